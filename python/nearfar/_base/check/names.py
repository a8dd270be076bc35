"""Checks of texts, paths, objects and collections of them."""

from __future__ import annotations

import os
from collections.abc import Collection, Iterable, Mapping
from pathlib import Path
from typing import TypeVar, cast

import numpy as np

from nearfar._base.check.describe import shortened, type_and_value

Kind = TypeVar("Kind")
Value = TypeVar("Value")
Option = TypeVar("Option", bound=str)


def instance(name: str, value: object, kind: type[Kind], expected: str = "") -> Kind:
    """Check a value's type; TypeError otherwise, with `expected` in its message or else the type's name."""
    if not isinstance(value, kind):
        raise TypeError(f"{name}: expected {expected or f'a {kind.__name__}'}, got {type(value).__name__}")
    return value


def choice(name: str, value: str, options: Collection[Option]) -> Option:
    """Return one of the named options; ValueError or TypeError otherwise."""
    if not isinstance(value, str):
        raise TypeError(f"{name}: expected a string, got {type_and_value(value)}")
    if value not in options:
        choices = ", ".join(repr(option) for option in options)
        raise ValueError(f"{name}: expected one of {choices}, got {shortened(value)}")
    return cast(Option, value)


def text(name: str, value: str) -> str:
    """Check a text that files can hold; ValueError for a lone surrogate, TypeError for anything but a string."""
    if not isinstance(value, str):
        raise TypeError(f"{name}: expected a string, got {type_and_value(value)}")
    try:
        value.encode()
    except UnicodeEncodeError:
        message = f"{name}: expected text that files can hold, got a lone surrogate in {shortened(value)}"
        raise ValueError(message) from None
    return value


def path(name: str, value: str | os.PathLike[str], *suffixes: str) -> Path:
    """Check a path that the file system can hold, and its suffix if `suffixes` are given; case does not matter.

    ValueError otherwise, TypeError for anything but text or a path.
    """
    written = os.fspath(value) if isinstance(value, str | os.PathLike) else None
    if not isinstance(written, str):
        raise TypeError(f"{name}: expected a string or a path, got {type_and_value(value)}")
    if not written:
        raise ValueError(f"{name}: expected a path, got an empty string")
    try:
        is_usable = b"\0" not in os.fsencode(written)
    except UnicodeEncodeError:
        is_usable = False
    if not is_usable:
        raise ValueError(f"{name}: expected a path that the file system can hold, got {shortened(written)}")
    if suffixes and Path(written).suffix.lower() not in suffixes:
        raise ValueError(f"{name}: expected a name ending in {' or '.join(suffixes)}, got {written!r}")
    return Path(written)


def mapping(name: str, value: Mapping[str, Value], expected: str) -> Mapping[str, Value]:
    """Check a mapping with string keys; TypeError otherwise."""
    if not isinstance(value, Mapping):
        raise TypeError(f"{name}: expected {expected}, got {type_and_value(value)}")
    for key in value:
        if not isinstance(key, str):
            raise TypeError(f"{name}: expected {expected}, got the key {type_and_value(key)}")
    return value


def iterable(name: str, value: Iterable[Value], expected: str) -> Iterable[Value]:
    """Check an iterable; TypeError for texts, mappings and anything that is not iterable.

    `expected` describes the whole argument in messages, such as "a sequence of Cameras".
    """
    is_single = isinstance(value, str | bytes | Mapping) or (isinstance(value, np.ndarray) and value.ndim == 0)
    if is_single or not isinstance(value, Iterable):
        raise TypeError(f"{name}: expected {expected}, got {type_and_value(value)}")
    return value


def items(name: str, value: Iterable[object], kind: type[Kind], expected: str) -> list[Kind]:
    """Check an iterable whose items all have a type, and return them as a list; TypeError otherwise."""
    checked = []
    for number, item in enumerate(iterable(name, value, expected)):
        # An iterable may be endless, so this stops at the first wrong item.
        if not isinstance(item, kind):
            raise TypeError(f"{name}: expected {expected}, got {type_and_value(item)} at index {number}")
        checked.append(item)
    return checked


def texts(name: str, value: Iterable[str]) -> list[str]:
    """Check texts that files can hold; TypeError for anything but strings, ValueError for a lone surrogate."""
    checked = items(name, value, str, "a sequence of strings")
    try:
        "".join(checked).encode()
    except UnicodeEncodeError:
        for number, item in enumerate(checked):
            text(f"{name}[{number}]", item)
    return checked
