"""Tests of single checks of arguments, beside those that pass every hostile value to every public function."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from nearfar._base import check as checks

check: Any = checks
"""Without its types, because the tests pass wrong ones."""


@pytest.mark.parametrize(
    ("call", "kind", "message"),
    [
        (lambda: check.number("r", 10**400), ValueError, "r: expected a number up to 1.8e308, got int a number"),
        (lambda: check.number("r", np.zeros(1)), TypeError, "r: expected a number, got ndarray"),
        (lambda: check.number("r", np.datetime64("NaT")), TypeError, "r: expected a number, got datetime64"),
        (lambda: check.number("r", np.bool_(True)), TypeError, "r: expected a number, got bool"),
        (lambda: check.integer("n", 10**5000, 0, 9), ValueError, "n: .* from 0 to 9, got a number of 16,610 bits"),
        (lambda: check.integer("n", np.zeros(2, int), 0, 9), TypeError, "n: expected a whole number, got ndarray"),
        (lambda: check.flag("copy", 1), TypeError, "copy: expected True or False, got int 1"),
        (lambda: check.flag("copy", np.zeros(2)), TypeError, "copy: expected True or False, got ndarray"),
        (lambda: check.text("name", "\ud800"), ValueError, r"name: .* lone surrogate in '\\ud800'"),
        (lambda: check.path("path", "a\0b"), ValueError, "path: expected a path that the file system can hold"),
        (lambda: check.path("path", ""), ValueError, "path: expected a path, got an empty string"),
        (lambda: check.path("path", b"a"), TypeError, "path: expected a string or a path, got bytes"),
        (lambda: check.texts("names", "ab"), TypeError, "names: expected a sequence of strings, got str 'ab'"),
        (lambda: check.texts("names", np.array("ab")), TypeError, "names: expected a sequence of strings, got ndarray"),
        (lambda: check.items("n", range(10**18), str, "texts"), TypeError, "n: expected texts, got int 0 at index 0"),
        (lambda: check.mapping("at", {1: 2}, "poses by name"), TypeError, "at: expected poses by name, got the key"),
        (lambda: check.size("size", "12"), TypeError, "size: expected .width, height. in pixels, got '12'"),
    ],
)  # fmt: skip
def test_messages_say_what_came(call: Callable[[], Any], kind: type[Exception], message: str) -> None:
    with pytest.raises(kind, match=message):
        call()


def test_views_of_one_number_are_refused_where_a_copy_would_not_fit() -> None:
    for dtype in (np.float32, np.float64, np.int64):
        endless = np.broadcast_to(dtype(1), (2**50, 3))
        with pytest.raises(ValueError, match="points: expected an array that fits into memory"):
            check.array("points", endless, dtype=np.int32 if dtype is np.int64 else None)


def test_numbers_beyond_a_smaller_type_become_infinite_without_a_warning() -> None:
    assert check.array("points", [[1e300, 0, -1e300]], dtype=np.float32).tolist() == [[math.inf, 0, -math.inf]]
    with pytest.raises(ValueError, match="points: expected finite numbers, got 2"):
        check.array("points", [[1e300, 0, -1e300]], dtype=np.float32, finite=True)


def test_values_in_messages_are_short() -> None:
    assert len(check.described("x" * 10_000)) < 80
    assert check.shown((1, 2.5)) == "(1, 2.5)"
    assert check.shown((10**5000,)) == "tuple"
    assert check.shown(np.zeros(9)) == "ndarray"


def test_what_is_usable_passes() -> None:
    assert check.flag("copy", np.bool_(False)) is False
    assert check.path("path", Path("a")) == Path("a")
    assert check.texts("names", iter("ab")) == ["a", "b"]
    assert check.number("r", np.array(2.0)) == 2.0
    assert check.integer("n", np.array(2), 0, 9) == 2
