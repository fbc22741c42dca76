#!/usr/bin/env python3
"""The set-up script `nicol` with stand-ins for the system's tools.

setup_script_test.py SCRIPT
"""

import os
import shutil
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

SCRIPT = sys.argv.pop(1) if __name__ == "__main__" else ""

# Each stand-in notes its call; $FAIL_<NAME> makes it fail. cmake "builds" a program that tells its
# arguments, with a window if $WINDOW is ON.
STAND_INS = {
    "dpkg-query": 'for p; do case $p in -*) ;; *) case " $LACKING " in *" $p "*) ;; *) '
    'printf "installed=%s " "$p";; esac;; esac; done',
    "id": 'echo "${USER_ID:-0}"',
    "sudo": '[ -z "${FAIL_SUDO:-}" ] || exit 1; shift; exec "$@"',
    "apt-get": 'echo "apt-get $*" >>"$CALLS"; echo "E: no route to $1"; [ -z "${FAIL_APT:-}" ]',
    "cmake": 'echo "cmake $*" >>"$CALLS"; echo "configuring or building"; [ -z "${FAIL_CMAKE:-}" ] || exit 1\n'
    'mkdir -p "$NICOL_BUILD/bin"; for name in nicol nicol_bench; do\n'
    'printf \'#!/bin/sh\\necho "%s got $*"\\nexit 7\\n\' "$name" >"$NICOL_BUILD/bin/$name"\n'
    'chmod +x "$NICOL_BUILD/bin/$name"; done\n'
    'echo "NICOL_WINDOW:INTERNAL=${WINDOW:-OFF}" >"$NICOL_BUILD/CMakeCache.txt"',
    "ctest": 'echo "ctest $*"; exit 5',
}


class SetupScript(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="with space ")
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name) / "checkout"
        for name in "sdl/a.cpp", "kernels/a.h", "host/a.cpp", "CMakeLists.txt", "CMakePresets.json":
            file = self.root / name
            file.parent.mkdir(parents=True, exist_ok=True)
            file.touch()
        shutil.copy(SCRIPT, self.root / "nicol")
        tools = Path(folder.name) / "tools"
        tools.mkdir()
        for name, text in STAND_INS.items():
            (tools / name).write_text("#!/bin/sh\n" + text + "\n")
            (tools / name).chmod(0o755)
        self.calls = Path(folder.name) / "calls"
        self.environment = {
            **os.environ,
            "PATH": f"{tools}:{os.environ['PATH']}",
            "CALLS": str(self.calls),
            "NICOL_BUILD": str(self.root / "build/release"),
            "LACKING": "",
        }

    def nicol(self, *arguments, **environment):
        return subprocess.run(
            [self.root / "nicol", *arguments],
            capture_output=True,
            text=True,
            timeout=60,
            stdin=subprocess.DEVNULL,
            env={**self.environment, **environment},
        )

    def take_calls(self):
        text = self.calls.read_text() if self.calls.exists() else ""
        self.calls.unlink(missing_ok=True)
        return text

    def test_builds_once_and_hands_over(self):
        result = self.nicol("render", "a b.pov", "-o", "x.exr")
        self.assertEqual(
            (result.returncode, result.stdout),
            (7, "nicol got render a b.pov -o x.exr\n"),
            result.stderr,
        )
        calls = self.take_calls()
        self.assertIn("-DNICOL_TESTS=OFF", calls)
        self.assertIn("--target nicol\n", calls)
        self.assertNotIn("apt-get", calls)

        result = self.nicol("devices")
        self.assertEqual(
            (result.returncode, result.stdout, result.stderr), (7, "nicol got devices\n", "")
        )
        self.assertEqual(self.take_calls(), "")

    def test_builds_again_when_a_source_is_newer(self):
        self.nicol("devices")
        for name in "host/a.cpp", "kernels/a.h", "sdl/new.cpp", "CMakeLists.txt":
            self.take_calls()
            soon = time.time() + 5
            (self.root / name).touch()
            os.utime(self.root / name, (soon, soon))
            self.nicol("devices")
            self.assertIn("--build", self.take_calls(), name)
            os.utime(self.root / name, (0, 0))
            os.utime(self.root / "sdl", (0, 0))

    def test_installs_only_what_lacks(self):
        result = self.nicol("devices", LACKING="libpng-dev pocl-opencl-icd doctest-dev")
        self.assertEqual(result.returncode, 7, result.stderr)
        line = self.take_calls().splitlines()[0]
        self.assertRegex(
            line, r"^apt-get install -y --no-install-recommends .*libpng-dev pocl-opencl-icd\s*$"
        )
        self.assertIn("libpng-dev pocl-opencl-icd", result.stderr)

    def test_tests_and_bench_need_more(self):
        result = self.nicol("test", "-R", "sdl", LACKING="doctest-dev")
        self.assertEqual(result.returncode, 5, result.stderr)
        self.assertRegex(result.stdout, r"^ctest .*--output-on-failure.* -R sdl\n$")
        calls = self.take_calls()
        self.assertRegex(calls, r"apt-get install .*doctest-dev")
        self.assertIn("-DNICOL_TESTS=ON", calls)
        self.assertIn("--target all", calls)
        self.assertEqual(self.nicol("bench", "--quick").stdout, "nicol_bench got --quick\n")

    def test_only_the_preview_needs_its_window(self):
        lacking = "libglfw3-dev libegl1"
        self.assertEqual(self.nicol("render", "a.pov", LACKING=lacking).returncode, 7)
        self.assertNotIn("apt-get", self.take_calls())

        result = self.nicol("preview", "a.pov", LACKING=lacking, WINDOW="ON")
        self.assertEqual((result.returncode, result.stdout), (7, "nicol got preview a.pov\n"), result.stderr)
        calls = self.take_calls()
        self.assertRegex(calls, r"^apt-get install .*libglfw3-dev libegl1\s")
        self.assertIn("--target nicol\n", calls)

        for verb in "preview", "render":
            self.assertEqual(self.nicol(verb, "a.pov").returncode, 7)
            self.assertEqual(self.take_calls(), "", verb)

    def test_preview_without_the_right_to_install(self):
        self.nicol("render", "a.pov")
        self.take_calls()
        result = self.nicol("preview", "a.pov", LACKING="libglfw3-dev", USER_ID="1000", FAIL_SUDO="1")
        self.assertEqual(result.returncode, 1)
        self.assertIn("apt-get install --no-install-recommends libglfw3-dev", result.stderr)
        self.assertEqual(self.take_calls(), "")

    def test_no_right_to_install(self):
        result = self.nicol("devices", LACKING="libpng-dev", USER_ID="1000", FAIL_SUDO="1")
        self.assertEqual(result.returncode, 1)
        self.assertIn("apt-get install --no-install-recommends libpng-dev", result.stderr)
        self.assertEqual(self.take_calls(), "")

    def test_sudo_that_asks_for_nothing_is_used(self):
        result = self.nicol("devices", LACKING="libpng-dev", USER_ID="1000")
        self.assertEqual(result.returncode, 7, result.stderr)
        self.assertIn("libpng-dev", self.take_calls())

    def test_no_network(self):
        result = self.nicol("devices", LACKING="libpng-dev", FAIL_APT="1")
        self.assertEqual(result.returncode, 1)
        self.assertIn("network", result.stderr)
        self.assertIn("| E: no route to", result.stderr)
        self.assertNotIn("cmake", self.take_calls())

    def test_failed_build_is_told_and_tried_again(self):
        for _ in range(2):
            result = self.nicol("devices", FAIL_CMAKE="1")
            self.assertEqual((result.returncode, result.stdout), (1, ""))
            self.assertIn("| configuring or building", result.stderr)
            self.assertIn("setup.log", result.stderr)
            self.assertIn("cmake", self.take_calls())
        self.assertEqual(self.nicol("devices").returncode, 7)

    def test_called_from_elsewhere_and_through_a_link(self):
        link = self.root.parent / "link"
        link.symlink_to(self.root / "nicol")
        result = subprocess.run(
            [link, "devices"], capture_output=True, text=True, cwd="/", env=self.environment
        )
        self.assertEqual(result.stdout, "nicol got devices\n", result.stderr)


if __name__ == "__main__":
    unittest.main()
