"""Hostile values, each with the kinds of parameters that may accept it; all others must refuse it.

A kind is a word for what is odd about a value:

number, whole, big
    Numbers, integers, and integers beyond 32 bits. A range decides which of them are valid.
flag, none, nan
    A truth value, None, and one number that is NaN.
free, path, names, texts, bytes
    Any text, a file path, a list of names, an iterable that may contain no text, and bytes.
empty, hollow
    No rows, and rows without columns.
rows, shape
    Rows of numbers of another type or size, and arrays with another number of axes.
nans, infs, flags, endless
    Arrays with NaN, with infinities, of truth values, and of more rows than memory holds.
axes, columns, fewer
    The array of the valid call with an extra axis, without its last column, and without its last row.
mapping, entries, set, objects, callable
    An empty mapping, mappings with meaningless keys, a set, an iterable without items, and callables.
scene, camera, frame, model, mesh, lens, hmd
    Objects of the package, where another kind of object is expected.

A value without kinds is always invalid.
"""

from __future__ import annotations

import datetime
import decimal
import fractions
import functools
import math
import os
import threading
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from tests.support.valid_calls.objects import Valid

TOO_MANY = 2**50
"""Rows of views that share memory: a copy cannot be made, and a pass over them would not end."""

OBJECTS = ("scene", "camera", "frame", "model", "mesh", "lens", "hmd")
"""Attributes of `Valid` that are hostile where another kind of object is expected."""


@dataclass(frozen=True)
class Hostile:
    """A value to pass in place of an argument; `make` creates it, because a generator can be used only once."""

    name: str
    make: Callable[[], Any]
    kinds: frozenset[str] = frozenset()
    """Kinds of parameters that may accept it."""


def constant(value: Any) -> Callable[[], Any]:
    """Return a function that returns a value."""
    return lambda: value


class _Fields:
    """An object that has every attribute, all meaningless; the class accepts any arguments, like a callback."""

    def __init__(self, *_: object, **__: object) -> None: ...

    def __getattr__(self, name: str) -> int:
        if name.startswith("_"):
            raise AttributeError(name)
        return 7


@functools.lru_cache(1)
def hostile_values(valid: Valid) -> tuple[Hostile, ...]:
    """Return all values; paths lie in a folder of `valid`, and objects come from it."""
    objects = ((f"object:{name}", name, lambda name=name: getattr(valid, name)) for name in OBJECTS)
    found = [*_numbers(), *_others(), *_containers(), *_arrays(), *_paths(valid.folder), *objects]
    return tuple(Hostile(name, make, frozenset(kinds.split())) for name, kinds, make in found)


Row = tuple[str, str, Callable[[], Any]]
"""Name, kinds, and factory of the value."""


def _numbers() -> Iterator[Row]:
    values: dict[str, tuple[str, Any]] = {
        "0": ("number whole", 0), "-1": ("number whole", -1), "2**31": ("big whole", 2**31),
        "2**64": ("big whole", 2**64), "10**400": ("", 10**400), "1e308": ("number", 1e308),
        "1e-320": ("number", 1e-320), "inf": ("number", math.inf), "-inf": ("number", -math.inf),
        "nan": ("nan", math.nan), "1j": ("", 1j), "Decimal": ("number", decimal.Decimal("1.5")),
        "array(3)": ("number whole", np.array(3)), "Fraction": ("", fractions.Fraction(10**400, 3)),
        "np.int8": ("number whole", np.int8(-128)), "np.float16": ("number", np.float16(np.inf)),
        "array(nan)": ("nan", np.array(math.nan)), "np.bool": ("flag", np.bool_(True)), "True": ("flag", True),
        "NaT": ("", np.datetime64("NaT")), "timedelta": ("", np.timedelta64(3, "s")),
    }  # fmt: skip
    for name, (kinds, value) in values.items():
        yield name, kinds, constant(value)


def _others() -> Iterator[Row]:
    yield "None", "none", lambda: None
    for name, text in {"''": "", "abc": "abc", "newline": "a\nb", "NUL": "a\0b", "long": "x" * 300}.items():
        yield name, "free path" if name in ("abc", "newline") else "free", constant(text)
    yield "surrogate", "", lambda: "\ud800"
    yield "b'x'", "bytes", lambda: b"x"
    yield "object", "", object
    yield "class", "callable", lambda: _Fields
    yield "lambda", "callable", lambda: lambda *_, **__: None
    yield "module", "", lambda: os
    yield "lock", "", threading.Lock
    yield "date", "", lambda: datetime.date(2020, 1, 1)
    yield "attributes", "", _Fields
    yield "NotImplemented", "", lambda: NotImplemented


def _containers() -> Iterator[Row]:
    yield "[]", "empty texts objects", list
    yield "{}", "mapping", dict
    yield "{'a': 1}", "entries", lambda: {"a": 1}
    yield "{1: None}", "entries", lambda: {1: None}
    yield "set", "set", lambda: {1, 2}
    yield "[[]]", "hollow", lambda: [[]]
    yield "ragged", "", lambda: [1, [2]]
    yield "[None]", "", lambda: [None]
    yield "['a', 3]", "", lambda: ["a", 3]
    yield "['abc']", "names", lambda: ["abc"]
    yield "[surrogate]", "", lambda: ["\ud800"]
    yield "[10**400] * 3", "", lambda: [10**400] * 3
    yield "itself", "", _itself
    yield "generator", "", lambda: (number for number in range(3))


def _itself() -> list[Any]:
    nested: list[Any] = []
    nested.append(nested)
    return nested


def _arrays() -> Iterator[Row]:
    yield "(0, 3)", "empty texts objects", lambda: np.zeros((0, 3))
    yield "(3, 0)", "hollow", lambda: np.zeros((3, 0))
    yield "(5,)", "shape", lambda: np.arange(5)
    yield "(2, 3, 4, 5)", "shape", lambda: np.zeros((2, 3, 4, 5))
    yield "32 axes", "shape", lambda: np.zeros((1,) * 32)
    yield "array of objects", "", lambda: np.array([[1, 2, "x"]] * 3, dtype=object)
    yield "complex", "", lambda: np.full((3, 3), 1j)
    yield "masked", "", lambda: np.ma.masked_equal(np.arange(3.0), 1)
    yield "structured", "", lambda: np.zeros(3, [("a", "f8"), ("b", "i4")])
    yield "array of texts", "names", lambda: np.array(["1", "b", "ü"])
    yield "array of bytes", "", lambda: np.array([b"1", b"2"])
    yield "array of dates", "", lambda: np.array(["2020-01-01", "NaT"], "datetime64[D]")
    yield "array of bools", "flags", lambda: np.array([True, False, True])
    yield "float16", "rows", lambda: np.full((3, 3), 65504, np.float16)
    yield "int64 extremes", "rows", lambda: np.array([[-(2**63), 2**63 - 1, 0]])
    yield "greatest", "rows", lambda: np.full((3, 3), np.finfo(np.float64).max)
    yield "array of nan", "nans", lambda: np.full((3, 3), math.nan, np.float32)
    yield "array of inf", "infs", lambda: np.full((3, 3), math.inf)
    for kind in (np.float64, np.float32, np.int64):
        yield f"endless {kind.__name__}", "", constant(np.broadcast_to(kind(1), (TOO_MANY, 3)))
    yield "endless pixels", "endless", lambda: np.broadcast_to(np.uint8(1), (TOO_MANY, 1, 4))
    yield "endless flags", "", lambda: np.broadcast_to(np.bool_(True), (TOO_MANY,))
    yield "endless faces", "", lambda: np.broadcast_to(np.float32(1), (6, 2**24, 2**24, 3))


def _paths(folder: Path) -> Iterator[Row]:
    yield "missing file", "path", lambda: folder / "missing" / "file.json"
    yield "folder", "path", lambda: folder
    yield "path with NUL", "", lambda: Path(f"{folder}/a\0b.exr")
    yield "path with a surrogate", "", lambda: Path(f"{folder}/\ud800.json")
    yield "long path", "path", lambda: folder / ("x" * 300 + ".exr")
    yield "parent is a file", "path", lambda: Path(__file__) / "x.json"


def variants(argument: Any) -> Iterator[Hostile]:
    """Yield damaged copies of an array that a call accepts: other shapes, and a NaN or infinite number."""
    try:
        array = np.asarray(argument)
    except ValueError:
        return
    if array.ndim == 0 or array.dtype.kind not in "fiu":
        return
    found = {("one axis more", "axes"): array[None], ("columns without the last", "columns"): array[..., :-1]}
    if len(array) > 1:
        found["rows without the last", "fewer"] = array[:-1]
    for value in (math.nan, math.inf, -math.inf) if array.dtype.kind == "f" else ():
        changed = found[f"{value} at the end", "nans" if math.isnan(value) else "infs"] = array.astype(array.dtype)
        changed.flat[-1] = value
    for (name, kind), changed in found.items():
        yield Hostile(name, constant(changed), frozenset({kind}))
