"""Checked access to entries of untrusted JSON documents; errors state the JSON path of the wrong entry."""

from __future__ import annotations

import json
from typing import Any, NoReturn, TypeVar

import numpy as np
from numpy.typing import NDArray

from nearfar._base import check
from nearfar._base.errors import UnusableError

Kind = TypeVar("Kind")

TILE_FARTHEST = 1e10
"""Greatest coordinate of a tile in metres: over a thousand Earth radii, as most tilesets are Earth-centred."""

_KINDS = {dict: "an object", list: "a list", str: "a text", int: "a whole number", float: "a number"}


def document(data: bytes, prefix: str = "") -> Any:
    """Parse JSON; UnusableError for invalid JSON, including NaN and infinity."""

    def refuse(word: str) -> NoReturn:
        raise UnusableError(f"{prefix}it is not valid JSON: {word} instead of a number")

    try:
        return json.loads(data, parse_constant=refuse)
    except UnicodeDecodeError as error:
        text = f"its text is not in a known encoding ({error.reason} at byte {error.start})"
        raise UnusableError(f"{prefix}it is not valid JSON: {text}") from None
    except json.JSONDecodeError as error:
        raise UnusableError(f"{prefix}it is not valid JSON: {check.one_line(str(error), 120)}") from None


def entry(parent: dict[str, Any], key: str, kind: type[Kind], prefix: str, default: Kind | None = None) -> Kind:
    """Return an entry of a given type; the default if it is absent or null, else UnusableError."""
    value = parent.get(key)
    if value is None and default is not None:
        return default
    return typed(value, kind, f"{prefix}{key}")


def typed(value: object, kind: type[Kind], json_path: str) -> Kind:
    """Return a value of the given type; else UnusableError with the JSON path."""
    if not isinstance(value, kind) or isinstance(value, bool):
        raise UnusableError(f"{json_path}: expected {_KINDS[kind]}, got {describe(value)}")
    return value


def describe(value: object) -> str:
    """Describe an unexpected value for a message."""
    return "nothing" if value is None else f"{type(value).__name__} {check.shortened(value)}"


def numbers(value: object, json_path: str, columns: int | None) -> NDArray[np.float64]:
    """Convert rows of `columns` numbers, or a flat list if `columns` is None, to float64; else UnusableError.

    All numbers must be finite and within ±1e30.
    """
    rows = typed(value, list, json_path)
    try:
        array = np.array(rows)
    except ValueError:
        raise UnusableError(f"{json_path}: expected {_expected(columns)}, got rows of other sizes") from None
    if not len(rows):
        return np.zeros((0,) if columns is None else (0, columns))
    fits = array.ndim == 1 if columns is None else array.ndim == 2 and array.shape[1] == columns
    if array.dtype.kind not in "iuf" or not fits:
        wrong_row = next((row for row in rows if not _is_row(row, columns)), rows[0])
        raise UnusableError(f"{json_path}: expected {_expected(columns)}, got {check.shortened(wrong_row)} among them")
    values: NDArray[np.float64] = array.astype(np.float64)
    check_range(values, json_path)
    return values


def check_range(values: NDArray[np.float64], json_path: str) -> None:
    """Reject numbers that are not finite or not within ±1e30; UnusableError names the first such row."""
    is_in_range = np.abs(values) <= check.FARTHEST  # NaN fails the comparison
    if not is_in_range.all():
        row = int(np.flatnonzero(~is_in_range.reshape(len(values), -1).all(axis=1))[0])
        number = values[row][~is_in_range[row]][0] if values.ndim > 1 else values[row]
        raise UnusableError(f"{json_path}[{row}]: expected numbers up to {check.FARTHEST:g}, got {number:g}")


def _expected(columns: int | None) -> str:
    return "numbers" if columns is None else f"rows of {columns} numbers"


def _is_row(row: object, columns: int | None) -> bool:
    if columns is None:
        return isinstance(row, int | float) and not isinstance(row, bool)
    return isinstance(row, list) and len(row) == columns and all(_is_row(value, None) for value in row)


def flattened(levels: list[Any], depth: int, json_path: str) -> list[Any]:
    """Flatten `depth` levels of nested lists; UnusableError where a level is not a list."""
    for _ in range(depth):
        for item in levels:
            if not isinstance(item, list):
                raise UnusableError(f"{json_path}: expected nested lists, got {describe(item)} among them")
        levels = [part for item in levels for part in item]
    return levels


def coordinates(value: Any, count: int, json_path: str) -> NDArray[np.float64]:
    """Check a list of `count` coordinates of a tile; UnusableError otherwise."""
    if not isinstance(value, list) or len(value) != count or not all(type(n) in (int, float) for n in value):
        got = f"a list of {len(value)}" if isinstance(value, list) else describe(value)
        raise UnusableError(f"{json_path}: expected {count} numbers, got {got}")
    # Integers may have any number of digits.
    too_large = next((n for n in value if not -TILE_FARTHEST <= n <= TILE_FARTHEST), None)
    if too_large is not None:
        raise UnusableError(f"{json_path}: expected numbers within ±1e10, got {check.shortened(too_large)}")
    return np.array(value, np.float64)


def at_least_zero(value: Any, json_path: str) -> float:
    """Check a number of at least 0, possibly infinite; UnusableError otherwise."""
    if type(value) not in (int, float) or not value >= 0.0:
        raise UnusableError(f"{json_path}: expected a number of at least 0, got {describe(value)}")
    return float(value) if value <= np.finfo(np.float64).max else np.inf


def integer(value: Any, minimum: int, maximum: int, json_path: str) -> int:
    """Check an integer within bounds; UnusableError otherwise."""
    if isinstance(value, float) and value.is_integer():
        value = int(value)
    if type(value) is not int or not minimum <= value <= maximum:
        raise UnusableError(f"{json_path}: expected a whole number from {minimum} to {maximum}, got {describe(value)}")
    return value


def choice(value: Any, options: tuple[str, ...], json_path: str) -> str:
    """Check one of several strings, in any case; UnusableError otherwise."""
    upper = value.upper() if isinstance(value, str) else value
    if upper not in options:
        raise UnusableError(f"{json_path}: expected {' or '.join(options)}, got {describe(value)}")
    return str(upper)
