"""Logistic curves against known parameters, and fits to degenerate data."""

from __future__ import annotations

import subprocess
import sys

import numpy as np
import pytest
from hypothesis import given, strategies as st

import nearfar as nf
from tests.support import PEAK, need, printed_by_threads
from tests.support.fit_cases import SIZES, formula, noisy


@given(
    st.floats(-1, 1),
    st.floats(0.05, 2),
    st.booleans(),
    st.floats(0.7, 6),
    st.floats(np.log(2e-3), np.log(0.15)),
    st.integers(20, 60),
)
def test_clean_curves_are_recovered(a: float, height: float, falls: bool, b: float, log_c: float, count: int) -> None:
    # At b = 0.7 the samples still reach to an eighth of the height from both plateaus.
    d, c = (a - height if falls else a + height), float(np.exp(log_c))
    x = np.geomspace(1e-4, 3, count)
    y = formula(x, a, b, c, d)
    curve = nf.lod.fit_4pl(x, y)
    assert curve.status == "fitted"
    assert curve.ok is True
    assert curve.reason == ""
    # Rounding of y, 2⁻⁵³, is amplified by the condition of the parameters: some hundreds here.
    np.testing.assert_allclose(list(curve), [a, b, c, d], rtol=1e-9, atol=1e-11)
    assert curve.rms < 1e-15
    a2, b2, c2, d2 = curve
    assert (a2, b2, c2, d2) == (curve.a, curve.b, curve.c, curve.d)


@pytest.mark.parametrize("scale", [1e-300, 1e-8, 1.0, 1e8, 1e300])
@pytest.mark.parametrize("unit", [1e-200, 1e-6, 1e9])
def test_fits_do_not_depend_on_units(scale: float, unit: float) -> None:
    for x, y in noisy(3, 5, 30, 0.05):
        one, other = nf.lod.fit_4pl(x, y), nf.lod.fit_4pl(x * unit, y * scale)
        assert other.status == one.status
        if one.status == "fitted":
            # Parameters of noisy data are only known to the square root of a residual's rounding.
            np.testing.assert_allclose(
                [other.a / scale, other.b, other.c / unit, other.d / scale], list(one), rtol=1e-5, atol=1e-6
            )
        assert other.rms / scale == pytest.approx(one.rms, rel=1e-9)


def test_offsets_add_only_their_own_rounding() -> None:
    y = formula(SIZES, 0.9, 1.3, 0.05, 0.4)
    curve = nf.lod.fit_4pl(SIZES, 1e8 + y)
    assert curve.status == "fitted"
    # y is rounded to 1.5e-8 of a height of 0.5.
    np.testing.assert_allclose([curve.a - 1e8, curve.b, curve.c, curve.d - 1e8], [0.9, 1.3, 0.05, 0.4], rtol=1e-5)
    # Differences between neighbouring x far from zero are exact.
    x = 1e8 + np.arange(20.0)
    y = 1 / (1 + np.exp(np.arange(20) - 9.5))
    np.testing.assert_allclose(nf.lod.fit_4pl(x, y)(x), y, atol=1e-7)


VALLEYS = (
    (np.linspace(0.1, 1, 6), (0.9, 6, 0.1, 0.2)),
    (np.linspace(0.1, 1, 6), (0.9, 6, 0.07, 0.2)),
    (np.linspace(0.1, 1, 6), (0.9, 6, 0.05, 0.2)),
    (np.linspace(0.01, 1, 5), (0.9, 3.6, 0.023, 0.2)),
    (np.linspace(0.01, 1, 12), (0.9, 7, 0.02, 0.2)),
)
"""Clean curves whose residual hardly rises along a curve in (b, c) that leads far away."""


def test_clean_curves_fit_samples_of_one_plateau() -> None:
    for x, truth in VALLEYS:
        y = formula(x, *truth)
        curve = nf.lod.fit_4pl(x, y)
        assert curve.ok
        # Parameters far along the valley fit nearly as well: measured SSIM has a thousand times this noise.
        np.testing.assert_allclose(curve(x), y, atol=5e-5)


def test_curves_with_infinite_parameters_are_fitted_in_the_limit() -> None:
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


def test_a_sample_at_zero_shows_the_first_plateau() -> None:
    x = np.linspace(0, 3, 25)
    y = formula(x, 0.95, 2.5, 0.7, 0.2)
    curve = nf.lod.fit_4pl(x, y)
    np.testing.assert_allclose(list(curve), [0.95, 2.5, 0.7, 0.2], rtol=1e-9)
    assert curve(0.0) == curve.a
    assert curve(np.inf) == curve.d
    # A single sample besides a plateau is a step.
    alone = nf.lod.fit_4pl(x, np.where(x == 0, 1.0, 0.5))
    assert alone.status == "step"
    np.testing.assert_allclose(alone(x), np.where(x == 0, 1.0, 0.5), atol=1e-9)


def test_order_and_repetitions_do_not_matter() -> None:
    random = np.random.default_rng(2)
    for x, y in noisy(5, 10, 20, 0.1):
        curve = nf.lod.fit_4pl(x, y)
        mixed = random.permutation(20)
        np.testing.assert_array_equal(list(nf.lod.fit_4pl(x[mixed], y[mixed])), list(curve))
        twice = nf.lod.fit_4pl(np.repeat(x, 2), np.repeat(y, 2))
        if curve.ok:
            assert twice.rms == pytest.approx(curve.rms, rel=1e-9)


def test_few_samples_are_interpolated_or_refused() -> None:
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


def test_curves_of_pure_noise_are_flat() -> None:
    random = np.random.default_rng(4)
    for samples in (6, 12, 30, 60):
        y = 0.5 + random.normal(size=(1000, samples))
        curves = nf.lod.fit_4pl(np.geomspace(1e-4, 3, samples), y)
        # 95 of 100, four standard deviations of 1000 draws, and the dependence on the number of samples.
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


MEMORY = f"""{PEAK}
import numpy as np
import nearfar as nf
x = np.random.default_rng(0).uniform(0.001, 3, 200_000)
truth = (0.9, 2.5, 0.3, 0.2)
y = truth[3] + (truth[0] - truth[3]) / (1 + (x / truth[2]) ** truth[1])
np.testing.assert_allclose(list(nf.lod.fit_4pl(x, y)), truth, rtol=1e-9)
# All but three samples lie at one x.
x, y = np.full(200_000, 0.1), np.full(200_000, 0.9)
x[[7, 8, 9]], y[[7, 8, 9]] = (0.2, 0.4, 0.8), (0.8, 0.4, 0.3)
np.testing.assert_allclose(nf.lod.fit_4pl(x, y)(x[6:10]), y[6:10], atol=1e-6)
print(peak())
"""


def test_many_samples_take_little_memory() -> None:
    need("linux")
    printed = subprocess.run([sys.executable, "-c", MEMORY], check=True, capture_output=True, text=True).stdout
    # A third of it is the interpreter with NumPy.
    assert int(printed) < 3e8


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
