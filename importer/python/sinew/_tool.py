# SPDX-License-Identifier: MIT
"""The command-line tool, which the package carries."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any, NamedTuple, NoReturn

_TOOL = Path(__file__).with_name("bin") / ("sinew.exe" if sys.platform == "win32" else "sinew")


class ToolResult(NamedTuple):
    """Outcome of a run of the tool: exit code, standard output, standard error."""

    code: int
    out: str
    err: str


def run_tool(arguments: Sequence[str | os.PathLike[str]]) -> ToolResult:
    """Runs `sinew ARGUMENTS...` and waits for it.

    >>> run_tool(["--version"]).code
    0
    """
    done = subprocess.run(
        [_TOOL, *(os.fspath(argument) for argument in arguments)], capture_output=True, text=True, check=False
    )
    return ToolResult(done.returncode, done.stdout, done.stderr)


def exec_tool(arguments: Sequence[str]) -> NoReturn:
    """Becomes the tool."""
    if sys.platform == "win32":
        sys.exit(subprocess.run([_TOOL, *arguments], check=False).returncode)
    os.execv(_TOOL, ["sinew", *arguments])


def verify(
    file: str | os.PathLike[str], golden: str | os.PathLike[str], tolerance: str = "0.1mm"
) -> tuple[bool, list[str]]:
    """Compares a file with poses that `sinew sample` wrote.

    Returns whether all values are within the tolerance, and a line for the outcome and for each of the worst
    differences. Raises OSError where nothing could be compared.
    """
    done = run_tool(["verify", file, golden, "--tolerance", tolerance])
    if done.code not in (0, 1):
        raise OSError(done.err.strip() or f"sinew verify ended with {done.code}")
    return done.code == 0, [line.strip() for line in done.out.splitlines() if line.strip()]


def cost(file: str | os.PathLike[str]) -> dict[str, Any]:
    """Measures what accuracy costs in time on a model: the numbers of `sinew cost`. Takes minutes."""
    with tempfile.TemporaryDirectory() as folder:
        done = run_tool(["cost", file, "-o", folder])
        if done.code != 0:
            raise OSError(done.err.strip() or f"sinew cost ended with {done.code}")
        report = next(iter(sorted(Path(folder).glob("*.json"))), None)
        if report is None:
            raise OSError("sinew cost wrote no numbers")
        numbers: dict[str, Any] = json.loads(report.read_text())
        return numbers
