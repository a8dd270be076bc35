"""Every public callable refuses unusable arguments with messages that name them, whatever is passed."""

from __future__ import annotations

import contextlib
import sys
from collections.abc import Iterator

import pytest

import nearfar as nf
from tests.support.argument_cases import OBJECTS, Case, cases
from tests.support.hostile_values import Hostile, hostile_values
from tests.support.public_callables import public_callables
from tests.support.valid_calls import valid_arguments
from tests.support.valid_objects import Valid

NAMES = sorted(public_callables())

_LONG = ("choose_radii", "datasets.factory", "regions", "stream.export", "stream.simulate")
"""Callables whose valid calls, which some values make, take tenths of a second."""


@pytest.fixture(scope="module")
def valid(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Valid]:
    """Valid arguments; the working folder is empty, because some texts are valid names of files."""
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(tmp_path_factory.mktemp("working"))
        patch.setenv("MPLBACKEND", "agg")
        yield Valid(tmp_path_factory.mktemp("files"))


@pytest.fixture(scope="module")
def calls(valid: Valid) -> dict[str, Case]:
    return cases(valid)


@pytest.fixture(scope="module")
def values(valid: Valid) -> list[Hostile]:
    return hostile_values(valid.folder, {name: getattr(valid, name) for name in OBJECTS})


@pytest.fixture(autouse=True)
def _nothing_left() -> Iterator[None]:
    """Undo the choice of an adapter, and close plots."""
    yield
    with contextlib.suppress(nf.DeviceError):
        nf.gpu.select(None)
    if "matplotlib.pyplot" in sys.modules:
        sys.modules["matplotlib.pyplot"].close("all")


def test_every_public_callable_has_a_valid_call(valid: Valid, calls: dict[str, Case]) -> None:
    assert {name.partition(" @")[0] for name in valid_arguments(valid)} == set(NAMES)
    failed = {name: error for name, case in calls.items() if (error := case.attempt()) is not None}
    assert failed == {}


@pytest.mark.parametrize(
    "name",
    [pytest.param(name, marks=[pytest.mark.slow] * (name.removeprefix("nearfar.") in _LONG)) for name in NAMES],
)
def test_unusable_arguments_are_named(name: str, calls: dict[str, Case], values: list[Hostile]) -> None:
    own = [case for case in calls.values() if case.name.partition(" @")[0] == name]
    assert [complaint for case in own for complaint in case.complaints(values)] == []
