"""Worlds for pictures, their trees, and the viewpoints."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness.views import distances_around
from benchmarks.orthoview.worlds import open_tokyo
from nearfar.orthoview import _store
from nearfar.orthoview._cut import Cutter
from nearfar.orthoview._grid import Place, directions_of
from nearfar.orthoview._viewer import Viewer

SIZE = 256
"""Width and height of a view in pixels."""
ALL = 26
"""Number of directions of the built trees; smaller sets are its first ones."""
FOV = nf.Fov.symmetric(60, 4 / 3)
PICTURE = (640, 480)
EYE_HEIGHT = 1.7
GROUND = ("ground", "land")
"""Prefixes of the names of objects that serve as ground."""
RING = 48
"""Number of horizontal directions in which walkers look."""

LANDSCAPE_ERROR = 3.0
"""Maximum geometric error of the landscape, metres."""

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class World:
    """A square of a world with corners at multiples of a leaf's side."""

    name: str
    source: Callable[[Floats], nf.Scene]
    """Function that returns the geometry in a box."""
    low: tuple[float, float, float]
    side: float
    height: float
    cell: float

    @cached_property
    def box(self) -> Floats:
        """Box of the square (2, 3), a millimetre short, so that it touches no leaf beyond its last one."""
        return np.array([self.low, np.add(self.low, [self.side - 1e-3, self.height, self.side - 1e-3])])

    @cached_property
    def scene(self) -> nf.Scene:
        """All geometry in the square."""
        return self.source(self.box)

    def camera(self, eye: Floats, target: Floats) -> nf.Camera:
        return nf.Camera.look_at(eye, target, fov=FOV, size=PICTURE)

    def from_air(self) -> list[nf.Camera]:
        """One camera beside the square looks across it, one at a corner looks down on it."""
        points = self.side * np.array([(0.5, 0.25, -0.15), (0.55, 0.0, 0.6), (0.0, 0.45, 0.0), (0.5, 0.0, 0.5)])
        points[::2, 1] = np.maximum(points[::2, 1], 0.6 * self.height)
        points += self.box[0]
        return [self.camera(points[0], points[1]), self.camera(points[2], points[3])]

    def from_ground(self, count: int = 2) -> list[nf.Camera]:
        """Cameras of walkers under the sky, far from what they look at, and from one another."""
        axis = np.linspace(0.2, 0.8, 41) * self.side
        x, z = np.stack(np.meshgrid(axis, axis), axis=-1).reshape(-1, 2).T
        start = self.box[0] + np.column_stack([x, np.full(len(x), self.height), z])
        down = nf.cast_rays(self.scene, start, np.tile([0.0, -1.0, 0.0], (len(x), 1)))
        land = np.array([name.split("_")[0] in GROUND for name in self.scene.object_names])
        is_ground = land[np.maximum(down.object_id, 0)] & np.isfinite(down.t_hit)
        eyes = start[is_ground] - (down.t_hit[is_ground] - EYE_HEIGHT)[:, None] * np.array([0.0, 1.0, 0.0])
        ring, free = distances_around(self.scene, eyes, RING)
        sights = np.where(np.isfinite(free) & (free.min(axis=1) > 2.0)[:, None], free, 0.0)
        cameras: list[nf.Camera] = []
        for n in np.argsort(-sights.max(axis=1)):
            if all(np.linalg.norm(eyes[n] - camera.position) > self.side / 5 for camera in cameras):
                cameras.append(self.camera(eyes[n], eyes[n] + ring[sights[n].argmax()]))
            if len(cameras) == count:
                break
        return cameras

    def build(self, folder: Path, directions: int = ALL, **settings: Any) -> Path:
        """Build the tree, unless the folder contains it; return its path."""
        path = folder / f"{self.name.replace(' ', '-')}-{directions}.zarr"
        settings |= {"aabb": self.box, "size": SIZE, "directions": directions}
        nf.orthoview.build(self.scene, path, cell=self.cell, **settings)
        return path


def open_tree(path: Path, directions: int) -> nf.orthoview.OrthoTree:
    """Open a tree as if built with fewer directions: views do not depend on others."""
    tree = nf.orthoview.open(path)
    layout = tree._layout
    tree._layout = replace(layout, directions=directions_of(directions))
    _, read = _store.open_generation(tree._files, layout, tree.generation)

    def fewer(tier: int, place: Place) -> _store.Cells:
        cells = read(tier, place)
        return replace(cells, masks=[mask & np.uint32((1 << directions) - 1) for mask in cells.masks])

    viewer = tree._viewer
    tree.__dict__["_viewer"] = Viewer(Cutter(tree._layout, fewer), viewer.views, viewer.near)
    return tree


def tokyo(tiles: str | None) -> World:
    """1.5 km around Shimbashi from `tiles`, or from the core's file if None, with a ground, which the data lack."""
    source = open_tokyo(tiles)
    x, z = (-1750.0, 1000.0) if tiles else (-1500.0, 0.0)

    def part(box: Floats) -> nf.Scene:
        houses, ground = source.query(box).triangles().reshape(-1, 3), _ground(box)
        corners = np.concatenate([houses, ground]).astype(np.float32)
        faces = np.arange(len(corners), dtype=np.uint32).reshape(-1, 3)
        numbers = np.repeat([0, 1], [len(houses) // 3, len(ground) // 3])
        return nf.Scene.from_arrays(corners, faces, numbers, object_names=("houses", GROUND[0]))

    return World("Tokyo", part, (x, -1.0, z), 1500.0, 350.0, 125.0)


def _ground(box: Floats, step: float = 125.0, y: float = -0.5) -> Floats:
    """Corners of triangles half a metre below 0, in squares."""
    x, z = (np.arange(box[0, axis], box[1, axis], step) for axis in (0, 2))
    corners = np.stack(np.meshgrid(x, z), axis=-1).reshape(-1, 1, 2)
    offsets = step * np.array([(0, 0), (0, 1), (1, 1), (0, 0), (1, 1), (1, 0)])
    flat = (corners + offsets).reshape(-1, 2)
    return np.column_stack([flat[:, 0], np.full(len(flat), y), flat[:, 1]])


def forest() -> World:
    """160 m of woods around a trail."""
    return World("forest", nf.datasets.forest().query, (-80.0, -16.0, -80.0), 160.0, 64.0, 20.0)


def landscape() -> World:
    """A square kilometre of wooded hills with fields, roads and hamlets, 100 m from the lowest to the highest place."""
    hills = nf.datasets.world()

    def part(box: Floats) -> nf.Scene:
        return hills.query(box, detail=LANDSCAPE_ERROR)

    return World("landscape", part, (-4000.0, 20.0, -4000.0), 1000.0, 120.0, 125.0)
