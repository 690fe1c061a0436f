#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares poses that a program computed with those of evaluate.py.

usage: compare_poses.py [--require KIND,...] REFERENCE CANDIDATE        (KIND: normals, tangents, dqs, dqsNormals)
Exit status: 0 all within single precision, 1 something is off or missing."""
import argparse
import json
import sys

POSITIONS, DIRECTIONS = 1e-4, 1e-3  # of the larger of value and model; of a unit vector
KINDS = {'positions': False, 'normals': True, 'tangents': True, 'dqs': False, 'dqsNormals': True}


class Comparison:
    def __init__(self):
        self.compared, self.wrong = 0, []

    def numbers(self, where, expected, found, allowed):
        self.compared += 1
        if found is None or len(found) != len(expected):
            self.wrong.append('%s: missing' % where)
        elif not all(f is not None and abs(e - f) <= allowed for e, f in zip(expected, found)):
            self.wrong.append('%s: %s instead of %s' % (where, found, expected))

    def sample(self, where, expected, found, extent, required):
        worlds = {n['node']: n['world'] for n in found['nodes']}
        for node in expected['nodes']:
            world, place = node['world'], '%s, node %d' % (where, node['node'])
            mine = worlds.get(node['node'])
            largest = max(max(abs(x) for x in world[:12]), 1e-30)
            self.numbers(place, world[:12], mine and mine[:12], POSITIONS * largest)
            self.numbers(place, world[12:], mine and mine[12:], POSITIONS * max(extent, *map(abs, world[12:15])))
        weights = {n['node']: n['weights'] for n in found['weights']}
        for node in expected['weights']:
            self.numbers('%s, weights of node %d' % (where, node['node']), node['weights'], weights.get(node['node']),
                         POSITIONS * max([1.0] + [abs(w) for w in node['weights']]))
        parts = {(p['node'], p['primitive']): p for p in found['skinned']}
        for part in expected['skinned']:
            mine = parts.get((part['node'], part['primitive']), {'vertices': []})
            row_of = {v: i for i, v in enumerate(mine['vertices'])}
            for kind, is_direction in KINDS.items():
                if kind not in part or kind not in mine and kind not in required:
                    continue
                for v, row in zip(part['vertices'], part[kind]):
                    at = row_of.get(v)
                    self.numbers('%s, node %d, primitive %d, vertex %d, %s' % (where, part['node'], part['primitive'], v, kind), row,
                                 mine[kind][at] if at is not None and kind in mine else None,
                                 DIRECTIONS if is_direction else POSITIONS * max(extent, *map(abs, row)))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--require', default='')
    parser.add_argument('reference')
    parser.add_argument('candidate')
    options = parser.parse_args()
    with open(options.reference, encoding='utf-8') as file:
        reference = json.load(file)
    with open(options.candidate, encoding='utf-8') as file:
        clips = {c['clip']: c for c in json.load(file)['clips']}
    comparison = Comparison()
    required = set(options.require.split(',')) | {'positions'}
    for clip in reference['clips']:
        samples = {s['time']: s for s in clips.get(clip['clip'], {'samples': []})['samples']}
        for sample in clip['samples']:
            where = 'clip %s, %s s' % (clip['clip'], sample['time'])
            if sample['time'] in samples:
                comparison.sample(where, sample, samples[sample['time']], reference['extent'], required)
            else:
                comparison.wrong.append(where + ': missing')
    for wrong in comparison.wrong[:10]:
        print(wrong)
    print('%d compared, %d off' % (comparison.compared, len(comparison.wrong)))
    return 1 if comparison.wrong or not comparison.compared else 0


if __name__ == '__main__':
    sys.exit(main())
