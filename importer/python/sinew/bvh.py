# SPDX-License-Identifier: MIT
"""Motion as BVH, which most captures are in."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
import numpy.typing as npt

from sinew._scene import Poses, Scene, load

_CENTIMETRES = 100.0


def from_bvh(file: str | os.PathLike[str]) -> Scene:
    """Reads a BVH file; lengths are taken to be in centimetres. The scene has one clip."""
    if Path(file).suffix.lower() != ".bvh":
        raise ValueError(f"{os.fspath(file)}: the name does not end in .bvh")
    return load(file)


def _euler_zxy(rotations: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    """Degrees about z, x, y with R = Rz Rx Ry, from quaternions x y z w. At x = +-90 degrees y is 0.

    Angles follow each other without jumps of a turn.
    """
    x, y, z, w = np.moveaxis(rotations / np.linalg.norm(rotations, axis=-1, keepdims=True), -1, 0)
    r01, r11, r21 = 2.0 * (x * y - w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + w * x)
    r00, r10 = 1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + w * z)
    r20, r22 = 2.0 * (x * z - w * y), 1.0 - 2.0 * (x * x + y * y)
    cosine = np.hypot(r01, r11)
    locked = cosine < 1e-9
    about_x = np.arctan2(r21, cosine)
    about_z = np.where(locked, np.arctan2(r10, r00), np.arctan2(-r01, r11))
    about_y = np.where(locked, 0.0, np.arctan2(-r20, r22))
    return np.degrees(np.unwrap(np.stack([about_z, about_x, about_y], axis=-1), axis=0))


def to_bvh(poses: Poses, file: str | os.PathLike[str]) -> None:
    """Writes poses at equal steps of time as BVH, in centimetres, with y up.

    All joints become joints of the file. Roots, and joints that change their length, have position channels. BVH has
    no scale: a joint whose scale is not 1 is an error. Names get underscores in place of blanks.
    """
    scene, steps = poses.scene, np.diff(poses.times)
    if len(poses) < 2 or not np.all(steps > 0.0) or np.ptp(steps) > 1e-6 * steps.mean() + 1e-9:
        raise ValueError("to_bvh: times must rise in equal steps, as those of Clip.times do but for the last")
    stretched = np.argwhere(np.abs(poses.scales - 1.0).max(axis=(0, 2)) > 1e-3)
    if len(stretched):
        raise ValueError(
            f"to_bvh: joint {scene.joint_names[int(stretched[0, 0])]!r} has a scale, which BVH cannot hold"
        )
    offsets = scene.rest().translations[0].astype(np.float64) * _CENTIMETRES
    places = poses.translations.astype(np.float64) * _CENTIMETRES
    angles = _euler_zxy(poses.rotations.astype(np.float64))
    children: list[list[int]] = [[] for _ in scene.parents]
    for joint, parent in enumerate(scene.parents):
        if parent >= 0:
            children[parent].append(joint)
    lines: list[str] = ["HIERARCHY"]
    order: list[tuple[int, bool]] = []

    def numbers(values: npt.NDArray[np.float64]) -> str:
        return " ".join(f"{value:.6f}" for value in values)

    stack: list[tuple[int, int, bool]] = [(j, 0, False) for j in reversed(range(len(children))) if scene.parents[j] < 0]
    while stack:
        joint, depth, closes = stack.pop()
        indent = "  " * depth
        if closes:
            lines.append(f"{indent}}}")
            continue
        is_root = scene.parents[joint] < 0
        moves = is_root or bool(np.abs(places[:, joint] - offsets[joint]).max() > 1e-4)
        name = "_".join(scene.joint_names[joint].split()) or f"joint_{joint}"
        channels = (
            "6 Xposition Yposition Zposition Zrotation Xrotation Yrotation"
            if moves
            else "3 Zrotation Xrotation Yrotation"
        )
        lines += [f"{indent}{'ROOT' if is_root else 'JOINT'} {name}", f"{indent}{{"]
        lines += [f"{indent}  OFFSET {numbers(offsets[joint])}", f"{indent}  CHANNELS {channels}"]
        order.append((joint, moves))
        if not children[joint]:
            lines += [f"{indent}  End Site", f"{indent}  {{", f"{indent}    OFFSET 0.0 0.0 0.0", f"{indent}  }}"]
        stack.append((joint, depth, True))
        stack += [(child, depth + 1, False) for child in reversed(children[joint])]
    lines += ["MOTION", f"Frames: {len(poses)}", f"Frame Time: {steps.mean():.9f}"]
    columns = [part for joint, moves in order for part in ([places[:, joint]] if moves else []) + [angles[:, joint]]]
    lines += [numbers(row) for row in np.concatenate(columns, axis=1)]
    Path(file).write_text("\n".join(lines) + "\n")
