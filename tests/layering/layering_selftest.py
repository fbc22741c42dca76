#!/usr/bin/env python3
"""Proves on trees made for it that layering.py finds what it must and leaves alone what is right."""

import tempfile
import unittest
from pathlib import Path

import layering

RIGHT = {
    "sdl/tree.hpp": "#include <vector>\n",
    "sdl/parse.hpp": '#include "tree.hpp"\n',
    "sdl/diagnostics.hpp": '#include "tree.hpp"\n',
    "kernels/abi.h": "#include <cstdint>\n",
    "kernels/trace.h": '#include "abi.h"\n',
    "host/scene.hpp": '#include "sdl/tree.hpp"\n#include <vector>\n',
    "host/optics/media.hpp": "#include <vector>\n",
    "host/bind/bind.cpp": '#include "sdl/parse.hpp"\n#include "host/optics/media.hpp"\nsdl::Block b;\n',
    "host/solids/planar.cpp": '#include <CGAL/Surface_mesh.h>\n#include "sdl/diagnostics.hpp"\n',
    "host/output/exr_sink.cpp": "#include <ImfHeader.h>\n",
    "host/opencl/device.cpp": '#include <CL/opencl.hpp>\n#include "kernels/abi.h"\n',
    "host/app/main.cpp": '#include <CLI/CLI.hpp>\n#include "sdl/parse.hpp"\n#include "host/bind/bind.hpp"\n',
    "host/bind/bind.hpp": "",
}

WRONG = [
    ("host/solids/solids.cpp", '#include "sdl/parse.hpp"\n'),
    ("host/solids/solids.cpp", "sdl::Block block;\n"),
    ("host/optics/media.cpp", '#include "sdl/parse.hpp"\n'),
    ("host/pack.cpp", "#include <CGAL/Surface_mesh.h>\n"),
    ("host/pack.cpp", "#include <gmpxx.h>\n"),
    ("host/output/png_sink.cpp", "#include <ImfHeader.h>\n"),
    ("host/output/frame.cpp", "#  include <OpenEXR/ImfHeader.h>\n"),
    ("host/output/frame.cpp", "#include <png.h>\n"),
    ("host/output/frame.cpp", "#include <GLFW/glfw3.h>\n"),
    ("host/app/main.cpp", "#include <imgui.h>\n"),
    ("host/app/render.cpp", "#include <CL/opencl.hpp>\n"),
    ("host/opencl/render.cpp", '#include "host/bind/bind.hpp"\n'),
    ("host/optics/media.cpp", '#include "host/scene.hpp"\n'),
    ("sdl/lexer.cpp", '#include "host/scene.hpp"\n'),
    ("sdl/lexer.cpp", '#include "../host/scene.hpp"\n'),
    ("sdl/lexer.cpp", '#include "kernels/abi.h"\n'),
    ("sdl/lexer.cpp", "#include <fmt/format.h>\n"),
    ("sdl/lexer.cpp", "double Wavelength = 0;\n"),
    ("sdl/lexer.cpp", "// polarizers are words too\n"),
    ("kernels/trace.cl", '#include "host/scene.hpp"\n'),
    ("kernels/trace.cl", '#include "../sdl/tree.hpp"\n'),
    ("kernels/trace.cl", "#include <CL/cl.h>\n"),
]


def make_tree(folder, files):
    for path, text in files.items():
        file = Path(folder) / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)


class Layering(unittest.TestCase):
    def check(self, files):
        with tempfile.TemporaryDirectory() as folder:
            make_tree(folder, files)
            return layering.check(Path(folder))

    def test_a_right_tree_passes(self):
        self.assertEqual(self.check(RIGHT), ([], []))

    def test_each_violation_is_found_in_its_line(self):
        for path, line in WRONG:
            with self.subTest(path=path, line=line):
                violations, _ = self.check(
                    {**RIGHT, path: RIGHT.get(path, "") + "// first\n" + line}
                )
                place = RIGHT.get(path, "").count("\n") + 2
                self.assertEqual([v[:2] for v in violations], [(path, place)])

    def test_long_files_are_reported_and_not_refused(self):
        violations, long_files = self.check({**RIGHT, "sdl/lexer.cpp": "//\n" * 301})
        self.assertEqual((violations, long_files), ([], [("sdl/lexer.cpp", 301)]))


if __name__ == "__main__":
    unittest.main()
