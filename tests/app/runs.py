"""Runs of nicol in a folder of their own, for the tests of the command line."""

import signal
import subprocess
import tempfile
import time
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

    def start(self, *arguments, **more):
        """A render begun; its messages are to be read from stderr."""
        return subprocess.Popen([self.nicol_path, "render", *map(str, arguments)], cwd=self.folder, stdout=subprocess.DEVNULL,
                                stderr=subprocess.PIPE, text=True, **more)

    def killed_in_work(self, start, effort, kept, size):
        """start(effort) begins a render that is killed once the file `kept` holds `size` bytes. Returns the effort it was killed at: one that
        finishes before (a trial beside other work makes a machine look slower than it is) is begun again with four times as much."""
        for _ in range(6):
            process = start(effort)
            deadline = time.monotonic() + PATIENCE_S
            while process.poll() is None and time.monotonic() < deadline and not (kept.exists() and kept.stat().st_size > size):
                time.sleep(0.01)
            process.send_signal(signal.SIGKILL)
            process.communicate()
            if process.returncode == -signal.SIGKILL:
                return effort
            effort *= 4
        self.fail("it finished before it could be killed")
        return 0

    def files(self):
        return sorted(path.name for path in self.folder.iterdir())
