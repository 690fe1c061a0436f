#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compiles all plain sources of a library as one unit, so that engines may build with unity batches of any size."""
import pathlib
import subprocess
import sys
import tempfile

compiler, source, folder, includes, listed = sys.argv[1:6]
root = pathlib.Path(source)
names = [name for name in listed.split(";") if name.endswith(".cpp")]
plain = [name for name in names if "foreach_target.h" not in (root / folder / name).read_text()]  # others compile themselves
if not plain:
    sys.exit("no sources: is the list whole?")
with tempfile.TemporaryDirectory() as scratch:
    unit = pathlib.Path(scratch) / "unit.cpp"
    unit.write_text("".join(f'#include "{folder}/{name}"\n' for name in plain))
    flags = [f"-isystem{path}" for path in includes.split(";") if path and path not in ("/usr/include", source)]
    made = subprocess.run([compiler, "-std=c++20", "-fsyntax-only", f"-I{source}", *flags, str(unit)], text=True,
                          stderr=subprocess.PIPE, check=False)
sys.stderr.write(made.stderr)
sys.exit(made.returncode)
