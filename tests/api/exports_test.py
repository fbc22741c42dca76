#!/usr/bin/env python3
"""exports_test.py LIBRARY HEADER: the library exports what the header declares, and nothing else."""

import re
import subprocess
import sys

library, header = sys.argv[1:]
listed = subprocess.run(["nm", "-D", "--defined-only", library], check=True, capture_output=True, text=True).stdout
symbols = [line.split() for line in listed.splitlines()]
exported = {fields[-1].split("@")[0] for fields in symbols if fields[-2] != "A"}  # A: names of versions
with open(header, encoding="utf-8") as file:
    declared = set(re.findall(r"NICOL_API[^;]*?\b(nicol_\w+)\(", file.read()))

failures = [f"exported but not declared: {name}" for name in sorted(exported - declared)]
failures += [f"declared but not exported: {name}" for name in sorted(declared - exported)]
if len(declared) < 30:
    failures.append(f"only {len(declared)} functions were found in {header}")
print("\n".join(failures) or f"{len(exported)} functions, all declared")
sys.exit(1 if failures else 0)
