# SPDX-License-Identifier: MIT
"""The notebook runs from top to bottom."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

_NOTEBOOK = Path(__file__).parents[2] / "samples/python/trajectories_errors_cost.ipynb"


def test_each_cell_runs(monkeypatch: pytest.MonkeyPatch) -> None:
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    names: dict[str, object] = {}
    cells = [cell for cell in json.loads(_NOTEBOOK.read_text())["cells"] if cell["cell_type"] == "code"]
    for number, cell in enumerate(cells):
        exec(compile("".join(cell["source"]), f"{_NOTEBOOK.name}, code cell {number}", "exec"), names)
    figures = matplotlib.pyplot.get_fignums()
    assert len(figures) == 4
    matplotlib.pyplot.close("all")
