"""Bakes impostors of the far part of a scene, and chooses the near triangles that stay geometry."""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import progress
from nearfar._impostor.quads import Point, Quads
from nearfar._impostor.settings import ImpostorSettings, height_of
from nearfar._partition.partition import Partition
from nearfar._trace.rays import cast_rays

PIXELS_PER_DEGREE = 20.0
"""Density of the pixels in which errors are stated: a headset's, in the middle of its picture."""

_CHECKED_USERS = 8
"""Number of users whose pixels `changed_share` counts."""
_CHECKED_RAYS = 16384
"""Number of their rays, in directions spread evenly over the sphere."""
_GOLDEN = math.pi * (3.0 - math.sqrt(5.0))
"""Golden angle: its multiples are spread evenly in all directions."""


@dataclass(frozen=True)
class Region:
    """Users' region and the cylinder of the near part."""

    center: Point
    """World position O, metres."""
    reach: float
    """Radius of the region, a sphere about O, metres."""
    r2: float
    """Radius of the cylinder about the vertical axis through O, metres."""
    error_px: float
    """Greatest error, pixels."""


@dataclass(frozen=True)
class Baked:
    """Near triangles and quads of one bake."""

    near: NDArray[np.int64]
    """Numbers of the triangles that stay geometry, ascending."""
    quads: Quads | None
    """Quads of the far part; None if there are none."""
    settings: ImpostorSettings
    """Settings of the bake; budgets may have changed `error_px` and `face_size`."""
    missing: float = 0.0
    """Share of the probes' pixels that are missing."""
    sheets: _core.ImpostorSheets | None = None
    """Quads that the bake of another region can use again."""
    far: NDArray[np.int64] = field(default_factory=lambda: np.empty(0, np.int64))
    """Numbers of the far triangles that rays from the region hit, ascending."""

    @property
    def far_count(self) -> int:
        """Number of triangles of the quads."""
        return 0 if self.quads is None else len(self.quads.faces)


def bake(
    zones: Partition, region: Region, settings: ImpostorSettings, earlier: _core.ImpostorSheets | None = None
) -> Baked:
    """Bake the far part of a partitioned scene with these settings, without regard to budgets.

    Quads of an `earlier` bake of the same scene that keep the error bound in this region are used again.
    """
    counts, near = zones.summary(), zones.nsf
    if counts["sf"] == counts["straddling"]:
        return Baked(near, None, settings)
    arguments: dict[str, Any] = {
        "center": region.center,
        "reach": region.reach,
        "height": height_of(settings, region.reach),
        "r2": region.r2,
        "size": settings.face_size,
        "angle": math.radians(settings.error_px / PIXELS_PER_DEGREE),
        "centers": settings.centers,
        "missing": settings.missing,
    }
    with progress.bar("baking impostors") as report:
        baked = _core.bake_impostors(zones.scene._core, arguments, earlier=earlier, report=report)
    far = np.setdiff1d(baked["seen"], near, assume_unique=True)
    if settings.visible:
        is_moving = near >= zones.scene._core.standing_triangle_count
        near = near[is_moving | np.isin(near, baked["seen"], assume_unique=True)]
    quads = Quads.from_kernel(baked)
    return Baked(near, quads if len(quads) else None, settings, float(baked["missing"][-1]), baked["sheets"], far)


def changed_share(zones: Partition, region: Region, baked: Baked) -> float:
    """Return the share of the pixels of users within a region that show a near triangle which was dropped."""
    dropped = np.setdiff1d(zones.nsf, baked.near, assume_unique=True)
    return float(np.isin(_shown_triangles(zones, region, baked), dropped).mean()) if len(dropped) else 0.0


def as_geometry(zones: Partition, region: Region, baked: Baked) -> Baked | None:
    """Return the near triangles and the far ones that rays hit, without quads, if they are no more than the quads'.

    `missing` is the share of the pixels of users within the region that show another triangle. None if that is more
    than the share that quads may miss.
    """
    if not baked.settings.visible or not 0 < len(baked.far) <= baked.far_count:
        return None
    part = np.union1d(baked.near, baked.far)
    shown = _shown_triangles(zones, region, baked)
    missing = float(((shown >= 0) & ~np.isin(shown, part)).mean())
    if missing > baked.settings.missing:
        return None
    return replace(baked, near=part, quads=None, missing=missing, sheets=None)


def _shown_triangles(zones: Partition, region: Region, baked: Baked) -> NDArray[np.int64]:
    """Return the triangle that each pixel of users within a region shows; −1 for the sky.

    The users stand all around O, at several distances and heights, and look in all directions.
    """
    rays = np.arange(_CHECKED_RAYS) + 0.5
    rise, turn = 1.0 - 2.0 * rays / _CHECKED_RAYS, rays * _GOLDEN
    width = np.sqrt(1.0 - rise**2)
    directions = np.column_stack([width * np.cos(turn), rise, width * np.sin(turn)])
    shares = (np.arange(_CHECKED_USERS) + 0.5) / _CHECKED_USERS
    height = height_of(baked.settings, region.reach)
    heights = height * (2.0 * ((5 * np.arange(_CHECKED_USERS)) % _CHECKED_USERS + 0.5) / _CHECKED_USERS - 1.0)
    distances = np.sqrt(shares * (region.reach**2 - height**2))
    angles = np.arange(_CHECKED_USERS) * _GOLDEN
    offsets = np.column_stack([distances * np.cos(angles), heights, distances * np.sin(angles)])
    shown = [cast_rays(zones.scene, np.add(region.center, offset), directions).triangle_index for offset in offsets]
    return np.concatenate(shown)
