"""10,000 cells of the whole of Tokyo: time of `Scene.query` against the triangles it returns, and against reading them.

Reading is a compiled loop in one thread that copies the indices and corners of the same triangles from the city's
arrays. Cells are in random order, so that no data of a cell is cached before it is read.
"""

from __future__ import annotations

import importlib
import itertools
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import trimesh
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness import scenes
from benchmarks.harness.report import save_figure, start, subplots, table
from benchmarks.harness.timing import best, timed
from benchmarks.harness.tokyo import with_buildings

SIDE = 100
"""Number of cells along each side of the city."""
ROUNDS = 3
"""Number of times that each cell is queried and read; the least time counts."""

Floats = NDArray[np.float32]
Faces = NDArray[np.uint32]


@dataclass(frozen=True)
class CellTimes:
    """Seconds of each cell's query and reading, and its number of triangles."""

    counts: NDArray[np.int64]
    query: NDArray[np.float64]
    read: NDArray[np.float64]


def main() -> None:
    options = start(__doc__, "--plots", side=(SIDE, "cells along each side of the city"))
    if (city := with_buildings()) is not None:
        whole_city(*city, side=options.side, plots=options.plots)
    centre()


def permutation(side: int) -> list[int]:
    return list(np.random.default_rng(1).permutation(side * side).tolist())


def cells_of(bounds: NDArray[np.float64], side: int) -> list[NDArray[np.float64]]:
    """Boxes (2, 3) of square cells, unbounded in height, in random order."""
    low, high = bounds[:, (0, 2)]
    width = (high - low) / side
    boxes = []
    for place in permutation(side):
        corner = low + width * (place % side, place // side)
        box = np.array([[-np.inf] * 3, [np.inf] * 3])
        box[0, (0, 2)], box[1, (0, 2)] = corner, corner + width
        boxes.append(box)
    return boxes


def whole_city(vertices: Floats, faces: Faces, building: NDArray[np.int32], *, side: int, plots: Path | None) -> None:
    """Measure all cells of the city, and peers on a few of them."""
    scene = nf.Scene.from_arrays(vertices, faces, building)
    _, tree = timed(scene.query, np.zeros((2, 3)))
    print(f"search tree, once: {tree.wall:.1f} s\n")
    boxes = cells_of(scene.bounds, side)
    listed = touching(scene.bounds, side, vertices, faces)
    measured = measure(scene, boxes, listed, vertices, faces)
    report(measured, scene.triangle_count)
    if plots is not None:
        draw(measured, plots / "source_query.png")
    median = int(np.argsort(measured.counts)[len(boxes) // 2])
    peers(scene, boxes[median], listed[median], vertices, faces, measured.counts[median])


def touching(bounds: NDArray[np.float64], side: int, vertices: Floats, faces: Faces) -> list[NDArray[np.int64]]:
    """Return for each cell, in the order of `cells_of`, the faces whose boxes touch it, which reading copies."""
    low, high = bounds[:, (0, 2)]
    corners = (vertices[:, (0, 2)] - low) * side / (high - low)
    places = np.clip(corners, 0, side - 1).astype(np.int16)[faces]
    first, last = places.min(axis=1), places.max(axis=1)
    spans = last - first + 1
    # A face touches as many cells as its box; most touch one.
    number = np.repeat(np.arange(len(faces)), spans.prod(axis=1, dtype=np.int64))
    step = np.arange(len(number)) - np.searchsorted(number, number)
    column, row = first[number].T + np.stack([step % spans[number, 0], step // spans[number, 0]])
    cell = row.astype(np.int64) * side + column
    order = np.argsort(cell, kind="stable")
    listed = np.split(number[order], np.cumsum(np.bincount(cell, minlength=side * side))[:-1])
    return [listed[place] for place in permutation(side)]


def reader() -> Callable[..., None]:
    """Compile a loop that copies triangles: their indices, and their corners."""
    numba = importlib.import_module("numba")

    def body(rows: Any, vertices: Any, faces: Any, indices: Any, corners: Any) -> None:
        for at in range(len(rows)):
            for corner in range(3):
                vertex = faces[rows[at], corner]
                indices[at, corner] = vertex
                for axis in range(3):
                    corners[at, corner, axis] = vertices[vertex, axis]

    compiled: Callable[..., None] = numba.njit(body)
    return compiled


def measure(
    scene: nf.Scene, boxes: list[NDArray[np.float64]], listed: list[NDArray[np.int64]], vertices: Floats, faces: Faces
) -> CellTimes:
    """Time each cell's query, and the reading of as many triangles from the same places."""
    read = reader()
    counts = np.zeros(len(boxes), np.int64)
    seconds = np.full((2, len(boxes)), np.inf)
    for _, (cell, box) in itertools.product(range(ROUNDS), enumerate(boxes)):
        part, spent = timed(scene.query, box)
        seconds[0, cell] = min(seconds[0, cell], spent.wall)
        counts[cell] = part.triangle_count
    greatest = max(map(len, listed))
    indices, corners = np.zeros((greatest, 3), np.uint32), np.zeros((greatest, 3, 3), np.float32)
    read(listed[0][:0], vertices, faces, indices, corners)
    for _, (cell, rows) in itertools.product(range(ROUNDS), enumerate(listed)):
        _, spent = timed(read, rows[: counts[cell]], vertices, faces, indices, corners)
        seconds[1, cell] = min(seconds[1, cell], spent.wall)
    return CellTimes(counts, *seconds)


def line(counts: NDArray[np.int64], seconds: NDArray[np.float64]) -> tuple[float, float, float]:
    """Fit seconds by a + b · triangles, weighted so that small cells count as much as large ones; a, b and R²."""
    slope, first = np.polyfit(counts, seconds, 1, w=1 / np.sqrt(np.maximum(counts, 100)))
    residual = seconds - (first + slope * counts)
    return float(first), float(slope), 1 - float(residual.var() / seconds.var())


def report(measured: CellTimes, triangles: int) -> None:
    rows = []
    for name, seconds in (("query", measured.query), ("reading", measured.read)):
        first, slope, explained = line(measured.counts, seconds)
        rows.append([name, first * 1e6, slope * 1e9, explained, seconds.sum()])
    title = f"{len(measured.counts):,} cells of {triangles:,} triangles, {measured.counts.sum():,} returned"
    print(table(title, " | µs a call {:.1f} | ns a triangle {:.1f} | R² {:.3f} | all cells, s {:.2f}", rows))
    rows = []
    for low, high in itertools.pairwise([0, 1, 100, 1000, 3000, 10_000, 30_000, 10**9]):
        in_range = (measured.counts >= low) & (measured.counts < high)
        if in_range.any():
            query, read = measured.query[in_range], measured.read[in_range]
            ratio = query.sum() / read.sum()
            rows.append([(low, high - 1), in_range.sum(), np.median(query) * 1e6, np.median(read) * 1e6, ratio])
    header = "triangles {:,} to {:,} | cells {:,} | query, µs {:.0f} | reading, µs {:.0f} | ratio of sums {:.2f}"
    print(table("Medians by size", header, rows))


def draw(measured: CellTimes, path: Path) -> None:
    figure, axes = subplots(figsize=(7, 4.5))
    filled = measured.counts > 0
    counts = measured.counts[filled]
    for name, seconds, color in (("query", measured.query, "#c8102e"), ("reading", measured.read, "#888888")):
        axes.scatter(counts, seconds[filled] * 1e6, s=3, color=color, alpha=0.3, linewidths=0)
        first, slope, _ = line(measured.counts, seconds)
        along = np.geomspace(1, counts.max(), 200)
        label = f"{name}: {first * 1e6:.0f} µs + {slope * 1e9:.0f} ns · triangles"
        axes.plot(along, (first + slope * along) * 1e6, color=color, label=label)
    axes.set(xscale="log", yscale="log", xlabel="triangles returned", ylabel="microseconds")
    axes.set_title(f"Scene.query, {len(measured.counts):,} cells of Tokyo")
    axes.grid(alpha=0.3)
    axes.legend()
    save_figure(figure, path)


def peers(
    scene: nf.Scene, box: NDArray[np.float64], rows: NDArray[np.int64], vertices: Floats, faces: Faces, count: int
) -> None:
    """Time other methods of finding the same triangles for a cell with the faces `rows`, `count` of which touch it."""

    def mask() -> NDArray[np.bool_]:
        corners = vertices[faces]
        return np.asarray(((corners.min(axis=1) <= box[1]) & (corners.max(axis=1) >= box[0])).all(axis=1))

    is_touching = mask()
    jobs: dict[str, Callable[[], Any]] = {
        "Scene.query": lambda: scene.query(box),
        "Scene.subset, mask at hand": lambda: scene.subset(triangles=is_touching),
        "NumPy: triangles gathered, numbers at hand": lambda: vertices[faces[rows]],
        "NumPy: mask of boxes, then gathered": lambda: vertices[faces[mask()]],
    }
    times = [(name, best(job, repeat=2).ms) for name, job in jobs.items()]
    print(table(f"One cell of the whole of Tokyo, {count:,} triangles", "way | ms {:,.3f}", times))


def centre() -> None:
    """Time trimesh's R-tree and our query on the centre of Tokyo; the city would need tens of gigabytes."""
    scene = scenes.load("Tokyo core")
    if scene is None:
        print(f"{scenes.FILES['Tokyo core']} is not there\n")
        return
    numbers = np.arange(3 * scene.triangle_count).reshape(-1, 3)
    mesh = trimesh.Trimesh(scene.triangles().reshape(-1, 3), numbers, process=False)
    boxes = cells_of(scene.bounds, 30)
    _, ours = timed(scene.query, np.zeros((2, 3)))
    tree, theirs = timed(lambda: mesh.triangles_tree)
    finite = [np.clip(box, -1e6, 1e6) for box in boxes]

    def by_trimesh() -> int:
        return sum(len(mesh.triangles[list(tree.intersection(box.ravel()))]) for box in finite)

    rows = [
        ["Scene.query", ours.wall, best(lambda: [scene.query(box) for box in boxes]).ms],
        ["trimesh with rtree, boxes only", theirs.wall, best(by_trimesh, repeat=2).ms],
    ]
    title = f"{len(boxes)} cells of the centre of Tokyo, {scene.triangle_count:,} triangles"
    print(table(title, " | tree, s {:.2f} | all cells, ms {:.1f}", rows))


if __name__ == "__main__":
    main()
