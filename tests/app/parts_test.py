#!/usr/bin/env python3
"""Parts of a picture, rendered by several runs, come to the bits of one run; what does not belong together is told.

parts_test.py NICOL COMPARE_EXR
"""

import re
import sys
import unittest
from pathlib import Path

from runs import Runs

if __name__ == "__main__":
    Runs.compare_path, Runs.nicol_path = sys.argv.pop(2), sys.argv.pop(1)
SCENES = Path(__file__).resolve().parents[2] / "scenes"
FOUNDING = SCENES / "founding" / "fig5_active.pov"  # 21 wavelengths, each traced by itself
CRYSTAL = SCENES / "gems" / "zircon.pov"  # 7 wavelengths; waves in the order of their weights
MONOCHROMATIC = SCENES / "birefringence" / "biaxial_figure.pov"  # lanes over pixels
CUBE = Path(__file__).resolve().parent / "cube.pov"  # 3 wavelengths, one geometry for all
LINE = """#version unofficial 3.7;
global_settings { mm_per_unit 1 wavelengths { 450, 500, 550, 600, 650 } max_trace_level 12 adc_bailout 1e-3 }
camera { location <0, 30, -30> right x*image_width/image_height angle 30 look_at 0 }
background { spectrum { e scale 0.4 } }
polygon { 5, <-8, 0, -8>, <8, 0, -8>, <8, 0, 8>, <-8, 0, 8>, <-8, 0, -8> luminous { spectrum { line 548 } } }
box { <-4, 0, -4>, <4, 6, 4> interior { GLASS } rotate y*20 }
"""
RENDER_S = 2
SIZE = ["-W", 61, "-H", 40]  # odd: lanes that hold pixels go over the ends of rows


class Parts(Runs):
    def render(self, scene, name, *options):
        return self.done("render", scene, *SIZE, "-o", name, *options)

    def check_joined(self, scene, *parts, options=()):
        """The whole, and parts with these options."""
        self.render(scene, "whole.exr", "--no-budget", *options)
        names = []
        for number, part in enumerate(parts):
            names.append(f"part{number}.exr")
            self.render(scene, names[-1], *options, *part)
        told = self.done("merge", *reversed(names), "-o", "merged.exr", "-o", "merged.png")
        self.assertNotIn("warning", told)
        self.assert_same("merged.exr", "whole.exr")
        return names

    def test_shares(self):
        thirds = [("--part", f"{i}/3") for i in (1, 2, 3)]
        for scene in (FOUNDING, CRYSTAL, MONOCHROMATIC, CUBE):
            with self.subTest(scene=scene.name):
                self.check_joined(scene, *thirds, options=("--samples", 2))

    def test_wavelengths(self):
        for scene, options in ((FOUNDING, ()), (CRYSTAL, ()), (CUBE, ()), (FOUNDING, ("--real", "double", "--samples", 20))):
            with self.subTest(scene=scene.name, options=options):
                self.check_joined(scene, ("--wavelengths", "0..470"), ("--wavelengths", "470.5..550"),
                                  ("--wavelength-part", "550.5..1000"), options=options)

    def test_wavelengths_of_a_line(self):
        for glass in ("ior 1.5", "index { cauchy 1.5046, 0.0042 }"):
            with self.subTest(glass=glass):
                (self.folder / "line.pov").write_text(LINE.replace("GLASS", glass))
                self.check_joined("line.pov", ("--wavelengths", "450..500"), ("--wavelengths", "550..550"),
                                  ("--wavelengths", "600..650"))

    def test_shares_of_wavelengths_and_windows(self):
        self.check_joined(CRYSTAL, ("--wavelengths", "0..500"), ("--wavelengths", "501..1000", "--part", "1/2"),
                          ("--wavelengths", "501..1000", "--part", "2/2"))
        self.check_joined(FOUNDING, ("+ER0.5",), ("+SR0.5", "+EC30"), ("+SR0.5", "+SC31"))

    def test_missing_parts_are_told(self):
        names = self.check_joined(FOUNDING, *[("--part", f"{i}/3") for i in (1, 2, 3)])
        told = self.refused(["part 2/3", "pixels", "row", "--incomplete"], "merge", names[0], names[2], "-o", "m.exr")
        self.assertNotIn("m.exr", self.files(), told)
        self.done("merge", names[0], names[2], "-o", "some.exr", "--incomplete")
        self.done("merge", names[1], "some.exr", "-o", "m.exr")
        self.assert_same("m.exr", "whole.exr")
        self.render(FOUNDING, "blue.exr", "--wavelengths", "0..500")
        self.refused(["the wavelengths 520, 540"], "merge", "blue.exr", "-o", "n.exr")
        self.refused([f"{names[0]} is one of the parts"], "merge", *names, "-o", names[0])

    def test_what_does_not_belong_together_is_told(self):
        self.render(CUBE, "a.exr", "--part", "1/2")
        for option, words in ((("--declare", "Sky=0.3"), ["scenes differ"]),
                              (("--samples", 4), ["samples differs (1, 4)"]),
                              (("--adc-bailout", 1e-3), ["adc_bailout differs"]),
                              (("--real", "double"), ["precision differs (float, double)"]),
                              (("--wavelengths", "400:700:50"), ["wavelengths of the whole picture differ"]),
                              (("+H41",), ["sizes differ (61x40, 61x41)"])):
            with self.subTest(option=option):
                size = ["+W61"] if option == ("+H41",) else SIZE
                self.done("render", CUBE, *size, "-o", "b.exr", "--part", "2/2", *option)
                self.refused(["a.exr", "b.exr", *words], "merge", "a.exr", "b.exr", "-o", "m.exr")
        self.render(CUBE, "lanes.exr", "--part", "2/2", "--lanes", 1)
        self.assertIn("1 lanes", self.done("merge", "a.exr", "lanes.exr", "-o", "m.exr"))
        self.render(CUBE, "whole.exr", "--no-budget")
        self.refused(["whole.exr", "not a part"], "merge", "a.exr", "whole.exr", "-o", "m.exr")
        (self.folder / "b.exr").write_bytes((self.folder / "a.exr").read_bytes()[:-100])
        self.refused(["b.exr"], "merge", "b.exr", "-o", "m.exr")

    def test_what_needs_a_whole_picture_is_refused(self):
        part = ["render", CUBE, *SIZE, "--part", "1/2", "-o"]
        self.refused(["a.png", ".exr"], *part, "a.png")
        self.refused(["an error to be kept", "whole picture"], *part, "a.exr", "--error", "1%")
        self.refused(["a sample error to be kept", "whole picture"], *part, "a.exr", "--sample-error", "1%")
        self.refused(["an error bound"], *part, "a.exr", "--error-map", "map.exr")
        self.refused(["none of the scene's 3 wavelengths"], "render", CUBE, "--wavelengths", "460..500", "-o", "a.exr")
        self.refused(["part is told as i/n", "3/2"], "render", CUBE, "--part", "3/2", "-o", "a.exr")
        self.refused(["row 41"], "render", CUBE, *SIZE, "+SR41", "-o", "a.exr")
        self.assertEqual(self.files(), [])

    def test_a_window_may_be_looked_at(self):
        self.render(CUBE, "a.png", "+SR0.5", "+EC20")
        self.assertEqual(self.files(), ["a.png"])

    def test_a_killed_part_goes_on_to_the_same_bits(self):
        half = [CUBE, "-W", 1024, "-H", 1024, "--part", "1/2", "--keep-after", 0, "--samples"]
        trial = self.done("render", *half, 4, "-o", "a.exr")
        seconds = float(re.search(r"^([\d.]+) s, ", trial, re.MULTILINE)[1])
        samples = self.killed_in_work(lambda n: self.start(*half, n, "-o", "a.exr"), int(4 * RENDER_S / max(seconds, 0.005)),
                                      self.folder / "a.exr.part", 10_000_000)
        long = [*half, samples]
        told = self.done("render", *long, "-o", "a.exr", "--continue")
        self.assertNotIn(" 0 tiles were there", told)
        self.done("render", *long, "-o", "whole.exr")
        self.assert_same("a.exr", "whole.exr")
        self.assertEqual(self.files(), ["a.exr", "whole.exr"])


if __name__ == "__main__":
    unittest.main()
