"""A battery of values that no function expects, calls with them, and the verdict on what a call raised."""

from __future__ import annotations

import asyncio
import datetime
import decimal
import fractions
import inspect
import itertools
import math
import os
import re
import threading
import warnings
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

import nearfar as nf

TOO_MANY = 2**50
"""Rows of views without memory of their own: a copy cannot be made, and a pass over them would not end."""

ALLOWED = (ValueError, TypeError, nf.Error, OSError, MemoryError)
"""Exceptions for wrong arguments; their subclasses below are accidents."""

ACCIDENTS = (UnicodeError,)
"""Subclasses of allowed exceptions that come from inside."""

LONGEST = 600
"""Greatest number of characters of a message: values are cut, and paths are shorter."""

FOREIGN = re.compile(
    r"object is not|is not iterable|not subscriptable|has no attribute|has no len|unsupported operand|truth value"
    r"|only integer scalar|only length-1|size-1 arrays|cannot be interpreted|could not convert|cannot convert"
    r"|cannot be converted|cannot be cast|can't convert|invalid literal|not supported between|must be real number"
    r"|must be a string|must be str|must be an integer|too many values|not enough values|inhomogeneous"
    r"|setting an array|ufunc|broadcast together|Unable to allocate|array is too big|unhashable"
    r"|required positional argument|unexpected keyword|takes \d|takes from|not callable|<class '"
    r"|embedded null|surrogates not allowed|codec can't|argument '|Python int too large|int too big"
    r"|out of bounds|dtype\(|data type .* not understood|nan to integer|infinity to integer|expected str, bytes"
)
"""Parts of messages of Python, NumPy and PyO3."""


@dataclass(frozen=True)
class Hostile:
    """A value to pass in place of an argument; `make` makes it, because a generator serves only once."""

    name: str
    make: Callable[[], Any]


class _Fields:
    """An object whose attributes are all there and mean nothing; the class takes any arguments, like a callback."""

    def __init__(self, *_: object, **__: object) -> None: ...

    def __getattr__(self, name: str) -> int:
        if name.startswith("_"):
            raise AttributeError(name)
        return 7


def hostile_values(folder: Path, objects: Mapping[str, Any] | None = None) -> list[Hostile]:
    """Return the battery. Paths lie in `folder`; `objects` are valid arguments of other functions, by their names."""
    ours = (_same(f"object:{name}", value) for name, value in (objects or {}).items())
    return [*_numbers(), *_texts(), *_containers(), *_arrays(), *_paths(folder), *ours]


def _same(name: str, value: Any) -> Hostile:
    """A value that serves any number of times."""
    return Hostile(name, lambda: value)


def _numbers() -> Iterator[Hostile]:
    values = {
        "None": None, "True": True, "0": 0, "-1": -1, "2**31": 2**31, "2**63": 2**63, "10**400": 10**400,
        "1e308": 1e308, "inf": math.inf, "-inf": -math.inf, "nan": math.nan, "1j": 1j, "1e-320": 1e-320,
        "Decimal": decimal.Decimal("1.5"), "Fraction": fractions.Fraction(10**400, 3),
        "np.int8": np.int8(-128), "np.uint64": np.uint64(2**64 - 1), "np.bool": np.bool_(True),
        "np.float16": np.float16(np.inf), "NaT": np.datetime64("NaT"), "timedelta": np.timedelta64(3, "s"),
    }  # fmt: skip
    for name, value in values.items():
        yield _same(name, value)


def _texts() -> Iterator[Hostile]:
    texts = {"''": "", "abc": "abc", "surrogate": "\ud800", "NUL": "a\0b", "newline": "a\nb", "long": "x" * 300}
    for name, value in texts.items():
        yield _same(name, value)
    for name, data in {"b'x'": b"x", "bytearray": bytearray(b"x"), "memoryview": memoryview(b"xyz")}.items():
        yield _same(name, data)


def _containers() -> Iterator[Hostile]:
    yield Hostile("[]", list)
    yield Hostile("()", tuple)
    yield Hostile("{}", dict)
    yield Hostile("set", lambda: {1, 2})
    yield Hostile("[[]]", lambda: [[]])
    yield Hostile("ragged", lambda: [1, [2]])
    yield Hostile("[None]", lambda: [None])
    yield Hostile("['a', 3]", lambda: ["a", 3])
    yield Hostile("[10**400]*3", lambda: [10**400] * 3)
    yield Hostile("[nan]*3", lambda: [math.nan] * 3)
    yield Hostile("[surrogate]", lambda: ["\ud800"])
    yield Hostile("{'a': 1}", lambda: {"a": 1})
    yield Hostile("{1: None}", lambda: {1: None})
    yield Hostile("itself", _itself)
    yield Hostile("range", lambda: range(3))
    yield Hostile("generator", lambda: (number for number in range(3)))
    yield Hostile("object", object)
    yield Hostile("class", lambda: _Fields)
    yield Hostile("lambda", lambda: lambda *_, **__: None)
    yield Hostile("module", lambda: os)
    yield Hostile("lock", threading.Lock)
    yield Hostile("date", lambda: datetime.date(2020, 1, 1))
    yield Hostile("attributes", _Fields)
    yield Hostile("NotImplemented", lambda: NotImplemented)
    yield Hostile("...", lambda: ...)


def _itself() -> list[Any]:
    nested: list[Any] = []
    nested.append(nested)
    return nested


def _arrays() -> Iterator[Hostile]:
    yield Hostile("array(3)", lambda: np.array(3))
    yield Hostile("array(nan)", lambda: np.array(math.nan))
    yield Hostile("empty", lambda: np.zeros(0))
    yield Hostile("(0, 3)", lambda: np.zeros((0, 3)))
    yield Hostile("(3, 0)", lambda: np.zeros((3, 0)))
    yield Hostile("(5,)", lambda: np.arange(5))
    yield Hostile("(2, 3, 4, 5)", lambda: np.zeros((2, 3, 4, 5)))
    yield Hostile("32 axes", lambda: np.zeros((1,) * 32))
    yield Hostile("objects", lambda: np.array([object(), None, 3], dtype=object))
    yield Hostile("object rows", lambda: np.array([[1, 2, "x"]] * 3, dtype=object))
    yield Hostile("complex", lambda: np.full((3, 3), 1j))
    yield Hostile("masked", lambda: np.ma.masked_equal(np.arange(3.0), 1))
    yield Hostile("structured", lambda: np.zeros(3, [("a", "f8"), ("b", "i4")]))
    yield Hostile("texts", lambda: np.array(["1", "b", "ü"]))
    yield Hostile("bytes", lambda: np.array([b"1", b"2"]))
    yield Hostile("datetime64", lambda: np.array(["2020-01-01", "NaT"], "datetime64[D]"))
    yield Hostile("bools", lambda: np.array([True, False, True]))
    yield Hostile("float16", lambda: np.full((3, 3), 65504, np.float16))
    yield Hostile("longdouble", lambda: np.full((3, 3), 3, np.longdouble))
    yield Hostile("int64 extremes", lambda: np.array([[-(2**63), 2**63 - 1, 0]]))
    yield Hostile("uint64 extremes", lambda: np.array([2**64 - 1, 0, 1], np.uint64))
    yield Hostile("nan rows", lambda: np.full((3, 3), math.nan, np.float32))
    yield Hostile("inf rows", lambda: np.full((3, 3), math.inf))
    yield Hostile("greatest", lambda: np.full((3, 3), np.finfo(np.float64).max))
    yield Hostile("read-only", lambda: np.broadcast_to(np.float32(1), (4, 3)))
    yield Hostile("not contiguous", lambda: np.arange(60.0).reshape(6, 10)[::-2, ::3])
    yield Hostile("big-endian", lambda: np.arange(9, dtype=">f4").reshape(3, 3))
    yield Hostile("endless float64", lambda: np.broadcast_to(np.float64(1), (TOO_MANY, 3)))
    yield Hostile("endless float32", lambda: np.broadcast_to(np.float32(1), (TOO_MANY, 3)))
    yield Hostile("endless int64", lambda: np.broadcast_to(np.int64(1), (TOO_MANY,)))
    yield Hostile("endless uint8", lambda: np.broadcast_to(np.uint8(1), (TOO_MANY, 1, 4)))
    yield Hostile("endless bool", lambda: np.broadcast_to(np.bool_(True), (TOO_MANY,)))
    yield Hostile("endless faces", lambda: np.broadcast_to(np.float32(1), (6, 2**24, 2**24, 3)))


def _paths(folder: Path) -> Iterator[Hostile]:
    yield Hostile("missing file", lambda: folder / "missing" / "file.json")
    yield Hostile("folder", lambda: folder)
    yield Hostile("path with NUL", lambda: Path(f"{folder}/a\0b.exr"))
    yield Hostile("path with a surrogate", lambda: Path(f"{folder}/\ud800.json"))
    yield Hostile("long path", lambda: folder / ("x" * 300 + ".exr"))
    yield Hostile("parent is a file", lambda: Path(__file__) / "x.json")


def attempt(call: Callable[..., Any], arguments: Mapping[str, Any]) -> BaseException | None:
    """Call with keywords and return the exception; warnings count as such.

    A result that is an iterator is begun, and one that is a coroutine is run.
    """
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        warnings.filterwarnings("ignore", "the picture folds")
        try:
            result = call(**arguments)
            if inspect.iscoroutine(result):
                asyncio.run(result)
            if isinstance(result, Iterator):
                for _ in itertools.islice(result, 2):
                    pass
        except Exception as error:
            return error
        except BaseException as error:
            # PyO3's panics derive from BaseException alone.
            if type(error).__name__ != "PanicException":
                raise
            return error
    return None


def verdict(exception: BaseException | None, parameter: str, others: Iterable[str] = ()) -> str | None:
    """Return why an exception is wrong for an unusable value of a parameter; None if it is right or there is none.

    The message has to name the parameter, or one of the call's `others`, which may no longer fit to it.
    """
    if exception is None:
        return None
    text = ascii(f"{type(exception).__name__}: {exception}")
    allowed = (*ALLOWED, IndexError) if parameter == "index" else ALLOWED
    if not isinstance(exception, allowed) or isinstance(exception, ACCIDENTS):
        return f"an exception of a wrong type, {text}"
    if FOREIGN.search(str(exception)):
        return f"a message that is not ours, {text}"
    names = "|".join(re.escape(name) for name in (parameter, *others))
    is_named = re.search(rf"(?<![A-Za-z0-9])({names})(?![A-Za-z0-9])", str(exception)) is not None
    if len(text) > LONGEST:
        return f"a message of {len(text)} characters, {text}"
    # Files, scenes and devices are named by their own names.
    if not is_named and not isinstance(exception, OSError | nf.Error):
        return f"a message that does not name {parameter}, {text}"
    return None
