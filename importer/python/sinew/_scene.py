# SPDX-License-Identifier: MIT
"""Scenes, clips and poses."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Literal, NamedTuple, overload

import numpy as np
import numpy.typing as npt

from sinew import _sinew
from sinew._errors import Issue
from sinew._lengths import length
from sinew._samples import sample_file  # noqa: F401  (doctests)

Floats = npt.NDArray[np.float32]
Skinning = Literal["linear", "dual_quaternion", "center_of_rotation"]


def _threads(threads: int | None) -> int:
    return threads if threads is not None else len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else 1


class Primitive(NamedTuple):
    """Vertices of one primitive of one mesh instance in world space, in the order of the file.

    `positions` and `normals` are [frame, vertex, 3]; `normals` is None where they were not asked for or not there.
    """

    node: int
    mesh: int
    primitive: int
    positions: Floats
    normals: Floats | None


@dataclass(frozen=True)
class Poses:
    """Local poses of a scene, one a frame. Arrays are float32 and belong to the caller: change them at will.

    Rotations are unit quaternions in the order x y z w, as in glTF. Lengths are in the file's unit, metres by
    convention.
    """

    scene: Scene
    times: npt.NDArray[np.float64]  #: [frame] seconds
    translations: Floats  #: [frame, joint, 3]
    rotations: Floats  #: [frame, joint, 4] x y z w
    scales: Floats  #: [frame, joint, 3]
    weights: Floats  #: [frame, weight] morph weights of all mesh instances, one after another

    def __len__(self) -> int:
        return len(self.times)

    def _arrays(self) -> tuple[Floats, Floats, Floats, Floats]:
        def floats(array: Floats) -> Floats:
            return np.ascontiguousarray(array, dtype=np.float32)

        return floats(self.translations), floats(self.rotations), floats(self.scales), floats(self.weights)

    def world_matrices(self, threads: int | None = None) -> Floats:
        """World matrices, [frame, joint, 4, 4]: `matrix @ [x, y, z, 1]`.

        >>> poses = load(sample_file()).clips["Bend"].sample([0.5])
        >>> [round(float(height), 3) for height in poses.world_matrices()[0, :, 1, 3]]
        [0.0, 0.25, 1.25, 1.75]
        """
        return _sinew.world(self.scene._handle, *self._arrays(), _threads(threads))


class Certificate(NamedTuple):
    """Measured error and size of a clip that was compiled within a budget. Lengths are in the file's unit."""

    asked: float
    measured: float
    worst_time: float
    worst_joint: str | None
    source_keys: int
    kept_keys: int
    source_bytes: int
    bytes: int


class Clip:
    """An animation of a scene. Get it from `Scene.clips`."""

    def __init__(self, scene: Scene, handle: _sinew.Clip) -> None:
        self.scene = scene
        self._handle = handle

    def __repr__(self) -> str:
        return f"<sinew.Clip {self.name!r} of {self.duration:.3g} s>"

    @property
    def name(self) -> str:
        return self._handle.name

    @property
    def duration(self) -> float:
        """Seconds."""
        return self._handle.duration

    @property
    def byte_size(self) -> int:
        """Bytes of its keys in memory."""
        return self._handle.byte_size

    @property
    def certificate(self) -> Certificate | None:
        """Present if the clip comes from `compile`."""
        numbers = self._handle.certificate
        return Certificate(**numbers) if numbers is not None else None

    def times(self, fps: float = 30.0) -> npt.NDArray[np.float64]:
        """The times of frames from 0 to the end, at `fps` frames a second. The last is the end itself.

        >>> load(sample_file()).clips["Bend"].times(fps=4).tolist()
        [0.0, 0.25, 0.5, 0.75, 1.0]
        """
        if not fps > 0.0:
            raise ValueError(f"fps is {fps}: it must be above 0")
        frames = np.arange(0.0, self.duration * fps * (1.0 - 1e-9)) / fps
        return np.append(frames, self.duration)

    def sample(self, times: npt.ArrayLike | None = None, threads: int | None = 1) -> Poses:
        """Local poses at these times in seconds; without times, 30 a second over the clip.

        Each track clamps to its first and last key. `threads` of None means all cores; results do not depend on it.

            >>> poses = load(sample_file()).clips["Bend"].sample([0.0, 0.5])
            >>> poses.rotations[1, 2].astype(float).round(3).tolist()  # the middle joint, turned by 60 degrees about z
            [0.0, 0.0, 0.5, 0.866]
        """
        array = self.times() if times is None else np.ascontiguousarray(np.atleast_1d(times), dtype=np.float64)
        return Poses(self.scene, array, *_sinew.sample(self._handle, array, _threads(threads)))

    def compile(self, budget: str | float) -> Clip:
        """The smallest clip within an error budget, such as "0.1mm" or "0.01%" of the model's size.

        The error is a distance of vertices, measured at keys and between them; `certificate` has it.

            >>> clip = load(sample_file()).clips["Bend"].compile("0.1mm")
            >>> clip.certificate.measured <= 1e-4
            True
        """
        metres = length(budget, self.scene.size)
        return Clip(self.scene, _sinew.compile_within(self._handle, metres))


class Clips(Sequence[Clip]):
    """The clips of a scene, by index or by name."""

    def __init__(self, clips: Sequence[Clip]) -> None:
        self._clips = list(clips)

    def __len__(self) -> int:
        return len(self._clips)

    def __iter__(self) -> Iterator[Clip]:
        return iter(self._clips)

    def __repr__(self) -> str:
        return f"<sinew.Clips {self.names}>"

    @property
    def names(self) -> list[str]:
        return [clip.name for clip in self._clips]

    @overload
    def __getitem__(self, key: int | str) -> Clip: ...
    @overload
    def __getitem__(self, key: slice) -> Sequence[Clip]: ...
    def __getitem__(self, key: int | str | slice) -> Clip | Sequence[Clip]:
        """The clip of an index, or the first one of a name. `KeyError` lists the names that there are."""
        if not isinstance(key, str):
            return self._clips[key]
        for clip in self._clips:
            if clip.name == key:
                return clip
        raise KeyError(f"no clip is called {key!r}; there are {', '.join(map(repr, self.names)) or 'none'}")


class Scene:
    """The assets of one file. Get it from `load`."""

    def __init__(self, handle: _sinew.Scene) -> None:
        self._handle = handle
        self._size: float | None = None
        self.joint_names: list[str] = handle.joint_names  #: [joint] may repeat or be empty
        self.parents: npt.NDArray[np.int64] = np.array(handle.parents, dtype=np.int64)  #: [joint] -1 for a root
        self.nodes: npt.NDArray[np.int64] = np.array(handle.nodes, dtype=np.int64)  #: [joint] index in the file
        self.clips = Clips([Clip(self, clip) for clip in handle.clips()])

    def __repr__(self) -> str:
        return f"<sinew.Scene {self.file!r}: {len(self.joint_names)} joints, {len(self.clips)} clips>"

    @property
    def file(self) -> str:
        return self._handle.file

    @property
    def warnings(self) -> list[Issue]:
        """Repairs, and parts that were left out. `check` finds more."""
        return [Issue(*issue) for issue in self._handle.warnings]

    @property
    def weight_count(self) -> int:
        return self._handle.weight_count

    @property
    def size(self) -> float:
        """Longest side of the box around all vertices at rest, or around all joints without vertices: what % means."""
        if self._size is None:
            rest = self.rest()
            points = [primitive.positions[0] for primitive in self.skin(rest)]
            cloud = np.concatenate(points) if points else rest.world_matrices()[0, :, :3, 3]
            self._size = float(np.ptp(cloud, axis=0).max()) if len(cloud) else 0.0
        return self._size

    def joint(self, name: str) -> int:
        """Index of the first joint of a name. `KeyError` if there is none."""
        try:
            return self.joint_names.index(name)
        except ValueError:
            raise KeyError(f"no joint is called {name!r}") from None

    def rest(self) -> Poses:
        """The rest pose, as one frame."""
        return Poses(self, np.zeros(1), *self._handle.rest())

    def skin(
        self, poses: Poses, kind: Skinning = "linear", normals: bool = False, threads: int | None = 1
    ) -> list[Primitive]:
        """Morphed and skinned vertices of all meshes in world space.

        "center_of_rotation" needs `load(..., centers_of_rotation=True)`, and is linear elsewhere.

            >>> scene = load(sample_file())
            >>> top = scene.skin(scene.clips["Bend"].sample([0.0, 0.5]))[0].positions[:, -1]
            >>> top.astype(float).round(2).tolist()
            [[0.14, 3.0, -0.14], [-1.8, 1.37, -0.14]]
        """
        found = _sinew.skin(self._handle, *poses._arrays(), kind, normals, _threads(threads))
        return [Primitive(*primitive) for primitive in found]


def load(file: str | os.PathLike[str], *, centers_of_rotation: bool = False, images: bool = False) -> Scene:
    """Reads a glTF, BVH, FBX or COLLADA file.

    Raises `FileError`, which names the file, the place in it and the rule.

        >>> load(sample_file())
        <sinew.Scene '...sinew_tube.gltf': 4 joints, 1 clips>
    """
    return Scene(_sinew.load(os.fspath(file), centers_of_rotation, images))


def check(file: str | os.PathLike[str]) -> list[Issue]:
    """Everything that is wrong or unusual about a glTF file, errors first; empty if nothing is.

    >>> [issue.rule for issue in check(sample_file()) if issue.severity != "info"]
    []
    """
    return [Issue(*issue) for issue in _sinew.check(os.fspath(file))]


def blend(poses: Sequence[Poses], weights: Sequence[float]) -> Poses:
    """Weighted mean of poses of one scene, frame by frame. The rest pose gets what the weights lack to 1.

    >>> clip = load(sample_file()).clips["Bend"]
    >>> half = blend([clip.sample([0.0]), clip.sample([0.5])], [0.5, 0.5])
    >>> half.rotations[0, 2].astype(float).round(3).tolist()  # turned by 30 degrees
    [0.0, 0.0, 0.259, 0.966]
    """
    if not poses:
        raise ValueError("blend: there are no poses")
    scene = poses[0].scene
    if any(pose.scene is not scene for pose in poses):
        raise ValueError("blend: the poses are of different scenes; retarget the clips first")
    arrays = _sinew.blend(scene._handle, [pose._arrays() for pose in poses], list(map(float, weights)))
    return Poses(scene, poses[0].times, *arrays)


def retarget(clip: Clip, target: Scene, *, hold_feet: bool = False) -> Clip:
    """A clip of one body for another. Bones are found by names, or by what VRM files say of them.

    `hold_feet` keeps feet in place while those of the source stand.

        >>> scene = load(sample_file())
        >>> retarget(scene.clips["Bend"], load(sample_file())).name
        'Bend'
    """
    made, _, _ = _sinew.retarget(clip._handle, target._handle, hold_feet)
    return Clip(target, made)
