"""Runs of nicol in a folder of their own, for the tests of the command line."""

import subprocess
import tempfile
import unittest
from pathlib import Path

PATIENCE_S = 240


class Runs(unittest.TestCase):
    nicol_path = ""
    compare_path = ""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def nicol(self, *arguments, **more):
        return subprocess.run([self.nicol_path, *map(str, arguments)], cwd=self.folder, capture_output=True, text=True,
                              timeout=PATIENCE_S, check=False, **more)

    def done(self, *arguments, **more):
        result = self.nicol(*arguments, **more)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stderr

    def refused(self, words, *arguments):
        """It fails with exit code 1 and tells these words."""
        result = self.nicol(*arguments)
        self.assertEqual(result.returncode, 1, result.stderr)
        for word in words:
            self.assertIn(word, result.stderr)
        return result.stderr

    def assert_same(self, one, two):
        """The same channels with the same bits."""
        result = subprocess.run([self.compare_path, one, two], cwd=self.folder, capture_output=True, text=True, check=False)
        self.assertEqual(result.returncode, 0, f"{one} and {two}: {result.stdout}")

    def files(self):
        return sorted(path.name for path in self.folder.iterdir())
