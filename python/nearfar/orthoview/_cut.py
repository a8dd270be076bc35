"""Cuts: the cells of a tree that a viewer sees, their levels and directions, and the leaves drawn as geometry.

The parts of a cut are read separately: views of cells, geometry of leaves, records of subtrees.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import check
from nearfar._camera.camera import Camera
from nearfar.lod._select.size import ACUITY_LIMIT_DEG, ACUITY_SLOPE
from nearfar.orthoview._grid import Grid, Place, places_of, widest
from nearfar.orthoview._layout import Layout, ViewKey
from nearfar.orthoview._owners import Guests
from nearfar.orthoview._store import Cells

MAX_VIEWS = 8
"""Greatest number of views of a cell."""

BAND = 0.25
"""Width of the distance band in which a level gradually replaces the finer one, as a share of the distance at which the
band begins."""


@dataclass(frozen=True)
class Settings:
    """Settings for viewing a tree."""

    views: int = 3
    """Number of views of a cell: those nearest to the viewer's direction, raised by `lift_deg`."""
    error_px: float = 1.0
    """Greatest width of a view's pixels, in pixels of the picture."""
    geometry: bool = True
    """Whether leaves so near that their views are too coarse are drawn as geometry."""
    continuous: bool = False
    """Whether levels blend splat by splat."""
    gaze: tuple[float, float] | None = None
    """Pixel that the viewer looks at; None for a picture of uniform resolution."""
    budget: int | None = None
    """Greatest number of splats; None for no limit."""
    lift_deg: float = 0.0
    """Degrees by which the viewer's direction is raised towards the zenith before views are chosen."""


@dataclass(frozen=True, eq=False)
class OrthoCut:
    """The parts of a tree that a viewer sees; nearest cells first."""

    level: NDArray[np.int64]
    """Level of each cell that is drawn from views (N,)."""
    place: NDArray[np.int64]
    """Place of each cell (N, 3)."""
    directions: NDArray[np.int8]
    """Direction numbers of the views that each cell is drawn from (N, views), nearest first; −1 for missing ones."""
    distance: NDArray[np.float64]
    """Distance of each cell's nearest point from the viewer (N,), metres."""
    in_picture: NDArray[np.bool_]
    """Whether each cell lies in the picture, at least partly (N,)."""
    partial: NDArray[np.bool_]
    """Whether only some of a cell's splats are drawn, and finer cells replace the others (N,)."""
    leaves: NDArray[np.int64]
    """Places of the leaves that are drawn as geometry (M, 3)."""
    leaf_distance: NDArray[np.float64]
    """Distance of each leaf's nearest point from the viewer (M,), metres."""
    leaf_in_picture: NDArray[np.bool_]
    """Whether each leaf lies in the picture, at least partly (M,)."""
    reach: float
    """Distance beyond which leaves are drawn from views, metres; level k is drawn beyond 2ᵏ times this distance. It is
    shorter away from a gaze. For parallel rays it is the ratio of a leaf's pixel width in the picture to `error_px`."""
    unknown: list[tuple[int, Place]] = field(default_factory=list, repr=False)
    """Tiers and places of subtrees whose records must still be read; until then coarser cells replace them. Empty in
    complete cuts."""
    unbuilt: int = 0
    """Number of cells, as large as possible, that an unfinished build has not reached; they may be empty."""

    def __len__(self) -> int:
        """Number of cells that are drawn from views."""
        return len(self.level)

    def parts(self) -> list[bool]:
        """Return for each view in `keys` whether only some of its splats are drawn."""
        counts = (self.directions >= 0).sum(axis=1)
        return list(np.repeat(self.partial, counts).tolist())

    def keys(self, in_picture: bool = False) -> list[tuple[int, Place, int]]:
        """Level, place, direction of each view, nearest cells first; `in_picture` omits cells outside the picture."""
        in_picture = check.flag("in_picture", in_picture)
        rows = zip(self.level.tolist(), self.place.tolist(), self.directions.tolist(), self.in_picture, strict=True)
        return [
            (level, (x, y, z), direction)
            for level, (x, y, z), directions, is_visible in rows
            if is_visible or not in_picture
            for direction in directions
            if direction >= 0
        ]

    def leaf_places(self, in_picture: bool = False) -> list[Place]:
        """Places of the leaves that are drawn as geometry; `in_picture` omits those outside the picture."""
        in_picture = check.flag("in_picture", in_picture)
        return places_of(self.leaves[self.leaf_in_picture] if in_picture else self.leaves)


class Cutter:
    """Cuts a tree; `read` is called for the cells of a subtree, by its tier and place, when they are needed.

    Tier k has the subtrees whose lowest level is k times the levels of a subtree.
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
        return self._layout.grid

    def knows(self, tier: int, place: Place) -> bool:
        """Whether the record of a subtree has been read."""
        return (tier, place) in self._known

    def with_guests(self, leaves: Sequence[Place]) -> list[Place]:
        """Return leaves and their guests: other leaves whose files have triangles that reach into them."""
        leaves_and_guests = [leaf for place in leaves for leaf in (place, *self._guests.get(place, []))]
        return list(dict.fromkeys(leaves_and_guests))

    def read_record(self, tier: int, place: Place) -> None:
        """Read the record of a subtree: its cells and their guests."""
        cells = self._read(tier, place)
        self._guests |= cells.guests  # before the cells, since other threads may cut meanwhile
        self._cells.add(tier, place, [mask.reshape(-1) for mask in cells.masks])
        self._known.add((tier, place))

    def rule(self, camera: Camera, settings: Settings) -> _core.OrthoRule:
        """Return the rule that sets the distance beyond which each level is drawn."""
        return _core.OrthoRule(
            camera._core,
            pitch=self._pitch,
            error=settings.error_px,
            band=BAND if settings.continuous else None,
            gaze=None if settings.gaze is None else (settings.gaze, ACUITY_SLOPE, ACUITY_LIMIT_DEG),
        )

    def cut(self, camera: Camera, settings: Settings, *, around: bool = False) -> OrthoCut:
        """Cut with the subtrees read so far; `around` includes cells outside the picture."""
        arguments = {
            "directions": self._layout.directions,
            "views": settings.views,
            "geometry": settings.geometry and self._layout.geometry,
            "around": around,
            "lift_deg": settings.lift_deg,
        }
        arrays, reach, unknown, unbuilt = self._cells.cut(camera._core, self.rule(camera, settings), arguments)
        return OrthoCut(
            **{name: arrays[name] for name in ("level", "place", "distance", "in_picture", "partial")},
            directions=np.ascontiguousarray(arrays["directions"][:, : settings.views]),
            leaves=arrays["leaf_place"],
            leaf_distance=arrays["leaf_distance"],
            leaf_in_picture=arrays["leaf_in_picture"],
            reach=reach,
            unknown=[(tier, (x, y, z)) for tier, (x, y, z) in unknown],
            unbuilt=unbuilt,
        )

    def complete_cut(self, camera: Camera, settings: Settings, *, around: bool = False) -> OrthoCut:
        """Read all subtrees that the cut needs, and return the cut."""
        while True:
            cut = self.cut(camera, settings, around=around)
            for tier, place in cut.unknown:
                self.read_record(tier, place)
            if not cut.unknown:
                return cut


def grid_of(samples: int) -> int:
    """Return the samples along each axis of a pixel; ValueError unless `samples` is a square of at most `MAX_GRID`²."""
    grid = math.isqrt(samples)
    if grid * grid != samples or grid > MAX_GRID:
        raise ValueError(f"samples: expected 1, 4, 9 … {MAX_GRID**2} for orthoviews, got {samples}")
    return grid


MAX_GRID = 8
"""Greatest number of samples along each axis of a pixel."""


Part = ViewKey
"""Level, place and direction of a view. With the direction `GEOMETRY` the part is the geometry of a leaf; with `RECORD`
it is the record of a subtree, and the first two fields are its tier and place."""

GEOMETRY, RECORD = -1, -2


def kind(part: Part) -> int:
    """Kind of a part: `GEOMETRY`, `RECORD`, or 0 for a view."""
    return min(part[2], 0)


def records_of(cut: OrthoCut) -> list[Part]:
    """Records of subtrees that a cut lacks."""
    return [(tier, place, RECORD) for tier, place in cut.unknown]


def leaf_parts(leaves: Sequence[Place], cutter: Cutter) -> list[Part]:
    """Geometry of leaves and of their guests (see `with_guests`), as parts."""
    return [(0, place, GEOMETRY) for place in cutter.with_guests(leaves)]
