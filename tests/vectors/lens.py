"""Vectors of radial lenses and their inverses in exact arithmetic.

r_d = f(r) = r (1 + k₁r² + k₂r⁴ + …), odd in r, and its inverse on the branch from 0 to the fold, the least r_max > 0
with f′(r_max) = 0. Points move along their radii; Brown's tangential terms add 2p₁xy + p₂(r² + 2x²) to x and
p₁(r² + 2y²) + 2p₂xy to y.
"""

from __future__ import annotations

from functools import cache
from typing import Any

from tests.vectors.exact import STEP_64, above, document, exact, rounded

Coefficients = tuple[float, ...]

STEPS = 4
"""Number of steps of the published fixed-point iteration."""
HALVINGS = 150
"""Number of halvings of an interval of some units, for 45 digits."""
PLACES = 500
"""Number of positions at which the sign of f′ is tested: closer together than any two of its roots here."""


def distort(k: Coefficients, r: Any) -> Any:
    """f(r)."""
    return r * (1 + sum(exact.mpf(c) * r ** (2 * n + 2) for n, c in enumerate(k)))


def derivative(k: Coefficients, r: Any) -> Any:
    """f′(r)."""
    return 1 + sum((2 * n + 3) * exact.mpf(c) * r ** (2 * n + 2) for n, c in enumerate(k))


@cache
def fold(k: Coefficients) -> Any:
    """r_max, or None for lenses that never fold: the first change of sign of f′, a polynomial in r², by halving."""
    if not any(k):
        return None
    # Cauchy's bound: no root of a polynomial is larger than 1 plus the greatest ratio of a coefficient to the highest
    # one.
    reach = 1 + max([1.0, *((2 * n + 3) * abs(c) for n, c in enumerate(k))]) / abs(k[-1])
    places = [exact.sqrt(exact.mpf(reach) * n / PLACES) for n in range(PLACES + 1)]
    high = next((r for r in places if derivative(k, r) < 0), None)
    if high is None:
        return None
    low = exact.mpf(0)
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        low, high = (low, middle) if derivative(k, middle) < 0 else (middle, high)
    return low


def undistort(k: Coefficients, shown: Any) -> Any:
    """The r of least size with f(r) = shown, by halving."""
    sign, size = exact.sign(shown), abs(shown)
    low, high = exact.mpf(0), fold(k)
    if high is None:
        high = exact.mpf(1)
        while distort(k, high) < size:
            high *= 2
    assert distort(k, high) >= size, "beyond the fold nothing is shown"
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        low, high = (low, middle) if distort(k, middle) > size else (middle, high)
    return sign * low


def fixed_point(k: Coefficients, shown: Any, steps: int) -> Any:
    """The published iteration, r ← r_d / (1 + k₁r² + …), begun at r_d."""
    r = shown
    for _ in range(steps):
        r = shown / (1 + sum(exact.mpf(c) * r ** (2 * n + 2) for n, c in enumerate(k)))
    return r


def distort_point(k: Coefficients, p: tuple[float, float], point: tuple[Any, Any]) -> list[Any]:
    """Position at which a point is shown."""
    x, y = point
    p1, p2 = (exact.mpf(c) for c in p)
    square = x * x + y * y
    factor = 1 + sum(exact.mpf(c) * square ** (n + 1) for n, c in enumerate(k))
    return [
        x * factor + 2 * p1 * x * y + p2 * (square + 2 * x * x),
        y * factor + p1 * (square + 2 * y * y) + 2 * p2 * x * y,
    ]


def undistort_point(k: Coefficients, p: tuple[float, float], start: tuple[float, float], shown: list[Any]) -> list[Any]:
    """The point near a start that is shown at a position, by Newton's method with differences of 25 digits."""
    at = [exact.mpf(x) for x in start]
    step = exact.mpf(10) ** -25
    for _ in range(12):
        x, y = at
        off = [a - b for a, b in zip(distort_point(k, p, (x, y)), shown, strict=True)]
        columns = []
        for dx, dy in ((step, 0), (0, step)):
            ahead, behind = distort_point(k, p, (x + dx, y + dy)), distort_point(k, p, (x - dx, y - dy))
            columns.append([(a - b) / (2 * step) for a, b in zip(ahead, behind, strict=True)])
        (a, c), (b, d) = columns
        determinant = a * d - b * c
        at = [x - (d * off[0] - b * off[1]) / determinant, y - (a * off[1] - c * off[0]) / determinant]
    assert (
        max(abs(a - b) for a, b in zip(distort_point(k, p, (at[0], at[1])), shown, strict=True)) < exact.mpf(10) ** -40
    )
    return at


LENSES: tuple[tuple[str, Coefficients], ...] = (
    ("no coefficients: nothing changes", ()),
    ("monotone, Rift S (Liebisch 2021)", (0.22, 0.24)),
    ("monotone, Cardboard (2015)", (0.441, 0.156)),
    ("monotone, one coefficient", (0.1,)),
    ("monotone, only the third coefficient", (0.0, 0.0, 0.7)),
    ("monotone, of both signs", (-0.3, 0.1)),
    ("folds, one coefficient", (-0.2,)),
    ("folds, then rises again", (-0.4, 0.05)),
    ("folds, a positive first coefficient", (5.0, -1.0)),
    ("folds, four coefficients", (0.3, -0.2, 0.1, -0.05)),
)

MONOTONE = (0.0, 1e-9, -0.015625, 0.25, -0.5, 0.8, 1.0, -1.3, 2.5, -7.0)
"""Radii of either sign for lenses that never fold."""
SHARES = (0.0, 1e-9, -0.05, 0.2, -0.4, 0.6, -0.8, 0.95)
"""Radii as shares of r_max."""
NEAR_FOLD = (0.99, -0.999, 0.99999, -0.9999999)


def _samples(region: str, k: Coefficients, radii: list[float]) -> dict[str, Any]:
    shown = [rounded(distort(k, exact.mpf(r))) for r in radii]
    # The inverse of the rounded value, which near a fold is a different number.
    inverse = [undistort(k, exact.mpf(x)) for x in shown]
    slopes = [derivative(k, exact.mpf(r)) for r in radii]
    root = max(
        (2 * abs(x) / (abs(r) * derivative(k, r)) + 1 for r, x in zip(inverse, shown, strict=True) if r), default=1
    )
    sizes = [derivative(tuple(abs(c) for c in k), exact.mpf(r)) for r in radii]
    end = fold(k)
    return {
        "region": region,
        "k": list(k),
        "tolerance": {
            "distort": above(2 * STEP_64),
            "undistort": above(2 * STEP_64 * root),
            "derivative": above((2 * len(k) + 2) * 2 * STEP_64 * max(sizes)),
            "lut": 5e-10,
            "fixed_point": above(_iteration(k, shown)),
            **({} if end is None else {"fold": above(_fold_error(k, end))}),
        },
        "r": radii,
        "distorted": shown,
        "undistorted": rounded(inverse),
        "derivative": rounded(slopes),
        "fixed_point": [rounded(fixed_point(k, exact.mpf(x), STEPS)) for x in shown],
        "r_max": None if end is None else rounded(end),
        "distorted_max": None if end is None else rounded(distort(k, end)),
    }


def _fold_error(k: Coefficients, end: Any) -> Any:
    """Share of r_max by which rounding of f′, 2 (n + 1) steps of its terms' sizes, moves its root; four of each."""
    terms = derivative(tuple(abs(c) for c in k), end)
    second = sum((2 * n + 3) * (2 * n + 2) * exact.mpf(c) * end ** (2 * n + 2) for n, c in enumerate(k))
    return 8 * (len(k) + 1) * STEP_64 * terms / abs(second)


def _iteration(k: Coefficients, shown: list[float]) -> Any:
    """Relative rounding of the published iteration: 2 (n + 2) steps at a time, each carried on by its slope."""
    worst = exact.mpf(1)
    for x in (exact.mpf(value) for value in shown if value):
        carried, r = exact.mpf(1), x
        for _ in range(STEPS):
            factor = 1 + sum(exact.mpf(c) * r ** (2 * n + 2) for n, c in enumerate(k))
            sizes = 1 + sum((2 * n + 2) * abs(exact.mpf(c)) * r ** (2 * n + 2) for n, c in enumerate(k))
            carried = 1 + carried * sizes / abs(factor)
            r = x / factor
        worst = max(worst, carried)
    return 2 * (len(k) + 2) * 2 * STEP_64 * worst


def radial() -> list[dict[str, Any]]:
    """Radii through lenses, by whether and where these fold."""
    found = []
    for region, k in LENSES:
        end = fold(k)
        if end is None:
            found.append(_samples(region, k, list(MONOTONE)))
            continue
        found.append(_samples(region, k, [rounded(end * share) for share in SHARES]))
        found.append(_samples(f"{region}: near the fold", k, [rounded(end * share) for share in NEAR_FOLD]))
    return found


POINTS = ((0.0, 0.0), (0.5, 0.0), (0.0, -0.625), (0.3, 0.4), (-0.35, 0.2), (-0.1, -0.55), (0.45, -0.25))


def points() -> list[dict[str, Any]]:
    """Points in all quadrants through centred lenses and lenses with tangential terms."""
    found = []
    for region, k, p in (
        ("a centred lens", (0.22, 0.24), (0.0, 0.0)),
        ("a centred lens that folds", (-0.2,), (0.0, 0.0)),
        ("tangential terms", (0.22, 0.24), (0.013, -0.021)),
        ("tangential terms alone", (), (-0.03, 0.01)),
    ):
        shown = [rounded(distort_point(k, p, (exact.mpf(x), exact.mpf(y)))) for x, y in POINTS]
        back = [undistort_point(k, p, at, [exact.mpf(x) for x in to]) for at, to in zip(POINTS, shown, strict=True)]
        found.append(
            {
                "region": region,
                "k": list(k),
                "tangential": list(p),
                # A dozen roundings of radii below 1; the inverse divides by slopes of at least a half here.
                "tolerance": {"distort": above(16 * STEP_64), "undistort": above(32 * STEP_64)},
                "points": [list(at) for at in POINTS],
                "distorted": shown,
                "undistorted": rounded(back),
            }
        )
    return found


def files() -> dict[str, str]:
    """Texts of the files by name."""
    text = document(
        holds="Radii r of either sign, f(r), f'(r), the r of each f(r) as written (its rounding moves it near a fold), "
        f"and {STEPS} steps of the published iteration from it; where lenses fold, f'(r_max) = 0, or null. Points with "
        "Brown's tangential terms p1, p2 and back.",
        units="tangents over that of half the field of view: r = 1 at the screen's edge; x to the right, y up.",
        source="r_d = r (1 + k1 r^2 + k2 r^4 + ...): Liebisch (2021), Eq. 4.10 and Alg. 1; Brown (1966).",
        tolerance={
            "distort": "Share of f(r): one unit in the last place. Points: 16 roundings of 1.",
            "undistort": "Share of r: 2 units in the last place of f(r) over the slope f', and one of r. Points: 32 "
            "roundings of 1.",
            "derivative": "2 (n + 1) units in the last place of the sum of the terms' sizes, n coefficients.",
            "lut": "Share of r: the greatest lut_bound that nearfar.RadialLens states; besides undistort's.",
            "fixed_point": "Share of r: 2 (n + 2) units in the last place a step, carried on by the iteration's slope.",
            "fold": "Share of r_max: 8 (n + 1) roundings of the terms of f', over r_max f''. distorted_max: distort's.",
        },
        radial=radial(),
        points=points(),
    )
    return {"lens.json": text}
