# SPDX-License-Identifier: MIT
"""The plugin, run inside of a test."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

import sinew

_TEST = """
def test_bend(pose_golden):
    pose_golden("sinew_tube.gltf", clip="Bend", tolerance="0.1 mm")
"""


@pytest.fixture
def project(pytester: pytest.Pytester) -> pytest.Pytester:
    sinew.sample_file(pytester.path)
    pytester.makepyfile(_TEST)
    return pytester


def change(project: pytest.Pytester, height: float) -> None:
    file = project.path / "sinew_tube.gltf"
    file.write_text(file.read_text().replace('"translation": [0, 1, 0]', f'"translation": [0, {height}, 0]', 1))


def test_a_golden_has_to_be_written_first(project: pytest.Pytester) -> None:
    project.runpytest("-p", "no:cacheprovider").stdout.fnmatch_lines(["*--sinew-update writes it*"])
    project.runpytest("--sinew-update").assert_outcomes(passed=1)
    project.runpytest().assert_outcomes(passed=1)
    golden = json.loads(next((project.path / "goldens").glob("*.json")).read_text())
    assert len(golden["joints"]["tip"]) == 9 and len(golden["joints"]["tube"]) == 1


def test_a_difference_names_joint_time_and_millimetres(project: pytest.Pytester) -> None:
    project.runpytest("--sinew-update")
    change(project, 1.002)
    run = project.runpytest()
    run.assert_outcomes(failed=1)
    run.stdout.fnmatch_lines(["*2 joints moved*", "*joint 'middle' at * s: 2 mm and 0 degrees off*"])
    folder = next((project.path / "sinew-artifacts").iterdir())
    assert {"golden.json", "now.json", "differences.csv"} <= {file.name for file in folder.iterdir()}
    project.runpytest("--sinew-update").assert_outcomes(passed=1)
    project.runpytest().assert_outcomes(passed=1)


def test_a_smaller_difference_than_the_tolerance_passes(project: pytest.Pytester) -> None:
    project.runpytest("--sinew-update")
    change(project, 1.00008)
    project.runpytest().assert_outcomes(passed=1)


def test_a_damaged_golden_is_named(project: pytest.Pytester) -> None:
    project.runpytest("--sinew-update")
    golden = next((project.path / "goldens").glob("*.json"))
    golden.write_text("{}")
    project.runpytest().stdout.fnmatch_lines([f"*{golden.name}: is no golden file of sinew*"])


def test_a_picture_shows_both(project: pytest.Pytester) -> None:
    pytest.importorskip("matplotlib")
    project.runpytest("--sinew-update")
    change(project, 1.3)
    project.runpytest().assert_outcomes(failed=1)
    picture: Path = next((project.path / "sinew-artifacts").glob("*/difference.png"))
    assert picture.stat().st_size > 5000
