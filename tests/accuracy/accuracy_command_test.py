#!/usr/bin/env python3
"""`nicol accuracy` as a user meets it: table, CSV, plots, messages, interruption.

accuracy_command_test.py NICOL
"""

import csv
import os
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import xml.etree.ElementTree
from pathlib import Path

NICOL = sys.argv.pop(1) if __name__ == "__main__" else ""
SCENE = str(Path(__file__).resolve().parent / "cell.pov")
PATIENCE_S = 400
SMALL = ["-W", "16", "-H", "16", "--reference-error", "1%", "--most-samples", "4", "--longest", "2"]


class Accuracy(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def nicol(self, *arguments, **options):
        return subprocess.run(
            [NICOL, "accuracy", *arguments],
            capture_output=True,
            text=True,
            cwd=self.folder,
            timeout=PATIENCE_S,
            **options,
        )

    def rows(self, name="cell_accuracy.csv"):
        with open(self.folder / name, newline="") as file:
            return list(csv.DictReader(file))

    def test_everything_is_measured_and_written(self):
        run = self.nicol(SCENE, *SMALL, "--repeats", "2")
        self.assertEqual(run.returncode, 0, run.stderr)
        rows = self.rows()
        knobs = {row["knob"] for row in rows}
        self.assertLessEqual(
            {"reference", "scene", "wavelengths", "depth", "cut-off", "samples", "adaptive", "without"}, knobs
        )
        self.assertEqual(rows[0]["knob"], "reference")
        self.assertEqual(rows[0]["real"], "double")
        self.assertEqual(rows[1]["knob"], "scene")
        for row in rows[1:]:
            self.assertEqual(row["renderings"], "2")
            least, median, most = (float(row[f"seconds_{which}"]) for which in ("min", "median", "max"))
            self.assertTrue(0 < least <= median <= most)
            self.assertAlmostEqual(float(row["rms"]), max(float(row["stokes_rms"]), float(row["xyz_rms"])), places=9)
            self.assertLessEqual(float(row["ciede_mean"]), float(row["ciede_worst"]) + 1e-9)

        errors = {(row["knob"], row["value"].split(":")[0]): float(row["rms"]) for row in rows}
        # Two faces show nothing of what lies below the block; without rotation the analyzer passes all.
        self.assertGreater(errors["depth", "1 faces"], errors["scene", "as it is"])
        alone = {row["without"]: float(row["alone_rms"]) for row in rows if row["knob"] == "without"}
        self.assertGreater(alone["rotation"], 0.2)
        self.assertGreater(alone["polarization"], 0.2)
        self.assertLess(alone["dispersion"], 0.2)
        self.assertLess(errors["samples", "4 samples"], errors["scene", "as it is"])

        front = sorted((float(r["seconds_median"]), float(r["rms"])) for r in rows if r["pareto"] == "1")
        self.assertTrue(front)
        self.assertEqual([e for _, e in front], sorted((e for _, e in front), reverse=True))
        for row in rows[1:]:
            if row["without"] not in ("", "polarization"):
                self.assertEqual(row["pareto"], "0")

        self.assertIn("its own error:", run.stdout)
        self.assertIn("noise of the machine: 2 renderings", run.stdout)
        self.assertIn("CIEDE2000 below 1, mean: ", run.stdout)

    def test_the_command_that_it_names_renders(self):
        run = self.nicol(SCENE, *SMALL, "--repeats", "1", "--knobs", "wavelengths,adaptive,combined")
        self.assertEqual(run.returncode, 0, run.stderr)
        commands = [line.split() for line in run.stdout.splitlines() if line.startswith("    nicol render ")]
        self.assertTrue(commands, run.stdout)
        render = subprocess.run(
            [NICOL, *commands[0][1:], "-o", "a.png"],
            capture_output=True,
            text=True,
            cwd=self.folder,
            timeout=PATIENCE_S,
        )
        self.assertEqual(render.returncode, 0, render.stderr)
        self.assertTrue((self.folder / "a.png").exists())

    def test_plots_are_pictures_and_lie_beside_the_table(self):
        run = self.nicol(SCENE, *SMALL, "--repeats", "1", "--knobs", "depth,samples", "-o", "here.csv")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["here.csv", "here.png", "here.svg"])
        self.assertEqual((self.folder / "here.png").read_bytes()[:8], b"\x89PNG\r\n\x1a\n")
        text = "".join(xml.etree.ElementTree.parse(self.folder / "here.svg").getroot().itertext())
        for word in [
            "cell.pov, 16x16 pixels",
            "Pareto front",
            "depth (max_trace_level)",
            "seconds",
            "error of the reference",
        ]:
            self.assertIn(word, text)

    def test_a_knob_that_errs_nothing_leaves_the_plot_whole(self):
        (self.folder / "room.pov").write_text(
            "background { spectrum { e } } camera { location -9*z right x }"
            " box { -1, 1 interior { ior 1.5 } } global_settings { polarization off }"
        )
        for knobs in ["wavelengths", "precision", "without"]:
            with self.subTest(knobs=knobs):
                run = self.nicol("room.pov", *SMALL, "--repeats", "1", "--knobs", knobs)
                self.assertEqual(run.returncode, 0, run.stderr)
                self.assertNotIn("no plot", run.stderr)

    def test_without_gnuplot_there_is_a_table_and_a_message(self):
        empty = self.folder / "empty"
        empty.mkdir()
        run = self.nicol(SCENE, *SMALL, "--repeats", "1", "--knobs", "depth", env={**os.environ, "PATH": str(empty)})
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("no plot: gnuplot is not installed (Debian's package gnuplot-nox)", run.stderr)
        self.assertIn("depth", run.stdout)
        self.assertTrue(self.rows())
        self.assertFalse((self.folder / "cell_accuracy.png").exists())

    def test_interrupted_it_keeps_what_it_has(self):
        wait_s = 4
        while True:
            process = subprocess.Popen(
                [NICOL, "accuracy", SCENE, *SMALL, "--repeats", "1000"],
                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, cwd=self.folder,
            )
            time.sleep(wait_s)
            process.send_signal(signal.SIGINT)
            table, messages = process.communicate(timeout=PATIENCE_S)
            self.assertEqual(process.returncode, 2, messages)
            if "before anything was measured" not in messages and "nothing saved" not in messages:
                break
            wait_s *= 2
            self.assertLess(wait_s, PATIENCE_S)
        rows = self.rows()
        self.assertEqual([row["knob"] for row in rows[:2]], ["reference", "scene"])
        self.assertLess(sum(int(row["renderings"]) for row in rows), 1000 * len(rows))
        self.assertIn("as it is", table)

    def test_errors_come_before_the_work(self):
        for arguments, words in [
            ([SCENE, "-o", "a.png"], "the table is written as .csv"),
            ([SCENE, "-o", "missing/a.csv"], "cannot write missing/a.csv"),
            ([SCENE, "--knobs", "colour"], "colour"),
            ([SCENE, "--longest", "-1"], "--longest"),
            ([SCENE, "--reference-error", "200%"], "200%"),
            (["nowhere.pov"], "nowhere.pov"),
        ]:
            with self.subTest(arguments=arguments):
                run = self.nicol(*arguments)
                self.assertEqual(run.returncode, 1)
                self.assertIn(words, run.stderr)
                self.assertEqual(list(self.folder.iterdir()), [])


if __name__ == "__main__":
    unittest.main(verbosity=2)
