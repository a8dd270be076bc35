"""Run time against error of bent rays by tolerance; the peer finds fixed points by bisection in NumPy."""

from __future__ import annotations

import functools
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness.compare import OURS, Case, compare, print_limits
from benchmarks.harness.report import start, table

COUNT = 20_000
RADII: dict[str, Any] = {"center": (0.0, 1.7, 0.0), "r1": 30.0, "r2": 50.0}
USER = (6.0, 1.5, -5.0)
HALVINGS = 52
"""Number of bisection steps with which NumPy searches for a point, enough for float64's digits."""

Array = NDArray[np.float64]


def directions(count: int) -> Array:
    """Evenly spread directions (a spherical Fibonacci set)."""
    n = np.arange(count) + 0.5
    y, turn = 1.0 - 2.0 * n / count, n * np.pi * (3.0 - np.sqrt(5.0))
    r = np.sqrt(1.0 - y * y)
    return np.stack([r * np.cos(turn), y, r * np.sin(turn)], axis=1)


def bisect(rays: Array, points: int) -> Array:
    """Points (N, K, 3) at equal steps along each ray between the radii, each a root found by bisection."""
    center, user = np.array(RADII["center"]), np.array(USER)
    v = center - user
    side = v - (rays @ v)[:, None] * rays
    max_offset = np.linalg.norm(side, axis=1)[:, None]
    e = side / max_offset
    # The curve bends between the horizontal distances r1 and r2; a margin on both sides covers all of it.
    horizontal = np.linalg.norm(rays[:, [0, 2]], axis=1)[:, None]
    reach = np.linalg.norm(v)
    steps = np.linspace(RADII["r1"] - reach, RADII["r2"] + reach, points)[None] / horizontal
    low, high = np.zeros_like(steps), np.broadcast_to(max_offset, steps.shape).copy()
    for _ in range(HALVINGS):
        y = 0.5 * (low + high)
        p = user + steps[..., None] * rays[:, None] + y[..., None] * e[:, None]
        from_center = p - center
        rho = np.hypot(from_center[..., 0], from_center[..., 2])
        w = np.clip((RADII["r2"] - rho) / (RADII["r2"] - RADII["r1"]), 0.0, 1.0)
        ranges = np.linalg.norm(p - user, axis=-1), np.linalg.norm(from_center, axis=-1)
        value = w * y / ranges[0] + (1 - w) * (y - max_offset) / ranges[1]
        low, high = np.where(value < 0, y, low), np.where(value < 0, high, y)
    return np.asarray(p)


def error(lines: Array, rays: Array) -> float:
    """Greatest angle in radians, seen from U, between a ray and the morphed middles of its chords."""
    rows = slice(0, len(rays), 20)
    chords = 0.5 * (lines[rows, 1:-1] + lines[rows, 2:])
    defined = np.isfinite(chords[..., 0])
    morphed = nf.morph(chords[defined], user=USER, **RADII) - np.array(USER)
    ray = np.broadcast_to(rays[rows, None], chords.shape)[defined]
    return float(np.arctan2(np.linalg.norm(np.cross(morphed, ray), axis=1), (morphed * ray).sum(axis=1)).max())


def peer(rays: Array, count: int) -> Array:
    """Polylines of `count` bisected points, with the user in front, as `bend_rays` returns them."""
    points = bisect(rays, count)
    return np.concatenate([np.broadcast_to(np.array(USER), (len(points), 1, 3)), points], axis=1)


def margins() -> str:
    rows = [(distance, nf.fold_margin((distance, 1.7, 0.0), **RADII)) for distance in (0.0, 5.0, 10.0, 15.0, 19.0)]
    return table("Metres left before the picture folds, r1 = 30 m, r2 = 50 m", "|U−O|, m {:g} | margin, m {:.3f}", rows)


def main() -> None:
    start(__doc__)
    print_limits()
    rays = directions(COUNT)
    # Nearly vertical rays bend only kilometres away, where the peer's equal steps would be too coarse.
    rays = rays[np.abs(rays[:, 1]) < 0.9]
    error_of, cases = functools.partial(error, rays=rays), []
    for tolerance in (1e-2, 1e-3, 1e-4, 1e-5):
        job = functools.partial(nf.bend_rays, rays, user=USER, tolerance=tolerance, **RADII)
        points = np.isfinite(job()[..., 0]).sum(axis=1).mean()
        cases.append(Case(f"{OURS}, tolerance {tolerance:g}, {points:.1f} points a ray", job, error_of))
    cases += [Case(f"NumPy, {count} points a ray", functools.partial(peer, rays, count), error_of) for count in (8, 32)]
    print(compare(f"{len(rays):,} bent rays, r1 = 30 m, r2 = 50 m, |U−O| = 7.8 m", cases, unit="rad"))
    print(margins())
    print(compare("One fold margin", [Case(OURS, lambda: nf.fold_margin(USER, **RADII))]))


if __name__ == "__main__":
    main()
