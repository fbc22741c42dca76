#!/usr/bin/env python3
"""--device all and lists: the bits of one device.

several_devices_test.py NICOL COMPARE_EXR
"""

import os
import re
import subprocess
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "app"))
from runs import Runs  # noqa: E402

SCENE = Path(__file__).resolve().parent.parent / "app" / "cube.pov"
SMALL = ["-W", "96", "-H", "64", "--no-budget"]
TWO = {**os.environ, "POCL_DEVICES": "pthread pthread"}


class SeveralDevices(Runs):
    def rendered(self, output, *options):
        return self.done("render", SCENE, *options, "-o", output, env=TWO)

    def test_the_bits_of_one(self):
        for extra in [["--samples", 3], ["--samples", 40], ["--wavelengths", "580", "--samples", 4], ["--sample-error", "0.5%"]]:
            alone = self.rendered("alone.exr", *SMALL, *extra)
            self.assertNotIn("shared:", alone)
            for devices in ("all", "0,1", "1,0"):
                with self.subTest(extra=extra, devices=devices):
                    told = self.rendered("a.exr", *SMALL, *extra, "--device", devices)
                    self.assert_same("alone.exr", "a.exr")
                    self.assertRegex(told, r"segments/s on 2 x \S")
                    tiles = re.findall(r": (\d+) tiles", re.search(r"^shared: .*$", told, re.MULTILINE)[0])
                    self.assertEqual(len(tiles), 2)

    def test_killed_with_two_continued_with_one(self):
        trial = self.rendered("trial.exr", *SMALL, "--samples", 64)
        seconds = float(re.search(r"^([\d.]+) s, ", trial, re.MULTILINE)[1])
        samples = self.killed_in_work(lambda n: self.start(SCENE, *SMALL, "--samples", n, "--device", "all", "-o", "a.exr", env=TWO),
                                      int(64 * 7 / max(seconds, 0.005)), self.folder / "a.exr.part", 50000)
        options = [*SMALL, "--samples", samples]
        told = self.rendered("a.exr", *options, "--continue")
        self.assertGreater(int(re.search(r"(\d+) tiles were there", told)[1]), 0)
        self.rendered("alone.exr", *options, "--device", "all")
        self.assert_same("alone.exr", "a.exr")

    def test_lists_that_make_no_sense(self):
        self.refused(["named twice"], "render", SCENE, *SMALL, "--device", "0,0", "-o", "a.exr")
        self.refused(["no OpenCL device 'nothing'"], "render", SCENE, *SMALL, "--device", "0,nothing", "-o", "a.exr")

    def test_devices_says_what_all_means(self):
        listed = subprocess.run([self.nicol_path, "devices"], env=TWO, capture_output=True, text=True, check=True).stdout
        self.assertRegex(listed, r"--device 0,1, which is what --device all means")


if __name__ == "__main__":
    Runs.nicol_path, Runs.compare_path = sys.argv[1:3]
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
