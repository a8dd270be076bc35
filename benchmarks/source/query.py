"""10,000 cells of the whole of Tokyo: time of `Scene.query` against the triangles it returns, and against reading them.

Reading is a compiled loop that copies the same triangles, indices and corners, from their places in the city's arrays,
in one thread. Cells come in random order, so that no data of a cell is cached before it is read.
"""

from __future__ import annotations

import argparse
import importlib
import itertools
import os
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import trimesh
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness.compare import FOLDER
from benchmarks.harness.timing import best, machine, table
from benchmarks.harness.tokyo import with_buildings
from nearfar._base import data

SIDE = 100
"""Number of cells along each side of the city."""
ROUNDS = 3
"""Number of times that each cell is queried and read; the least time counts."""
CORE = "city/tokyo23/tokyo_core_lod1.glb"


@dataclass(frozen=True)
class Measured:
    """Seconds of each cell, and its numbers of triangles."""

    counts: NDArray[np.int64]
    query: NDArray[np.float64]
    read: NDArray[np.float64]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--side", type=int, default=SIDE, help="cells along each side of the city")
    side = parser.parse_args().side
    print(machine(), "\n")
    if (city := with_buildings()) is not None:
        whole_city(*city, side=side)
    centre()


def permutation(side: int) -> list[int]:
    """Numbers of cells in random order."""
    order: list[int] = np.random.default_rng(1).permutation(side * side).tolist()
    return order


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


def whole_city(
    vertices: NDArray[np.float32], faces: NDArray[np.uint32], building: NDArray[np.int32], *, side: int
) -> None:
    """Measure all cells of the city, and peers on a few of them."""
    scene = nf.Scene.from_arrays(vertices, faces, building)
    started = time.perf_counter()
    scene.query(np.zeros((2, 3)))
    print(f"search tree, once: {time.perf_counter() - started:.1f} s\n")
    boxes = cells_of(scene.bounds, side)
    listed = touching(scene.bounds, side, vertices, faces)
    measured = measure(scene, boxes, listed, vertices, faces)
    report(measured, scene.triangle_count)
    peers(scene, boxes, measured, listed, vertices, faces)


def touching(
    bounds: NDArray[np.float64], side: int, vertices: NDArray[np.float32], faces: NDArray[np.uint32]
) -> list[NDArray[np.int64]]:
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
    scene: nf.Scene,
    boxes: list[NDArray[np.float64]],
    listed: list[NDArray[np.int64]],
    vertices: NDArray[np.float32],
    faces: NDArray[np.uint32],
) -> Measured:
    """Time each cell's query, and the reading of as many triangles from the same places."""
    read = reader()
    counts = np.zeros(len(boxes), np.int64)
    seconds = np.full((2, len(boxes)), np.inf)
    for _ in range(ROUNDS):
        for at, box in enumerate(boxes):
            started = time.perf_counter()
            part = scene.query(box)
            seconds[0, at] = min(seconds[0, at], time.perf_counter() - started)
            counts[at] = part.triangle_count
    most = max(map(len, listed))
    indices, corners = np.zeros((most, 3), np.uint32), np.zeros((most, 3, 3), np.float32)
    read(listed[0][:0], vertices, faces, indices, corners)
    for _ in range(ROUNDS):
        for at, rows in enumerate(listed):
            chosen = rows[: counts[at]]
            started = time.perf_counter()
            read(chosen, vertices, faces, indices, corners)
            seconds[1, at] = min(seconds[1, at], time.perf_counter() - started)
    return Measured(counts, *seconds)


def line(counts: NDArray[np.int64], seconds: NDArray[np.float64]) -> tuple[float, float, float]:
    """Fit seconds by a + b · triangles, weighted so that small cells count as much as large ones; a, b and R²."""
    weights = 1 / np.sqrt(np.maximum(counts, 100))
    columns = np.column_stack([np.ones(len(counts)), counts])
    (start, slope), *_ = np.linalg.lstsq(columns * weights[:, None], seconds * weights, rcond=None)
    left = seconds - columns @ (start, slope)
    return float(start), float(slope), 1 - float(left.var() / seconds.var())


def report(measured: Measured, triangles: int) -> None:
    """Print the fits and the ratio by size, and save the plot."""
    rows = []
    for name, seconds in (("query", measured.query), ("reading", measured.read)):
        start, slope, explained = line(measured.counts, seconds)
        rows.append([name, f"{start * 1e6:.1f}", f"{slope * 1e9:.1f}", f"{explained:.3f}", f"{seconds.sum():.2f}"])
    title = f"{len(measured.counts):,} cells of {triangles:,} triangles, {measured.counts.sum():,} returned"
    print(table(title, ["", "µs a call", "ns a triangle", "R²", "all cells, s"], rows))
    rows = []
    edges = [0, 1, 100, 1000, 3000, 10_000, 30_000, 10**9]
    for low, high in itertools.pairwise(edges):
        here = (measured.counts >= low) & (measured.counts < high)
        if here.any():
            query, read = np.median(measured.query[here]), np.median(measured.read[here])
            rows.append([f"{low:,} to {high - 1:,}", f"{here.sum():,}", f"{query * 1e6:.0f}", f"{read * 1e6:.0f}",
                         f"{measured.query[here].sum() / measured.read[here].sum():.2f}"])  # fmt: skip
    print(table("Medians by size", ["triangles", "cells", "query, µs", "reading, µs", "ratio of sums"], rows))
    draw(measured)


def draw(measured: Measured) -> None:
    folder = os.environ.get(FOLDER)
    if not folder:
        return
    import matplotlib as mpl

    mpl.use("Agg")
    from matplotlib import pyplot as plt

    figure, axes = plt.subplots(figsize=(7, 4.5), layout="constrained")
    some = measured.counts > 0
    counts = measured.counts[some]
    for name, seconds, color in (("query", measured.query, "#c8102e"), ("reading", measured.read, "#888888")):
        axes.scatter(counts, seconds[some] * 1e6, s=3, color=color, alpha=0.3, linewidths=0)
        start, slope, _ = line(measured.counts, seconds)
        along = np.geomspace(1, counts.max(), 200)
        label = f"{name}: {start * 1e6:.0f} µs + {slope * 1e9:.0f} ns · triangles"
        axes.plot(along, (start + slope * along) * 1e6, color=color, label=label)
    axes.set(xscale="log", yscale="log", xlabel="triangles returned", ylabel="microseconds")
    axes.set_title(f"Scene.query, {len(measured.counts):,} cells of Tokyo")
    axes.grid(alpha=0.3)
    axes.legend()
    figure.savefig(Path(folder) / "source_query.png", dpi=100)
    plt.close(figure)


def peers(
    scene: nf.Scene,
    boxes: list[NDArray[np.float64]],
    measured: Measured,
    listed: list[NDArray[np.int64]],
    vertices: NDArray[np.float32],
    faces: NDArray[np.uint32],
) -> None:
    """Time other methods of finding the same triangles for the cell with the median number of them."""
    at = int(np.argsort(measured.counts)[len(boxes) // 2])
    box = boxes[at]

    def mask() -> NDArray[np.bool_]:
        corners = vertices[faces]
        touches: NDArray[np.bool_] = ((corners.min(axis=1) <= box[1]) & (corners.max(axis=1) >= box[0])).all(axis=1)
        return touches

    chosen = mask()
    jobs: dict[str, Callable[[], Any]] = {
        "Scene.query": lambda: scene.query(box),
        "Scene.subset, mask at hand": lambda: scene.subset(triangles=chosen),
        "NumPy: triangles gathered, numbers at hand": lambda: vertices[faces[listed[at]]],
        "NumPy: mask of boxes, then gathered": lambda: vertices[faces[mask()]],
    }
    rows = [[name, f"{best(job, repeat=2).wall * 1e3:,.3f}"] for name, job in jobs.items()]
    title = f"One cell of the whole of Tokyo, {measured.counts[at]:,} triangles"
    print(table(title, ["way", "ms"], rows))


def centre() -> None:
    """Time trimesh's R-tree and our query on the centre of Tokyo; the city would need tens of gigabytes."""
    path = data.find(CORE)
    if path is None:
        print(f"{CORE} is not there\n")
        return
    scene = nf.Scene.load(path)
    mesh = trimesh.Trimesh(scene.triangles().reshape(-1, 3), np.arange(3 * scene.triangle_count).reshape(-1, 3),
                           process=False)  # fmt: skip
    boxes = cells_of(scene.bounds, 30)
    started = time.perf_counter()
    scene.query(np.zeros((2, 3)))
    ours = time.perf_counter() - started
    started = time.perf_counter()
    tree = mesh.triangles_tree
    theirs = time.perf_counter() - started
    finite = [np.clip(box, -1e6, 1e6) for box in boxes]

    def by_trimesh() -> int:
        return sum(len(mesh.triangles[list(tree.intersection(box.ravel()))]) for box in finite)

    rows = [
        ["Scene.query", f"{ours:.2f}", f"{best(lambda: [scene.query(box) for box in boxes]).wall * 1e3:.1f}"],
        ["trimesh with rtree, boxes only", f"{theirs:.2f}", f"{best(by_trimesh, repeat=2).wall * 1e3:.1f}"],
    ]
    title = f"{len(boxes)} cells of the centre of Tokyo, {scene.triangle_count:,} triangles"
    print(table(title, ["", "tree, s", "all cells, ms"], rows))


if __name__ == "__main__":
    main()
