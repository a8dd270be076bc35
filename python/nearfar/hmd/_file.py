"""Headsets as JSON of our own; and how documents of others are read: every mistake names the file and the key."""

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
# What may be missing or null.
OPTIONAL = ("panel_size", "refresh_hz", "lens_radius", "triangle_budget", "hidden_area_percent")

Made = TypeVar("Made")


def write(path: Path, fields: dict[str, Any]) -> None:
    """Write a headset's fields as a document of ours."""
    save(path, document(fields))


def save(path: Path, content: dict[str, Any]) -> None:
    """Write JSON whole or not at all."""
    with files.atomic_file(path) as aside:
        aside.write_text(formats.to_json(content), encoding="utf-8")


def document(fields: dict[str, Any]) -> dict[str, Any]:
    """Return the document of a headset."""
    eyes = {side: _eye_document(fields[side]) for side in ("left", "right")}
    names = ("name", "render_size", "panel_size", "refresh_hz", "lens", "lens_radius", "triangle_budget")
    rest = {name: fields[name] for name in (*names, "hidden_area_percent", "sources")}
    rest["lens"] = list(rest["lens"].k) if rest["lens"] else None
    return formats.header(FORMAT, VERSION) | {"name": rest.pop("name"), "eyes": eyes} | rest


def fields(content: dict[str, Any], where: str) -> dict[str, Any]:
    """Return a headset's fields by name from a document of ours."""
    formats.check(content, FORMAT, VERSION, where)
    read = Reader(content, where)
    found: dict[str, Any] = {"name": read.text("name")}
    for side in ("left", "right"):
        found[side] = _eye(read.inside("eyes").inside(side))
    found["render_size"] = read.pair("render_size")
    for name in OPTIONAL:
        if content.get(name) is not None:
            found[name] = read.pair(name) if name in ("panel_size", "triangle_budget") else read.number(name)
    if content.get("lens") is not None:
        found["lens"] = built(where, lambda: RadialLens(read.numbers("lens", None)))
    found["sources"] = read.texts("sources")
    return found


def parse(text: bytes, where: str) -> dict[str, Any]:
    """Return the object that JSON text holds; FormatError for anything else."""
    try:
        content = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise FormatError(f"{where}: expected JSON, got something else ({error})") from None
    if not isinstance(content, dict):
        raise FormatError(f"{where}: expected a JSON object, got {type(content).__name__}")
    return content


def built(where: str, make: Callable[[], Made]) -> Made:
    """Make something of what a file says; what is wrong with it is the file's fault."""
    try:
        return make()
    except (OverflowError, TypeError, ValueError) as error:
        raise FormatError(f"{where}: {error}") from None


def finite(value: object) -> float | None:
    """A number of JSON as float64; nothing for anything else, and for what float64 does not hold."""
    if not isinstance(value, int | float) or isinstance(value, bool):
        return None
    try:
        found = float(value)
    except OverflowError:
        return None
    return found if math.isfinite(found) else None


def finite_row(value: object) -> list[float] | None:
    """Numbers of JSON in the same way; nothing if one of them is none."""
    found = [finite(item) for item in value] if isinstance(value, list) else [None]
    return None if None in found else [item for item in found if item is not None]


class Reader:
    """An object within a document, which knows what it is called."""

    def __init__(self, content: dict[str, Any], where: str, name: str = "") -> None:
        self.content, self.where, self.name = content, where, name

    def inside(self, key: str) -> Reader:
        """The object of a key."""
        value = self._value(key)
        if not isinstance(value, dict):
            raise self.wrong(key, "an object", value)
        return Reader(value, self.where, self._named(key))

    def number(self, key: str) -> float:
        """A number."""
        value = self._value(key)
        found = finite(value)
        if found is None:
            raise self.wrong(key, "a number", value)
        return found

    def numbers(self, key: str, count: int | None) -> tuple[float, ...]:
        """So many numbers."""
        value = self._value(key)
        found = finite_row(value)
        if found is None or count not in (None, len(found)):
            raise self.wrong(key, "numbers" if count is None else f"{count} numbers", value)
        return tuple(found)

    def pair(self, key: str) -> tuple[Any, Any]:
        """Two numbers, kept as they are: whole ones stay whole."""
        self.numbers(key, 2)
        one, other = self._value(key)
        return one, other

    def text(self, key: str) -> str:
        """A string."""
        value = self._value(key)
        if not isinstance(value, str):
            raise self.wrong(key, "a string", value)
        return value

    def texts(self, key: str) -> tuple[str, ...]:
        """Strings."""
        value = self._value(key)
        if not isinstance(value, list) or not all(isinstance(item, str) for item in value):
            raise self.wrong(key, "strings", value)
        return tuple(value)

    def rows(self, key: str) -> Any:
        """Rows of numbers."""
        value = self._value(key)
        found = [finite_row(row) for row in value] if isinstance(value, list) else [None]
        if None in found:
            raise self.wrong(key, "rows of numbers", value)
        return found

    def made(self, make: Callable[[], Made]) -> Made:
        """Make something of what stands here."""
        return built(f"{self.where}: {self.name}", make)

    def wrong(self, key: str, expected: str, value: object) -> FormatError:
        """Say what was expected of a key."""
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
    fov = read.inside("fov").made(lambda: Fov(*tangents))
    x, y, z = read.numbers("position", 3)
    a, b, c, d = read.numbers("orientation", 4)
    return read.made(lambda: Eye(fov, (x, y, z), (a, b, c, d)))
