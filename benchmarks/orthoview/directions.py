"""Visible surface missing from all views, by set of directions; the selected set and the time of selection."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

import nearfar as nf
from benchmarks.harness import scenes
from benchmarks.harness.report import save_figure, start, subplots, table
from benchmarks.harness.timing import timed
from nearfar.orthoview._disocclusion import GOOD_DISOCCLUSION, Choice, choose_directions
from nearfar.orthoview._grid import COUNTS, Grid

STREET_ANGLE = 28.5
"""Angle in degrees about y that aligns Manhattan's avenues with an axis."""

ANGLES = (0.0, 15.0, 30.0, 45.0)
"""Angles in degrees between an axis and the streets of Manhattan."""


@dataclass(frozen=True)
class World:
    """A world, and its viewers."""

    name: str
    source: nf.SceneSource
    cell: float
    below: bool = False
    """Whether viewers also look up from below."""

    @property
    def label(self) -> str:
        """Name of the world and size of its leaf."""
        return f"{self.name}, {self.cell:g} m"


def main() -> None:
    plots = start(__doc__, "--plots").plots
    header = ["world, leaf", *(f"{count} {{:.1f}}" for count in COUNTS), "chosen", "leaves", "seconds {:.1f}"]
    header += ["CPU seconds {:.1f}"]
    rows: list[list[object]] = []
    choices = {world.label: measure(world, rows) for world in worlds()}
    print(table("Share of what viewers see that no view shows, %, by the number of directions", header, rows))
    rows = []
    by_angle = [measure(world, rows) for world in turned_worlds()]
    print(table("The same by the angle between Manhattan's streets and the axes", header, rows))
    if plots is not None:
        draw(choices, by_angle, plots / "orthoview-directions.png")
        print("![disocclusion by the number of directions](orthoview-directions.png)\n")


def worlds() -> Iterator[World]:
    """Yield cities with and without a street grid, wooded land, and bodies in space."""
    city = nf.datasets.city(blocks=12, detail=1)
    yield World("city, streets along the axes", city, 40.0)
    yield World("city, streets along the axes", city, 80.0)
    yield World("city, turned by 45°", rotate_about_y(city, 45.0), 80.0)
    for name, cells in {"Manhattan core": (125.0, 500.0), "Tokyo core": (125.0, 250.0, 500.0)}.items():
        for _, scene in scenes.present(name):
            yield from (World(name.removesuffix(" core"), scene, cell) for cell in cells)
    forest = nf.datasets.forest()
    yield World("forest", forest, 20.0)
    yield World("forest", forest, 80.0)
    asteroids = nf.datasets.asteroids().scene()
    yield World("asteroids", asteroids, 1000.0)
    yield World("asteroids, viewers below too", asteroids, 1000.0, below=True)


def turned_worlds() -> Iterator[World]:
    """Yield Manhattan at angles to the axes."""
    for _, scene in scenes.present("Manhattan core"):
        for angle in ANGLES:
            yield World(f"Manhattan, {angle:g}°", rotate_about_y(scene, STREET_ANGLE + angle), 250.0)


def rotate_about_y(scene: nf.Scene, degrees: float) -> nf.Scene:
    """Rotate the triangles of a scene about the y axis."""
    corners, (sine, cosine) = scene.triangles().reshape(-1, 3), np.sin(np.radians([degrees, degrees + 90]))
    matrix = np.array([[cosine, 0, -sine], [0, 1, 0], [sine, 0, cosine]], np.float32)
    return nf.Scene.from_arrays(corners @ matrix, np.arange(len(corners), dtype=np.uint32).reshape(-1, 3))


def measure(world: World, rows: list[list[object]]) -> Choice:
    """Choose directions for a world, and add a row to the table."""
    grid = Grid.from_bounds(world.source.bounds, world.cell)
    world.source.query(grid.box(0, (0, 0, 0)))  # makes the search tree of a scene in memory
    choice, time = timed(choose_directions, world.source, grid, below=world.below)
    shares = (100 * choice.shares[count] for count in COUNTS)
    rows.append([world.label, *shares, choice.count, choice.cells, time.wall, time.cpu])
    return choice


def draw(choices: Mapping[str, Choice], by_angle: Sequence[Choice], path: Path) -> None:
    """Draw the shares of all worlds by set, with a ring around the chosen set, and the shares of Manhattan by angle."""
    from matplotlib import colormaps

    figure, axes = subplots(1, 2, figsize=(12, 4.8), sharey=True, width_ratios=(2, 1))
    sets = range(len(COUNTS))
    for number, (name, choice) in enumerate(choices.items()):
        color = colormaps["tab20"](number)
        line(axes[0], sets, [choice.shares[count] for count in COUNTS], name, color)
        ring = COUNTS.index(choice.count), 100 * choice.shares[choice.count]
        axes[0].plot(*ring, "o", ms=10, mfc="none", color=color)
    axes[0].set_xticks(sets, COUNTS)
    axes[0].set(xlabel="directions; ○ chosen", ylabel="hidden, %", ylim=0)
    for number, count in enumerate(COUNTS):
        shares = [choice.shares[count] for choice in by_angle]
        line(axes[1], ANGLES[: len(shares)], shares, f"{count} directions", colormaps["viridis"](number / len(COUNTS)))
    axes[1].set(xticks=ANGLES, xlabel="degrees between Manhattan's streets and the axes")
    for axis in axes:
        axis.axhline(100 * GOOD_DISOCCLUSION, color="black", ls=":", lw=1)
        axis.grid(alpha=0.3)
        axis.legend(fontsize=7)
    save_figure(figure, path)


def line(axis: Any, x: Any, shares: list[float], label: str, color: Any) -> None:
    axis.plot(x, [100 * share for share in shares], marker=".", label=label, color=color)


if __name__ == "__main__":
    main()
