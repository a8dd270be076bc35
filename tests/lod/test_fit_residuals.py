"""Residuals of logistic curves against a fine search and SciPy."""

from __future__ import annotations

import warnings

import numpy as np
import pytest
import scipy.optimize

import nearfar as nf
from tests.support.fit_cases import Array, formula, noisy


def best_for(x: Array, y: Array, log_b: Array, log_c: Array) -> Array:
    """Return squared residuals of the best a and d for each b and c: a regression of y over 1/(1 + (x/c)^b)."""
    steps = np.exp(log_b)[:, None] * (np.log(x) - log_c[:, None])
    p = 1 / (1 + np.exp(np.clip(steps, -700, 700)))
    p = p - p.mean(axis=1, keepdims=True)
    centred = y - y.mean()
    square = (p**2).sum(axis=1)
    slope = np.divide(p @ centred, square, out=np.zeros(len(p)), where=square > 0)
    result: Array = ((centred - slope[:, None] * p) ** 2).sum(axis=1)
    return result


def searched(x: Array, y: Array) -> float:
    """Return the least residual by a fine grid over b and c, whose best points are refined without derivatives."""
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
    """Return the least residual that curve_fit finds from sensible starts, unbounded and bounded."""
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


def guessed(x: Array, y: Array) -> list[Array]:
    """Return results of curve_fit from three common initial guesses."""
    found = []
    for b, c in ((2, np.median(x)), (1, np.exp(np.log(x).mean())), (4, x.mean())):
        with warnings.catch_warnings(), np.errstate(all="ignore"):
            warnings.simplefilter("ignore")
            try:
                found.append(scipy.optimize.curve_fit(formula, x, y, p0=[y[0], b, c, y[-1]])[0])
            except RuntimeError:
                continue
    return found


def squared(curve: nf.lod.Curve4PL, x: Array, y: Array) -> float:
    return float(((curve(x) - y) ** 2).sum())


@pytest.mark.parametrize(("samples", "noise"), [(8, 0.1), (20, 0.05), (40, 0.01)])
def test_residuals_are_at_most_scipys(samples: int, noise: float) -> None:
    compared = 0
    for x, y in noisy(7, 6, samples, noise):
        curve = nf.lod.fit_4pl(x, y)
        if curve.ok:
            compared += 1
            assert squared(curve, x, y) <= by_scipy(x, y) * (1 + 1e-9)
            assert curve.rms**2 * samples == pytest.approx(squared(curve, x, y), rel=1e-9)
    assert compared >= (1 if samples == 8 else 4)


@pytest.mark.parametrize("samples", [5, 9, 20])
def test_clean_data_is_fitted_exactly(samples: int) -> None:
    random = np.random.default_rng(samples)
    recovered = 0
    for k in range(30):
        x = (np.linspace(0.1, 1, samples), np.linspace(0.01, 1, samples), np.geomspace(0.01, 1, samples))[k % 3]
        # Middles from a quarter of the first sample to twice the last one.
        truth = np.array([0.9, random.uniform(0.5, 8), np.exp(random.uniform(np.log(x[0] / 4), np.log(2))), 0.2])
        y = formula(x, *truth)
        curve = nf.lod.fit_4pl(x, y)
        assert curve.ok
        for found in guessed(x, y):
            rms = np.sqrt(((formula(x, *found) - y) ** 2).mean())
            # The descent stops when the residual is below any measurable difference.
            assert curve.rms <= rms + 1e-9 * np.ptp(y), truth
            if curve.status != "step" and np.allclose(found, truth, rtol=1e-6, atol=0):
                recovered += 1
                np.testing.assert_allclose(list(curve), truth, rtol=1e-6)
    assert recovered > 30


def test_nearly_clean_data_is_fitted_to_its_noise() -> None:
    for noise in (1e-12, 1e-9, 1e-6):
        for x, y in noisy(19, 20, 20, noise):
            curve = nf.lod.fit_4pl(x, y)
            if curve.status == "fitted":
                for found in guessed(x, y):
                    least = float(np.sqrt(((formula(x, *found) - y) ** 2).mean()))
                    assert curve.rms <= least * (1 + 1e-9) + 1e-15 * np.ptp(y)


@pytest.mark.slow
@pytest.mark.parametrize("noise", [0.05, 0.2, 0.5])
def test_a_fine_grid_search_finds_no_lower_residual(noise: float) -> None:
    for x, y in noisy(11, 8, 16, noise):
        curve = nf.lod.fit_4pl(x, y)
        if curve.ok:
            assert squared(curve, x, y) <= searched(x, y) * (1 + 1e-9)
