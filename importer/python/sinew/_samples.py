# SPDX-License-Identifier: MIT
"""A small file for examples and tests, made here."""

from __future__ import annotations

import base64
import json
import math
import struct
import tempfile
from pathlib import Path
from typing import Any

_JOINTS = 3
_RINGS = 6


class _Buffer:
    """Binary data of a glTF file with its views and accessors."""

    def __init__(self) -> None:
        self.data = b""
        self.views: list[dict[str, Any]] = []
        self.accessors: list[dict[str, Any]] = []

    def add(self, rows: list[list[float]], kind: str, component: int = 5126, bounds: bool = False) -> int:
        code = {5126: "f", 5121: "B", 5123: "H"}[component]
        packed = b"".join(struct.pack(f"<{len(row)}{code}", *row) for row in rows)
        self.views.append({"buffer": 0, "byteOffset": len(self.data), "byteLength": len(packed)})
        accessor: dict[str, Any] = {
            "bufferView": len(self.views) - 1,
            "componentType": component,
            "count": len(rows),
            "type": kind,
        }
        if bounds:
            accessor["min"] = [min(column) for column in zip(*rows, strict=True)]
            accessor["max"] = [max(column) for column in zip(*rows, strict=True)]
        self.accessors.append(accessor)
        self.data += packed + b"\0" * (-len(packed) % 4)
        return len(self.accessors) - 1


def _float32(value: float) -> float:
    return float(struct.unpack("<f", struct.pack("<f", value))[0])


def _model() -> dict[str, Any]:
    """A square tube of three joints that bends, one metre a joint, with 24 vertices."""
    buffer = _Buffer()
    positions, joints, weights, triangles = [], [], [], []
    for ring in range(_RINGS):
        height = _float32(ring * _JOINTS / (_RINGS - 1))
        place = min(height, _JOINTS - 1.0)
        upper = min(int(place) + 1, _JOINTS - 1)
        share = _float32(place - int(place)) if upper > int(place) else 0.0
        for corner in range(4):
            angle = math.pi / 4 + corner * math.pi / 2
            positions.append([_float32(0.2 * math.cos(angle)), height, _float32(0.2 * math.sin(angle))])
            joints.append([float(int(place)), float(upper if share else 0), 0.0, 0.0])
            weights.append([_float32(1.0 - share), share, 0.0, 0.0])
            if ring + 1 < _RINGS:
                a, b = ring * 4 + corner, ring * 4 + (corner + 1) % 4
                triangles += [[float(i)] for i in (a, a + 4, b, b, a + 4, b + 4)]
    for row in joints:
        row[:] = [int(value) for value in row]
    for row in triangles:
        row[:] = [int(row[0])]
    position = buffer.add(positions, "VEC3", bounds=True)
    joint = buffer.add(joints, "VEC4", 5121)
    weight = buffer.add(weights, "VEC4")
    index = buffer.add(triangles, "SCALAR", 5123)
    bind = buffer.add([[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -float(j), 0, 1] for j in range(_JOINTS)], "MAT4")
    times = buffer.add([[0.0], [0.5], [1.0]], "SCALAR", bounds=True)
    half = math.radians(30.0)
    bend = buffer.add([[0, 0, 0, 1], [0, 0, _float32(math.sin(half)), _float32(math.cos(half))], [0, 0, 0, 1]], "VEC4")
    rise = buffer.add([[0, 0, 0], [0, 0.25, 0], [0, 0, 0]], "VEC3")
    names = ["root", "middle", "tip"]
    nodes: list[dict[str, Any]] = [{"name": "tube", "mesh": 0, "skin": 0}]
    for j in range(_JOINTS):
        node: dict[str, Any] = {"name": names[j]}
        if j:
            node["translation"] = [0, 1, 0]
        if j + 1 < _JOINTS:
            node["children"] = [j + 2]
        nodes.append(node)
    return {
        "asset": {"version": "2.0", "generator": "sinew"},
        "scene": 0,
        "scenes": [{"nodes": [0, 1]}],
        "nodes": nodes,
        "meshes": [
            {
                "primitives": [
                    {"attributes": {"POSITION": position, "JOINTS_0": joint, "WEIGHTS_0": weight}, "indices": index}
                ]
            }
        ],
        "skins": [{"joints": [1, 2, 3], "inverseBindMatrices": bind}],
        "animations": [
            {
                "name": "Bend",
                "channels": [
                    {"sampler": 0, "target": {"node": 2, "path": "rotation"}},
                    {"sampler": 0, "target": {"node": 3, "path": "rotation"}},
                    {"sampler": 1, "target": {"node": 1, "path": "translation"}},
                ],
                "samplers": [{"input": times, "output": bend}, {"input": times, "output": rise}],
            }
        ],
        "buffers": [
            {
                "byteLength": len(buffer.data),
                "uri": "data:application/octet-stream;base64," + base64.b64encode(buffer.data).decode(),
            }
        ],
        "bufferViews": buffer.views,
        "accessors": buffer.accessors,
    }


def sample_file(folder: str | Path | None = None) -> Path:
    """Writes a small skinned model with one clip, "Bend", and returns its path.

    Without a folder it lies in the folder for temporary files.
    """
    path = Path(folder if folder is not None else tempfile.gettempdir()) / "sinew_tube.gltf"
    path.write_text(json.dumps(_model()))
    return path
