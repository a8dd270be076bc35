"""Radii of rings: as published, of equal areas, or with the least expected time to quality."""

from __future__ import annotations

import math
from typing import Literal, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check
from nearfar._scene.scene import Scene, core_of
from nearfar.stream._assign import MAX_RINGS, object_radii
from nearfar.stream._by_footprint import footprints

Policy = Literal["cost", "published", "equal_area"]
"""Policy for choosing radii."""

PUBLISHED = (10.0, 14.0, 17.0, 22.0, 32.0, 63.0)
"""Radii in metres that CloVR (2024) prints for its City; they are about 10 √i for i = 1, 2, 3, 5, 10, 40."""

REACH = PUBLISHED[-1]
"""Default last radius, metres."""

TRIANGLE_BYTES = 5.0
"""Bytes per triangle of compressed geometry."""

INSTANCE_BYTES = 40.0
"""Bytes per instance placement."""

MAP_BYTES = 700_000.0
"""Bytes of the map changes from one ring to the next."""


def ring_radii(
    scene: Scene,
    *,
    center: ArrayLike,
    r_max: float = REACH,
    base_radius: float | None = None,
    bandwidth: float = 50.0,
    latency: float = 0.05,
    map_bytes: float = MAP_BYTES,
    policy: Policy = "cost",
) -> tuple[float, ...]:
    """Choose the radii of rings about a centre: metres, ascending.

    ValueError for numbers out of range, unknown policies, and the policy "cost" if no object lies within `r_max`.
    Source: CloVR (2024): rings of equal area, merged by hand for the City. "cost" is our addition.

    Parameters
    ----------
    scene
        The scene.
    center
        World position of the centre O, metres.
    r_max
        The last radius, metres.
    base_radius
        Radius R of the first ring of equal area, metres, at most `r_max`; the others are R √i. None for 10 m, or
        `r_max` if that is less. "equal_area" returns these radii up to `r_max`, "cost" merges them.
    bandwidth
        Bandwidth of the link, 10⁶ bits per second, 10⁻⁶ to 10⁹. Only for "cost".
    latency
        Seconds before the first byte of a ring arrives, up to 10⁶. Only for "cost".
    map_bytes
        Bytes of the differences between the maps of two consecutive rings, up to 10¹⁵. Only for "cost".
    policy
        "cost": the radii with the least expected time to quality. That is the time until an object's geometry has
        arrived, averaged over all viewing directions that show an object within `r_max`. Rings are sent in order, each
        with its map: more rings show the nearest objects sooner, but send more maps. Bytes are estimated from triangle
        counts; the optimum for them is exact. "published": 10, 14, 17, 22, 32 and 63 m times `base_radius`/10, as far
        as they are at most `r_max`. "equal_area": all rings have the same area.
    """
    core_of(scene)
    middle = check.vector("center", center)
    reach = check.positive("r_max", r_max)
    base = min(PUBLISHED[0], reach) if base_radius is None else check.positive("base_radius", base_radius)
    rate = check.in_range("bandwidth", bandwidth, 1e-6, 1e9) * 1e6 / 8.0
    delay = check.in_range("latency", latency, 0.0, 1e6)
    size = check.in_range("map_bytes", map_bytes, 0.0, 1e15)
    check.choice("policy", policy, get_args(Policy))
    if base > reach:
        raise ValueError(f"base_radius: expected at most r_max = {reach:g} m, got {base:g}")
    if policy == "published":
        # The ratio of the first radius is exactly 1, so that it is included even if `base` equals `r_max`.
        scaled = [base * (radius / PUBLISHED[0]) for radius in PUBLISHED]
        return tuple(radius for radius in scaled if radius <= reach)
    radii = equal_areas(base, reach)
    if policy == "equal_area":
        return radii
    least, least_of_rest, _ = object_radii(scene, middle, reach, "object")
    ring = np.searchsorted(radii, np.append(least, least_of_rest))
    loads = _core.ring_loads(scene._core, ring.astype(np.uint16), len(radii) + 1)[:-1]
    sizes = loads[:, 1] * TRIANGLE_BYTES + loads[:, 2] * INSTANCE_BYTES
    if not sizes.any():
        raise ValueError(f"r_max: expected a radius that an object reaches inside, got {reach:g} m")
    angles = np.bincount(ring[:-1], footprints(scene, center=middle), len(radii) + 1)[:-1]
    return tuple(radii[n] for n in merge_parts(sizes.astype(np.float64), angles.astype(np.float64), rate, delay, size))


def equal_areas(base: float, reach: float) -> tuple[float, ...]:
    """Return the radii base √i below the reach, and the reach; ValueError for too many."""
    count = math.ceil((reach / base) ** 2 * (1.0 - 1e-12)) if reach / base < MAX_RINGS else MAX_RINGS + 1
    if count > MAX_RINGS:
        raise ValueError(f"base_radius: expected at most {MAX_RINGS} rings of equal area, got {base:g} for {reach:g} m")
    return (*(base * math.sqrt(n) for n in range(1, count)), reach)


def merge_parts(
    sizes: NDArray[np.float64], weights: NDArray[np.float64], rate: float, delay: float, map_bytes: float
) -> list[int]:
    """Divide consecutive parts, which are sent in order, into runs of least cost; returns the last part of each run.

    The cost is the weighted mean of the parts' arrival times. It equals the sum over all runs of a run's duration times
    the weight of this run and all later ones. So the best division of the first n parts extends the best division of
    fewer parts (dynamic programming).

    `sizes` (N,) are the bytes of each part; `weights` (N,) may be 0; `rate` is the bandwidth in bytes per second,
    `delay` the seconds before a run's first byte, and `map_bytes` the bytes of each run in addition to its parts. The
    returned part numbers ascend to N − 1.
    """
    before = np.concatenate([[0.0], np.cumsum(sizes)])
    remaining = np.concatenate([np.cumsum(weights[::-1])[::-1], [0.0]])
    best, previous = np.zeros(len(before)), np.zeros(len(before), np.int64)
    for end in range(1, len(before)):
        costs = best[:end] + (delay + (before[end] - before[:end] + map_bytes) / rate) * remaining[:end]
        previous[end] = int(np.argmin(costs))
        best[end] = costs[previous[end]]
    ends, end = [], len(sizes)
    while end > 0:
        ends.append(end - 1)
        end = int(previous[end])
    return ends[::-1]


def choose_radii(scene: Scene, center: ArrayLike) -> tuple[float, ...]:
    """Choose radii about a centre, before baking; ValueError that names the centre if no object is around it."""
    try:
        return ring_radii(scene, center=center)
    except ValueError:
        got = ", ".join(f"{value:g}" for value in check.vector("center", center))
        reason = f"within {REACH:g} m of which there is none; pass radii to use it nevertheless"
        raise ValueError(f"center: expected a place with objects around it, got ({got}), {reason}") from None
