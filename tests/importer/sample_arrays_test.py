#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""NumPy reads what `sinew sample` writes for it, and finds the numbers of the JSON file.

usage: sample_arrays_test.py SINEW SCRATCH      exit status: 0 right, 1 wrong, 77 there is no NumPy
"""
import json, os, pathlib, subprocess, sys

SYSTEM = '/usr/bin/python3'   # which packages of the system are for, where another Python comes first

try:
    import numpy
except ImportError:
    if os.path.exists(SYSTEM) and os.path.realpath(sys.executable) != os.path.realpath(SYSTEM):
        os.execv(SYSTEM, [SYSTEM] + sys.argv)
    print('no NumPy: install python3-numpy')
    sys.exit(77)

MODEL = {
    'asset': {'version': '2.0'}, 'scene': 0, 'scenes': [{'nodes': [0]}],
    'nodes': [{'name': 'Hüfte', 'children': [1], 'translation': [1, 2, 3]},
              {'name': 'knee', 'rotation': [0, 0, 0.6, 0.8], 'mesh': 0}],
    'meshes': [{'primitives': [{'attributes': {'POSITION': 0}}]}],
    'accessors': [{'bufferView': 0, 'componentType': 5126, 'count': 3, 'type': 'VEC3', 'min': [0, 0, 0], 'max': [1, 1, 0]}],
    'bufferViews': [{'buffer': 0, 'byteLength': 36}],
    'buffers': [{'byteLength': 36, 'uri': 'data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA'}],
}


def main():
    sinew, scratch = sys.argv[1], pathlib.Path(sys.argv[2])
    scratch.mkdir(parents=True, exist_ok=True)
    model = scratch / 'model.gltf'
    model.write_text(json.dumps(MODEL), encoding='utf-8')

    def sample(name):
        subprocess.run([sinew, 'sample', str(model), '-o', str(scratch / name)], check=True)
        return scratch / name

    pose = json.loads(sample('poses.json').read_text(encoding='utf-8'))['clips'][0]['samples'][0]
    matrices = numpy.array([numpy.reshape(node['world'], (4, 4)).T for node in pose['nodes']], dtype=numpy.float32)
    with numpy.load(sample('poses.npz')) as arrays:
        assert arrays['world'].shape == (1, 2, 4, 4) and (arrays['world'][0] == matrices).all()
        assert arrays['node_name'].tolist() == ['Hüfte', 'knee'], arrays['node_name']
        assert arrays['clip'].tolist() == [-1] and arrays['clip_name'].tolist() == ['']
        assert arrays['time_s'].dtype == numpy.float64 and arrays['time_s'].tolist() == [0.0]
        positions = arrays['node1_primitive0_positions']
        assert positions.shape == (1, 3, 3) and positions.dtype == numpy.float32
        moved = arrays['world'][0, 1] @ numpy.array([1, 0, 0, 1], dtype=numpy.float32)
        assert numpy.allclose(moved[:3], positions[0, 1], atol=1e-6), (moved, positions)
    alone = numpy.load(sample('poses.npy'))
    assert alone.shape == (1, 2, 4, 4) and (alone[0] == matrices).all()
    table = numpy.genfromtxt(sample('poses.csv'), delimiter=',', names=True, dtype=None, encoding='utf-8')
    assert table['m03'].tolist() == matrices[:, 0, 3].tolist() and table['node'].tolist() == [0, 1]
    return 0


sys.exit(main())
