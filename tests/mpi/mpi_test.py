#!/usr/bin/env python3
"""Renders of several ranks: the bits of one process, whatever happens to a rank.

mpi_test.py NICOL MPIRUN COMPARE_EXR
"""

import os
import re
import signal
import subprocess
import sys
import time
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "app"))
from runs import PATIENCE_S, Runs  # noqa: E402

from mpirun import UnderMpirun  # noqa: E402

SCENE = Path(__file__).resolve().parent.parent / "app" / "cube.pov"
SMALL = ["-W", "96", "-H", "64", "--no-budget"]
LONG = ["-W", "192", "-H", "192", "--no-budget", "--keep-after", "0"]
LONG_S = 3


class Ranks(UnderMpirun, Runs):
    def setUp(self):
        super().setUp()
        self.environment = self.mark_ranks()

    def command(self, ranks, *arguments, mpirun=()):
        return self.with_mpirun(ranks, [self.nicol_path, "render", str(SCENE), *map(str, arguments)], mpirun)

    def start(self, ranks, *arguments, mpirun=(), **more):
        return subprocess.Popen(self.command(ranks, *arguments, mpirun=mpirun), cwd=self.folder, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, text=True, env={**self.environment, **more})

    def together(self, ranks, *arguments):
        process = self.start(ranks, *arguments)
        out, told = process.communicate(timeout=PATIENCE_S)
        self.assertEqual(process.returncode, 0, told)
        self.assertEqual(out, "")
        return told

    def long(self):
        """Options of a render that takes LONG_S with one process, and its picture."""
        def trial():
            told = self.done("render", SCENE, *LONG, "--samples", 32, "-o", "trial.exr")
            return float(re.search(r"^([\d.]+) s, ", told, re.MULTILINE)[1])

        seconds = min(trial() for _ in range(3))
        (self.folder / "trial.exr").unlink()
        options = [*LONG, "--samples", str(int(32 * LONG_S / max(seconds, 0.005)))]
        self.done("render", SCENE, *options, "-o", "alone.exr")
        return options

    def wait_for_tiles(self, process, bytes_there=0):
        part = self.folder / "a.exr.part"
        deadline = time.monotonic() + PATIENCE_S
        while process.poll() is None and time.monotonic() < deadline:
            if part.exists() and part.stat().st_size > bytes_there + 100000:
                return
            time.sleep(0.02)
        self.fail(f"no tiles were kept: {process.communicate()[1]}")

    def shares(self, told):
        """Tiles of each rank, as the summary tells them."""
        line = re.search(r"^shared: (.*)$", told, re.MULTILINE)[1]
        return [int(tiles) for tiles in re.findall(r": (\d+) tiles", line)]


class SameBits(Ranks):
    def test_uniform_samples(self):
        for extra in [["--samples", 3], ["--samples", 40], ["--wavelengths", "580", "--samples", 4]]:
            self.done("render", SCENE, *SMALL, *extra, "-o", "alone.exr")
            for ranks in (1, 2, 4):
                with self.subTest(extra=extra, ranks=ranks):
                    self.together(ranks, *SMALL, *extra, "-o", "a.exr")
                    self.assert_same("alone.exr", "a.exr")
        self.assertEqual(self.files(), ["a.exr", "alone.exr"])

    def test_samples_where_they_matter(self):
        options = [*SMALL, "--sample-error", "0.5%", "--real", "double"]
        alone = self.done("render", SCENE, *options, "-o", "alone.exr")
        told = self.together(3, *options, "-o", "a.exr")
        self.assert_same("alone.exr", "a.exr")
        passes = re.compile(r"in (\d+) passes")
        self.assertEqual(passes.search(alone)[1], passes.search(told)[1])

    def test_every_rank_works_and_rank_0_alone_talks(self):
        told = self.together(3, "-W", 256, "-H", 256, "--no-budget", "--samples", 64, "-o", "a.exr")
        shares = self.shares(told)
        self.assertEqual(len(shares), 3)
        self.assertTrue(all(tiles > 0 for tiles in shares), told)
        self.assertEqual(told.count("pixels, "), 1, told)
        self.assertRegex(told, r"rank 1 on \S+, ")
        self.assertEqual(self.together(3, *SMALL, "-q", "-o", "b.exr"), "")

    def test_rank_0_may_be_idle(self):
        self.done("render", SCENE, *SMALL, "-o", "alone.exr")
        told = self.together(2, *SMALL, "--first-rank-idle", "-o", "a.exr")
        self.assert_same("alone.exr", "a.exr")
        self.assertNotIn("shared:", told)

    def test_a_part_and_frames(self):
        self.done("render", SCENE, *SMALL, "--part", "2/3", "-o", "alone.exr")
        self.together(2, *SMALL, "--part", "2/3", "-o", "a.exr")
        self.assert_same("alone.exr", "a.exr")
        self.together(2, *SMALL, "--final-frame", 2, "-o", "f.exr")
        self.done("render", SCENE, *SMALL, "--final-frame", 2, "-o", "g.exr")
        self.assert_same("f1.exr", "g1.exr")
        self.assert_same("f2.exr", "g2.exr")

    def test_an_error_of_rank_0_ends_all(self):
        process = self.start(3, *SMALL, "-o", "nowhere/a.exr")
        _, told = process.communicate(timeout=PATIENCE_S)
        self.assertEqual(process.returncode, 1)
        self.assertEqual(told.count("nicol: cannot write nowhere"), 1, told)


class Losses(Ranks):
    def test_a_killed_rank_leaves_a_resumable_picture(self):
        options = self.long()
        process = self.start(2, *options, "-o", "a.exr")
        self.wait_for_tiles(process)
        os.kill(self.rank(1), signal.SIGKILL)
        _, told = process.communicate(timeout=PATIENCE_S)
        self.assertNotEqual(process.returncode, 0)
        self.assertIn("--continue", told)
        self.assertTrue((self.folder / "a.exr.part").exists())
        told = self.together(2, *options, "--continue", "-o", "a.exr")
        self.assertGreater(int(re.search(r"(\d+) tiles were there", told)[1]), 0)
        self.assert_same("alone.exr", "a.exr")
        self.assertEqual(self.files(), ["a.exr", "alone.exr"])

    def test_interrupted_at_rank_0(self):
        options = self.long()
        process = self.start(2, *options, "-o", "a.exr")
        self.wait_for_tiles(process)
        os.kill(self.rank(0), signal.SIGINT)
        _, told = process.communicate(timeout=PATIENCE_S)
        self.assertEqual(process.returncode, 2, told)
        self.assertIn("--continue goes on from here", told)
        self.together(2, *options, "--continue", "-o", "a.exr")
        self.assert_same("alone.exr", "a.exr")


if __name__ == "__main__":
    Runs.nicol_path, UnderMpirun.mpirun_path, Runs.compare_path = sys.argv[1:4]
    unittest.main(argv=sys.argv[:1] + sys.argv[4:])
