#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Times 1,000 poses of a clip of 67 joints: this package, the C++ loop, three.js under node, and a loop in NumPy.

speed.py [SAMPLE_LOOP]    SAMPLE_LOOP is the program sinew-sample-loop of a build; SINEW_THREE names the folder of three
"""

from __future__ import annotations

import base64
import json
import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from time import perf_counter

import numpy as np

import sinew

JOINTS, KEYS, SECONDS, POSES, REPEATS = 67, 61, 2.0, 1000, 15


def model() -> tuple[dict[str, object], np.ndarray, np.ndarray]:
    """A chain of joints that all turn, as glTF, with its key times and rotations [joint, key, 4]."""
    random = np.random.default_rng(67)
    times = np.linspace(0.0, SECONDS, KEYS, dtype=np.float32)
    axes = random.normal(size=(JOINTS, 3))
    axes /= np.linalg.norm(axes, axis=1, keepdims=True)
    angles = np.sin(times[None] * random.uniform(1, 4, (JOINTS, 1)) + random.uniform(0, 6, (JOINTS, 1)))
    keys = np.concatenate([axes[:, None] * np.sin(angles / 2)[..., None], np.cos(angles / 2)[..., None]], axis=-1)
    keys = keys.astype(np.float32)
    data = times.tobytes() + keys.tobytes()
    views = [{"buffer": 0, "byteLength": times.nbytes}]
    accessors: list[dict[str, object]] = [
        {"bufferView": 0, "componentType": 5126, "count": KEYS, "type": "SCALAR", "min": [0.0], "max": [SECONDS]}
    ]
    for joint in range(JOINTS):
        views.append({"buffer": 0, "byteOffset": times.nbytes + joint * KEYS * 16, "byteLength": KEYS * 16})
        accessors.append({"bufferView": joint + 1, "componentType": 5126, "count": KEYS, "type": "VEC4"})
    nodes = [
        {"name": f"joint {j}", "translation": [0, 0.1, 0]} | ({"children": [j + 1]} if j + 1 < JOINTS else {})
        for j in range(JOINTS)
    ]
    animation = {
        "name": "turn",
        "channels": [{"sampler": j, "target": {"node": j, "path": "rotation"}} for j in range(JOINTS)],
        "samplers": [{"input": 0, "output": j + 1} for j in range(JOINTS)],
    }
    uri = "data:application/octet-stream;base64," + base64.b64encode(data).decode()
    return (
        {
            "asset": {"version": "2.0"},
            "scene": 0,
            "scenes": [{"nodes": [0]}],
            "nodes": nodes,
            "animations": [animation],
            "buffers": [{"byteLength": len(data), "uri": uri}],
            "bufferViews": views,
            "accessors": accessors,
        },
        times,
        keys,
    )


def median_ns(work: Callable[[], object]) -> float:
    """Median of the repeats, in nanoseconds a joint."""
    seconds = []
    for _ in range(REPEATS):
        begin = perf_counter()
        work()
        seconds.append(perf_counter() - begin)
    return float(np.median(seconds)) / POSES / JOINTS * 1e9


def numpy_loop(times: np.ndarray, keys: np.ndarray, at: np.ndarray) -> np.ndarray:
    """A slerp of all joints for each time, as people write it."""
    out = np.empty((len(at), JOINTS, 4), dtype=np.float32)
    for frame, time in enumerate(at):
        key = min(int(np.searchsorted(times, time, side="right")) - 1, KEYS - 2)
        share = (time - times[key]) / (times[key + 1] - times[key])
        a, b = keys[:, key], keys[:, key + 1]
        dot = np.sum(a * b, axis=1, keepdims=True)
        b = np.where(dot < 0, -b, b)
        angle = np.arccos(np.minimum(np.abs(dot), 1.0))
        sine = np.maximum(np.sin(angle), 1e-9)
        near = angle < 1e-4
        out[frame] = np.where(near, 1 - share, np.sin((1 - share) * angle) / sine) * a
        out[frame] += np.where(near, share, np.sin(share * angle) / sine) * b
    return out


def main() -> None:
    document, times, keys = model()
    at = np.sort(np.random.default_rng(1).uniform(0.0, SECONDS, POSES))
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "chain.gltf"
        file.write_text(json.dumps(document))
        (Path(folder) / "times.json").write_text(json.dumps(at.tolist()))
        clip = sinew.load(file).clips[0]
        rows = {
            "sinew, one thread": median_ns(lambda: clip.sample(at)),
            "sinew, all cores": median_ns(lambda: clip.sample(at, threads=None)),
        }
        if len(sys.argv) > 1:
            loop = subprocess.run(
                [sys.argv[1], file, str(POSES), str(REPEATS)], capture_output=True, text=True, check=True
            )
            rows["C++ loop into one pose"], rows["C++ loop that keeps each pose"] = map(float, loop.stdout.split())
        if shutil.which("node") and os.environ.get("SINEW_THREE"):
            script = Path(__file__).with_name("sample_three.mjs")
            three = subprocess.run(["node", script, folder, str(REPEATS)], capture_output=True, text=True, check=True)
            rows["three.js under node"] = float(three.stdout)
        difference = np.abs(numpy_loop(times, keys, at) - clip.sample(at).rotations).max()
        assert difference < 1e-5, difference
        rows["NumPy, slerp of all joints for each time"] = median_ns(lambda: numpy_loop(times, keys, at))
    print("| 1,000 poses of 67 joints | ns a joint | of the package |\n|---|---|---|")
    for name, value in rows.items():
        print(f"| {name} | {value:.2f} | {value / rows['sinew, one thread']:.2f} |")


if __name__ == "__main__":
    main()
