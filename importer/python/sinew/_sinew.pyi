# SPDX-License-Identifier: MIT
"""Signatures of the compiled module. Poses are (translations, rotations, scales, weights)."""

import os
from collections.abc import Sequence
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

_Floats: TypeAlias = npt.NDArray[np.float32]
_Pose: TypeAlias = tuple[_Floats, _Floats, _Floats, _Floats]
_Issue: TypeAlias = tuple[str, str, str, str]

class Scene:
    file: str
    joint_names: list[str]
    parents: list[int]
    nodes: list[int]
    weight_count: int
    warnings: list[_Issue]
    def clips(self) -> list[Clip]: ...
    def rest(self) -> _Pose: ...

class Clip:
    name: str
    duration: float
    index: int
    byte_size: int
    certificate: dict[str, Any] | None

def load(file: str | os.PathLike[str], centers_of_rotation: bool, images: bool) -> Scene: ...
def check(file: str | os.PathLike[str]) -> list[_Issue]: ...
def sample(clip: Clip, times: npt.NDArray[np.float64], threads: int) -> _Pose: ...
def world(
    scene: Scene, translations: _Floats, rotations: _Floats, scales: _Floats, weights: _Floats, threads: int
) -> _Floats: ...
def blend(scene: Scene, poses: Sequence[_Pose], weights: Sequence[float]) -> _Pose: ...
def skin(
    scene: Scene,
    translations: _Floats,
    rotations: _Floats,
    scales: _Floats,
    weights: _Floats,
    kind: str,
    normals: bool,
    threads: int,
) -> list[tuple[int, int, int, _Floats, _Floats | None]]: ...
def compile_within(clip: Clip, budget: float) -> Clip: ...
def retarget(clip: Clip, target: Scene, hold_feet: bool) -> tuple[Clip, list[str], float]: ...
