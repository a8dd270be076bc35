"""Error of the vertex morph before and after tessellation, and the triangles that a peer needs for the same error."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import trimesh
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness import scenes
from benchmarks.harness.report import save_figure, start, subplots, table
from benchmarks.harness.timing import Timing, best, timed
from tests.support.tessellate_cases import VIEW, ground

R1, R2, REACH = 30.0, 50.0, 5.0
"""Radii of the zones, and greatest distance of users from the centre, metres."""
CENTER = np.array([0.3, 1.7, 0.2])
"""Centre above the procedural ground, metres."""
PIXEL = VIEW._core.least_pixel_angle
TOLERANCES = (0.25, 0.5, 1.0)

Array = NDArray[Any]


def users(center: Array, count: int) -> Array:
    """Eyes in the region, most of them at its border, where errors are greatest."""
    random = np.random.default_rng(0)
    aim = random.normal(size=(count, 3)) * [1, 0.2, 1]
    aim /= np.linalg.norm(aim, axis=1, keepdims=True)
    return np.asarray(center + REACH * random.uniform(0.5, 1, (count, 1)) ** 0.1 * aim)


def misses(triangles: Array, center: Array, eyes: Array) -> Array:
    """Greatest error of each triangle in the finest pixels of a 1080p view of 90°, at seven points for each eye."""
    weights = np.concatenate([(1 - np.eye(3)) / 2, np.full((1, 3), 1 / 3), np.eye(3) * 0.55 + 0.15])
    worst = np.zeros(len(triangles))
    for eye in eyes:
        morphing: dict[str, Any] = {"user": eye, "center": center, "r1": R1, "r2": R2}
        for part in np.array_split(np.arange(len(triangles)), len(triangles) // 100_000 + 1):
            worst[part] = np.maximum(worst[part], morph_errors(triangles[part], weights, morphing))
    return worst / PIXEL


def morph_errors(triangles: Array, weights: Array, settings: dict[str, Any]) -> Array:
    """Greatest angle in each triangle between morphed points and the same points interpolated from the morphed corners.

    The points are given by the weights (W, 3) of the triangle's corners.
    """
    points = np.einsum("wk,tkc->twc", weights, triangles)
    corners, exact = (
        nf.morph(places.reshape(-1, 3), **settings).reshape(places.shape) - settings["user"]
        for places in (triangles, points)
    )
    drawn = np.einsum("wk,tkc->twc", weights, corners)
    cross = np.linalg.norm(np.cross(drawn, exact), axis=2)
    return np.asarray(np.arctan2(cross, (drawn * exact).sum(axis=2)).max(axis=1))


def grid(length: float, extent: float = 60.0) -> Array:
    """Ground of right triangles with legs of a length in metres."""
    count = round(2 * extent / length)
    x, z = (v.ravel() * length - extent for v in np.meshgrid(np.arange(count), np.arange(count)))
    low = np.stack([x, np.zeros(len(x)), z], axis=1)
    right, down = np.array([length, 0, 0]), np.array([0, 0, length])
    return np.concatenate([np.stack([low, low + side, low + right + down], 1) for side in (down, right)])


def by_length() -> str:
    """Table of errors of unsplit triangles by the length of their legs, on ground 1.7 m below the eye."""
    rows = []
    for length in (0.5, 1.0, 2.0, 4.0, 8.0, 15.0, 30.0, 60.0):
        triangles = grid(length)
        error = misses(triangles, CENTER, users(CENTER, 12))
        error = error[error > 0]
        rows.append([length, len(triangles), error.max(), np.percentile(error, 95)])
    header = "leg, m {:g} | triangles of 120 m × 120 m {:,} | greatest error, px {:.2f}"
    header += " | 95th percentile of those that bend {:.2f}"
    return table("Vertex morph of ground without tessellation, users within 5 m", header, rows)


def surfaces(quick: bool) -> Iterator[tuple[str, nf.Scene, Array]]:
    """Yield two triangles, procedural streets, and Tokyo if its data exist."""
    yield "two triangles of ground, 8 km wide", nf.Scene.from_trimesh(ground()), CENTER
    city = nf.datasets.city(blocks=4 if quick else 12, seed=0, detail=2)
    low, high = city.bounds
    yield "procedural city", city, np.array([(low[0] + high[0]) / 2, 1.7, (low[2] + high[2]) / 2])
    for name, scene in scenes.present(*([] if quick else ["Tokyo core"])):
        yield name, scene, np.array([275.0, 1.7, -60.7])


def touching(scene: nf.Scene, center: Array) -> Array:
    """Static triangles in world coordinates that reach between the radii."""
    triangles = scene.triangles()[: scene._core.standing_triangle_count].astype(np.float64) + scene.origin
    radii = nf.triangle_radii(triangles, center=center)
    return np.asarray(triangles[(radii[:, 0] < R2) & (radii[:, 1] > R1)])


def scenes_by_tolerance(quick: bool) -> str:
    rows: list[list[object]] = []
    for name, scene, center in surfaces(quick):
        eyes = users(center, 4 if quick else 12)
        before = misses(touching(scene, center), center, eyes).max()
        rows.append([name, "none", scene.triangle_count, None, None, f"{before:.1f}", None])
        settings: dict[str, Any] = {"center": tuple(center), "radii": (R1, R2), "grown": None, "reach": REACH}
        for pixels in TOLERANCES:
            job = partial(nf._core.tessellate_scene, scene._core, settings | {"tolerance": pixels * PIXEL})
            split, counts = job()
            error = misses(touching(scene._derived(split, scene._load_placements), center), center, eyes).max()
            numbers = counts["after"], (counts["split"], counts["examined"]), best(job, repeat=3).ms
            rows.append([name, pixels, *numbers, error, error / pixels])
    header = "scene | tolerance, px {:g} | triangles {:,} | split of examined {:,} of {:,} | ms {:.0f}"
    header += " | greatest error, px {:.3f} | of the bound {:.2f}"
    return table(f"Tessellation, users within {REACH:g} m, r₁ = {R1:g}, r₂ = {R2:g} m", header, rows)


def against_peer(quick: bool) -> tuple[str, dict[str, list[tuple[int, float]]]]:
    """Table for ground of 120 m × 120 m: trimesh's subdivide_to_size until it reaches nearfar's measured error."""
    eyes, mesh = users(CENTER, 6), ground(60.0)
    rows: list[list[object]] = []
    curves: dict[str, list[tuple[int, float]]] = {"nearfar": [], "subdivide_to_size": []}

    def add(method: str, label: str, triangles: Array, spent: Timing) -> None:
        error = float(misses(triangles, CENTER, eyes).max())
        curves[method].append((len(triangles), error))
        rows.append([label, len(triangles), spent.ms, error])

    for pixels in (1.0, 4.0) if quick else (0.5, 1.0, 2.0, 4.0):
        settings: dict[str, Any] = {"center": CENTER, "r1": R1, "r2": R2, "user_region": REACH, "camera": VIEW}
        ours, spent = timed(nf.tessellate, mesh, tolerance_px=pixels, **settings)
        add("nearfar", f"nearfar, {pixels:g} px", np.asarray(ours.triangles), spent)
    for max_edge in (8.0, 4.0, 2.0) if quick else (8.0, 4.0, 2.0, 1.0, 0.5, 0.25):
        peer: dict[str, Any] = {"max_edge": max_edge, "max_iter": 30}
        (vertices, faces), spent = timed(trimesh.remesh.subdivide_to_size, mesh.vertices, mesh.faces, **peer)
        add("subdivide_to_size", f"trimesh subdivide_to_size, {max_edge:g} m", np.asarray(vertices[faces]), spent)
    header = "method | triangles {:,} | ms {:.0f} | greatest error, px {:.3f}"
    return table("Ground of 120 m × 120 m, two triangles, users within 5 m", header, rows), curves


def draw(curves: dict[str, list[tuple[int, float]]], path: Path) -> None:
    figure, axes = subplots(figsize=(6, 4))
    for name, points in curves.items():
        axes.loglog(*zip(*points, strict=True), marker="o", label=name)
    axes.set(xlabel="triangles", ylabel="greatest error, px", title="Ground of two triangles, users within 5 m")
    axes.grid(True, which="both", alpha=0.3)
    axes.legend()
    save_figure(figure, path)


def main() -> None:
    arguments = start(__doc__, "--quick", plot=(Path, "where to draw the error by the number of triangles"))
    print(by_length())
    print(scenes_by_tolerance(arguments.quick))
    text, curves = against_peer(arguments.quick)
    print(text)
    if arguments.plot is not None:
        draw(curves, arguments.plot)


if __name__ == "__main__":
    main()
