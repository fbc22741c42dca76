#!/usr/bin/env python3
"""Who may include what, held over the #include lines of the tree.

layering.py ROOT        prints each violation as file:line: reason; exit code 1 if there is one.
                        Files over the soft limit of lines are reported, not refused.
"""

import re
import sys
from pathlib import Path

SUFFIXES = {".cpp", ".hpp", ".h", ".cl", ".inc", ".def"}
SOFT_LIMIT_LINES = 300

# A library's headers, and the files that may include them.
LIBRARIES = [
    ("CGAL or GMP", r"(CGAL/|gmp|mpfr)", ["host/solids/"]),
    ("OpenEXR", r"(OpenEXR/|Imath/|Imf|Imath|Iex|half\.h)", ["host/output/exr_sink.cpp", "host/output/exr_source.cpp", "host/output/exr_threads.hpp"]),
    ("zlib", r"zlib\.h", ["host/output/journal.cpp"]),
    ("libpng", r"(libpng\d*/|png\.h)", ["host/output/png_sink.cpp", "host/output/png_source.cpp"]),
    ("a window library", r"(GLFW/|imgui|epoxy/|GL/|EGL/)", ["host/window/"]),
    ("OpenCL", r"(CL/|OpenCL/)", ["host/opencl/"]),
    ("CLI11", r"CLI/", ["host/app/main.cpp"]),
    ("MPI", r"mpi\.h", ["host/mpi/"]),
]

# What the parser knows beyond places and diagnostics belongs to those who read trees.
SDL_FOR_ALL = {"sdl/diagnostics.hpp", "sdl/tree.hpp"}  # tree.hpp holds Location
SDL_READERS = ("host/bind/", "host/engine/", "host/app/")
TREE_WORDS = r"\bsdl::(Block|BlockPtr|Item|Word|Vector|Document|print)\b"

# The modules of host that a module may include beside itself; "" stands for the headers in host/ itself.
HOST_MODULES = {
    "optics": set(),
    "crystallography": {""},
    "fragments": {"", "solids", "plugins"},
    "bind": {"", "optics", "crystallography", "fragments", "plugins"},
    "plugins": {"", "output"},
    "solids": {""},
    "output": {"optics"},
    "accuracy": {"output", "optics"},
    "opencl": {"", "output", "optics", "fragments"},
    "mpi": {"", "opencl"},
    "": {"", "solids", "optics", "fragments"},
    "record": {"", "solids"},
    "preview": {"", "output", "opencl", "optics", "solids", "accuracy", "record"},
    "window": {"", "output", "optics", "opencl", "preview", "record"},
    "engine": {"", "optics", "bind", "fragments", "solids", "output", "plugins", "accuracy", "opencl"},
    "app": {"", "optics", "bind", "solids", "output", "plugins", "accuracy", "opencl", "mpi", "engine", "preview", "window"},
    "api": {"", "optics", "output", "opencl", "engine", "plugins"},
}

OPTICS_WORDS = (
    r"\w*(refracti|polariz|birefring|wavelength|lambda_nm|stokes|jones|crystal|uniaxial|"
    r"dispersi|fresnel|sellmeier)\w*"
)

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def resolve(path, quote, name, root):
    """The included file relative to the root if it lies in the tree, else None."""
    if quote == "<":
        return None
    for candidate in (root / path).parent / name, root / name:
        if candidate.exists():
            return candidate.resolve().relative_to(root).as_posix()
    return name


def host_module(path):
    parts = path.split("/")
    return parts[1] if len(parts) > 2 else ""


def library_violation(path, name):
    for library, pattern, allowed in LIBRARIES:
        if re.match(pattern, name) and not any(path.startswith(a) for a in allowed):
            return f"{library} is for {', '.join(allowed)} only: {name}"
    return None


def own_file_violation(path, target):
    layer, target_layer = path.split("/")[0], target.split("/")[0]
    if layer in ("sdl", "kernels"):
        return (
            None
            if target_layer == layer
            else f"{layer} includes {target}: it knows nothing else of this tree"
        )
    if target_layer == "sdl":
        if target not in SDL_FOR_ALL and not path.startswith(SDL_READERS):
            return f"only {' and '.join(SDL_READERS)} read the language: {target}"
    elif target_layer == "host":
        mine, theirs = host_module(path), host_module(target)
        if mine != theirs and theirs not in HOST_MODULES.get(mine, set()):
            return f"host/{mine} knows nothing of {target}"
    elif target_layer != "kernels":
        return f"{target} is none of sdl, kernels, host"
    return None


def include_violation(path, quote, name, root):
    target = resolve(path, quote, name, root)
    if target is not None:
        return own_file_violation(path, target)
    if path.split("/")[0] in ("sdl", "kernels") and ("/" in name or "." in name):
        return f"{path.split('/')[0]} knows the standard library only: {name}"
    return library_violation(path, name)


def line_violations(path, line, root):
    match = INCLUDE.match(line)
    if match:
        violation = include_violation(path, match[1], match[2], root)
        if violation:
            yield violation
    if path.startswith("sdl/"):
        for word in re.finditer(OPTICS_WORDS, line, re.IGNORECASE):
            yield f"a word of optics in the language: {word[0]}"
    elif path.startswith("host/") and not path.startswith(SDL_READERS):
        for word in re.finditer(TREE_WORDS, line):
            yield f"only {' and '.join(SDL_READERS)} read the tree: {word[0]}"


def check(root):
    """Violations as (file, line, reason), and files over the soft limit as (file, lines)."""
    root = root.resolve()
    violations, long_files = [], []
    files = [f for layer in ("sdl", "kernels", "host") for f in sorted((root / layer).rglob("*"))]
    for file in files:
        if file.suffix not in SUFFIXES or not file.is_file():
            continue
        path = file.relative_to(root).as_posix()
        lines = file.read_text(encoding="utf-8").splitlines()
        for number, line in enumerate(lines, 1):
            violations += [(path, number, reason) for reason in line_violations(path, line, root)]
        if len(lines) > SOFT_LIMIT_LINES and file.suffix != ".inc":
            long_files.append((path, len(lines)))
    return violations, long_files


def main():
    root = Path(sys.argv[1])
    if not (root / "sdl").is_dir():
        sys.exit(f"{root} is not the root of the tree")
    violations, long_files = check(root)
    for path, lines in long_files:
        print(f"{path}: {lines} lines (soft limit {SOFT_LIMIT_LINES})")
    for path, number, reason in violations:
        print(f"{path}:{number}: {reason}")
    print(f"{len(violations)} violations")
    sys.exit(1 if violations else 0)


if __name__ == "__main__":
    main()
