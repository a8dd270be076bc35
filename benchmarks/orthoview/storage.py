"""Storage: bytes of the geometry of leaves against bytes of their views, and the density at which both are equal."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness import scenes
from benchmarks.harness.report import save_figure, start, subplots, table
from benchmarks.orthoview._leaves import DIRECTIONS, SIZE, layout_of
from nearfar import _core
from nearfar._base import glb
from nearfar.orthoview import _codec
from nearfar.orthoview._geometry import cell_glb, step_of
from nearfar.orthoview._grid import Grid

LAYOUT = layout_of()
PLACE = (1, 1, 1)
"""Place of the leaf: in the middle of 3 × 3 × 3."""

SIDES = (125.0, 250.0, 500.0, 1000.0)
"""Sides of leaves in metres for which triangles per square kilometre are listed at equal bytes."""


@dataclass(frozen=True)
class Leaf:
    """Bytes of a leaf."""

    name: str
    side: float
    triangles: int
    geometry: int
    """Bytes of its GLB."""
    shared: int
    """Bytes of the GLB that are meshes with several placements."""
    merged: int
    """Bytes of its GLB if each placement had its own triangles."""
    views: int
    """Bytes of the chunks of its views."""

    @property
    def world(self) -> str:
        """World of the leaf."""
        return self.name.partition(",")[0]

    @property
    def row(self) -> list[object]:
        """Row of the table."""
        numbers = self.triangles, self.triangles / (self.side / 1000) ** 2, self.triangles / SIZE**2
        sizes = (count / 1000 for count in (self.geometry, self.shared, self.merged, self.views))
        return [self.name, *numbers, *sizes, self.merged / self.triangles, self.geometry / self.views]


def main() -> None:
    plots = start(__doc__, "--plots").plots
    leaves = [leaf for leaf in map(measure, worlds()) if leaf is not None]
    header = "leaf | triangles {:,} | a km² {:,.0f} | a pixel {:.3g} | geometry, kB {:,.1f} | shared meshes, kB {:,.1f}"
    header += " | merged, kB {:,.1f} | views, kB {:,.1f} | merged, bytes a triangle {:.1f} | geometry / views {:.3g}"
    print(table(f"Geometry and nine views of {SIZE}² pixels", header, [leaf.row for leaf in leaves]))
    worlds_of = dict.fromkeys(leaf.world for leaf in leaves)
    rows = [crossing_row(world, [leaf for leaf in leaves if leaf.world == world]) for world in worlds_of]
    columns = ["world", "triangles a leaf", "a pixel {:.2g}", *(f"a km², {side:g} m {{:,.0f}}" for side in SIDES)]
    print(table("Where merged geometry takes as much as views", columns, rows))
    if plots is not None:
        draw(leaves, plots / "orthoview_storage.png")


def worlds() -> Iterator[tuple[str, Any, float]]:
    for _, city in scenes.present("Tokyo core"):
        yield from (("Tokyo", city, side) for side in (125.0, 250.0, 500.0, 1000.0, 2000.0))
    town = nf.datasets.city(blocks=4)
    yield from (("city", town, side) for side in (10.0, 20.0, 40.0, 80.0))
    forest = nf.datasets.forest()
    yield from (("forest", forest, side) for side in (10.0, 20.0, 40.0, 80.0))
    yield from (("world", nf.datasets.world(km=10), side) for side in (62.5, 125.0, 250.0))
    # A belt whose bodies have 1,000 polygons, and finer ones.
    yield from (("asteroids", nf.datasets.asteroids(polygons=count), 1500.0) for count in (1_000, 10_000, 97_000))


def measure(case: tuple[str, Any, float]) -> Leaf | None:
    """Measure the bytes of the leaf in the middle of a world; None if it is empty."""
    name, world, side = case
    grid = Grid(corner_of(name, world, side), side, (3, 3, 3))
    part = world.query(grid.box(0, PLACE))
    geometry = cell_glb(part, grid, PLACE)
    if geometry is None:
        return None
    views = _core.OrthoViews.of_cell(part._core, (grid.corner(0, PLACE), side), DIRECTIONS, LAYOUT.format)
    chunks = sum(map(len, _codec.encode(views, LAYOUT).values()))
    merged = cell_glb(part._derived(part._core.of_mesh(part._core.merged()), part._load_placements[:0]), grid, PLACE)
    assert merged is not None
    triangles = glb.header(geometry)[0]["asset"]["extras"]["triangles"]
    sizes = len(geometry), shared_bytes(part, step_of(grid)), len(merged), chunks
    return Leaf(f"{name}, {side:g} m", side, triangles, *sizes)


def corner_of(name: str, world: Any, side: float) -> tuple[float, float, float]:
    """Least corner of a grid of three leaves along each axis, whose middle one contains the ground or a body."""
    if name == "asteroids":
        x, y, z = (world.centers[np.argmax(world.radii)] - 1.5 * side).tolist()
        return x, y, z
    x, _, z = (world.bounds.mean(axis=0) - 1.5 * side).tolist()
    if name == "world":
        x, z = x + 1000.0, z + 1000.0
    column = np.array([[x + side, -np.inf, z + side], [x + 2 * side, np.inf, z + 2 * side]])
    return x, float(np.floor(world.query(column).bounds[0, 1])) - side, z


def shared_bytes(part: nf.Scene, step: float) -> int:
    """Bytes of meshes with several placements in the GLB of a leaf."""
    images: list[str | None] = [None] * part._core.texture_count
    encoding = {"step": step, "compressed": True}
    export = _core.Export(part._core, np.zeros(1, np.uint16), 1, names=[], images=images, encoding=encoding)
    return sum(len(content) for content, _, _ in export.shared())


def crossing_row(world: str, leaves: list[Leaf]) -> list[object]:
    """Row of a world: where the ratio is 1, by linear interpolation or extrapolation of its leaves' logarithms."""
    ordered = sorted(leaves, key=lambda leaf: leaf.triangles)
    log_triangles = np.log([leaf.triangles for leaf in ordered])
    ratios = np.log([leaf.merged / leaf.views for leaf in ordered])
    changes = np.flatnonzero((ratios[:-1] < 0) & (ratios[1:] >= 0))
    left_index = int(changes[0]) if len(changes) else len(ordered) - 2
    slope = (ratios[left_index + 1] - ratios[left_index]) / (log_triangles[left_index + 1] - log_triangles[left_index])
    crossing = float(np.exp(log_triangles[left_index] - ratios[left_index] / slope))
    numbers = f"{crossing:,.0f}" + ("" if len(changes) else " (extrapolated)"), crossing / SIZE**2
    return [world, *numbers, *(crossing / (side / 1000) ** 2 for side in SIDES)]


def draw(all_leaves: list[Leaf], path: Path) -> None:
    figure, axes = subplots(figsize=(7.5, 4.8))
    for number, world in enumerate(dict.fromkeys(leaf.world for leaf in all_leaves)):
        leaves = [leaf for leaf in all_leaves if leaf.world == world]
        density: NDArray[np.float64] = np.array([leaf.triangles for leaf in leaves]) / SIZE**2
        for name, marker, style in (("merged", "o", "-"), ("geometry", "s", ":"), ("views", "x", "--")):
            values = [getattr(leaf, name) / 1000 for leaf in leaves]
            axes.plot(density, values, color=f"C{number}", marker=marker, linestyle=style, label=f"{world}, {name}")
    axes.set(xscale="log", yscale="log", xlabel=f"triangles a pixel of a view ({SIZE}²)", ylabel="kB a leaf")
    axes.legend(fontsize="x-small", ncols=2)
    save_figure(figure, path)


if __name__ == "__main__":
    main()
