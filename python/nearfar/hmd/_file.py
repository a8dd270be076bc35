"""Reads and writes headsets as JSON; the reader of JSON documents checks values, and its errors name file and key."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any, TypeVar

from nearfar._base import formats
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
    eyes = {
        side: {
            "fov": {name: getattr(fields[side].fov, name) for name in SIDES},
            "position": fields[side].position,
            "orientation": fields[side].orientation,
        }
        for side in ("left", "right")
    }
    names = ("render_size", "panel_size", "refresh_hz", "lens", "lens_radius", "triangle_budget")
    others = {name: fields[name] for name in (*names, "hidden_area_percent", "sources")}
    others["lens"] = list(others["lens"].k) if others["lens"] else None
    formats.write_json(path, formats.header(FORMAT, VERSION) | {"name": fields["name"], "eyes": eyes} | others)


def fields(content: dict[str, Any], where: str) -> dict[str, Any]:
    """Return a headset's fields by name from a document that `write` made; FormatError for other documents."""
    formats.check(content, FORMAT, VERSION, where)
    read = Reader(content, where)
    result: dict[str, Any] = {"name": read.text("name")}
    for side in ("left", "right"):
        eye = read.object_at("eyes").object_at(side)
        result[side] = eye.eye(eye.object_at("fov").fov(SIDES))
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


def _text(value: object) -> str | None:
    return value if isinstance(value, str) else None


def _convert_items(
    value: object, convert: Callable[[object], Built | None], count: int | None = None
) -> list[Built] | None:
    """Convert a JSON list, of `count` items if given; None for other values, and if an item's conversion is None."""
    if not isinstance(value, list) or count not in (None, len(value)):
        return None
    items = [item for item in map(convert, value) if item is not None]
    return items if len(items) == len(value) else None


class Reader:
    """An object within a JSON document; errors contain its path within the document."""

    def __init__(self, content: dict[str, Any], where: str, name: str = "") -> None:
        self.content, self.where, self.name = content, where, name

    def object_at(self, key: str) -> Reader:
        """Return a reader of the object at a key."""
        value = self._read(key, "an object", lambda value: value if isinstance(value, dict) else None)
        return Reader(value, self.where, self._path_of(key))

    def number(self, key: str) -> float:
        """Return the number at a key."""
        return self._read(key, "a number", finite)

    def numbers(self, key: str, count: int | None) -> tuple[float, ...]:
        """Return the numbers at a key, exactly `count` of them if not None."""
        expected = "numbers" if count is None else f"{count} numbers"
        return tuple(self._read(key, expected, lambda value: _convert_items(value, finite, count)))

    def pair(self, key: str) -> tuple[Any, Any]:
        """Return the two numbers at a key without conversion, so that whole numbers stay whole."""
        self.numbers(key, 2)
        first, second = self._value(key)
        return first, second

    def text(self, key: str) -> str:
        """Return the string at a key."""
        return self._read(key, "a string", _text)

    def texts(self, key: str) -> tuple[str, ...]:
        """Return the strings at a key."""
        return tuple(self._read(key, "strings", lambda value: _convert_items(value, _text)))

    def rows(self, key: str) -> list[list[float]]:
        """Return the rows of numbers at a key."""
        convert_rows = partial(_convert_items, convert=partial(_convert_items, convert=finite))
        return self._read(key, "rows of numbers", convert_rows)

    def fov(self, keys: tuple[str, str, str, str]) -> Fov:
        """Return the field of view whose tangents (left, right, down, up) are at four keys."""
        tangents = [self.number(key) for key in keys]
        return self.convert(lambda: Fov(*tangents))

    def eye(self, fov: Fov) -> Eye:
        """Return the eye whose position and orientation are at the keys of these names."""
        x, y, z = self.numbers("position", 3)
        a, b, c, d = self.numbers("orientation", 4)
        return self.convert(lambda: Eye(fov, (x, y, z), (a, b, c, d)))

    def convert(self, make: Callable[[], Built]) -> Built:
        """Call a constructor with values of this object; its errors become FormatError."""
        return convert(f"{self.where}: {self.name}", make)

    def _read(self, key: str, expected: str, convert: Callable[[Any], Built | None]) -> Built:
        """Return the converted value at a key; FormatError if the conversion returns None."""
        value = self._value(key)
        built = convert(value)
        if built is None:
            got = json.dumps(value)
            got = got if len(got) < 60 else got[:57] + "..."
            raise FormatError(f"{self.where}: {self._path_of(key)}: expected {expected}, got {got}")
        return built

    def _value(self, key: str) -> Any:
        if key not in self.content:
            raise FormatError(f"{self.where}: {self._path_of(key)}: expected a value, found none")
        return self.content[key]

    def _path_of(self, key: str) -> str:
        return f"{self.name}.{key}" if self.name else key
