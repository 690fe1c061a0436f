# SPDX-License-Identifier: MIT
"""A pytest plugin for golden poses.

    def test_walk(pose_golden):
        pose_golden("fox.glb", clip="Walk", tolerance="0.1 mm")

`pytest --sinew-update` writes goldens again. A difference names joint, time, millimetres and degrees; golden, current
poses, differences and, where matplotlib is installed, a picture of both lie in a folder that the message names.
"""

from __future__ import annotations

import os
import re
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest

from sinew._scene import Scene, load
from sinew.golden import Difference, Golden, compare, golden_of

_SHOWN = 8  # differences in a message


def pytest_addoption(parser: pytest.Parser) -> None:
    group = parser.getgroup("sinew")
    group.addoption("--sinew-update", action="store_true", help="write golden poses again")
    group.addoption(
        "--sinew-artifacts", default="sinew-artifacts", metavar="DIR", help="where differences go (%(default)s)"
    )


def _draw(scene: Scene, old: Golden, new: Golden, worst: Difference, file: Path) -> bool:
    """Draws the skeletons of both at the worst time, from the front and the side. False without matplotlib."""
    try:
        from matplotlib.figure import Figure
    except ImportError:
        return False
    t = int(np.abs(old.times - worst.time).argmin())
    figure = Figure(figsize=(10, 5), layout="constrained")
    for panel, (across, title) in enumerate(((0, "front"), (2, "side"))):
        axes = figure.add_subplot(1, 2, panel + 1)
        for golden, colour, label in ((old, "tab:gray", "golden"), (new, "tab:red", "now")):
            place = golden.positions[t]
            for joint, parent in enumerate(scene.parents):
                if parent >= 0:
                    ends = place[[parent, joint]]
                    axes.plot(
                        ends[:, across], ends[:, 1], color=colour, label=label if joint == len(place) - 1 else None
                    )
        j = old.joints.index(worst.joint)
        axes.plot(new.positions[t, j, across], new.positions[t, j, 1], "o", color="tab:red")
        axes.set_aspect("equal", adjustable="datalim")
        axes.set_title(f"{title}: {worst.joint} at {worst.time:.4g} s")
    axes.legend()
    figure.savefig(file, dpi=100)
    return True


def _report(scene: Scene, old: Golden, new: Golden, found: list[Difference], folder: Path) -> str:
    folder.mkdir(parents=True, exist_ok=True)
    old.write(folder / "golden.json")
    new.write(folder / "now.json")
    rows = ["joint,time_s,metres,degrees"] + [f"{d.joint},{d.time!r},{d.metres!r},{d.degrees!r}" for d in found]
    (folder / "differences.csv").write_text("\n".join(rows) + "\n")
    drawn = _draw(scene, old, new, found[0], folder / "difference.png")
    lines = [f"  {difference}" for difference in found[:_SHOWN]]
    if len(found) > _SHOWN:
        lines.append(f"  {len(found) - _SHOWN} more joints")
    picture = " with a picture" if drawn else " (no picture: matplotlib is not installed)"
    return "\n".join([*lines, f"old, new and differences are in {folder}{picture}", "--sinew-update accepts them"])


class PoseGolden:
    """Type of the fixture: compares a clip of a file with its golden poses, in `goldens/` beside the test."""

    def __init__(self, request: pytest.FixtureRequest) -> None:
        self._request = request
        self._made: set[str] = set()

    def __call__(
        self,
        file: str | os.PathLike[str],
        *,
        clip: str | int = 0,
        tolerance: str | float = "0.1mm",
        angle: float = 0.1,
        times: Sequence[float] | int = 9,
        name: str | None = None,
    ) -> None:
        beside = Path(self._request.path).parent
        scene = load(beside / file)
        chosen = scene.clips[clip]
        at = np.linspace(0.0, chosen.duration, times) if isinstance(times, int) else np.asarray(times, dtype=np.float64)
        new = golden_of(chosen.sample(at), chosen.name)
        stem = re.sub(r"[^\w.-]+", "_", name or f"{self._request.node.name}-{Path(file).stem}-{chosen.name or clip}")
        if stem in self._made:
            pytest.fail(f"two goldens of this test are called {stem!r}: give one of them a name")
        self._made.add(stem)
        golden = beside / "goldens" / f"{stem}.json"
        if self._request.config.getoption("--sinew-update"):
            new.write(golden)
            return
        if not golden.exists():
            pytest.fail(f"{golden}: there is no golden yet; pytest --sinew-update writes it")
        old = Golden.read(golden)
        if not np.allclose(old.times, at, rtol=0.0, atol=1e-6):
            pytest.fail(f"{golden}: has other times ({len(old.times)}, and the clip is asked for {len(at)})")
        found = compare(old, new, tolerance, angle, scene.size)
        if found:
            folder = Path(self._request.config.getoption("--sinew-artifacts")) / stem
            pytest.fail(
                f"{file}, clip {chosen.name!r}: {len(found)} joints moved\n{_report(scene, old, new, found, folder)}",
                pytrace=False,
            )


@pytest.fixture
def pose_golden(request: pytest.FixtureRequest) -> PoseGolden:
    """Compares a clip of a file with its golden poses."""
    return PoseGolden(request)
