# SPDX-License-Identifier: MIT
"""Where the nodes and vertices of a glTF file are, from its bytes and the words of the glTF 2.0 specification alone, in plain
double precision. Nothing of sinew is used."""
import base64
import json
import math
import struct

from gltf_file import FORMATS, LARGEST, WIDTHS, as_float

IDENTITY = [[float(r == c) for c in range(4)] for r in range(4)]  # rows


class File:
    def __init__(self, path):
        data = path.read_bytes()
        self.folder, self.bin = path.parent, None
        if data[:4] == b'glTF':
            size = struct.unpack_from('<I', data, 12)[0]
            self.json = json.loads(data[20:20 + size])
            self.bin = data[28 + size:]
        else:
            self.json = json.loads(data)
        self.buffers = [self.bytes_of(b) for b in self.json.get('buffers', [])]

    def bytes_of(self, buffer):
        uri = buffer.get('uri')
        if uri is None:
            return self.bin
        return base64.b64decode(uri.split(',')[1]) if uri.startswith('data:') else (self.folder / uri).read_bytes()

    def list(self, name):
        return self.json.get(name, [])

    def elements(self, view, offset, kind, width, count, own_stride=None):
        entry = self.json['bufferViews'][view]
        data, form = self.buffers[entry['buffer']], '<%d%s' % (width, FORMATS[kind])
        step = own_stride or entry.get('byteStride') or struct.calcsize(form)
        start = entry.get('byteOffset', 0) + offset
        return [list(struct.unpack_from(form, data, start + i * step)) for i in range(count)]

    def accessor(self, index):
        """Rows of numbers, normalised integers as numbers."""
        a = self.json['accessors'][index]
        width, kind = WIDTHS[a['type']], a['componentType']
        rows = [[0] * width for _ in range(a['count'])]
        if 'bufferView' in a:
            rows = self.elements(a['bufferView'], a.get('byteOffset', 0), kind, width, a['count'])
        if 'sparse' in a:
            s = a['sparse']
            at = self.elements(s['indices']['bufferView'], s['indices'].get('byteOffset', 0), s['indices']['componentType'], 1, s['count'])
            values = self.elements(s['values']['bufferView'], s['values'].get('byteOffset', 0), kind, width, s['count'])
            for (i,), row in zip(at, values):
                rows[i] = row
        if a.get('normalized'):
            rows = [[max(x / LARGEST[kind], -1.0) for x in row] for row in rows]
        return [[float(x) for x in row] for row in rows]


# -- matrices as rows, quaternions as x y z w

def product(a, b):
    return [[sum(a[r][k] * b[k][c] for k in range(4)) for c in range(4)] for r in range(4)]


def unit(v):
    length = math.sqrt(sum(x * x for x in v))
    return [x / length for x in v] if length > 0 else list(v)


def rotation(q):
    x, y, z, w = unit(q)
    return [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]


def from_trs(t, q, s):
    r = rotation(q)
    return [[r[i][k] * s[k] for k in range(3)] + [t[i]] for i in range(3)] + [[0.0, 0.0, 0.0, 1.0]]


def from_columns(numbers):
    return [[numbers[4 * c + r] for c in range(4)] for r in range(4)]


def moved(m, p):
    return [sum(m[r][k] * p[k] for k in range(3)) + m[r][3] for r in range(3)]


def turned(m, v):
    return [sum(m[r][k] * v[k] for k in range(3)) for r in range(3)]


def cofactors(m):
    """The inverse transpose times the determinant."""
    return [[m[(r + 1) % 3][(c + 1) % 3] * m[(r + 2) % 3][(c + 2) % 3] - m[(r + 1) % 3][(c + 2) % 3] * m[(r + 2) % 3][(c + 1) % 3]
             for c in range(3)] for r in range(3)]


def normal_turned(m, n):
    k = cofactors(m)
    sign = math.copysign(1.0, sum(m[0][c] * k[0][c] for c in range(3)))
    return unit([sign * x for x in turned(k, n)])


def quaternion_product(a, b):
    ax, ay, az, aw = a
    bx, by, bz, bw = b
    return [aw * bx + ax * bw + ay * bz - az * by, aw * by - ax * bz + ay * bw + az * bx,
            aw * bz + ax * by - ay * bx + az * bw, aw * bw - ax * bx - ay * by - az * bz]


def quaternion_of(r):
    """Of a rotation matrix, from its largest component (Shepperd)."""
    trace = r[0][0] + r[1][1] + r[2][2]
    sizes = [r[0][0], r[1][1], r[2][2], trace]
    i = sizes.index(max(sizes))
    if i == 3:
        return unit([r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1], 1 + trace])
    j, k = (i + 1) % 3, (i + 2) % 3
    q = [0.0] * 4
    q[i], q[j], q[k], q[3] = 1 + r[i][i] - r[j][j] - r[k][k], r[j][i] + r[i][j], r[k][i] + r[i][k], r[k][j] - r[j][k]
    return unit(q)


# -- interpolation (glTF 2.0, Appendix C)

def slerp(a, b, t):
    a, b = unit(a), unit(b)
    dot = sum(x * y for x, y in zip(a, b))
    if dot < 0:
        b, dot = [-x for x in b], -dot
    angle = math.atan2(math.sqrt(sum((y - dot * x) ** 2 for x, y in zip(a, b))), dot)
    if angle < 1e-9:
        return unit([x + t * (y - x) for x, y in zip(a, b)])
    return [(math.sin((1 - t) * angle) * x + math.sin(t * angle) * y) / math.sin(angle) for x, y in zip(a, b)]


def hermite(v0, out0, in1, v1, d, t):
    a, b, c, e = 2 * t ** 3 - 3 * t * t + 1, d * (t ** 3 - 2 * t * t + t), -2 * t ** 3 + 3 * t * t, d * (t ** 3 - t * t)
    return [a * w + b * x + c * y + e * z for w, x, y, z in zip(v0, out0, v1, in1)]


def sampled(times, rows, interpolation, is_rotation, time):
    """`rows`: one for each key, or in tangent, value, out tangent for CUBICSPLINE."""
    cubic = interpolation == 'CUBICSPLINE'
    value = lambda k: rows[3 * k + 1] if cubic else rows[k]
    if time <= times[0] or len(times) == 1:
        out = value(0)
    elif time >= times[-1]:
        out = value(len(times) - 1)
    else:
        k = max(i for i, t in enumerate(times) if t <= time)
        d = times[k + 1] - times[k]
        t = (time - times[k]) / d
        if interpolation == 'STEP':
            out = value(k)
        elif cubic:
            out = hermite(value(k), rows[3 * k + 2], rows[3 * k + 3], value(k + 1), d, t)
        elif is_rotation:
            out = slerp(value(k), value(k + 1), t)
        else:
            out = [x + t * (y - x) for x, y in zip(value(k), value(k + 1))]
    return unit(out) if is_rotation else out


class Evaluator:
    def __init__(self, path):
        self.file = File(path)
        self.nodes, self.meshes = self.file.list('nodes'), self.file.list('meshes')
        self.parent = {child: n for n, node in enumerate(self.nodes) for child in node.get('children', [])}

    def target_count(self, node):
        return max((len(p.get('targets', [])) for p in self.meshes[node['mesh']]['primitives']), default=0) if 'mesh' in node else 0

    def animated(self, clip, time):
        """(node, path) -> value."""
        out = {}
        for channel in self.file.list('animations')[clip]['channels'] if clip is not None else []:
            sampler = self.file.list('animations')[clip]['samplers'][channel['sampler']]
            target = channel['target']
            node, path = target.get('node'), target['path']
            if path == 'pointer':
                _, _, node, path = target['extensions']['KHR_animation_pointer']['pointer'].split('/')
                node = int(node)
            times = [t for t, in self.file.accessor(sampler['input'])]
            rows = self.file.accessor(sampler['output'])
            if path == 'weights':
                n = self.target_count(self.nodes[node])
                flat = [x for x, in rows]
                rows = [flat[i:i + n] for i in range(0, len(flat), n)]
            out[node, path] = sampled(times, rows, sampler.get('interpolation', 'LINEAR'), path == 'rotation', time)
        return out

    def key_times(self, clip):
        return sorted({t for s in self.file.list('animations')[clip]['samplers'] for t, in self.file.accessor(s['input'])})

    def world(self, animated):
        out = {}

        def matrix(n):
            if n not in out:
                node = self.nodes[n]
                get = lambda path, rest: animated.get((n, path), node.get(path, rest))
                local = from_columns(node['matrix']) if 'matrix' in node else from_trs(
                    get('translation', [0, 0, 0]), get('rotation', [0, 0, 0, 1]), get('scale', [1, 1, 1]))
                out[n] = product(matrix(self.parent[n]), local) if n in self.parent else local
            return out[n]

        for n in range(len(self.nodes)):
            matrix(n)
        return out

    def weights(self, n, animated):
        node = self.nodes[n]
        count = self.target_count(node)
        rest = node.get('weights', self.meshes[node['mesh']].get('weights', [0.0] * count))
        return animated.get((n, 'weights'), rest)

    def sample(self, clip, time):
        animated = self.animated(clip, time)
        world = self.world(animated)
        out = {'time': time, 'nodes': [], 'weights': [], 'skinned': []}
        for n in range(len(self.nodes)):
            out['nodes'].append({'node': n, 'world': [world[n][r][c] for c in range(4) for r in range(4)]})
            if self.target_count(self.nodes[n]):
                out['weights'].append({'node': n, 'weights': self.weights(n, animated)})
            if 'mesh' in self.nodes[n]:
                for p in range(len(self.meshes[self.nodes[n]['mesh']]['primitives'])):
                    out['skinned'].append(self.primitive(n, p, animated, world))
        return out

    def primitive(self, n, p, animated, world):
        node = self.nodes[n]
        entry = self.meshes[node['mesh']]['primitives'][p]
        own = {name: self.file.accessor(a) for name, a in entry['attributes'].items()}
        targets = [{name: self.file.accessor(a) for name, a in t.items()} for t in entry.get('targets', [])]
        weights = self.weights(n, animated) if targets else []
        count = len(own['POSITION'])
        shown = {}
        for name, width in (('POSITION', 3), ('NORMAL', 3), ('TANGENT', 3)):
            if name in own:
                shown[name] = [[row[i] + sum(w * t[name][v][i] for w, t in zip(weights, targets) if name in t) for i in range(width)]
                               for v, row in enumerate(own[name])]
        out = {'node': n, 'mesh': node['mesh'], 'primitive': p, 'vertices': list(range(count))}
        if 'skin' in node and 'JOINTS_0' in own:
            self.skinned(node['skin'], own, shown, world, out)
        else:
            m = world[n]
            out['positions'] = [moved(m, v) for v in shown['POSITION']]
            if 'NORMAL' in shown:
                out['normals'] = [normal_turned(m, v) for v in shown['NORMAL']]
            if 'TANGENT' in shown:
                out['tangents'] = [unit(turned(m, v)) + [own['TANGENT'][i][3]] for i, v in enumerate(shown['TANGENT'])]
        return out

    def skinned(self, s, own, shown, world, out):
        skin = self.file.list('skins')[s]
        binds = [from_columns(row) for row in self.file.accessor(skin['inverseBindMatrices'])] if 'inverseBindMatrices' in skin else None
        joints = [product(world[j], binds[i] if binds else IDENTITY) for i, j in enumerate(skin['joints'])]
        rigid = [self.rigid(m) for m in joints]
        positions, normals, tangents, dqs, dqs_normals = [], [], [], [], []
        for v in range(len(shown['POSITION'])):
            pulls = [(int(j), w) for k in range(8) if 'JOINTS_%d' % k in own
                     for j, w in zip(own['JOINTS_%d' % k][v], own['WEIGHTS_%d' % k][v]) if w > 0]
            total = sum(w for _, w in pulls)
            pulls = [(j, w / total) for j, w in pulls] if pulls else [(int(own['JOINTS_0'][v][0]), 1.0)]
            m = [[sum(w * joints[j][r][c] for j, w in pulls) for c in range(4)] for r in range(4)]
            positions.append(moved(m, shown['POSITION'][v]))
            if 'NORMAL' in shown:
                normals.append(unit(turned(m, shown['NORMAL'][v])))
            if 'TANGENT' in shown:
                tangents.append(unit(turned(m, shown['TANGENT'][v])) + [own['TANGENT'][v][3]])
            if all(rigid[j] for j, _ in pulls):
                q, move, scale = self.blended([(rigid[j], w) for j, w in pulls])
                at = turned(rotation(q), [scale * x for x in shown['POSITION'][v]])
                dqs.append([a + b for a, b in zip(at, move)])
                if 'NORMAL' in shown:
                    dqs_normals.append(unit(turned(rotation(q), shown['NORMAL'][v])))
        for name, values in (('positions', positions), ('normals', normals), ('tangents', tangents)):
            if values:
                out[name] = values
        if len(dqs) == len(positions):
            out['dqs'] = dqs
            if dqs_normals:
                out['dqsNormals'] = dqs_normals

    def rigid(self, m):
        """Rotation, translation and the one factor of a matrix that scales all directions alike; nothing of others."""
        lengths = [math.sqrt(sum(m[r][c] ** 2 for r in range(3))) for c in range(3)]
        s = sum(lengths) / 3
        k = cofactors(m)
        determinant = sum(m[0][c] * k[0][c] for c in range(3))
        if s < 1e-6 or max(abs(x - s) for x in lengths) > 1e-6 * s or abs(determinant - s ** 3) > 1e-5 * s ** 3:
            return None
        return quaternion_of([[m[r][c] / s for c in range(3)] for r in range(3)]), [m[r][3] for r in range(3)], s

    def blended(self, pulls):
        """Dual quaternion linear blending (Kavan et al. 2008), each on the side of the heaviest; scale is blended before."""
        (pivot, _, _), _ = max(pulls, key=lambda pull: pull[1])
        real, dual, scale = [0.0] * 4, [0.0] * 4, 0.0
        for (q, t, s), w in pulls:
            side = -w if sum(a * b for a, b in zip(q, pivot)) < 0 else w
            half = [0.5 * x for x in quaternion_product(t + [0.0], q)]
            real = [a + side * b for a, b in zip(real, q)]
            dual = [a + side * b for a, b in zip(dual, half)]
            scale += w * s
        length = math.sqrt(sum(x * x for x in real))
        real, dual = [x / length for x in real], [x / length for x in dual]
        x, y, z, w = real
        move = [2 * c for c in quaternion_product(dual, [-x, -y, -z, w])[:3]]
        return real, move, scale

    # -- the file of poses

    def poses(self):
        rest = self.sample(None, 0.0)
        corners = [p for part in rest['skinned'] for p in part['positions']]
        extent = max((max(p[i] for p in corners) - min(p[i] for p in corners) for i in range(3)), default=1.0)
        clips = [{'clip': None, 'index': None, 'name': None, 'samples': [rest]}]
        for clip, animation in enumerate(self.file.list('animations')):
            keys = self.key_times(clip)
            times = {0.0, keys[0], keys[-1], keys[len(keys) // 2], as_float(keys[-1] + 0.5)}
            times |= {as_float(a + share * (b - a)) for a, b in list(zip(keys, keys[1:]))[:4] for share in (0.2, 0.55)}
            clips.append({'clip': clip, 'index': clip, 'name': animation.get('name'),
                          'samples': [self.sample(clip, t) for t in sorted(times)]})
        return {'extent': extent if extent > 0 else 1.0, 'clips': clips}
