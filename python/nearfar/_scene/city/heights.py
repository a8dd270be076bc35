"""Heights of features by the properties that state them."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base import check

STOREY = 3.0
"""Height in metres of a storey, where only their number is stated."""

DEFAULT_HEIGHT = 6.0
"""Height in metres of buildings of unknown height: two storeys."""

TALLEST = 10_000.0
"""Height in metres beyond which a value is no height but a mark for unknown."""

HEIGHTS = (
    ("height", 1.0),
    ("building:height", 1.0),
    ("measuredHeight", 1.0),
    ("measured_height", 1.0),
    ("render_height", 1.0),
    ("building_height", 1.0),
    ("building:levels", STOREY),
    ("building_levels", STOREY),
    ("levels", STOREY),
    ("num_floors", STOREY),
    ("storeysAboveGround", STOREY),
)
"""Properties that state heights, the first one of a feature that has a value counts; and metres in their unit."""

BASES = (
    ("min_height", 1.0),
    ("building:min_height", 1.0),
    ("render_min_height", 1.0),
    ("base_height", 1.0),
    ("building:min_level", STOREY),
    ("min_floor", STOREY),
)
"""Properties that state the height of the lower end."""

_LENGTH = re.compile(
    r"\s*([-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][-+]?[0-9]{1,3})?)\s*(m|metres?|meters?|ft|feet|')?\s*"
)

Column = Callable[[str], NDArray[np.float64] | None]
"""Returns a property's numbers for all features, not a number where it states none; None if no feature has it."""


def stated(column: Column, known: Iterable[tuple[str, float]], count: int, name: str | None) -> NDArray[np.float64]:
    """Metres that properties state for each feature (N,), not a number where none does.

    Parameters
    ----------
    column
        Returns a property.
    known
        Properties in the order in which they count, with metres in their unit.
    count
        Number of features.
    name
        The only property that counts, in metres; None for the known ones.
    """
    values = np.full(count, np.nan)
    for key, metres in known if name is None else [(name, 1.0)]:
        missing = np.isnan(values)
        if not missing.any():
            break
        found = column(key)
        if found is not None:
            values[missing] = found[missing] * metres
    values[~(np.abs(values) <= TALLEST)] = np.nan
    return values


def number(value: Any) -> float:
    """A property as a number: numbers, and text such as "12.5 m" or "40 ft"; not a number for others."""
    if isinstance(value, int | float) and not isinstance(value, bool):
        return float(value) if abs(value) <= check.FARTHEST else np.nan
    match = _LENGTH.fullmatch(value) if isinstance(value, str) and len(value) < 40 else None
    if match is None:
        return np.nan
    return float(match[1]) * (0.3048 if match[2] in ("ft", "feet", "'") else 1.0)


def numbers(values: Iterable[Any]) -> NDArray[np.float64] | None:
    """Properties of any type as numbers; None if none states one."""
    found = np.array([number(value) for value in values], np.float64)
    return found if len(found) and not np.isnan(found).all() else None
