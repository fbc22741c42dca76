#!/usr/bin/env python3
"""A picture by a Slurm array: submitted, a task killed and requeued, its parts merged to the bits of one run.

slurm_test.py NICOL COMPARE_EXR ARRAY_SBATCH
"""

import sys
import tempfile
import unittest
from pathlib import Path

APP = Path(__file__).resolve().parents[1] / "app"
sys.path.insert(0, str(APP))
from runs import Runs  # noqa: E402
from slurm import Slurm, wait_for  # noqa: E402

if __name__ == "__main__":
    ARRAY = sys.argv.pop(3)
    Runs.compare_path, Runs.nicol_path = sys.argv.pop(2), sys.argv.pop(1)
SCENE = Path(__file__).resolve().parents[2] / "scenes" / "founding" / "fig5_active.pov"
SIZE = ["-W", "160", "-H", "120", "--samples", "24", "--keep-after", "0"]


class Array(Runs):
    def setUp(self):
        super().setUp()
        folder = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)  # its daemons may still write
        self.addCleanup(folder.cleanup)
        self.slurm = Slurm(folder.name)
        self.slurm.__enter__()
        self.addCleanup(self.slurm.__exit__)

    def test_killed_and_requeued(self):
        self.done("render", SCENE, *SIZE, "-o", "whole.exr", "--no-budget")
        out = self.folder / "out"
        job = self.slurm.submit("--array=1-3", "-n", 1, f"--output={self.folder}/%A_%a.log", ARRAY, SCENE, out, *SIZE, NICOL=self.nicol_path)
        task = f"{job}_2"

        def details():
            return self.slurm.run("scontrol", "show", "job", job) + "".join(p.read_text() for p in self.folder.glob("*.log")) + self.slurm.logs()

        journal = self.folder / "out.2.exr.part"
        wait_for(lambda: journal.exists() and journal.stat().st_size > 100_000, "a tile of task 2", details)
        self.slurm.run("scancel", "--signal=KILL", "--full", task)
        wait_for(lambda: self.slurm.state(task) in ("FAILED", "CANCELLED"), "the end of the killed task", details)
        self.assertFalse((self.folder / "out.2.exr").exists())
        self.assertTrue(journal.exists())
        self.slurm.run("scontrol", "requeue", task)
        wait_for(lambda: set(self.slurm.state(job).split()) == {"COMPLETED"}, "the end of the array", details)
        self.assertFalse(journal.exists())
        merge = self.slurm.submit(f"--dependency=afterany:{job}", f"--output={self.folder}/merge.log", "--wrap",
                                  f"{self.nicol_path} merge {out}.*.exr -o {self.folder}/merged.exr")
        wait_for(lambda: self.slurm.state(merge) == "COMPLETED", "the merged picture", details)
        self.assert_same("merged.exr", "whole.exr")
        # The same array again leaves what is there; with another option it does not take old parts for new ones.
        there = [(self.folder / f"out.{i}.exr").stat().st_mtime_ns for i in (1, 2, 3)]
        again = self.slurm.submit("--array=1-3", "-n", 1, f"--output={self.folder}/%A_%a.log", ARRAY, SCENE, out, *SIZE, NICOL=self.nicol_path)
        wait_for(lambda: set(self.slurm.state(again).split()) == {"COMPLETED"}, "the array that has nothing to do", details)
        self.assertEqual([(self.folder / f"out.{i}.exr").stat().st_mtime_ns for i in (1, 2, 3)], there)
        few = ["1" if option == "24" else option for option in SIZE]
        other = self.slurm.submit("--array=1-3", "-n", 1, f"--output={self.folder}/%A_%a.log", ARRAY, SCENE, out, *few, NICOL=self.nicol_path)
        wait_for(lambda: set(self.slurm.state(other).split()) == {"COMPLETED"}, "the array of another picture", details)
        self.done("render", SCENE, *few, "-o", "whole.exr", "--no-budget")
        self.done("merge", *(f"out.{i}.exr" for i in (1, 2, 3)), "-o", "merged.exr")
        self.assert_same("merged.exr", "whole.exr")


if __name__ == "__main__":
    unittest.main()
