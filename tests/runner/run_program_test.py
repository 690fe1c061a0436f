#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""usage: run_program_test.py FAULTY-PROGRAM"""
import json
import os
import subprocess
import sys
import tempfile
import unittest

RUNNER = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'run_program.py')
PROGRAM = os.path.abspath(sys.argv.pop())
ALL = {'SharedSetup.passes', 'fates.passes_with_words_before_its_verdict', 'fates.fails', 'fates.is_skipped', 'fates.dies',
       'fates.leaves_with_success', 'fates.hangs', 'fates.says_that_another_test_fails', 'fates.passes_at_last', 'kinds/Numbered.is_even/0',
       'kinds/Numbered.is_even/1'}
FAIL = {'fates.fails', 'fates.dies', 'fates.leaves_with_success', 'kinds/Numbered.is_even/1'}


def run(*arguments, program=PROGRAM, **environment):
    """The exit status, what was printed, and test -> verdict."""
    with tempfile.TemporaryDirectory() as folder:
        clean = {k: v for k, v in os.environ.items() if not k.startswith('SINEW_')}
        done = subprocess.run([sys.executable, RUNNER, '--name', 'p', '--results', f'{folder}/r.json', *arguments, '--', program],
                              env={**clean, **environment}, capture_output=True, text=True, timeout=60)
        with open(f'{folder}/r.json', encoding='utf-8') as file:
            return done.returncode, done.stdout, {n.removeprefix('p/'): v for n, v in json.load(file).items()}


def in_state(verdicts, state):
    return {n for n, v in verdicts.items() if v['state'] == state}


class RunProgram(unittest.TestCase):
    def test_each_test_gets_one_verdict(self):
        status, text, verdicts = run()
        self.assertEqual(status, 1)
        self.assertEqual(set(verdicts), ALL)
        self.assertEqual(in_state(verdicts, 'failed'), FAIL)
        self.assertEqual(in_state(verdicts, 'skipped'), {'fates.is_skipped'})
        self.assertIn('p: 6 passed, 4 failed, 1 skipped', text)

    def test_what_failed_is_named_with_its_output(self):
        _, text, _ = run()
        for part in ('FAILED p/fates.dies\n    last words\n', 'the program died in it: SIGABRT', 'one is not two',
                     'FAILED p/fates.leaves_with_success', 'the program ended in it, with status 0', 'SKIPPED p/fates.is_skipped', 'no such device'):
            self.assertIn(part, text)
        self.assertNotIn('no line ends here', text)

    def test_a_test_that_hangs_fails_and_the_next_ones_run(self):
        status, text, verdicts = run('--limit', '1', HANG='1')
        self.assertEqual(status, 1)
        self.assertEqual(in_state(verdicts, 'failed'), FAIL | {'fates.hangs'})
        self.assertIn('took too long', text)

    def test_a_failure_outside_of_tests_fails(self):
        status, text, verdicts = run(SINEW_TESTS='SharedSetup', FAIL_OUTSIDE='1')
        self.assertEqual(status, 1)
        self.assertEqual(in_state(verdicts, 'passed'), {'SharedSetup.passes'})
        self.assertEqual(verdicts['']['state'], 'failed')
        self.assertIn('the suite cannot be torn down', text)

    def test_a_skipped_test_fails_when_none_may_be(self):
        self.assertEqual(run(SINEW_TESTS='is_skipped')[0], 0)
        self.assertEqual(run(SINEW_TESTS='is_skipped', SINEW_NO_SKIPS='1')[0], 1)

    def test_expressions_choose_by_the_whole_name(self):
        status, _, verdicts = run(SINEW_TESTS='^p/fates.passes', SINEW_NOT_TESTS='at_last')
        self.assertEqual((status, set(verdicts)), (0, {'fates.passes_with_words_before_its_verdict'}))

    def test_shards_are_all_tests_once(self):
        parts = [set(run('--shard', f'{i}/3')[2]) for i in (1, 2, 3)]
        self.assertEqual(set().union(*parts), ALL)
        self.assertEqual(sum(map(len, parts)), len(ALL))

    def test_a_program_that_cannot_be_started_fails(self):
        done = subprocess.run([sys.executable, RUNNER, '--name', 'p', '--', PROGRAM + '.not'], capture_output=True)
        self.assertNotEqual(done.returncode, 0)


if __name__ == '__main__':
    unittest.main()
