#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the models, poses and broken files that tests read besides those of a corpus. The same bytes each time.

usage: make_corpus.py FOLDER       FOLDER gets models/, poses/, malformed/, cache/ and vrm/"""
import json
import math
import pathlib
import shutil
import struct
import sys

import faults
import models
from evaluate import Evaluator
from gltf_file import Gltf


def rounded(value):
    """Numbers with the nine digits that a pose needs; times keep all of theirs."""
    if isinstance(value, float):
        return float('%.9g' % value)
    if isinstance(value, list):
        return [rounded(x) for x in value]
    if isinstance(value, dict):
        return {k: x if k == 'time' else rounded(x) for k, x in value.items()}
    return value


def write_models(folder, poses):
    paths = []
    for name, (write, fill) in models.MODELS.items():
        g = Gltf()
        fill(g)
        path = folder / (name + ('.glb' if write is Gltf.write_glb else '.gltf'))
        write(g, path)
        (poses / (name + '.json')).write_text(json.dumps(rounded(Evaluator(path).poses())), encoding='utf-8')
        paths.append(path)
    return paths


def write_sound(folder):
    """What faults.py breaks."""
    g = Gltf()
    models.add_skinned_sheet(g, joints=2, columns=3, rows=3)
    mesh = g.json['meshes'][0]
    count = g.json['accessors'][0]['count']
    mesh['primitives'][0]['targets'] = [{'POSITION': g.accessor([[0, 0, 1]] * count, 'VEC3', bounds=True)}]
    g.put('nodes', {'mesh': 0, 'skin': 0})
    models.add_skin(g, 2)
    models.scene(g, 0, 1)
    g.animate(models.bend(2))
    g.accessor([1, 2, 3], 'SCALAR')
    path = folder / 'sound.gltf'
    g.write_gltf(path)
    return path


def write_point_cache(folder):
    """A sheet that waves, as an .obj and the .mdd and .pc2 that move its vertices; z is up in the second."""
    points, _, _, indices = models.grid(6, 5)
    lines = ['v %.9g %.9g %.9g' % tuple(p) for p in points]
    lines += ['f %d %d %d' % tuple(i + 1 for i in indices[k:k + 3]) for k in range(0, len(indices), 3)]
    frames = [[[x, y, z + 0.2 * f * math.sin(3 * x + f)] for x, y, z in points] for f in range(7)]
    for name in ('waving', 'waving-z-up'):
        (folder / (name + '.obj')).write_text('\n'.join(lines) + '\n', encoding='utf-8')
    flat = [c for frame in frames for p in frame for c in p]
    (folder / 'waving.mdd').write_bytes(struct.pack('>2I', len(frames), len(points)) + struct.pack('>7f', *(f / 24 for f in range(7))) +
                                        struct.pack('>%df' % len(flat), *flat))
    flat = [c for frame in frames for x, y, z in frame for c in (x, -z, y)]
    (folder / 'waving-z-up.pc2').write_bytes(b'POINTCACHE2\0' + struct.pack('<iiffi', 1, len(points), 0.0, 1.0, len(frames)) +
                                             struct.pack('<%df' % len(flat), *flat))


def write_vrm(folder):
    g = Gltf()
    models.add_skinned_sheet(g)
    g.put('nodes', {'mesh': 0, 'skin': 0})
    models.add_skin(g, 3)
    models.scene(g, 0, 1)
    g.json['extensions'] = {
        'VRMC_vrm': {'specVersion': '1.0', 'meta': {'name': 'sheet', 'authors': ['sinew'], 'licenseUrl': 'https://vrm.dev/licenses/1.0/'},
                     'humanoid': {'humanBones': {'hips': {'node': 1}, 'spine': {'node': 2}, 'head': {'node': 3}}}},
        'VRMC_springBone': {'specVersion': '1.0', 'springs': [{'joints': [{'node': 2, 'stiffness': 1.0}, {'node': 3}]}]}}
    for name in g.json['extensions']:
        g.uses(name)
    g.write_glb(folder / 'sheet.vrm')


def main():
    out = pathlib.Path(sys.argv[1])
    shutil.rmtree(out, ignore_errors=True)
    for name in ('models', 'poses', 'malformed', 'cache', 'vrm'):
        (out / name).mkdir(parents=True)
    paths = write_models(out / 'models', out / 'poses')
    faults.write_faults(write_sound(out / 'malformed'), out / 'malformed')
    faults.write_damage([p for p in paths if p.stem.startswith(('random', 'sparse', 'skin-three', 'morph-l'))], out / 'malformed')
    write_point_cache(out / 'cache')
    write_vrm(out / 'vrm')


if __name__ == '__main__':
    main()
