#!/usr/bin/env python3
"""The example polarizer_sweep.py: its pictures follow Malus' law and the formulas of the plates, and its plot is drawn.

sweep_test.py; NICOL_LIBRARY and PYTHONPATH say where the library and the example are.
"""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import matplotlib.image
import numpy as np

import nicol
import polarizer_sweep as sweep

WITHIN = 2e-6  # float, of light that has been through up to 20 faces


class Sweep(unittest.TestCase):
    def test_formulas(self):
        angles = np.array([0.0, 45.0, 90.0])
        nothing, along, across = sweep.transmitted(angles, np.array([589.3]))[:, :, 0]
        np.testing.assert_allclose(nothing, [1, 0.5, 0], atol=1e-15)
        # all light: both positions of the analyzer together, less what the faces send back
        n_o = sweep.quartz_indices(np.array([589.3]))[0][0]
        self.assertAlmostEqual(n_o, 1.5442, delta=1e-4)
        self.assertAlmostEqual(across[0] + across[2], 2 * n_o / (n_o**2 + 1), delta=1e-12)
        self.assertAlmostEqual(sweep.quartz_rotation_deg_per_mm(589.3), 21.72, delta=0.03)
        self.assertLess(along[0] + along[2], 1)

    def test_pictures_follow_them(self):
        angles = np.array([0.0, 20.0, 75.0, 90.0, 140.0, 180.0])
        with nicol.Context() as context:
            points = sweep.measured(angles, context)
        formula = sweep.transmitted(angles, sweep.WAVELENGTHS_NM)
        self.assertEqual(points.shape, (3, 6, 5))
        for plate, point, line in zip(sweep.PLATES, points, formula):
            self.assertLess(np.abs(point - line).max(), WITHIN, plate)

    def test_plot(self):
        with tempfile.TemporaryDirectory() as folder:
            plot = Path(folder, "sweep.png")
            told = subprocess.run([sys.executable, "-B", sweep.__file__, "-o", plot, "--step", "45"], check=True,
                                  capture_output=True, text=True).stdout
            picture = matplotlib.image.imread(plot)
        self.assertIn("5 angles, 5 wavelengths", told)
        self.assertGreater(len(np.unique(picture.reshape(-1, picture.shape[2]), axis=0)), 50)


if __name__ == "__main__":
    unittest.main()
