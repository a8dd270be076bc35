"""Levels by both simplifiers: time, its parts, and the levels' distance from the base; nearest points against peers.

python -m benchmarks.lod.simplify [FILE …]
"""

from __future__ import annotations

import importlib.util
import sys
import time
from pathlib import Path
from typing import Any
from unittest.mock import patch

import fast_simplification
import numpy as np
import trimesh
from numpy.typing import NDArray
from PIL import Image
from scipy.spatial import cKDTree

import nearfar as nf
from benchmarks.harness.compare import OURS, Case, compare, describe
from benchmarks.harness.timing import machine, table
from nearfar import _core
from nearfar.lod._simplify import carry, deviation
from nearfar.lod._simplify.quadrics import QuadricSimplifier
from nearfar.lod._simplify.surface import Base, Surface

Array = NDArray[Any]
RATIOS = (0.5, 0.25, 0.1, 0.05, 0.02)


def knobbly(subdivisions: int) -> trimesh.Trimesh:
    """Make a sphere with waves, whose texture coordinates are its x and y."""
    ball = trimesh.creation.icosphere(subdivisions)
    waves = 1 + 0.1 * np.sin(8 * ball.vertices[:, :1]) * np.cos(6 * ball.vertices[:, 1:2])
    ball.vertices = ball.vertices * waves
    image = trimesh.visual.material.PBRMaterial(baseColorTexture=Image.new("RGB", (8, 8)))
    ball.visual = trimesh.visual.TextureVisuals(uv=ball.vertices[:, :2] / 3 + 0.5, material=image)
    return ball


def levels(name: str, mesh: nf.Scene | trimesh.Trimesh) -> str:
    """Table of errors of all levels, and of fast-simplification used directly on the same surface."""
    base = Base(mesh)
    rows = []
    for method in ("fast", "meshopt"):
        started = time.perf_counter()
        made = nf.lod.simplify(mesh, RATIOS, method=method)
        seconds = time.perf_counter() - started
        for level in made[1:]:
            share = f"{level.triangle_count / made[0].triangle_count:.3f}"
            error = [f"{value / made.radius:.2e}" for value in (level.error, level.mean_error)]
            rows.append([f"{OURS}, {method}, {seconds:.2f} s", f"{level.ratio:g}", share, *error])
    points, faces = base.surface.positions.astype(np.float64), base.places[base.surface.faces].astype(np.int32)
    started = time.perf_counter()
    plain = [fast_simplification.simplify(points, faces, target_count=int(r * len(faces))) for r in RATIOS]
    seconds = time.perf_counter() - started
    _, radius = nf.bounding_sphere(points)
    for ratio, (places, left) in zip(RATIOS, plain, strict=True):
        surface = Surface(places.astype(np.float32), left.astype(np.uint32), np.zeros(len(left), np.int32))
        distances = deviation.deviation((base.scene, base.surface), (base.scene_of(surface), surface))
        error = [f"{value / radius:.2e}" for value in distances]
        rows.append(
            [f"fast-simplification as it is, {seconds:.2f} s", f"{ratio:g}", f"{len(left) / len(faces):.3f}", *error]
        )
    header = ["", "ratio", "reached", "greatest / radius", "mean / radius"]
    return table(f"levels of {name}, {len(faces):,} triangles", header, rows)


def shares(name: str, mesh: nf.Scene | trimesh.Trimesh) -> str:
    """Table of the time of one level by its parts."""
    base = Base(mesh)
    target = len(base.surface.faces) // 10
    ticks = [time.perf_counter()]
    simplifier = QuadricSimplifier(base.surface, base.places)
    ticks.append(time.perf_counter())
    surface = simplifier.level(target)
    ticks.append(time.perf_counter())
    carried: list[float] = []
    original = carry.Carrier.carried

    def timed(self: carry.Carrier, *arguments: Any) -> Surface:
        started = time.perf_counter()
        result = original(self, *arguments)
        carried.append(time.perf_counter() - started)
        return result

    with patch.object(carry.Carrier, "carried", timed):
        simplifier.level(target)
    again = time.perf_counter()
    scene = base.scene_of(surface)
    deviation.deviation((base.scene, base.surface), (scene, surface))
    measured = time.perf_counter() - again
    rows = [
        ["preparing, once for all levels", f"{(ticks[1] - ticks[0]) * 1e3:.0f}"],
        ["collapsing", f"{(ticks[2] - ticks[1] - carried[0]) * 1e3:.0f}"],
        ["carrying attributes", f"{carried[0] * 1e3:.0f}"],
        ["distances, with both trees", f"{measured * 1e3:.0f}"],
    ]
    return table(f"one level of {name} at 0.1 by 'fast'", ["", "ms"], rows)


def nearest(subdivisions: int, count: int) -> str:
    """Table for points around a knobbly sphere; distances are compared with those to all triangles for a few points."""
    mesh = knobbly(subdivisions)
    scene = nf.Scene.from_trimesh(mesh)
    scene._core.build()
    random = np.random.default_rng(0)
    points = trimesh.sample.sample_surface(mesh, count, seed=0)[0] + random.normal(size=(count, 3)) * 0.02
    exact, _, _ = _core.nearest_points(scene._core, points)

    def error(distance: Array) -> float:
        return float(np.abs(distance - exact).max())

    tree = cKDTree(mesh.vertices)
    cases = [
        Case(f"{OURS}, nearest_points", lambda: nf.nearest_points(scene, points).distance, error, peer=False),
        Case("SciPy, nearest vertex, all cores", lambda: tree.query(points, workers=-1)[0], error),
    ]
    if importlib.util.find_spec("rtree"):
        proximity = trimesh.proximity.closest_point
        cases.append(Case("trimesh, closest_point", lambda: proximity(mesh, points)[1], error))
    return compare(f"{count:,} nearest points of {len(mesh.faces):,} triangles", cases, repeat=3, unit="m")


def main() -> None:
    print(machine())
    print(describe())
    print(nearest(6, 100_000))
    meshes: dict[str, nf.Scene | trimesh.Trimesh] = {"a knobbly sphere": knobbly(6)}
    meshes |= {Path(path).name: nf.Scene.load(path) for path in sys.argv[1:]}
    for name, mesh in meshes.items():
        print(levels(name, mesh))
        print(shares(name, mesh))


if __name__ == "__main__":
    main()
