"""Leaves drawn by the benchmarks of stored views: boxes, vertex colours, foliage, and photographed textures."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.orthoview.views import TOKYO
from nearfar import _core
from nearfar._base import data
from nearfar.orthoview._directions import directions_of
from nearfar.orthoview._grid import Grid
from nearfar.orthoview._layout import Layout

SIZE = 256
DIRECTIONS = directions_of(9)
HELMET = "objects/gltf/FlightHelmet/FlightHelmet.gltf"


@dataclass(frozen=True)
class Leaf:
    """A cubic cell and the geometry that touches it."""

    name: str
    scene: nf.Scene
    corner: tuple[float, float, float]
    side: float

    def views(self, layout: Layout) -> _core.OrthoViews:
        return _core.OrthoViews.of_cell(self.scene._core, (self.corner, self.side), layout.directions, layout.format)

    @property
    def box(self) -> NDArray[np.float64]:
        return np.array([self.corner, np.add(self.corner, self.side)])


def layout_of(depth_bits: int = 12, normal_bits: int = 16, size: int = SIZE) -> Layout:
    return Layout(Grid((0.0, 0.0, 0.0), 1.0, (1, 1, 1)), DIRECTIONS, size, depth_bits, normal_bits, 3)


def leaves() -> Iterator[Leaf]:
    """Yield leaves of the test data, if they exist, and of procedural scenes."""
    if (path := data.find(TOKYO)) is not None:
        city = nf.Scene.load(path)
        for side in (250.0, 500.0):
            yield in_the_middle(f"Tokyo, {side:g} m", city, side)
    yield in_the_middle("city, 80 m", nf.datasets.city(blocks=6), 80.0)
    forest = nf.datasets.forest()
    for side in (20.0, 80.0):
        yield in_the_middle(f"forest, {side:g} m", forest, side)


def in_the_middle(name: str, scene: nf.Scene, side: float) -> Leaf:
    """Return the leaf on the ground in the middle of a scene."""
    x, _, z = (scene.bounds.mean(axis=0) - side / 2).tolist()
    corner = (x, float(np.floor(scene.bounds[0, 1])), z)
    return Leaf(name, scene.query(np.array([corner, np.add(corner, side)])), corner, side)


def helmet() -> Leaf | None:
    """Return a whole model with photographed textures; None without the test data."""
    if (path := data.find(HELMET)) is None:
        return None
    scene, side = nf.Scene.load(path), 0.75
    x, y, z = (scene.bounds.mean(axis=0) - side / 2).tolist()
    return Leaf(f"helmet, {side:g} m", scene, (x, y, z), side)
