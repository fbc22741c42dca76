#!/usr/bin/env python3
"""The preview's real window, on an X server of its own: its screen is held against what `nicol render` writes.

window_test.py NICOL
"""

import os
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

from display import Display
from pictures import read_png
from preview_program import PATIENCE_S, Preview, change, copy_scene

NICOL = sys.argv.pop(1) if __name__ == "__main__" else ""
SIZE = ["-W", "160", "-H", "120"]
BEHIND, DIVIDER, BOX = 38, 28, 26  # greys of the window: beside the pictures, the divider, the box of errors
# Parts of a picture, with gaps between them in which the mouse may mark a pixel.
GRID = [(column / 4 + 0.03, row / 3 + 0.03, column / 4 + 0.22, row / 3 + 0.3)
        for column in range(4) for row in range(3)]


class Window(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.display = Display(folder.name)
        cls.addClassCleanup(cls.display.close)

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.scene = copy_scene(self.folder)
        self.title = f"nicol preview: {self.scene.name}"
        self.rendered = 0

    def open_window(self, *arguments):
        """Opens the preview; its window's number."""
        # Where things lie: the same window without a display tells it.
        with Preview(NICOL, self.scene.name, *SIZE, *arguments, cwd=self.folder) as without_display:
            self.places = without_display.state()
        self.bottom = round(self.places["divider"]["height"])   # of the panes
        self.errors = open(self.folder / "errors.txt", "w+b")
        self.addCleanup(self.errors.close)
        self.program = subprocess.Popen([NICOL, "preview", self.scene.name, *SIZE, *arguments], cwd=self.folder,
                                        env=self.display.environment, stderr=self.errors, stdin=subprocess.DEVNULL)
        self.addCleanup(self.program.wait)
        self.addCleanup(self.program.kill)
        window = self.until(lambda: self.display.window(self.title), lambda: "the window does not open")
        self.display.hand("mousemove", 100, 60)   # keys go where the mouse is; in a picture it would mark a pixel
        return window

    def until(self, holds, complaint):
        """What `holds` gives, once that is something; complaint(): of what is not so, though time enough has passed."""
        deadline = time.monotonic() + PATIENCE_S
        while not (value := holds()):
            self.assertIsNone(self.program.poll(), "the program has ended: " + self.stderr())
            if time.monotonic() > deadline:
                self.fail(complaint())
            time.sleep(0.05)
        return value

    def stderr(self):
        return (self.folder / "errors.txt").read_text()

    def render(self):
        """The picture that the left pane should come to."""
        self.rendered += 1
        output = f"{self.rendered}.png"
        command = [NICOL, "render", self.scene.name, *SIZE, "--no-budget", "--samples", "5", "-o", output]
        result = subprocess.run(command, cwd=self.folder, capture_output=True, text=True, timeout=PATIENCE_S)
        self.assertEqual(result.returncode, 0, result.stderr)
        picture = read_png(self.folder / output)
        return [picture.part(picture.whole(), *part) for part in GRID]

    def shown(self, place=None, parts=None):
        screen = self.display.screen()
        return [screen.part(place or self.places["pictures"][0], *part) for part in parts or GRID]

    @staticmethod
    def distance(a, b):
        return max(abs(x - y) for one, other in zip(a, b) for x, y in zip(one, other))

    def wait_for_picture(self, expected, what, place=None, within=3):
        self.until(lambda: self.distance(self.shown(place), expected) < within,
                   lambda: f"{what}: {self.distance(self.shown(place), expected)} away from what nicol render gives")

    def cpu_seconds(self):
        fields = Path(f"/proc/{self.program.pid}/stat").read_text().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def assert_quits(self):
        self.assertEqual(self.program.wait(PATIENCE_S), 0)
        self.assertEqual(self.stderr(), "")

    def test_edits_show_in_the_window(self):
        self.open_window()
        first = self.render()
        self.wait_for_picture(first, "the first picture")

        change(self.scene, "exposure 2 }", "exposure 0.7 }")
        darker = self.render()
        self.assertGreater(self.distance(first, darker), 50)
        self.wait_for_picture(darker, "after an edit of the scene")

        change(self.folder / "founding.inc", "#declare Edge = 16*mm", "#declare Edge = 8*mm")
        smaller = self.render()
        self.assertGreater(self.distance(darker, smaller), 20)
        self.wait_for_picture(smaller, "after an edit of an included file")

        change(self.scene, "exposure 0.7 }", "exposure 2 }")
        change(self.folder / "founding.inc", "#declare Edge = 8*mm", "#declare Edge = 16*mm")
        self.wait_for_picture(first, "after both edits are taken back")
        self.display.key("q")
        self.assert_quits()

    def test_an_error_is_shown_over_the_last_picture(self):
        self.open_window()
        self.wait_for_picture(self.render(), "the picture")
        pane = self.places["pictures"][0]
        bottom = 10, self.bottom - 150, pane["width"] - 10, self.bottom - 6   # of the left pane, below its picture

        def box():
            """Background and brightest text in the lowest part of the pane."""
            values = sorted(self.display.screen().values(*bottom)[1])
            return values[len(values) // 2], values[-1]

        self.assertEqual(box(), (BEHIND, BEHIND))
        top = [(0.1, 0.05, 0.3, 0.25), (0.7, 0.05, 0.9, 0.25)]
        before = self.shown(parts=top)
        change(self.scene, "exposure 2 }", "exposure }")
        self.until(lambda: abs(box()[0] - BOX) <= 2 and box()[1] > 120, lambda: f"no error is shown: {box()}")
        self.assertLess(self.distance(self.shown(parts=top), before), 1, "the picture above the error has changed")

        change(self.scene, "exposure }", "exposure 2 }")
        self.until(lambda: box() == (BEHIND, BEHIND), lambda: f"the error does not go: {box()}")
        self.wait_for_picture(self.render(), "the mended scene's picture")
        self.display.key("Escape")
        self.assert_quits()

    def test_polarizers_and_camera_by_hand(self):
        self.open_window()
        first = self.render()
        self.wait_for_picture(first, "the picture")

        self.display.key("a", 18)
        include = self.folder / "founding.inc"
        text = include.read_text()
        change(include, "#declare Gamma = 90;", "#declare Gamma = 180;")
        crossed = self.render()
        self.assertGreater(self.distance(first, crossed), 100)
        include.write_text(text)
        self.wait_for_picture(crossed, "the analyzer turned by 90 deg")
        self.display.key("r")
        self.wait_for_picture(first, "the analyzer turned back")

        place = self.places["pictures"][0]
        at = lambda x, y: (round(place["x"] + x * place["width"]), round(place["y"] + y * place["height"]))
        self.display.drag(at(0.5, 0.33), at(0.75, 0.665))
        self.until(lambda: self.distance(self.shown(), first) > 20, lambda: "the camera does not move")
        self.display.key("r")
        self.wait_for_picture(first, "the camera moved back")
        self.display.hand("click", "--repeat", 4, 4)   # the wheel, upwards
        self.until(lambda: self.distance(self.shown(), first) > 20, lambda: "the camera comes no nearer")
        self.display.key("q")
        self.assert_quits()

    def dividers(self):
        """Where the divider lies: first and last column of its grey above the pictures, the title's row left out."""
        row = self.display.screen().values(0, 70, self.places["window"][0], 71)
        columns = [x for x, grey in enumerate(zip(*row)) if grey == (DIVIDER,) * 3]
        return (columns[0], columns[-1]) if columns else None

    def test_the_divider_and_the_window_change_their_size(self):
        window = self.open_window()
        first = self.render()
        self.wait_for_picture(first, "the picture")
        divider = self.places["divider"]
        low, high = divider["x"], divider["x"] + divider["width"] - 1
        self.assertEqual(self.dividers(), (low, high))
        self.display.drag((round(low) + 4, 70), (round(low) + 94, 90))
        self.until(lambda: self.dividers() and abs(self.dividers()[0] - low - 90) <= 1,
                   lambda: f"the divider is at {self.dividers()}")
        self.assertEqual(self.dividers()[1] - self.dividers()[0], high - low)
        left = low + 90
        height = left * 120 / 160
        self.wait_for_picture(first, "the picture of the wider pane",
                              {"x": 0, "y": (divider["height"] - height) / 2, "width": left, "height": height})

        self.display.key("r")
        self.display.drag((round(left) + 4, 70), (round(low) + 4, 70))
        self.display.hand("windowsize", window, 1200, 760)
        with Preview(NICOL, self.scene.name, *SIZE, cwd=self.folder) as larger:
            larger.do("size 1200 760")
            places = larger.state()
        self.wait_for_picture(first, "the picture of the larger window", places["pictures"][0])
        screen = self.display.screen()
        self.assertGreater(min(screen.mean(1190, 300, 1200, 310)), 25, "the panel does not reach the window's side")
        self.assertEqual(screen.mean(1201, 300, 1210, 310), [0, 0, 0])
        self.display.hand("windowsize", window, 300, 200)
        beside = 400, 100, 500, 200
        self.until(lambda: max(self.display.screen().mean(*beside)) == 0, lambda: "the window does not shrink")
        self.display.hand("windowsize", window, *map(round, self.places["window"]))
        self.wait_for_picture(first, "the picture of the window as it was")
        self.display.ask_to_close(window)
        self.assert_quits()

    def test_two_scenes_that_rest(self):
        other = self.folder / "other.pov"
        other.write_text(self.scene.read_text().replace("exposure 2", "exposure 0.7"))
        window = self.open_window("other.pov")
        self.wait_for_picture(self.render(), "the left picture")
        self.scene = other
        self.wait_for_picture(self.render(), "the right picture", self.places["pictures"][1])

        def idle():
            began, seconds = self.cpu_seconds(), 2
            time.sleep(seconds)
            self.idle_part = (self.cpu_seconds() - began) / seconds
            return self.idle_part < 0.05

        self.until(idle, lambda: f"nothing changes, and yet {100 * self.idle_part} % of a core are used")
        self.display.ask_to_close(window)
        self.assert_quits()

    def test_a_scene_that_is_not_there_yet(self):
        self.open_window("missing.pov")
        place = self.places["pictures"][1]
        bottom = place["x"] + 10, self.bottom - 16, place["x"] + 280, self.bottom - 1
        self.until(lambda: abs(self.display.screen().mean(*bottom)[0] - BOX) < 12, lambda: "no error is shown")
        (self.folder / "missing.pov").write_text(self.scene.read_text())
        self.wait_for_picture(self.render(), "the picture of the file that came", place)
        self.display.key("q")
        self.assert_quits()


if __name__ == "__main__":
    unittest.main()
