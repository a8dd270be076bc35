"""Run time against error of logistic fits, a thousand curves, beside SciPy's curve_fit."""

from __future__ import annotations

import functools
import warnings
from typing import Any

import numpy as np
import scipy.optimize
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness.compare import OURS, Case, compare
from benchmarks.harness.report import start

Array = NDArray[np.float64]
COUNT = 1_000
"""Number of curves of a table."""
BOUNDS = ([-np.inf, 1e-6, 1e-12, -np.inf], [np.inf, 1e3, 1e12, np.inf])


def formula(x: Any, a: Any, b: Any, c: Any, d: Any) -> Any:
    return d + (a - d) / (1 + (x / c) ** b)


def curves(samples: int, noise: float) -> tuple[Array, Array]:
    """Make curves of any slope and middle over solid angles, with noise as a share of their height."""
    random = np.random.default_rng(0)
    x = np.geomspace(1e-4, 3, samples)
    a, d = random.uniform(-1, 1, (2, COUNT, 1))
    b, c = np.exp(random.uniform(-1.2, 1.8, (COUNT, 1))), np.exp(random.uniform(-7.5, -0.5, (COUNT, 1)))
    return x, formula(x, a, b, c, d) + noise * np.abs(a - d) * random.normal(size=(COUNT, samples))


def by_scipy(x: Array, y: Array, **options: Any) -> Array:
    """Squared residuals of SciPy's fit from the usual first guess; infinite if it fails."""
    residuals = np.full(len(y), np.inf)
    middle = np.sqrt(x[0] * x[-1])
    with warnings.catch_warnings(), np.errstate(all="ignore"):
        warnings.simplefilter("ignore")
        for k, row in enumerate(y):
            try:
                parameters = scipy.optimize.curve_fit(formula, x, row, p0=(row[0], 1, middle, row[-1]), **options)[0]
            except RuntimeError:
                continue
            residuals[k] = ((formula(x, *parameters) - row) ** 2).sum()
    return residuals


def table(samples: int, noise: float) -> str:
    """Table; errors are the share of curves with a residual above the least of all methods by more than 1e-9 of it."""
    x, y = curves(samples, noise)
    repeated = np.tile(x, (COUNT, 1))

    def ours(places: Array) -> nf.lod.Curve4PL:
        return nf.lod.fit_4pl(places, y)

    def residuals(fitted: nf.lod.Curve4PL | Array) -> Array:
        if isinstance(fitted, np.ndarray):
            return fitted
        return np.asarray(((fitted(x) - y) ** 2).sum(axis=1))

    by = functools.partial(by_scipy, x, y)
    scipy_cases = {"SciPy curve_fit": by, "SciPy curve_fit, bounded": functools.partial(by, bounds=BOUNDS)}
    # Our fit reports some curves as flat where SciPy fits noise: those are left out.
    counted = ours(x).ok
    least = np.min([residuals(ours(x)), *(job() for job in scipy_cases.values())], axis=0)

    def error(fitted: nf.lod.Curve4PL | Array) -> float:
        # Residuals of clean data are only rounding.
        is_above_least = residuals(fitted) > least * (1 + 1e-9) + 1e-13 * y.var(axis=1)
        return float(is_above_least[counted].mean())

    cases = [Case(f"{OURS}, shared x", lambda: ours(x), error), Case(f"{OURS}, own x", lambda: ours(repeated), error)]
    cases += [Case(name, job, error) for name, job in scipy_cases.items()]
    title = f"{COUNT:,} logistic curves of {samples} samples, {noise:.0%} noise"
    return compare(title, cases, repeat=4, unit="share not least")


def main() -> None:
    start(__doc__)
    for samples, noise in ((30, 0.0), (30, 0.05), (30, 0.2), (20, 0.1), (40, 0.1)):
        print(table(samples, noise), flush=True)


if __name__ == "__main__":
    main()
