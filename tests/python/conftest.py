# SPDX-License-Identifier: MIT
"""Files that tests read: the package's own sample, and nothing else."""

from __future__ import annotations

from pathlib import Path

import pytest

import sinew

pytest_plugins = ["pytester"]


@pytest.fixture
def tube(tmp_path: Path) -> Path:
    """A skinned tube of three joints whose clip "Bend" turns the upper two by 60 degrees at 0.5 s."""
    return sinew.sample_file(tmp_path)
