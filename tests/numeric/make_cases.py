#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes cases whose answers are known to 60 digits, so that kernels are held to the truth on every machine.

    python3 make_cases.py            # writes KIND.json beside this file; needs python3-mpmath
    python3 make_cases.py --check    # only looks whether the files are what it would write

Inputs are exactly float32, answers are the doubles nearest to what the equations give at 60 digits. What is accepted
counts roundings: so many steps of float (2^-24 of the numbers that are added). Quaternions are x, y, z, w; matrices
column by column. numeric_metrics.cpp says how each metric compares.
"""
import json
import os
import random
import struct
import sys

try:
    from mpmath import atan2, cos, mp, mpf, pi, sin, sqrt
except ImportError:
    print('python3-mpmath is missing')
    sys.exit(77)

mp.dps = 60
EPS = 2.0 ** -24
FLOOR = 2.0 ** -126  # the smallest normal float
HERE = os.path.dirname(os.path.abspath(__file__))


def f32(x):
    return struct.unpack('f', struct.pack('f', float(x)))[0]


def floats(v):
    return [f32(x) for x in v]


def dot(a, b):
    return sum((mpf(x) * mpf(y) for x, y in zip(a, b)), mpf(0))


def length(v):
    return sqrt(dot(v, v))


def scaled(v, s):
    return [mpf(x) * s for x in v]


def added(*vectors):
    return [sum(parts, mpf(0)) for parts in zip(*(list(map(mpf, v)) for v in vectors))]


def unit(v):
    return scaled(v, 1 / length(v))


def cross(a, b):
    a, b = list(map(mpf, a)), list(map(mpf, b))
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def times(p, q):
    """Product of quaternions: q first, then p."""
    v = added(scaled(q[:3], p[3]), scaled(p[:3], q[3]), cross(p[:3], q[:3]))
    return v + [mpf(p[3]) * q[3] - dot(p[:3], q[:3])]


def conjugate(q):
    return [-mpf(x) for x in q[:3]] + [mpf(q[3])]


def about(axis, angle):
    """Quaternion of a turn."""
    return scaled(unit(axis), sin(mpf(angle) / 2)) + [cos(mpf(angle) / 2)]


def log(q):
    """Half the angle along the axis, of a unit quaternion."""
    n = length(q[:3])
    return scaled(q[:3], atan2(n, q[3]) / n) if n else [mpf(0)] * 3


def exponential(v):
    n = length(v)
    return (scaled(v, sin(n) / n) if n else list(map(mpf, v))) + [cos(n)]


def rotation(q):
    """Columns of the matrix of q / |q|."""
    x, y, z, w = unit(q)
    return [[1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)],
            [2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)],
            [2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)]]


def moved(columns, v):
    return added(*(scaled(c, mpf(x)) for c, x in zip(columns, v)))


def product(a, b):
    return [moved(a, c) for c in b]


def arc(q, r, t):
    """Spherical interpolation along the arc from q to r as they are, q and r unit."""
    angle = 2 * atan2(length(added(q, scaled(r, -1))), length(added(q, r)))
    if angle == 0:
        return list(map(mpf, q))
    return added(scaled(q, sin((1 - t) * angle) / sin(angle)), scaled(r, sin(t * angle) / sin(angle)))


def near_side(q, r):
    return scaled(r, -1) if dot(q, r) < 0 else list(map(mpf, r))


class Cases:
    def __init__(self, kind):
        self.kind, self.cases, self.random = kind, [], random.Random(kind)

    def vector(self, low=-1.0, high=1.0):
        return floats(self.random.uniform(low, high) for _ in range(3))

    def direction(self):
        return unit([self.random.gauss(0, 1) for _ in range(3)])

    def quaternion(self):
        return floats(unit([self.random.gauss(0, 1) for _ in range(4)]))

    def add(self, name, given, out, accept):
        plain = lambda v: None if v is None else [float(x) for x in v] if isinstance(v, (list, tuple)) else float(v)
        self.cases.append({'name': name, 'in': given, 'out': {k: plain(v) for k, v in out.items()}, 'accept': accept})

    def write(self):
        lines = ',\n'.join(json.dumps(c) for c in self.cases)
        text, path = '{"kind": "%s", "cases": [\n%s\n]}\n' % (self.kind, lines), f'{HERE}/{self.kind}.json'
        if '--check' in sys.argv:
            with open(path, encoding='utf-8') as file:
                if file.read() != text:
                    sys.exit(f'{path} is not what this program writes')
            return
        with open(path, 'w', encoding='utf-8') as file:
            file.write(text)


TURNED = {'metric': 'rotation_angle', 'tol': 7 * EPS, 'norm_tol': 5 * EPS}
PARTS = (0.0, 0.1, 0.25, 0.5, 0.75, 0.999, 1.0)


def two_keys(kind, between):
    cases = Cases(kind)
    for angle in (1e-8, 1e-6, 1e-4, 1e-3, 0.02, 0.085, 0.5, 1.0, 2.0, 2.8, 3.1):
        for sign in (1, -1):
            q = cases.quaternion()
            r = floats(scaled(times(q, about(cases.direction(), angle)), sign))
            for t in PARTS[1:6] if sign > 0 else PARTS[::3]:
                t = f32(t)
                cases.add(f'angle-{angle}-sign-{sign}-t-{t:.3f}', {'q': q, 'r': r, 't': t}, {'q': between(q, r, mpf(t))}, TURNED)
    cases.write()


def squad():
    cases = Cases('squad')
    for step in (1e-5, 1e-3, 0.085, 0.3, 0.7, 2.6):
        for number in range(4):
            keys = [cases.quaternion()]
            for _ in range(3):
                turn = about(cases.direction(), step * cases.random.uniform(0.95, 1.0))
                keys.append(floats(scaled(times(keys[-1], turn), -1 if number % 2 and cases.random.random() < 0.5 else 1)))
            q = [unit(keys[0])]
            for key in keys[1:]:
                q.append(near_side(q[-1], unit(key)))
            control = []
            for i in (1, 2):
                back = times(conjugate(q[i]), q[i - 1])
                forth = times(conjugate(q[i]), q[i + 1])
                control.append(times(q[i], exponential(scaled(added(log(back), log(forth)), mpf(-1) / 4))))
            t = mpf(f32(PARTS[1 + number]))
            out = arc(arc(q[1], q[2], t), arc(control[0], control[1], t), 2 * t * (1 - t))
            cases.add(f'steps-{step}-{number}', {'keys': keys, 't': float(t)}, {'q': out, 'a0': control[0], 'a1': control[1]},
                      {'metric': 'squad', 'tol': 12 * EPS, 'control_tol': 12 * EPS, 'norm_tol': 5 * EPS})
    cases.write()


def hermite():
    cases = Cases('hermite')
    for op, size in (('vec3', 3), ('quat', 4)):
        for interval in (1.0, 0.04, 2.5):
            for s in (0.0, 0.003, 0.25, 0.5, 0.875, 0.998, 1.0):
                for large in (1.0, 1e4) if op == 'vec3' else (1.0,):
                    t0 = f32(cases.random.choice([0.0, 1.0]))
                    t1 = f32(t0 + interval)
                    t = f32(t0 + s * (t1 - t0))
                    start = [cases.random.gauss(0, 1) for _ in range(size)]
                    end = [cases.random.gauss(0, 1) for _ in range(size)]
                    if op == 'quat':
                        start, end = unit(start), unit(added(start, scaled(end, mpf('0.4'))))
                    v0, v1 = floats(scaled(start, large)), floats(end)
                    out0 = floats(cases.random.gauss(0, 1) / interval for _ in range(size))
                    in1 = floats(cases.random.gauss(0, 1) / interval for _ in range(size))
                    td = mpf(t1) - mpf(t0)
                    u = (mpf(t) - mpf(t0)) / td
                    h = (1 - u) ** 2 * (1 + 2 * u), u ** 2 * (3 - 2 * u), u * (1 - u) ** 2 * td, -u ** 2 * (1 - u) * td
                    terms = [scaled(v0, h[0]), scaled(v1, h[1]), scaled(out0, h[2]), scaled(in1, h[3])]
                    value = added(*terms)
                    slope = 6 * u * (u - 1), -6 * u * (u - 1), (3 * u - 1) * (u - 1) * td, u * (3 * u - 2) * td
                    along = [scaled(v, w) for v, w in zip((v0, v1, out0, in1), slope)]  # the place between the keys is rounded too
                    sums = [float(sum(abs(x) for x in column)) for column in zip(*terms, *(scaled(v, mpf('0.4')) for v in along))]
                    given = {'op': op, 't0': t0, 't1': t1, 't': t, 'v0': v0, 'out_tangent0': out0, 'in_tangent1': in1, 'v1': v1}
                    name = f'{op}-interval-{interval}-s-{s}-start-{large:g}'
                    if op == 'vec3':
                        cases.add(name, given, {'v': value}, {'metric': 'components', 'key': 'v', 'tol': [10 * EPS * x for x in sums]})
                    else:
                        spread = sum(sums) / float(length(value))
                        cases.add(name, given, {'q': unit(value)},
                                  {'metric': 'rotation_angle', 'tol': 12 * EPS * spread, 'norm_tol': 5 * EPS})
    cases.write()


def log_exp_pow():
    cases = Cases('quat_log_exp_pow')
    for n in (1e-30, 1e-22, 1e-10, 1e-6, 1e-4, 3e-3, 0.1, 0.7, 1.5, 1.6, 2.5, 3.0, 3.1, 3.14):
        axis = cases.direction()
        q = floats(exponential(scaled(axis, n)))
        cases.add(f'log-{n}', {'op': 'log', 'q': q}, {'v': log(unit(q))}, {'metric': 'vec_relative', 'tol': 10 * EPS, 'floor': FLOOR})
        v = floats(scaled(axis, n))
        accept = {'metric': 'quat_components', 'tol': 6 * EPS, 'floor': FLOOR}
        if n < 2:
            accept['vec_rel_tol'] = 10 * EPS
        cases.add(f'exp-{n}', {'op': 'exp', 'v': v}, {'q': exponential(v)}, accept)
        for t in (0.5, 0.25, -1.0, 1.0) if n < 1.4 else ():
            accept = {'metric': 'quat_components', 'tol': 8 * EPS, 'vec_rel_tol': 12 * EPS, 'floor': FLOOR}
            cases.add(f'pow-{n}-t-{t}', {'op': 'pow', 'q': q, 't': t}, {'q': exponential(scaled(log(unit(q)), t))}, accept)
    cases.write()


def axis_angle():
    cases = Cases('axis_angle')
    for angle in (1e-30, 1e-8, 1e-5, 1e-3, 0.1, 1.0, 2.0, 3.0, 3.14):
        axis, a = floats(cases.direction()), f32(angle)
        q = about(axis, a)
        accept = {'metric': 'quat_components', 'tol': 5 * EPS, 'vec_rel_tol': 10 * EPS, 'floor': FLOOR}
        cases.add(f'to-quat-{angle}', {'op': 'to_quat', 'axis': axis, 'angle': a}, {'q': q}, accept)
        columns = [x for c in rotation(q) for x in c]
        cases.add(f'to-matrix-{angle}', {'op': 'to_matrix', 'axis': axis, 'angle': a}, {'m': columns},
                  {'metric': 'max_abs', 'key': 'm', 'tol': 7 * EPS})
        given = floats(q)
        v = log(unit(given))
        cases.add(f'from-quat-{angle}', {'op': 'from_quat', 'q': given}, {'axis': unit(v), 'angle': 2 * length(v)},
                  {'metric': 'axis_angle', 'axis_tol': 8 * EPS, 'angle_rel_tol': 10 * EPS, 'floor': FLOOR})
    cases.write()


def matrices():
    to, back = Cases('quat_to_matrix'), Cases('matrix_to_quat')
    exact = [floats(e) for e in ([1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1], [0.6, 0.8, 0, 0], [0, 0.6, 0, 0.8])]
    for number in range(40):
        q = exact[number] if number < len(exact) else to.quaternion()
        if 10 <= number < 20:  # small turns
            q = floats(about(to.direction(), 10.0 ** -(number - 10)))
        if 20 <= number < 30:  # near half a turn
            q = floats(about(to.direction(), pi - mpf(10) ** -(number - 20)))
        given = floats(scaled(q, mpf(to.random.uniform(0.7, 1.4)))) if number >= 30 else q
        columns = [x for c in rotation(given) for x in c]
        to.add(f'{number}', {'q': given}, {'m': columns}, {'metric': 'max_abs', 'key': 'm', 'tol': 7 * EPS})
        out = unit(given)
        m = floats(columns)
        back.add(f'{number}', {'m': m}, {'q': out}, {'metric': 'rotation_angle', 'tol': 9 * EPS, 'norm_tol': 5 * EPS})
    to.write()
    back.write()


def vector_to_vector():
    cases = Cases('vector_to_vector')
    for angle in (0.0, 1e-30, 1e-6, 1e-3, 0.3, 1.5, 2.8, 3.0, 3.13, 3.1405, 3.14150):
        for number in range(3):
            s = cases.direction()
            aside = unit(cross(s, cases.direction()))
            t = added(scaled(s, cos(mpf(angle))), scaled(aside, sin(mpf(angle))))
            s, t = floats(scaled(s, mpf(10) ** (4 * (number - 1)))), floats(scaled(t, mpf(10) ** (3 * (1 - number))))
            u, v = unit(s), unit(t)
            half = added(u, v)
            q = unit(cross(u, unit(half)) + [dot(u, unit(half))])
            opening = float(length(half))  # near opposite vectors rounding of either turns the axis
            cases.add(f'angle-{angle}-{number}', {'s': s, 't': t}, {'q': q},
                      {'metric': 'rotates_s_to_t', 'tol': 12 * EPS, 'norm_tol': 5 * EPS, 'rotation_tol': 18 * EPS * max(1.0, 2.0 / opening)})
    cases.write()


def trs_compose():
    cases = Cases('trs_compose')

    def local(number):
        s = [1.0, 1.0, 1.0] if number % 3 == 0 else cases.vector(-2, 2) if number % 3 == 1 else [2.0 ** -20, 1.0, 2.0 ** 10]
        return {'t': cases.vector(-3, 3), 'q': cases.quaternion(), 's': s}

    def columns_of(x):
        return [scaled(c, mpf(s)) for c, s in zip(rotation(x['q']), x['s'])], list(map(mpf, x['t']))

    for number in range(24):
        depth = 1 if number < 12 else 2 + number % 4
        locals_ = [local(number if depth == 1 else number % 2) for _ in range(depth)]
        linear, origin = columns_of(locals_[0])
        size = [8 * EPS * float(length(c)) for c in linear] + [0.0]
        for x in locals_[1:]:
            other, at = columns_of(x)
            reach = max(float(length(c)) for c in linear)
            origin = added(origin, moved(linear, at))
            size = [12 * EPS * depth * reach * max(abs(y) for y in x['s']) + max(size[:3]) * 3] * 3
            size.append(12 * EPS * depth * (reach * 6 + float(length(origin)) + 6))
            linear = product(linear, other)
        m = [y for c in linear for y in c + [mpf(0)]] + origin + [mpf(1)]
        given = {'op': 'trs', **locals_[0]} if depth == 1 else {'op': 'chain', 'locals': locals_}
        cases.add(f'{number}', given, {'m': m}, {'metric': 'columns', 'key': 'm', 'tol': size})
    cases.write()


def normal_transform():
    cases = Cases('normal_transform')
    for number in range(30):
        size = mpf(10) ** (0, 0, -25, 15, -12)[number % 5]
        stretch = [1, 1, 1] if number % 3 == 0 else [1, 4, 0.25] if number % 3 == 1 else [1, -2, 0.5]
        columns = [floats(scaled(c, size * s)) for c, s in zip(rotation(cases.quaternion()), stretch)]
        n = floats(cases.direction())
        cofactor = [cross(columns[1], columns[2]), cross(columns[2], columns[0]), cross(columns[0], columns[1])]
        det = dot(columns[0], cofactor[0])
        out = moved(cofactor, n)
        spread = float(sum(length(c) * abs(mpf(x)) for c, x in zip(cofactor, n)) / length(out))
        cases.add(f'{number}', {'m': [x for c in columns for x in c], 'n': n},
                  {'n': unit(out), 'n_outward': unit(scaled(out, 1 if det > 0 else -1))}, {'metric': 'normal', 'tol': 14 * EPS * spread})
    cases.write()


def weights_of(cases, count, total=1.0):
    raw = [cases.random.uniform(0.1, 1.0) for _ in range(count)]
    return floats(total * x / sum(raw) for x in raw)


def lbs():
    cases = Cases('lbs')
    for number in range(24):
        count = (1, 2, 4, 7)[number % 4]
        total = 1.0 if number < 12 else (0.5, 0.9, 1.25)[number % 3]
        weights = weights_of(cases, count, total)
        given = {'matrices': [], 'weights': weights, 'p': cases.vector(-2, 2), 'n': floats(cases.direction())}
        p, n, sizes = [mpf(0)] * 3, [mpf(0)] * 3, [0.0, 0.0, 0.0]
        for w in weights:
            linear = [floats(scaled(c, cases.random.uniform(0.5, 2.0))) for c in rotation(cases.quaternion())]
            t = cases.vector(-2, 2)
            given['matrices'].append([x for c in linear for x in c + [0.0]] + t + [1.0])
            share = mpf(w) / sum(map(mpf, weights))
            p = added(p, scaled(added(moved(linear, given['p']), t), share))
            n = added(n, scaled(moved(linear, given['n']), share))
            for a in range(3):
                parts = sum(abs(c[a] * x) for c, x in zip(linear, given['p'])) + abs(t[a])
                sizes[a] += float(share) * parts
        cases.add(f'{number}', given, {'p': p, 'n_linear': n},
                  {'metric': 'components', 'key': 'p', 'tol': [8 * EPS * (1 + s) for s in sizes], 'n_tol': [20 * EPS] * 3})
    cases.write()


def rigid(cases, number):
    """Joints of a vertex, with the rotation that their dual quaternions blend to."""
    count = (1, 2, 3, 4)[number % 4]
    weights = weights_of(cases, count)
    base, quats = cases.quaternion(), []
    for _ in range(count):
        turn = about(cases.direction(), cases.random.uniform(0.0, 2.2))
        quats.append(floats(scaled(times(turn, base), cases.random.choice([1, -1]))))
    translations = [cases.vector(-2, 2) for _ in range(count)]
    heaviest = unit(quats[max(range(count), key=lambda i: weights[i])])
    real, dual = [mpf(0)] * 4, [mpf(0)] * 4
    for w, q, t in zip(weights, quats, translations):
        q = near_side(heaviest, unit(q))
        real = added(real, scaled(q, w))
        dual = added(dual, scaled(times(list(map(mpf, t)) + [mpf(0)], q), mpf(w) / 2))
    given = {'quats': quats, 'translations': translations, 'weights': weights, 'p': cases.vector(-2, 2)}
    return given, real, dual


def dqs():
    cases = Cases('dqs')
    for number in range(32):
        given, real, dual = rigid(cases, number)
        n = length(real)
        shift = scaled(times(dual, conjugate(real))[:3], 2 / (n * n))
        p = list(map(mpf, given['p']))
        if number >= 20:
            given['scales'] = [cases.vector(0.5, 2.0) for _ in given['weights']]
            total = sum(map(mpf, given['weights']))
            stretch = added(*(scaled(s, mpf(w) / total) for s, w in zip(given['scales'], given['weights'])))
            p = [x * s for x, s in zip(p, stretch)]
        else:
            given['n'] = floats(cases.direction())
        out = {'p': added(moved(rotation(real), p), shift), 'q': unit(real)}
        if 'n' in given:
            out['n'] = moved(rotation(real), given['n'])
        spread = 1 / float(n)  # quaternions that nearly cancel lose digits
        cases.add(f'{number}', given, out, {'metric': 'skin', 'tol': 60 * EPS * spread, 'rotation_tol': 14 * EPS * spread, 'n_tol': 14 * EPS * spread})
    cases.write()


def cor():
    cases = Cases('cor')
    for number in range(24):
        given, real, _ = rigid(cases, number)
        given['cor'] = cases.vector(-1, 1)
        if number >= 12:
            given['weights'] = floats(w * 0.8 for w in given['weights'])
        total = sum(map(mpf, given['weights']))
        carried = [mpf(0)] * 3
        for w, q, t in zip(given['weights'], given['quats'], given['translations']):
            carried = added(carried, scaled(added(moved(rotation(q), given['cor']), t), mpf(w) / total))
        arm = added(given['p'], scaled(given['cor'], -1))
        spread = 1 / float(length(real))
        cases.add(f'{number}', given, {'p': added(moved(rotation(real), arm), carried), 'q': unit(real)},
                  {'metric': 'skin', 'tol': 60 * EPS * spread, 'rotation_tol': 14 * EPS * spread})
    cases.write()


def candy_wrapper():
    """A point beside the x axis, twisted by half of a turn about it: its distance from the axis by each kind of skinning."""
    cases = Cases('candy_wrapper')
    for degrees in (0, 30, 90, 135, 170):
        for weight in (0.5, 0.25, 0.125):
            half = mpf(degrees) * pi / 360
            q1 = floats([sin(half), 0, 0, cos(half)])
            m1 = [x for c in rotation(q1) for x in floats(c)]
            p, center = [0.25, 1.0, 0.0], [0.25, 0.0, 0.0]
            columns = [m1[0:3], m1[3:6], m1[6:9]]
            linear = added(scaled(p, 1 - mpf(weight)), scaled(moved(columns, p), mpf(weight)))
            blended = added(scaled([0, 0, 0, 1], 1 - mpf(weight)), scaled(unit(q1), mpf(weight)))
            turned = moved(rotation(blended), p)
            cases.add(f'{degrees}-{weight}', {'degrees': float(degrees), 'weight1': weight, 'p': p, 'q1': q1, 'm1': m1, 'cor': center},
                      {'lbs_p': linear, 'dqs_p': turned, 'cor_p': turned, 'dqs_radius': mpf(1), 'cor_radius': mpf(1)},
                      {'metric': 'candy', 'tol': 14 * EPS, 'radius_rel_tol': 12 * EPS})
    cases.write()


def morph():
    cases = Cases('morph')
    for number in range(20):
        count = (1, 2, 5, 40)[number % 4]
        large = (1.0, 1000.0)[number % 2]
        base = floats(scaled(cases.vector(), large))
        weights = floats(cases.random.uniform(-0.5, 1.0) for _ in range(count))
        deltas = floats(cases.random.uniform(-0.01, 0.01) for _ in range(3 * count))
        p, tol = [], []
        for a in range(3):
            terms = [mpf(w) * mpf(deltas[3 * i + a]) for i, w in enumerate(weights)]
            p.append(mpf(base[a]) + sum(terms, mpf(0)))
            tol.append(1.01 * EPS * abs(float(p[-1])) + (count + 2) * EPS * float(sum(abs(t) for t in terms)))
        cases.add(f'{number}', {'base': base, 'deltas': deltas, 'weights': weights}, {'p': p}, {'metric': 'components', 'key': 'p', 'tol': tol})
    cases.write()


def euler():
    """Roll about z, pitch about x, head about y: the head turns first."""
    cases = Cases('euler')
    axes = {'h': [0, 1, 0], 'p': [1, 0, 0], 'r': [0, 0, 1]}
    for pitch in (0.0, 0.4, -1.1, 1.5, 1.57, 1.5707, -1.57079, 1.5707964, -1.5707964):
        for _ in range(3):
            given = {'h': f32(cases.random.uniform(-3.1, 3.1)), 'p': f32(pitch), 'r': f32(cases.random.uniform(-3.1, 3.1))}
            turns = {k: about(axes[k], given[k]) for k in given}
            q = times(turns['r'], times(turns['p'], turns['h']))
            m = [x for c in rotation(q) for x in c]
            cases.add(f'compose-{pitch}', {'op': 'compose', **given}, {'m': m, 'q': q},
                      {'metric': 'euler_compose', 'tol': 9 * EPS, 'quat_tol': 12 * EPS})
            cases.add(f'extract-{pitch}', {'op': 'extract', 'm': floats(m)}, given, {'metric': 'euler_rebuild', 'tol': 16 * EPS})
    cases.write()


def decompose():
    cases = Cases('decompose')
    for number in range(24):
        size = mpf(10) ** (0, -25, 20, 2)[number % 4]
        turn = rotation(cases.quaternion())
        side = -1 if number % 5 == 4 else 1
        axes = rotation(cases.quaternion())
        values = [mpf(cases.random.uniform(0.5, 2.0)) * size * side for _ in range(3)]
        stretch = [added(*(scaled(axis, v * axis[c]) for axis, v in zip(axes, values))) for c in range(3)]
        linear = product(turn, stretch)
        t = cases.vector(-5, 5)
        m = [x for c in linear for x in floats(c) + [0.0]] + t + [1.0]
        s = [stretch[0][0], stretch[1][1], stretch[2][2], stretch[1][0], stretch[2][0], stretch[2][1]]
        out = {'t': t, 'q': quaternion_of(turn), 'stretch': s}
        cases.add(f'polar-{number}', {'op': 'polar', 'm': m}, out,
                  {'metric': 'polar', 'rebuild_tol': 24 * EPS * float(size), 'orthogonal_tol': 14 * EPS, 'rotation_tol': 40 * EPS,
                   'stretch_tol': 40 * EPS * float(size)})
        scales = [mpf(cases.random.uniform(0.5, 2.0)) * size for _ in range(3)]
        if side < 0:
            scales[0] = -scales[0]
        m = [x for c, k in zip(turn, scales) for x in floats(scaled(c, k)) + [0.0]] + t + [1.0]
        cases.add(f'trs-{number}', {'op': 'trs', 'm': m}, {'t': t, 'q': quaternion_of(turn), 's': scales},
                  {'metric': 'trs', 'rebuild_tol': [24 * EPS * abs(float(k)) for k in scales], 'scale_rel_tol': 8 * EPS,
                   'rotation_tol': 20 * EPS, 'norm_tol': 6 * EPS})
    cases.write()


def quaternion_of(columns):
    """Of an exact rotation: the eigenvector by the largest of the four sums."""
    m = columns
    w = 1 + m[0][0] + m[1][1] + m[2][2]
    x = 1 + m[0][0] - m[1][1] - m[2][2]
    y = 1 - m[0][0] + m[1][1] - m[2][2]
    z = 1 - m[0][0] - m[1][1] + m[2][2]
    a, b, c = m[1][2] - m[2][1], m[2][0] - m[0][2], m[0][1] - m[1][0]
    d, e, f = m[0][1] + m[1][0], m[0][2] + m[2][0], m[1][2] + m[2][1]
    return unit(max([[a, b, c, w], [x, d, e, a], [d, y, f, b], [e, f, z, c]], key=length))


def depth_numbers(op, near, far):
    """What distances d become: slope + offset / d, with the slope's sign that of a view along +z."""
    n = mpf(near)
    if 'infinite' in op:
        return {'persp_gl': (mpf(1), -2 * n), 'persp_01': (mpf(1), -n), 'persp_reversed': (mpf(0), n)}[op.replace('_infinite', '')]
    f = mpf(far)
    if 'reversed' in op:
        return -n / (f - n), f * n / (f - n)
    if 'gl' in op:
        return (f + n) / (f - n), -2 * f * n / (f - n)
    return f / (f - n), -f * n / (f - n)


PERSPECTIVES = ('persp_gl', 'persp_gl_infinite', 'persp_01', 'persp_01_lh', 'persp_01_infinite', 'persp_reversed', 'persp_reversed_infinite')
NEAR_FAR = ((0.1, 100.0), (0.01, 1e6), (10.0, 10.001), (1e10, 1e32), (1e-30, 1e-3))


def projection():
    cases = Cases('projection')
    accept = {'metric': 'relative_elements', 'key': 'm', 'rel_tol': 10 * EPS, 'floor': 2.0 ** -149}
    for op in PERSPECTIVES:
        for near, far in NEAR_FAR:
            fov, aspect = f32(cases.random.uniform(0.2, 2.5)), f32(cases.random.uniform(0.5, 2.0))
            given = {'op': op, 'fov_y': fov, 'aspect': aspect, 'near': f32(near)}
            if 'infinite' not in op:
                given['far'] = f32(far)
            slope, offset = depth_numbers(op, given['near'], given.get('far'))
            focal = cos(mpf(fov) / 2) / sin(mpf(fov) / 2)
            facing = 1 if '_lh' in op else -1
            m = [focal / aspect, 0, 0, 0, 0, focal, 0, 0, 0, 0, slope * facing, facing, 0, 0, offset, 0]
            cases.add(f'{op}-{near}-{far}', given, {'m': m}, accept)
    for op in ('ortho', 'ortho_01', 'ortho_01_reversed'):
        for _ in range(4):
            l, b = cases.random.uniform(-5, -1), cases.random.uniform(-5, -1)
            given = {'op': op, **{k: f32(v) for k, v in {'l': l, 'r': l + cases.random.uniform(1, 9), 'b': b,
                                                        't': b + cases.random.uniform(1, 9), 'near': -0.25, 'far': -80.5}.items()}}
            left, right, low, high, n, f = (mpf(given[k]) for k in ('l', 'r', 'b', 't', 'near', 'far'))
            z = {'ortho': (2 / (f - n), -(f + n) / (f - n)), 'ortho_01': (1 / (f - n), -n / (f - n)), 'ortho_01_reversed': (-1 / (f - n), f / (f - n))}[op]
            m = [2 / (right - left), 0, 0, 0, 0, 2 / (high - low), 0, 0, 0, 0, z[0], 0,
                 -(right + left) / (right - left), -(high + low) / (high - low), z[1], 1]
            cases.add(op, given, {'m': m}, accept)
    cases.write()


def depth():
    cases = Cases('depth')
    for op in PERSPECTIVES:
        for near, far in NEAR_FAR[:2]:
            for distance in (1.0, 1.5, 10.0, 300.0):
                given = {'op': op, 'near': f32(near), 'distance': f32(near * distance)}
                if 'infinite' not in op:
                    given['far'] = f32(far)
                slope, offset = depth_numbers(op, given['near'], given.get('far'))
                value = slope + offset / mpf(given['distance'])
                stored = given['stored_depth'] = f32(value)
                gap = abs(mpf(stored) - slope)  # forward depths of what is far lie close to the slope: digits are lost
                back = offset / (mpf(stored) - slope)
                cases.add(f'{op}-{near}-{distance}', given, {'depth': value, 'distance_from_stored': back},
                          {'metric': 'depth', 'depth_tol': 8 * EPS * float(abs(slope) + abs(offset / mpf(given['distance']))),
                           'distance_rel_tol': 8 * EPS * float((abs(mpf(stored)) + abs(slope)) / gap + 1)})
    cases.write()


def hast():
    """Normals by the vectors half way between them and z: these are interpolated, and z is reflected at the result."""
    cases = Cases('hast')
    z = [mpf(0), mpf(0), mpf(1)]
    for tilt in (0.0, 0.3, 1.5, 2.8, 3.1, 3.1405):
        for t in (0.0, 0.25, 0.5, 0.75, 1.0):
            n0 = floats(moved(rotation(about([1, 0, 0], tilt)), z))
            n1 = floats(moved(rotation(about([cases.random.uniform(0.5, 1), cases.random.uniform(-0.5, 0.5), 0], 0.9 * tilt + 0.05)), z))
            h0, h1 = unit(added(unit(n0), z)), unit(added(unit(n1), z))
            h = added(scaled(h0, 1 - mpf(t)), scaled(h1, mpf(t)))
            n = added(scaled(h, 2 * h[2] / dot(h, h)), scaled(z, -1))
            spread = max(1.0, 1 / float(min(h0[2], h1[2])))  # near -z the way there is lost to rounding of the normal
            cases.add(f'{tilt}-{t}', {'n0': n0, 'n1': n1, 't': t}, {'q0': h0, 'q1': h1, 'n': n},
                      {'metric': 'vector_angle', 'key': 'n', 'tol': 16 * EPS * spread, 'q_tol': 6 * EPS * spread, 'norm_tol': 10 * EPS})
    cases.write()


if __name__ == '__main__':
    two_keys('slerp', lambda q, r, t: arc(unit(q), near_side(unit(q), unit(r)), t))
    two_keys('nlerp', lambda q, r, t: unit(added(scaled(q, 1 - t), scaled(near_side(q, r), t))))
    for write in (squad, hermite, log_exp_pow, axis_angle, matrices, vector_to_vector, trs_compose, normal_transform, lbs, dqs, cor,
                  candy_wrapper, morph, euler, decompose, projection, depth, hast):
        write()
