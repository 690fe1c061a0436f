#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Lines and branches that the tests have run, by folder. tests/coverage/README.md explains."""
import argparse
import collections
import concurrent.futures
import functools
import json
import os
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
PRODUCT = ('runtime/', 'importer/', 'viewer/')


def arguments():
    parser = argparse.ArgumentParser(prog='./run coverage', description=__doc__)
    parser.add_argument('build', help='a build with --coverage whose tests have run')
    parser.add_argument('--lines', action='store_true', help='name each line that no test runs, and that unreached.txt does not list')
    parser.add_argument('--check', action='store_true', help='fail when there is such a line, or when one is listed that tests run')
    return parser.parse_args()


@functools.cache
def text_of(path):
    with open(path, encoding='utf-8') as file:
        return [line.strip() for line in file]


def decisions(branches):
    """Counts of the branches that the source decides. A call that may throw has two as well: going on, and the exception."""
    kept = []
    for branch in branches:
        if branch['throw']:
            kept.pop()
        else:
            kept.append(branch['count'])
    return tuple(kept)


def counts_of(build, notes, root):
    """[(file, line, count, function's place, counts of branches)] of one object, all 0 where no program has run that holds it. Lines
    without a word are left out: at a closing brace stands what the compiler does when an exception leaves the block."""
    done = subprocess.run(['gcov', '--json-format', '--stdout', '--branch-probabilities', notes], cwd=build, capture_output=True, check=True, text=True)
    found = []
    for document in done.stdout.splitlines():
        for file in json.loads(document)['files']:
            path = os.path.relpath(os.path.join(build, file['file']), root)
            if path.startswith(PRODUCT) and os.path.exists(os.path.join(root, path)):  # an object stays when its source moves away
                text = text_of(os.path.join(root, path))
                places = {f['name']: (f['start_line'], f['start_column']) for f in file['functions']}
                found += [(path, line['line_number'], line['count'], places.get(line.get('function_name')), decisions(line['branches']))
                          for line in file['lines'] if any(c.isalnum() for c in text[line['line_number'] - 1])]
    return found


def collect(build, root=ROOT):
    """{(file, line): count} and {(file, line): [count of each branch]} over all copies: templates, inline functions and kernels are
    compiled more than once. Copies of a function have its place; where their branches differ in number, those of the copy that has run
    and has most count."""
    notes = [f'{folder}/{name}' for folder, _, names in os.walk(build) for name in names
             if name.endswith('.gcno') and name.replace('.gcno', '.o') in names]  # a build that was stopped leaves some without
    lines, copies = collections.Counter(), {}
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for found in pool.map(lambda n: counts_of(build, n, root), notes):
            for path, number, count, place, taken in found:
                lines[path, number] += count
                known = copies.setdefault((path, number), {}).get(place, ())
                same = len(known) == len(taken)
                copies[path, number][place] = tuple(map(sum, zip(known, taken))) if same else max(known, taken, key=lambda t: (any(t), len(t)))
    return lines, {key: [count for taken in of_line.values() for count in taken] for key, of_line in copies.items()}


def read_list(path):
    """{(file, text of a line): reason} of `FILE: TEXT # REASON`."""
    with open(path, encoding='utf-8') as file:
        entries = (line.strip().rsplit(' # ', 1) for line in file if line.strip() and not line.startswith('#'))
        return {tuple(entry.split(': ', 1)): reason for entry, reason in entries}


def missed(lines, listed, root=ROOT):
    """Lines that no test runs, as [(file, line, text, entry of the list or None)]. An entry stands for the lines that follow it, too,
    up to the next one that ran."""
    found, entry = [], None
    for path, number in sorted(lines):
        if lines[path, number]:
            entry = None
            continue
        text = text_of(os.path.join(root, path))[number - 1]
        if (path, text) in listed:
            entry = path, text
        elif entry is not None and entry[0] != path:
            entry = None
        found.append((path, number, text, entry))
    return found


def table(lines, branches, unlisted):
    rows = collections.defaultdict(collections.Counter)
    for (path, number), count in lines.items():
        folder = '/'.join(os.path.dirname(path).split('/')[:2])
        for name in {folder if '/' in folder else f'{folder} (top)', f'**{path.split("/")[0]}**', '**all**'}:
            rows[name] += collections.Counter(lines=1, run=count > 0, unlisted=(path, number) in unlisted, branches=len(branches[path, number]),
                                              taken=sum(taken > 0 for taken in branches[path, number]))
    percent = lambda some, whole: f'{100 * some / whole:.1f} %' if whole else ''
    text = ['| folder | lines | run | neither run nor listed | branches | taken |', '|---|---|---|---|---|---|']
    for name, row in sorted(rows.items(), key=lambda item: (item[0] == '**all**', item[0].strip('*'))):
        text.append(f'| {name} | {row["lines"]} | {percent(row["run"], row["lines"])} | {row["unlisted"]} | {row["branches"]} '
                    f'| {percent(row["taken"], row["branches"])} |')
    return '\n'.join(text)


def main():
    options = arguments()
    lines, branches = collect(os.path.abspath(options.build))
    if not any(lines.values()):
        sys.exit(f'{options.build} holds no counts: build it with --coverage and run its tests')
    listed = read_list(f'{HERE}/unreached.txt')
    found = missed(lines, listed)
    unlisted = {(path, number): text for path, number, text, entry in found if entry is None}
    needless = listed.keys() - {entry for *_, entry in found}
    if options.lines:
        for (path, number), text in unlisted.items():
            print(f'{path}:{number}: {text}')
    for path, text in sorted(needless):
        print(f'unreached.txt lists what tests run, or what is gone: {path}: {text}')
    print(table(lines, branches, unlisted))
    return options.check and bool(unlisted or needless)


if __name__ == '__main__':
    sys.exit(main())
