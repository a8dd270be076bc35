"""A selection behaves as its array of levels; the other columns exist only on request."""

from __future__ import annotations

import copy
import operator
import pickle
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from tests.support.lod_oracle import random_spheres, usual

CAMERA = nf.Camera((0.5, 1.5, -2.0), fov=nf.Fov(-1.0, 0.9, -1.1, 1.05), size=(1440, 1600))
COLUMNS = ("sigma", "sigma_seen", "threshold", "score", "shown")


def selected(*, full: bool = False, count: int = 300) -> nf.lod.Selection:
    centers, radii = random_spheres(count, 3, CAMERA)
    return nf.lod.select([usual()], np.zeros(count, int), centers, radii, camera=CAMERA, fade=0.5, full=full)


@pytest.fixture(scope="module")
def selection() -> nf.lod.Selection:
    return selected()


def test_levels_compare_and_compute(selection: nf.lod.Selection) -> None:
    level = selection.level
    assert set(np.unique(level)) > {-1, 0, 1}
    others: list[Any] = [0, 2, np.arange(len(level)), selection, level, level.tolist()]
    for name in ("eq", "ne", "lt", "le", "gt", "ge", "add", "sub", "mul", "floordiv", "and_", "or_"):
        compute = getattr(operator, name)
        for other in others:
            divisor = 3 if name == "floordiv" else other
            plain = level if divisor is selection else divisor
            for found, expected in (
                (compute(selection, divisor), compute(level, plain)),
                (compute(divisor, selection + 9), compute(plain, level + 9)),
            ):
                assert type(found) is np.ndarray
                assert found.dtype == expected.dtype
                assert np.array_equal(found, expected)
    assert np.array_equal(-selection, -level)
    assert np.array_equal(abs(selection), abs(level))
    assert np.array_equal(np.maximum(selection, 0), np.maximum(level, 0))
    assert np.add.reduce(selection) == level.sum()


@pytest.mark.parametrize(
    "use",
    [
        np.asarray,
        np.array,
        lambda s: np.asarray(s, np.float64),
        lambda s: np.where(s > 1),
        lambda s: np.where(s > 1, s, 0),
        lambda s: np.unique(s, return_counts=True),
        lambda s: np.bincount(np.maximum(s, 0)),
        lambda s: np.concatenate([s, s]),
        lambda s: np.arange(10)[s],
        lambda s: np.arange(20).reshape(2, 10)[0, s],
        lambda s: np.max(s),
        lambda s: np.count_nonzero(s >= 0),
        lambda s: s[3],
        lambda s: s[-1],
        lambda s: s[2:9],
        lambda s: s[s > 0],
        lambda s: s[np.array([4, 1])],
        lambda s: (s.max(), s.min(), s.sum(), s.mean(), s.any(), s.all(), s.argmax()),
        lambda s: s.astype(np.int64),
        lambda s: s.tolist(),
        lambda s: list(s),
        lambda s: (*s.shape, s.ndim, s.size, s.dtype.itemsize, len(s)),
        lambda s: s.tobytes(),
        lambda s: s.reshape(-1, 10).T,
        lambda s: 3 in s,
        lambda s: sorted(s),
    ],
)
def test_array_functions_accept_a_selection(selection: nf.lod.Selection, use: Callable[[Any], Any]) -> None:
    found, expected = use(selection), use(selection.level)
    assert type(found) is type(expected)
    np.testing.assert_array_equal(found, expected)


def test_numpy_assertions_and_the_package_accept_a_selection(selection: nf.lod.Selection) -> None:
    np.testing.assert_array_equal(selection, selection.level)
    with pytest.raises(AssertionError):
        np.testing.assert_array_equal(selection, selection.level + 1)
    assert np.asarray(selection) is selection.level
    assert not np.shares_memory(np.array(selection), selection.level)
    centers, radii = random_spheres(300, 3, CAMERA)
    options: dict[str, Any] = {"camera": CAMERA, "hysteresis": 0.1}
    index = np.zeros(300, int)
    after = nf.lod.select([usual()], index, centers, radii, previous=selection, **options)
    np.testing.assert_array_equal(
        after, nf.lod.select([usual()], index, centers, radii, previous=selection.level, **options)
    )


def test_levels_can_be_written() -> None:
    levels: Any = selected()
    expected: NDArray[np.int32] = levels.level.copy()
    levels[levels < 0] = 0
    expected[expected < 0] = 0
    np.testing.assert_array_equal(levels, expected)
    levels += 1
    np.testing.assert_array_equal(levels, expected + 1)


def test_truth_value_equals_that_of_an_array(selection: nf.lod.Selection) -> None:
    with pytest.raises(ValueError, match="ambiguous"):
        bool(selection)
    assert bool(selected(count=1)) == bool(selected(count=1).level)


def test_columns_exist_on_request(selection: nf.lod.Selection) -> None:
    full = selected(full=True)
    np.testing.assert_array_equal(full, selection)
    assert full.counts == selection.counts
    assert np.array_equal(full.coarser, np.ceil(full.shown))
    for name in COLUMNS:
        assert getattr(full, name).shape == (300,)
        assert not hasattr(selection, name)
        with pytest.raises(AttributeError, match=f"{name}: expected a selection made with full=True"):
            getattr(selection, name)
    for name in ("coarser", "finer_weight"):
        with pytest.raises(AttributeError, match=f"{name}: expected a selection made with full=True"):
            getattr(selection, name)
    with pytest.raises(AttributeError, match="colour"):
        _ = selection.colour
    with pytest.raises(AttributeError):
        full.level = selection.level  # type: ignore[misc]


@pytest.mark.parametrize("full", [False, True])
def test_copies_are_complete(full: bool) -> None:
    one = selected(full=full)
    for other in (pickle.loads(pickle.dumps(one)), copy.copy(one), copy.deepcopy(one)):
        assert isinstance(other, nf.lod.Selection)
        np.testing.assert_array_equal(other, one)
        assert repr(other) == repr(one)
        assert [hasattr(other, name) for name in COLUMNS] == [full] * len(COLUMNS)
