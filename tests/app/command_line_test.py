#!/usr/bin/env python3
"""The built program as a user meets it: pictures, messages, exit codes, interruption, no debris.

command_line_test.py NICOL
"""

import os
import pty
import re
import resource
import select
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest
import zlib
from pathlib import Path

NICOL = sys.argv.pop(1) if __name__ == "__main__" else ""
SCENE = str(Path(__file__).resolve().parent / "cube.pov")
PATIENCE_S = 240  # a busy machine builds a kernel in seconds, not minutes


def read_png(path):
    """Width, height and the unfiltered bytes' length; raises if a chunk or the data is damaged."""
    data = Path(path).read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n", "no PNG"
    at, pixels, kinds = 8, b"", []
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at : at + 8])
        body = data[at + 8 : at + 8 + length]
        (crc,) = struct.unpack(">I", data[at + 8 + length : at + 12 + length])
        assert crc == zlib.crc32(kind + body), f"damaged chunk {kind}"
        kinds.append(kind)
        if kind == b"IHDR":
            width, height, depth, colour = struct.unpack(">IIBB", body[:10])
        if kind == b"IDAT":
            pixels += body
        at += 12 + length
    assert kinds[-1] == b"IEND", "PNG without its end"
    channels = {2: 3, 6: 4}[colour]
    raw = zlib.decompress(pixels)
    assert len(raw) == height * (1 + width * channels * depth // 8), "PNG without all its rows"
    return width, height


def exr_header(path):
    result = subprocess.run(["exrheader", str(path)], capture_output=True, text=True, check=True)
    return result.stdout


LIT = "camera { location <0, 0, -60> right x }\nbackground { spectrum { e } }\n"


class CommandLine(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def nicol(self, *arguments, **options):
        options.setdefault("cwd", self.folder)
        return subprocess.run(
            [NICOL, *map(str, arguments)],
            capture_output=True,
            text=True,
            timeout=PATIENCE_S,
            **options,
        )

    def scene(self, text, name="scene.pov"):
        (self.folder / name).write_text(text)
        return name

    # A render that was stopped after its first seconds keeps what is finished in OUTPUT.part.
    def left_in_folder(self):
        return sorted(p.name for p in self.folder.iterdir() if p.suffix != ".part")

    def assert_refused(self, result, *words):
        self.assertEqual(result.returncode, 1, result.stderr)
        for word in words:
            self.assertIn(word, result.stderr)
        self.assertNotIn("terminate called", result.stderr)

    # ---- pictures ----
    def test_two_pictures_of_one_render(self):
        result = self.nicol("render", SCENE, "-o", "a.exr", "-o", "a.png", "-W", 40, "-H", 30)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(self.left_in_folder(), ["a.exr", "a.png"])
        self.assertEqual(read_png(self.folder / "a.png"), (40, 30))
        header = exr_header(self.folder / "a.exr")
        for channel in "S0.450,000000nm", "S3.650,000000nm":
            self.assertIn(channel, header)
        self.assertIn("render " + SCENE, header)

    def test_summary_names_what_a_reader_needs(self):
        result = self.nicol("render", SCENE, "-o", "a.png", "-W", 16, "-H", 16)
        for word in ("16x16", "3 wavelengths", "segments/s", "cut off", "Stokes 0", "clipped"):
            self.assertIn(word, result.stderr)

    def test_no_terminal_no_progress(self):
        result = self.nicol("render", SCENE, "-o", "a.png", "-W", 64, "-H", 64)
        self.assertEqual(result.stdout, "")
        self.assertNotRegex(result.stderr, "[\r\033]")

    def test_quiet_says_nothing(self):
        result = self.nicol("render", SCENE, "-o", "a.png", "-W", 16, "-H", 16, "--quiet")
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", ""))

    def test_without_output_the_picture_has_the_scenes_name(self):
        self.nicol("render", SCENE, "-W", 16, "-H", 16)
        self.assertEqual(self.left_in_folder(), ["cube.png"])

    def test_error_budget(self):
        result = self.nicol("render", SCENE, "-W", 48, "-H", 48, "-o", "a.exr")
        self.assertEqual(result.returncode, 0, result.stderr)
        for source in "cut-off", "spectral step", "sampling", "rounding", "solids", "counted":
            self.assertRegex(result.stderr, rf"(?m)^  {source} +[0-9.e-]+ +[0-9.]+ s  \S")
            self.assertIn(f"nicol:error.{source}".replace(" ", "_"), exr_header(self.folder / "a.exr"))
        self.assertRegex(result.stderr, r"(?m)^  together +[0-9.e-]+$")
        quick = self.nicol("render", SCENE, "-W", 48, "-H", 48, "-o", "b.exr", "--no-budget")
        self.assertNotIn("together", quick.stderr)

    def test_the_sampling_line_says_what_was_done(self):
        for more, words in (
            ([], "1 sample a pixel against 9, on"),
            (["--error-map", "map.exr"], "1 sample a pixel: from each pixel's spread and its neighbours"),
            (["--samples", 4], "4 samples a pixel: half the difference of their halves"),
            (["--samples", 1000], "1000 samples a pixel: half the difference of their halves"),
        ):
            with self.subTest(words=words):
                result = self.nicol("render", SCENE, "-W", 24, "-H", 18, "-o", "a.exr", *more)
                self.assertIn(words, result.stderr)
                self.assertIn(f" nm, {words.split(' a pixel')[0]} a pixel\n", result.stderr)

    def test_options_that_make_no_sense_are_named(self):
        for wavelengths in "-3", "1e9", "-400:500:10", "400,2e6":
            self.assert_refused(self.nicol("render", SCENE, f"--wavelengths={wavelengths}", "-o", "a.exr"), wavelengths, "1 and 1000000 nm")
        for word in "box", "x", "if":
            self.assert_refused(self.nicol("render", SCENE, "--declare", f"{word}=3", "-o", "a.exr"), f"'{word}' is a word of the language")
        for word in "size", "height", "rotation":  # which scenes declare, too
            self.assertEqual(self.nicol("check", SCENE, "--declare", f"{word}=3").returncode, 0)
        self.assertEqual(self.left_in_folder(), [])

    def test_a_kernel_that_does_not_build_leaves_nothing_to_go_on_from(self):
        kernels = self.folder / "kernels"
        shutil.copytree(Path(__file__).resolve().parents[2] / "kernels", kernels)
        with (kernels / "trace.cl").open("a") as trace:
            trace.write("this is no OpenCL C;\n")
        result = self.nicol("render", SCENE, "-W", 16, "-H", 16, "-o", "a.exr", env={**os.environ, "NICOL_KERNEL_DIR": str(kernels)})
        self.assert_refused(result, "trace")
        self.assertNotIn("--continue", result.stderr)
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["kernels"])

    def test_error_that_is_kept(self):
        result = self.nicol("render", SCENE, "-W", 48, "-H", 48, "-o", "a.exr", "--error", "2%", "--error-map", "map.exr")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertRegex(result.stderr, r"error 2 %: kept with adc_bailout \S+, max_trace_level \d+, \d+ wavelengths, float")
        header = exr_header(self.folder / "map.exr")
        for channel in "cutoff", "sampling", "rounding", "total":
            self.assertIn(f"error.{channel}", header)
        self.assertIn("nicol:chosen", exr_header(self.folder / "a.exr"))
        self.assert_refused(self.nicol("render", SCENE, "-o", "a.exr", "--error", "120%"), "120%", "0.1%")

    def test_wavelengths_from_the_command_line(self):
        result = self.nicol(
            "render", SCENE, "-o", "a.exr", "-W", 8, "-H", 8, "--wavelengths", "500:520:10"
        )
        self.assertEqual(result.returncode, 0, result.stderr)
        names = set(re.findall(r"S0\.[0-9,]+nm", exr_header(self.folder / "a.exr")))
        self.assertEqual(names, {"S0.500,000000nm", "S0.510,000000nm", "S0.520,000000nm"})
        for wrong in "700:400:10", "400:700:0", "400:700", "400:700:x", "550,550", "0:1e9:1e-3":
            self.assert_refused(
                self.nicol("render", SCENE, "-o", "b.exr", "--wavelengths", wrong), wrong
            )

    def test_povray_switches(self):
        result = self.nicol(
            "render", f"+I{SCENE}", "+Oa.png", "+W24", "+H18", "+A0.3", "Declare=Sky=0.2"
        )
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(read_png(self.folder / "a.png"), (24, 18))
        self.assertIn("+A0.3", result.stderr)
        self.assert_refused(self.nicol("render", f"+I{SCENE}", "+SF1", "+Ob.png"), "+KFF")
        self.assert_refused(self.nicol("render", f"+I{SCENE}", "+KX1", "+Ob.png"), "+KX1")

    def test_declare_reaches_the_scene(self):
        def header(sky, name):
            self.nicol("render", SCENE, "-o", name, "-W", 1, "-H", 1, "--declare", f"Sky={sky}")
            return (self.folder / name).read_bytes()

        self.assertNotEqual(header(0.2, "a.png"), header(0.9, "b.png"))
        self.assert_refused(
            self.nicol("render", SCENE, "-o", "c.png", "--declare", "Sky"), "name=value"
        )

    # ---- what cannot be done ----
    def test_unknown_suffix_before_anything_else(self):
        for name in "a.jpg", "picture":
            self.assert_refused(self.nicol("render", "no_such_scene.pov", "-o", name), name, ".exr")
        self.assertEqual(self.left_in_folder(), [])

    def test_target_that_cannot_be(self):
        (self.folder / "folder.png").mkdir()
        for target in "missing/a.png", "folder.png", "/proc/a.exr", "/dev/null/a.png":
            self.assert_refused(self.nicol("render", SCENE, "-o", target), target)
        self.assertEqual(self.left_in_folder(), ["folder.png"])

    def test_missing_scene(self):
        for verb in (["render", "-o", "a.png"], ["check"], ["explain"], ["expect"]):
            self.assert_refused(self.nicol(verb[0], "nowhere.pov", *verb[1:]), "nowhere.pov")
        self.assertEqual(self.left_in_folder(), [])

    def test_bad_scene_tells_all_errors_and_keeps_the_old_picture(self):
        bad = self.scene(
            "camera { location <0, 0, -5> lok_at 0 }\n"
            "sphear { 0, 1 }\n"
            "box { 0, 1 interior { ior } }\n"
        )
        (self.folder / "a.png").write_text("old")
        for verb in (["render", "-o", "a.png"], ["check"], ["explain", "--no-build"], ["expect"]):
            result = self.nicol(verb[0], bad, *verb[1:])
            self.assert_refused(result, "line 1", "line 2", "line 3", "lok_at", "look_at", "sphear")
        self.assertEqual((self.folder / "a.png").read_text(), "old")
        self.assertEqual(self.left_in_folder(), ["a.png", "scene.pov"])

    def test_check(self):
        result = self.nicol("check", SCENE, self.scene("sphear { }"))
        self.assertEqual(result.returncode, 1)
        self.assertIn("cube.pov: right", result.stdout)
        self.assertIn("scene.pov: wrong", result.stdout)
        self.assertEqual(self.nicol("check", SCENE).returncode, 0)

    def test_includes_beside_the_scene_come_before_the_standard_ones(self):
        (self.folder / "own").mkdir()
        self.scene("#debug \"its own\\n\"\n", "own/units.inc")
        self.scene("#include \"units.inc\"\n" + LIT + "sphere { 0, 1 interior { ior 1.5 } }", "own/scene.pov")
        self.assertIn("its own", self.nicol("check", "own/scene.pov").stderr)
        self.scene("#debug \"of the working folder\\n\"\n", "units.inc")
        self.assertIn("of the working folder", self.nicol("check", "own/scene.pov").stderr)

    def test_polarizers_inside_crystals_are_refused_with_their_place(self):
        crystal = "box { -4, 4 interior { ordinary { constant 1.65 } extraordinary { constant 1.48 } } }\n"
        result = self.nicol("check", self.scene(LIT + crystal + "disc { 0, z, 1 polarizer { ideal angle 0 } }"))
        self.assertEqual(result.returncode, 1)
        self.assertIn("polarizes inside the crystal", result.stderr)

    def test_file_size_limit(self):
        limit = (4096, 4096)
        self.nicol("render", SCENE, "-o", "a.exr", "-W", 64, "-H", 64)
        (self.folder / "a.exr").unlink()
        result = self.nicol(
            "render",
            SCENE,
            "-o",
            "a.exr",
            "-W",
            64,
            "-H",
            64,
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, limit),
        )
        self.assert_refused(result, "cannot write a.exr", "File too large")
        self.assertEqual(self.left_in_folder(), [])

    @unittest.skipUnless(
        os.geteuid() == 0, "only root may mount; test_file_size_limit stands for it"
    )
    def test_full_disk(self):
        disk = self.folder / "disk"
        disk.mkdir()
        mount = subprocess.run(
            ["mount", "-t", "tmpfs", "-o", "size=16k", "nicol-test", disk], capture_output=True
        )
        if mount.returncode != 0:
            self.skipTest("this root may not mount; test_file_size_limit stands for it")
        try:
            result = self.nicol(
                "render", SCENE, "-o", disk / "a.exr", "-o", "b.png", "-W", 64, "-H", 64
            )
            self.assert_refused(result, "a.exr", "No space left on device")
            self.assertEqual(list(disk.iterdir()), [])
            self.assertEqual(read_png(self.folder / "b.png"), (64, 64))
        finally:
            subprocess.run(["umount", disk], check=True)

    def test_picture_larger_than_the_machine(self):
        result = self.nicol("render", SCENE, "-o", "a.png", "-W", 65536, "-H", 65536)
        self.assert_refused(result, "65536x65536", "GB")

    def test_command_line_errors(self):
        self.assert_refused(self.nicol(), "--help")
        self.assert_refused(self.nicol("rendr", SCENE), "rendr", "did you mean 'render'")
        self.assert_refused(self.nicol("render", SCENE, "-o", "a.png", "--width", "0"), "width")
        self.assert_refused(self.nicol("render", SCENE, "-o", "a.png", "--real", "half"), "half")
        self.assertEqual(self.nicol("--help").returncode, 0)
        self.assertRegex(self.nicol("--version").stdout, r"^nicol \d+\.\d+\.\d+\n$")

    # ---- devices ----
    def test_unknown_device(self):
        self.assert_refused(
            self.nicol("render", SCENE, "-o", "a.png", "--device", "abacus"), "abacus", "0:"
        )
        self.assertEqual(self.left_in_folder(), [])

    def test_no_device_at_all(self):
        (self.folder / "vendors").mkdir()
        environment = {**os.environ, "OCL_ICD_VENDORS": str(self.folder / "vendors")}
        for arguments in (
            ["render", SCENE, "-o", "a.png"],
            ["devices"],
            ["explain", SCENE],
            ["probe"],
        ):
            result = self.nicol(*arguments, env=environment, stdin=subprocess.DEVNULL)
            self.assert_refused(result, "no OpenCL device", "pocl-opencl-icd")
        self.assertEqual(self.nicol("check", SCENE, env=environment).returncode, 0)
        self.assertEqual(self.left_in_folder(), ["vendors"])

    def test_devices_marks_the_one_in_use(self):
        result = self.nicol("devices")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(len(re.findall(r"(?m)^\* \d", result.stdout)), 1)

    # ---- other verbs ----
    def test_expect(self):
        result = self.nicol("expect", SCENE)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        self.assertEqual(result.stdout.count("2 of 2 hold"), 2)
        wrong = self.scene(
            Path(SCENE)
            .read_text()
            .replace("relative_radiance 550, 0.4", "relative_radiance 550, 0.41")
        )
        result = self.nicol("expect", wrong)
        self.assertEqual(result.returncode, 1)
        self.assertIn("FAIL  scene.pov:11", result.stdout)
        self.assertIn("1 of 2 hold", result.stdout)

    def test_expect_of_a_wavelength_that_is_not_traced(self):
        wrong = self.scene(
            Path(SCENE).read_text().replace("relative_radiance 550", "relative_radiance 551")
        )
        result = self.nicol("expect", wrong)
        self.assert_refused(result, "line 11", "551 nm is not among")
        self.assert_refused(
            self.nicol("expect", SCENE, "--wavelengths", "450,650"), "550 nm is not among"
        )

    def test_explain_media(self):
        result = self.nicol("explain", "--media")
        self.assertEqual(result.returncode, 0, result.stderr)
        rows = {row.split()[0]: row for row in result.stdout.splitlines()}
        self.assertIn("uniaxial +, active", rows["M_Quartz_Right"])
        self.assertIn("21.7", rows["M_Quartz_Right"])
        self.assertIn("biaxial -", rows["M_Aragonite"])
        columns = {row.index("iaxial") for row in rows.values() if "iaxial" in row}
        self.assertLessEqual(len(columns), 2, "columns are not aligned")  # uniaxial and biaxial

    def test_explain_media_of_a_scene(self):
        scene = self.scene(
            "background { rgb 1 } #declare M = interior { ordinary { constant 1.5 }"
            ' extraordinary { constant 1.6 } name "crystal" }\n'
            "box { 0, 1 interior { M } } box { 2, 3 interior { M } rotate 90*x }"
        )
        result = self.nicol("explain", "--media", scene, "--lambda", 500)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("n at 500 nm", result.stdout)
        self.assertEqual(result.stdout.count("crystal"), 1)
        self.assertIn("1.5000 1.6000", result.stdout)
        self.assert_refused(self.nicol("explain", "--media", "missing.inc"), "missing.inc")
        self.assert_refused(self.nicol("explain"), "takes a scene")

    def test_explain(self):
        result = self.nicol("explain", SCENE, "--no-build")
        self.assertEqual(result.returncode, 0, result.stderr)
        called_for, left_out = result.stdout.split("left out:")
        self.assertIn("luminous_sheets", called_for)
        self.assertIn("calcite_polarizer", left_out)
        self.assertNotIn("kernel", left_out.split("\n")[-2])

    def test_probe_refuses_what_is_no_json(self):
        self.assert_refused(self.nicol("probe", input="{ not json"), "nicol: ")

    # ---- interruption ----
    def start_long_render(self, *options):
        """A render on a terminal of its own, past its first rows: process and terminal."""
        terminal, slave = pty.openpty()
        process = subprocess.Popen(
            [
                NICOL,
                "render",
                SCENE,
                "-o",
                "a.exr",
                "-o",
                "a.png",
                "-W",
                "700",
                "-H",
                "700",
                "--samples",
                "256",
                *options,
            ],
            cwd=self.folder,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=slave,
        )
        os.close(slave)
        self.addCleanup(os.close, terminal)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        seen, give_up = b"", time.monotonic() + PATIENCE_S
        while not re.search(rb" [1-9] %", seen):
            self.assertLess(time.monotonic(), give_up, seen)
            self.assertIsNone(process.poll(), seen)
            if select.select([terminal], [], [], 1)[0]:
                seen += os.read(terminal, 4096)
        return process, terminal

    def finish(self, process, terminal):
        """Reads the terminal until the process is gone, so that it never blocks on it."""
        said = b""
        while True:
            try:
                part = os.read(terminal, 4096)
            except OSError:  # the other side is closed
                break
            if not part:
                break
            said += part
        return process.wait(timeout=PATIENCE_S), said.decode()

    def test_interrupt_saves_what_is_done(self):
        process, terminal = self.start_long_render()
        process.send_signal(signal.SIGINT)
        code, said = self.finish(process, terminal)
        self.assertEqual(code, 2, said)
        self.assertRegex(said, r"\d+ of 700 rows")
        self.assertEqual(self.left_in_folder(), ["a.exr", "a.png"])
        self.assertEqual(read_png(self.folder / "a.png"), (700, 700))
        self.assertIn("nicol:partial", exr_header(self.folder / "a.exr"))

    def test_what_an_interrupt_saved_is_no_whole_picture(self):
        for suffix in ("exr", "png"):
            process, terminal = self.start_long_render("--keep-after", "1e9")
            process.send_signal(signal.SIGINT)
            self.finish(process, terminal)
            (self.folder / f"a.{suffix}").unlink()
            process, terminal = self.start_long_render("--keep-after", "1e9", "--continue")
            process.send_signal(signal.SIGINT)
            code, said = self.finish(process, terminal)
            self.assertEqual(code, 2, said)

    def test_an_interrupt_before_the_first_tile_quits_at_once(self):
        self.scene('{ "name": "endless", "version": "1", "nicol": 1, "kind": "element", "meaning": "never ends" }', "endless.json")
        self.scene("FUNCTION void endless(PRIVATE const ElementIn* in, GLOBAL const scalar* parameter, PRIVATE ElementOut* out) {\n"
                   "  volatile int on = 1;\n  while (on) out->t.ss = real_number(lanes(1));\n}\n", "endless.cl")
        scene = self.scene(LIT + "disc { 0, z, 1 polarizer { plugin { \"endless\" } angle 0 } }")
        process = subprocess.Popen([NICOL, "render", scene, "-o", "a.exr"], cwd=self.folder, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.kill)
        deadline = time.monotonic() + PATIENCE_S
        while self.seconds_worked(process) < 3 and time.monotonic() < deadline:
            time.sleep(0.05)
        self.assertIsNone(process.poll())
        process.send_signal(signal.SIGTERM)
        _, told = process.communicate(timeout=PATIENCE_S)
        self.assertEqual(process.returncode, 2, told)
        self.assertIn("interrupted", told)

    def seconds_worked(self, process):
        """Time of processors; a kernel has been built by then, and its endless loop entered."""
        fields = Path(f"/proc/{process.pid}/stat").read_text().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def test_second_interrupt_quits_at_once(self):
        process, terminal = self.start_long_render()
        process.send_signal(signal.SIGINT)
        process.send_signal(signal.SIGTERM)  # another signal, lest the two become one
        code, said = self.finish(process, terminal)
        self.assertEqual(code, 2, said)
        self.assertEqual(self.left_in_folder(), [])


if __name__ == "__main__":
    unittest.main()
