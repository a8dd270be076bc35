"""Logistic curves as objects: evaluation, many at once, indexing, and refused data."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, strategies as st
from hypothesis.extra import numpy as npst

import nearfar as nf
from tests.support.fit_cases import SIZES, Array, formula, noisy

anything = st.floats(width=64) | st.sampled_from([0.0, -0.0, 1.0, 2.0, 1e-320, 1.7e308, np.inf, np.nan])


@given(npst.arrays(np.float64, (2, 9), elements=anything))
def test_fits_of_any_data_can_be_evaluated(rows: Array) -> None:
    for x, y in (rows, (np.abs(rows[0]), rows[1]), (np.arange(9.0), rows[1])):
        curve = nf.lod.fit_4pl(x, y)
        counts = np.isfinite(x) & np.isfinite(y)
        if curve.status == "unfittable":
            assert np.isnan(list(curve)).all()
            continue
        assert np.isfinite(list(curve)).all()
        assert curve.b > 0
        assert curve.c > 0
        values = curve(x[counts])
        assert np.isfinite(values).all()
        # No residual exceeds the root of the sum of squares, which is at most that of the mean: N (spread/2)².
        # Eighths, because spreads overflow.
        values, given = values / 8, y[counts] / 8
        assert (np.abs(values - given) <= 1.5 * (1 + 1e-6) * np.ptp(given) + 1e-15 * np.abs(given)).all()


def test_many_curves_equal_single_fits() -> None:
    rows = list(noisy(8, 40, 25, 0.1))
    x, y = rows[0][0], np.array([y for _, y in rows])
    y[3, 4:9] = np.nan
    y[5] = np.nan
    y[7] = 2.0
    own = x * np.random.default_rng(0).uniform(0.9, 1.1, y.shape)
    for places in (x, own):
        curves = nf.lod.fit_4pl(places, y)
        assert curves.a.shape == curves.status.shape == curves.ok.shape == (40,)
        values = curves(x)
        assert values.shape == (40, 25)
        for k in range(40):
            single = nf.lod.fit_4pl(places if places.ndim == 1 else places[k], y[k])
            np.testing.assert_array_equal([*single, single.rms], [*curves[k], curves[k].rms])
            assert (single.status, single.reason, single.ok) == (curves[k].status, curves[k].reason, curves.ok[k])
            np.testing.assert_array_equal(single(x), values[k])
    dropped = nf.lod.fit_4pl(np.delete(x, np.s_[4:9]), np.delete(y[3], np.s_[4:9]))
    np.testing.assert_array_equal(list(dropped), list(nf.lod.fit_4pl(x, y)[3]))
    np.testing.assert_array_equal(list(nf.lod.fit_4pl(own, y[0])[2]), list(nf.lod.fit_4pl(own[2], y[0])))
    assert nf.lod.fit_4pl(x, y[:0]).a.shape == (0,)
    assert nf.lod.fit_4pl(x[:0], y[:, :0]).status.tolist() == ["unfittable"] * 40
    single = nf.lod.fit_4pl(x.astype(np.float32), y[0].astype(np.float32))
    assert single.rms == pytest.approx(nf.lod.fit_4pl(x, y[0]).rms, rel=1e-4)


@given(st.floats(-5, 5), st.floats(0.01, 50), st.floats(1e-6, 1e6), st.floats(-5, 5), st.floats(0, 1e7))
def test_evaluation_equals_the_formula(a: float, b: float, c: float, d: float, x: float) -> None:
    curve = nf.lod.Curve4PL(a, b, c, d, 0.0, "fitted", "")
    with np.errstate(over="ignore", under="ignore"):
        expected = float(formula(np.longdouble(x), *map(np.longdouble, (a, b, c, d))))
    # The exponent b ln(x/c) is up to 1,500 here and rounds to 2⁻⁵³ of itself.
    assert curve(x) == pytest.approx(expected, abs=1e-11)


@pytest.mark.parametrize(
    ("call", "error", "message"),
    [
        (lambda: nf.lod.fit_4pl(SIZES, SIZES)[0], TypeError, "single"),
        (lambda: len(nf.lod.fit_4pl(SIZES, SIZES)), TypeError, "single"),
        (lambda: nf.lod.fit_4pl(SIZES, [SIZES, SIZES])[2], IndexError, "index: expected numbers from -2 to 1, got 2"),
        (lambda: nf.lod.fit_4pl(SIZES, [SIZES, SIZES])[0.5], TypeError, "index: expected a number, a slice"),
    ],
)
def test_refuses_wrong_shapes_and_types(call: Any, error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=message):
        call()


def test_indexing_many_curves_gives_curves() -> None:
    x, y = next(noisy(8, 1, 25, 0.1))
    curves = nf.lod.fit_4pl(x, y * np.arange(1.0, 6.0)[:, None])
    assert len(curves) == 5
    mask = np.array([True, False, True, False, False])
    chosen: list[Any] = [slice(1, 4), slice(None, None, -2), mask, mask.tolist(), [3, -1, 3], np.array([], np.intp)]
    assert len(curves[[]]) == 0
    for index in chosen:
        some = curves[index]
        expected = np.arange(5)[index]
        assert isinstance(some, nf.lod.Curve4PL)
        assert len(some) == len(expected)
        for field in ("a", "b", "c", "d", "rms", "status", "reason"):
            np.testing.assert_array_equal(getattr(some, field), getattr(curves, field)[expected])
        assert some(x).shape == (len(expected), 25)
    assert list(curves[np.int32(-1)]) == list(curves[4])
    assert isinstance(curves[4].a, float)
    assert curves[:0]
    assert curves[4]
