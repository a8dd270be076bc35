"""The second layer of views: its cost, and the share of viewers' pixels that it fills."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness import scenes
from benchmarks.harness.report import start, table
from benchmarks.harness.timing import best
from benchmarks.orthoview._leaves import DIRECTIONS, SIZE, axes_of, copy_without_trees, layout_of
from benchmarks.orthoview._quality import shown_by
from nearfar import _core
from nearfar.orthoview import _codec
from nearfar.orthoview._disocclusion import nearest
from nearfar.orthoview._grid import OCTANTS, directions_of

LAYOUT = layout_of()
MORE_DIRECTIONS = directions_of(13)
"""Directions with which a second layer is compared; they begin with `DIRECTIONS`."""
AXES = [axes_of(direction, 1.0) for direction in MORE_DIRECTIONS]
UNITS = np.array([axes[2] for axes, _ in AXES])
BOUNDS = (0.0, 0.002, 0.005, 0.01, 0.02, 0.05)
VIEWERS = 8

Floats = NDArray[np.float64]
Bools = NDArray[np.bool_]
Children = list[tuple[tuple[int, int, int], _core.OrthoViews]]


@dataclass(frozen=True)
class Cell:
    """A leaf, or a cell composed of leaves."""

    name: str
    scene: nf.Scene
    corner: Floats
    side: float
    levels: int = 0
    """Number of levels of cells below."""

    def part(self) -> nf.Scene:
        """Query the geometry that touches the cell."""
        return self.scene.query(np.array([self.corner, self.corner + self.side]))

    def children(self) -> Iterator[tuple[tuple[int, int, int], Cell]]:
        """Yield the cells of half the side, with their places."""
        half_side = self.side / 2
        for octant in OCTANTS:
            yield octant, Cell("", self.scene, self.corner + np.array(octant) * half_side, half_side, self.levels - 1)


@dataclass(frozen=True)
class Gain:
    """Cost and use of second layers for a cell; arrays are by direction."""

    unseen: Floats
    first_bytes: Floats
    second_bytes: Floats
    hidden: float
    """Share of viewers' pixels that no view's first layer shows."""
    still_hidden: float
    """Share that is still hidden with second layers."""
    hidden_with_more: float
    """Share that no view's first layer shows with `MORE_DIRECTIONS`."""
    filled: Floats
    """Share shown by each direction's second layer."""


def main() -> None:
    start(__doc__)
    rows, gains = [], []
    for cell in cells():
        ratio, gain = time_ratio(cell), measure_gain(cell)
        gains.append(gain)
        kilobytes = (each.sum() / len(DIRECTIONS) / 1e3 for each in (gain.first_bytes, gain.second_bytes))
        shares = gain.hidden, gain.still_hidden, gain.hidden_with_more, gain.unseen.mean()
        rows.append([cell.name, ratio, *kilobytes, *(100 * share for share in shares)])
    header = "cell | build time, × {:.1f} | kB a view {:.1f} | kB a second layer {:.1f} | hidden, % {:.2f}"
    header += " | still hidden, % {:.2f} | 13 directions, % {:.2f} | unseen, % {:.2f}"
    print(table(f"Nine views of {SIZE}² pixels", header, rows))
    header = "kept where unseen exceeds {:g} | directions, % {:.0f} | bytes, % of first layers' {:.0f}"
    header += " | of filled pixels, % {:.0f}"
    unseen, first, second, filled = (
        np.array([getattr(gain, name) for gain in gains])
        for name in ("unseen", "first_bytes", "second_bytes", "filled")
    )
    rows = []
    for bound in BOUNDS:
        is_kept = unseen > bound
        fractions = is_kept.mean(), second[is_kept].sum() / first.sum(), filled[is_kept].sum() / filled.sum()
        rows.append([bound, *(100 * fraction for fraction in fractions)])
    print(table("Second layers that are kept", header, rows))


def cells() -> Iterator[Cell]:
    city = nf.datasets.city(blocks=4)
    for x, z in ((-40, -40), (-40, -80), (40, 40)):
        yield Cell(f"city, 40 m at {x}, {z}", city, np.array([x, -2.1, z]), 40.0)
    yield Cell("city, 160 m", city, np.array([-160, -2.1, -160]), 160.0)
    yield Cell("city, 80 m of leaves of 40 m", city, np.array([-80, -2.1, -80]), 80.0, 1)
    forest = nf.datasets.forest()
    yield Cell("forest, 20 m", forest, np.array([0.0, -10.0, 0.0]), 20.0)
    yield Cell("forest, 40 m of leaves of 20 m", forest, np.array([0.0, -10.0, 0.0]), 40.0, 1)
    yield Cell("forest, 80 m", forest, np.array([-40.0, -14.0, -40.0]), 80.0)
    for _, tokyo in scenes.present("Tokyo core"):
        (x, _, z), y = tokyo.bounds.mean(axis=0), np.floor(tokyo.bounds[0, 1])
        for east, south in ((-250, -250), (250, -250)):
            yield Cell(f"Tokyo, 500 m at {east}, {south}", tokyo, np.array([x + east, y, z + south]), 500.0)
        yield Cell("Tokyo, 2000 m", tokyo, np.array([x - 1000, y, z - 1000]), 2000.0)
        yield Cell("Tokyo, 1000 m of leaves of 500 m", tokyo, np.array([x - 500, y, z - 500]), 1000.0, 1)


def render_cell(cell: Cell, *, behind: bool, count: int = len(DIRECTIONS)) -> _core.OrthoViews:
    if cell.levels:
        children = [(octant, render_cell(child, behind=behind, count=count)) for octant, child in cell.children()]
        return compose(children, behind=behind, count=count)
    return leaf(cell.part()._core, cell, behind=behind, count=count)


def leaf(scene: _core.Scene, cell: Cell, *, behind: bool, count: int = len(DIRECTIONS)) -> _core.OrthoViews:
    corner_and_side = (cell.corner.tolist(), cell.side)
    return _core.OrthoViews.of_cell(scene, corner_and_side, MORE_DIRECTIONS[:count], LAYOUT.format, behind=behind)


def compose(children: Children, *, behind: bool, count: int = len(DIRECTIONS)) -> _core.OrthoViews:
    parent = _core.OrthoParent(MORE_DIRECTIONS[:count], LAYOUT.format, behind=behind)
    for octant, views in children:
        parent.add(octant, views)
    return parent.finish()


def time_ratio(cell: Cell) -> float:
    """Ratio of the times to draw a leaf, or to compose a cell, with and without second layers."""
    alone, layered = (best(fresh_job(cell, behind=behind), repeat=1).wall for behind in (False, True))
    return layered / alone


def fresh_job(cell: Cell, *, behind: bool) -> Callable[[], object]:
    """Return a job that twice composes a cell from its children, or draws a leaf from a scene without search trees."""
    if cell.levels:
        children = [(octant, render_cell(child, behind=behind)) for octant, child in cell.children()]
        return lambda: compose(children, behind=behind)
    scenes = [copy_without_trees(cell.part())._core for _ in range(2)]
    return lambda: leaf(scenes.pop(), cell, behind=behind)


def measure_gain(cell: Cell) -> Gain:
    views = render_cell(cell, behind=True)
    second = views.second_layer()
    firsts = render_cell(cell, behind=False, count=len(MORE_DIRECTIONS)).depths()[..., 0]
    seconds = np.zeros_like(firsts) if second is None else second.depths()[..., 0]
    rng, part, filled = np.random.default_rng(1), cell.part(), np.zeros(len(DIRECTIONS))
    total, hidden, hidden_by_both, with_more = 0, 0, 0, 0
    for _ in range(VIEWERS):
        toward = rng.normal(size=3)
        toward[1] = abs(toward[1])
        toward /= np.linalg.norm(toward)
        points = visible_points(part, cell, toward)
        drawn = nearest(UNITS[: len(DIRECTIONS)], toward)
        lost = lost_points(points, firsts, drawn, cell)
        shown_by_direction = {n: shows(seconds[n], n, lost, cell) for n in drawn}
        for n, shown in shown_by_direction.items():
            filled[n] += shown.sum()
        total, hidden = total + len(points), hidden + len(lost)
        hidden_by_both += (~np.any([*shown_by_direction.values()], axis=0)).sum()
        with_more += len(lost_points(points, firsts, nearest(UNITS, toward), cell))
    return Gain(
        np.array(views.unseen()),
        chunk_bytes(views),
        chunk_bytes(second),
        hidden / total,
        hidden_by_both / total,
        with_more / total,
        filled / total,
    )


def lost_points(points: Floats, firsts: NDArray[np.uint16], directions: list[int], cell: Cell) -> Floats:
    return np.asarray(points[~np.any([shows(firsts[n], n, points, cell) for n in directions], axis=0)])


def chunk_bytes(views: _core.OrthoViews | None) -> Floats:
    chunks = {} if views is None else _codec.encode(views, LAYOUT)
    return np.array([len(chunks.get(number, b"")) for number in range(len(DIRECTIONS))], np.float64)


def visible_points(scene: nf.Scene, cell: Cell, toward: Floats) -> Floats:
    """Return a point per pixel of the front faces that are visible when only this cell is drawn."""
    up, center = (0.0, 1.0, 0.0), cell.corner + cell.side / 2
    right = np.cross(up, toward)
    right /= np.linalg.norm(right)
    x, y = (np.abs(axis).sum() * cell.side / 2 for axis in (right, np.cross(toward, right)))
    fov = nf.Orthographic(-x, x, -y, y)
    camera = nf.Camera.look_at(center + 2 * cell.side * toward, center, up=up, fov=fov, size=(SIZE, SIZE))
    clip = nf.Clip(box=np.array([cell.corner, cell.corner + cell.side]))
    frame = nf.render(scene, camera, clip=clip, channels=("face_id", "position"), backend="cpu")
    faces = frame.require("face_id")
    a, b, c = np.moveaxis(scene.triangles()[faces[faces >= 0]].astype(np.float64), 1, 0)
    is_front = np.cross(b - a, c - a) @ toward > 0
    return np.asarray((frame.require("position")[faces >= 0] + np.array(frame.origin))[is_front])


def shows(codes: NDArray[np.uint16], direction: int, points: Floats, cell: Cell) -> Bools:
    """Whether one of the 3 × 3 pixels around each point has about the point's depth (see `shown_by`)."""
    axes, extents = AXES[direction]
    extents = extents * cell.side
    metres = np.where(codes > 0, (codes - 0.5) * extents[2] / LAYOUT.steps, np.inf)
    return shown_by(points, axes, extents, cell.corner + cell.side / 2, metres)


if __name__ == "__main__":
    main()
