"""Logistic curves against known parameters, a fine search, and SciPy; and what becomes of data that has none."""

from __future__ import annotations

import subprocess
import sys
import warnings
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
import scipy.optimize
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as npst
from numpy.typing import NDArray

import nearfar as nf
from tests.support import PEAK, need, printed_by_threads

Array = NDArray[np.float64]
SIZES = np.geomspace(1e-4, 3, 30)
"""Solid angles in steradians."""


def formula(x: Any, a: Any, b: Any, c: Any, d: Any) -> Any:
    """The definition as written, in extended precision where x is."""
    return d + (a - d) / (1 + (x / c) ** b)


def best_for(x: Array, y: Array, log_b: Array, log_c: Array) -> Array:
    """Squared residuals of the best a and d for each b and c: a regression of y over 1/(1 + (x/c)^b)."""
    steps = np.exp(log_b)[:, None] * (np.log(x) - log_c[:, None])
    p = 1 / (1 + np.exp(np.clip(steps, -700, 700)))
    p = p - p.mean(axis=1, keepdims=True)
    centred = y - y.mean()
    square = (p**2).sum(axis=1)
    slope = np.divide(p @ centred, square, out=np.zeros(len(p)), where=square > 0)
    result: Array = ((centred - slope[:, None] * p) ** 2).sum(axis=1)
    return result


def searched(x: Array, y: Array) -> float:
    """The least residual by a fine grid over b and c, whose best places are polished without derivatives."""
    log_b, log_c = (
        grid.ravel()
        for grid in np.meshgrid(np.log(np.geomspace(0.01, 300, 120)), np.linspace(np.log(1e-6), np.log(300), 400))
    )
    residuals = best_for(x, y, log_b, log_c)
    least = np.inf
    for n in np.argsort(residuals)[:200:20]:
        options = {"xatol": 1e-10, "fatol": 0.0, "maxiter": 600}
        job = lambda at: best_for(x, y, at[:1], at[1:])[0]  # noqa: E731
        found = scipy.optimize.minimize(job, [log_b[n], log_c[n]], method="Nelder-Mead", options=options)
        least = min(least, float(found.fun))
    return least


def by_scipy(x: Array, y: Array) -> float:
    """The least residual that curve_fit finds from sensible starts, unbounded and bounded."""
    middle = float(np.exp(np.log(x).mean()))
    first, last = y[0], y[-1]
    starts = [(first, 1, middle, last), (first, 3, middle, last), (y.max(), 0.5, np.median(x), y.min())]
    bounds = ([-np.inf, 1e-6, 1e-12, -np.inf], [np.inf, 1e3, 1e12, np.inf])
    least = np.inf
    for start in starts:
        for options in ({"maxfev": 5000}, {"bounds": bounds, "max_nfev": 1000}):
            with warnings.catch_warnings(), np.errstate(all="ignore"):
                warnings.simplefilter("ignore")
                try:
                    found = scipy.optimize.curve_fit(formula, x, y, p0=start, **options)[0]
                except RuntimeError:
                    continue
                least = min(least, float(((formula(x, *found) - y) ** 2).sum()))
    return least


def noisy(seed: int, count: int, samples: int, noise: float) -> Iterator[tuple[Array, Array]]:
    """Curves of any slope and middle, with normal noise as a share of their height."""
    random = np.random.default_rng(seed)
    x = np.geomspace(1e-4, 3, samples)
    for _ in range(count):
        a, d = random.uniform(-1, 1, 2)
        y = formula(x, a, np.exp(random.uniform(-1.2, 2.0)), np.exp(random.uniform(-8.0, 0.5)), d)
        yield x, y + noise * abs(a - d) * random.normal(size=samples)


def squared(curve: nf.lod.Curve4PL, x: Array, y: Array) -> float:
    return float(((curve(x) - y) ** 2).sum())


@given(
    st.floats(-1, 1),
    st.floats(0.05, 2),
    st.booleans(),
    st.floats(0.7, 6),
    st.floats(np.log(2e-3), np.log(0.15)),
    st.integers(20, 60),
)
def test_clean_curves_come_back(a: float, height: float, falls: bool, b: float, log_c: float, count: int) -> None:
    # At b = 0.7 the samples still reach to an eighth of the height from both plateaus.
    d, c = (a - height if falls else a + height), float(np.exp(log_c))
    x = np.geomspace(1e-4, 3, count)
    y = formula(x, a, b, c, d)
    curve = nf.lod.fit_4pl(x, y)
    assert curve.status == "fitted"
    assert curve.ok is True
    assert curve.reason == ""
    # Rounding of y, 2⁻⁵³, is magnified by how badly the samples tell parameters apart: some hundreds here.
    np.testing.assert_allclose(list(curve), [a, b, c, d], rtol=1e-9, atol=1e-11)
    assert curve.rms < 1e-15
    a2, b2, c2, d2 = curve
    assert (a2, b2, c2, d2) == (curve.a, curve.b, curve.c, curve.d)


@pytest.mark.parametrize("scale", [1e-300, 1e-8, 1.0, 1e8, 1e300])
@pytest.mark.parametrize("unit", [1e-200, 1e-6, 1e9])
def test_units_do_not_matter(scale: float, unit: float) -> None:
    for x, y in noisy(3, 5, 30, 0.05):
        one, other = nf.lod.fit_4pl(x, y), nf.lod.fit_4pl(x * unit, y * scale)
        assert other.status == one.status
        if one.status == "fitted":
            # Parameters of noisy data are known to the root of a residual's rounding only.
            np.testing.assert_allclose(
                [other.a / scale, other.b, other.c / unit, other.d / scale], list(one), rtol=1e-5, atol=1e-6
            )
        assert other.rms / scale == pytest.approx(one.rms, rel=1e-9)


def test_offsets_cost_only_their_own_rounding() -> None:
    y = formula(SIZES, 0.9, 1.3, 0.05, 0.4)
    curve = nf.lod.fit_4pl(SIZES, 1e8 + y)
    assert curve.status == "fitted"
    # y is rounded to 1.5e-8 of a height of 0.5.
    np.testing.assert_allclose([curve.a - 1e8, curve.b, curve.c, curve.d - 1e8], [0.9, 1.3, 0.05, 0.4], rtol=1e-5)
    # Neighbouring x far from zero keep their differences.
    x = 1e8 + np.arange(20.0)
    y = 1 / (1 + np.exp(np.arange(20) - 9.5))
    np.testing.assert_allclose(nf.lod.fit_4pl(x, y)(x), y, atol=1e-7)


@pytest.mark.parametrize("samples", [8, 20, 40])
@pytest.mark.parametrize("noise", [0.01, 0.05, 0.1, 0.2])
def test_residuals_are_never_above_scipys(samples: int, noise: float) -> None:
    compared = 0
    for x, y in noisy(7, 20, samples, noise):
        curve = nf.lod.fit_4pl(x, y)
        if curve.ok:
            compared += 1
            assert squared(curve, x, y) <= by_scipy(x, y) * (1 + 1e-9)
            assert curve.rms**2 * samples == pytest.approx(squared(curve, x, y), rel=1e-9)
    assert compared >= (4 if samples == 8 else 15)


VALLEYS = (
    (np.linspace(0.1, 1, 6), (0.9, 6, 0.1, 0.2)),
    (np.linspace(0.1, 1, 6), (0.9, 6, 0.07, 0.2)),
    (np.linspace(0.1, 1, 6), (0.9, 6, 0.05, 0.2)),
    (np.linspace(0.01, 1, 5), (0.9, 3.6, 0.023, 0.2)),
    (np.linspace(0.01, 1, 12), (0.9, 7, 0.02, 0.2)),
)
"""Clean curves whose residual hardly rises along a line over b and c that leads far away."""


def test_clean_curves_pass_samples_that_show_one_plateau() -> None:
    for x, truth in VALLEYS:
        y = formula(x, *truth)
        curve = nf.lod.fit_4pl(x, y)
        assert curve.ok
        # Parameters far along the valley fit nearly as well: measured SSIM has a thousand times this noise.
        np.testing.assert_allclose(curve(x), y, atol=5e-5)


def guessed(x: Array, y: Array) -> list[Array]:
    """Results of curve_fit from three common first guesses."""
    found = []
    for b, c in ((2, np.median(x)), (1, np.exp(np.log(x).mean())), (4, x.mean())):
        with warnings.catch_warnings(), np.errstate(all="ignore"):
            warnings.simplefilter("ignore")
            try:
                found.append(scipy.optimize.curve_fit(formula, x, y, p0=[y[0], b, c, y[-1]])[0])
            except RuntimeError:
                continue
    return found


@pytest.mark.parametrize("samples", [5, 6, 9, 14, 20])
def test_nothing_is_better_on_clean_data(samples: int) -> None:
    random = np.random.default_rng(samples)
    recovered = 0
    for k in range(60):
        x = (np.linspace(0.1, 1, samples), np.linspace(0.01, 1, samples), np.geomspace(0.01, 1, samples))[k % 3]
        # Middles up to a factor of 4 before the samples and 2 beyond.
        truth = np.array([0.9, random.uniform(0.5, 8), np.exp(random.uniform(np.log(x[0] / 4), np.log(2))), 0.2])
        y = formula(x, *truth)
        curve = nf.lod.fit_4pl(x, y)
        assert curve.ok
        for found in guessed(x, y):
            rms = np.sqrt(((formula(x, *found) - y) ** 2).mean())
            # Descents stop where less is left than any measurement tells.
            assert curve.rms <= rms + 1e-9 * np.ptp(y), truth
            if curve.status != "step" and np.allclose(found, truth, rtol=1e-6, atol=0):
                recovered += 1
                np.testing.assert_allclose(list(curve), truth, rtol=1e-6)
    assert recovered > 60


def test_nearly_clean_data_is_fitted_to_its_noise() -> None:
    for noise in (1e-12, 1e-9, 1e-6):
        for x, y in noisy(19, 20, 20, noise):
            curve = nf.lod.fit_4pl(x, y)
            if curve.status == "fitted":
                for found in guessed(x, y):
                    least = float(np.sqrt(((formula(x, *found) - y) ** 2).mean()))
                    assert curve.rms <= least * (1 + 1e-9) + 1e-15 * np.ptp(y)


@pytest.mark.parametrize("noise", [0.05, 0.2, 0.5])
def test_no_fine_search_finds_less(noise: float) -> None:
    for x, y in noisy(11, 8, 16, noise):
        curve = nf.lod.fit_4pl(x, y)
        if curve.ok:
            assert squared(curve, x, y) <= searched(x, y) * (1 + 1e-9)


def test_curves_whose_best_parameters_are_infinite_are_fitted_in_the_limit() -> None:
    for name, y in (("log", np.log(SIZES)), ("power", SIZES**-0.3), ("root", SIZES**0.3), ("line", 2 * SIZES)):
        curve = nf.lod.fit_4pl(SIZES, y)
        assert (curve.status, curve.ok) == ("open", True), name
        assert "plateau" in curve.reason
        np.testing.assert_allclose(curve(SIZES), y, atol=1e-8 * np.abs(y).max(), err_msg=name)
    step = nf.lod.fit_4pl(SIZES, np.where(SIZES < 0.1, 0.9, 0.2))
    assert step.status == "step"
    np.testing.assert_allclose(step(SIZES), np.where(SIZES < 0.1, 0.9, 0.2), atol=1e-8)
    one_between = np.where(SIZES < 0.1, 0.9, 0.2)
    one_between[np.argmax(SIZES >= 0.1)] = 0.5
    met = nf.lod.fit_4pl(SIZES, one_between)
    assert met.status == "step"
    np.testing.assert_allclose(met(SIZES), one_between, atol=1e-8)


def test_zero_is_where_the_first_plateau_is_seen() -> None:
    x = np.linspace(0, 3, 25)
    y = formula(x, 0.95, 2.5, 0.7, 0.2)
    curve = nf.lod.fit_4pl(x, y)
    np.testing.assert_allclose(list(curve), [0.95, 2.5, 0.7, 0.2], rtol=1e-9)
    assert curve(0.0) == curve.a
    assert curve(np.inf) == curve.d
    # Alone against a plateau it is a step.
    alone = nf.lod.fit_4pl(x, np.where(x == 0, 1.0, 0.5))
    assert alone.status == "step"
    np.testing.assert_allclose(alone(x), np.where(x == 0, 1.0, 0.5), atol=1e-9)


def test_order_and_repeats_do_not_matter() -> None:
    random = np.random.default_rng(2)
    for x, y in noisy(5, 10, 20, 0.1):
        curve = nf.lod.fit_4pl(x, y)
        mixed = random.permutation(20)
        np.testing.assert_array_equal(list(nf.lod.fit_4pl(x[mixed], y[mixed])), list(curve))
        twice = nf.lod.fit_4pl(np.repeat(x, 2), np.repeat(y, 2))
        if curve.ok:
            assert twice.rms == pytest.approx(curve.rms, rel=1e-9)


def test_few_samples_are_passed_through_or_refused() -> None:
    curve = nf.lod.fit_4pl([0.1, 0.2, 0.5, 1.0], [0.9, 0.85, 0.5, 0.4])
    assert curve.status == "fitted"
    np.testing.assert_allclose(curve(np.array([0.1, 0.2, 0.5, 1.0])), [0.9, 0.85, 0.5, 0.4], atol=1e-12)
    for x, y in (
        ([1.0, 2, 3], [1.0, 2, 3]),
        ([1.0, 1, 1, 1, 1], [1.0, 2, 3, 4, 5]),
        ([0.0, 1, 1, 2, 2], [1.0, 2, 3, 4, 5]),
        ([], []),
        (SIZES, np.full(30, np.nan)),
        (np.full(30, np.inf), SIZES),
        (-SIZES, SIZES),
    ):
        refused = nf.lod.fit_4pl(x, y)
        assert (refused.status, refused.ok) == ("unfittable", False)
        assert refused.reason
        assert np.isnan([*refused, refused.rms, refused(1.0)]).all()


def test_curves_of_nothing_but_noise_are_flat() -> None:
    random = np.random.default_rng(4)
    for samples in (6, 12, 30, 60):
        y = 0.5 + random.normal(size=(1000, samples))
        curves = nf.lod.fit_4pl(np.geomspace(1e-4, 3, samples), y)
        # 95 in 100, four standard deviations of 1000 draws and what depends on the number of samples.
        assert 0.92 <= np.mean(curves.status == "flat") <= 0.995
        flat = curves.status == "flat"
        np.testing.assert_allclose(curves.a[flat], y[flat].mean(axis=1), rtol=1e-12, atol=1e-15)
        np.testing.assert_array_equal(curves.a[flat], curves.d[flat])
        np.testing.assert_allclose(curves.rms[flat], y[flat].std(axis=1), rtol=1e-12)
        assert np.isfinite(curves(SIZES)[flat]).all()
        a, b, c, d = (field[flat] for field in curves)
        np.testing.assert_array_equal(formula(0.3, a, b, c, d), a)
    for constant in (0.0, 1.0, -1e300, 5e-324):
        curve = nf.lod.fit_4pl(SIZES, np.full(30, constant))
        assert (curve.status, curve.a, curve.d, curve(0.5)) == ("flat", constant, constant, constant)
    rounding = 1e6 + 1e-11 * np.arange(30)
    assert nf.lod.fit_4pl(SIZES, rounding).status == "flat"


anything = st.floats(width=64) | st.sampled_from([0.0, -0.0, 1.0, 2.0, 1e-320, 1.7e308, np.inf, np.nan])


@given(npst.arrays(np.float64, (2, 9), elements=anything))
def test_no_data_raises_and_every_answer_can_be_evaluated(rows: Array) -> None:
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
        # No residual is above the root of all squares, which are no more than those of the mean: N (spread/2)².
        # Eighths, because spreads overflow.
        values, given = values / 8, y[counts] / 8
        assert (np.abs(values - given) <= 1.5 * (1 + 1e-6) * np.ptp(given) + 1e-15 * np.abs(given)).all()


def test_many_curves_are_what_single_calls_find() -> None:
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
def test_evaluation_is_the_formula(a: float, b: float, c: float, d: float, x: float) -> None:
    curve = nf.lod.Curve4PL(a, b, c, d, 0.0, "fitted", "")
    with np.errstate(over="ignore", under="ignore"):
        expected = float(formula(np.longdouble(x), *map(np.longdouble, (a, b, c, d))))
    # The exponent b ln(x/c) is up to 1,500 here and rounds to 2⁻⁵³ of itself.
    assert curve(x) == pytest.approx(expected, abs=1e-11)


@pytest.mark.parametrize(
    ("call", "error", "message"),
    [
        (lambda: nf.lod.fit_4pl([1, 2, 3], [1, 2]), ValueError, r"x: expected shape \(2,\), as y has"),
        (lambda: nf.lod.fit_4pl([[1, 2]], [[1, 2], [3, 4]]), ValueError, r"x: expected shape \(2,\) or \(2, 2\)"),
        (lambda: nf.lod.fit_4pl([1], 1.0), ValueError, r"y: expected shape \(N,\) or \(K, N\), got \(\)"),
        (lambda: nf.lod.fit_4pl([1], [[[1]]]), ValueError, "y: expected shape"),
        (lambda: nf.lod.fit_4pl(["x"], [1]), TypeError, "x: expected real numbers"),
        (lambda: nf.lod.fit_4pl([1], [1j]), TypeError, "y: expected real numbers"),
        (lambda: nf.lod.fit_4pl(SIZES, SIZES)(-1.0), ValueError, "x: expected numbers of at least 0"),
        (lambda: nf.lod.fit_4pl(SIZES, [SIZES, SIZES])([[1.0]]), ValueError, r"x: expected shape \(M,\) or \(2, M\)"),
        (lambda: nf.lod.fit_4pl(SIZES, SIZES)[0], TypeError, "single"),
        (lambda: len(nf.lod.fit_4pl(SIZES, SIZES)), TypeError, "single"),
        (lambda: nf.lod.fit_4pl(SIZES, [SIZES, SIZES])[2], IndexError, "index: expected numbers from -2 to 1, got 2"),
        (lambda: nf.lod.fit_4pl(SIZES, [SIZES, SIZES])[[0, -3]], IndexError, "from -2 to 1, got -3"),
        (lambda: nf.lod.fit_4pl(SIZES, [SIZES, SIZES])[[True]], IndexError, r"mask of shape \(2,\), got \(1,\)"),
        (lambda: nf.lod.fit_4pl(SIZES, [SIZES, SIZES])["a"], TypeError, "index: expected a number, a slice"),
        (lambda: nf.lod.fit_4pl(SIZES, [SIZES, SIZES])[0.5], TypeError, "index: expected a number, a slice"),
        (lambda: nf.lod.fit_4pl(SIZES, [SIZES, SIZES])[None], TypeError, "index: expected a number, a slice"),
    ],
)
def test_refuses_wrong_shapes_and_types(call: Any, error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=message):
        call()


def test_some_of_many_curves_are_curves() -> None:
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


MEMORY = f"""{PEAK}
import numpy as np
import nearfar as nf
x = np.random.default_rng(0).uniform(0.001, 3, 1_000_000)
truth = (0.9, 2.5, 0.3, 0.2)
y = truth[3] + (truth[0] - truth[3]) / (1 + (x / truth[2]) ** truth[1])
np.testing.assert_allclose(list(nf.lod.fit_4pl(x, y)), truth, rtol=1e-9)
# All but three samples lie at one x.
x, y = np.full(1_000_000, 0.1), np.full(1_000_000, 0.9)
x[[7, 8, 9]], y[[7, 8, 9]] = (0.2, 0.4, 0.8), (0.8, 0.4, 0.3)
np.testing.assert_allclose(nf.lod.fit_4pl(x, y)(x[6:10]), y[6:10], atol=1e-6)
print(peak())
"""


def test_a_million_samples_take_little_memory() -> None:
    need("linux")
    printed = subprocess.run([sys.executable, "-c", MEMORY], check=True, capture_output=True, text=True).stdout
    assert int(printed) < 1e9


BITS = """
import hashlib
import numpy as np
import nearfar as nf
random = np.random.default_rng(0)
x, y = np.sort(random.random((3000, 30))), random.random((3000, 30))
parts = [b"".join(field.tobytes() for field in nf.lod.fit_4pl(places, y)) for places in (x, x[0])]
print(hashlib.sha256(b"".join(parts)).hexdigest())
"""


def test_bits_do_not_depend_on_the_number_of_threads() -> None:
    assert len(set(printed_by_threads(BITS))) == 1
