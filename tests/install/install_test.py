#!/usr/bin/env python3
"""What `cmake --install` leaves, moved elsewhere: the files, the program, and what others build on it with CMake, pkg-config, Python.

install_test.py CMAKE BUILD_FOLDER PKG_CONFIG CC CXX; the Python that runs it has numpy. Programs run with an empty environment but
for PATH, in which PoCL looks for the linker, and HOME, where kernels are kept.
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

if __name__ == "__main__":
    CMAKE, BUILD, PKG_CONFIG, CC, CXX = sys.argv[1:6]
    del sys.argv[1:6]
STRANGER = Path(__file__).resolve().parent / "stranger"
CUBE = Path(__file__).resolve().parents[1] / "app" / "cube.pov"
EMPTY = {"PATH": "/usr/bin:/bin", **{name: os.environ[name] for name in ("HOME",) if name in os.environ}}
LIB = r"lib(64|/[a-z0-9_]+-linux-gnu)?"
# Each must be there, and nothing else.
FILES = [
    r"bin/nicol", LIB + r"/libnicol\.so", LIB + r"/libnicol\.so\.\d+", LIB + r"/libnicol\.so\.\d+\.\d+\.\d+\.\d+",
    r"include/nicol\.h", r"include/nicol\.hpp", r"include/nicol_plugin\.h", LIB + r"/cmake/nicol/nicolConfig\.cmake",
    LIB + r"/cmake/nicol/nicolConfigVersion\.cmake", LIB + r"/pkgconfig/nicol\.pc", r"lib/python3/dist-packages/nicol\.py",
    r"share/nicol/array\.sbatch", r"share/nicol/include/\w+\.inc", 
    r"share/nicol/plugins/(\w+)/\w+\.(cl|json|cpp|gon|md|png|pov|txt)", r"share/nicol/fragments/\w+\.(h|hpp|md)",
    LIB + r"/nicol/plugins/\w+\.so"]
OPTIONAL = {LIB + r"/nicol/plugins/\w+\.so"}
SOURCES = {"units.inc", "minerals.inc", "closed_forms.inc", "cuts.inc", "illuminants.inc", "fragment.h", "modes.h", "vec3.h", "portable.h",
           "manifest.hpp", "wire_grid.cl", "wire_grid.json", "thin_film.cl", "goniometer.cpp", "temperature_sellmeier.cpp", "quartz.gon"}
BUDGET = {"cut-off", "sampling", "spectral step", "rounding"}


def run(*command, **more):
    result = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False, **more)
    if result.returncode != 0:
        raise AssertionError(f"{' '.join(map(str, command))}: exit code {result.returncode}\n{result.stdout}{result.stderr}")
    return result.stdout


class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name).resolve()
        first, cls.prefix = cls.folder / "first", cls.folder / "with a space" / "moved"
        run(CMAKE, "--install", BUILD, "--prefix", first)
        cls.prefix.parent.mkdir()
        shutil.move(first, cls.prefix)
        cls.lib = next(cls.prefix.glob("lib*/**/libnicol.so")).parent

    def check_pictures(self, name, told):
        """A picture of 32 x 24 pixels in both formats, and the lines of a budget."""
        self.assertEqual((self.folder / f"{name}.exr").read_bytes()[:4], b"\x76\x2f\x31\x01")
        png = (self.folder / f"{name}.png").read_bytes()
        self.assertEqual((png[:8], png[16:24]), (b"\x89PNG\r\n\x1a\n", bytes([0, 0, 0, 32, 0, 0, 0, 24])))
        lines = dict(re.findall(r"^(.+) (\S+)$", told, re.MULTILINE))
        self.assertGreaterEqual(set(lines), BUDGET)
        self.assertLess(float(lines["cut-off"]), 1e-2)

    def test_files(self):
        found = sorted(str(file.relative_to(self.prefix)) for file in self.prefix.rglob("*") if not file.is_dir())
        for file in found:
            self.assertTrue(any(re.fullmatch(pattern, file) for pattern in FILES), f"{file} is not to be installed")
        for pattern in FILES:
            if pattern not in OPTIONAL:
                self.assertTrue(any(re.fullmatch(pattern, file) for file in found), f"nothing is installed as {pattern}")
        self.assertGreaterEqual({Path(file).name for file in found}, SOURCES)
        for file in self.prefix.rglob("*"):
            if file.suffix in (".cmake", ".pc"):
                self.assertNotIn(str(self.folder / "first"), file.read_text())

    def test_program(self):
        """With the include files of its prefix, not those of the source tree."""
        (self.prefix / "share" / "nicol" / "include" / "only_here.inc").write_text("#declare Edge = 4;\n")
        self.addCleanup((self.prefix / "share" / "nicol" / "include" / "only_here.inc").unlink)
        scene = self.folder / "scene.pov"
        scene.write_text('#include "only_here.inc"\n' + CUBE.read_text().split("expect")[0].replace("<4, 6, 4>", "<Edge, 6, Edge>"))
        run(self.prefix / "bin" / "nicol", "render", scene, "-W", 32, "-H", 24, "-o", self.folder / "program.png", env=EMPTY)
        self.assertGreater((self.folder / "program.png").stat().st_size, 100)

    def test_cmake(self):
        build = self.folder / "stranger"
        run(CMAKE, "-S", STRANGER, "-B", build, f"-DCMAKE_PREFIX_PATH={self.prefix}", f"-DCMAKE_C_COMPILER={CC}",
            f"-DCMAKE_CXX_COMPILER={CXX}")
        run(CMAKE, "--build", build)
        needs = run("objdump", "-p", build / "in_c")
        self.assertEqual(set(re.findall(r"NEEDED +(\S+)", needs)), {"libnicol.so.1", "libc.so.6"})
        for name in ("in_c", "in_cpp"):
            self.check_pictures(name, run(build / name, self.folder / name, env=EMPTY))

    def test_pkg_config(self):
        environment = {**EMPTY, "PKG_CONFIG_PATH": str(self.lib / "pkgconfig")}
        self.assertEqual(run(PKG_CONFIG, "--modversion", "nicol", env=environment).strip(), "0.1.0")
        for compiler, standard, source in ((CC, "c99", "render.c"), (CXX, "c++17", "render.cpp")):
            with self.subTest(source=source):
                name = f"pkg_{standard}"
                run("sh", "-c", f'eval "$0 -std={standard} $1 -o $2 $({PKG_CONFIG} --cflags --libs nicol)"', compiler, STRANGER / source,
                    self.folder / f"{name}.bin", env=environment)
                self.check_pictures(name, run(self.folder / f"{name}.bin", self.folder / name, env=EMPTY))

    def test_plugins(self):
        """A shared object of somebody else, put where nicol's own lie, and the fragments that come with nicol."""
        own = self.lib / "nicol" / "plugins" / "flat.so"
        own.parent.mkdir(parents=True, exist_ok=True)
        self.addCleanup(own.unlink, missing_ok=True)
        run(CC, "-std=c99", "-shared", "-fPIC", f"-I{self.prefix / 'include'}", STRANGER / "plugin.c", "-o", own)
        scene = self.folder / "plugins.pov"
        scene.write_text("""camera { location -4*z look_at 0 right x*image_width/image_height polarizer { plugin { "wire_grid" } angle 0 } }
background { spectrum { plugin { "flat" } } }
box { -1, 1 interior { ior 1.5 } }
""")
        run(self.prefix / "bin" / "nicol", "check", scene, env=EMPTY)
        elsewhere = shutil.move(own, self.folder / "flat.so")
        program = f"import nicol; c = nicol.Context(); c.load_plugin({str(elsewhere)!r}); c.load({str(scene)!r})"
        run(sys.executable, "-B", "-c", program, env={**EMPTY, "PYTHONPATH": str(self.prefix / "lib" / "python3" / "dist-packages")})

    def test_how_to_write_a_plugin(self):
        """The example builds as its how-to says, every file that a how-to names is there, and `nicol plugins` lists both."""
        shared = self.prefix / "share" / "nicol"
        how_tos = sorted(shared.glob("plugins/*/README.md"))
        self.assertEqual([file.parent.name for file in how_tos], ["goniometer", "temperature_sellmeier", "wire_grid"])
        for how_to in how_tos:
            for target in re.findall(r"\]\(([^)#:]+)\)", how_to.read_text(encoding="utf-8")):
                self.assertTrue((how_to.parent / target).exists(), f"{how_to} names {target}")
        build = self.folder / "example"
        run(CMAKE, "-S", shared / "plugins" / "temperature_sellmeier", "-B", build, f"-DCMAKE_PREFIX_PATH={self.prefix}",
            f"-DCMAKE_CXX_COMPILER={CXX}")
        run(CMAKE, "--build", build)
        listed = run(self.prefix / "bin" / "nicol", "plugins", "--plugin", build / "temperature_sellmeier.so", env=EMPTY)
        for words in (str(build / "temperature_sellmeier.so"), str(shared / "plugins" / "wire_grid" / "wire_grid.json")):
            self.assertIn(words, listed)

    def test_python(self):
        program = "\n".join([
            "import nicol, sys", f"picture = nicol.load({str(CUBE)!r}, width=32, height=24).render(error_budget=True)",
            "picture.write(sys.argv[1] + '.exr')", "picture.write(sys.argv[1] + '.png')",
            "for line in picture.budget.lines: print(line.source, line.rms)", "assert picture.stokes.shape == (4, 3, 24, 32)"])
        folder = self.prefix / "lib" / "python3" / "dist-packages"
        self.check_pictures("python", run(sys.executable, "-B", "-c", program, self.folder / "python", env={**EMPTY, "PYTHONPATH": str(folder)}))
        # by the library beside it, and by no other
        maps = run(sys.executable, "-B", "-c", "import nicol; print(open('/proc/self/maps').read())", env={**EMPTY, "PYTHONPATH": str(folder)})
        self.assertEqual({line.split(maxsplit=5)[5] for line in maps.splitlines() if "libnicol" in line},
                         {str(self.lib.resolve() / next(self.lib.glob("libnicol.so.*.*.*.*")).name)})


if __name__ == "__main__":
    unittest.main()
