#!/usr/bin/env python3
"""`nicol preview` by scripts, without a display.

script_test.py NICOL
"""

import math
import statistics
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

from pictures import read_png
from preview_program import PATIENCE_S, CommandFailed, Gone, Preview, change, copy_scene, without_display

NICOL = sys.argv.pop(1) if __name__ == "__main__" else ""
SIZE = ["-W", "160", "-H", "120"]
CENTRE = (80, 60)


class PreviewScript(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.scene = copy_scene(self.folder)

    def preview(self, *arguments):
        preview = Preview(NICOL, self.scene.name, *arguments, *SIZE, cwd=self.folder)
        self.addCleanup(preview.__exit__)
        return preview

    def nicol(self, *arguments):
        return subprocess.run([NICOL, *arguments], cwd=self.folder, env=without_display(), capture_output=True,
                              text=True, timeout=PATIENCE_S, check=False)

    def render(self, scene, output="rendered.png"):
        result = self.nicol("render", scene, *SIZE, "--no-budget", "-o", output)
        self.assertEqual(result.returncode, 0, result.stderr)
        return read_png(self.folder / output)

    def srgb(self, preview, side="left", at=CENTRE):
        pixel = preview.pixel(side, *at)
        return pixel and pixel["srgb"]

    def left_mean(self, preview):
        """Of the middle of the left picture as the window shows it."""
        preview.do("screenshot left.png")
        return sum(read_png(self.folder / "left.png").part(preview.state()["pictures"][0], 0.45, 0.45, 0.55, 0.55))

    def difference(self, preview):
        state = preview.until(lambda s: s.get("difference", {}).get("comparable"), "there is a difference")
        return state["difference"]

    def wait_for_file(self, preview, name):
        deadline = time.monotonic() + PATIENCE_S
        while not (self.folder / name).exists():
            self.assertLess(time.monotonic(), deadline, f"{name} is not written; {preview.state()['notice']}")
            preview.do("wait 0.05")
        return self.folder / name

    def assert_colours(self, got, expected, within, what=""):
        for a, b in zip(got, expected):
            self.assertAlmostEqual(a, b, delta=within, msg=f"{what}: {got} and {expected}")

    def test_picture_values_and_quitting(self):
        preview = self.preview()
        preview.run("wait picture", "set left colour", "wait done")
        state = preview.state()
        pane = state["panes"][0]
        self.assertEqual((pane["step"], pane["done"], pane["stale"]), (1, True, False))
        self.assertEqual((pane["failure"], pane["messages"]), ("", []))
        self.assertIn("rotation", pane["effects"])
        self.assertGreater(pane["samples"], 1)

        preview.do("screenshot shot.png")
        shot = read_png(self.folder / "shot.png")
        self.assertEqual([shot.width, shot.height], state["window"])
        place = state["pictures"][0]
        for x, y in CENTRE, (40, 60), (80, 100):
            left, top = (x + 0.25) / 160, (y + 0.25) / 120
            shown = shot.part(place, left, top, left + 0.01, top + 0.01)
            self.assert_colours(shown, self.srgb(preview, at=(x, y)), 12, f"pixel {x}, {y} in the window")
        self.assertEqual(preview.quit(), 0)
        self.assertEqual(preview.stderr(), "")

    def test_keys_mouse_and_settings(self):
        preview = self.preview()
        preview.run("set left colour", "wait done")
        before = self.srgb(preview)

        preview.run(*["key a"] * 18, "wait done")
        self.assertAlmostEqual(preview.state()["controls"]["analyzer_deg"], 90, places=6)
        # cos^2 of the angle turned becomes sin^2: 16 mm of quartz turn green away from the scene's plane
        turned = preview.pixel("left", *CENTRE)["stokes"][0]
        preview.run("key r", "wait done")
        self.assert_colours(self.srgb(preview), before, 1, "after the reset")
        straight = preview.pixel("left", *CENTRE)["stokes"][0]
        self.assertGreater(turned[8], 5 * straight[7])   # 540 nm, 520 nm
        self.assertGreater(straight[10], 5 * straight[7])

        preview.do("drag left 0.3 0.5 left 0.6 0.5")
        controls = preview.state()["controls"]
        self.assertAlmostEqual(controls["yaw_rad"], 0.3 * math.pi, delta=0.01)
        self.assertAlmostEqual(controls["pitch_rad"], 0, delta=0.01)
        preview.run("move left 0.5 0.5", "scroll 4")
        self.assertAlmostEqual(preview.state()["controls"]["zoom"], 1, places=6)

        preview.do("drag divider divider 0.2")
        state = preview.state()
        divider = state["divider"]
        self.assertAlmostEqual(divider["x"] + divider["width"] / 2, 0.2 * state["window"][0], delta=2)

        preview.run("do reset", "wait done")
        plain = self.left_mean(preview)
        preview.do("set exposure 1")
        # one stop, in sRGB about a power of 1/2.2
        self.assertAlmostEqual(self.left_mean(preview) / plain, 2 ** (1 / 2.2), delta=0.15)
        preview.run("set exposure 0", "set right degree", "set wavelength 580", "set analyzer 30")
        now = preview.state()["controls"]
        self.assertEqual((now["views"][1], now["analyzer_deg"], now["exposure_stops"]), ("degree", 30, 0))

    def test_files_that_change_are_read_again(self):
        preview = self.preview()
        preview.run("set left colour", "wait done")
        before = self.srgb(preview)
        preview.do('replace fig5_active.pov "exposure 2" "exposure 1"')
        preview.until(lambda _: sum(self.srgb(preview) or before) < 0.9 * sum(before), "the picture is darker")
        preview.do('replace fig5_active.pov "exposure 1" "exposure 2"')
        preview.until(lambda _: sum(self.srgb(preview) or [0]) > 0.98 * sum(before), "the picture is as before")
        sky = (3, 3)
        self.assertGreater(min(self.srgb(preview, at=sky)), 50)
        preview.do('replace founding.inc "#declare Sky_Level = 0.4" "#declare Sky_Level = 0"')
        preview.until(lambda _: max(self.srgb(preview, at=sky) or [255]) < 3, "the surroundings are black")

        preview.run('replace fig5_active.pov "exposure 2" "exposure"', "wait error")
        pane = preview.pane()
        self.assertTrue(pane["stale"])
        self.assertEqual((pane["messages"][0]["file"], pane["messages"][0]["line"]), ("fig5_active.pov", 4))
        self.assertGreater(pane["step"], 0, "the last picture is gone")
        preview.until(lambda _: preview.pane()["step"] == 1, "the last good picture gets whole beside the error")
        self.assertTrue(preview.pane()["stale"])
        preview.do('replace fig5_active.pov "exposure" "exposure 2"')
        preview.until(lambda s: not s["panes"][0]["messages"] and not s["panes"][0]["stale"], "the error is gone")

    def test_two_panes_and_their_difference(self):
        preview = self.preview("--right", "without optical_activity")
        preview.run("set left colour", "set right colour", "wait done")
        left, right = (preview.pixel(side, *CENTRE) for side in ("left", "right"))
        self.assertGreater(right["rgb"][1], 1.5 * left["rgb"][1])   # what the rotation takes from the green
        preview.run("key d", "wait done")
        difference = self.difference(preview)
        self.assertGreater(difference["largest"], 0.1)
        self.assertGreater(difference["rms"], 0.05)
        self.assertGreaterEqual(difference["largest"], difference["rms"])

    def test_the_same_scene_twice_does_not_differ(self):
        preview = self.preview(self.scene.name)
        preview.run("key d", "wait done")
        difference = self.difference(preview)
        self.assertEqual((difference["largest"], difference["rms"]), (0, 0))

    def test_an_error_to_keep(self):
        preview = self.preview("--right", "error 1%")
        preview.do("wait done")
        left, right = preview.state()["panes"]
        self.assertEqual(left["chosen"], "")
        self.assertRegex(right["chosen"], r"^error 1 %: .*sampling to 0\.\d+ %$")
        self.assertLessEqual(right["sample_error"], 0.01)
        self.assertGreater(right["sample_error"], 0)

    def test_window_size_without_a_display(self):
        preview = self.preview()
        preview.run("wait done", "size 1234 567")
        state = preview.state()
        self.assertEqual(state["window"], [1234, 567])
        self.assertEqual(state["panel"]["x"] + state["panel"]["width"], 1234)
        preview.do("screenshot wide.png")
        wide = read_png(self.folder / "wide.png")
        self.assertEqual((wide.width, wide.height), (1234, 567))
        for size in "size 0 10", "size 10 100000", "size ten 10":
            with self.assertRaises(CommandFailed):
                preview.do(size)
        preview.run("size 1 1", "screenshot dot.png", "size 900 600", "wait done")
        self.assertEqual(preview.state()["window"], [900, 600])

    def test_saved_files(self):
        preview = self.preview()
        preview.run("set left colour", "drag left 0.3 0.5 left 0.35 0.55", "wait done")
        preview.run('do "save picture"', 'do "save spectra"', 'do "save camera"')
        picture = read_png(self.wait_for_file(preview, "fig5_active-preview.png"))
        self.assertEqual((picture.width, picture.height), (160, 120))
        spectra = self.wait_for_file(preview, "fig5_active-preview.exr")
        header = subprocess.run(["exrheader", spectra], capture_output=True, text=True, check=False)
        self.assertEqual(header.returncode, 0, header.stderr)
        self.assertIn("S0", header.stdout)

        camera = self.wait_for_file(preview, "fig5_active-camera.inc").read_text()
        change(self.scene, "Founding_Camera(Centre, View_Angle)", camera)
        rendered = self.render(self.scene.name)
        self.assertGreater(picture.mean(0, 0, 160, 120)[0] - picture.mean(0, 0, 16, 12)[0], 10, "nothing is to be seen")
        for column in range(4):
            for row in range(3):
                part = column / 4, row / 3, (column + 1) / 4, (row + 1) / 3
                whole = picture.whole()
                self.assert_colours(rendered.part(whole, *part), picture.part(whole, *part), 2, f"part {part}")

    def test_wrong_scripts(self):
        (self.folder / "wrong.txt").write_text("wait done\n\n# a comment\nkey a   # another\ndo nothing\n")
        result = self.nicol("preview", self.scene.name, *SIZE, "--script", "wrong.txt")
        self.assertEqual(result.returncode, 1)
        self.assertIn("wrong.txt, line 5: there is no action 'nothing'", result.stderr)

        preview = self.preview()
        for command, answer in (("dance", "no command 'dance'"), ("click widget nowhere", "no widget 'nowhere'"),
                                ("set analyzer much", "'much' is not a number"),
                                ("set taste 3", "'taste' cannot be set"), ("key", "lacks a word"),
                                ("replace nosuch.pov a b", "cannot read nosuch.pov"),
                                ("set left smell", "no view 'smell'"), ("press both", "left, middle or right"),
                                ("screenshot shot.gif", ".gif")):
            with self.assertRaises(CommandFailed) as failed:
                preview.do(command)
            self.assertIn(answer, str(failed.exception))
        self.assertEqual(preview.do("pixel left 5000 5000"), ["null"])
        self.assertEqual(preview.quit(), 0)

    def test_what_cannot_be_shown_is_told(self):
        for arguments, word in ((["--right", "without magic"], "no such effect"),
                                (["--right", "samples=x"], "samples=x"),
                                ([self.scene.name, "--right", "real=double"], "nothing to change")):
            with self.assertRaises(Gone) as gone:
                self.preview(*arguments).run("wait picture", "quit", "state")
            self.assertIn("exit code 1", str(gone.exception))
            self.assertIn(word, (self.folder / "stderr.txt").read_text())

        preview = self.preview("missing.pov")
        preview.run("wait error", "wait done")
        left, right = preview.state()["panes"]
        self.assertEqual((left["messages"], left["done"]), ([], True))
        self.assertEqual(right["messages"][0]["file"], "missing.pov")
        (self.folder / "missing.pov").write_text(self.scene.read_text())
        preview.until(lambda s: not s["panes"][1]["messages"] and s["panes"][1]["step"] == 1, "the scene is shown")

    def test_no_display(self):
        result = self.nicol("preview", self.scene.name)
        self.assertEqual((result.returncode, result.stdout), (1, ""))
        self.assertRegex(result.stderr, r"^nicol: no display: [^\n]*DISPLAY[^\n]*\n$")

    def test_memory_stays_flat(self):
        edits = 100
        preview = self.preview()
        preview.run("wait done")
        mib = []
        for edit in range(edits):
            old, new, low, high = (2, 1, 100, 170) if edit % 2 == 0 else (1, 2, 180, 255)
            change(self.scene, f"exposure {old} }}", f"exposure {new} }}")
            preview.until(lambda _, a=low, b=high: a < (self.srgb(preview) or [0])[0] < b, f"edit {edit} shows")
            mib.append(preview.state()["resident_mib"])
        middle, last = mib[edits // 3 : 2 * edits // 3], mib[2 * edits // 3 :]
        self.assertLess(statistics.mean(last), 1.05 * statistics.mean(middle), mib)


if __name__ == "__main__":
    unittest.main()
