#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Sets faults into the sources, one at a time, and tells which of them no test notices. tests/mutation/README.md explains."""
import argparse
import concurrent.futures
import dataclasses
import hashlib
import json
import os
import subprocess
import sys
import time

import changes
import places_glsl
import report
from build_tree import Tree
from mutant import Mutant, drawn, give_keys, in_clusters, in_sample_order
from mutated_build import MutatedBuild, compile_shaders, is_shader
from test_runs import Programs

HERE = os.path.dirname(os.path.abspath(__file__))
SOURCES = ('.cpp', '.h', '.glsl', '.frag', '.vert')


def arguments():
    parser = argparse.ArgumentParser(prog='./run mutate', description=__doc__)
    parser.add_argument('files', nargs='*', help='files or folders (default: runtime importer viewer)')
    parser.add_argument('--changed', action='store_true', help='only lines that the last commit wrote, or the newest ones before it')
    parser.add_argument('--sample', type=int, metavar='N', help='an even sample of N mutants')
    parser.add_argument('--clusters', type=int, metavar='K', help='take the sample from about K files, which are compiled sooner')
    parser.add_argument('--draw', type=int, metavar='N', help='only N files of each top folder, drawn by the seed: sooner read and compiled')
    parser.add_argument('--own', action='store_true', help="only by the tests of the file's own folder, which others may add to")
    parser.add_argument('--seed', type=int, default=1, help='which sample (default: 1)')
    parser.add_argument('--jobs', type=int, default=os.cpu_count())
    parser.add_argument('--alone', action='store_true', help='build every mutant by itself, without switches')
    parser.add_argument('--constants', action='store_true', help='only numbers that are constexpr, which are built by themselves')
    parser.add_argument('--again', action='store_true', help='try survivors again, after tests were added')
    parser.add_argument('--listed', action='store_true', help='only those that survivors.txt lists')
    parser.add_argument('--fresh', action='store_true', help='forget earlier verdicts')
    parser.add_argument('--corpus', action='store_true', help='with the files of a corpus, where there is one')
    parser.add_argument('--headers', choices=['with', 'without', 'only'], default='with')
    parser.add_argument('--check', action='store_true', help='fail when one survives that survivors.txt does not list')
    parser.add_argument('--table', action='store_true', help='only print the table of what is known')
    parser.add_argument('--list', action='store_true', help='only print the mutants')
    parser.add_argument('--state', default='build/mutation', help='where mutated builds and verdicts are kept')
    parser.add_argument('--build', default='build/release', help='the finished build')
    return parser.parse_args()


def wanted_files(root, tree, options, changed=None):
    listed = subprocess.run(['git', 'ls-files', *(options.files or ['runtime', 'importer', 'viewer'])], cwd=root, check=True, capture_output=True,
                            text=True).stdout.split()
    header = lambda f: f.endswith('.h')
    if changed is not None:  # headers that half of the project includes take too long for every commit
        listed = [f for f in listed if f in changed and (not header(f) or len(tree.users[f]) <= 25)]
    if options.listed:
        listed = [f for f in listed if f in report.listed_files()]
    keep = {'with': lambda f: True, 'without': lambda f: not header(f), 'only': header}[options.headers]
    listed = sorted(f for f in listed if f.endswith(SOURCES) and keep(f))
    if options.draw is None:
        return listed
    by_folder = [[f for f in listed if f.split('/')[0] == top] for top in sorted({f.split('/')[0] for f in listed})]
    return [f for some in by_folder for f in drawn(some, options.seed, options.draw)]


def is_computed_before(mutant):
    """Whether the compiler has to know it, so that no switch can choose it."""
    return not mutant.before and not is_shader(mutant.file)


def parse(job):
    import places_cpp  # clang is needed here only
    return places_cpp.places(*job)


def find_places(tree, files, state, jobs):
    """All mutants of the files; those of files that have not changed come from the last time."""
    path = f'{state}/places.json'
    known = load(path)
    finders = digest(f'{HERE}/places_cpp.py') + digest(f'{HERE}/places_glsl.py')  # other finders find other places
    digests = {f: digest(f'{tree.root}/{f}') + finders for f in files}
    new = [f for f in files if known.get(f, {}).get('digest') != digests[f]]
    units = {}
    for file in new:
        if is_shader(file):
            known[file] = entry(digests[file], places_glsl.places(f'{tree.root}/{file}', file))
        elif (object_ := tree.product_object(file)) is not None:
            units.setdefault(object_, []).append(file)
        else:
            known[file] = entry(digests[file], [])
    work = [(f'{tree.root}/{tree.source[o]}', names, tree.commands[o], tree.root) for o, names in sorted(units.items())]
    with concurrent.futures.ProcessPoolExecutor(max(1, jobs)) as pool:
        for done, (job, (found, errors)) in enumerate(zip(work, pool.map(parse, work)), 1):
            report.progress(f'reading {done} of {len(work)} sources')
            if errors:
                report.note(f'{job[0]}: clang says {errors[0]}')
            for name, mutants in found.items():
                known[name] = entry(digests[name], mutants)
            if done % 20 == 0:
                save(path, known)
    save(path, known)
    found = [Mutant(**m) for f in files for m in known[f]['mutants']]
    give_keys(found)
    return found


def entry(digest_, mutants):
    return {'digest': digest_, 'mutants': [dataclasses.asdict(m) for m in mutants]}


def digest(path):
    with open(path, 'rb') as file:
        return hashlib.sha256(file.read()).hexdigest()


def load(path):
    try:
        with open(path, encoding='utf-8') as file:
            return json.load(file)
    except FileNotFoundError:
        return {}


def save(path, value):
    with open(path + '.new', 'w', encoding='utf-8') as file:
        json.dump(value, file, indent=0)
    os.replace(path + '.new', path)


class Session:
    def __init__(self, tree, state, options):
        self.tree, self.state, self.options = tree, state, options
        self.results = {} if options.fresh else load(f'{state}/results.json')
        self.equivalent = report.listed(f'{HERE}/equivalent.txt')

    def is_known(self, mutant):
        verdict = self.results.get(mutant.key, {}).get('verdict')
        if self.options.again and verdict in ('survived', 'unreached'):
            return False
        return verdict is not None

    def note(self, mutant, verdict, by, seconds):
        self.results[mutant.key] = {'verdict': verdict, 'by': by, 'seconds': round(seconds, 2), 'file': mutant.file, 'line': mutant.line,
                                    'what': str(mutant).split(': ', 1)[1]}
        save(f'{self.state}/results.json', self.results)

    def run(self, mutants):
        """Mutants of one batch, all behind switches in one build."""
        skipped = self.equivalent | (report.listed(f'{HERE}/survivors.txt') if self.options.check else set())
        todo = [m for m in mutants if not self.is_known(m) and m.key not in skipped]
        if not todo:
            return
        if self.options.alone or self.options.constants:
            for done, m in enumerate(todo, 1):
                self.alone(m)
                report.progress(f'{done} of {len(todo)} alone')
            return
        numbered = dict(enumerate(mutants, 1))  # known ones too, so that a compiler cache finds what it compiled the last time
        build = MutatedBuild(self.tree, f'{self.state}/switched', numbered, self.options.jobs)
        programs = Programs(build, self.options.corpus, self.options.own)
        done = 0
        with concurrent.futures.ThreadPoolExecutor(max(1, self.options.jobs)) as pool:
            tasks = [pool.submit(self.one, programs, number, m) for number, m in numbered.items() if m in todo]
            for task in concurrent.futures.as_completed(tasks):
                if task.exception() is not None:  # the others go on, and the next run tries this one again
                    report.note(f'not tried: {task.exception()!r}')
                    continue
                number, m, verdict, by, seconds = task.result()
                done += 1
                self.note(m, verdict, by, seconds)
                report.progress(report.state_of(self.results, done, len(todo)))
                if verdict in ('survived', 'unreached'):
                    report.note(f'{verdict}: {m}')
        for test in programs.broken:
            report.note(f'fails without a mutant and was left out: {test}')

    def one(self, programs, number, m):
        started = time.monotonic()
        environment, reaches = {'SINEW_MUTANT': str(number)}, lambda test, n: n in test[2]
        verdict = None
        if is_shader(m.file):
            folder = compile_shaders(self.tree.root, f'{programs.build.folder}/shaders{number}', m)
            if folder is None:
                verdict = 'stillborn', ''
            else:
                changed = {os.path.splitext(name)[0] for name in os.listdir(folder)}
                environment, reaches = {'SINEW_MUTANT_SHADERS': folder}, lambda test, n: not changed.isdisjoint(test[2])
        if verdict is None:
            verdict = programs.verdict(number, m, environment, reaches)
        if number in programs.build.stillborn:
            verdict = 'stillborn', ''
        return number, m, *verdict, time.monotonic() - started

    def alone(self, m):
        started = time.monotonic()
        build = MutatedBuild(self.tree, f'{self.state}/alone', {1: m}, self.options.jobs, switched=False)
        programs = Programs(build, self.options.corpus, self.options.own)
        verdict = 'stillborn', ''
        try:
            verdict = programs.verdict_alone(m)
        except RuntimeError:
            pass
        if build.stillborn:
            verdict = 'stillborn', ''
        self.note(m, *verdict, time.monotonic() - started)


def main():
    options = arguments()
    root = subprocess.run(['git', 'rev-parse', '--show-toplevel'], cwd=HERE, check=True, capture_output=True, text=True).stdout.strip()
    state = f'{root}/{options.state}'
    os.makedirs(state, exist_ok=True)
    tree = Tree(root, f'{root}/{options.build}')

    def mutants_of(changed):
        found = find_places(tree, wanted_files(root, tree, options, changed), state, options.jobs)
        return [m for m in found if is_computed_before(m) == options.constants]

    mutants = in_sample_order(changes.newest(root, mutants_of) if options.changed else mutants_of(None), options.seed)
    report.note(f'{len(mutants)} mutants can be set in {len({m.file for m in mutants})} files')
    if options.listed:
        mutants = [m for m in mutants if m.key in report.listed(f'{HERE}/survivors.txt')]
    chosen = mutants if options.sample is None else mutants[:options.sample]
    if options.clusters and options.sample:
        chosen = in_clusters(mutants, options.seed, options.clusters, -(-options.sample // options.clusters))
    if options.list:
        print('\n'.join(f'{m.key} {m}' for m in chosen))
        return 0
    session = Session(tree, state, options)
    if not options.table:
        session.run([m for m in chosen if not m.file.endswith('.h')])
        session.run([m for m in chosen if m.file.endswith('.h')])
    return report.finish(chosen, session.results, session.equivalent, options)


if __name__ == '__main__':
    sys.exit(main())
