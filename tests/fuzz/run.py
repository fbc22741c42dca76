#!/usr/bin/env python3
"""Builds the fuzzers with clang and runs one for a while.

run.py build                              configures and builds, in --folder
run.py scene|probe --seconds 30           seeds, then inputs made from them; prints how many
By hand for longer: run.py scene --seconds 3600 --jobs 2. What a run finds interesting stays in --folder,
and the next run goes on from there; what crashes, hangs or takes too much memory is printed with its path.
"""

import argparse
import json
import os
import random
import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
HERE = Path(__file__).resolve().parent
PACKAGES = "clang libclang-rt-14-dev"


def find_clang():
    for name in ["clang++", *(f"clang++-{v}" for v in range(22, 13, -1))]:
        if shutil.which(name):
            return name
    sys.exit(f"run.py: no clang++ found; on Debian 12: apt-get install {PACKAGES}")


def run(command, log):
    with open(log, "a", encoding="utf-8") as out:
        if subprocess.run(command, stdout=out, stderr=subprocess.STDOUT, check=False).returncode == 0:
            return
    print("".join(Path(log).read_text(encoding="utf-8", errors="replace").splitlines(True)[-25:]))
    sys.exit(f"run.py: {' '.join(map(str, command))} failed (log: {log}); it needs {PACKAGES}")


def build(folder):
    log = folder / "build.log"
    log.write_text("")
    cached = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
    run(["cmake", "-S", ROOT, "-B", folder / "build", "-G", "Ninja", f"-DCMAKE_CXX_COMPILER={find_clang()}",
         "-DNICOL_FUZZ=ON", *cached], log)
    run(["cmake", "--build", folder / "build", "--target", "fuzz_scene", "fuzz_probe"], log)


def put_seeds(subject, seeds):
    """Scenes as they are; each of the probe's known cases by itself."""
    seeds.mkdir(parents=True, exist_ok=True)
    if subject == "scene":
        for path in [*ROOT.glob("scenes/*/*.pov"), *ROOT.glob("tests/**/*.pov")]:
            (seeds / f"{path.parent.name}_{path.name}").write_bytes(path.read_bytes())
        random.seed(1)
        for number in range(60):  # of these bytes scenes are made
            (seeds / f"bytes_{number}").write_bytes(b"\0" + random.randbytes(10 + 3 * number))
        return
    for path in [*ROOT.glob("tests/kernels/data/*.json"), *HERE.glob("seeds/*.json")]:
        document = json.loads(path.read_text(encoding="utf-8"))
        for kind in ("interface", "bulk", "propagation"):
            cases = document.get(kind, []) if isinstance(document, dict) else []
            for number, case in enumerate(cases[:: max(1, len(cases) // 60)]):
                text = json.dumps({"interface": [], kind: [case]})
                (seeds / f"{path.stem}_{kind}_{number}.json").write_text(text)


def fuzz(subject, folder, seconds, jobs, timeout):
    corpus, seeds, found = (folder / f"{subject}_{what}" for what in ("corpus", "seeds", "found"))
    for path in corpus, found:
        path.mkdir(parents=True, exist_ok=True)
    put_seeds(subject, seeds)
    known = sorted((HERE / "found").glob(f"{subject}_*"))
    fuzzer = folder / "build/bin" / f"fuzz_{subject}"
    if not fuzzer.exists():
        sys.exit(f"run.py: there is no {fuzzer}: run.py build comes first")
    limits = [f"-timeout={timeout}", "-rss_limit_mb=3000", f"-artifact_prefix={found}/", "-print_final_stats=1"]
    options = [f"-max_total_time={seconds}", "-max_len=6000", f"-fork={jobs}" if jobs > 1 else "-seed=1"]
    environment = {**os.environ, "ASAN_OPTIONS": "detect_leaks=0", "UBSAN_OPTIONS": "print_stacktrace=1"}
    for arguments in [*known] and [[*limits, *known]] or []:
        check(subprocess.run([fuzzer, *arguments], env=environment, capture_output=True, text=True, errors="replace",
                             check=False), found)
    outcome = subprocess.run([fuzzer, *limits, *options, corpus, seeds], env=environment, capture_output=True, text=True,
                             errors="replace", check=False)
    check(outcome, found)
    tried = re.findall(r"stat::number_of_executed_units:\s*(\d+)", outcome.stderr) or re.findall(
        r"^#(\d+):", outcome.stderr, re.MULTILINE)
    slowest = re.findall(r"stat::slowest_unit_time_sec:\s*(\d+)", outcome.stderr)
    print(f"fuzz.{subject}: {tried[-1] if tried else '?'} inputs in {seconds} s, from {len(list(seeds.iterdir()))} seeds and "
          f"{len(known)} that once failed; slowest {slowest[-1] if slowest else '?'} s; nothing found")


def check(outcome, found):
    if outcome.returncode == 0:
        return
    print(outcome.stderr[-8000:])
    sys.exit(f"run.py: an input fails; it lies in {found}. Run the fuzzer on it alone to see it again.")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=["build", "scene", "probe"])
    parser.add_argument("--folder", type=Path, default=ROOT / "build/fuzz")
    parser.add_argument("--seconds", type=int, default=30)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--timeout", type=int, default=20, help="s for one input; sanitizers make it 5 to 10 times slower")
    arguments = parser.parse_args()
    folder = arguments.folder.resolve()
    folder.mkdir(parents=True, exist_ok=True)
    if arguments.what == "build":
        build(folder)
    else:
        fuzz(arguments.what, folder, arguments.seconds, arguments.jobs, arguments.timeout)


if __name__ == "__main__":
    main()
