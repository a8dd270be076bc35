"""Features of a file: polygons in flat arrays, coordinate system and properties."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from nearfar._base import check
from nearfar._base.errors import UnusableError


@dataclass(frozen=True)
class Outlines:
    """Polygons of features; a polygon's first ring is the outer one, the others are holes."""

    points: NDArray[np.float64]
    """Points (N, 2) in the file's coordinates; rings do not repeat their first point at the end."""
    rings: NDArray[np.int64]
    """Offsets (R + 1,) into the points."""
    polygons: NDArray[np.int64]
    """Offsets (P + 1,) into the rings."""
    features: NDArray[np.int64]
    """Offsets (F + 1,) into the polygons."""

    @property
    def point_starts(self) -> NDArray[np.int64]:
        """Offsets (F + 1,) of the features into the points."""
        return self.rings[self.polygons[self.features]]

    def select(self, rows: NDArray[np.int64 | np.bool_]) -> Outlines:
        """Select some features, by number or by a mask."""
        polygons, feature_offsets = select_runs(self.features, rows)
        rings, polygon_offsets = select_runs(self.polygons, polygons)
        points, ring_offsets = select_runs(self.rings, rings)
        return Outlines(self.points[points], ring_offsets, polygon_offsets, feature_offsets)

    def without_closing_points(self) -> Outlines:
        """Remove the last point of rings where it repeats the first one."""
        rings = np.flatnonzero(np.diff(self.rings) > 1)
        last = self.rings[1:][rings] - 1
        last = last[(self.points[self.rings[:-1][rings]] == self.points[last]).all(axis=1)]
        keep = np.ones(len(self.points), bool)
        keep[last] = False
        return replace(self, points=self.points[keep], rings=offsets(keep)[self.rings])

    def validate(self, *, drop: bool, degrees: bool) -> tuple[Outlines, int]:
        """Reject rings of fewer than three points, and points out of range.

        With `drop` such polygons are left out instead. Return the others and the number of polygons left out.
        """
        # NaN fails each comparison.
        limit = np.array([360.0, 90.0]) if degrees else check.FARTHEST
        is_in_range = np.asarray((np.abs(self.points) <= limit).all(axis=1))
        is_unusable = np.diff(self.rings) < 3
        if is_in_range.all() and not is_unusable.any():
            return self, 0
        if not drop:
            self._raise_for(is_in_range, is_unusable, degrees)
        is_unusable[np.searchsorted(self.rings, np.flatnonzero(~is_in_range), side="right") - 1] = True
        polygon_of = np.arange(len(self.polygons) - 1).repeat(np.diff(self.polygons))
        is_invalid = np.zeros(len(self.polygons) - 1, bool)
        is_invalid[polygon_of[is_unusable]] = True
        usable = Outlines(self.points, self.rings, self.polygons, np.arange(len(self.polygons))).select(~is_invalid)
        return replace(usable, features=offsets(~is_invalid)[self.features]), int(is_invalid.sum())

    def _raise_for(self, is_in_range: NDArray[np.bool_], is_short: NDArray[np.bool_], degrees: bool) -> None:
        if not is_in_range.all():
            point = int(np.argmin(is_in_range))
            ring = int(np.searchsorted(self.rings, point, side="right")) - 1
            x, y = self.points[point].tolist()
            expected = "longitude and latitude in degrees" if degrees else f"numbers up to {check.FARTHEST:g}"
            hint = "; a member 'crs' names a system in metres" if degrees and max(abs(x), abs(y)) < 1e9 else ""
            flaw = f"expected {expected}, got ({x:g}, {y:g}){hint}"
        else:
            ring = int(np.argmax(is_short))
            flaw = f"a ring of {np.diff(self.rings)[ring]} points"
        feature = int(np.searchsorted(self.polygons[self.features], ring, side="right")) - 1
        raise UnusableError(f"feature {feature}: {flaw}; on_invalid='drop' leaves such polygons out")


def concatenate(parts: Sequence[Outlines]) -> Outlines:
    """Concatenate the features of several parts."""
    levels = [
        offsets(np.concatenate([np.zeros(0, np.int64), *(np.diff(getattr(part, name)) for part in parts)]))
        for name in ("rings", "polygons", "features")
    ]
    return Outlines(np.concatenate([np.zeros((0, 2)), *(part.points for part in parts)]), *levels)


def offsets(counts: NDArray[np.int64 | np.bool_] | list[int]) -> NDArray[np.int64]:
    """Offsets (N + 1,) of consecutive runs with these lengths."""
    ends = np.zeros(len(counts) + 1, np.int64)
    np.cumsum(counts, out=ends[1:])
    return ends


def select_runs(
    starts: NDArray[np.int64], runs: NDArray[np.int64 | np.bool_]
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Select runs of rows, whose offsets are `starts` (R + 1,): return the row numbers and the new offsets (N + 1,)."""
    lengths = np.diff(starts)[runs]
    selected = offsets(lengths)
    return np.arange(selected[-1]) + (starts[:-1][runs] - selected[:-1]).repeat(lengths), selected


class Columns(Protocol):
    """Properties of all features."""

    def __call__(self, name: str) -> NDArray[np.float64] | None:
        """Numbers of a property (F,), NaN where missing; None if no feature has it."""

    def texts(self, name: str | None) -> list[str] | None:
        """Features' names: a property, or the identifiers if `name` is None; None if any feature lacks one."""


@dataclass(frozen=True)
class Table:
    """Features of a file."""

    outlines: Outlines
    system: str
    """Name of the coordinate system."""
    degrees: bool
    """Whether its coordinates are longitudes and latitudes."""
    columns: Columns
    metres: float = 1.0
    """Metres per unit of projected coordinates."""
    skipped: int = 0
    """Number of geometries that are not polygons."""
    notes: tuple[str, ...] = ()
    format: str = "GeoJSON"
