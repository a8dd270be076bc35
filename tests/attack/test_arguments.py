"""Every public callable works with valid arguments, and refuses invalid ones with messages that name them.

`pytest tests/attack/test_arguments.py -k STAGE-` runs the calls of a stage.
"""

from __future__ import annotations

import contextlib
import sys
from collections.abc import Iterator

import pytest

import nearfar as nf
from tests.support import need
from tests.support.hostile_calls import Call
from tests.support.valid_calls.calls import NAMES, callable_of, needs
from tests.support.valid_calls.objects import Valid

_LONG = (
    "ReducedScene.explore",
    "choose_radii",
    "datasets.World.query",
    "datasets.city",
    "datasets.factory",
    "datasets.room",
    "reduce",
    "regions",
    "stream.export",
    "stream.ring_radii",
    "stream.simulate",
)
LONG = tuple(name for name in NAMES if name.startswith(_LONG))
"""Calls that take tenths of a second with some valid values."""


@pytest.fixture(autouse=True)
def _nothing_left() -> Iterator[None]:
    """Reset the choice of an adapter, and close plots."""
    yield
    with contextlib.suppress(nf.DeviceError):
        nf.gpu.select(None)
    if "matplotlib.pyplot" in sys.modules:
        sys.modules["matplotlib.pyplot"].close("all")


def call_of(name: str, valid: Valid) -> Call:
    for part in needs(name):
        need(part)
    return Call(name, valid)


@pytest.mark.parametrize("name", [pytest.param(name, id=f"{callable_of(name).stage}-{name}") for name in NAMES])
def test_valid_arguments_work_and_invalid_ones_are_named(name: str, valid: Valid) -> None:
    call = call_of(name, valid)
    assert call.attempt_valid() is None
    assert call.wrong_refusals() == []
    assert list(call.differences()) == []
    if name not in LONG:
        assert list(call.refused_floats()) == []
        assert call.wrong_uses() == []


@pytest.mark.slow
@pytest.mark.parametrize("name", LONG)
def test_odd_arguments_of_long_calls_work(name: str, valid: Valid) -> None:
    call = call_of(name, valid)
    assert call.attempt_valid() is None
    assert list(call.refused_floats()) == []
    assert call.wrong_uses() == []
