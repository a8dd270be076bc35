"""Entries of JSON documents that anyone may have written: each is checked for its type, and errors name its place."""

from __future__ import annotations

import json
from typing import Any, NoReturn, TypeVar

import numpy as np
from numpy.typing import NDArray

from nearfar._base import check
from nearfar._base.errors import UnusableError

Kind = TypeVar("Kind")

_KINDS = {dict: "an object", list: "a list", str: "a text", int: "a whole number", float: "a number"}


def document(data: bytes, place: str = "") -> Any:
    """Parse JSON; UnusableError for text that is none, also for NaN and infinity, which JSON does not have."""

    def refuse(word: str) -> NoReturn:
        raise UnusableError(f"{place}it is no JSON: {word} stands where a number belongs")

    try:
        return json.loads(data, parse_constant=refuse)
    except (json.JSONDecodeError, UnicodeDecodeError) as error:
        raise UnusableError(f"{place}it is no JSON: {check.one_line(str(error), 120)}") from None


def entry(parent: dict[str, Any], key: str, kind: type[Kind], place: str, default: Kind | None = None) -> Kind:
    """An entry of a type; the default if it is absent or null, or UnusableError without a default."""
    value = parent.get(key)
    if value is None and default is not None:
        return default
    return typed(value, kind, f"{place}{key}")


def typed(value: object, kind: type[Kind], place: str) -> Kind:
    """The value if it has the type; UnusableError with its place otherwise."""
    if not isinstance(value, kind) or isinstance(value, bool):
        raise UnusableError(f"{place}: expected {_KINDS[kind]}, got {_shown(value)}")
    return value


def _shown(value: object) -> str:
    return "nothing" if value is None else f"{type(value).__name__} {check.shortened(value)}"


def numbers(value: object, place: str, columns: int | None) -> NDArray[np.float64]:
    """Numbers as float64: rows of so many columns or, without columns, a list; UnusableError for others.

    They are finite and at most 1e30.
    """
    rows = typed(value, list, place)
    try:
        array = np.array(rows)
    except ValueError:
        raise UnusableError(f"{place}: expected {_expected(columns)}, got rows of other sizes") from None
    if not len(rows):
        return np.zeros((0,) if columns is None else (0, columns))
    fits = array.ndim == 1 if columns is None else array.ndim == 2 and array.shape[1] == columns
    if array.dtype.kind not in "iuf" or not fits:
        wrong = next((row for row in rows if not _is_row(row, columns)), rows[0])
        raise UnusableError(f"{place}: expected {_expected(columns)}, got {check.shortened(wrong)} among them")
    values: NDArray[np.float64] = array.astype(np.float64)
    check_range(values, place)
    return values


def check_range(values: NDArray[np.float64], place: str) -> None:
    """Refuse numbers that are not finite or beyond 1e30; UnusableError names the first one's row."""
    good = np.abs(values) <= check.FARTHEST  # NaN fails the comparison
    if not good.all():
        row = int(np.flatnonzero(~good.reshape(len(values), -1).all(axis=1))[0])
        number = values[row][~good[row]][0] if values.ndim > 1 else values[row]
        raise UnusableError(f"{place}[{row}]: expected numbers up to {check.FARTHEST:g}, got {number:g}")


def _expected(columns: int | None) -> str:
    return "numbers" if columns is None else f"rows of {columns} numbers"


def _is_row(row: object, columns: int | None) -> bool:
    if columns is None:
        return isinstance(row, int | float) and not isinstance(row, bool)
    return isinstance(row, list) and len(row) == columns and all(_is_row(value, None) for value in row)


def flattened(levels: list[Any], depth: int, place: str) -> list[Any]:
    """The items that lie `depth` levels deeper in nested lists; UnusableError where a level is none."""
    for _ in range(depth):
        for item in levels:
            if not isinstance(item, list):
                raise UnusableError(f"{place}: expected nested lists, got {_shown(item)} among them")
        levels = [part for item in levels for part in item]
    return levels
