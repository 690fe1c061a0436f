# SPDX-License-Identifier: MIT
"""Files with one fault each, whose place and kind are known because it was put there, and files with random damage.

A fault is reported the way that the Khronos validator reports: code and JSON pointer. Damage has no report: such a file has to
end in a message or in a scene, and never in a crash."""
import copy
import json
import random

FAULTS = []


def fault(code, pointer):
    """The function changes the document of a model with a mesh, a skin of two joints, a morph target and a clip."""
    def keep(change):
        FAULTS.append((code, pointer, change))
        return change
    return keep


def set_at(document, pointer, value):
    *path, last = [int(k) if k.isdigit() else k for k in pointer.strip('/').split('/')]
    for key in path:
        document = document[key]
    document[last] = value


def simple(code, pointer, value, at=None):
    FAULTS.append((code, at or pointer, lambda document: set_at(document, pointer, value)))


simple('ACCESSOR_TOO_LONG', '/accessors/0/count', 100000, '/accessors/0')
simple('ACCESSOR_TOO_LONG', '/accessors/0/byteOffset', 4096, '/accessors/0')
simple('BUFFER_VIEW_TOO_LONG', '/bufferViews/1/byteLength', 1 << 20)
simple('UNKNOWN_ASSET_MAJOR_VERSION', '/asset/version', '3.0')
simple('TYPE_MISMATCH', '/nodes/1/translation', 'up')
simple('TYPE_MISMATCH', '/accessors/1/count', 'three')
simple('TYPE_MISMATCH', '/meshes/0/primitives', {})
simple('UNDEFINED_PROPERTY', '/accessors/2', {'componentType': 5126, 'type': 'VEC3'}, '/accessors/2')
simple('VALUE_NOT_IN_RANGE', '/accessors/1/type', 'VEC7')
simple('VALUE_NOT_IN_RANGE', '/accessors/1/componentType', 5124)
simple('UNRESOLVED_REFERENCE', '/nodes/0/mesh', 7)
simple('UNRESOLVED_REFERENCE', '/nodes/0/skin', 9)
simple('UNRESOLVED_REFERENCE', '/nodes/1/children/0', 77)
simple('UNRESOLVED_REFERENCE', '/skins/0/joints/1', 50)
simple('UNRESOLVED_REFERENCE', '/skins/0/inverseBindMatrices', 50)
simple('UNRESOLVED_REFERENCE', '/accessors/0/bufferView', 50)
simple('UNRESOLVED_REFERENCE', '/bufferViews/0/buffer', 3)
simple('UNRESOLVED_REFERENCE', '/meshes/0/primitives/0/attributes/NORMAL', 60)
simple('UNRESOLVED_REFERENCE', '/meshes/0/primitives/0/indices', 60)
simple('UNRESOLVED_REFERENCE', '/meshes/0/primitives/0/targets/0/POSITION', 60)
simple('UNRESOLVED_REFERENCE', '/animations/0/channels/0/sampler', 5)
simple('UNRESOLVED_REFERENCE', '/animations/0/channels/0/target/node', 70)
simple('UNRESOLVED_REFERENCE', '/animations/0/samplers/0/input', 70)
simple('UNRESOLVED_REFERENCE', '/animations/0/samplers/0/output', 70)
simple('UNRESOLVED_REFERENCE', '/scenes/0/nodes/0', 70)
simple('ROTATION_NON_UNIT', '/nodes/1/rotation', [0, 0, 3, 4])
simple('MESH_PRIMITIVE_ATTRIBUTES_ACCESSOR_INVALID_FORMAT', '/meshes/0/primitives/0/attributes/NORMAL', 6)
simple('MESH_PRIMITIVE_INVALID_ATTRIBUTE', '/meshes/0/primitives/0/attributes/COLOUR', 1)
simple('NODE_WEIGHTS_INVALID', '/nodes/0/weights', [1, 2, 3])


@fault('NODE_LOOP', '/nodes/1')
def _(document):
    document['nodes'][2]['children'] = [1]


@fault('NODE_PARENT_OVERRIDE', '/nodes/3/children/0')
def _(document):
    document['nodes'].append({'children': [2]})


@fault('NODE_MATRIX_TRS', '/nodes/1/matrix')
def _(document):
    document['nodes'][1]['matrix'] = [2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1]


@fault('ANIMATION_DUPLICATE_TARGETS', '/animations/0/channels/1/target')
def _(document):
    channels = document['animations'][0]['channels']
    channels[1] = copy.deepcopy(channels[0])


@fault('ANIMATION_SAMPLER_OUTPUT_ACCESSOR_INVALID_COUNT', '/animations/0/samplers/0/output')
def _(document):
    document['accessors'][document['animations'][0]['samplers'][0]['output']]['count'] -= 1


@fault('MESH_PRIMITIVE_UNEQUAL_ACCESSOR_COUNT', '/meshes/0/primitives/0/attributes/NORMAL')
def _(document):
    document['accessors'][document['meshes'][0]['primitives'][0]['attributes']['NORMAL']]['count'] -= 1


@fault('ACCESSOR_SMALL_BYTESTRIDE', '/accessors/0')
def _(document):
    document['bufferViews'][document['accessors'][0]['bufferView']]['byteStride'] = 4


def write_faults(model, folder):
    """`model`: the path of a sound .gltf."""
    sound = json.loads(model.read_text(encoding='utf-8'))
    for number, (code, pointer, change) in enumerate(FAULTS):
        document = copy.deepcopy(sound)
        change(document)
        path = folder / ('%02d-%s.gltf' % (number, code.lower().replace('_', '-')))
        path.write_text(json.dumps(document), encoding='utf-8')
        report = {'issues': {'numErrors': 1, 'messages': [{'code': code, 'severity': 0, 'pointer': pointer or '/'}]}}
        path.with_name(path.name + '.report.json').write_text(json.dumps(report), encoding='utf-8')


def write_damage(models, folder, each=4):
    """Each model cut, with bits turned, with a stretch of itself elsewhere, and with the end of another."""
    random_ = random.Random(7)
    whole = [path.read_bytes() for path in models]
    for path, data in zip(models, whole):
        for k in range(each):
            ways = {'cut': data[:random_.randrange(len(data))], 'bits': turned_bits(random_, data), 'moved': moved_bytes(random_, data),
                    'spliced': data[:random_.randrange(len(data))] + random_.choice(whole)[random_.randrange(len(data)):]}
            for way, bytes_ in ways.items():
                (folder / ('%s-%s-%d%s' % (path.stem, way, k, path.suffix))).write_bytes(bytes_)


def turned_bits(random_, data):
    out = bytearray(data)
    for _ in range(random_.choice((1, 1, 3, 20))):
        out[random_.randrange(len(out))] ^= 1 << random_.randrange(8)
    return bytes(out)


def moved_bytes(random_, data):
    length = random_.randint(1, 64)
    from_, to = random_.randrange(len(data)), random_.randrange(len(data))
    return data[:to] + data[from_:from_ + length] + data[to:]
