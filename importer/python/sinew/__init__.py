# SPDX-License-Identifier: MIT
"""Poses and skinned vertices of glTF files as NumPy arrays.

>>> import sinew
>>> scene = sinew.load(sinew.sample_file())
>>> poses = scene.clips[0].sample([0.0, 0.5])
>>> poses.rotations.shape  # [frame, joint, 4] x y z w
(2, 4, 4)
>>> scene.skin(poses)[0].positions.shape  # [frame, vertex, 3]
(2, 24, 3)
"""

from sinew._errors import FileError, Issue
from sinew._lengths import length
from sinew._samples import sample_file
from sinew._scene import Certificate, Clip, Clips, Poses, Primitive, Scene, blend, check, load, retarget
from sinew._tool import cost, run_tool, verify
from sinew.bvh import from_bvh, to_bvh

__version__ = "0.1.0"
__all__ = [
    "Certificate",
    "Clip",
    "Clips",
    "FileError",
    "Issue",
    "Poses",
    "Primitive",
    "Scene",
    "blend",
    "check",
    "cost",
    "from_bvh",
    "length",
    "load",
    "retarget",
    "run_tool",
    "sample_file",
    "to_bvh",
    "verify",
]
