#!/usr/bin/env python3
"""Pictures as numpy arrays: no copy, the right shapes, the same bits as the command line's; what goes with a picture.

module_test.py NICOL COMPARE_EXR; NICOL_LIBRARY and PYTHONPATH say where the library and nicol.py are.
"""

import ctypes
import gc
import io
import subprocess
import sys
import tempfile
import unittest
import weakref
from pathlib import Path

import matplotlib.image
import numpy as np

import nicol

if __name__ == "__main__":
    COMPARE, PROGRAM = sys.argv.pop(2), sys.argv.pop(1)
ROOT = Path(__file__).resolve().parents[2]
CUBE = ROOT / "tests" / "app" / "cube.pov"
WIDTH, HEIGHT = 41, 30


def cube(**options):
    return nicol.load(CUBE, width=WIDTH, height=HEIGHT, **options)


class Layout(unittest.TestCase):
    def test_structs_are_those_of_the_header(self):
        """Places of all members, as a C compiler has them."""
        lines, expected = [], []
        for struct in nicol.STRUCTS:
            for name, _ in struct._fields_:
                lines.append(f'printf("%zu\\n", offsetof({struct.__name__}, {name}));')
                expected.append(getattr(struct, name).offset)
        program = "#include <nicol.h>\n#include <stdio.h>\nint main(void) {" + "\n".join(lines) + "return 0; }"
        with tempfile.TemporaryDirectory() as folder:
            source, binary = Path(folder, "layout.c"), Path(folder, "layout")
            source.write_text(program)
            subprocess.run(["cc", "-I", ROOT / "host" / "api", source, "-o", binary], check=True)
            found = subprocess.run([binary], check=True, capture_output=True, text=True).stdout
        self.assertEqual([int(line) for line in found.split()], expected)

    def test_planes_are_numbered_as_in_the_header(self):
        header = (ROOT / "host" / "api" / "nicol.h").read_text()
        for number, plane in enumerate(nicol._PLANES):
            self.assertRegex(header, rf"NICOL_PLANE_{plane.upper()} = {number}\b")


class Film(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scene = cube()
        cls.picture = cls.scene.render()

    def test_shapes(self):
        picture = self.picture
        self.assertEqual((picture.width, picture.height), (WIDTH, HEIGHT))
        self.assertEqual((self.scene.width, self.scene.height), (WIDTH, HEIGHT))
        self.assertEqual(picture.wavelengths_nm.tolist(), [450, 550, 650])
        self.assertEqual(self.scene.wavelengths_nm.tolist(), [450, 550, 650])
        self.assertEqual(picture.widths_nm.shape, (3,))
        self.assertEqual((picture.stokes.shape, picture.stokes.dtype), ((4, 3, HEIGHT, WIDTH), np.float32))
        self.assertEqual((picture.xyz.shape, picture.linear_srgb.shape), ((3, HEIGHT, WIDTH),) * 2)
        self.assertEqual(picture.srgb().shape, (HEIGHT, WIDTH, 3))
        for plane in ("coverage", "samples", "cut_off"):
            self.assertEqual(picture.plane(plane).shape, (HEIGHT, WIDTH))
        self.assertTrue((picture.plane("coverage") == 1).all())

    def test_values(self):
        """The sky, unpolarized, in the corners; light from glass is polarized, but by no more than all of it."""
        stokes = self.picture.stokes
        self.assertTrue((stokes[0, :, 0, 0] > 0).all() and (stokes[1:, :, 0, 0] == 0).all())
        degree = self.picture.degree_of_polarization()
        self.assertGreater(degree.max(), 0.05)
        self.assertLessEqual(degree.max(), 1 + 1e-5)
        self.assertEqual(degree[:, 0, 0].max(), 0)
        most = np.unravel_index(degree.argmax(), degree.shape)
        s_0, s_1, s_2, s_3 = stokes[(slice(None), *most)].astype(float)
        angle, ellipticity = np.radians(self.picture.polarization_angle_deg()[most]), np.radians(self.picture.ellipticity_angle_deg()[most])
        polarized = degree[most] * s_0
        np.testing.assert_allclose([polarized * np.cos(2 * ellipticity) * np.cos(2 * angle),
                                    polarized * np.cos(2 * ellipticity) * np.sin(2 * angle), polarized * np.sin(2 * ellipticity)],
                                   [s_1, s_2, s_3], atol=1e-6)

    def test_arrays_are_the_film_itself(self):
        place = ctypes.c_void_p()
        self.assertEqual(nicol._lib.nicol_picture_stokes(self.picture.open_pointer, ctypes.byref(place)), 0)
        self.assertEqual(self.picture.stokes.__array_interface__["data"], (place.value, True))
        self.assertFalse(self.picture.stokes.flags.owndata)
        with self.assertRaises(ValueError):
            self.picture.stokes[0, 0, 0, 0] = 1
        with self.assertRaises(ValueError):
            self.picture.stokes.flags.writeable = True

    def test_arrays_keep_the_picture(self):
        with nicol.Context() as context:
            scene = context.load(CUBE, width=WIDTH, height=HEIGHT)
            picture = scene.render()
        handles = [weakref.ref(thing._handle) for thing in (scene, picture)]
        row = picture.stokes[0, 1, 7]
        lambda_nm, before = picture.wavelengths_nm, row.copy()
        picture.close()
        del context, scene, picture
        gc.collect()
        others = [cube().render() for _ in range(2)]  # would take the memory, were it free
        np.testing.assert_array_equal(row, before)
        self.assertEqual(lambda_nm.tolist(), [450, 550, 650])
        self.assertTrue(all(handle() is not None for handle in handles))
        del row, lambda_nm, others
        gc.collect()
        self.assertEqual([handle() for handle in handles], [None, None])

    def test_two_pictures_at_once(self):
        dim = cube(declares={"Sky": 0.1}).render()
        np.testing.assert_allclose(dim.stokes[0, :, 0, 0] * 4, self.picture.stokes[0, :, 0, 0], rtol=1e-6)

    def test_options_of_a_scene(self):
        picture = cube(wavelengths_nm=np.array([600.0, 500.0]), samples=4).render(precision="double")
        self.assertEqual(picture.wavelengths_nm.tolist(), [500, 600])
        self.assertEqual(picture.report.precision, "double")
        self.assertEqual(picture.report.samples_mean, 4)
        rows = self.scene.render(rows=(10, 12), columns=(3, 9))
        np.testing.assert_array_equal(rows.stokes[:, :, 10:12, 3:9], self.picture.stokes[:, :, 10:12, 3:9])
        self.assertEqual(rows.plane("coverage").sum(), 12)

    def test_told_of_a_scene(self):
        self.assertEqual(Path(self.scene.files[0]).name, "cube.pov")
        on = [feature for feature in self.scene.features if feature.on]
        self.assertTrue(on)
        for feature in on:
            self.assertIn(feature.name, self.scene.explanation)
        self.assertTrue(all(feature.name and feature.meaning for feature in self.scene.features))
        self.assertIn("41 x 30 pixels, 3 wavelengths, 450 to 650 nm", repr(self.scene))
        self.assertIn("41 x 30 pixels", repr(self.picture))

    def test_colours_of_a_notebook(self):
        with tempfile.TemporaryDirectory() as folder:
            written = Path(folder, "a.png")
            self.picture.write(written)
            file = matplotlib.image.imread(written)
        shown = matplotlib.image.imread(io.BytesIO(self.picture._repr_png_()))
        np.testing.assert_array_equal(np.rint(file * 255), self.picture.srgb())
        np.testing.assert_array_equal(shown, file)


class Files(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def assert_same(self, one, two):
        result = subprocess.run([COMPARE, self.folder / one, self.folder / two], capture_output=True, text=True, check=False)
        self.assertEqual(result.returncode, 0, result.stdout)

    def test_same_bits_as_the_command_line(self):
        cube().render().write(self.folder / "module.exr")
        subprocess.run([PROGRAM, "render", CUBE, "-W", str(WIDTH), "-H", str(HEIGHT), "--no-budget", "--quiet",
                        "-o", self.folder / "program.exr"], check=True)
        self.assert_same("module.exr", "program.exr")

    def test_parts_merged(self):
        scene, files = cube(samples=2), [self.folder / name for name in ("1.exr", "2.exr")]
        whole = scene.render()
        for number, file in enumerate(files, 1):
            scene.render(part=(number, 2)).write(file)
        merged = nicol.merge(files)
        np.testing.assert_array_equal(merged.stokes, whole.stokes)
        merged.write(self.folder / "merged.exr")
        whole.write(self.folder / "whole.exr")
        self.assert_same("merged.exr", "whole.exr")
        with self.assertRaises(nicol.UnavailableError):
            merged.report
        with self.assertRaises(nicol.InputError):
            nicol.merge(files[:1])
        half = nicol.merge(files[:1], incomplete=True)
        self.assertLess(half.plane("coverage").mean(), 1)

    def test_error_bound_and_budget(self):
        picture = cube().render(error_bound=True, error_budget=True)
        self.assertEqual(picture.error_bound.shape, (HEIGHT, WIDTH))
        self.assertGreater(picture.error_bound.max(), 0)
        sources = {line.source: line for line in picture.budget.lines}
        self.assertGreaterEqual(set(sources), {"cut-off", "sampling", "spectral step", "rounding"})
        self.assertGreater(picture.budget.rms, 0)
        self.assertLess(sources["rounding"].rms, 1e-4)
        picture.write_error_map(self.folder / "map.exr")
        self.assertTrue((self.folder / "map.exr").is_file())
        self.assertTrue(any("cube.pov" in text for text in picture.notes.values()))

    def test_settings_chosen_for_an_error(self):
        picture = cube(error=0.05).render()
        self.assertEqual(picture.chosen.error, 0.05)
        self.assertTrue(picture.chosen.text)
        self.assertIsNone(cube().render().chosen)
        self.assertIsNone(cube().render().budget)


if __name__ == "__main__":
    unittest.main()
