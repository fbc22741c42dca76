"""Programs under mpirun whose ranks a test can find, to kill or to stop them."""

import os
import time
import uuid
from pathlib import Path

PATIENCE_S = 120


class UnderMpirun:
    mpirun_path = ""

    def mark_ranks(self):
        self.mark = uuid.uuid4().hex
        # single copies need rights that containers may lack
        return {**os.environ, "NICOL_TEST_MARK": self.mark, "OMPI_MCA_btl_vader_single_copy_mechanism": "none"}

    def with_mpirun(self, ranks, command, options=()):
        return [self.mpirun_path, "--allow-run-as-root", "--oversubscribe", "--bind-to", "none", *options, "-n", str(ranks), *command]

    def rank(self, number):
        """The process of this rank, once it is there."""
        wanted = {f"NICOL_TEST_MARK={self.mark}".encode(), f"OMPI_COMM_WORLD_RANK={number}".encode()}
        deadline = time.monotonic() + PATIENCE_S
        while time.monotonic() < deadline:
            for folder in Path("/proc").iterdir():
                try:
                    if folder.name.isdigit() and wanted <= set((folder / "environ").read_bytes().split(b"\0")):
                        return int(folder.name)
                except OSError:
                    continue
            time.sleep(0.05)
        self.fail(f"rank {number} never came")
        return 0
