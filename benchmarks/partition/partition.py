"""Run times of radii, partition and load curve, compared with a copy and NumPy; near triangles for several r2."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness import scenes
from benchmarks.harness.report import start, table
from benchmarks.harness.timing import Timing, best
from benchmarks.harness.tokyo import load_arrays

R1, R2 = 30.0, 50.0
RADII = (20.0, 30.0, 50.0, 100.0, 200.0, 500.0, 1000.0, 2000.0)
PUBLISHED = {30.0: "371", 50.0: "< 1,000"}
"""Triangles within each r2 in metres by Popescu et al. (2022), Manhattan with 3.7 million triangles."""


def numpy_zones(vertices: NDArray[np.float32], faces: NDArray[np.uint32]) -> NDArray[np.int64]:
    """Zones by the triangle's distance from the axis at 0, in whole-array float64."""
    plan = vertices[:, [0, 2]].astype(np.float64)[faces]
    next_corners = np.roll(plan, -1, axis=1)
    edge = next_corners - plan
    length = (edge**2).sum(-1)
    t = np.clip(-(plan * edge).sum(-1) / np.where(length > 0, length, 1), 0, 1)
    distances = np.linalg.norm(plan + t[..., None] * edge, axis=-1).min(1)
    side = plan[..., 0] * next_corners[..., 1] - plan[..., 1] * next_corners[..., 0]
    distances[(side > 0).all(1) | (side < 0).all(1)] = 0
    return np.asarray(np.digitize(distances, [R1, R2], right=True))


def times(name: str, vertices: NDArray[np.float32], faces: NDArray[np.uint32]) -> str:
    """Table of all times, measured in one run, so that other programs affect all of them equally."""
    scene = nf.Scene.from_arrays(vertices, faces)
    center = (0.0, 1.7, 0.0)
    copy = best(lambda: (np.copy(vertices), np.copy(faces)))
    radii = best(lambda: nf.triangle_radii(vertices, faces, center=center))
    partition = best(lambda: nf.partition(scene, center=center, r1=R1, r2=R2))
    wide_partition = best(lambda: nf.partition(scene, center=center, r1=500, r2=2000))
    curve_time = best(lambda: nf.load_curve(scene, center=center), repeat=2)
    curve = nf.load_curve(scene, center=center)
    budgets = np.random.default_rng(0).integers(curve.count(0.0), curve.triangle_count, 1000)
    first_faces = slice(0, 1_000_000)
    peer = best(lambda: numpy_zones(vertices, faces[first_faces]), repeat=1)
    scale = len(faces) / len(faces[first_faces])
    sum_of_both = Timing(radii.wall + partition.wall, radii.cpu + partition.cpu)
    jobs = {
        "np.copy of vertices and faces": copy,
        "triangle_radii": radii,
        "partition at 30 / 50 m": partition,
        "triangle_radii + partition (target: at most 3)": sum_of_both,
        "partition at 500 / 2,000 m": wide_partition,
        "load_curve": curve_time,
        "LoadCurve.radius, 1,000 budgets": best(lambda: curve.radius(budgets), repeat=20),
        "NumPy, zones only (from 10⁶ triangles)": Timing(peer.wall * scale, peer.cpu * scale),
    }
    rows = [(job, time.ms, time.cpu_ms, time.wall / copy.wall) for job, time in jobs.items()]
    return table(f"{name}: {len(faces):,} triangles", " | wall ms {:.2f} | CPU ms {:.2f} | wall / copy {:.2f}", rows)


def triangles_left(loaded: list[tuple[str, nf.Scene]]) -> str:
    """Table of triangles that stay geometry around a place in each scene, and of the work needed."""
    names = (f"{name}, {scene.triangle_count:,} {{:,}}" for name, scene in loaded)
    centers = [np.zeros(3) if "Tokyo" in name else np.mean(scene.bounds, axis=0) for name, scene in loaded]
    scenes_and_centers = [(scene, center) for (_, scene), center in zip(loaded, centers, strict=True)]
    counts = [np.atleast_1d(nf.load_curve(scene, center=center).count(RADII)) for scene, center in scenes_and_centers]
    rows = [[f"{r2:g}", PUBLISHED.get(r2), *(count[i] for count in counts)] for i, r2 in enumerate(RADII)]
    summaries = [nf.partition(scene, center=center, r1=R1, r2=R2).summary() for scene, center in scenes_and_centers]
    labels = {"near": "near", "intermediate": "intermediate", "straddling": "in both parts", "measured": "measured"}
    rows += [[f"{labels[key]}, r1 = 30, r2 = 50", None, *(part[key] for part in summaries)] for key in labels]
    header = ["r2, m", "Manhattan as published", *names]
    return table("Triangles left against r2, about Tokyo Station and the middle of the other scenes", header, rows)


def main() -> None:
    start(__doc__)
    loaded = list(scenes.present("garage", "FlightHelmet", "Manhattan core", "Tokyo core"))
    city = load_arrays()
    if city is not None:
        print(times("Whole Tokyo", *city))
        loaded.append(("whole Tokyo", nf.Scene.from_arrays(*city)))
    elif loaded:
        corners = loaded[-1][1].triangles().reshape(-1, 3)
        print(times(loaded[-1][0], corners, np.arange(len(corners), dtype=np.uint32).reshape(-1, 3)))
    if loaded:
        print(triangles_left(loaded))


if __name__ == "__main__":
    main()
