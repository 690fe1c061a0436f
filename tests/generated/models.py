# SPDX-License-Identifier: MIT
"""Small models that between them hold what glTF can say of poses: every type of accessor, interpolation, sparse data, morph
targets, skins and hierarchies. MODELS: name -> (how it is written, function that fills a Gltf)."""
import math
import random

from gltf_file import F32, I16, I8, U16, U32, U8, Gltf, as_float

MODELS = {}
LINEAR, STEP, CUBIC = 'LINEAR', 'STEP', 'CUBICSPLINE'
WAYS = {'text': Gltf.write_gltf, 'beside': Gltf.write_beside, 'binary': Gltf.write_glb}


def model(name, way='text'):
    def keep(fill):
        MODELS[name] = WAYS[way], fill
        return fill
    return keep


# -- parts

def turn(axis, degrees):
    half = math.radians(degrees) / 2
    length = math.sqrt(sum(x * x for x in axis))
    return [math.sin(half) * x / length for x in axis] + [math.cos(half)]


def grid(columns, rows, width=1.0, height=1.0):
    """Positions, normals, tangents and triangles of a wavy sheet in the plane z = 0."""
    points, normals, tangents, indices = [], [], [], []
    for j in range(rows):
        for i in range(columns):
            x, y = i / (columns - 1), j / (rows - 1)
            points.append([width * (x - 0.5), height * y, 0.1 * math.sin(5 * x + 3 * y)])
            dx, dy = 0.5 * math.cos(5 * x + 3 * y) / width, 0.3 * math.cos(5 * x + 3 * y) / height
            length = math.sqrt(1 + dx * dx + dy * dy)
            normals.append([-dx / length, -dy / length, 1 / length])
            along = math.sqrt(1 + dx * dx)
            tangents.append([1 / along, 0.0, dx / along, 1.0 if j % 2 else -1.0])
    for j in range(rows - 1):
        for i in range(columns - 1):
            a = j * columns + i
            indices += [a, a + 1, a + columns, a + columns, a + 1, a + columns + 1]
    return points, normals, tangents, indices


def add_mesh(g, attributes, indices=None, targets=(), name=None, **more):
    primitive = {'attributes': attributes, **more}
    if indices is not None:
        primitive['indices'] = indices
    if targets:
        primitive['targets'] = list(targets)
    return g.put('meshes', {'primitives': [primitive], **({'name': name} if name else {})})


def add_sheet(g, columns=4, rows=3, with_tangents=False, index_kind=U16, **more):
    points, normals, tangents, indices = grid(columns, rows)
    attributes = {'POSITION': g.accessor(points, 'VEC3', bounds=True), 'NORMAL': g.accessor(normals, 'VEC3')}
    if with_tangents:
        attributes['TANGENT'] = g.accessor(tangents, 'VEC4')
    return add_mesh(g, attributes, g.accessor(indices, 'SCALAR', index_kind), **more)


def scene(g, *roots):
    g.json['scenes'], g.json['scene'] = [{'nodes': list(roots)}], 0


def spin(node, times=(0, 0.5, 1.25), interpolation=LINEAR, **how):
    rows = [turn((1, 2, 3), 40 * k) for k in range(len(times))]
    return node, 'rotation', list(times), rows, interpolation, how


# -- interpolation

def add_moving_node(g, interpolation):
    add_sheet(g)
    g.put('nodes', {'mesh': 0, 'translation': [1, 2, 3], 'rotation': turn((0, 1, 0), 30), 'scale': [1, 2, 1]})
    scene(g, 0)
    r = random.Random(interpolation)
    times = [0.25, 0.5, 1.0, 1.75]
    small = lambda n: [r.uniform(-1, 1) for _ in range(n)]
    keys = {'translation': [small(3) for _ in times], 'scale': [[1 + 0.4 * x for x in small(3)] for _ in times],
            'rotation': [turn(small(3), 60 * k) for k in range(len(times))]}
    if interpolation == CUBIC:
        keys = {path: [row for value in rows for row in (small(len(value)), value, small(len(value)))] for path, rows in keys.items()}
    g.animate([(0, path, times, rows, interpolation, {}) for path, rows in keys.items()], name=interpolation.lower())


for way in (LINEAR, STEP, CUBIC):
    model('interpolation-' + way.lower(), 'binary')(lambda g, way=way: add_moving_node(g, way))


@model('clips-of-all-kinds')
def _(g):
    add_sheet(g)
    g.json['nodes'] = [{'mesh': 0, 'children': [1]}, {'translation': [0, 1, 0]}]
    scene(g, 0)
    g.animate([spin(0)], name='turn')
    g.animate([spin(1, (0.5, 1)), (0, 'translation', [0, 2], [[0, 0, 0], [1, 1, 1]], STEP, {})], name='mixed')
    g.animate([(0, 'scale', [0.0], [[2, 2, 2]], LINEAR, {})], name='one key')
    g.animate([(1, 'rotation', [0, 1], [turn((0, 0, 1), 170), [-x for x in turn((0, 0, 1), 190)]], LINEAR, {})], name='short way')
    g.animate([(0, '/nodes/1/translation', [0, 1], [[0, 1, 0], [0, 2, 0]], LINEAR, {})], name='pointer')


# -- accessors

def add_quantized(g, kind, normalized):
    g.uses('KHR_mesh_quantization', required=True)
    factor = 1 if normalized else 100
    signed = kind in (I8, I16)
    points, normals, _, indices = grid(4, 3, 0.8, 0.8)
    lift = [0, 0, 0] if signed else [0.5, 0.2, 0.2]
    rows = [[factor * (a + b) for a, b in zip(p, lift)] for p in points]
    stride = {I8: 4, U8: 4, I16: 8, U16: 8}[kind]
    attributes = {'POSITION': g.accessor(rows, 'VEC3', kind, normalized, bounds=True, stride=stride)}
    if signed:
        attributes['NORMAL'] = g.accessor(normals, 'VEC3', kind, True, stride=stride)
    add_mesh(g, attributes, g.accessor(indices, 'SCALAR', U8))
    g.put('nodes', {'mesh': 0, 'scale': [1 / factor] * 3})
    scene(g, 0)
    turns = [turn((1, 0, 0), a) for a in (0, 60, 120)] if not signed else [turn((1, 1, 0), a) for a in (-80, 10, 120)]
    g.animate([(0, 'rotation', [0, 1, 2], turns, LINEAR, {'kind': kind, 'normalized': True})])


for kind, name in ((I8, 'i8'), (U8, 'u8'), (I16, 'i16'), (U16, 'u16')):
    for normalized in (False, True):
        model('quantized-%s%s' % (name, '-normalized' if normalized else ''))(
            lambda g, kind=kind, normalized=normalized: add_quantized(g, kind, normalized))


@model('interleaved', 'beside')
def _(g):
    import struct
    points, normals, tangents, indices = grid(5, 4)
    rows = b''.join(struct.pack('<10f', *p, *n, *t) for p, n, t in zip(points, normals, tangents))
    view = g.view(bytes(8) + rows, 40)
    attributes = {}
    for name, type_, offset in (('POSITION', 'VEC3', 8), ('NORMAL', 'VEC3', 20), ('TANGENT', 'VEC4', 32)):
        entry = {'bufferView': view, 'byteOffset': offset, 'componentType': F32, 'count': len(points), 'type': type_}
        if name == 'POSITION':
            entry['min'] = [min(as_float(p[i]) for p in points) for i in range(3)]
            entry['max'] = [max(as_float(p[i]) for p in points) for i in range(3)]
        attributes[name] = g.put('accessors', entry)
    g.json['bufferViews'][view]['byteLength'] = 8 + len(rows)
    add_mesh(g, attributes, g.accessor(indices, 'SCALAR', U32))
    g.put('nodes', {'mesh': 0, 'scale': [-1, 1, 2]})
    scene(g, 0)
    g.animate([spin(0)])


@model('modes-without-indices', 'binary')
def _(g):
    points, _, _, _ = grid(4, 3)
    primitives = [{'attributes': {'POSITION': g.accessor(points, 'VEC3', bounds=True)}, 'mode': mode} for mode in range(7)]
    g.put('meshes', {'primitives': primitives})
    g.put('nodes', {'mesh': 0})
    scene(g, 0)
    g.animate([spin(0)])


@model('sparse', 'binary')
def _(g):
    points, _, _, indices = grid(4, 3)
    base = g.accessor(points, 'VEC3', bounds=True)
    sparse = g.sparse(base, {1: [5, 5, 5], 7: [-1, 0, 2]}, len(points), 'VEC3')
    rows = points[:1] + [[5, 5, 5]] + points[2:7] + [[-1, 0, 2]] + points[8:]
    g.json['accessors'][sparse]['min'] = [min(as_float(p[i]) for p in rows) for i in range(3)]
    g.json['accessors'][sparse]['max'] = [max(as_float(p[i]) for p in rows) for i in range(3)]
    lift = g.sparse(None, {0: [0, 0, 1], 11: [0, 0, 2]}, len(points), 'VEC3', U8)
    over = g.sparse(g.accessor([[0.1, 0, 0]] * len(points), 'VEC3'), {3: [0, 3, 0]}, len(points), 'VEC3', U32)
    add_mesh(g, {'POSITION': sparse}, g.accessor(indices, 'SCALAR', U16), [{'POSITION': lift}, {'POSITION': over}])
    g.put('nodes', {'mesh': 0})
    scene(g, 0)
    g.animate([(0, 'weights', [0, 1, 2], [[0, 0], [1, 0.5], [-0.5, 2]], LINEAR, {})])


# -- morph targets

def add_face(g, way, node_weights=None, **how):
    points, normals, tangents, indices = grid(4, 3)
    r = random.Random(way)
    rows = lambda size: [[r.uniform(-size, size) for _ in range(3)] for _ in points]
    targets = [{'POSITION': g.accessor(rows(0.5), 'VEC3', bounds=True), 'NORMAL': g.accessor(rows(0.3), 'VEC3')},
               {'POSITION': g.accessor(rows(0.5), 'VEC3', bounds=True), 'TANGENT': g.accessor(rows(0.3), 'VEC3')},
               {'NORMAL': g.accessor(rows(0.2), 'VEC3')}]
    attributes = {'POSITION': g.accessor(points, 'VEC3', bounds=True), 'NORMAL': g.accessor(normals, 'VEC3'),
                  'TANGENT': g.accessor(tangents, 'VEC4')}
    mesh = add_mesh(g, attributes, g.accessor(indices, 'SCALAR', U16), targets)
    g.json['meshes'][mesh]['weights'] = [0.25, 0.5, 0]
    g.put('nodes', {'mesh': mesh, 'scale': [1, 2, 0.5], **({'weights': node_weights} if node_weights else {})})
    scene(g, 0)
    times, keys = [0, 0.75, 1.5], [[0, 0.2, 1], [1, 0.6, 0.4], [0.2, 0, 0]]
    if way == CUBIC:
        keys = [row for value in keys for row in ([r.uniform(-1, 1) for _ in value], value, [r.uniform(-1, 1) for _ in value])]
    g.animate([(0, 'weights', times, keys, way, how)])


for way in (LINEAR, STEP, CUBIC):
    model('morph-' + way.lower(), 'binary')(lambda g, way=way: add_face(g, way))
model('morph-weights-of-nodes')(lambda g: add_face(g, LINEAR, [0.5, 0, 0.75]))
model('morph-weights-u8')(lambda g: add_face(g, LINEAR, kind=U8, normalized=True))
model('morph-weights-u16')(lambda g: add_face(g, STEP, kind=U16, normalized=True))


# -- skins

def add_skin(g, count, bind=True, first=1, step=(0, 0.5, 0)):
    """A chain of joints from node `first` on, `step` from each other."""
    for j in range(count):
        node = {'name': 'joint%d' % j, 'translation': [0, 0, 0] if j == 0 else list(step)}
        if j + 1 < count:
            node['children'] = [first + j + 1]
        g.put('nodes', node)
    skin = {'joints': list(range(first, first + count))}
    if bind:
        rows = [[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -j * step[0], -j * step[1], -j * step[2], 1] for j in range(count)]
        skin['inverseBindMatrices'] = g.accessor(rows, 'MAT4')
    return g.put('skins', skin)


def influences(points, joints, width):
    """Weights that go over from joint to joint along y; `width` joints a vertex."""
    ids, weights = [], []
    top = max(p[1] for p in points) or 1.0
    reach = 1.5 if width <= 4 else width / 2  # in joints; more than four of eight pull at a vertex
    for p in points:
        at = p[1] / top * (joints - 1)
        near = sorted(range(joints), key=lambda j: abs(j - at))[:width]
        pull = [max(0.0, reach - abs(j - at)) for j in near]
        total = sum(pull)
        ids.append(near + [0] * (width - len(near)))
        weights.append([x / total for x in pull] + [0.0] * (width - len(near)))
    return ids, weights


def add_skinned_sheet(g, joints=3, columns=4, rows=7, joint_kind=U8, weight_kind=F32, with_tangents=False, width=4):
    points, normals, tangents, indices = grid(columns, rows, 1.0, 0.5 * (joints - 1))
    ids, weights = influences(points, joints, width)
    if weight_kind != F32:  # whole numbers that add up
        most = {U8: 255, U16: 65535}[weight_kind]
        for row in weights:
            whole = [round(w * most) for w in row]
            whole[whole.index(max(whole))] += most - sum(whole)
            row[:] = [w / most for w in whole]
    attributes = {'POSITION': g.accessor(points, 'VEC3', bounds=True), 'NORMAL': g.accessor(normals, 'VEC3')}
    if with_tangents:
        attributes['TANGENT'] = g.accessor(tangents, 'VEC4')
    for k in range(0, width, 4):
        attributes['JOINTS_%d' % (k // 4)] = g.accessor([row[k:k + 4] for row in ids], 'VEC4', joint_kind)
        attributes['WEIGHTS_%d' % (k // 4)] = g.accessor([row[k:k + 4] for row in weights], 'VEC4', weight_kind, weight_kind != F32)
    return add_mesh(g, attributes, g.accessor(indices, 'SCALAR', U16))


def bend(count, first=1):
    return [(first + j, 'rotation', [0, 1, 2], [turn((0, 0, 1), 0), turn((1, 0, 1), 25 + 5 * j), turn((0, 1, 1), -20)], LINEAR, {})
            for j in range(count)]


def add_arm(g, joints=3, moved=(), bind=True, **how):
    add_skinned_sheet(g, joints, **how)
    g.put('nodes', {'mesh': 0, 'skin': 0, 'translation': [9, 9, 9]})
    add_skin(g, joints, bind)
    scene(g, 0, 1)
    g.animate(bend(joints) + list(moved), name='bend')


model('skin-three-joints')(lambda g: add_arm(g))
model('skin-tangents', 'binary')(lambda g: add_arm(g, with_tangents=True))
model('skin-joints-u16-weights-u8')(lambda g: add_arm(g, joint_kind=U16, weight_kind=U8))
model('skin-weights-u16')(lambda g: add_arm(g, weight_kind=U16))
model('skin-eight-influences', 'binary')(lambda g: add_arm(g, joints=8, rows=9, width=8))
model('skin-without-binds')(lambda g: add_arm(g, bind=False))
model('skin-stretched')(lambda g: add_arm(g, moved=[(2, 'scale', [0, 1, 2], [[1, 1, 1], [1, 2, 0.5], [3, 1, 1]], LINEAR, {})]))
model('skin-scaled-evenly')(lambda g: add_arm(g, moved=[(2, 'scale', [0, 2], [[1, 1, 1], [2, 2, 2]], LINEAR, {})]))
model('skin-mirrored')(lambda g: add_arm(g, moved=[(3, 'scale', [0, 2], [[1, 1, 1], [-1, 1, 1]], STEP, {})]))


@model('skin-rings-of-equal-weights', 'binary')
def _(g):
    """Rings of 24 vertices that share their weights, as modellers paint them."""
    sides, rings, joints = 24, 9, 3
    points = [[0.3 * math.cos(2 * math.pi * s / sides), ring / 8, 0.3 * math.sin(2 * math.pi * s / sides)] for ring in range(rings) for s in range(sides)]
    normals = [[math.cos(2 * math.pi * s / sides), 0, math.sin(2 * math.pi * s / sides)] for _ in range(rings) for s in range(sides)]
    corner = lambda ring, s: ring * sides + s % sides
    indices = [i for ring in range(rings - 1) for s in range(sides)
               for i in (corner(ring, s), corner(ring + 1, s), corner(ring, s + 1), corner(ring, s + 1), corner(ring + 1, s), corner(ring + 1, s + 1))]
    ids, weights = influences(points, joints, 4)
    add_mesh(g, {'POSITION': g.accessor(points, 'VEC3', bounds=True), 'NORMAL': g.accessor(normals, 'VEC3'),
                 'JOINTS_0': g.accessor(ids, 'VEC4', U8), 'WEIGHTS_0': g.accessor(weights, 'VEC4')}, g.accessor(indices, 'SCALAR', U16))
    g.put('nodes', {'mesh': 0, 'skin': 0})
    add_skin(g, joints)
    scene(g, 0, 1)
    g.animate(bend(joints))


@model('skin-shared-by-two-meshes')
def _(g):
    add_skinned_sheet(g)
    add_skinned_sheet(g, columns=3, rows=5)
    g.json['meshes'][0]['primitives'] += g.json['meshes'].pop()['primitives']
    add_skinned_sheet(g, columns=2, rows=4)
    g.json['nodes'] = [{'mesh': 0, 'skin': 0}]
    add_skin(g, 3)
    g.json['nodes'] += [{'mesh': 1, 'skin': 0, 'scale': [2, 2, 2]}, {'mesh': 1, 'skin': 1}]
    g.put('skins', {'joints': [3, 2, 1], 'skeleton': 1})
    scene(g, 0, 1, 4, 5)
    g.animate(bend(3))


@model('skin-morphed', 'binary')
def _(g):
    add_skinned_sheet(g, with_tangents=True)
    points = grid(4, 7)[0]
    r = random.Random(5)
    rows = lambda size: [[r.uniform(-size, size) for _ in range(3)] for _ in points]
    g.json['meshes'][0]['primitives'][0]['targets'] = [
        {'POSITION': g.accessor(rows(0.3), 'VEC3', bounds=True), 'NORMAL': g.accessor(rows(0.2), 'VEC3'), 'TANGENT': g.accessor(rows(0.2), 'VEC3')}]
    g.put('nodes', {'mesh': 0, 'skin': 0})
    add_skin(g, 3)
    scene(g, 0, 1)
    g.animate(bend(3) + [(0, 'weights', [0, 2], [[0], [1]], LINEAR, {})])


# -- hierarchies

@model('hierarchy-deep')
def _(g):
    add_sheet(g)
    count = 40
    for n in range(count):
        node = {'translation': [0.1, 0.2, 0], 'rotation': turn((1, n % 3, 1), 7)}
        if n + 1 < count:
            node['children'] = [n + 1]
        g.put('nodes', node)
    g.json['nodes'][-1]['mesh'] = 0
    scene(g, 0)
    g.animate([spin(n) for n in (0, 7, 8, 25)])


@model('hierarchy-matrices-shear-and-mirrors')
def _(g):
    add_sheet(g, with_tangents=True)
    shear = [1, 0, 0, 0, 0.5, 2, 0, 0, 0, 0.25, 1, 0, 1, 2, 3, 1]
    g.json['nodes'] = [{'matrix': shear, 'children': [1, 2]}, {'mesh': 0, 'scale': [-1, 1, 1], 'rotation': turn((0, 1, 0), 50)},
                       {'mesh': 0, 'matrix': [0, 1, 0, 0, -1, 0, 0, 0, 0, 0, -3, 0, 4, 0, 0, 1], 'children': [3]},
                       {'mesh': 0, 'scale': [1, -2, -0.5]}]
    scene(g, 0)
    g.animate([spin(1), spin(3)])


@model('hierarchy-outside-of-scenes')
def _(g):
    add_sheet(g)
    g.json['nodes'] = [{'children': [3]}, {'mesh': 0, 'translation': [3, 0, 0]}, {'children': [1]}, {'mesh': 0}, {}]
    g.json['scenes'] = [{'nodes': [0]}, {'nodes': [2, 4]}]
    g.json['scene'] = 1
    g.animate([spin(0), spin(2)])


# -- at random

def add_random(g, seed):
    r = random.Random(seed)
    count = r.randint(3, 9)
    add_sheet(g, r.randint(2, 4), r.randint(2, 4), index_kind=r.choice((U8, U16, U32)))
    add_skinned_sheet(g, joints=2)
    for n in range(count):
        node = {'translation': [r.uniform(-1, 1) for _ in range(3)], 'rotation': turn([r.uniform(-1, 1) for _ in range(3)], r.uniform(-179, 179)),
                'scale': [r.choice((1, 1, r.uniform(0.5, 2))) for _ in range(3)]}
        if r.random() < 0.5:
            node['mesh'] = 0
        g.put('nodes', node)
    roots = []
    for n in range(count):
        if n == 0 or r.random() < 0.2:
            roots.append(n)
        else:
            g.json['nodes'][r.randrange(n)].setdefault('children', []).append(n)
    roots.append(g.put('nodes', {'mesh': 1, 'skin': 0}))
    joints = r.sample(range(count), 2)
    rows = [[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0] + [r.uniform(-1, 1) for _ in range(3)] + [1] for _ in joints]
    g.put('skins', {'joints': joints, 'inverseBindMatrices': g.accessor(rows, 'MAT4')})
    scene(g, *roots)
    channels = []
    for n in range(count):
        for path, width in (('translation', 3), ('rotation', 4), ('scale', 3)):
            if r.random() < 0.5:
                continue
            times = sorted({as_float(r.uniform(0, 3)) for _ in range(r.randint(1, 6))})
            way = r.choice((LINEAR, STEP, CUBIC if len(times) > 1 else STEP))
            value = lambda: turn([r.uniform(-1, 1) for _ in range(3)], r.uniform(-170, 170)) if path == 'rotation' else [
                r.uniform(0.5, 1.5) for _ in range(3)]
            keys = [row for _ in times for row in (([r.uniform(-0.3, 0.3) for _ in range(width)], value(), [r.uniform(-0.3, 0.3) for _ in range(width)])
                                                   if way == CUBIC else (value(),))]
            channels.append((n, path, times, keys, way, {}))
    g.animate(channels or [spin(0)])


for seed in range(8):
    model('random-%d' % seed, ('text', 'binary')[seed % 2])(lambda g, seed=seed: add_random(g, seed))
