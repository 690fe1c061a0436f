#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tests of the mutation tester, on a project of one source, one test and one shader."""
import os
import subprocess
import sys
import tempfile
import unittest

try:
    import clang.cindex
except ImportError:
    print('skipped: python3-clang is not installed')
    sys.exit(77)

import changes
import mutant as mutants_of
import places_cpp
import places_glsl
from build_tree import Tree
from mutated_build import MutatedBuild, compile_shaders
from test_runs import Programs

EXAMPLE = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'example')
SOURCE, HEADER, SHADER = 'runtime/tiny/clamp_and_sum.cpp', 'runtime/tiny/tiny.h', 'viewer/shaders/tiny.frag'


class MutationTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        build = f'{cls.folder.name}/build'
        for command in (['cmake', '-G', 'Ninja', '-S', EXAMPLE, '-B', build, '-DCMAKE_BUILD_TYPE=Release'], ['cmake', '--build', build]):
            subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        cls.tree = Tree(EXAMPLE, build)
        object_ = cls.tree.product_object(SOURCE)
        found, errors = places_cpp.places(f'{EXAMPLE}/{SOURCE}', [SOURCE, HEADER], cls.tree.commands[object_], EXAMPLE)
        assert not errors, errors
        everything = found[SOURCE] + found[HEADER]
        mutants_of.give_keys(everything)
        cls.mutants = [m for m in everything if m.before]
        cls.constants = [m for m in everything if not m.before]

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_only_code_that_runs_is_mutated(self):
        places = {(m.function, m.kind, m.original, m.shown) for m in self.mutants}
        self.assertEqual(places, {
            ('two', 'arithmetic', 'x + 2', 'x - 2'), ('two', 'constant', '2', '3'),
            ('clamped', 'condition', 'value < low', '!(value < low)'), ('clamped', 'condition', 'value < low', 'false'),
            ('clamped', 'condition', 'value < low', 'true'), ('clamped', 'comparison', 'value < low', 'value <= low'),
            ('clamped', 'arithmetic', 'std::min(value, high) + kLocal - kFour', 'std::min(value, high) + kLocal + kFour'),
            ('clamped', 'arithmetic', 'std::min(value, high) + kLocal', 'std::min(value, high) - kLocal'),
            ('clamped', 'call', 'std::min(value, high)', 'std::max(value, high)'),
            ('tripled', 'arithmetic', '3 * x', '3 / x'), ('tripled', 'constant', '3', '4'),
            ('count_in_three', 'constant', '0', '1'), ('count_in_three', 'constant', '3', '4'),
            ('count_in_three', 'comparison', 'i < 3', 'i <= 3'), ('count_in_three', 'index', 'i', '(i) + 1'),
            ('count_in_three', 'comparison', 'kThree.numbers[i] == value', 'kThree.numbers[i] != value'),
            ('count_in_three', 'condition', 'kThree.numbers[i] == value', 'false'), ('count_in_three', 'condition', 'kThree.numbers[i] == value', 'true'),
            ('count_in_three', 'statement', '++found', '(nothing)'),
            ('sum', 'arithmetic', 'kTable[0] - 1', 'kTable[0] + 1'), ('sum', 'constant', '0', '1'),
            ('sum', 'constant', '1', '2'), ('sum', 'comparison', 'i < count', 'i <= count'),
            ('sum', 'statement', 'total += numbers[i]', '(nothing)'), ('sum', 'arithmetic', 'total += numbers[i]', 'total -= numbers[i]'),
            ('sum', 'index', 'i', '(i) + 1'), ('sum', 'condition', 'total > 1000', '!(total > 1000)'),
            ('sum', 'condition', 'total > 1000', 'false'), ('sum', 'condition', 'total > 1000', 'true'),
            ('sum', 'comparison', 'total > 1000', 'total >= 1000'), ('sum', 'constant', '1000', '1001'),
            ('twice_apart', 'arithmetic', '2 * (a < b ? b - a : a - b)', '2 / (a < b ? b - a : a - b)'),
            ('twice_apart', 'constant', '2', '3'), ('twice_apart', 'condition', 'a < b', '!(a < b)'),
            ('twice_apart', 'comparison', 'a < b', 'a <= b'), ('twice_apart', 'arithmetic', 'b - a', 'b + a'),
            ('twice_apart', 'arithmetic', 'a - b', 'a + b')})

    def test_constants_are_built_alone(self):
        self.assertEqual({(m.function, m.original, m.mutated) for m in self.constants},
                         {('kFour', '3 + 1', '3 - 1'), ('kFour', '3', '4'), ('kFour', '1', '2'), ('clamped', '4', '5'), ('kUnread', '0.5', '1.0')})
        for m in [m for m in self.constants if m.original in ('3 + 1', '0.5')]:
            build = MutatedBuild(self.tree, f'{self.folder.name}/constant', {1: m}, 2, switched=False)
            expected = 'killed' if m.function == 'kFour' else 'survived'
            self.assertEqual(Programs(build, corpus=True).verdict_alone(m)[0], expected, str(m))

    def test_verdicts_are_known_and_the_same_with_switches_and_alone(self):
        switched = MutatedBuild(self.tree, f'{self.folder.name}/switched', dict(enumerate(self.mutants, 1)), 2)
        programs = Programs(switched, corpus=True)
        reaches = lambda test, number: number in test[2]
        together = {m.key: programs.verdict(n, m, {'SINEW_MUTANT': str(n)}, reaches)[0] for n, m in enumerate(self.mutants, 1)}
        self.assertEqual(switched.stillborn, set())
        for m in self.mutants:
            expected = 'unreached' if m.function in ('sum', 'two') else 'survived' if m.kind == 'comparison' else 'killed'
            if m.function == 'count_in_three':
                expected = 'killed'  # an index behind the end, too, though nothing there changes a result
            self.assertEqual(together[m.key], expected, str(m))
        alone = {}
        for m in self.mutants[::4]:
            build = MutatedBuild(self.tree, f'{self.folder.name}/alone', {1: m}, 2, switched=False)
            alone[m.key] = Programs(build, corpus=True).verdict_alone(m)[0]
        self.assertEqual(alone, {key: 'survived' if together[key] == 'unreached' else together[key] for key in alone})

    def test_others_than_the_tests_of_the_own_folder_are_left_out_where_that_is_asked_for(self):
        m = next(m for m in self.mutants if m.function == 'tripled')
        build = MutatedBuild(self.tree, f'{self.folder.name}/own', {1: m}, 2)
        reaches = lambda test, number: number in test[2]
        self.assertEqual(self.tree.tests_of_room(m.file), [], 'the program of the example lies beside its sources')
        for own_only, expected in ((True, 'unreached'), (False, 'killed')):
            self.assertEqual(Programs(build, True, own_only).verdict(1, m, {'SINEW_MUTANT': '1'}, reaches)[0], expected)

    def test_files_are_drawn_by_the_seed(self):
        files = [f'f{i}' for i in range(50)]
        self.assertEqual(mutants_of.drawn(files[::-1], 3, 10), mutants_of.drawn(files, 3, 10))
        self.assertNotEqual(mutants_of.drawn(files, 4, 10), mutants_of.drawn(files, 3, 10))
        self.assertEqual(mutants_of.drawn(files, 3, 99), sorted(files))
        self.assertEqual(len(set(mutants_of.drawn(files, 3, 10))), 10)

    def test_what_does_not_end_is_late_and_what_waits_for_others_is_not(self):
        programs = Programs(MutatedBuild(self.tree, f'{self.folder.name}/late', {}, 1), corpus=True)
        self.assertEqual(programs.run('/bin/sh', 0.3, ['-c', 'while :; do :; done'], {}), 'time')
        self.assertEqual(programs.run('/bin/sh', 0.3, ['-c', 'sleep 9'], {}), 'time')
        self.assertIs(programs.run('/bin/sh', 0.3, ['-c', 'sleep 1'], {}), True)
        self.assertIs(programs.run('/bin/sh', 0.3, ['-c', 'exit 1'], {}), False)

    def test_a_program_that_ends_early_while_it_is_recorded_is_told(self):
        script = f'{self.folder.name}/recorded'
        with open(script, 'w', encoding='utf-8') as file:
            file.write('#!/bin/sh\nprintf "a.first passed 1 7\\na.second passed 1\\n$ENDING" > "$SINEW_MUTATION_RECORD"\nkill -9 $$\n')
        os.chmod(script, 0o755)
        build = MutatedBuild(self.tree, f'{self.folder.name}/early', {}, 1)
        build.linked['early'] = build.linked['whole'] = script
        programs = Programs(build, corpus=True)
        self.assertEqual(programs.record('early'), [('a.first', 1, frozenset({7})), ('a.second', 1, frozenset())])
        self.assertEqual(programs.broken, ['early ends behind a.second, and all tests that follow'])
        programs.environment['ENDING'] = 'end\n'
        self.assertEqual(len(programs.record('whole')), 2)
        self.assertEqual(len(programs.broken), 1)

    def test_keys_stay_when_other_functions_change(self):
        with open(f'{EXAMPLE}/{SOURCE}', encoding='utf-8') as file:
            text = file.read().replace('int clamped(', 'int other(int x) { return x < 3 ? x + 1 : 0; }\n\nint clamped(')
        path = f'{self.folder.name}/{SOURCE}'
        os.makedirs(os.path.dirname(path))
        with open(path, 'w', encoding='utf-8') as file:
            file.write(text)
        command = self.tree.commands[self.tree.product_object(SOURCE)]
        found, _ = places_cpp.places(path, [SOURCE], command, self.folder.name)
        mutants_of.give_keys(found[SOURCE])
        before = {m.key for m in self.mutants + self.constants if m.file == SOURCE}
        self.assertEqual({m.key for m in found[SOURCE] if m.function != 'other'}, before)

    def test_shaders(self):
        found = places_glsl.places(f'{EXAMPLE}/{SHADER}', SHADER)
        shown = {m.shown for m in found}
        for part in ('!(c.x < 0.0)', '(c.x <= 0.0) return 0.0', '0.1)) + 1.0;', 'vec3( 0.7, 0.2 , 0.1)'):
            self.assertTrue(any(part in text for text in shown), f'{part} in {shown}')
        self.assertFalse(any('kGamma' in m.original or 'location' in m.original for m in found))
        compiled = [m for m in found if compile_shaders(EXAMPLE, f'{self.folder.name}/shader', m)]
        self.assertGreater(len(compiled), len(found) / 2)

    def test_lists_hold_reasons(self):
        with open(os.path.join(os.path.dirname(EXAMPLE), 'equivalent.txt'), encoding='utf-8') as file:
            for line in file:
                if line.strip() and not line.startswith('#'):
                    self.assertIn(' # ', line)


class ChangesTest(unittest.TestCase):
    """On a history of its own: each commit is a text of `a.cpp` or `notes.md`, and every line `a..` is a mutant."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = folder.name
        changes.git(self.root, 'init', '--quiet')
        self.commit('a.cpp', 'a1\na2\na3\n')

    def commit(self, name, text):
        with open(f'{self.root}/{name}', 'w', encoding='utf-8') as file:
            file.write(text)
        changes.git(self.root, 'add', '.')
        changes.git(self.root, '-c', 'user.name=a', '-c', 'user.email=a@b', 'commit', '--quiet', '-m', 'a')

    def newest(self):
        return [m.original for m in changes.newest(self.root, self.mutants_of)]

    def mutants_of(self, files):
        found = []
        for name in sorted(files & {'a.cpp'}):
            with open(f'{self.root}/{name}', encoding='utf-8') as file:
                found += [mutants_of.Mutant(name, line, 0, 0, 'constant', '', text, '', '', '', '')
                          for line, text in enumerate(file.read().splitlines(), 1) if text.startswith('a')]
        return found

    def test_lines_of_the_last_commit_alone(self):
        self.commit('a.cpp', 'a1\nb2\na3\na4\n')
        self.commit('a.cpp', 'a1\na2 again\na3\na4\na5\n')
        self.assertEqual(self.newest(), ['a2 again', 'a5'])

    def test_commits_without_mutants_lead_back_to_the_newest_with_some(self):
        self.commit('a.cpp', 'a0\na1\na2\na3\n')
        self.commit('a.cpp', 'a0\na1 other\na2\na3\n')
        self.commit('a.cpp', '// moved down\na0\na1 other\na2\n')  # a comment, and a line less
        self.commit('notes.md', 'a line\n')
        self.assertEqual([m.line for m in changes.newest(self.root, self.mutants_of)], [3])
        self.assertEqual(self.newest(), ['a1 other'])

    def test_a_commit_that_has_none_before_it_fails(self):
        with self.assertRaisesRegex(SystemExit, 'no commit before the last one'):
            self.newest()

    def test_a_history_without_mutants_fails(self):
        self.commit('notes.md', 'a line\n')
        with self.assertRaisesRegex(SystemExit, 'in which a mutant can be set'):
            self.newest()


if __name__ == '__main__':
    unittest.main()
