"""Common header of all files written by nearfar: format, version, generator, units, origin and colour space."""

from __future__ import annotations

import gc
import json
import math
import os
import struct
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np

from nearfar._base import files
from nearfar._base.check import one_line, shortened
from nearfar._base.errors import FormatError
from nearfar._base.version import __version__

CONVENTIONS: dict[str, Any] = {
    "units": {"length": "metre", "angle": "radian", "time": "second", "size": "byte"},
    "axes": "right-handed, y up, cameras look along -z",
    "origin": [0.0, 0.0, 0.0],
    "color_space": "none",
}
"""Default header fields. `color_space` is "linear", "sRGB", or "none" for files without colour."""

_GENERATOR = 60
"""Greatest length of the name of another program in a message."""

_REASON = 180
"""Greatest length of another library's message in ours."""


def header(name: str, version: int, **conventions: Any) -> dict[str, Any]:
    """Return the header fields of a document; `name` is the format without "nearfar.", such as "report".

    Readers reject newer versions. `conventions` are values that differ from `CONVENTIONS`, such as `origin=(x, y, z)`
    in metres or `color_space="linear"`, and further fields about the whole file.
    """
    identity = {"format": f"nearfar.{name}", "version": version, "generator": f"nearfar {__version__}"}
    return identity | CONVENTIONS | conventions


def check(document: Any, name: str, version: int, path: str | os.PathLike[str]) -> dict[str, Any]:
    """Return the decoded content of a file if its header has the expected format and a supported version.

    `name` is that of the format without "nearfar.", `version` the newest supported one. FormatError with the file's
    path for another format, a missing or invalid version, or a newer one.
    """
    file_name, format_name = os.fspath(path), f"nearfar.{name}"
    if not isinstance(document, dict):
        raise FormatError(f"{file_name}: expected a {format_name} document, got {type(document).__name__}")
    if document.get("format") != format_name:
        raise FormatError(f"{file_name}: expected format {format_name!r}, got {shortened(document.get('format'))}")
    file_version = document.get("version")
    if not isinstance(file_version, int) or isinstance(file_version, bool) or file_version < 1:
        raise FormatError(f"{file_name}: expected a version of at least 1, got {shortened(file_version)}")
    if file_version > version:
        raise FormatError(
            f"{file_name}: {format_name} version {shortened(file_version)} was written by "
            f"{one_line(str(document.get('generator', 'a newer nearfar')), _GENERATOR)}; "
            f"this is nearfar {__version__}, which reads up to version {version}"
        )
    return document


def from_json(text: str | bytes) -> Any:
    """Parse strict JSON; ValueError for NaN, Infinity, numbers beyond float64 and lone surrogates."""

    def refuse(word: str) -> float:
        raise ValueError(f"{word} is not a JSON number")

    def number(digits: str) -> float:
        value = float(digits)
        return value if math.isfinite(value) else refuse(digits)

    if isinstance(text, bytes):
        text = text.decode()  # json would accept lone surrogates
    document = json.loads(text, parse_constant=refuse, parse_float=number)
    if "\\u" in text:
        _refuse_lone_surrogates(document)
    return document


def from_foreign_json(text: bytes) -> Any:
    """Parse JSON of other programs, which may contain NaN and Infinity; ValueError for lone surrogates."""
    with _without_collection():
        document = json.loads(text)
    # Without these bytes there is no lone surrogate: an escape, its lead byte in UTF-8, a zero byte of UTF-16 or 32.
    if b"\\u" in text or b"\xed" in text or b"\0" in text:
        _refuse_lone_surrogates(document)
    return document


@contextmanager
def _without_collection() -> Iterator[None]:
    """Pause garbage collection, which takes half of the time of parsing large documents; parsers create no cycles."""
    was_enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if was_enabled:
            gc.enable()


def _refuse_lone_surrogates(document: Any) -> None:
    """Raise a ValueError if a text cannot be written to a file."""
    try:
        json.dumps(document, ensure_ascii=False).encode()
    except UnicodeEncodeError:
        raise ValueError("a string in it contains a lone surrogate") from None


def read_json(path: str | os.PathLike[str], name: str, version: int) -> dict[str, Any]:
    """Read a JSON document; FormatError if it is damaged or too new, OSError if it is missing."""
    with open(path, encoding="utf-8") as file:
        try:
            document = from_json(file.read())
        except (ValueError, RecursionError) as error:
            raise FormatError(f"{os.fspath(path)}: expected JSON, got something else ({error})") from None
    return check(document, name, version, path)


_INVALID = (ValueError, TypeError, LookupError, AttributeError, ArithmeticError)
DAMAGE: tuple[type[Exception], ...] = (*_INVALID, StopIteration, RecursionError, struct.error)
"""Exceptions that reading a damaged file may raise."""


@contextmanager
def guarded(path: str | os.PathLike[str], kind: str = "") -> Iterator[None]:
    """Convert exceptions from reading a damaged file to a FormatError with the file's name and the kind of content.

    NumPy's warnings about numbers that do not fit a type count as errors, too.
    """
    damaged = f"{os.fspath(path)}: damaged{' ' if kind else ''}{kind}"
    try:
        with np.errstate(invalid="raise", over="raise", divide="raise"):
            yield
    except FormatError:
        raise
    except KeyError as error:
        raise FormatError(f"{damaged}: {one_line(str(error), _REASON)} is missing") from None
    except DAMAGE as error:
        raise FormatError(f"{damaged}: {one_line(str(error), _REASON) or type(error).__name__}") from None


def to_json(document: dict[str, Any], *, compact: bool = False) -> str:
    """Encode a document as strict JSON (no NaN or infinity) with a final newline, indented or `compact`."""
    layout: dict[str, Any] = {"separators": (",", ":")} if compact else {"indent": 2}
    return json.dumps(document, allow_nan=False, ensure_ascii=False, **layout) + "\n"


def write_json(path: str | os.PathLike[str], document: dict[str, Any]) -> None:
    """Write a document as JSON atomically."""
    with files.atomic_file(path) as temporary:
        temporary.write_text(to_json(document), encoding="utf-8")
