# SPDX-License-Identifier: MIT
"""Lengths as people write them."""

from __future__ import annotations

import re

_METRES = {"": 1.0, "m": 1.0, "cm": 1e-2, "mm": 1e-3, "um": 1e-6, "µm": 1e-6}
_FORM = re.compile(r"\s*([0-9.]+(?:[eE][-+]?[0-9]+)?)\s*(%|[a-zµ]*)\s*")


def length(text: str | float, size: float | None = None) -> float:
    """Reads a length in metres, or in the file's unit where that is another one.

    `size` is what "%" refers to, such as `Scene.size`.

        >>> length("0.1mm")
        0.0001
        >>> length("2 cm"), length(0.5), length("1%", size=3.0)
        (0.02, 0.5, 0.03)
    """
    if isinstance(text, (int, float)):
        value, unit = float(text), ""
    else:
        match = _FORM.fullmatch(text)
        if match is None:
            raise ValueError(f"{text!r} is not a length such as '0.1mm', '2 cm', '0.01%' or 0.001")
        try:
            value, unit = float(match[1]), match[2]
        except ValueError:
            raise ValueError(f"{text!r}: {match[1]!r} is not a number") from None
    if not 0.0 <= value < float("inf"):
        raise ValueError(f"{text!r} is not a length: it is negative or not finite")
    if unit == "%":
        if size is None:
            raise ValueError(f"{text!r}: a percentage needs a size that it refers to")
        return value / 100.0 * size
    if unit not in _METRES:
        raise ValueError(f"{text!r}: the unit {unit!r} is not m, cm, mm, um or %")
    return value * _METRES[unit]
