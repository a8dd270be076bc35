"""Times of rays and search trees, compared with Embree's, with the same rays in the same run.

python -m benchmarks.trace.rays [--view-size 1920x1080] [--repeat 5]
"""

from __future__ import annotations

import argparse
import os
from collections.abc import Callable
from typing import Any

# Rates are rays per CPU-second, and idle threads of a pool would count, hence one thread.
os.environ.setdefault("NEARFAR_NUM_THREADS", "1")

import numpy as np
from embreex import rtcore_scene
from embreex.mesh_construction import TriangleMesh
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness.timing import best, machine, table
from nearfar import _core
from nearfar._base import data

Array = NDArray[np.float32]


def camera_rays(eye: tuple[float, ...], target: tuple[float, ...], size: tuple[int, int], tile: int) -> Array:
    """Unit directions of a 90° view in tiles of `tile` pixels, or row by row for 1."""
    width, height = size
    forward = np.subtract(target, eye)
    forward = forward / np.linalg.norm(forward)
    right = np.cross(forward, (0.0, 1.0, 0.0))
    right /= np.linalg.norm(right)
    up = np.cross(right, forward)
    x = (np.arange(width) + 0.5) / width * 2 - 1
    y = (1 - (np.arange(height) + 0.5) / height * 2) * height / width
    rays = forward + x[None, :, None] * right + y[:, None, None] * up
    if tile > 1:
        rays = rays.reshape(height // tile, tile, width // tile, tile, 3).transpose(0, 2, 1, 3, 4)
    rays = rays.reshape(-1, 3)
    return np.ascontiguousarray(rays / np.linalg.norm(rays, axis=1, keepdims=True), np.float32)


def embree_scene(points: Array, faces: NDArray[np.int32]) -> Any:
    """Embree scene with its tree built, which Embree does at the first ray."""
    scene = rtcore_scene.EmbreeScene()
    TriangleMesh(scene, points, faces)
    scene.run(np.zeros((1, 3), np.float32), np.array([[0, 1, 0]], np.float32))
    return scene


def rates(ours: Callable[[], Any], theirs: Callable[[], Any], rays: int, repeat: int) -> list[str]:
    """Million rays per CPU-second of both tracers, and their ratio."""
    peer, mine = best(theirs, repeat=repeat).cpu, best(ours, repeat=repeat).cpu
    return [f"{rays / peer / 1e6:.2f}", f"{rays / mine / 1e6:.2f}", f"{peer / mine:.2f}"]


def primary(scene: nf.Scene, embree: Any, views: dict[str, Any], size: tuple[int, int], repeat: int) -> list[list[str]]:
    """Rows for camera rays in both orders and shuffled, then for occlusion rays."""
    rows = []
    for name, (eye, target) in views.items():
        orders = {"tiles of 8×8": camera_rays(eye, target, size, 8), "row by row": camera_rays(eye, target, size, 1)}
        shuffled = np.random.default_rng(0).permutation(orders["row by row"])
        for order, directions in {**orders, "random order": shuffled}.items():
            start = np.asarray(eye, np.float32)
            origins = np.broadcast_to(start, directions.shape).copy()

            def ours(directions: Array = directions, start: Array = start) -> nf.Hits:
                return nf.cast_rays(scene, start, directions)

            def theirs(directions: Array = directions, origins: Array = origins) -> Any:
                return embree.run(origins, directions, output=True)

            same = np.mean(ours().triangle_index == theirs()["primID"])
            rows.append([name, order, *rates(ours, theirs, len(directions), repeat), f"{100 * same:.3f} %"])
    return rows


def incoherent(scene: nf.Scene, embree: Any, points: Array, repeat: int) -> list[list[str]]:
    """Rows for rays between random points: nearest hits, and Embree's occlusion beside nearfar's nearest hits."""
    draw = np.random.default_rng(1)
    directions = draw.normal(size=(500_000, 3)).astype(np.float32)
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    origins = draw.uniform(points.min(0), points.max(0), directions.shape).astype(np.float32)
    rows = []
    queries: dict[str, dict[str, Any]] = {"nearest hit": {"output": True}, "Embree: any hit": {"query": "OCCLUDED"}}
    for name, options in queries.items():

        def theirs(options: dict[str, Any] = options) -> Any:
            return embree.run(origins, directions, **options)

        rows.append([name, *rates(lambda: nf.cast_rays(scene, origins, directions), theirs, len(directions), repeat)])
    return rows


def build(points: Array, faces: NDArray[Any], repeat: int) -> list[str]:
    """CPU-seconds of building both trees."""
    ours = best(lambda: nf.Scene.from_arrays(points, faces)._core.build(), repeat=repeat).cpu
    theirs = best(lambda: embree_scene(points, faces.astype(np.int32)), repeat=repeat).cpu
    return [f"{len(faces):,}", f"{theirs:.2f}", f"{ours:.2f}", f"{theirs / ours:.2f}"]


def tokyo() -> tuple[nf.Scene, Array, NDArray[Any], dict[str, Any]] | None:
    """The middle of Tokyo, seen from a street and from above."""
    path = data.find("city/tokyo23/tokyo_core_lod1.glb")
    if path is None:
        return None
    scene = nf.Scene.load(path)
    middle = np.asarray(scene.bounds).mean(0)
    x, z = float(middle[0]), float(middle[2])
    views = {"street": ((x, 2.0, z), (x + 100, 20.0, z + 30)), "above": ((x, 150.0, z), (x + 300, 0.0, z + 200))}
    points = scene.triangles().reshape(-1, 3)
    return scene, points, np.arange(len(points), dtype=np.uint32).reshape(-1, 3), views


def city() -> tuple[nf.Scene, Array, NDArray[Any], dict[str, Any]]:
    """The procedural city: nearfar has instances and cut-out leaves, Embree one merged opaque mesh."""
    scene = nf.datasets.city()
    points = scene.triangles().reshape(-1, 3)
    views = {"street": ((2.0, 1.7, 2.0), (30.0, 8.0, -100.0)), "above": ((0.0, 60.0, 0.0), (100.0, 0.0, -100.0))}
    return scene, points, np.arange(len(points), dtype=np.uint32).reshape(-1, 3), views


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--view-size", default="1920x1080", help="pixels, multiples of 8")
    parser.add_argument("--repeat", type=int, default=5)
    options = parser.parse_args()
    width, height = (int(part) for part in options.view_size.split("x"))
    print(f"{machine()}; {_core.instruction_sets()[-1]}; one thread\n")
    builds = []
    for name, arrays in {"tokyo_core_lod1": tokyo(), "procedural city": city()}.items():
        if arrays is None:
            continue
        scene, points, faces, views = arrays
        embree = embree_scene(points, faces.astype(np.int32))
        header = ["view", "order", "embreex Mray/s", "nearfar Mray/s", "ratio", "same triangle"]
        rows = primary(scene, embree, views, (width, height), options.repeat)
        print(table(f"Camera rays, {options.view_size}, {name}", header, rows))
        header = ["rays from anywhere", "embreex Mray/s", "nearfar Mray/s", "ratio"]
        print(table(f"Incoherent rays, {name}", header, incoherent(scene, embree, points, options.repeat)))
        builds.append([name, *build(points, faces, min(options.repeat, 2))])
    print(table("Building, CPU-seconds, merged", ["scene", "triangles", "embreex", "nearfar", "ratio"], builds))


if __name__ == "__main__":
    main()
