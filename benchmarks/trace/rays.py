"""Times of rays and search trees, compared with Embree's, with the same rays in the same run."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from functools import partial
from typing import Any

# One thread, because rates are per CPU second, which would include idle threads of a pool.
os.environ.setdefault("NEARFAR_NUM_THREADS", "1")

import numpy as np
from embreex import rtcore_scene
from embreex.mesh_construction import TriangleMesh
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness import scenes
from benchmarks.harness.report import start, table
from benchmarks.harness.timing import best
from nearfar import _core

Array = NDArray[np.float32]


def camera_rays(eye: tuple[float, ...], target: tuple[float, ...], size: tuple[int, int], tile: int) -> Array:
    """Unit directions of a 90° view in tiles of `tile` pixels, or row by row for 1."""
    width, height = size
    _, rays = nf.Camera.look_at(eye, target, fov=nf.Fov.symmetric(90, width / height), size=size).rays()
    rays = rays.reshape(height // tile, tile, width // tile, tile, 3).transpose(0, 2, 1, 3, 4)
    return np.ascontiguousarray(rays.reshape(-1, 3), np.float32)


def embree_scene(points: Array, faces: NDArray[np.int32]) -> Any:
    """Embree scene with its tree, which Embree builds at the first ray."""
    scene = rtcore_scene.EmbreeScene()
    TriangleMesh(scene, points, faces)
    scene.run(np.zeros((1, 3), np.float32), np.array([[0, 1, 0]], np.float32))
    return scene


HEADER = "embreex Mray/s {:.2f} | nearfar Mray/s {:.2f} | ratio {:.2f}"


def rates(ours: Callable[[], Any], theirs: Callable[[], Any], rays: int, repeat: int) -> list[float]:
    """Million rays per CPU-second of both tracers, and their ratio."""
    peer_seconds, own_seconds = best(theirs, repeat=repeat).cpu, best(ours, repeat=repeat).cpu
    return [rays / peer_seconds / 1e6, rays / own_seconds / 1e6, peer_seconds / own_seconds]


def primary(
    scene: nf.Scene, embree: Any, views: dict[str, Any], size: tuple[int, int], repeat: int
) -> list[list[object]]:
    """Rows for camera rays in both orders and shuffled, then for occlusion rays."""
    rows: list[list[object]] = []
    for name, (eye, target) in views.items():
        orders = {"tiles of 8×8": camera_rays(eye, target, size, 8), "row by row": camera_rays(eye, target, size, 1)}
        shuffled = np.random.default_rng(0).permutation(orders["row by row"])
        for order, directions in {**orders, "random order": shuffled}.items():
            origin = np.asarray(eye, np.float32)
            ours = partial(nf.cast_rays, scene, origin, directions)
            theirs = partial(embree.run, np.broadcast_to(origin, directions.shape).copy(), directions, output=True)
            same = np.mean(ours().triangle_index == theirs()["primID"])
            rows.append([name, order, *rates(ours, theirs, len(directions), repeat), 100 * same])
    return rows


def incoherent(scene: nf.Scene, embree: Any, points: Array, repeat: int) -> list[list[object]]:
    """Rows for rays between random points: nearest hits, and Embree's occlusion beside nearfar's nearest hits."""
    draw = np.random.default_rng(1)
    directions = draw.normal(size=(500_000, 3)).astype(np.float32)
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    origins = draw.uniform(points.min(0), points.max(0), directions.shape).astype(np.float32)
    ours = partial(nf.cast_rays, scene, origins, directions)
    queries: dict[str, dict[str, Any]] = {"nearest hit": {"output": True}, "Embree: any hit": {"query": "OCCLUDED"}}
    return [
        [name, *rates(ours, partial(embree.run, origins, directions, **options), len(directions), repeat)]
        for name, options in queries.items()
    ]


def build(points: Array, faces: NDArray[Any], repeat: int) -> list[float]:
    """CPU-seconds of building both trees."""
    ours = best(lambda: nf.Scene.from_arrays(points, faces)._core.build(), repeat=repeat).cpu
    theirs = best(lambda: embree_scene(points, faces.astype(np.int32)), repeat=repeat).cpu
    return [len(faces), theirs, ours, theirs / ours]


def places() -> Iterator[tuple[str, nf.Scene, dict[str, Any]]]:
    """Yield names, scenes, and eyes and targets of views from a street and from above."""
    for _, scene in scenes.present("Tokyo core"):
        x, _, z = np.asarray(scene.bounds).mean(0).tolist()
        views = {"street": ((x, 2.0, z), (x + 100, 20.0, z + 30)), "above": ((x, 150.0, z), (x + 300, 0.0, z + 200))}
        yield "tokyo_core_lod1", scene, views
    # nearfar has instances and cut-out leaves, Embree one merged opaque mesh.
    views = {"street": ((2.0, 1.7, 2.0), (30.0, 8.0, -100.0)), "above": ((0.0, 60.0, 0.0), (100.0, 0.0, -100.0))}
    yield "procedural city", nf.datasets.city(), views


def main() -> None:
    options = start(__doc__, view_size=("1920x1080", "pixels, multiples of 8"), repeat=5)
    width, height = (int(part) for part in options.view_size.split("x"))
    print(f"{_core.instruction_sets()[-1]}; one thread\n")
    builds = []
    for name, scene, views in places():
        points = scene.triangles().reshape(-1, 3)
        faces = np.arange(len(points), dtype=np.uint32).reshape(-1, 3)
        embree = embree_scene(points, faces.astype(np.int32))
        rows = primary(scene, embree, views, (width, height), options.repeat)
        header = f"view | order | {HEADER} | same triangle {{:.3f}} %"
        print(table(f"Camera rays, {options.view_size}, {name}", header, rows))
        rows = incoherent(scene, embree, points, options.repeat)
        print(table(f"Incoherent rays, {name}", f"rays from anywhere | {HEADER}", rows))
        builds.append([name, *build(points, faces, min(options.repeat, 2))])
    header = "scene | triangles {:,} | embreex {:.2f} | nearfar {:.2f} | ratio {:.2f}"
    print(table("Building, CPU-seconds, merged", header, builds))


if __name__ == "__main__":
    main()
