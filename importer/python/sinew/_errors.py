# SPDX-License-Identifier: MIT
"""Errors of files."""

from __future__ import annotations

from typing import NamedTuple


class Issue(NamedTuple):
    """One violation of a rule in a file.

    `rule` is a stable identifier such as "accessor-fit", `pointer` the place by RFC 6901 ("/accessors/3/count", or ""
    for the whole file).
    """

    severity: str
    rule: str
    pointer: str
    detail: str


class FileError(ValueError):
    """A file that cannot be used.

    `rule`, `pointer` and `detail` are those of the first error; `issues` has all errors and warnings.
    """

    def __init__(self, message: str, file: str, issues: list[tuple[str, str, str, str]]) -> None:
        super().__init__(message)
        self.file = file
        self.issues = [Issue(*issue) for issue in issues]
        self.rule = self.issues[0].rule
        self.pointer = self.issues[0].pointer
        self.detail = self.issues[0].detail
