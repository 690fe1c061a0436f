# SPDX-License-Identifier: MIT
"""Golden poses: small text files that a reviewer can read, compared in metres and degrees."""

from __future__ import annotations

import json
import os
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from sinew._lengths import length
from sinew._scene import Poses

_FORMAT = 1
Doubles = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Golden:
    """World places of joints at some times of a clip.

    A joint that never moves has one row. Positions are rounded to 1e-6 units, quaternions (x y z w) to 1e-6.
    """

    clip: str
    times: Doubles  #: [time] seconds
    joints: list[str]  #: [joint] unique names: a repeated name gets its number, "#2"
    positions: Doubles  #: [time, joint, 3]
    rotations: Doubles  #: [time, joint, 4] x y z w, w >= 0

    def write(self, file: str | os.PathLike[str]) -> None:
        """Writes the golden file, one line for each joint and time."""
        rows: list[str] = []
        for j, name in enumerate(self.joints):
            values = np.concatenate([self.positions[:, j], self.rotations[:, j]], axis=1).round(6) + 0.0
            if (values == values[0]).all():
                values = values[:1]
            lines = ",\n".join("      " + json.dumps(row) for row in values.tolist())
            rows.append(f"    {json.dumps(name)}: [\n{lines}\n    ]")
        head = {"sinew_golden": _FORMAT, "clip": self.clip, "times": self.times.round(9).tolist()}
        text = json.dumps(head)[:-1] + ',\n  "joints": {\n' + ",\n".join(rows) + "\n  }\n}\n"
        path = Path(file)
        path.parent.mkdir(parents=True, exist_ok=True)
        part = path.with_name(path.name + ".part")
        part.write_text(text)
        part.replace(path)

    @staticmethod
    def read(file: str | os.PathLike[str]) -> Golden:
        """Reads a golden file. `ValueError` says what is wrong with it."""
        try:
            data: dict[str, Any] = json.loads(Path(file).read_text())
            if data["sinew_golden"] != _FORMAT:
                raise ValueError(f"its form is {data['sinew_golden']}, and this version reads {_FORMAT}")
            times = np.array(data["times"], dtype=np.float64)
            shape = (len(times), 7)
            rows = [np.broadcast_to(np.array(r, dtype=np.float64), shape) for r in data["joints"].values()]
            values = np.stack(rows, axis=1) if rows else np.zeros((len(times), 0, 7))
            return Golden(str(data["clip"]), times, list(data["joints"]), values[..., :3], values[..., 3:])
        except (KeyError, TypeError, ValueError) as error:
            raise ValueError(f"{os.fspath(file)}: is no golden file of sinew: {error}") from None


def _unique(names: list[str]) -> list[str]:
    seen: dict[str, int] = {}
    out = []
    for name in names:
        seen[name] = seen.get(name, 0) + 1
        out.append(name if seen[name] == 1 else f"{name}#{seen[name]}")
    return out


def _rotations(matrices: Doubles) -> Doubles:
    """Quaternions x y z w with w >= 0 of [..., 3, 3] matrices, their columns made unit and orthogonal first."""
    u, _, v = np.linalg.svd(matrices)
    r = u @ v
    r = r * np.sign(np.linalg.det(r))[..., None, None]
    w = np.sqrt(np.maximum(0.0, 1.0 + r[..., 0, 0] + r[..., 1, 1] + r[..., 2, 2])) / 2.0
    parts = [
        np.sqrt(np.maximum(0.0, 1.0 + 2.0 * r[..., i, i] - r[..., 0, 0] - r[..., 1, 1] - r[..., 2, 2])) / 2.0
        for i in range(3)
    ]
    four = np.stack([*parts, w], axis=-1)
    largest = four.argmax(axis=-1)
    xy, xz, yz = r[..., 0, 1] + r[..., 1, 0], r[..., 0, 2] + r[..., 2, 0], r[..., 1, 2] + r[..., 2, 1]
    wx, wy, wz = r[..., 2, 1] - r[..., 1, 2], r[..., 0, 2] - r[..., 2, 0], r[..., 1, 0] - r[..., 0, 1]
    products = {0: (None, xy, xz, wx), 1: (xy, None, yz, wy), 2: (xz, yz, None, wz), 3: (wx, wy, wz, None)}
    out = np.empty_like(four)
    for pivot, row in products.items():
        value = np.maximum(four[..., pivot], 1e-30)
        column = np.stack([value if p is None else p / (4.0 * value) for p in row], axis=-1)
        out = np.where((largest == pivot)[..., None], column, out)
    out /= np.linalg.norm(out, axis=-1, keepdims=True)
    return out * np.where(out[..., 3:] < 0.0, -1.0, 1.0)


def golden_of(poses: Poses, clip: str) -> Golden:
    """The golden of poses, as they are now."""
    world = poses.world_matrices().astype(np.float64)
    return Golden(
        clip, poses.times, _unique(poses.scene.joint_names), world[..., :3, 3], _rotations(world[..., :3, :3])
    )


@dataclass(frozen=True)
class Difference:
    """One joint that is off, at the time where it is worst."""

    joint: str
    time: float
    metres: float
    degrees: float

    def __str__(self) -> str:
        return (
            f"joint {self.joint!r} at {self.time:.4g} s: {self.metres * 1000:.4g} mm and {self.degrees:.3g} degrees off"
        )


def compare(old: Golden, new: Golden, tolerance: str | float, angle_deg: float, size: float) -> list[Difference]:
    """Joints that are off by more than the tolerance, the worst first. Joints and times must be the same."""
    limit = length(tolerance, size)
    if old.joints != new.joints:
        lost, added = sorted(set(old.joints) - set(new.joints)), sorted(set(new.joints) - set(old.joints))
        raise ValueError(
            f"the joints differ: lost {lost}, new {added}" if lost or added else "the joints have another order"
        )
    # A golden holds rounded numbers: half a step of them is no difference.
    distance = np.linalg.norm(new.positions - old.positions, axis=-1) - 1e-6
    dot = np.abs((new.rotations * old.rotations).sum(axis=-1)) / (
        np.linalg.norm(new.rotations, axis=-1) * np.linalg.norm(old.rotations, axis=-1)
    )
    angle = np.degrees(2.0 * np.arccos(np.minimum(dot, 1.0)))
    excess = np.maximum(distance / max(limit, 1e-30), angle / max(angle_deg, 1e-30))
    found = []
    for j in np.argsort(-excess.max(axis=0, initial=0.0)):
        t = int(excess[:, j].argmax())
        if excess[t, j] <= 1.0:
            break
        found.append(
            Difference(
                old.joints[j],
                float(old.times[t]),
                float(np.linalg.norm(new.positions[t, j] - old.positions[t, j])),
                float(angle[t, j]),
            )
        )
    return found
