"""Leaves drawn by the benchmarks of stored views: boxes, vertex colours, foliage, and photographed textures."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness import scenes
from nearfar import _core
from nearfar.orthoview._grid import Grid, directions_of
from nearfar.orthoview._layout import Layout

SIZE = 256
DIRECTIONS = directions_of(9)


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


def axes_of(direction: tuple[int, int, int], side: float) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Unit vectors to the right, upwards and to the viewer (3, 3) of a view of a cell, and the extents along them."""
    axes, extents = (np.array(values) for values in _core.orthoview_axes(direction))
    return axes, extents * side


def metres_of(
    views: _core.OrthoViews, number: int, layout: Layout, side: float, empty: float = np.inf
) -> NDArray[np.float64]:
    """Distances (H, W) in metres of one view's pixels behind the front of their cell; `empty` for empty pixels."""
    codes = views.depths()[number, ..., 0].astype(float)
    _, extents = axes_of(layout.directions[number], side)
    return np.where(codes > 0, (codes - 0.5) * extents[2] / layout.steps, empty)


def layout_of(depth_bits: int = 12, normal_bits: int = 16) -> Layout:
    return Layout(Grid((0.0, 0.0, 0.0), 1.0, (1, 1, 1)), DIRECTIONS, SIZE, depth_bits, normal_bits, 3)


def copy_without_trees(scene: nf.Scene) -> nf.Scene:
    return scene.subset(triangles=np.ones(scene.triangle_count, bool))


def leaves() -> Iterator[Leaf]:
    """Yield leaves of the test data, if they exist, and of procedural scenes."""
    for _, city in scenes.present("Tokyo core"):
        yield from (in_the_middle(f"Tokyo, {side:g} m", city, side) for side in (250.0, 500.0))
    yield in_the_middle("city, 80 m", nf.datasets.city(blocks=6), 80.0)
    forest = nf.datasets.forest()
    yield from (in_the_middle(f"forest, {side:g} m", forest, side) for side in (20.0, 80.0))


def in_the_middle(name: str, scene: nf.Scene, side: float) -> Leaf:
    """Return the leaf on the ground in the middle of a scene."""
    x, _, z = (scene.bounds.mean(axis=0) - side / 2).tolist()
    corner = (x, float(np.floor(scene.bounds[0, 1])), z)
    return Leaf(name, scene.query(np.array([corner, np.add(corner, side)])), corner, side)


def helmet() -> Leaf | None:
    """Return a whole model with photographed textures; None without the test data."""
    scene, side = scenes.load("FlightHelmet"), 0.75
    if scene is None:
        return None
    x, y, z = (scene.bounds.mean(axis=0) - side / 2).tolist()
    return Leaf(f"helmet, {side:g} m", scene, (x, y, z), side)
