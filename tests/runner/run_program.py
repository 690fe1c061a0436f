#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the tests of one GoogleTest program in one process, and gives each of them a verdict.

A process that dies, hangs or leaves early fails the test that ran, and a new process runs the tests behind it. The exit status is 0 when
every test has passed or was skipped. The environment narrows the run: SINEW_TESTS and SINEW_NOT_TESTS are regular expressions of
PROGRAM/suite.test, and SINEW_NO_SKIPS=1 makes a skipped test a failure."""
import argparse
import json
import os
import re
import selectors
import signal
import subprocess
import sys
import tempfile
import time

BEGIN = re.compile(r'\[ RUN      \] (\S+)\s*$')
END = re.compile(r'\[(       OK |  FAILED  |  SKIPPED )\] (\S+?)(, where | \(\d+ ms\))')
STATES = {'OK': 'passed', 'FAILED': 'failed', 'SKIPPED': 'skipped'}
FRAME = re.compile(r'\[(-{10}|={10}|  PASSED  )\]|Note: Google Test filter')


def list_tests(command):
    """The names of all tests of a program, in its order. Disabled tests are left out."""
    listing = subprocess.run([*command, '--gtest_list_tests'], check=True, capture_output=True, text=True, timeout=120).stdout
    names, suite = [], ''
    for line in listing.splitlines():
        word = line.split('#')[0].strip()
        if line.startswith('  ') and word:
            names.append(suite + word)
        elif re.fullmatch(r'\S+\.', word):
            suite = word
    return [n for n in names if not n.startswith('DISABLED_') and '/DISABLED_' not in n and '.DISABLED_' not in n]


def wanted(program, names, environment=os.environ):
    """Those of the names that SINEW_TESTS and SINEW_NOT_TESTS leave."""
    only, but = environment.get('SINEW_TESTS'), environment.get('SINEW_NOT_TESTS')
    return [n for n in names if (not only or re.search(only, f'{program}/{n}')) and not (but and re.search(but, f'{program}/{n}'))]


def shard(names, number, count):
    """One of `count` parts. Tests of a suite stay together, since they share what the suite sets up."""
    suites = {}
    for name in names:
        suites.setdefault(name.rsplit('.', 1)[0].split('/')[0], []).append(name)
    parts = [[] for _ in range(count)]
    for suite in sorted(suites.values(), key=len, reverse=True):
        min(parts, key=len).extend(suite)
    part = set(parts[number - 1])
    return [n for n in names if n in part]


class Run:
    """One process of the program, and the verdicts that it gave."""

    def __init__(self, command, names, limit):
        self.names, self.verdicts, self.current, self.block, self.since = set(names), {}, None, [], time.monotonic()
        self.outside = []  # lines that belong to no test
        with tempfile.NamedTemporaryFile('w', suffix='.flags') as flags:  # a filter of all names is too long for an argument
            flags.write('--gtest_filter=' + ':'.join(names) + '\n')
            flags.flush()
            process = subprocess.Popen([*command, '--gtest_color=no', f'--gtest_flagfile={flags.name}'], stdin=subprocess.DEVNULL,
                                       stdout=subprocess.PIPE, stderr=subprocess.STDOUT, start_new_session=True)
            self.late = self.read(process, limit)
            self.status = process.wait()
            end_group(process)
        if self.current:
            self.settle('failed', f'{self.current}: {self.fate()}')

    def read(self, process, limit):
        """Reads until the program is gone. True when one test took longer than the limit."""
        with selectors.DefaultSelector() as selector:
            selector.register(process.stdout, selectors.EVENT_READ)
            rest = b''
            while True:
                left = self.since + limit - time.monotonic()
                ready = selector.select(min(max(left, 0), 1))
                if ready:
                    some = os.read(process.stdout.fileno(), 1 << 16)
                    if not some:
                        return False
                    *lines, rest = (rest + some).split(b'\n')
                    for line in lines:
                        self.line(line.decode(errors='replace'))
                elif left <= 0:
                    end_group(process)
                    return True
                elif process.poll() is not None:  # a program that it started holds the pipe
                    return False

    def line(self, line):
        begin, end = BEGIN.search(line), END.search(line)
        if begin and begin[1] in self.names and begin[1] != self.current:
            if self.current:
                self.settle('failed', f'{self.current}: the program gave no verdict')
            self.current, self.block, self.since = begin[1], [], time.monotonic()
        elif end and end[2] == self.current:
            before = line[:end.start()]
            self.settle(STATES[end[1].strip()], *([before] if before else []))
        elif self.current:
            self.block.append(line)
        elif line and not FRAME.match(line):
            self.outside.append(line)

    def settle(self, state, *lines):
        self.verdicts[self.current] = {'state': state, 'seconds': round(time.monotonic() - self.since, 3),
                                       'output': [] if state == 'passed' else self.block + list(lines)}
        self.current, self.block, self.since = None, [], time.monotonic()

    def fate(self):
        if self.late:
            return 'took too long and was ended'
        if self.status < 0:
            return f'the program died in it: {signal.Signals(-self.status).name}'
        return f'the program ended in it, with status {self.status}'


def end_group(process):
    """Ends the program and what it started."""
    try:
        os.killpg(process.pid, signal.SIGKILL)
    except ProcessLookupError:
        pass


def run_all(command, names, limit):
    """The verdict of each name, in their order; a last one by the name '' when the program failed outside of its tests."""
    verdicts, left, outside = {}, list(names), None
    while left:
        run = Run(command, left, limit)
        verdicts.update(run.verdicts)
        still = [n for n in left if n not in verdicts]
        fell = any(v['state'] == 'failed' for v in run.verdicts.values())
        if run.status != 0 and not fell and not outside:
            outside = {'state': 'failed', 'seconds': 0, 'output': run.outside + [f'outside of a test: {run.fate()}']}
        if len(still) == len(left):  # it runs none of them
            for name in still:
                verdicts[name] = {'state': 'failed', 'seconds': 0, 'output': run.outside + [f'{name}: was not run, {run.fate()}']}
            break
        left = still
    found = {n: verdicts[n] for n in names}
    if outside:
        found[''] = outside
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--name', required=True, help='what stands before the names of the tests')
    parser.add_argument('--shard', default='1/1', help='NUMBER/COUNT: which part of the tests')
    parser.add_argument('--limit', type=float, default=900, help='seconds that one test may take')
    parser.add_argument('--results', help='JSON file for the verdicts')
    parser.add_argument('--except', dest='but', default='', help='a regular expression of tests that are not run')
    parser.add_argument('command', nargs='+', help='the program, behind its emulator where there is one')
    options = parser.parse_args()
    number, count = (int(part) for part in options.shard.split('/'))
    names = wanted(options.name, list_tests(options.command))
    if options.but:
        names = [n for n in names if not re.search(options.but, f'{options.name}/{n}')]
    names = shard(names, number, count)
    verdicts = run_all(options.command, names, options.limit)
    if options.results:
        os.makedirs(os.path.dirname(options.results), exist_ok=True)
        with open(options.results, 'w', encoding='utf-8') as file:
            json.dump({f'{options.name}/{n}': v for n, v in verdicts.items()}, file)
    no_skips = os.environ.get('SINEW_NO_SKIPS') == '1'
    bad = [n for n, v in verdicts.items() if v['state'] == 'failed' or (no_skips and v['state'] == 'skipped')]
    for name, verdict in verdicts.items():
        if verdict['state'] != 'passed':
            print('\n'.join([f'{verdict["state"].upper()} {options.name}/{name}', *('    ' + line for line in verdict['output'])]))
    states = [v['state'] for v in verdicts.values()]
    print(f'{options.name}: ' + ', '.join(f'{states.count(s)} {s}' for s in ('passed', 'failed', 'skipped') if s in states))
    return 1 if bad else 0


if __name__ == '__main__':
    sys.exit(main())
