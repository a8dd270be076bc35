"""Cuts: which cells of a tree a viewer sees at which level, from which directions, and which leaves as geometry."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import check
from nearfar._camera.camera import Camera
from nearfar.lod._select.size import ACUITY_LIMIT_DEG, ACUITY_SLOPE
from nearfar.orthoview._directions import widest
from nearfar.orthoview._grid import Grid, Place
from nearfar.orthoview._guests import Guests
from nearfar.orthoview._layout import Layout
from nearfar.orthoview._store import Cells

MOST_VIEWS = 8
"""Greatest number of views of a cell."""

BAND = 0.25
"""Width of the band of distances in which a level's splats take the places of finer ones, over its nearest distance."""


@dataclass(frozen=True)
class Settings:
    """How a tree is viewed."""

    views: int = 3
    """Views of a cell: those whose directions are nearest to the viewer's, raised by `lift_deg`."""
    error_px: float = 1.0
    """Greatest width of a view's pixels, in pixels of the picture."""
    geometry: bool = True
    """Whether leaves so near that their views are too coarse are drawn as geometry."""
    continuous: bool = False
    """Whether levels change splat by splat."""
    gaze: tuple[float, float] | None = None
    """Place in the picture that the viewer looks at, pixels; None for a picture that is equally fine everywhere."""
    budget: int | None = None
    """Greatest number of splats; None for any."""
    lift_deg: float = 0.0
    """Degrees by which the viewer's direction is raised towards the zenith before views are chosen by it."""


@dataclass(frozen=True, eq=False)
class OrthoCut:
    """The parts of a tree that a viewer sees; the nearest cells come first."""

    level: NDArray[np.int64]
    """Level of each cell that is drawn from views (N,)."""
    place: NDArray[np.int64]
    """Its place (N, 3)."""
    directions: NDArray[np.int8]
    """Numbers of the directions it is drawn from (N, views), the nearest one first; −1 where fewer show anything."""
    distance: NDArray[np.float64]
    """Distance of its nearest point from the viewer (N,), metres."""
    in_picture: NDArray[np.bool_]
    """Whether it reaches into the picture (N,)."""
    partial: NDArray[np.bool_]
    """Whether only some of its splats are drawn, and those of cells below it in the places of the others (N,)."""
    leaves: NDArray[np.int64]
    """Places of the leaves that are drawn as geometry (M, 3)."""
    leaf_distance: NDArray[np.float64]
    """Distance of their nearest points (M,), metres."""
    leaf_in_picture: NDArray[np.bool_]
    """Whether they reach into the picture (M,)."""
    reach: float
    """Distance from which on leaves are drawn from views, metres; cells of level k from 2ᵏ times as far, beside a gaze
    from less. For parallel rays the width of a leaf's pixel in pixels of the picture, over `error_px`."""
    unknown: list[tuple[int, Place]] = field(default_factory=list, repr=False)
    """Tiers and places of subtrees that were not read: the cells above stand for theirs. Cuts of trees have none."""

    def __len__(self) -> int:
        """Number of cells that are drawn from views."""
        return len(self.level)

    def parts(self) -> list[bool]:
        """Of each view in `keys` whether only some of its splats are drawn."""
        counts = (self.directions >= 0).sum(axis=1)
        return list(np.repeat(self.partial, counts).tolist())

    def keys(self, in_picture: bool = False) -> list[tuple[int, Place, int]]:
        """Level, place and direction of each view, the nearest cells first; of those in the picture alone if asked."""
        in_picture = check.flag("in_picture", in_picture)
        rows = zip(self.level.tolist(), self.place.tolist(), self.directions.tolist(), self.in_picture, strict=True)
        return [
            (level, (x, y, z), direction)
            for level, (x, y, z), directions, seen in rows
            if seen or not in_picture
            for direction in directions
            if direction >= 0
        ]

    def leaf_places(self, in_picture: bool = False) -> list[Place]:
        """Places of the leaves that are drawn as geometry; of those in the picture alone if asked."""
        in_picture = check.flag("in_picture", in_picture)
        rows = zip(self.leaves.tolist(), self.leaf_in_picture, strict=True)
        return [(x, y, z) for (x, y, z), seen in rows if seen or not in_picture]


class Cutter:
    """Cuts a tree, whose subtrees it reads when a viewer comes to them.

    Parameters
    ----------
    layout
        Of the tree.
    read
        Reads the cells of a subtree, given by its tier and its place.
    """

    def __init__(self, layout: Layout, read: Callable[[int, Place], Cells]) -> None:
        grid = layout.grid
        self._layout, self._read = layout, read
        self._guests: Guests = {}
        self._known: set[tuple[int, Place]] = set()
        self._pitch = grid.cell * widest(layout.directions) / layout.size
        self._cells = _core.OrthoCells(grid.origin, grid.cell, grid.levels, layout.subtree)

    @property
    def grid(self) -> Grid:
        """The tree's cells."""
        return self._layout.grid

    @property
    def known(self) -> int:
        """Number of subtrees that were read."""
        return len(self._known)

    def knows(self, tier: int, place: Place) -> bool:
        """Whether a subtree was read."""
        return (tier, place) in self._known

    def with_guests(self, leaves: Sequence[Place]) -> list[Place]:
        """Leaves whose geometry has all triangles in some leaves: they themselves and their guests."""
        several = [leaf for place in leaves for leaf in (place, *self._guests.get(place, []))]
        return list(dict.fromkeys(several))

    def learn(self, tier: int, place: Place) -> None:
        """Read a subtree."""
        cells = self._read(tier, place)
        self._guests |= cells.guests  # other threads may cut
        self._cells.add(tier, place, [mask.reshape(-1) for mask in cells.masks])
        self._known.add((tier, place))

    def rule(self, camera: Camera, settings: Settings) -> _core.OrthoRule:
        """From which distance on a level is drawn."""
        return _core.OrthoRule(
            camera._core,
            pitch=self._pitch,
            error=settings.error_px,
            band=BAND if settings.continuous else None,
            gaze=None if settings.gaze is None else (settings.gaze, ACUITY_SLOPE, ACUITY_LIMIT_DEG),
        )

    def cut(self, camera: Camera, settings: Settings, *, around: bool = False) -> OrthoCut:
        """The cut with the subtrees that are known."""
        arrays, reach, unknown = self._cells.cut(
            camera._core,
            self.rule(camera, settings),
            directions=self._layout.directions,
            views=settings.views,
            geometry=settings.geometry and self._layout.geometry,
            around=around,
            lift_deg=settings.lift_deg,
        )
        return _cut_of(arrays, unknown, reach, settings.views)

    def whole(self, camera: Camera, settings: Settings, *, around: bool = False) -> OrthoCut:
        """The cut with all subtrees that it needs, which are read."""
        while True:
            found = self.cut(camera, settings, around=around)
            for tier, place in found.unknown:
                self.learn(tier, place)
            if not found.unknown:
                return found


def _cut_of(arrays: dict[str, Any], unknown: list[tuple[int, list[int]]], reach: float, views: int) -> OrthoCut:
    return OrthoCut(
        level=arrays["level"],
        place=arrays["place"],
        directions=np.ascontiguousarray(arrays["directions"][:, :views]),
        distance=arrays["distance"],
        in_picture=arrays["in_picture"],
        partial=arrays["partial"],
        leaves=arrays["leaf_place"],
        leaf_distance=arrays["leaf_distance"],
        leaf_in_picture=arrays["leaf_in_picture"],
        reach=reach,
        unknown=[(tier, (x, y, z)) for tier, (x, y, z) in unknown],
    )


def grid_of(samples: int) -> int:
    """Samples along each axis of a pixel; ValueError for a number that is no square."""
    grid = math.isqrt(samples)
    if grid * grid != samples or grid > MOST_GRID:
        raise ValueError(f"samples: expected 1, 4, 9 … {MOST_GRID**2} for orthoviews, got {samples}")
    return grid


MOST_GRID = 8
"""Greatest number of samples along each axis of a pixel."""
