# SPDX-License-Identifier: MIT
"""Builds small glTF files: accessors of every type, sparse ones, interleaved ones, and the ways to keep bytes."""
import base64
import json
import struct

FORMATS = {5120: 'b', 5121: 'B', 5122: 'h', 5123: 'H', 5125: 'I', 5126: 'f'}
LARGEST = {5120: 127, 5121: 255, 5122: 32767, 5123: 65535}
WIDTHS = {'SCALAR': 1, 'VEC2': 2, 'VEC3': 3, 'VEC4': 4, 'MAT4': 16}
I8, U8, I16, U16, U32, F32 = FORMATS


def as_float(number):
    """The nearest 32-bit float, so that what is written is what is meant."""
    return struct.unpack('<f', struct.pack('<f', number))[0]


def stored(number, kind, normalized):
    """A number as an element of this kind holds it."""
    if kind == F32:
        return as_float(number)
    return round(number * LARGEST[kind]) if normalized else round(number)


class Gltf:
    def __init__(self):
        self.json = {'asset': {'version': '2.0', 'generator': 'sinew tests/generated'}}
        self.bytes = bytearray()

    def list(self, name):
        return self.json.setdefault(name, [])

    def put(self, name, entry):
        self.list(name).append(entry)
        return len(self.list(name)) - 1

    def uses(self, extension, required=False):
        for name in ('extensionsUsed', 'extensionsRequired')[:2 if required else 1]:
            if extension not in self.list(name):
                self.list(name).append(extension)

    def view(self, data, stride=None):
        self.bytes += bytes(-len(self.bytes) % 4)
        entry = {'buffer': 0, 'byteOffset': len(self.bytes), 'byteLength': len(data)}
        if stride:
            entry['byteStride'] = stride
        self.bytes += data
        return self.put('bufferViews', entry)

    def accessor(self, rows, type_, kind=F32, normalized=False, bounds=False, stride=0):
        """Rows of numbers, `stride` bytes apart (0 = tight), as an accessor with a view of its own."""
        rows = [row if isinstance(row, (list, tuple)) else (row,) for row in rows]
        values = [[stored(x, kind, normalized) for x in row] for row in rows]
        packed = [struct.pack('<%d%s' % (WIDTHS[type_], FORMATS[kind]), *row) for row in values]
        step = stride or len(packed[0])
        data = b''.join(row + bytes(step - len(row)) for row in packed)
        entry = {'bufferView': self.view(data, stride or None), 'componentType': kind, 'count': len(rows), 'type': type_}
        if normalized:
            entry['normalized'] = True
        if bounds:
            entry['min'] = [min(row[i] for row in values) for i in range(WIDTHS[type_])]
            entry['max'] = [max(row[i] for row in values) for i in range(WIDTHS[type_])]
        return self.put('accessors', entry)

    def sparse(self, base, changed, count, type_, index_kind=U16):
        """`changed`: index -> row, over the accessor `base` or over zeros."""
        at = sorted(changed)
        indices = self.view(struct.pack('<%d%s' % (len(at), FORMATS[index_kind]), *at))
        values = self.view(b''.join(struct.pack('<%df' % WIDTHS[type_], *map(as_float, changed[i])) for i in at))
        entry = {'componentType': F32, 'count': count, 'type': type_}
        if base is not None:
            entry = {k: v for k, v in self.json['accessors'][base].items() if k not in ('min', 'max')}
        entry['sparse'] = {'count': len(at), 'indices': {'bufferView': indices, 'componentType': index_kind},
                           'values': {'bufferView': values}}
        return self.put('accessors', entry)

    def times(self, values):
        return self.accessor(values, 'SCALAR', bounds=True)

    def animate(self, channels, name=None):
        """`channels`: (node, path, times, rows, interpolation, keywords of the output's accessor); paths that begin with / are
        pointers."""
        samplers, entries = [], []
        for node, path, times, rows, interpolation, how in channels:
            flat = path.endswith('weights')
            type_ = 'SCALAR' if flat else 'VEC4' if path.endswith('rotation') else 'VEC3'
            output = [x for row in rows for x in row] if flat else rows
            samplers.append({'input': self.times(times), 'output': self.accessor(output, type_, **how),
                             'interpolation': interpolation})
            target = {'node': node, 'path': path}
            if path.startswith('/'):
                self.uses('KHR_animation_pointer')
                target = {'path': 'pointer', 'extensions': {'KHR_animation_pointer': {'pointer': path}}}
            entries.append({'sampler': len(samplers) - 1, 'target': target})
        entry = {'samplers': samplers, 'channels': entries}
        return self.put('animations', dict(entry, name=name) if name else entry)

    # -- writing

    def write_gltf(self, path):
        uri = 'data:application/octet-stream;base64,' + base64.b64encode(bytes(self.bytes)).decode()
        self.finish({'byteLength': len(self.bytes), 'uri': uri})
        path.write_text(json.dumps(self.json, indent=1), encoding='utf-8')

    def write_beside(self, path):
        """The bytes in a file of their own."""
        path.with_suffix('.bin').write_bytes(bytes(self.bytes))
        self.finish({'byteLength': len(self.bytes), 'uri': path.with_suffix('.bin').name})
        path.write_text(json.dumps(self.json), encoding='utf-8')

    def write_glb(self, path):
        self.finish({'byteLength': len(self.bytes)})
        path.write_bytes(self.glb())

    def finish(self, buffer):
        if self.bytes:
            self.json['buffers'] = [buffer]

    def glb(self):
        text = json.dumps(self.json).encode()
        text += b' ' * (-len(text) % 4)
        data = bytes(self.bytes) + bytes(-len(self.bytes) % 4)
        chunks = struct.pack('<I4s', len(text), b'JSON') + text
        if data:
            chunks += struct.pack('<I4s', len(data), b'BIN\0') + data
        return b'glTF' + struct.pack('<II', 2, 12 + len(chunks)) + chunks
