"""Both simplifiers: time, and the levels' distance from the base; and nearest points against peers."""

from __future__ import annotations

import importlib.util
from pathlib import Path
from typing import Any

import fast_simplification
import numpy as np
import trimesh
from numpy.typing import NDArray
from PIL import Image
from scipy.spatial import cKDTree

import nearfar as nf
from benchmarks.harness.compare import OURS, Case, compare, greatest_error, print_limits
from benchmarks.harness.report import start, table
from benchmarks.harness.timing import timed
from nearfar import _core
from nearfar.lod._simplify import deviation
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
    rows: list[list[object]] = []
    for method in ("fast", "meshopt"):
        simplified, time = timed(nf.lod.simplify, mesh, RATIOS, method=method)
        for level in simplified[1:]:
            errors = level.error / simplified.radius, level.mean_error / simplified.radius
            reached = level.triangle_count / simplified[0].triangle_count
            rows.append([f"{OURS}, {method}, {time.wall:.2f} s", level.ratio, reached, *errors])
    points, faces = base.surface.positions.astype(np.float64), base.places[base.surface.faces].astype(np.int32)
    simplify = fast_simplification.simplify
    peer_levels, time = timed(lambda: [simplify(points, faces, target_count=int(r * len(faces))) for r in RATIOS])
    _, radius = nf.bounding_sphere(points)
    for ratio, (vertices, triangles) in zip(RATIOS, peer_levels, strict=True):
        count = len(triangles)
        surface = Surface(vertices.astype(np.float32), triangles.astype(np.uint32), np.zeros(count, np.int32))
        distances = deviation.deviation((base.scene, base.surface), (base.scene_of(surface), surface))
        errors = distances[0] / radius, distances[1] / radius
        rows.append([f"fast-simplification directly, {time.wall:.2f} s", ratio, count / len(faces), *errors])
    header = " | ratio {:g} | reached {:.3f} | greatest / radius {:.2e} | mean / radius {:.2e}"
    return table(f"levels of {name}, {len(faces):,} triangles", header, rows)


def nearest(subdivisions: int, count: int) -> str:
    """Table for points around a knobbly sphere; distances are compared with those to all triangles for a few points."""
    mesh = knobbly(subdivisions)
    scene = nf.Scene.from_trimesh(mesh)
    scene._core.build()
    random = np.random.default_rng(0)
    points = trimesh.sample.sample_surface(mesh, count, seed=0)[0] + random.normal(size=(count, 3)) * 0.02
    exact, _, _ = _core.nearest_points(scene._core, points)
    error, tree = greatest_error(exact), cKDTree(mesh.vertices)
    cases = [
        Case(f"{OURS}, nearest_points", lambda: nf.nearest_points(scene, points).distance, error),
        Case("SciPy, nearest vertex, all cores", lambda: tree.query(points, workers=-1)[0], error),
    ]
    if importlib.util.find_spec("rtree"):
        proximity = trimesh.proximity.closest_point
        cases.append(Case("trimesh, closest_point", lambda: proximity(mesh, points)[1], error))
    return compare(f"{count:,} nearest points of {len(mesh.faces):,} triangles", cases, repeat=3, unit="m")


def main() -> None:
    options = start(__doc__, files={"nargs": "*", "help": "further meshes"})
    print_limits()
    print(nearest(6, 100_000))
    meshes: dict[str, nf.Scene | trimesh.Trimesh] = {"a knobbly sphere": knobbly(6)}
    meshes |= {Path(path).name: nf.Scene.load(path) for path in options.files}
    for name, mesh in meshes.items():
        print(levels(name, mesh))


if __name__ == "__main__":
    main()
