"""Reads and writes headsets as JSON, with a checked reader of JSON documents whose errors name file and key."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

from nearfar._base import files, formats
from nearfar._base.errors import FormatError
from nearfar._camera.camera import Fov
from nearfar._lens.lens import RadialLens
from nearfar.hmd._eye import Eye

FORMAT, VERSION = "hmd", 1
SIDES = ("left", "right", "down", "up")
"""Names of the tangents of a field of view."""
OPTIONAL = ("panel_size", "refresh_hz", "lens_radius", "triangle_budget", "hidden_area_percent")
"""Keys that may be missing or null."""

Built = TypeVar("Built")


def write(path: Path, fields: dict[str, Any]) -> None:
    """Write a headset's fields as a JSON document."""
    save(path, document(fields))


def save(path: Path, content: dict[str, Any]) -> None:
    """Write JSON completely or not at all."""
    with files.atomic_file(path) as temporary:
        temporary.write_text(formats.to_json(content), encoding="utf-8")


def document(fields: dict[str, Any]) -> dict[str, Any]:
    """Make the document of a headset from its fields."""
    eyes = {side: _eye_document(fields[side]) for side in ("left", "right")}
    names = ("name", "render_size", "panel_size", "refresh_hz", "lens", "lens_radius", "triangle_budget")
    rest = {name: fields[name] for name in (*names, "hidden_area_percent", "sources")}
    rest["lens"] = list(rest["lens"].k) if rest["lens"] else None
    return formats.header(FORMAT, VERSION) | {"name": rest.pop("name"), "eyes": eyes} | rest


def fields(content: dict[str, Any], where: str) -> dict[str, Any]:
    """Return a headset's fields by name from a document that `write` made; FormatError for others."""
    formats.check(content, FORMAT, VERSION, where)
    read = Reader(content, where)
    result: dict[str, Any] = {"name": read.text("name")}
    for side in ("left", "right"):
        result[side] = _eye(read.inside("eyes").inside(side))
    result["render_size"] = read.pair("render_size")
    for name in OPTIONAL:
        if content.get(name) is not None:
            result[name] = read.pair(name) if name in ("panel_size", "triangle_budget") else read.number(name)
    if content.get("lens") is not None:
        result["lens"] = convert(where, lambda: RadialLens(read.numbers("lens", None)))
    result["sources"] = read.texts("sources")
    return result


def parse(text: bytes, where: str) -> dict[str, Any]:
    """Parse JSON text to an object; FormatError for anything else."""
    try:
        content = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise FormatError(f"{where}: expected JSON, got something else ({error})") from None
    if not isinstance(content, dict):
        raise FormatError(f"{where}: expected a JSON object, got {type(content).__name__}")
    return content


def convert(where: str, make: Callable[[], Built]) -> Built:
    """Call a constructor with values of a file; its errors become FormatError."""
    try:
        return make()
    except (OverflowError, TypeError, ValueError) as error:
        raise FormatError(f"{where}: {error}") from None


def finite(value: object) -> float | None:
    """Convert a JSON number to float64; None for other types and for numbers beyond float64's range."""
    if not isinstance(value, int | float) or isinstance(value, bool):
        return None
    try:
        number = float(value)
    except OverflowError:
        return None
    return number if math.isfinite(number) else None


def finite_row(value: object) -> list[float] | None:
    """Convert a JSON list of numbers to float64; None if an item is not a finite number."""
    numbers = [finite(item) for item in value] if isinstance(value, list) else [None]
    return None if None in numbers else [item for item in numbers if item is not None]


class Reader:
    """An object within a JSON document; errors contain its path within the document."""

    def __init__(self, content: dict[str, Any], where: str, name: str = "") -> None:
        self.content, self.where, self.name = content, where, name

    def inside(self, key: str) -> Reader:
        """Return a reader of the object at a key."""
        value = self._value(key)
        if not isinstance(value, dict):
            raise self.wrong(key, "an object", value)
        return Reader(value, self.where, self._named(key))

    def number(self, key: str) -> float:
        """Return the number at a key."""
        value = self._value(key)
        number = finite(value)
        if number is None:
            raise self.wrong(key, "a number", value)
        return number

    def numbers(self, key: str, count: int | None) -> tuple[float, ...]:
        """Return the numbers at a key, exactly `count` of them if not None."""
        value = self._value(key)
        numbers = finite_row(value)
        if numbers is None or count not in (None, len(numbers)):
            raise self.wrong(key, "numbers" if count is None else f"{count} numbers", value)
        return tuple(numbers)

    def pair(self, key: str) -> tuple[Any, Any]:
        """Return the two numbers at a key without conversion, so that whole numbers stay whole."""
        self.numbers(key, 2)
        one, other = self._value(key)
        return one, other

    def text(self, key: str) -> str:
        """Return the string at a key."""
        value = self._value(key)
        if not isinstance(value, str):
            raise self.wrong(key, "a string", value)
        return value

    def texts(self, key: str) -> tuple[str, ...]:
        """Return the strings at a key."""
        value = self._value(key)
        if not isinstance(value, list) or not all(isinstance(item, str) for item in value):
            raise self.wrong(key, "strings", value)
        return tuple(value)

    def rows(self, key: str) -> Any:
        """Return the rows of numbers at a key."""
        value = self._value(key)
        rows = [finite_row(row) for row in value] if isinstance(value, list) else [None]
        if None in rows:
            raise self.wrong(key, "rows of numbers", value)
        return rows

    def convert(self, make: Callable[[], Built]) -> Built:
        """Call a constructor with values of this object; its errors become FormatError."""
        return convert(f"{self.where}: {self.name}", make)

    def wrong(self, key: str, expected: str, value: object) -> FormatError:
        """Make the error for a key with an unexpected value."""
        got = json.dumps(value)
        return FormatError(
            f"{self.where}: {self._named(key)}: expected {expected}, got {got if len(got) < 60 else got[:57] + '...'}"
        )

    def _value(self, key: str) -> Any:
        if key not in self.content:
            raise FormatError(f"{self.where}: {self._named(key)}: expected a value, found none")
        return self.content[key]

    def _named(self, key: str) -> str:
        return f"{self.name}.{key}" if self.name else key


def _eye_document(eye: Eye) -> dict[str, Any]:
    fov = {side: getattr(eye.fov, side) for side in SIDES}
    return {"fov": fov, "position": eye.position, "orientation": eye.orientation}


def _eye(read: Reader) -> Eye:
    tangents = [read.inside("fov").number(side) for side in SIDES]
    fov = read.inside("fov").convert(lambda: Fov(*tangents))
    x, y, z = read.numbers("position", 3)
    a, b, c, d = read.numbers("orientation", 4)
    return read.convert(lambda: Eye(fov, (x, y, z), (a, b, c, d)))
