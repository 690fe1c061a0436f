# SPDX-License-Identifier: MIT
"""Poses and vertices against plain double-precision formulas."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import sinew


def slerp(a: np.ndarray, b: np.ndarray, share: float) -> np.ndarray:
    """Shortest arc between unit quaternions."""
    dot = float(a @ b)
    b, dot = (-b, -dot) if dot < 0 else (b, dot)
    angle = np.arccos(min(dot, 1.0))
    if angle < 1e-9:
        return a
    return (np.sin((1 - share) * angle) * a + np.sin(share * angle) * b) / np.sin(angle)


def matrix(translation: np.ndarray, rotation: np.ndarray, scale: np.ndarray) -> np.ndarray:
    """T R S as 4 x 4."""
    x, y, z, w = rotation
    out = np.eye(4)
    out[:3, :3] = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    ) * np.asarray(scale)
    out[:3, 3] = translation
    return out


def test_rotations_follow_slerp_between_keys(tube: Path) -> None:
    times = np.linspace(0.0, 1.0, 41)
    poses = sinew.load(tube).clips["Bend"].sample(times)
    rest, bent = np.array([0, 0, 0, 1.0]), np.array([0, 0, 0.5, np.sqrt(0.75)])
    for frame, time in enumerate(times):
        share = time * 2 if time <= 0.5 else 2 - time * 2
        expected = slerp(rest, bent, share)
        assert np.abs(poses.rotations[frame, 2] - expected).max() < 3e-7


def test_world_matrices_are_products_down_the_hierarchy(tube: Path) -> None:
    scene = sinew.load(tube)
    poses = scene.clips["Bend"].sample([0.0, 0.3, 0.5])
    world = poses.world_matrices()
    for frame in range(3):
        made: list[np.ndarray] = []
        for joint, parent in enumerate(scene.parents):
            local = matrix(
                poses.translations[frame, joint].astype(float),
                poses.rotations[frame, joint].astype(float),
                poses.scales[frame, joint].astype(float),
            )
            made.append(local if parent < 0 else made[parent] @ local)
        assert np.abs(np.array(made) - world[frame]).max() < 1e-6


def test_vertices_are_those_of_linear_blend_skinning(tube: Path) -> None:
    scene = sinew.load(tube)
    poses = scene.clips["Bend"].sample([0.0, 0.4, 0.5])
    rest = scene.skin(scene.rest())[0].positions[0].astype(float)
    world = poses.world_matrices().astype(float)
    joints = [scene.joint(name) for name in ("root", "middle", "tip")]
    bind = scene.rest().world_matrices()[0].astype(float)
    for frame, positions in enumerate(scene.skin(poses)[0].positions):
        for vertex, place in enumerate(rest):
            lower = min(int(min(place[1], 2.0)), 2)
            share = min(place[1], 2.0) - lower
            upper = min(lower + 1, 2)
            blended = sum(
                weight * world[frame, joints[j]] @ np.linalg.inv(bind[joints[j]])
                for j, weight in ((lower, 1 - share), (upper, share))
            )
            assert np.abs((blended @ [*place, 1.0])[:3] - positions[vertex]).max() < 2e-6


def test_arrays_may_be_changed_and_skinned_again(tube: Path) -> None:
    scene = sinew.load(tube)
    poses = scene.rest()
    poses.translations[0, scene.joint("root"), 0] = 2.0
    moved, rest = scene.skin(poses)[0].positions, scene.skin(scene.rest())[0].positions
    assert np.abs(moved - rest - [2.0, 0.0, 0.0]).max() < 1e-6


@pytest.mark.parametrize("kind", ["linear", "dual_quaternion", "center_of_rotation"])
def test_threads_change_no_bit(tube: Path, kind: sinew._scene.Skinning) -> None:
    scene = sinew.load(tube, centers_of_rotation=True)
    clip = scene.clips["Bend"]
    one, four = clip.sample(clip.times(97), threads=1), clip.sample(clip.times(97), threads=4)
    assert one.rotations.tobytes() == four.rotations.tobytes()
    a = scene.skin(one, kind, normals=True, threads=1)[0]
    b = scene.skin(four, kind, normals=True, threads=4)[0]
    assert a.positions.tobytes() == b.positions.tobytes()
    assert a.normals is not None and b.normals is not None and a.normals.tobytes() == b.normals.tobytes()
    assert np.abs(np.linalg.norm(a.normals, axis=-1) - 1.0).max() < 1e-5


def test_dual_quaternions_keep_the_volume_that_linear_blending_loses(tube: Path) -> None:
    scene = sinew.load(tube)
    poses = scene.clips["Bend"].sample([0.5])

    def width(kind: sinew._scene.Skinning) -> float:
        rings = scene.skin(poses, kind)[0].positions[0].reshape(6, 4, 3)
        return float(np.linalg.norm(rings[2, 0] - rings[2, 2]))

    assert width("dual_quaternion") > width("linear")


def test_clips_and_scenes_outlive_what_made_them(tube: Path) -> None:
    clip = sinew.load(tube).clips["Bend"]
    poses = clip.sample([0.5])
    del clip
    assert poses.scene.skin(poses)[0].positions.shape == (1, 24, 3)
    rotations = poses.rotations
    del poses
    assert abs(float(rotations[0, 2, 2]) - 0.5) < 1e-6


def test_a_compiled_clip_stays_within_its_budget(tube: Path) -> None:
    scene = sinew.load(tube)
    clip = scene.clips["Bend"]
    small = clip.compile("1mm")
    times = clip.times(240)
    difference = scene.skin(clip.sample(times))[0].positions - scene.skin(small.sample(times))[0].positions
    assert small.certificate is not None
    assert np.linalg.norm(difference, axis=-1).max() <= 1e-3 >= small.certificate.measured
    assert clip.certificate is None
    with pytest.raises(ValueError, match="compiled before"):
        small.compile("1mm")


def test_blending_takes_the_mean_and_fills_up_with_the_rest_pose(tube: Path) -> None:
    scene = sinew.load(tube)
    a, b = scene.clips[0].sample([0.0]), scene.clips[0].sample([0.5])
    half = sinew.blend([a, b], [0.5, 0.5])
    assert np.abs(half.rotations[0, 2] - [0, 0, np.sin(np.pi / 12), np.cos(np.pi / 12)]).max() < 1e-6
    assert np.abs(sinew.blend([b], [0.5]).rotations[0, 2] - half.rotations[0, 2]).max() < 1e-6
    with pytest.raises(ValueError, match="below 0"):
        sinew.blend([a, b], [0.5, -0.5])
    with pytest.raises(ValueError, match="one weight for each"):
        sinew.blend([a, b], [1.0])
    with pytest.raises(ValueError, match="different scenes"):
        sinew.blend([a, sinew.load(tube).rest()], [0.5, 0.5])


def test_retargeting_to_the_same_body_keeps_the_motion(tube: Path) -> None:
    source, target = sinew.load(tube), sinew.load(tube)
    clip = sinew.retarget(source.clips["Bend"], target)
    assert clip.scene is target
    assert np.abs(clip.sample([0.3]).rotations - source.clips["Bend"].sample([0.3]).rotations).max() < 1e-6


def test_misuse_is_an_error_with_a_sentence(tube: Path, tmp_path: Path) -> None:
    scene = sinew.load(tube)
    with pytest.raises(KeyError, match="'Run'; there are 'Bend'"):
        scene.clips["Run"]
    with pytest.raises(ValueError, match=r"times\[1\]"):
        scene.clips[0].sample([0.0, float("nan")])
    with pytest.raises(ValueError, match="'cubic' is not"):
        scene.skin(scene.rest(), "cubic")  # type: ignore[arg-type]
    wrong = scene.rest()
    short = sinew.Poses(scene, wrong.times, wrong.translations[:, :2], wrong.rotations, wrong.scales, wrong.weights)
    with pytest.raises(ValueError, match=r"translations: the shape is not \[1, 4, 3\]"):
        scene.skin(short)
    wrong.translations[0, 0, 0] = float("inf")
    with pytest.raises(ValueError):
        scene.skin(wrong)
    with pytest.raises(ValueError, match="unit 'ell'"):
        scene.clips[0].compile("1 ell")


def test_a_broken_file_names_file_place_and_rule(tube: Path) -> None:
    tube.write_text(tube.read_text().replace('"skin": 0', '"skin": 7'))
    with pytest.raises(sinew.FileError) as raised:
        sinew.load(tube)
    error = raised.value
    assert error.file == str(tube) and error.pointer == "/nodes/0/skin" and error.rule
    assert error.pointer in str(error) and error.rule in str(error)
    assert sinew.check(tube)[0].severity == "error"
    with pytest.raises(sinew.FileError, match="missing"):
        sinew.load(tube.with_name("missing.glb"))


def test_the_module_is_the_tool(tube: Path) -> None:
    shown = subprocess.run([sys.executable, "-m", "sinew", "info", tube], capture_output=True, text=True, check=True)
    assert "Bend" in shown.stdout
    assert subprocess.run([sys.executable, "-m", "sinew", "info", "missing.glb"], capture_output=True).returncode == 1


def test_verify_says_what_moved(tube: Path, tmp_path: Path) -> None:
    golden = tmp_path / "golden.json"
    assert sinew.run_tool(["sample", tube, "-o", golden]).code == 0
    assert sinew.verify(tube, golden)[0]
    tube.write_text(tube.read_text().replace('"translation": [0, 1, 0]', '"translation": [0, 1.01, 0]', 1))
    held, lines = sinew.verify(tube, golden)
    assert not held and any("middle" in line for line in lines)
    with pytest.raises(OSError):
        sinew.verify(tube, tmp_path / "none.json")
