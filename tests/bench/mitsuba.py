#!/usr/bin/env python3
"""The same scene in nicol and in Mitsuba 3: error against time, side by side.

A glass cube (index 1.52 at all wavelengths) on a polarized light under a uniform sky, before an analyzer:
scenes/comparison/glass_cube.pov, and the same below for Mitsuba's spectral polarized path tracer. Mitsuba's polarizer
projects the axis that absorbs (Korger 2013); so do those of the scene.

    python3 -m venv mitsuba_venv && mitsuba_venv/bin/pip install mitsuba
    apt-get install libllvm19                    Mitsuba's compiler wants LLVM 16 or later
    mitsuba_venv/bin/python tests/bench/mitsuba.py

Error: RMS over pixels (and wavelengths) of S0, by its mean. nicol: against its own picture of --reference samples.
Mitsuba: between pictures of two seeds, by sqrt 2. Times: of rendering on a machine that does nothing else, without what
both need to start and to compile; the least of several runs. Beyond what was rendered Mitsuba's error goes on as
1/sqrt(samples).
"""

import argparse
import glob
import math
import os
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SCENE = ROOT / "scenes/comparison/glass_cube.pov"
CORES = len(os.sched_getaffinity(0))
TARGETS = (0.01, 0.001)
SKY_THROUGH_ANALYZER = 0.05  # radiance of the sky behind the analyzer, in units of what the light's polarizer passes


def load_mitsuba(variant):
    for library in sorted(glob.glob("/usr/lib/*/libLLVM*.so*") + glob.glob("/usr/lib/llvm-*/lib/libLLVM*.so*"), reverse=True):
        version = re.search(r"libLLVM[-.](?:so\.)?(\d+)", library)
        if version and int(version[1]) >= 16:
            os.environ.setdefault("DRJIT_LIBLLVM_PATH", library)
    own_folder = str(Path(__file__).resolve().parent)
    sys.path[:] = [folder for folder in sys.path if os.path.realpath(folder or ".") != own_folder]  # this file has that name too
    try:
        import mitsuba
    except ImportError as error:
        sys.exit(f"mitsuba.py: Mitsuba cannot be imported ({error}). This sets it up:\n" + __doc__.split("\n\n")[2])
    if "DRJIT_LIBLLVM_PATH" not in os.environ and variant.startswith("llvm"):
        sys.exit("mitsuba.py: no LLVM of version 16 or later: apt-get install libllvm19 (or set DRJIT_LIBLLVM_PATH)")
    mitsuba.set_variant(variant)
    return mitsuba


def sensor(mi, size, fov_deg, to_world):
    film = {"type": "hdrfilm", "width": size, "height": size, "pixel_format": "luminance", "component_format": "float32",
            "rfilter": {"type": "box"}}
    return {"type": "perspective", "fov": fov_deg, "fov_axis": "x", "near_clip": 0.001, "to_world": to_world, "film": film,
            "sampler": {"type": "independent"}}


def glass_cube(mi, size):
    """POV-Ray's (x, y, z) are x, z, y here. Mitsuba has no contacts: the gaps are just wider than its rays' offset."""
    transform = mi.ScalarTransform4f
    gap, near = 0.0004, 0.02
    camera = transform().look_at(origin=[2.2, -2.6, 2], target=[0, 0, 0.45], up=[0, 0, 1])
    return mi.load_dict({
        "type": "scene",
        "integrator": {"type": "path", "max_depth": 66, "rr_depth": 1000},
        "sensor": sensor(mi, size, 24, camera),
        "analyzer": {"type": "rectangle", "bsdf": {"type": "polarizer", "theta": 0.0},
                     "to_world": camera @ transform().translate([0, 0, near]) @ transform().scale([0.25 * near, 0.25 * near, 1])},
        "sky": {"type": "constant", "radiance": {"type": "uniform", "value": 0.1}},
        "light": {"type": "rectangle", "emitter": {"type": "area", "radiance": {"type": "uniform", "value": 2.0}},
                  "bsdf": {"type": "diffuse", "reflectance": {"type": "uniform", "value": 0.0}}},
        "polarizer": {"type": "rectangle", "to_world": transform().translate([0, 0, gap]),
                      "bsdf": {"type": "polarizer", "theta": -math.degrees(0.3)}},
        "cube": {"type": "cube", "bsdf": {"type": "dielectric", "int_ior": 1.52, "ext_ior": 1.0},
                 "to_world": transform().rotate([0, 0, 1], 25) @ transform().translate([0, 0, 0.5 + 2 * gap]) @
                             transform().scale(0.5)}})


def run_mitsuba(mi, size, counts):
    """(samples, seconds, error) for each count, and the mean in units of what the light's polarizer passes."""
    import numpy

    def render(scene, samples, seed):
        return numpy.array(mi.render(scene, spp=samples, seed=seed))[:, :, 0].astype(float)

    sky = mi.load_dict({"type": "scene", "integrator": {"type": "path"}, "sensor": sensor(mi, size, 24, mi.ScalarTransform4f()),
                        "sky": {"type": "constant", "radiance": {"type": "uniform", "value": 1.0}}})
    unit = render(sky, 128, 7).mean()  # a radiance of 1 as its film gives it
    scene = glass_cube(mi, size)
    curve, means, seed = [], [], 10
    for samples in counts:
        render(scene, samples, 1)  # compiles
        pair, seconds = [], math.inf
        for i in range(2):
            before = time.perf_counter()
            pair.append(render(scene, samples, seed + i))
            seconds = min(seconds, time.perf_counter() - before)
        mean = (pair[0].mean() + pair[1].mean()) / 2
        error = math.sqrt(((pair[0] - pair[1]) ** 2).mean() / 2) / mean
        curve.append((samples, seconds, error))
        means.append((mean / unit, samples))
        seed += 2
    return curve, sum(m * n for m, n in means) / sum(n for _, n in means)


class Nicol:
    def __init__(self, mi, program, size):
        self.mi, self.program, self.size = mi, program, size
        self.folder = tempfile.TemporaryDirectory()

    def render(self, options, size=None):
        """S0 [wavelength][pixel] in the same units, and the seconds of rendering."""
        import numpy

        out = Path(self.folder.name) / "out.exr"
        command = [self.program, "render", SCENE, "-o", out, "-W", size or self.size, "-H", size or self.size, "--no-budget",
                   *options]
        done = subprocess.run(list(map(str, command)), capture_output=True, text=True, check=False)
        if done.returncode != 0:
            sys.exit(f"mitsuba.py: {' '.join(map(str, command))} failed:\n{done.stdout}{done.stderr}")
        seconds = re.search(rb"nicol:time\0string\0....([-+.e\d]+) s", out.read_bytes(), re.DOTALL)
        bitmap = self.mi.Bitmap(str(out))
        planes = numpy.array(bitmap)
        s0 = [i for i, field in enumerate(bitmap.struct_()) if field.name.startswith("S0.")]
        values = numpy.moveaxis(planes[:, :, s0].astype(float), 2, 0)
        return values / (values[:, :1, :1].mean() / SKY_THROUGH_ANALYZER), float(seconds[1])

    def curve(self, what, options, settings, reference, repeats):
        self.render([*options, what, settings[0]])  # builds the kernel
        points = []
        for setting in settings:
            runs = [self.render([*options, what, setting]) for _ in range(repeats)]
            seconds = min(seconds for _, seconds in runs)
            error = math.sqrt(((runs[0][0] - reference) ** 2).mean()) / reference.mean()
            points.append((setting, seconds, error))
        return points


def seconds_to(curve, target):
    """Between the points of a curve, straight in logarithms; None beyond them."""
    for (_, t0, e0), (_, t1, e1) in zip(curve, curve[1:]):
        if e0 >= target > e1:
            return math.exp(math.log(t0) + math.log(t1 / t0) * math.log(e0 / target) / math.log(e0 / e1))
    return curve[0][1] if curve[0][2] <= target else None


def show(title, curve, unit):
    print(f"\n{title}")
    for setting, seconds, error in curve:
        print(f"  {setting:>10} {unit:<18} {seconds:10.3f} s   {100 * error:9.4f} %")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--nicol", default=str(ROOT / "build/release/bin/nicol"), help="the program (./nicol builds it)")
    parser.add_argument("--variant", default="llvm_ad_spectral_polarized")
    parser.add_argument("--size", type=int, default=256)
    parser.add_argument("--spp", type=int, nargs="+", default=[16, 64, 256], help="samples per pixel for Mitsuba")
    parser.add_argument("--samples", type=int, nargs="+", default=[1, 4, 9, 16, 25, 36, 64, 144, 256, 400, 576])
    parser.add_argument("--sample-errors", type=float, nargs="+", default=[0.05, 0.02, 0.01, 0.005, 0.002, 0.001, 0.0005])
    parser.add_argument("--reference", type=int, default=4096, help="samples per pixel of nicol's reference")
    parser.add_argument("--repeats", type=int, default=2)
    arguments = parser.parse_args()
    mi = load_mitsuba(arguments.variant)
    if not os.access(arguments.nicol, os.X_OK):
        sys.exit(f"mitsuba.py: there is no program {arguments.nicol}: `./nicol devices` builds it, or name one with --nicol")

    nicol = Nicol(mi, arguments.nicol, arguments.size)
    reference, _ = nicol.render(["--samples", arguments.reference, "--adc-bailout", 1e-6])
    mitsuba_curve, mitsuba_mean = run_mitsuba(mi, arguments.size, arguments.spp)
    print(f"{arguments.size} x {arguments.size} pixels, {len(reference)} wavelengths, {CORES} cores; Mitsuba {mi.__version__} "
          f"{arguments.variant}\nmean radiance, by half the light's: nicol {reference.mean():.6f}, Mitsuba {mitsuba_mean:.6f}, "
          f"off by {100 * (mitsuba_mean / reference.mean() - 1):+.3f} %")
    show("Mitsuba", mitsuba_curve, "samples")
    each = ["--declare", "Dispersion=1e-9"]
    curves = {"nicol, samples everywhere": nicol.curve("--samples", [], arguments.samples, reference, arguments.repeats),
              "nicol, each wavelength by itself": nicol.curve("--samples", each, [n for n in arguments.samples if n <= 64], reference, 1)}
    for title, curve in curves.items():
        show(title, curve, "samples")
    if "--sample-error" in subprocess.run([arguments.nicol, "render", "--help"], capture_output=True, text=True, check=False).stdout:
        for title, options, least, repeats in (("nicol, samples where they matter", [], 0, arguments.repeats),
                                               ("the same, each wavelength by itself", each, 0.001, 1)):
            errors = [error for error in arguments.sample_errors if error >= least]
            curves[title] = nicol.curve("--sample-error", options, errors, reference, repeats)
            show(title, curves[title], "error asked for")
    compare(mitsuba_curve, curves)


def compare(mitsuba_curve, curves):
    samples, seconds, error = mitsuba_curve[-1]
    print(f"\ntime to an error, and Mitsuba's by nicol's (Mitsuba's from {samples} samples on by 1/sqrt)")
    theirs = [seconds * (error / target) ** 2 for target in TARGETS]
    print(f"  {'Mitsuba':<40}" + "".join(f"{100 * t:g} %: {s:10.1f} s            " for t, s in zip(TARGETS, theirs)))
    for title, curve in curves.items():
        line = f"  {title:<40}"
        for target, their in zip(TARGETS, theirs):
            own = seconds_to(curve, target)
            line += f"{100 * target:g} %: " + (f"{own:10.3f} s {their / own:8.0f} x  " if own else f"{'not reached':<24} ")
        print(line)


if __name__ == "__main__":
    main()
