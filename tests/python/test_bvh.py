# SPDX-License-Identifier: MIT
"""BVH out and in."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import sinew


def random_poses(tube: Path, seed: int) -> sinew.Poses:
    scene = sinew.load(tube)
    clip = scene.clips[0]
    poses = clip.sample(np.arange(16) / 30.0)
    random = np.random.default_rng(seed)
    poses.rotations[:] = random.normal(size=poses.rotations.shape)
    poses.rotations[:] /= np.linalg.norm(poses.rotations, axis=-1, keepdims=True)
    poses.rotations[3, 2] = [np.sin(np.pi / 4), 0.0, 0.0, np.cos(np.pi / 4)]  # 90 degrees about x: locked
    poses.rotations[4, 2] = [-0.5, 0.5, -0.5, 0.5]
    return poses


@pytest.mark.parametrize("seed", range(4))
def test_poses_come_back(tube: Path, tmp_path: Path, seed: int) -> None:
    poses = random_poses(tube, seed)
    file = tmp_path / "motion.bvh"
    sinew.to_bvh(poses, file)
    again = sinew.from_bvh(file)
    back = again.clips[0].sample(poses.times)
    ours, theirs = poses.world_matrices(), back.world_matrices()
    for joint, name in enumerate(poses.scene.joint_names):
        assert np.abs(ours[:, joint] - theirs[:, again.joint(name)]).max() < 2e-5, name


def test_unequal_steps_and_scales_are_refused(tube: Path, tmp_path: Path) -> None:
    poses = sinew.load(tube).clips[0].sample([0.0, 0.1, 0.3])
    with pytest.raises(ValueError, match="equal steps"):
        sinew.to_bvh(poses, tmp_path / "a.bvh")
    poses = sinew.load(tube).clips[0].sample([0.0, 0.1, 0.2])
    poses.scales[1, 2, 0] = 2.0
    with pytest.raises(ValueError, match="'middle' has a scale"):
        sinew.to_bvh(poses, tmp_path / "a.bvh")
    assert not (tmp_path / "a.bvh").exists()
    with pytest.raises(ValueError, match=r"\.bvh"):
        sinew.from_bvh(tube)
