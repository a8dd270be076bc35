"""Speed of pictures of a tree: splats per second, against peers' points.

    NEARFAR_NUM_THREADS=1 python -m benchmarks.orthoview.splats TREE

Eyes look at the middle of the tree, diagonally, from half its width away. NumPy and pyrender draw the points
only, one pixel each, without planes, balls or normals.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness import opengl
from benchmarks.harness.report import start, table
from benchmarks.harness.timing import Timing, best
from nearfar import _core
from nearfar._camera.shot import Shot

SIZE = (640, 480)
FOV = nf.Fov.symmetric(60, SIZE[0] / SIZE[1])
HEIGHTS = (0.05, 0.25)
"""Heights of the eyes above the ground, in widths of the tree."""


def main() -> None:
    options = start(__doc__, "tree", repeat=7)
    tree = nf.orthoview.open(options.tree)
    print(f"{_core.thread_count()} threads\n\n{tree}\n")
    for height in HEIGHTS:
        print(pictures(tree, eye(tree, height), options.repeat, f"Eye at {height:g} widths"))


def eye(tree: nf.orthoview.OrthoTree, height: float) -> nf.Camera:
    """An eye that looks at the middle of a tree."""
    low, high = tree.bounds
    middle, width = (low + high) / 2, float((high - low).max())
    position = middle + width / 2 * np.array([0.7, 0.0, 0.7])
    return nf.Camera.look_at((position[0], low[1] + height * width, position[2]), middle, fov=FOV, size=SIZE)


def pictures(tree: nf.orthoview.OrthoTree, camera: nf.Camera, repeat: int, title: str) -> str:
    """Table of visible and of projected splats per second, and of the peers' points."""
    cut = tree.cut(camera, geometry=False)
    splats = tree._viewer.views.get(cut.keys())
    total = sum(view.count for view in splats)
    settings: dict[str, Any] = {"origin": (0.0, 0.0, 0.0)}
    draw = partial(_core.splat_orthoviews, splats, camera._core, Shot(cameras=(camera,), channels=("color",)).settings)
    timings: dict[str, tuple[Timing, int, int]] = {}
    for name, grid in (("splats", 1), ("splats, 4 × 4 samples", 4)):
        settings["grid"] = grid
        counts = draw(**settings)["stats"]
        timing = best(partial(draw, **settings), repeat=repeat)
        timings[name] = timing, counts["splats_seen"], counts["splats_projected"]
    points, colors = points_of(tree, cut.keys())
    timings["points, NumPy's minimum.at"] = best(numpy_points(points, camera), repeat=3), total, total
    if (draw_points := pyrender_points(points, colors, camera)) is not None:
        timings["points, pyrender"] = best(draw_points, repeat=3), total, total
    rows = [
        [name, time.ms, time.cpu_ms, count_seen / time.wall / 1e6, projected / time.wall / 1e6]
        for name, (time, count_seen, projected) in timings.items()
    ]
    full_title = f"{title}: {len(cut)} cells, {len(splats)} views, {total / 1e6:.2f} million splats"
    header = "method | ms {:.1f} | CPU ms {:.1f} | million seen a second {:.1f} | million projected a second {:.1f}"
    return table(full_title, header, rows)


def points_of(tree: nf.orthoview.OrthoTree, keys: list[Any]) -> tuple[NDArray[np.float64], NDArray[np.uint8]]:
    points, colors = [], []
    for key in keys:
        view = tree.view(*key)
        if view is not None:
            is_shown = np.isfinite(view.depth)
            points.append(view.points()[is_shown])
            colors.append(view.color[is_shown])
    return np.concatenate(points), np.concatenate(colors)


def numpy_points(points: NDArray[np.float64], camera: nf.Camera) -> Callable[[], NDArray[np.uint64]]:
    """Return the function that finds the nearest point of each pixel, by keys of depth and number."""
    width, height = camera.size

    def draw() -> NDArray[np.uint64]:
        x, y, depth = camera.project(points).T
        with np.errstate(invalid="ignore"):
            is_visible = (x >= 0) & (x < width) & (y >= 0) & (y < height)
        pixel = y[is_visible].astype(np.int64) * width + x[is_visible].astype(np.int64)
        key = depth[is_visible].astype(np.float32).view(np.uint32).astype(np.uint64) << np.uint64(32)
        keys = np.full(width * height, np.iinfo(np.uint64).max, np.uint64)
        np.minimum.at(keys, pixel, key | np.flatnonzero(is_visible).astype(np.uint64))
        return keys

    return draw


def pyrender_points(
    points: NDArray[np.float64], colors: NDArray[np.uint8], camera: nf.Camera
) -> Callable[[], Any] | None:
    """Return the function that draws the points by OpenGL, in software without a GPU; None without pyrender."""
    peer = opengl.pyrender()
    if peer is None:
        return None
    middle, far = points.mean(axis=0), float(np.ptp(points, axis=0).max()) * 4
    mesh = peer.Mesh.from_points(points - middle, colors=colors)
    scene = opengl.scene_of(mesh, camera, origin=middle, near=far / 1e4, far=far)
    renderer = peer.OffscreenRenderer(*camera.size)
    return lambda: renderer.render(scene, flags=peer.RenderFlags.FLAT)


if __name__ == "__main__":
    main()
