#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compiles every header of a folder alone and twice, and says which do not.

Only the syntax is checked, beside one precompiled header of the other libraries, which is most of what a header includes.
standard_includes_test holds that each header includes what that brings of the standard library and GLM.
SINEW_HEADERS names a file with the headers to take, one a line, where all would take too long; empty: all.
usage: header_alone.py SOURCE FOLDER [--headers CLI/CLI.hpp ...] [--exclude REGEX] --work FOLDER -- COMPILER FLAGS..."""
import argparse
import concurrent.futures
import os
import pathlib
import re
import subprocess
import sys

OF_OTHERS = ('glm/glm.hpp glm/gtc/quaternion.hpp algorithm array cmath filesystem functional limits map memory optional set span sstream string '
             'string_view vector')

parser = argparse.ArgumentParser()
parser.add_argument('source', type=pathlib.Path)
parser.add_argument('folder')
parser.add_argument('--headers', nargs='*', default=[])
parser.add_argument('--exclude', default='^$')
parser.add_argument('--work', type=pathlib.Path, required=True)
parser.add_argument('command', nargs='+')
options = parser.parse_args()


def compile_text(text, *more):
    return subprocess.run([*options.command, '-x', 'c++', *more, '-'], input=text, capture_output=True, text=True, cwd=options.work)


options.work.mkdir(parents=True, exist_ok=True)
precompiled = options.work / 'others.h'
precompiled.write_text(''.join(f'#include <{name}>\n' for name in [*OF_OTHERS.split(), *options.headers]))
done = subprocess.run([*options.command, '-x', 'c++-header', precompiled, '-o', f'{precompiled}.gch'], capture_output=True, text=True)
if done.returncode:
    sys.exit(done.stderr)

# Headers that end in -inl.h are included once for each instruction set by design.
headers = sorted(str(path.relative_to(options.source)) for path in (options.source / options.folder).rglob('*.h'))
headers = [h for h in headers if not h.endswith('-inl.h') and not re.search(options.exclude, h)]
total = len(headers)
if chosen := os.environ.get('SINEW_HEADERS'):
    headers = sorted(set(headers) & set(pathlib.Path(chosen).read_text().split()))
with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
    answers = pool.map(lambda h: compile_text(f'#include "{h}"\n' * 2, '-fsyntax-only', '-include', precompiled), headers)
    bad = [(h, a.stderr) for h, a in zip(headers, answers) if a.returncode]
for header, errors in bad:
    print(f'{header} does not compile alone:\n{errors}')
print(f'{options.folder}: {len(headers)} of {total} headers, {len(bad)} of them do not compile alone')
sys.exit(1 if bad or not total else 0)
