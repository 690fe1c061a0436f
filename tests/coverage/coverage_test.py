#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tests of the tool on a project of three sources, compiled as preset coverage says: coverage_test.py COMPILER."""
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest

import coverage

HERE = os.path.dirname(os.path.abspath(__file__))
COMPILER = sys.argv.pop()
SOURCE, HEADER, UNUSED = 'runtime/small.cpp', 'runtime/halves.h', 'runtime/unlinked.cpp'


def flags_of_preset():
    with open(f'{coverage.ROOT}/CMakePresets.json', encoding='utf-8') as file:
        preset, = (p for p in json.load(file)['configurePresets'] if p['name'] == 'coverage')
    return re.sub("-fprofile-exclude-files='[^']*'", '-fprofile-exclude-files=main.cpp', preset['cacheVariables']['CMAKE_CXX_FLAGS_RELWITHDEBINFO']).split()


class CoverageTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.root = f'{HERE}/example'
        for source in ('tests/main.cpp', SOURCE, UNUSED):
            object_ = f'{cls.folder.name}/{os.path.basename(source)}.o'
            subprocess.run([COMPILER, *flags_of_preset(), '-std=c++20', f'-I{cls.root}', '-c', f'{cls.root}/{source}', '-o', object_], check=True, cwd=cls.folder.name)
        program = f'{cls.folder.name}/program'
        subprocess.run([COMPILER, '--coverage', f'{cls.folder.name}/main.cpp.o', f'{cls.folder.name}/small.cpp.o', '-o', program], check=True)
        subprocess.run([program], check=True)
        cls.lines, cls.branches = coverage.collect(cls.folder.name, cls.root)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def missed_texts(self, listed=()):
        return [(path, text, entry) for path, _, text, entry in coverage.missed(self.lines, listed, self.root)]

    def test_a_line_ran_when_one_copy_of_it_did(self):
        self.assertNotIn(HEADER, {path for path, *_ in self.missed_texts()})

    def test_lines_that_end_in_the_same_way_are_told_apart_and_objects_that_no_program_holds_count(self):
        self.assertEqual([(path, text) for path, text, _ in self.missed_texts()],
                         [(SOURCE, 'return false;'), (UNUSED, 'int unlinked(int x) {'), (UNUSED, 'x += 1;'), (UNUSED, 'return x;')])

    def test_branches_are_those_of_conditions_and_not_of_calls_that_may_throw(self):
        of = lambda path: sorted(taken for (p, _), of_line in self.branches.items() if p == path for taken in of_line)
        self.assertEqual(of(SOURCE), [0, 1])  # the call of half() has none
        self.assertEqual(of(HEADER), [1, 1])  # each copy took one

    def test_an_entry_of_the_list_stands_for_what_follows_it_in_vain(self):
        entry = (UNUSED, 'int unlinked(int x) {')
        self.assertEqual([e for *_, e in self.missed_texts({entry: 'a reason'})], [None, entry, entry, entry])

    def test_the_table_adds_up_folders(self):
        unlisted = {(path, number) for path, number, *_ in coverage.missed(self.lines, {}, self.root)}
        rows = dict(row.strip('| ').split(' | ', 1) for row in coverage.table(self.lines, self.branches, unlisted).splitlines()[2:])
        self.assertEqual(rows['**all**'], f'{len(self.lines)} | {100 * (len(self.lines) - 4) / len(self.lines):.1f} % | 4 | 4 | 75.0 %')
        self.assertEqual(rows['runtime (top)'], rows['**runtime**'])

    def test_the_list_of_this_project_can_be_read_and_names_files_and_lines_that_exist(self):
        for (path, text), reason in coverage.read_list(f'{HERE}/unreached.txt').items():
            self.assertIn(text, coverage.text_of(f'{coverage.ROOT}/{path}'), path)
            self.assertTrue(reason)


if __name__ == '__main__':
    unittest.main()
