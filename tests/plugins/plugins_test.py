#!/usr/bin/env python3
"""Plugins through the program: formulas, spectra, solids, importers and sinks in use; where they are found; every way to be wrong.

plugins_test.py NICOL COMPARE_EXR TEST_PLUGINS OWN_PLUGINS SCENES_PLUGINS
"""

import math
import os
import re
import shutil
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "app"))
import runs  # noqa: E402

if __name__ == "__main__":
    runs.Runs.nicol_path, runs.Runs.compare_path, TEST, OWN, SCENES = [sys.argv.pop(1) for _ in range(5)]

HEAD = """#version unofficial 3.7;
global_settings { mm_per_unit 1 wavelengths { 500, 600 } }
camera { location <2, 1.5, -8> look_at <0.5, 0.5, 0.5> angle 30 right x*image_width/image_height }
background { spectrum { e } }
"""
GLASS = " interior { ior 1.5 } "
SMALL = ("-W", "6", "-H", "5", "--no-budget", "-q")


class Plugins(runs.Runs):
    def scene(self, text, name="scene.pov"):
        (self.folder / name).write_text(HEAD + text, encoding="utf-8")
        return name

    def using(self, formula, name="scene.pov"):
        """A cube whose index a plugin gives."""
        return self.scene(f'box {{ 0, 1 interior {{ index {{ plugin {{ "{formula}" }} }} }} }}\n', name)

    def test_published_indices_of_lithium_niobate(self):
        """Against others' measurements of congruent crystals: n_o of Zelmon, Small and Jundt, J. Opt. Soc. Am. B 14, 3319 (1997) at room
        temperature, n_e of Jundt, Opt. Lett. 22, 1553 (1997) at any."""
        def zelmon_ordinary(lambda_nm):
            l2 = (lambda_nm / 1000) ** 2
            return math.sqrt(1 + 2.6734 * l2 / (l2 - 0.01764) + 1.2290 * l2 / (l2 - 0.05914) + 12.614 * l2 / (l2 - 474.6))

        def jundt_extraordinary(kelvin, lambda_nm):
            celsius, l2 = kelvin - 273.15, (lambda_nm / 1000) ** 2
            f = (celsius - 24.5) * (celsius + 570.82)
            return math.sqrt(5.35583 + 4.629e-7 * f + (0.100473 + 3.862e-8 * f) / (l2 - (0.20692 - 0.89e-8 * f) ** 2)
                             + (100 + 2.657e-5 * f) / (l2 - 11.34927 ** 2) - 1.5334e-2 * l2)

        def indices(kelvin, lambda_nm):
            media = "".join(f'#declare M_{w} = interior {{ index {{ plugin {{ "temperature_sellmeier/lithium_niobate_{w}" '
                            f'temperature {kelvin} }} }} name "{w}" }}\nbox {{ {x}, {x + 1} interior {{ M_{w} }} }}\n'
                            for x, w in ((0, "ordinary"), (2, "extraordinary")))
            text = self.nicol("explain", "--media", self.scene(media), "--lambda", lambda_nm)
            self.assertEqual(text.returncode, 0, text.stderr)
            rows = {w: next(line for line in text.stdout.splitlines() if re.search(rf"(^|\s|\|)\W*{w}\b", line))
                    for w in ("ordinary", "extraordinary")}
            return [float(re.search(r"\b2\.\d+", rows[w]).group()) for w in ("ordinary", "extraordinary")]

        cool_k, warm_k = 297.65, 397.65
        for lambda_nm in (450, 532, 632.8, 1064):
            cool, warm = indices(cool_k, lambda_nm), indices(warm_k, lambda_nm)
            self.assertAlmostEqual(cool[0], zelmon_ordinary(lambda_nm), delta=2e-4)
            for kelvin, n in ((cool_k, cool), (warm_k, warm)):
                self.assertAlmostEqual(n[1], jundt_extraordinary(kelvin, lambda_nm), delta=4e-4)
            drift = jundt_extraordinary(warm_k, lambda_nm) - jundt_extraordinary(cool_k, lambda_nm)
            self.assertAlmostEqual(warm[1] - cool[1], drift, delta=4e-4)  # of some 5e-3
            self.assertLess(abs(warm[0] - cool[0]), 2e-3)  # n_o changes less

    def test_parameters_are_checked(self):
        for said, words in (("temperature 3500", ["'temperature' of plugin", "between 250 and 800 K, 3500 found"]),
                            ("temprature 300", ["unknown parameter 'temprature'", "did you mean 'temperature'"]),
                            ("temperature", ["Expected 'numeric expression' after 'temperature'"]),
                            ('temperature "hot"', ["string literal found"]),
                            ("temperature 300 temperature 310", ["said twice"])):
            box = f'box {{ 0, 1 interior {{ index {{ plugin {{ "temperature_sellmeier/lithium_niobate_ordinary" {said} }} }} }} }}'
            self.refused(["File 'scene.pov' line 5", *words], "check", self.scene(box))

    def test_spectrum_and_sink(self):
        scene = HEAD.replace("spectrum { e }", 'spectrum { plugin { "lamp" centre 500 width 50 } }')
        (self.folder / "lamp.pov").write_text(scene + "box { 9, 10" + GLASS + "}\n", encoding="utf-8")
        self.done("render", "lamp.pov", "-o", "out.txt", "--plugin", f"{TEST}/lab.so", "-W", 2, "-H", 2, "-q")
        lines = (self.folder / "out.txt").read_text(encoding="utf-8").split("\n")
        self.assertEqual(lines[0], "2 2 2")
        values = [float(line.split()[1]) for line in lines[1:3]]
        self.assertAlmostEqual(values[1] / values[0], math.exp(-2), places=6)
        self.refused(["three is one too many", "lab.so"], "render", "lamp.pov", "-o", "bad.txt", "--plugin", f"{TEST}/lab.so", "-W", 3, "-H", 2)
        self.refused(["cannot write bad.txt", "lab.so: sink 'numbers'", "has written nothing"], "render", "lamp.pov", "-o", "bad.txt",
                     "--plugin", f"{TEST}/lab.so", "-W", 4, "-H", 2)
        self.assertEqual([p.name for p in self.folder.iterdir() if p.name not in ("lamp.pov", "out.txt")
                          and not p.name.endswith(".part")], [])
        self.refused(["unknown suffix .txt"], "render", "lamp.pov", "-o", "out.txt", "-L", TEST)

    def same_picture(self, one, other, *more):
        for name, text in (("one", one), ("other", other)):
            self.done("render", self.scene(text, f"{name}.pov"), "-o", f"{name}.exr", *SMALL, *more)
        self.assert_same("one.exr", "other.exr")

    def test_mesh_cube_is_the_box(self):
        lab = ("--plugin", f"{TEST}/lab.so")
        self.same_picture("solid { plugin { \"cube\" edge 1 }" + GLASS + "rotate 20*y }\n", "box { 0, 1" + GLASS + "rotate 20*y }\n", *lab)
        self.same_picture("difference { solid { plugin { \"lab/cube\" } } box { 0.5, 2 }" + GLASS + "}\n",
                          "difference { box { 0, 1 } box { 0.5, 2 }" + GLASS + "}\n", *lab)
        of_lab = f'solid "cube" of plugin {os.path.realpath(TEST)}/lab.so'
        self.refused(["File 'scene.pov' line 5", f"{of_lab} is open: the edge from", "has no other face"], "check",
                     self.scene('solid { plugin { "cube" open 1 }' + GLASS + "}\n"), *lab)
        self.refused(["File 'scene.pov' line 5", f"{of_lab}' at line 5 is open"], "check",
                     self.scene('difference { solid { plugin { "cube" open 1 } } box { 0.5, 2 }' + GLASS + "}\n"), *lab)

    def test_mesh_that_is_not_convex(self):
        text = self.scene('solid { plugin { "ell" }' + GLASS + "}\nbox { <1, 0, 1>, <3, 1, 2>" + GLASS + "optical_contact }\n")
        self.done("check", text, "--plugin", f"{TEST}/lab.so")  # fits into the L without overlap
        self.refused(["overlap"], "check", self.scene('solid { plugin { "ell" }' + GLASS + "}\nbox { <0.9, 0, 1>, <3, 1, 2>" + GLASS + "}\n"),
                     "--plugin", f"{TEST}/lab.so")

    def test_files_that_are_found_keep_their_names(self):
        for name in ("first_file_with_a_long_name.txt", "second_file_with_a_long_name.txt"):
            (self.folder / name).write_text("", encoding="utf-8")
        self.done("check", self.scene('solid { plugin { "filed" first "first_file_with_a_long_name.txt" '
                                      'second "second_file_with_a_long_name.txt" }' + GLASS + "}\n"), "--plugin", f"{TEST}/lab.so")

    def test_goniometer_is_the_crystal_of_facets(self):
        lines = (Path(SCENES) / "goniometer" / "quartz.gon").read_text(encoding="utf-8").splitlines()
        shutil.copy(Path(SCENES) / "goniometer" / "quartz.gon", self.folder)
        facets = ""
        for words in (line.split("#")[0].split() for line in lines):
            if words[:1] != ["face"]:
                continue
            degree = math.acos(-1.0) / 180
            phi, rho = float(words[2]) * degree, float(words[3]) * degree
            normal = (math.sin(rho) * math.sin(phi), math.sin(rho) * math.cos(phi), math.cos(rho))
            facets += f"facet <{normal[0]!r}, {normal[1]!r}, {normal[2]!r}>, {float(words[4])!r}\n"
        self.assertEqual(facets.count("facet"), 18)
        turn = "scale 0.3 rotate 20*y translate 0.5"
        solid = 'solid { plugin { "goniometer" file "quartz.gon" }' + GLASS + turn + " }\n"
        crystal = "crystal { " + facets + GLASS + turn + " }\n"
        for name, text in (("one", solid), ("other", crystal)):
            self.done("render", self.scene(text, f"{name}.pov"), "-o", f"{name}.txt", "--plugin", f"{TEST}/lab.so", "-W", 8, "-H", 8, "--no-budget", "-q")
        self.assertEqual(*[(self.folder / f"{name}.txt").read_text(encoding="utf-8") for name in ("one", "other")])

    def test_importer_and_its_messages(self):
        gon = self.folder / "stone.gon"
        shutil.copy(Path(SCENES) / "goniometer" / "quartz.gon", gon)
        self.done("check", "stone.gon", "--plugin", "goniometer")
        self.done("render", "stone.gon", "-o", "stone.png", "--plugin", "goniometer", *SMALL)
        text = gon.read_text(encoding="utf-8").splitlines()
        at = next(i for i, line in enumerate(text) if line.startswith("face r1"))
        text[at] = "face r1 0 200 2"
        gon.write_text("\n".join(text) + "\n", encoding="utf-8")
        self.refused([f"stone.gon line {at + 1}", "rho lies between 0 and 180 degrees"], "check", "stone.gon", "--plugin", "goniometer")
        gon.write_text("face a 0 90 1\n", encoding="utf-8")
        self.refused(["File 'stone.gon' line 8", "open towards"], "check", "stone.gon", "--plugin", "goniometer")  # in the importer's text
        self.refused(["File 'scene.pov' line 5", "cannot find file 'none.gon'"], "check",
                     self.scene('solid { plugin { "goniometer" file "none.gon" }' + GLASS + "}\n"))

    def test_where_plugins_are_found(self):
        shutil.copy(f"{TEST}/bad_nothing.so", self.folder / "grey.so")
        (self.folder / "lib").mkdir()
        shutil.copy(f"{TEST}/lab.so", self.folder / "lib")
        scene = self.using("lab/grey", "grey.pov")
        shutil.copy(f"{TEST}/lab.so", self.folder)  # beside the scene, in the working directory: not looked at
        told = self.refused(["File 'grey.pov' line 5", "plugin 'lab/grey' is not found", "there is no lab.so in", OWN], "check", scene)
        self.assertNotIn(str(self.folder), told)
        self.refused(["plugin 'grey' is not found"], "check", self.using("grey"))
        self.done("check", scene, "-L", "lib")
        self.done("check", scene, "--plugin", "./lab.so")
        self.done("check", scene, "--plugin", "lab.so")
        self.done("check", self.using("grey"), "--plugin", "lib/lab.so")
        environment = dict(os.environ, NICOL_PLUGIN_PATH=f"/nowhere:{self.folder}/lib")
        self.done("check", scene, env=environment)
        self.done("check", self.using("grey"), "--plugin", "lab", env=environment)
        self.refused(["plugin 'lab' is not found", "lab.so"], "check", scene, "--plugin", "lab")
        for name in ("../lab/grey", ".lab", "a/b/c", ""):
            self.refused(["File 'scene.pov' line 5"], "check", self.using(name), "-L", "lib")
        shutil.copy(f"{TEST}/lab.so", self.folder / "lib" / "second.so")
        self.refused(["two plugins have a dispersion formula 'grey'", "lab/grey", "second/grey"], "check", self.using("grey"),
                     "--plugin", "lib/lab.so", "--plugin", "lib/second.so")
        self.refused(["two plugins have a sink for .txt", "lab/numbers", "second/numbers"], "render", self.using("lab/grey"), "-o", "out.txt",
                     "--plugin", "lib/lab.so", "--plugin", "lib/second.so")
        self.refused(["has no dispersion formula 'lamp'", "it has: 'grey'"], "check", self.using("lab/lamp"), "-L", "lib")

    def test_extinction_of_a_formula(self):
        scene = self.scene('box { 0, 1 interior { index { plugin { "grey" } } extinction { plugin { "grey" k 1e-4 } } } }\n')
        self.assertIn("absorption", self.nicol("explain", "--no-build", scene, "--plugin", f"{TEST}/lab.so").stdout)

    def test_everything_that_may_be_wrong(self):
        (self.folder / "bad_elf.so").write_text("not a shared object\n", encoding="utf-8")
        cases = {
            "no_symbol": ["without the function nicol_plugin_v1"],
            "later": ["made for a later nicol", "nicol_plugin_v2"],
            "nan": ["gives the refractive index", "nan at 600 nm"],
            "zero": ["refractive index 0 at 500 nm", "above 0"],
            "status": ["failed: the oven is cold"],
            "place": ["calls add_point where it does not belong"],
            "late": ["calls a function that registers where it does not belong"],
            "size": ["struct_size of 12", "another version of nicol_plugin.h"],
            "name": ["'not a name', which is no name"],
            "function": ["without its function"],
            "nothing": ["registers nothing"],
            "twice": ["'bad_twice' twice"],
            "entry": ["failed: no licence"],
            "throws_at_entry": ["threw an exception: no lamp at all"],
            "throws": ["threw an exception: the lamp has burst"],
            "elf": ["cannot be loaded"],
        }
        for wrong, words in cases.items():
            with self.subTest(wrong):
                folder = self.folder if wrong == "elf" else TEST
                self.refused(["File 'scene.pov' line 5", f"{folder}/bad_{wrong}.so", *words], "check", self.using(f"bad_{wrong}"), "-L", folder)
        two = self.scene("".join(f'box {{ {x}, {x + 1} interior {{ index {{ plugin {{ "bad_throws" }} }} }} }}\n' for x in (0, 3)))
        self.refused(["File 'scene.pov' line 5", "File 'scene.pov' line 6", "is not called again"], "check", two, "-L", TEST)
        self.refused(["bad_size.so"], "check", self.using("bad_size"), "--plugin", f"{TEST}/bad_size.so")
        self.refused(["there is no such file"], "check", self.using("x"), "--plugin", "./none.so")

    def test_list(self):
        result = self.nicol("plugins", "--plugin", f"{TEST}/lab.so")
        self.assertEqual(result.returncode, 0, result.stderr)
        for words in ("lithium_niobate_ordinary", "temperature number, K, default 297.65, from 250 to 800", "importer goniometer for .gon",
                      "sink numbers for .txt", "file \"text\", must be said"):
            self.assertIn(words, result.stdout)

    def test_list_of_fragments(self):
        """nicol's own, and what lies in a folder that is named, by itself or in a folder of its name."""
        own = self.nicol("plugins")
        self.assertEqual(own.returncode, 0, own.stderr)
        for words in ("wire_grid/wire_grid.json\n  polarizing element wire_grid: a free-standing grid", "surface thin_film: one homogeneous",
                      "    period number, nm, default 140, from 10 to 250: from wire to wire\n", "thickness_nm number, nm, from 0 to 100000, must be said"):
            self.assertIn(words, own.stdout)
        for place in ("", "half/"):
            (self.folder / "lib" / place).mkdir(parents=True, exist_ok=True)
            for end in ("json", "cl"):
                text = (Path(SCENES) / "thin_film" / f"thin_film.{end}").read_text(encoding="utf-8")
                name = "half" if place else "film"
                (self.folder / "lib" / place / f"{name}.{end}").write_text(text.replace("thin_film", name), encoding="utf-8")
        (self.folder / "lib" / "other.json").write_text("{}", encoding="utf-8")  # no OpenCL C beside it: of something else
        found = self.nicol("plugins", "-L", "lib")
        self.assertEqual(found.returncode, 0, found.stderr)
        for words in ("lib/film.json\n  surface film: one", "lib/half/half.json\n  surface half: one"):
            self.assertIn(words, found.stdout)
        (self.folder / "lib" / "film.json").write_text("{ }", encoding="utf-8")
        told = self.refused(["lib/film.json:1:1: 'name' is missing"], "plugins", "-L", "lib")
        self.assertNotIn("wire_grid", told)

    def test_demo_scenes(self):
        for scene in ("temperature_sellmeier/lithium_niobate.pov", "goniometer/quartz.pov"):
            self.done("check", f"{SCENES}/{scene}")


if __name__ == "__main__":
    unittest.main()
