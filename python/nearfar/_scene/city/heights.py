"""Heights of features, from the properties that state them."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base import check

STOREY = 3.0
"""Height of a storey in metres, for features that only state their number of storeys."""

DEFAULT_HEIGHT = 6.0
"""Height of buildings of unknown height, metres: two storeys."""

TALLEST = 10_000.0
"""Height in metres beyond which a value is taken as a marker for unknown."""

HEIGHTS = (
    *((name, 1.0) for name in ("height", "building:height", "measuredHeight", "measured_height", "render_height")),
    ("building_height", 1.0),
    *((name, STOREY) for name in ("building:levels", "building_levels", "levels", "num_floors", "storeysAboveGround")),
)
"""Properties that state heights, in order of precedence, with metres per unit."""

BASES = (
    *((name, 1.0) for name in ("min_height", "building:min_height", "render_min_height", "base_height")),
    *((name, STOREY) for name in ("building:min_level", "min_floor")),
)
"""Properties that state the height of a feature's lower end, with metres per unit."""

_LENGTH = re.compile(
    r"\s*([-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][-+]?[0-9]{1,3})?)\s*(m|metres?|meters?|ft|feet|')?\s*"
)

Column = Callable[[str], NDArray[np.float64] | None]
"""Returns a property's numbers for all features, NaN where missing; None if no feature has the property."""


def read_heights(
    column: Column, keys: Iterable[tuple[str, float]], count: int, name: str | None
) -> NDArray[np.float64]:
    """Read the heights (N,) in metres of `count` features from their properties; NaN where unknown.

    Properties are the `keys` in order of precedence, with metres per unit, or only `name` if given, in metres.
    """
    values = np.full(count, np.nan)
    for key, metres in keys if name is None else [(name, 1.0)]:
        missing = np.isnan(values)
        if not missing.any():
            break
        numbers = column(key)
        if numbers is not None:
            values[missing] = numbers[missing] * metres
    values[~(np.abs(values) <= TALLEST)] = np.nan
    return values


def number(value: Any) -> float:
    """Parse a property as a number: numbers, and text such as "12.5 m" or "40 ft"; NaN for anything else."""
    if isinstance(value, int | float) and not isinstance(value, bool):
        return float(value) if abs(value) <= check.FARTHEST else np.nan
    match = _LENGTH.fullmatch(value) if isinstance(value, str) and len(value) < 40 else None
    if match is None:
        return np.nan
    return float(match[1]) * (0.3048 if match[2] in ("ft", "feet", "'") else 1.0)


def numbers(values: Iterable[Any]) -> NDArray[np.float64] | None:
    """Parse properties of any type as numbers; None if all fail."""
    parsed = np.array([number(value) for value in values], np.float64)
    return None if np.isnan(parsed).all() else parsed
