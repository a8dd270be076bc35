"""Views of leaves and parents: rasterised triangles against rays, and against Embree's rays without shading."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator

import numpy as np
import trimesh

import nearfar as nf
from benchmarks.harness import scenes
from benchmarks.harness.report import start, table
from benchmarks.harness.timing import best
from benchmarks.orthoview._leaves import DIRECTIONS, SIZE, Leaf, axes_of, copy_without_trees, in_the_middle, layout_of
from nearfar import _core
from nearfar.orthoview import _codec
from nearfar.orthoview._grid import OCTANTS

REPEAT = 3
LAYOUT = layout_of()


def main() -> None:
    start(__doc__)
    rows, views = [], None
    for leaf in leaves():
        views, row = measure_leaf(leaf)
        rows.append(row)
    times = ("by triangles", "by rays", "nf.render", "Embree's rays")
    header = ["leaf", "triangles {:,}", "a pixel {:.2f}", *(f"{name}, ms {{:.0f}}" for name in times)]
    print(table(f"Nine views of {SIZE}² pixels, drawn at twice the size", header, rows))
    if views is not None:
        print(table("Steps for the last leaf", "step | ms {:.1f} | GB/s {:.1f}", step_rows(views)))


def leaves() -> Iterator[Leaf]:
    for _, city in scenes.present("Tokyo core"):
        yield from (in_the_middle(f"Tokyo, {side:g} m", city, side) for side in (125.0, 500.0, 2000.0))
    forest = nf.datasets.forest()
    yield from (in_the_middle(f"forest, {side:g} m", forest, side) for side in (20.0, 80.0, 400.0))


def measure_leaf(leaf: Leaf) -> tuple[_core.OrthoViews, list[object]]:
    scene, corner_and_side = leaf.scene, (leaf.corner, leaf.side)

    def draw(method: str) -> Callable[[], _core.OrthoViews]:
        # Each leaf of a build is a new scene, whose search tree must be built before rays.
        fresh_scenes = [copy_without_trees(scene)._core for _ in range(REPEAT + 1)]
        return lambda: _core.OrthoViews.of_cell(
            fresh_scenes.pop(), corner_and_side, DIRECTIONS, LAYOUT.format, method=method
        )

    times = [best(draw(method), repeat=REPEAT).ms for method in ("triangles", "rays")]
    row = [leaf.name, scene.triangle_count, scene.triangle_count / (4 * SIZE * SIZE), *times, time_renderer(leaf)]
    return draw("triangles")(), [*row, time_embree(leaf)]


def time_renderer(leaf: Leaf) -> float:
    """Milliseconds of the same pictures by the renderer: without clipping to the cell, reduction and codes."""
    fresh_scenes = [copy_without_trees(leaf.scene) for _ in range(REPEAT + 1)]

    def job() -> None:
        scene = fresh_scenes.pop()
        for camera in cameras(leaf):
            nf.render(scene, camera, channels=("range", "normal", "albedo"))

    return best(job, repeat=REPEAT).ms


def cameras(leaf: Leaf) -> Iterator[nf.Camera]:
    """Yield cameras of all views of a leaf, of twice the size."""
    for direction in DIRECTIONS:
        (_, up, toward), extents = axes_of(direction, leaf.side)
        x, y, z = extents / 2
        eye, fov = leaf.box.mean(axis=0) + z * toward, nf.Orthographic(-x, x, -y, y)
        yield nf.Camera.look_at(eye, eye - toward, up=up, fov=fov, size=(2 * SIZE, 2 * SIZE))


def time_embree(leaf: Leaf) -> float | str:
    """Milliseconds of Embree's search tree and its rays, of all views; "–" without it."""
    scene = leaf.scene
    mesh = trimesh.Trimesh(scene.triangles().reshape(-1, 3), np.arange(3 * scene.triangle_count).reshape(-1, 3),
                           process=False)  # fmt: skip
    try:
        from trimesh.ray.ray_pyembree import RayMeshIntersector
    except ImportError:
        return "–"
    views = [camera.rays() for camera in cameras(leaf)]

    def job() -> None:
        tree = RayMeshIntersector(mesh)
        for origins, rays in views:
            tree.intersects_first((origins - scene.origin).reshape(-1, 3), rays.reshape(-1, 3))

    return best(job, repeat=2).ms


def step_rows(views: _core.OrthoViews) -> list[list[object]]:
    parent = _core.OrthoParent(DIRECTIONS, LAYOUT.format)
    adds = itertools.cycle(OCTANTS)
    # A child's texel is 10 bytes. A parent's picture has four texels of 16 bytes for each pixel, read and written.
    pixels = len(DIRECTIONS) * SIZE * SIZE
    jobs: dict[str, tuple[Callable[[], object], int | None]] = {
        "drawing a child into its parent": (lambda: parent.add(next(adds), views), pixels * (10 + 2 * 16)),
        "reducing a parent": (parent.finish, pixels * (4 * 16 + 10)),
        "connected pixels": (lambda: views.connected(_codec.CONNECTION_LIMITS), None),
        "compressing and packing, connected pixels included": (lambda: _codec.encode(views, LAYOUT), None),
    }
    times = {name: best(job) for name, (job, _) in jobs.items()}
    return [
        [name, time.ms, bytes_moved and bytes_moved / time.wall / 1e9]
        for (name, time), (_, bytes_moved) in zip(times.items(), jobs.values(), strict=True)
    ]


if __name__ == "__main__":
    main()
