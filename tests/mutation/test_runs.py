# SPDX-License-Identifier: MIT
"""Runs the tests that reach a mutant, the quick ones of its own folder first, until one falls."""
import math
import os
import resource
import signal
import subprocess
import threading

QUICK_MS = 150
SLOW_LIMIT_MS = 60_000  # one test that takes longer is for other days
MEMORY = 12 << 30
FILE_SIZE = 8 << 30  # tests of long archives write more than 4 GiB, most of it holes
BUSY = 6  # on a busy machine this many times the usual time passes by the clock


def limits(seconds):
    os.setsid()
    processor = math.ceil(seconds * os.cpu_count())
    resource.setrlimit(resource.RLIMIT_CPU, (processor, processor + 5))
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    resource.setrlimit(resource.RLIMIT_FSIZE, (FILE_SIZE, FILE_SIZE))


class Programs:
    """The test programs of one mutated build, and which tests reach which mutant."""

    def __init__(self, build, corpus, own_only=False):
        self.build, self.tree, self.own_only = build, build.tree, own_only
        # Files that others may not have do not count: the tests that read them have models of the project.
        self.environment = {} if corpus else {'SINEW_CORPUS': f'{build.folder}/no_corpus'}
        self.records, self.broken, self.lock = {}, [], threading.Lock()

    def run(self, program, seconds, arguments, environment):
        """True, False or 'time': whether it passed. `seconds` are of each processor, so that no other program makes a test late."""
        folder = f'{self.build.folder}/run'
        os.makedirs(folder, exist_ok=True)
        process = subprocess.Popen([program, *arguments], cwd=folder, env={**os.environ, 'TMPDIR': folder, **self.environment, **environment},
                                   preexec_fn=lambda: limits(seconds), stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            status = process.wait(BUSY * seconds)
            return 'time' if status == -signal.SIGXCPU else status == 0
        except subprocess.TimeoutExpired:
            return 'time'
        finally:
            try:
                os.killpg(process.pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
            process.wait()

    def record(self, name):
        """Runs all tests of a program once as they are: [(test, milliseconds, numbers and shaders that it reaches)]."""
        with self.lock:  # the first worker that needs a program builds it, the others wait
            if name not in self.records:
                self.records[name] = self.record_now(name)
            return self.records[name]

    def record_now(self, name):
        program, found = self.build.program(name), []
        if program is not None:
            out = f'{self.build.folder}/{name}.reached'
            self.run(program, 1800, [], {'SINEW_MUTANT': '-1', 'SINEW_MUTATION_RECORD': out})
            with open(out, encoding='utf-8') as file:
                *lines, last = file.read().splitlines() or ['']
                if last != 'end':  # the tests behind it would not count as tests of any mutant
                    self.broken.append(f'{name} ends behind {last.split(" ")[0] or "nothing"}, and all tests that follow')
                    lines.append(last)
                for line in lines:
                    test, state, milliseconds, *reached = line.split() or ('', '', '0')
                    if state == 'passed' and int(milliseconds) < SLOW_LIMIT_MS:
                        found.append((test, int(milliseconds), frozenset(int(r) if r.isdigit() else r for r in reached)))
                    elif state == 'failed':
                        self.broken.append(f'{name}: {test}')
        return found

    def fall(self, name, tests, environment):
        """The first of the tests that falls, as far as one can tell; None when all pass."""
        program = self.build.program(name)
        for first in range(0, len(tests), 400):
            part = tests[first:first + 400]
            seconds = 10 + 10 * sum(t[1] for t in part) / 1000
            filter_ = '--gtest_filter=' + ':'.join(t[0] for t in part)
            passed = self.run(program, seconds, [filter_, '--gtest_fail_fast'], environment)
            if passed is not True:
                return name + (': time' if passed == 'time' else '')
        return None

    def verdict(self, number, mutant, environment, reaches):
        """('killed', by) | ('survived', n tests) | ('unreached', '')"""
        own = self.tree.tests_of_room(mutant.file)
        others = [] if self.own_only else [name for name in sorted(self.tree.programs) if name not in own]
        tried = 0
        for names in (own, others):
            for quick in (True, False):
                for name in names:
                    tests = [t for t in self.record(name) if (t[1] <= QUICK_MS) == quick and reaches(t, number)]
                    tried += len(tests)
                    if tests and (by := self.fall(name, tests, environment)):
                        return 'killed', by
        return ('survived', f'{tried} tests') if tried else ('unreached', '')

    def verdict_alone(self, mutant):
        """The same of a program that has the mutant in place: all tests of each program, from the start."""
        own = self.tree.tests_of_room(mutant.file)
        for name in own + [name for name in sorted(self.tree.programs) if name not in own]:
            program = self.build.program(name)
            if program and self.run(program, 1800, ['--gtest_fail_fast'], {}) is not True:
                return 'killed', name
        return 'survived', 'all tests'
