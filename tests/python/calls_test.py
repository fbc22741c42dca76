#!/usr/bin/env python3
"""Errors, callbacks and Ctrl-C of nicol in Python: each comes out where Python expects it.

calls_test.py; NICOL_LIBRARY and PYTHONPATH say where the library and nicol.py are.
"""

import copy
import os
import pickle
import signal
import tempfile
import threading
import time
import unittest
from pathlib import Path

import numpy as np

import nicol

SCENE = """#version unofficial 3.7;
global_settings { mm_per_unit 1 wavelengths { 450, 550, 650 } max_trace_level 12 adc_bailout 1e-4 }
camera { location <0, 30, -30> right x*image_width/image_height angle 30 look_at 0 }
background { spectrum { e scale 0.4 } }
polygon { 5, <-8, 0, -8>, <8, 0, -8>, <8, 0, 8>, <-8, 0, 8>, <-8, 0, -8> luminous { spectrum { e } } }
box { <-4, 0, -4>, <4, 6, 4> interior { ior 1.5 } }
"""
ENDLESS = {"width": 1024, "height": 1024, "samples": 1000}  # minutes, were it not stopped


def small(text=SCENE, **options):
    return nicol.load_text(text, "small.pov", width=24, height=18, **options)


class Errors(unittest.TestCase):
    def test_scene_with_errors(self):
        with self.assertRaises(nicol.SceneError) as caught:
            small(SCENE + "bxo { 0, 1 }\nbox { 0, 1 interior { iro 2 } }\n")
        errors = [found for found in caught.exception.diagnostics if found.severity == "error"]
        self.assertEqual([(error.file, error.line) for error in errors], [("small.pov", 7), ("small.pov", 8)])
        self.assertEqual(errors[1].column, 23)
        self.assertIn("iro", errors[1].message)
        self.assertIn("'small.pov' line 7", str(caught.exception))
        self.assertEqual(caught.exception.status, 3)

    def test_each_kind(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertRaisesRegex(nicol.InputError, "no.pov", nicol.load, Path(folder, "no.pov"))
            self.assertRaisesRegex(nicol.OutputError, "nowhere", small().render().write, Path(folder, "nowhere", "a.exr"))
            self.assertRaises(nicol.Error, small().render().write, Path(folder, "a.bmp"))
            self.assertEqual(os.listdir(folder), [])
        self.assertRaisesRegex(nicol.DeviceError, "no such device", nicol.Context, device="no such device")
        self.assertRaisesRegex(nicol.PluginError, "no_such_plugin", nicol.Context().load_plugin, "no_such_plugin")
        self.assertRaises(nicol.ArgumentError, small, error=2)
        self.assertRaises(ValueError, small().render, precision="half")
        self.assertRaises(ValueError, small().render, rows=(5, 5))
        self.assertRaises(TypeError, small, clok=1)
        self.assertRaises(nicol.UnavailableError, lambda: small().render().error_bound)

    def test_forked(self):
        small().render()
        child = os.fork()
        if child == 0:
            code = 1
            signal.alarm(60)
            try:
                small().render()
            except nicol.DeviceError as error:
                code = 0 if "forked" in str(error) else 2
            finally:
                os._exit(code)
        self.assertEqual(os.waitpid(child, 0)[1], 0)

    def test_closed(self):
        scene = small()
        picture = scene.render()
        for thing, use in ((picture, lambda: picture.stokes), (scene, scene.render)):
            thing.close()
            with self.assertRaisesRegex(ValueError, "closed"):
                use()
            self.assertIn("closed", repr(thing))

    def test_what_c_would_misread(self):
        for wrong in ({"samples": 2**33 + 1}, {"declares": {"Sk\0y": 1}}):
            with self.subTest(wrong=wrong), self.assertRaises(ValueError):
                small(**wrong)
        with self.assertRaises(ValueError):
            small().render(lanes=2**32)
        with self.assertRaises(ValueError):
            small().render().write("a.exr\0b.png")
        for call in (lambda: small(library_paths="/tmp"), lambda: small(7), lambda: small('#include "x.inc"', include=lambda name: 5),
                     lambda: nicol.merge("abc")):
            self.assertRaises(TypeError, call)

    def test_errors_speak_python(self):
        scene = small()
        picture = scene.render()
        for call, words in ((lambda: scene.render(precision="half"), "precision is one of 'float', 'double', not 'half'"),
                            (lambda: small(polarization="off"), "polarization is one of None, True, False, not 'off'"),
                            (lambda: scene.render(part="1/3"), r"part is a pair \(i, n\), not '1/3'"),
                            (lambda: scene.render(rows=4), r"rows is a pair \(first, stop\), not 4"),
                            (lambda: scene.render(wavelengths_nm=(450,)), r"wavelengths_nm is a pair \(first, last\)")):
            self.assertRaisesRegex(ValueError, words, call)
        with self.assertRaisesRegex(nicol.UnavailableError, r"not rendered with error_bound\b"):
            picture.plane("error_total")

    def test_copies(self):
        """Copies are closed by themselves; nothing goes into a pickle."""
        scene = small()
        picture = scene.render()
        for thing in (scene, picture):
            for made in (copy.copy(thing), copy.deepcopy([thing])[0]):
                made.close()
            self.assertEqual((thing.width, thing.height), (24, 18))
            other = copy.deepcopy(thing)
            thing.close()
            self.assertEqual(other.width, 24)
            self.assertRaisesRegex(TypeError, "stay in their process", pickle.dumps, other)

    def test_merge_takes_what_can_be_walked(self):
        with tempfile.TemporaryDirectory() as folder:
            paths = [os.path.join(folder, f"{i}.exr") for i in (1, 2)]
            for i, path in enumerate(paths):
                small().render(part=(i + 1, 2)).write(path)
            np.testing.assert_array_equal(nicol.merge(path for path in paths).stokes, small().render().stokes)

    def test_devices(self):
        found = nicol.devices()
        with nicol.Context(device=0) as context:
            self.assertEqual(context.device.name, found[0].name)
        self.assertTrue(all(device.compute_units > 0 and device.is_cpu in (True, False) for device in found))


class Callbacks(unittest.TestCase):
    def test_progress_and_tiles(self):
        seen, scene = [], small()
        told = np.full((4, 3, 18 * 24), np.nan, np.float32)

        def tile(tile):
            self.assertEqual((tile.width, tile.height, tile.wavelengths_nm.tolist()), (24, 18, [450, 550, 650]))
            self.assertEqual(tile.linear_srgb.shape, (len(tile.pixels), 3))
            told[:, :, tile.pixels] = tile.stokes

        picture = scene.render(progress=lambda *values: seen.append(values), tile=tile)
        np.testing.assert_array_equal(told.reshape(picture.stokes.shape), picture.stokes)
        fractions = [fraction for fraction, _, _ in seen]
        self.assertEqual(fractions, sorted(fractions))
        self.assertEqual(fractions[-1], 1)

    def test_cancel(self):
        scene, tiles = nicol.load_text(SCENE, **ENDLESS), []
        told = np.full((4, 3, ENDLESS["height"] * ENDLESS["width"]), np.nan, np.float32)

        def tile(tile):
            tiles.append(tile)
            told[:, :, tile.pixels] = tile.stokes

        with self.assertRaises(nicol.Cancelled) as caught:
            scene.render(tile=tile, cancel=lambda: len(tiles) > 4)
        stopped = caught.exception.picture
        self.assertTrue(stopped.report.interrupted)
        whole_rows = stopped.plane("coverage").ravel() == 1
        self.assertGreater(whole_rows.sum(), 0)
        np.testing.assert_array_equal(stopped.stokes.reshape(told.shape)[:, :, whole_rows], told[:, :, whole_rows])
        self.assertRaises(nicol.Cancelled, scene.render, cancel=lambda: True)

    def test_exceptions_come_out(self):
        def fail(*_):
            raise LookupError("of the callback")

        scene = nicol.load_text(SCENE, **ENDLESS)
        for callback in ("progress", "tile", "cancel"):
            with self.subTest(callback=callback), self.assertRaisesRegex(LookupError, "of the callback"):
                scene.render(**{callback: fail})
        self.assertRaisesRegex(LookupError, "of the callback", nicol.load_text, '#include "a.inc"', include=fail)
        context = nicol.Context(log=fail)
        self.assertRaisesRegex(LookupError, "of the callback", context.load_text, '#debug "words"\n' + SCENE)
        self.assertEqual(small().render().stokes.shape, (4, 3, 18, 24))  # and all is well again

    def test_interrupt(self):
        """Ctrl-C, with and without callbacks of one's own."""
        scene = nicol.load_text(SCENE, **ENDLESS)

        def interrupt(begun):
            while not begun():
                time.sleep(0.01)
            os.kill(os.getpid(), signal.SIGINT)

        tiles = []
        threading.Thread(target=interrupt, args=(lambda: tiles,), daemon=True).start()
        self.assertRaises(KeyboardInterrupt, scene.render, tile=tiles.append)
        renders = lambda: signal.getsignal(signal.SIGINT) is not signal.default_int_handler
        threading.Thread(target=interrupt, args=(renders,), daemon=True).start()
        self.assertRaises(KeyboardInterrupt, scene.render)
        self.assertFalse(renders())

    def test_include(self):
        asked = []

        def include(name):
            asked.append(name)
            return "#declare Sky = 0.25;\n" if name == "sky.inc" else None

        picture = small('#include "sky.inc"\n#include "units.inc"\n' + SCENE.replace("0.4", "Sky"), include=include).render()
        self.assertEqual(asked, ["sky.inc", "units.inc"])
        brighter = small().render()
        np.testing.assert_allclose(picture.stokes[0, :, 0, 0] / 0.25, brighter.stokes[0, :, 0, 0] / 0.4, rtol=1e-6)
        with self.assertRaises(nicol.SceneError):
            small('#include "sky.inc"\n', include=lambda name: None)

    def test_log(self):
        told = []
        context = nicol.Context(log=lambda severity, text: told.append((severity, text)))
        scene = context.load_text('#debug "so many words"\n' + SCENE)
        self.assertIn("so many words", "".join(text for _, text in told))
        self.assertEqual(scene.diagnostics, [])

    def test_threads(self):
        """Each thread gets its own picture, and its own exception."""
        answers = {}

        def work(number):
            try:
                if number == 3:
                    small().render(tile=lambda _: 1 / 0)
                answers[number] = small(declares={}).render().stokes.copy()
            except ZeroDivisionError as error:
                answers[number] = error

        threads = [threading.Thread(target=work, args=(number,)) for number in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertIsInstance(answers[3], ZeroDivisionError)
        for number in (1, 2):
            np.testing.assert_array_equal(answers[number], answers[0])


if __name__ == "__main__":
    unittest.main()
