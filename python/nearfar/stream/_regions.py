"""Regions of a bundle: centres, moved to a grid so that nearby requests share one, and the centres' neighbours."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cached_property
from typing import Any, Self, SupportsFloat, SupportsIndex

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import check
from nearfar._reduce.walk.regions import Regions
from nearfar.stream._growth import Growth

Point = tuple[float, float, float]

Floats = NDArray[np.float64]

MAX_CENTERS = 1000
"""Greatest number of centres in a bundle; the manifest describes each centre's rings and tiles."""

MIN_DISTANCE = 1e-3
"""Least distance between two centres, metres; about the step to which geometry is rounded."""

RIGHT_ANGLE_COSINE = 1e-9
"""Cosine below which an angle counts as 90° or more, in spite of rounding: on a grid, right angles are common."""

NEAREST_COUNT = 16
"""Number of nearest centres that are tested first, because they rule out almost all pairs."""


class BundleRegions:
    """Regions of a `Bundle`; its base class."""

    _manifest: dict[str, Any]
    number: int

    @cached_property
    def centers(self) -> NDArray[np.float64]:
        """(K, 3) centres O of all regions, world metres; read-only."""
        return _read_only([region["center"] for region in self._regions])

    @cached_property
    def fold_margins(self) -> NDArray[np.float64]:
        """(K,) horizontal distances in metres from each region's centre, within which complete pictures do not fold.

        A picture is complete once all rings are shown. Each margin is 0.7 of the last ring's radius, as
        `nearfar.fold_margin` returns it at O for kind="cylinder". While a client shows a smaller radius, its margin is
        0.7 of that radius.
        """
        return _read_only([region["fold_margin"] for region in self._regions])

    @property
    def findings(self) -> tuple[str, ...]:
        """Reasons why the region may show little, a sentence each.

        They are a badly placed centre, empty rings, objects that extend from ring 1 beyond the last ring, and a unit
        other than the metre.
        """
        return tuple(self._region["findings"])

    def neighbours(self, region: SupportsIndex) -> tuple[int, ...]:
        """Return the ascending numbers of a region's neighbours, whose first rings are worth fetching ahead.

        Two centres are neighbours if no third one is within or on the sphere whose diameter joins them. The graph of
        neighbours is connected (Gabriel, Sokal, 1969: A new statistical approach to geographic variation analysis).
        """
        return tuple(self._regions[self._check_index(region)]["neighbours"])

    def nearest(self, point: ArrayLike) -> int:
        """Return the region whose centre is nearest to a world position in metres; of equally near ones the first."""
        offsets = self.centers - check.vector("point", point)
        # Scaled, so that no square overflows.
        return int(np.argmin(np.linalg.norm(offsets / np.abs(offsets).max(), axis=1))) if offsets.any() else 0

    def region(self, region: SupportsIndex) -> Self:
        """Return the same bundle for another region, 0 to K − 1; both share the cache of read files."""
        return replace(self, number=self._check_index(region))  # type: ignore[type-var]

    @property
    def _regions(self) -> list[dict[str, Any]]:
        return list(self._manifest["regions"])

    @property
    def _region(self) -> dict[str, Any]:
        return self._regions[self.number]

    def _check_index(self, region: SupportsIndex) -> int:
        return check.integer("region", region, 0, len(self._regions) - 1)


def _read_only(values: list[Any]) -> NDArray[np.float64]:
    array = np.array(values, np.float64)
    array.setflags(write=False)
    return array


def snap(center: ArrayLike, grid: SupportsFloat) -> Point:
    """Move a centre to the nearest point of a horizontal grid, so that nearby requests share one bundle.

    In the result, x and z are the nearest multiples of `grid` (halves round to the even multiple); the height stays.
    The result lies at most grid/√2 from the centre. Source: "Client locality" of CloVR (2024): clients near each other
    are served the same rings and maps.

    Parameters
    ----------
    center
        World position, metres.
    grid
        Spacing of the grid in metres, 0.001 to 10⁶. Its lines pass through x = 0 and z = 0 of the world.
    """
    x, y, z = check.vector("center", center)
    spacing = check.in_range("grid", grid, 1e-3, 1e6)
    return spacing * round(x / spacing), y, spacing * round(z / spacing)


def centers_of(center: ArrayLike | Regions, grid: SupportsFloat | None) -> Floats:
    """Return the centres (K, 3) of a point, of several points or of regions, with duplicates on `grid` merged.

    ValueError for none, for too many, and for two that are closer than `MIN_DISTANCE`.
    """
    values = check.plain("center", center.centers if isinstance(center, Regions) else center)
    if values.ndim == 1:
        values = np.array([check.vector("center", values)])
    points = check.array("center", values, dtype=np.float64, finite=True)
    if not 1 <= len(points) <= MAX_CENTERS:
        raise ValueError(f"center: expected 1 to {MAX_CENTERS} centres, got {len(points)}")
    if np.abs(points).max() > check.FARTHEST:
        raise ValueError(f"center: expected numbers up to {check.FARTHEST:g}, got {np.abs(points).max():g}")
    if grid is not None:
        # A dict keeps the order of the requests.
        points = np.array(list(dict.fromkeys(snap(point, grid) for point in points)))
    _check_distances(points)
    return points


def neighbours(centers: Floats) -> list[list[int]]:
    """Find the neighbours of each of the centres (K, 3), in ascending order: the edges of the Gabriel graph.

    Two centres are neighbours if no third one lies within or on the sphere whose diameter joins them. A centre lies
    there if it sees both at an angle of 90° or more. On a square grid the neighbours are the four nearest centres.
    """
    neighbours_of: list[list[int]] = [[] for _ in centers]
    for first, center in enumerate(centers):
        offsets = centers - center
        nearest = np.argsort((offsets**2).sum(axis=1))[1 : 1 + NEAREST_COUNT]
        later = np.arange(first + 1, len(centers))
        for between in (offsets[nearest], offsets):
            later = later[~_is_between(offsets[later], between)]
        for second in later.tolist():
            neighbours_of[first].append(second)
            neighbours_of[second].append(first)
    return neighbours_of


def half_gap(centers: Floats, neighbour_lists: list[list[int]]) -> float:
    """Return half the greatest distance in metres between a centre and a neighbour; 0 without neighbours.

    A user who walks straight from one centre to the next is never farther than this from the nearest centre.
    """
    pairs = zip(centers, neighbour_lists, strict=True)
    gaps = (np.linalg.norm(centers[numbers] - center, axis=1).max() for center, numbers in pairs if numbers)
    return float(max(gaps, default=0.0)) / 2.0


def reach_of(grid: float | None, half_gap: float = 0.0) -> float:
    """Return the greatest horizontal distance in metres between a user and a centre that may have moved to a grid."""
    return max(Growth.reach, half_gap) + (0.0 if grid is None else math.sqrt(0.5) * float(grid))


def _check_distances(points: Floats) -> None:
    for number, point in enumerate(points[1:], 1):
        too_near = np.flatnonzero(np.abs(points[:number] - point).max(axis=1) < MIN_DISTANCE)
        if len(too_near):
            got = f"({', '.join(f'{v:g}' for v in point)}) twice, at index {too_near[0]} and {number}"
            raise ValueError(f"center: expected centres at least {MIN_DISTANCE:g} m apart, got {got}")


def _is_between(ends: Floats, points: Floats) -> NDArray[np.bool_]:
    """Return whether any of the points (M, 3) sees the origin and each end (N, 3) at an angle of 90° or more."""
    to_ends = ends[:, None] - points
    lengths = np.linalg.norm(to_ends, axis=2) * np.linalg.norm(points, axis=1)
    return np.asarray(((-points * to_ends).sum(axis=2) < RIGHT_ANGLE_COSINE * lengths).any(axis=1))
