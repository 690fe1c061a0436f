#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""`./run test`: runs CTest on a build, and counts each test of each program.

CTest knows a program as one test, which run_program.py runs. This script lets a person choose single tests by name (-R, -E), and ends with
the names of those that failed and one line: how many passed, failed and were skipped."""
import argparse
import glob
import json
import os
import re
import shutil
import subprocess
import sys
import time
import xml.etree.ElementTree

from run_program import list_tests


def entries_of(build):
    """The tests that CTest knows: name -> command, a list that is empty where the program is not built."""
    shown = subprocess.run(['ctest', '--test-dir', build, '--show-only=json-v1'], check=True, capture_output=True, text=True).stdout
    return {t['name']: t.get('command', []) for t in json.loads(shown)['tests']}


def program_of(command):
    """The program behind run_program.py as its name and its command; None for other tests."""
    if not any(word.endswith('/run_program.py') for word in command):
        return None
    return command[command.index('--name') + 1], command[command.index('--') + 1:]


def chosen_entries(entries, only, but):
    """Entries of CTest in which a test has a name that is asked for."""
    def is_wanted(name):
        return (not only or re.search(only, name)) and not (but and re.search(but, name))
    programs, chosen = {}, []
    for entry, command in entries.items():
        program = program_of(command)
        if program is None:
            wanted = is_wanted(entry)
        else:
            name, command = program
            if name not in programs:
                built = os.path.exists(command[-1])
                programs[name] = any(is_wanted(f'{name}/{test}') for test in list_tests(command)) if built else is_wanted(f'{name}/')
            wanted = programs[name]
        if wanted:
            chosen.append(entry)
    return chosen


def verdicts_of(build, junit):
    """Name -> (state, seconds) of each test that was run: those of programs as run_program.py wrote them, and CTest's own."""
    found, programs = {}, set()
    for path in glob.glob(f'{build}/test_results/*.json'):
        programs.add(os.path.basename(path).removesuffix('.json'))
        with open(path, encoding='utf-8') as file:
            for name, verdict in json.load(file).items():
                found[name] = verdict['state'], verdict['seconds']
    for case in xml.etree.ElementTree.parse(junit).getroot().iter('testcase'):
        name, status, skipped = case.get('name'), case.get('status'), case.find('skipped')
        if status == 'run':
            state = 'passed'
        elif status == 'notrun' and skipped is not None and skipped.get('message', '').startswith('SKIP_'):
            state = 'skipped'
        else:
            state = 'failed'
        if name not in programs:
            found[name] = state, float(case.get('time') or 0)
    return found


def main():
    parser = argparse.ArgumentParser(prog='./run test', description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('build', help=argparse.SUPPRESS)
    parser.add_argument('-j', '--jobs', default=str(os.cpu_count()), help=argparse.SUPPRESS)
    parser.add_argument('-R', dest='only', metavar='REGEX', help='only tests whose names match: pose/sample_clip, corpus, G06')
    parser.add_argument('-E', dest='but', metavar='REGEX', help='no tests whose names match')
    parser.add_argument('-N', dest='names', action='store_true', help='print the names of the tests and run none')
    parser.add_argument('--programs', metavar='NAME,...', help='only the tests of these programs')
    parser.add_argument('--no-skips', action='store_true', help='a skipped test fails')
    options, for_ctest = parser.parse_known_args()
    build, started = os.path.abspath(options.build), time.monotonic()
    environment = dict(os.environ)
    select = []
    if options.only or options.but or options.programs or options.names:
        entries = entries_of(build)
        if options.programs:
            programs = options.programs.split(',')
            entries = {e: c for e, c in entries.items() if (program_of(c) or ('',))[0] in programs}
        chosen = chosen_entries(entries, options.only, options.but)
        if options.names:
            for entry in chosen:
                program = program_of(entries[entry])
                print('\n'.join(f'{program[0]}/{test}' for test in list_tests(program[1])) if program else entry)
            return 0
        if not chosen:
            print('no test has such a name', file=sys.stderr)
            return 1
        select = ['-R', '^(' + '|'.join(re.sub(r'([.+*()$])', r'[\1]', entry) for entry in chosen) + ')$']
    if options.only:
        environment['SINEW_TESTS'] = options.only
    if options.but:
        environment['SINEW_NOT_TESTS'] = options.but
    if options.no_skips:
        environment['SINEW_NO_SKIPS'] = '1'
    shutil.rmtree(f'{build}/test_results', ignore_errors=True)
    os.makedirs(f'{build}/test_results')
    junit = f'{build}/test_results/ctest.xml'
    status = subprocess.run(['ctest', '--test-dir', build, '--output-on-failure', '--no-tests=error', '-j', options.jobs, '--output-junit', junit,
                             *select, *for_ctest], env=environment).returncode
    if not os.path.exists(junit):
        return status or 1
    verdicts = verdicts_of(build, junit)
    states = [state for state, _ in verdicts.values()]
    for name, (state, seconds) in sorted(verdicts.items()):
        if state != 'passed':
            print(f'{state.upper():7} {name} ({seconds:.1f} s)')
    print(f'{states.count("passed")} passed, {states.count("failed")} failed, {states.count("skipped")} skipped '
          f'in {(time.monotonic() - started) / 60:.1f} minutes')
    bad = states.count('failed') + (states.count('skipped') if options.no_skips else 0)
    return status or (1 if bad else 0)


if __name__ == '__main__':
    sys.exit(main())
