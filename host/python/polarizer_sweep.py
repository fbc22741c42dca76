#!/usr/bin/env python3
"""Quartz between two polarizers, the second of which turns: what nicol renders against the closed formulas.

    polarizer_sweep.py [-o sweep.png or .svg] [--step DEGREES]

Light polarized to the right goes through nothing, through a quartz plate cut along its optic axis (a retarder, 50 um, axis at
30 deg) and through one cut across it (2 mm of right quartz, which turns the plane). The analyzer turns from 0 to 180 deg, one
picture of three pixels each.

Formulas, a being the analyzer's angle, counter-clockwise for the receiver (E. L. Malus, 1809: I = cos^2 of the angle to the plane):
  nothing    cos^2 a
  across     T cos^2(a + rho d), T = (1 - R)/(1 + R), R = ((n_o - 1)/(n_o + 1))^2: right quartz turns clockwise by rho d, and each
             reflection to and fro turns back what it had turned
  along      in the axes of the plate, at b = 30 deg, the Jones vector
               ((1 - R_e) R_e^m cos(b) e^(i(2m + 1) delta/2), -(1 - R_o) R_o^m sin(b) e^(-i(2m + 1) delta/2)), delta = 2 pi (n_e - n_o) d/lambda,
             of which the analyzer takes its projection; the intensities of the orders m = 0, 1, ... of reflection add
Numbers: n_o, n_e by G. Ghosh, Opt. Commun. 163, 95 (1999), eq. 1; rho by T. M. Lowry, Optical Rotatory Power (1935), quartz at 20 C.
Holds for normal incidence and plates that are thicker than the coherence length. The plate cut along its axis is taken without its
activity, which is too weak there to be seen. Held by tests/python/sweep_test.py.
"""

import argparse

import numpy as np

import nicol

ALONG_MM, AXIS_DEG, ACROSS_MM = 0.05, 30.0, 2.0
WAVELENGTHS_NM = np.array([450.0, 500.0, 550.0, 600.0, 650.0])
COLOURS = ("#3f3fbf", "#1f8fa8", "#2e9a3a", "#d08a00", "#c0281e")
PLATES = ("nothing in between", "quartz cut along its axis, 50 µm at 30°", "right quartz cut across its axis, 2 mm")
SCENE = f"""
#version unofficial 3.7;
#include "minerals.inc"
global_settings {{ mm_per_unit 1  max_trace_level 20  adc_bailout 1e-8 }}
camera {{ orthographic  location -20*z  look_at 0  right 3*x  up y  polarizer {{ ideal angle Analyzer }} }}
polygon {{ 5, <-2, -1, 1>, <2, -1, 1>, <2, 1, 1>, <-2, 1, 1>, <-2, -1, 1>
  luminous {{ spectrum {{ e }} polarizer {{ ideal axis x }} }} }}
box {{ <-0.4, -0.4, -{ALONG_MM}>, <0.4, 0.4, 0>
  interior {{ M_Quartz_Inactive optic_axis <cos(radians({AXIS_DEG})), sin(radians({AXIS_DEG})), 0> }} }}
box {{ <0.6, -0.4, -{ACROSS_MM}>, <1.4, 0.4, 0> interior {{ M_Quartz_Right optic_axis z }} }}
"""


def quartz_indices(lambda_nm):
    """n_o, n_e (Ghosh 1999)."""
    l2 = (lambda_nm / 1000) ** 2
    index = lambda a, b, c, d, e: np.sqrt(a + b * l2 / (l2 - c) + d * l2 / (l2 - e))
    return (index(1.28604141, 1.07044083, 1.00585997e-2, 1.10202242, 100),
            index(1.28851804, 1.09509924, 1.02101864e-2, 1.15662475, 100))


def quartz_rotation_deg_per_mm(lambda_nm):
    """Along the axis (Lowry 1935)."""
    l2 = (lambda_nm / 1000) ** 2
    return 9.5639 / (l2 - 0.0127493) - 2.3113 / (l2 - 0.000974) - 0.1905


def reflectance(index):
    """Of a face at normal incidence (Fresnel)."""
    return ((index - 1) / (index + 1)) ** 2


def transmitted(analyzer_deg, lambda_nm):
    """(plates, angles, wavelengths): light behind the analyzer, relative to parallel polarizers without a plate."""
    a, b = np.radians(analyzer_deg)[:, None], np.radians(AXIS_DEG)
    n_o, n_e = quartz_indices(lambda_nm)
    r_o, r_e = reflectance(n_o), reflectance(n_e)
    turned = np.radians(quartz_rotation_deg_per_mm(lambda_nm) * ACROSS_MM)
    across = (1 - r_o) / (1 + r_o) * np.cos(a + turned) ** 2
    half_delta = np.pi * (n_e - n_o) * ALONG_MM * 1e6 / lambda_nm
    along = 0
    for m in range(4):
        phase = np.exp(1j * (2 * m + 1) * half_delta)
        e_wave = (1 - r_e) * r_e**m * np.cos(b) * phase * np.cos(a - b)
        o_wave = (1 - r_o) * r_o**m * np.sin(b) / phase * np.sin(a - b)
        along = along + np.abs(e_wave - o_wave) ** 2
    return np.stack(np.broadcast_arrays(np.cos(a) ** 2 + 0 * lambda_nm, along, across))


def measured(analyzer_deg, context):
    """The same as transmitted(), rendered."""
    light = []
    for angle in analyzer_deg:
        scene = context.load_text(SCENE, "sweep.pov", width=3, height=1, declares={"Analyzer": angle}, wavelengths_nm=WAVELENGTHS_NM)
        with scene.render() as picture:
            light.append(picture.stokes[0, :, 0, :].T)  # a row of pixels, one for each plate
    light = np.stack(light, axis=1).astype(np.float64)
    parallel = light[0, np.argmin(np.abs(analyzer_deg))]
    return light / parallel


def plot(path, analyzer_deg, points):
    """Points as rendered, lines by the formulas."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    fine_deg = np.linspace(0, 180, 361)
    lines = transmitted(fine_deg, WAVELENGTHS_NM)
    figure, axes = plt.subplots(1, 3, figsize=(13, 4.2), sharey=True, constrained_layout=True)
    for panel, title, line, point in zip(axes, PLATES, lines, points):
        for i, (lambda_nm, colour) in enumerate(zip(WAVELENGTHS_NM, COLOURS)):
            panel.plot(fine_deg, line[:, i], color=colour, linewidth=1)
            panel.plot(analyzer_deg, point[:, i], "o", color=colour, markersize=4, label=f"{lambda_nm:g} nm")
        panel.set(title=title, xlabel="analyzer (degrees)", xticks=range(0, 181, 30), xlim=(-3, 183), ylim=(-0.03, 1.03))
        panel.title.set_fontsize(10)
        panel.grid(alpha=0.3)
    axes[0].set_ylabel("transmitted light, relative to parallel polarizers")
    axes[2].legend(title="points: nicol\nlines: formula", fontsize=8, title_fontsize=8)
    figure.savefig(path, dpi=110)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-o", "--output", default="sweep.png", help="the plot, .png or .svg")
    parser.add_argument("--step", type=float, default=10, help="of the analyzer, degrees")
    options = parser.parse_args()
    analyzer_deg = np.arange(0, 180 + options.step / 2, options.step)
    with nicol.Context() as context:
        points = measured(analyzer_deg, context)
        device = context.device.name
    worst = np.abs(points - transmitted(analyzer_deg, WAVELENGTHS_NM)).max(axis=(1, 2))
    plot(options.output, analyzer_deg, points)
    print(f"{len(analyzer_deg)} angles, {len(WAVELENGTHS_NM)} wavelengths on {device}: {options.output}")
    for plate, off in zip(PLATES, worst):
        print(f"  {plate}: at most {off:.1e} off the formula")


if __name__ == "__main__":
    main()
