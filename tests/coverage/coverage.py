#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Lines and branches that the tests have run, by folder: coverage.py BUILD [--lines] (after the tests of a build with
--coverage have run). Kernels and inline functions are compiled more than once: a line counts as run when one of its copies was."""
import collections
import concurrent.futures
import json
import os
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PRODUCT = ('runtime/', 'importer/', 'viewer/')


def counts_of(build, data):
    """[(file, line, count, [counts of branches])] of one object."""
    done = subprocess.run(['gcov', '--json-format', '--stdout', '--branch-probabilities', data], cwd=build, capture_output=True, check=True, text=True)
    found = []
    for text in done.stdout.splitlines():
        for file in json.loads(text)['files']:
            path = os.path.relpath(os.path.join(build, file['file']), ROOT)
            if path.startswith(PRODUCT):
                # Branches that only an exception takes are the compiler's own.
                found += [(path, line['line_number'], line['count'], [b['count'] for b in line['branches'] if not b['throw']]) for line in file['lines']]
    return found


def collect(build):
    data = [os.path.join(folder, name) for folder, _, names in os.walk(build) for name in names if name.endswith('.gcda')]
    lines, branches = collections.defaultdict(int), {}
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for found in pool.map(lambda d: counts_of(build, d), data):
            for path, number, count, taken in found:
                lines[path, number] += count
                before = branches.setdefault((path, number), taken)
                if before is not taken and len(before) == len(taken):
                    branches[path, number] = [a + b for a, b in zip(before, taken)]
                elif len(taken) > len(before):
                    branches[path, number] = taken
    return lines, branches


def table(lines, branches):
    rows = collections.defaultdict(lambda: [0, 0, 0, 0])
    for (path, number), count in lines.items():
        for name in ('/'.join(os.path.dirname(path).split('/')[:2]), path.split('/')[0] + ' (all)', 'all'):
            row = rows[name]
            row[0] += 1
            row[1] += count > 0
            row[2] += len(branches[path, number])
            row[3] += sum(taken > 0 for taken in branches[path, number])
    text = ['| folder | lines | run | branches | taken |', '|---|---|---|---|---|']
    for name, row in sorted(rows.items(), key=lambda item: (item[0] == 'all', item[0])):
        part = lambda some, whole: f'{100 * some / whole:.1f} %' if whole else ''
        text.append(f'| {name} | {row[0]} | {part(row[1], row[0])} | {row[2]} | {part(row[3], row[2])} |')
    return '\n'.join(text)


def main():
    build = os.path.abspath(sys.argv[1])
    lines, branches = collect(build)
    if not lines:
        sys.exit(f'{build} holds no coverage data: build it with --coverage and run its tests')
    if '--lines' in sys.argv:
        for path, number in sorted(key for key, count in lines.items() if count == 0):
            print(f'{path}:{number}')
    print(table(lines, branches))


if __name__ == '__main__':
    main()
