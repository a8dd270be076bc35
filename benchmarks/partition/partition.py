"""Run times of radii, partition and load curve of cities, compared with a copy and NumPy; triangles left by r2."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness.timing import best, machine, table
from benchmarks.harness.tokyo import whole
from nearfar._base import data

R1, R2 = 30.0, 50.0
RADII = (20.0, 30.0, 50.0, 100.0, 200.0, 500.0, 1000.0, 2000.0)
PUBLISHED = {30.0: "371", 50.0: "< 1,000"}
"""Triangles within each r2 in metres by Popescu et al. (2022), Manhattan with 3.7 million triangles."""


def numpy_zones(vertices: NDArray[np.float32], faces: NDArray[np.uint32]) -> NDArray[np.int64]:
    """Zones by the triangle's distance from the axis at 0, in whole-array float64."""
    plan = vertices[:, [0, 2]].astype(np.float64)[faces]
    following = np.roll(plan, -1, axis=1)
    edge = following - plan
    length = (edge**2).sum(-1)
    t = np.clip(-(plan * edge).sum(-1) / np.where(length > 0, length, 1), 0, 1)
    least = np.linalg.norm(plan + t[..., None] * edge, axis=-1).min(1)
    side = plan[..., 0] * following[..., 1] - plan[..., 1] * following[..., 0]
    least[(side > 0).all(1) | (side < 0).all(1)] = 0
    zones: NDArray[np.int64] = np.digitize(least, [R1, R2], right=True)
    return zones


def times(name: str, vertices: NDArray[np.float32], faces: NDArray[np.uint32]) -> str:
    """Table of all times, taken in one run, so that other programs slow all of them down alike."""
    scene = nf.Scene.from_arrays(vertices, faces)
    center = (0.0, 1.7, 0.0)
    copy = best(lambda: (np.copy(vertices), np.copy(faces)))
    radii = best(lambda: nf.triangle_radii(vertices, faces, center=center))
    partition = best(lambda: nf.partition(scene, center=center, r1=R1, r2=R2))
    wide = best(lambda: nf.partition(scene, center=center, r1=500, r2=2000))
    curve_time = best(lambda: nf.load_curve(scene, center=center), repeat=2)
    curve = nf.load_curve(scene, center=center)
    budgets = np.random.default_rng(0).integers(curve.count(0.0), curve.triangle_count, 1000)
    answers = best(lambda: curve.radius(budgets), repeat=20)
    part = slice(0, 1_000_000)
    peer = best(lambda: numpy_zones(vertices, faces[part]), repeat=1)
    scale = len(faces) / len(faces[part])
    jobs = [
        ("np.copy of vertices and faces", copy.wall, copy.cpu),
        ("triangle_radii", radii.wall, radii.cpu),
        ("partition at 30 / 50 m", partition.wall, partition.cpu),
        ("triangle_radii + partition (target: at most 3)", radii.wall + partition.wall, radii.cpu + partition.cpu),
        ("partition at 500 / 2,000 m", wide.wall, wide.cpu),
        ("load_curve", curve_time.wall, curve_time.cpu),
        ("LoadCurve.radius, 1,000 budgets", answers.wall, answers.cpu),
        ("NumPy, zones only (from 10⁶ triangles)", peer.wall * scale, peer.cpu * scale),
    ]
    rows = [[job, f"{wall * 1e3:.2f}", f"{cpu * 1e3:.2f}", f"{wall / copy.wall:.2f}"] for job, wall, cpu in jobs]
    return table(f"{name}: {len(faces):,} triangles", ["", "wall ms", "CPU ms", "wall / copy"], rows)


def triangles_left(scenes: list[tuple[str, nf.Scene]]) -> str:
    """Table of triangles that stay geometry around a place in each scene, and of the work needed."""
    header = ["r2, m", "Manhattan as published", *(f"{name}, {scene.triangle_count:,}" for name, scene in scenes)]
    centers = [np.zeros(3) if "Tokyo" in name else np.mean(scene.bounds, axis=0) for name, scene in scenes]
    counts = [
        np.atleast_1d(nf.load_curve(scene, center=center).count(RADII))
        for (_, scene), center in zip(scenes, centers, strict=True)
    ]
    rows = [[f"{r2:g}", PUBLISHED.get(r2, ""), *(f"{count[i]:,}" for count in counts)] for i, r2 in enumerate(RADII)]
    for label, key in (
        ("near", "near"),
        ("intermediate", "intermediate"),
        ("in both parts", "straddling"),
        ("measured", "measured"),
    ):
        row = [f"{label}, r1 = 30, r2 = 50", ""]
        for (_, scene), center in zip(scenes, centers, strict=True):
            row.append(f"{nf.partition(scene, center=center, r1=R1, r2=R2).summary()[key]:,}")
        rows.append(row)
    return table("Triangles left against r2, about Tokyo Station and the middle of the other scenes", header, rows)


def main() -> None:
    print(machine())
    scenes = []
    for name, path in (
        ("garage", "interior/garage/garage.gltf"),
        ("FlightHelmet", "objects/gltf/FlightHelmet/FlightHelmet.gltf"),
        ("Manhattan core", "city/manhattan_deckgl/manhattan_core.glb"),
        ("Tokyo core", "city/tokyo23/tokyo_core_lod1.glb"),
    ):
        file = data.find(path)
        if file is not None:
            scenes.append((name, nf.Scene.load(file)))
    city = whole()
    if city is not None:
        print(times("Whole Tokyo", *city))
        scenes.append(("whole Tokyo", nf.Scene.from_arrays(*city)))
    elif scenes:
        corners = scenes[-1][1].triangles().reshape(-1, 3)
        print(times(scenes[-1][0], corners, np.arange(len(corners), dtype=np.uint32).reshape(-1, 3)))
    if scenes:
        print(triangles_left(scenes))


if __name__ == "__main__":
    main()
