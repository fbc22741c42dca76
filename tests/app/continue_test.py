#!/usr/bin/env python3
"""Killed in the middle of a render, at any moment: no damaged picture, and --continue goes on to the same bits.

continue_test.py NICOL
"""

import random
import re
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

NICOL = sys.argv.pop(1) if __name__ == "__main__" else ""
SCENE = str(Path(__file__).resolve().parent / "cube.pov")
PICTURE = ["-W", "256", "-H", "256", "--no-budget"]
RENDER_S = 2
PATIENCE_S = 240


def pixel_data(path):
    """The chunks of a scan-line EXR, without the header (it tells the time) and the table of offsets."""
    data = Path(path).read_bytes()
    assert data[:4] == b"\x76\x2f\x31\x01", "no EXR"
    at, height = 8, 0
    while data[at]:
        name_end = data.index(0, at)
        type_end = data.index(0, name_end + 1)
        (size,) = struct.unpack("<i", data[type_end + 1 : type_end + 5])
        if data[at:name_end] == b"dataWindow":
            box = struct.unpack("<4i", data[type_end + 5 : type_end + 21])
            height = box[3] - box[1] + 1
        at = type_end + 5 + size
    (first,) = struct.unpack("<Q", data[at + 1 : at + 9])
    assert height > 0 and at < first < len(data), "EXR without chunks"
    return data[first:]


class Continue(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.part = self.folder / "a.exr.part"
        trial = self.render(*PICTURE, "--samples", "64", "-o", "trial.exr")
        self.assertEqual(trial.returncode, 0, trial.stderr)
        (self.folder / "trial.exr").unlink()
        seconds = float(re.search(r"^([\d.]+) s, ", trial.stderr, re.MULTILINE)[1])
        self.set_samples(int(64 * RENDER_S / max(seconds, 0.005)))

    def set_samples(self, samples):
        self.samples = samples
        self.long = [*PICTURE, "--keep-after", "0", "--samples", str(samples)]

    def render(self, *options):
        return subprocess.run([NICOL, "render", SCENE, *options], cwd=self.folder, capture_output=True, text=True,
                              timeout=PATIENCE_S, check=False)

    def killed(self, *options):
        """Kills a render some time after it has kept further tiles; False: it finished before."""
        if "--continue" not in options:
            (self.folder / "a.exr").unlink(missing_ok=True)
        before = self.part.stat().st_size if self.part.exists() else 0
        process = subprocess.Popen([NICOL, "render", SCENE, *self.long, "-o", "a.exr", *options], cwd=self.folder,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        deadline = time.monotonic() + PATIENCE_S
        while process.poll() is None and time.monotonic() < deadline:
            if self.part.exists() and self.part.stat().st_size > before:
                time.sleep(random.uniform(0, 0.3))
                break
            time.sleep(0.01)
        process.send_signal(signal.SIGKILL)
        process.communicate()
        return process.returncode == -signal.SIGKILL

    def kill_in_work(self):
        for _ in range(6):
            if self.killed():
                return
            self.set_samples(4 * self.samples)  # a trial beside other work makes a machine look slower than it is
        self.fail("it finished before it could be killed")

    def test_killed_and_continued_to_the_same_bits(self):
        random.seed(5)
        self.kill_in_work()
        self.assertTrue(self.part.exists())
        self.assertFalse((self.folder / "a.exr").exists())
        whole = self.render(*self.long, "-o", "whole.exr")
        self.assertEqual(whole.returncode, 0, whole.stderr)
        self.killed("--continue")
        last = self.render(*self.long, "-o", "a.exr", "--continue")
        self.assertEqual(last.returncode, 0, last.stderr)
        self.assertEqual(pixel_data(self.folder / "a.exr"), pixel_data(self.folder / "whole.exr"))
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["a.exr", "whole.exr"])
        counted = [line for line in whole.stderr.splitlines() if line.startswith(("counted", "weight"))]
        self.assertEqual([line for line in last.stderr.splitlines() if line.startswith(("counted", "weight"))], counted)

    def test_another_picture_begins_anew(self):
        self.kill_in_work()
        other = self.render("-W", "32", "-H", "32", "--no-budget", "-o", "a.exr", "--continue")
        self.assertEqual(other.returncode, 0, other.stderr)
        self.assertIn("another picture", other.stderr)
        self.assertIn("begins anew", other.stderr)
        self.render("-W", "32", "-H", "32", "--no-budget", "-o", "b.exr")
        self.assertEqual(pixel_data(self.folder / "a.exr"), pixel_data(self.folder / "b.exr"))

    def test_nothing_to_go_on_from(self):
        result = self.render("-W", "16", "-H", "16", "--no-budget", "-o", "a.exr", "--continue")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual([p.name for p in self.folder.iterdir()], ["a.exr"])


if __name__ == "__main__":
    unittest.main()
