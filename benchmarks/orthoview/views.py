"""Views of leaves and parents: triangle by triangle against ray by ray, and against Embree's rays alone."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator

import numpy as np
import trimesh

import nearfar as nf
from benchmarks.harness.timing import best, machine, table
from nearfar import _core
from nearfar._base import data
from nearfar.orthoview import _codec
from nearfar.orthoview._directions import directions_of
from nearfar.orthoview._grid import OCTANTS, Grid
from nearfar.orthoview._layout import Layout

SIZE = 256
REPEAT = 3
DIRECTIONS = directions_of(9)
LAYOUT = Layout(Grid((0.0, 0.0, 0.0), 1.0, (1, 1, 1)), DIRECTIONS, SIZE, 12, 16, 3)
TOKYO = "city/tokyo23/tokyo_core_lod1.glb"


def main() -> None:
    print(machine(), "\n")
    rows = []
    views = None
    for name, scene, corner, side in leaves():
        views, row = of_leaf(name, scene, corner, side)
        rows.append(row)
    header = ["leaf", "triangles", "a pixel", "by triangles, ms", "by rays, ms", "nf.render, ms", "Embree's rays, ms"]
    print(table(f"Nine views of {SIZE}² pixels, drawn at twice the size", header, rows))
    if views is not None:
        print(table("Of the last leaf", ["step", "ms", "GB/s"], of_steps(views)))


def leaves() -> Iterator[tuple[str, nf.Scene, tuple[float, float, float], float]]:
    """Yield cells of few and of many triangles."""
    path = data.find(TOKYO)
    if path is not None:
        city = nf.Scene.load(path)
        for side in (125.0, 500.0, 2000.0):
            yield f"Tokyo, {side:g} m", *cell(city, side)
    forest = nf.datasets.forest()
    for side in (20.0, 80.0, 400.0):
        yield f"forest, {side:g} m", *cell(forest, side)


def cell(scene: nf.Scene, side: float) -> tuple[nf.Scene, tuple[float, float, float], float]:
    """Return the cell in the middle of a scene, and the geometry that touches it."""
    x, _, z = (scene.bounds.mean(axis=0) - side / 2).tolist()
    corner = (x, float(np.floor(scene.bounds[0, 1])), z)
    return scene.query(np.array([corner, np.add(corner, side)])), corner, side


def of_leaf(
    name: str, scene: nf.Scene, corner: tuple[float, float, float], side: float
) -> tuple[_core.OrthoViews, list[str]]:
    def draw(way: str) -> Callable[[], _core.OrthoViews]:
        # Each leaf of a build is a new scene, whose search tree must be built before rays.
        scenes = [fresh(scene) for _ in range(REPEAT + 1)]
        return lambda: _core.OrthoViews.of_cell(scenes.pop(), (corner, side), DIRECTIONS, LAYOUT.format, way=way)

    seconds = [best(draw(way), repeat=REPEAT).wall for way in ("triangles", "rays")]
    pixels = 4 * SIZE * SIZE
    row = [name, f"{scene.triangle_count:,}", f"{scene.triangle_count / pixels:.2f}"]
    row += [f"{second * 1e3:.0f}" for second in (*seconds, rendered(scene, corner, side))]
    return draw("triangles")(), [*row, embree(scene, corner, side)]


def rendered(scene: nf.Scene, corner: tuple[float, float, float], side: float) -> float:
    """Seconds of the same pictures by the renderer: without limits, reduction and codes."""
    scenes = [scene.subset(triangles=np.ones(scene.triangle_count, bool)) for _ in range(REPEAT + 1)]

    def job() -> None:
        fresh_one = scenes.pop()
        for direction in DIRECTIONS:
            (_, up, toward), extents = _core.orthoview_axes(direction)
            half = side * np.array(extents) / 2
            eye = np.add(corner, side / 2) + half[2] * np.array(toward)
            frame = nf.Orthographic(-half[0], half[0], -half[1], half[1])
            size = (2 * SIZE, 2 * SIZE)
            camera = nf.Camera.look_at(eye, eye - np.array(toward), up=np.array(up), fov=frame, size=size)
            nf.render(fresh_one, camera, channels=("range", "normal", "albedo"))

    return best(job, repeat=REPEAT).wall


def fresh(scene: nf.Scene) -> _core.Scene:
    """Copy a scene without search trees."""
    return scene.subset(triangles=np.ones(scene.triangle_count, bool))._core


def embree(scene: nf.Scene, corner: tuple[float, float, float], side: float) -> str:
    """The time of Embree's search tree and its rays, of all views."""
    mesh = trimesh.Trimesh(scene.triangles().reshape(-1, 3), np.arange(3 * scene.triangle_count).reshape(-1, 3),
                           process=False)  # fmt: skip
    try:
        from trimesh.ray.ray_pyembree import RayMeshIntersector
    except ImportError:
        return "–"
    rays = []
    for direction in DIRECTIONS:
        (right, up, toward), extents = _core.orthoview_axes(direction)
        place = (np.arange(2 * SIZE) + 0.5) / (2 * SIZE) - 0.5
        center = np.add(corner, side / 2) - scene.origin + np.array(toward) * extents[2] * side / 2
        points = center + side * (
            place[None, :, None] * extents[0] * np.array(right) - place[:, None, None] * extents[1] * np.array(up)
        )
        rays.append((points.reshape(-1, 3), np.broadcast_to(-np.array(toward), (4 * SIZE * SIZE, 3))))

    def job() -> None:
        tree = RayMeshIntersector(mesh)
        for origins, along in rays:
            tree.intersects_first(origins, along)

    return f"{best(job, repeat=2).wall * 1e3:.0f}"


def of_steps(views: _core.OrthoViews) -> list[list[str]]:
    parent = _core.OrthoParent(DIRECTIONS, LAYOUT.format)
    adds = itertools.cycle(OCTANTS)
    jobs: dict[str, Callable[[], object]] = {
        "drawing a child into its parent": lambda: parent.add(next(adds), views),
        "reducing a parent": parent.finish,
        "connected pixels": lambda: views.connected(_codec.CONNECTED),
        "compressing and packing, connected pixels included": lambda: _codec.encoded(views, LAYOUT),
    }
    rows = [[name, f"{best(job).wall * 1e3:.1f}"] for name, job in jobs.items()]
    # A texel of a child is 10 bytes. A texel of a parent's picture, four for each pixel, is 16: read and written.
    pixels = len(DIRECTIONS) * SIZE * SIZE
    moved = {"drawing a child into its parent": pixels * (10 + 2 * 16), "reducing a parent": pixels * (4 * 16 + 10)}
    return [[*row, f"{moved[row[0]] / float(row[1]) / 1e6:.1f}" if row[0] in moved else ""] for row in rows]


if __name__ == "__main__":
    main()
