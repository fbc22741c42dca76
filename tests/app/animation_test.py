#!/usr/bin/env python3
"""Films frame by frame: names, clocks, killed in the middle and continued, with and without ffmpeg.

animation_test.py NICOL COMPARE_EXR
"""

import os
import signal
import subprocess
import sys
import time
import unittest
from pathlib import Path

from runs import PATIENCE_S, Runs

if __name__ == "__main__":
    Runs.compare_path, Runs.nicol_path = sys.argv.pop(2), sys.argv.pop(1)
SCENE = Path(__file__).resolve().parent / "animation.pov"
SMALL = [f"+I{SCENE}", "+W40", "+H30"]
# Stands in for ffmpeg: notes its arguments, writes what is its last one.
STAND_IN = """#!/bin/sh
for a in "$@"; do echo "$a"; done > arguments.txt
for last; do :; done
echo film > "$last"
exit ${FFMPEG_EXIT:-0}
"""


class Animation(Runs):
    def with_ffmpeg(self, **more):
        folder = self.folder / "bin"
        folder.mkdir(exist_ok=True)
        (folder / "ffmpeg").write_text(STAND_IN)
        (folder / "ffmpeg").chmod(0o755)
        return {**os.environ, "PATH": f"{folder}:{os.environ['PATH']}", **more}

    def test_frames_have_their_clocks(self):
        self.done("render", *SMALL, "+Oa.exr", "+KFF3")
        self.assertEqual(self.files(), ["a1.exr", "a2.exr", "a3.exr"])
        self.done("render", *SMALL, "+Omiddle.exr", "+K0.5", "--no-budget")
        self.assert_same("a2.exr", "middle.exr")
        self.done("render", *SMALL, "+Ob.exr", "+KFI8", "+KFF11", "+KI0", "+KF2", "+KC", "+SF9", "+EF9")
        self.assertIn("b09.exr", self.files())
        self.assert_same("a2.exr", "b09.exr")

    def test_what_makes_no_film_is_refused(self):
        self.refused(["frames"], "render", *SMALL, "+KFF0", "+Oa.png")
        self.refused(["+KFF"], "render", *SMALL, "+SF2", "+Oa.png")
        self.refused([".png"], "render", *SMALL, "+KFF2", "+Oa.exr", "--film", "a.mp4")
        self.assertEqual(self.files(), [])

    def test_killed_and_continued(self):
        whole = self.folder / "whole"
        whole.mkdir()
        trial = time.monotonic()
        self.done("render", *SMALL, "+Owhole/a.exr", "--declare", "Samples=20000", "+KFF1")
        seconds = time.monotonic() - trial

        def long(samples):
            return [*SMALL, "--declare", f"Samples={samples}", "+KFF3", "--keep-after", "0"]

        def start(samples):
            for frame in self.folder.glob("a?.exr"):
                frame.unlink()
            return self.start(*long(samples), "+Oa.exr")

        samples = self.killed_in_work(start, min(60000, int(20000 * 2 / seconds)), self.folder / "a2.exr.part", 20000)
        self.assertTrue((self.folder / "a1.exr").exists())
        self.assertFalse((self.folder / "a2.exr").exists())
        before = (self.folder / "a1.exr").stat().st_mtime_ns
        told = self.done("render", *long(samples), "+Oa.exr", "+C")
        self.assertIn("2 frames rendered", told)
        self.assertIn("1 were there", told)
        self.assertNotIn(" 0 tiles were there, 0", told)
        self.assertEqual((self.folder / "a1.exr").stat().st_mtime_ns, before)
        self.done("render", *long(samples), "+Owhole/a.exr")
        for number in (1, 2, 3):
            self.assert_same(f"a{number}.exr", f"whole/a{number}.exr")
        self.assertEqual(self.files(), ["a1.exr", "a2.exr", "a3.exr", "whole"])

    def test_frames_of_another_picture_are_rendered_anew(self):
        def go_on(*more):
            size = [] if "+W41" in more else ["+W40"]
            return self.done("render", f"+I{SCENE}", "+H30", *size, "+Oa.exr", "+KFF2", "--continue", *more)

        self.assertIn("2 frames rendered", go_on())
        told = go_on()
        self.assertIn("0 frames rendered", told)
        self.assertIn("2 were there", told)
        for more, why in ((["+W41"], "the sizes differ (40x30, 41x30)"), (["--samples", 2], "samples"), (["+KF3"], "the scenes differ"),
                          (["--max-trace-level", 3], "max_trace_level"), (["--real", "double"], "precision")):
            with self.subTest(why=why):
                told = go_on(*more)
                self.assertIn("a2.exr is another picture", told)
                self.assertIn(why, told)
                self.assertIn("1 were there" if "+KF3" in more else "2 frames rendered", told)
                self.assertIn("2 were there", go_on(*more))
                go_on()
        self.done("render", *SMALL, "+Owhole.exr", "+KFF2")
        self.assert_same("a2.exr", "whole2.exr")

    def test_frames_that_do_not_say_what_they_are_are_rendered_anew(self):
        frames = [self.folder / "a1.png", self.folder / "a2.png"]

        def go_on():
            return self.done("render", *SMALL, "+Oa.png", "+KFF2", "--continue")

        go_on()
        right = frames[1].read_bytes()
        header = right[:33]  # signature and IHDR
        pixels = right[right.index(b"IDAT") - 4 :]
        for wrong, why in ((header + pixels, "does not say"), (right[:-20], "no whole PNG"), (b"GIF89a", "no whole PNG")):
            frames[1].write_bytes(wrong)
            told = go_on()
            self.assertIn("1 frames rendered", told)
            self.assertIn("a2.png is another picture", told)
            self.assertIn(why, told)
        self.assertIn("2 were there", go_on())

    def test_a_picture_that_is_there_is_left(self):
        scene = self.folder / "grids.pov"
        plugins = SCENE.parents[2] / "scenes" / "plugins"
        scene.write_bytes((plugins / "wire_grid" / "three_grids.pov").read_bytes())
        for name in ("wire_grid.cl", "wire_grid.json"):
            (self.folder / name).write_bytes((plugins / "wire_grid" / name).read_bytes())
        command = ["render", scene, "+W24", "+H16", "-L", self.folder, "--no-budget", "-o", "a.exr", "-o", "a.png", "--continue"]
        self.done(*command)
        before = (self.folder / "a.exr").stat().st_mtime_ns
        self.assertEqual(self.done(*command), "a.exr is there already\n")
        self.assertEqual((self.folder / "a.exr").stat().st_mtime_ns, before)
        (self.folder / "a.png").unlink()
        self.assertNotIn("is there already", self.done(*command))
        with (self.folder / "wire_grid.cl").open("a") as fragment:
            fragment.write("// other words\n")
        self.assertIn("a.exr is another picture (the scenes differ", self.done(*command))
        self.assertIn("is there already", self.done(*command))

    def test_interrupted_keeps_whole_frames_only(self):
        process = self.start(*SMALL, "--declare", "Samples=60000", "+Oa.exr", "+KFF99")
        deadline = time.monotonic() + PATIENCE_S
        while process.poll() is None and time.monotonic() < deadline and not (self.folder / "a01.exr").exists():
            time.sleep(0.01)
        time.sleep(0.2)
        process.send_signal(signal.SIGINT)
        _, told = process.communicate(timeout=PATIENCE_S)
        self.assertEqual(process.returncode, 2, told)
        self.assertIn("--continue", told)
        frames = [name for name in self.files() if name.endswith(".exr")]
        self.assertEqual(frames, [f"a{i:02}.exr" for i in range(1, len(frames) + 1)])
        self.assertLess(len(frames), 99)

    def test_without_ffmpeg_the_command_is_told(self):
        empty = self.folder / "empty"
        empty.mkdir()
        result = self.nicol("render", *SMALL, "+Oa b.png", "+KFF3", "--film", "film.mp4", env={**os.environ, "PATH": str(empty)})
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertIn("ffmpeg is not installed", result.stderr)
        self.assertIn("ffmpeg -nostdin", result.stderr)
        self.assertIn("'a b%01d.png'", result.stderr)
        self.assertEqual(self.files(), ["a b1.png", "a b2.png", "a b3.png", "empty"])

    def test_a_film_by_a_stand_in(self):
        self.done("render", *SMALL, "+Oa.png", "+KFF10", "+SF3", "+EF4", "--film", "film.mp4", "--fps", "12", env=self.with_ffmpeg())
        self.assertEqual((self.folder / "film.mp4").read_text(), "film\n")
        arguments = (self.folder / "arguments.txt").read_text().splitlines()
        for name, value in (("-i", "a%02d.png"), ("-framerate", "12"), ("-start_number", "3"), ("-frames:v", "2")):
            self.assertEqual(arguments[arguments.index(name) + 1], value)

    def test_a_film_that_fails_leaves_nothing(self):
        result = self.nicol("render", *SMALL, "+Oa.png", "+KFF2", "--film", "film.mp4", env=self.with_ffmpeg(FFMPEG_EXIT="3"))
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertIn("exit code 3", result.stderr)
        self.assertEqual(self.files(), ["a1.png", "a2.png", "arguments.txt", "bin"])

    def test_a_film_by_ffmpeg(self):
        self.done("render", f"+I{SCENE}", "+W41", "+H31", "+Oa.png", "+KFF5", "--film", "film.mp4")
        told = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-show_entries", "stream=nb_read_frames,width,height", "-of",
                               "csv=p=0", "film.mp4"], cwd=self.folder, capture_output=True, text=True, check=True).stdout
        self.assertEqual(told.strip(), "42,32,5")


if __name__ == "__main__":
    unittest.main()
