#!/usr/bin/env python3
"""From one processor core to two, measured, and from there to 1000 nodes, on paper.

scaling.py [--nicol PATH] [--mpirun PATH] [--ranks PATH] [--repeats N]

--ranks: test_mpi_ranks of a build with tests, which measures how fast rank 0 gathers.

Each rank or process gets one core (taskset, and a device of one thread), so that two ranks have twice the cores of one. The best of several runs counts:
a machine with other work to do only makes a run longer.
"""

import argparse
import os
import re
import shutil
import subprocess
import tempfile
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
SCENE = HERE.parent.parent / "scenes" / "founding" / "fig5_active.pov"
WIDTH, SAMPLES = 256, 4
PICTURE = ["-W", WIDTH, "-H", WIDTH, "--no-budget", "--samples", SAMPLES]


class Bench:
    def __init__(self, options):
        self.nicol = str(Path(options.nicol).resolve())
        self.mpirun = options.mpirun
        self.repeats = options.repeats
        self.folder = Path(tempfile.mkdtemp(prefix="nicol-scaling-"))
        self.cores = sorted(os.sched_getaffinity(0))

    def pinned(self, core, *arguments):
        return ["taskset", "-c", str(core), self.nicol, *map(str, arguments)]

    def ranks(self, count, *arguments):
        """mpirun, each rank on its core."""
        inner = 'exec taskset -c $((OMPI_COMM_WORLD_LOCAL_RANK + FIRST)) "$@"'
        return ["env", f"FIRST={self.cores[0]}", self.mpirun, "--allow-run-as-root", "--oversubscribe", "--bind-to", "none", "-n", str(count),
                "sh", "-c", inner, "sh", self.nicol, *map(str, arguments)]

    def run(self, *commands):
        """Seconds of all of them at once, and what they told."""
        start = time.monotonic()
        # a device of one core: its driver counts those of the machine, not those it may use
        environment = {**os.environ, "POCL_MAX_PTHREAD_COUNT": "1"}
        processes = [subprocess.Popen(c, cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=environment)
                     for c in commands]
        told = [p.communicate() for p in processes]
        seconds = time.monotonic() - start
        for process, (_, words) in zip(processes, told):
            if process.returncode != 0:
                raise SystemExit(f"{' '.join(process.args)}: {words}")
        return seconds, told[0][1]

    def best(self, *commands):
        return min((self.run(*commands) for _ in range(self.repeats)), key=lambda found: found[0])


def tracing_seconds(told):
    return float(re.search(r"^([\d.]+) s, ", told, re.MULTILINE)[1])


def measure_speed(bench):
    """Wall seconds of the same picture in four ways."""
    render = ["render", SCENE, *PICTURE, "-o"]
    core0, core1 = bench.cores[0], bench.cores[-1]
    bench.run(bench.pinned(core0, *render, "warm.exr"))  # kernels into the cache
    rows = {}
    rows["1 process"] = bench.best(bench.pinned(core0, *render, "one.exr"))
    rows["2 processes (--part)"] = bench.best(bench.pinned(core0, *render, "p1.exr", "--part", "1/2"),
                                              bench.pinned(core1, *render, "p2.exr", "--part", "2/2"))
    if bench.mpirun:
        rows["1 rank"] = bench.best(bench.ranks(1, *render, "r1.exr"))
        rows["2 ranks"] = bench.best(bench.ranks(2, *render, "r2.exr"))
    return rows


def measure_startup(bench):
    """Seconds of what a run needs before and beside tracing."""
    core = bench.cores[0]
    tiny = ["-W", "1", "-H", "1", "--no-budget", "-q"]
    found = {"process, nothing to do (--version)": bench.best(bench.pinned(core, "--version"))[0],
             "device opened (devices)": bench.best(bench.pinned(core, "devices"))[0],
             "1 pixel, small scene": bench.best(bench.pinned(core, "render", SCENE, *tiny, "-o", "t.exr"))[0]}
    large = HERE.parent.parent / "scenes" / "gems" / "quartz_cluster.pov"
    bench.run(bench.pinned(core, "render", large, *tiny, "-o", "l.exr"))
    found["check of the large scene"] = bench.best(bench.pinned(core, "check", large))[0]
    found["1 pixel, large scene"] = bench.best(bench.pinned(core, "render", large, *tiny, "-o", "l.exr"))[0]
    return found


def measure_merge(bench):
    parts = ["p1.exr", "p2.exr"]
    size = sum((bench.folder / p).stat().st_size for p in parts)
    seconds, _ = bench.best(bench.pinned(bench.cores[0], "merge", *parts, "-o", "merged.exr", "-q"))
    return size, seconds


def measure_gather(bench, program):
    """Bytes a second that one process takes from a device (of one core) and puts into the picture, with a kernel that does next to nothing."""
    folder = bench.folder / "kernels"
    folder.mkdir()
    subprocess.run([program, "--kernel", str(folder)], check=True)
    pixels, bytes_a_pixel = 211 * 83, 24 * components_of_kernel() * 4
    environment = {**os.environ, "NICOL_KERNEL_DIR": str(folder), "POCL_MAX_PTHREAD_COUNT": "1"}
    best = 0
    for _ in range(bench.repeats + 1):
        told = subprocess.run(["taskset", "-c", str(bench.cores[0]), program, "a", "1", "0", "0"], cwd=bench.folder, env=environment, check=True,
                              capture_output=True, text=True).stdout
        best = max(best, pixels * bytes_a_pixel / float(re.search(r"seconds ([\d.]+)", told)[1]))
    return best


def gather_bytes(wavelengths=21, lanes=8, components=8, scalar=4):
    """A pixel's sums as a rank sends them: for each wavelength, rounded up to lanes, the kernel's components."""
    return -(-wavelengths // lanes) * lanes * components * scalar


def components_of_kernel():
    text = (HERE.parent.parent / "kernels" / "abi.h").read_text(encoding="utf-8")
    return int(re.search(r"OUT_COMPONENTS\s*=?\s*(\d+)", text)[1])


def on_paper(told_alone, startup, merge, gather, samples):
    pixels = WIDTH * WIDTH
    core_s = tracing_seconds(told_alone) / pixels
    start_s = startup["1 pixel, small scene"]
    launches = -(-samples // 16)
    pixel_bytes = gather_bytes(components=components_of_kernel()) * launches
    rate = pixel_bytes / core_s
    part_bytes, merge_s = merge
    print(f"""
On paper, to 1000 nodes; measured above: {core_s * 1e6:.1f} us a pixel and core ({samples} samples, 21 wavelengths), {start_s:.2f} s start-up.
A pixel's sums are {pixel_bytes} bytes for every 16 samples begun: one core sends {rate / 1e6:.2f} MB/s to rank 0.
  ranks: seconds(C cores) = start-up + pixels x {core_s * 1e6:.1f} us / C, as long as C x {rate / 1e6:.2f} MB/s is less than""")
    limits = [("a network of 1 Gbit/s", 125e6), ("of 10 Gbit/s", 1.25e9), ("of 100 Gbit/s", 12.5e9), ("rank 0, gathering", gather)]
    for name, limit in limits:
        if limit > 0:
            print(f"    {name:24} {limit / 1e6:8.0f} MB/s: enough for {limit / rate:7.0f} cores")
    print(f"""  up to 16 samples the bytes stay while the seconds grow: 16 samples are enough work for {16 / min(samples, 16):.0f} times as many cores; beyond 16 both grow.
  --part i/n: nothing is sent; seconds(n) = start-up + tracing / n + merge. Merging reads all pixels once, {part_bytes / merge_s / 1e6:.0f} MB/s here, and
  opens n files:""")
    read_bytes = 3e6  # program, kernel and a scene, as they lie on the disk
    for n in (10, 100, 1000):
        print(f"    n = {n:4}: merge {merge_s:.1f} s for this picture ({part_bytes / 1e6:.0f} MB of parts), start-up reads {n * read_bytes / 1e6:.0f} MB"
              f" of a shared file system ({n * read_bytes / 500e6:.1f} s at 500 MB/s)")
    print("""  So ranks are for as many cores as rank 0 feeds; beyond, several jobs of ranks with --part each, and one merge.""")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--nicol", default=str(HERE.parent.parent / "build" / "release" / "bin" / "nicol"))
    parser.add_argument("--mpirun", default=shutil.which("mpirun") or "")
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--ranks", default="")
    options = parser.parse_args()
    bench = Bench(options)
    try:
        rows = measure_speed(bench)
        print(f"{'':24} {'seconds':>8} {'tracing':>8}")
        for name, (seconds, told) in rows.items():
            print(f"{name:24} {seconds:8.2f} {tracing_seconds(told):8.2f}")
        startup = measure_startup(bench)
        for name, seconds in startup.items():
            print(f"{name:40} {seconds:6.3f} s")
        merge = measure_merge(bench)
        print(f"{'merge of two parts':40} {merge[1]:6.3f} s, {merge[0] / 1e6:.1f} MB")
        gather = measure_gather(bench, str(Path(options.ranks).resolve())) if options.ranks else 0
        if gather:
            print(f"{'gathering at rank 0':40} {gather / 1e6:6.0f} MB/s")
        on_paper(rows["1 process"][1], startup, merge, gather, SAMPLES)
    finally:
        shutil.rmtree(bench.folder)


if __name__ == "__main__":
    main()
