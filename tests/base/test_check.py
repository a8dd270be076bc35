"""Tests of argument checks, besides those that pass every hostile value to every public function."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from nearfar._base import check as checks

check: Any = checks
"""Untyped, because the tests pass wrong types."""


@pytest.mark.parametrize(
    ("call", "kind", "message"),
    [
        (lambda: check.number("r", 10**400), ValueError, "r: expected a number up to 1.8e308, got int a number"),
        (lambda: check.counts("n", [1.0, 2.5]), TypeError, "n: expected whole numbers, got float64"),
        (lambda: check.counts("n", [math.nan]), TypeError, "n: expected whole numbers, got float64"),
        (lambda: check.counts("n", 2.0**63), TypeError, "n: expected whole numbers, got float64"),
        (lambda: check.counts("n", [3.0, -1.0]), ValueError, "n: expected numbers of at least 0, got -1"),
        (lambda: check.integer("n", 10**5000, 0, 9), ValueError, "n: .* from 0 to 9, got a number of 16,610 bits"),
        (lambda: check.text("name", "\ud800"), ValueError, r"name: .* lone surrogate in '\\ud800'"),
        (lambda: check.path("path", ""), ValueError, "path: expected a path, got an empty string"),
        (lambda: check.items("n", range(10**18), str, "texts"), TypeError, "n: expected texts, got int 0 at index 0"),
        (lambda: check.size("size", "12"), TypeError, "size: expected .width, height. in pixels, got '12'"),
    ],
)  # fmt: skip
def test_messages_quote_the_received_value(call: Callable[[], Any], kind: type[Exception], message: str) -> None:
    with pytest.raises(kind, match=message):
        call()


def test_numbers_beyond_a_smaller_type_become_infinite_without_a_warning() -> None:
    assert check.array("points", [[1e300, 0, -1e300]], dtype=np.float32).tolist() == [[math.inf, 0, -math.inf]]
    with pytest.raises(ValueError, match="points: expected finite numbers, got 2"):
        check.array("points", [[1e300, 0, -1e300]], dtype=np.float32, finite=True)


def test_values_in_messages_are_short() -> None:
    assert len(check.type_and_value("x" * 10_000)) < 80
    assert check.value_or_type((1, 2.5)) == "(1, 2.5)"
    assert check.value_or_type((10**5000,)) == "tuple"
    assert check.value_or_type(np.zeros(9)) == "ndarray"


def test_usable_values_pass() -> None:
    assert check.flag("copy", np.bool_(False)) is False
    assert check.path("path", Path("a")) == Path("a")
    assert check.texts("names", iter("ab")) == ["a", "b"]
    assert check.number("r", np.array(2.0)) == 2.0
    for two in (np.array(2), 2.0, np.float32(2.0)):
        assert check.integer("n", two, 0, 9) == 2
    for numbers in ([2, 3], [2.0, 3.0], np.array([2, 3], np.uint8)):
        assert check.counts("n", numbers).tolist() == [2, 3]
    assert check.counts("n", 1e6).dtype == np.int64
