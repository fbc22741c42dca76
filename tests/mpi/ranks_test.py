#!/usr/bin/env python3
"""Ranks on the stand-in kernel: the bits of one process, whatever happens to a rank.

ranks_test.py TEST_MPI_RANKS MPIRUN
"""

import os
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

from mpirun import PATIENCE_S, UnderMpirun

RANKS = ""


class Runs(UnderMpirun, unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        (self.folder / "kernels").mkdir()
        self.environment = {**self.mark_ranks(), "NICOL_KERNEL_DIR": str(self.folder / "kernels"),
                            "XDG_CACHE_HOME": str(self.folder / "cache"), "POCL_CACHE_DIR": str(self.folder / "pocl")}
        subprocess.run([RANKS, "--kernel", "kernels"], cwd=self.folder, check=True)
        self.done(0, "first", 1, 1, 0)  # its kernel is in the cache from here on

    def start(self, ranks, *arguments, mpirun=(), **more):
        command = [RANKS, *map(str, arguments)]
        if ranks > 0:
            command = self.with_mpirun(ranks, command, mpirun)
        return subprocess.Popen(command, cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                env={**self.environment, **more})

    def done(self, ranks, *arguments):
        process = self.start(ranks, *arguments)
        out, told = process.communicate(timeout=PATIENCE_S)
        self.assertEqual(process.returncode, 0, out + told)
        self.assertEqual(told, "")
        return out

    def assert_same(self, one, two):
        self.assertTrue((self.folder / one).read_bytes() == (self.folder / two).read_bytes(), f"{one} and {two} differ")

    def turns(self, samples, seconds):
        """Turns of the stand-in's loop with which one process takes so long."""
        told = self.done(0, "trial", samples, 50, 0)
        return int(50 * seconds / max(0.001, float(re.search(r"seconds ([\d.]+)", told)[1])))

    def wait_for_all(self, process):
        """Every rank has traced some tiles, and the journal has them."""
        for line in process.stdout:
            if line == "all work\n":
                return
        self.fail(f"not all ranks work: {process.stderr.read()}")


class SameBits(Runs):
    def test_whatever_the_ranks(self):
        for samples, over_pixels in [(1, 0), (5, 1), (37, 0)]:
            self.done(0, "alone", samples, 10, over_pixels)
            for ranks in (1, 2, 4):
                with self.subTest(samples=samples, over_pixels=over_pixels, ranks=ranks):
                    self.done(ranks, "a", samples, 10, over_pixels)
                    self.assert_same("alone", "a")

    def test_all_work(self):
        told = self.done(3, "a", 20, self.turns(20, 2), 0)
        tiles = [int(n) for n in re.findall(r"^share .* (\d+)$", told, re.MULTILINE)]
        self.assertEqual(len(tiles), 3, told)
        self.assertTrue(all(n > 0 for n in tiles), told)
        self.assertNotIn("note", told)

    def test_a_rank_that_waits_does_not_spin(self):
        process = self.start(2, "a", 20, self.turns(20, 3), 0, "part")
        self.wait_for_all(process)
        os.kill(self.rank(0), signal.SIGSTOP)
        try:
            waiting = self.rank(1)
            ticks = lambda: sum(map(int, Path(f"/proc/{waiting}/stat").read_text().rsplit(")", 1)[1].split()[11:13]))
            while True:  # until it has traced what it was dealt
                before = ticks()
                time.sleep(1)
                if ticks() - before < 0.2 * os.sysconf("SC_CLK_TCK"):
                    break
        finally:
            os.kill(self.rank(0), signal.SIGCONT)
        process.communicate(timeout=PATIENCE_S)
        self.assertEqual(process.returncode, 0)


class Losses(Runs):
    def setUp(self):
        super().setUp()
        self.picture = [20, self.turns(20, 3), 0]
        self.done(0, "alone", *self.picture)

    def test_a_killed_rank_leaves_tiles_to_go_on_from(self):
        process = self.start(2, "a", *self.picture, "part")
        self.wait_for_all(process)
        os.kill(self.rank(1), signal.SIGKILL)
        process.communicate(timeout=PATIENCE_S)
        self.assertNotEqual(process.returncode, 0)
        self.assertFalse((self.folder / "a").exists())
        told = self.done(2, "a", *self.picture, "part", "continue")
        self.assertGreater(int(re.search(r"found (\d+)", told)[1]), 0)
        self.assert_same("alone", "a")
        self.assertFalse((self.folder / "part").exists())

    def lost(self, how, **more):
        process = self.start(2, "a", *self.picture, "part", NICOL_RANK_PATIENCE_S="2", **more)
        self.wait_for_all(process)
        os.kill(self.rank(1), how)
        out, _ = process.communicate(timeout=PATIENCE_S)
        self.assertRegex(out, r"note rank 1\D.* has not answered for \d+ s")
        self.assertIn("Its tiles went to the other device", out)
        self.assert_same("alone", "a")

    def test_a_rank_that_answers_no_more_is_done_without(self):
        self.lost(signal.SIGSTOP)

    def test_a_rank_killed_where_the_job_survives(self):
        self.lost(signal.SIGKILL, mpirun=["--enable-recovery"])

    def test_interrupted_at_rank_0(self):
        process = self.start(2, "a", *self.picture, "part")
        self.wait_for_all(process)
        os.kill(self.rank(0), signal.SIGINT)
        out, _ = process.communicate(timeout=PATIENCE_S)
        self.assertEqual(process.returncode, 2, out)
        self.assertIn("interrupted true", out)
        self.done(2, "a", *self.picture, "part", "continue")
        self.assert_same("alone", "a")


if __name__ == "__main__":
    RANKS, UnderMpirun.mpirun_path = sys.argv[1:3]
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
