"""What the near-far methods cost in image quality: discontinuity, map sizes, and not being at the centre.

python benchmarks/near_far.py [--quick]
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from _measure import machine, table
from nearfar import _data
from nearfar.cli._place import choose

R1, R2 = 30.0, 50.0
VIEWS = 10
GOLDEN = 0.381966
"""Of a turn: directions that never repeat."""

Point = tuple[float, float, float]


def scenes(quick: bool) -> Iterator[tuple[str, nf.Scene, Point]]:
    """The cities that there are, with an open place in each."""
    for name, file in (
        ("tokyo_core_lod1", "city/tokyo23/tokyo_core_lod1.glb"),
        ("Manhattan", "city/manhattan_deckgl/manhattan_core.glb"),
    ):
        if not quick and (path := _data.find(file)) is not None:
            scene = nf.Scene.load(path)
            yield name, scene, choose(scene, name).eye
    city = nf.datasets.city(blocks=3, detail=0) if quick else nf.datasets.city()
    yield "procedural city", city, nf.datasets.street_view()[0]


def views(scene: nf.Scene, center: Point, size: tuple[int, int]) -> Iterator[nf.Camera]:
    """Users 5 to 8 m from the centre all around it who look across the way they went, where nothing is within 2 m."""
    found = 0
    for k in range(100):
        turn = 2.0 * np.pi * GOLDEN * k
        away = np.array([np.cos(turn), 0.0, np.sin(turn)])
        across = np.array([-np.sin(turn), -0.02, np.cos(turn)]) * (1 if k % 2 else -1)
        user = np.add(center, away * (5.0 + 3.0 * found / (VIEWS - 1)))
        around = np.stack([away, -away, across, -across])
        free = nf.cast_rays(scene, np.tile(user, (4, 1)), around).t_hit.min() > 2.0
        between = nf.cast_rays(scene, np.array([center]), away[None]).t_hit[0] > np.linalg.norm(user - center)
        if free and between:
            found += 1
            yield nf.Camera.look_at(user, user + across, fov=nf.Fov.symmetric(90, size[0] / size[1]), size=size)
        if found == VIEWS:
            return


def measures(truth: nf.Frame, frame: nf.Frame, center: Point) -> list[float]:
    """Mean and 99th percentile of discontinuity, its absolute mean along the boundary, PSNR and SSIM."""
    torn = nf.discontinuity(frame)
    edge = nf.boundary(frame, center=center, radius=R2) & ~np.isnan(torn)
    along = float(np.abs(torn[edge]).mean()) if edge.sum() >= 100 else np.nan
    return [
        float(np.nanmean(torn)),
        float(np.nanpercentile(torn, 99)),
        along,
        nf.psnr(truth, frame),
        nf.ssim(truth, frame),
    ]


def discontinuity(name: str, scene: nf.Scene, center: Point, size: tuple[int, int]) -> str:
    """Both methods in ten views, and their means."""
    reduced = nf.reduce(scene, center=center, r1=R1, r2=R2, channels=("color", "range"))
    methods = {"conventional": reduced.with_morph("none"), "continuous": reduced}
    rows, all_values = [], []
    for number, camera in enumerate(views(scene, center, size)):
        truth = nf.render(scene, camera, channels=("color",))
        values = [
            measures(truth, light.render(camera, channels=("color", "position")), center) for light in methods.values()
        ]
        all_values.append(values)
        away = np.linalg.norm(np.subtract(camera.position, center))
        rows.append([f"{number + 1}", f"{away:.1f}", *_pairs(np.array(values))])
    # A view without a boundary has no value along it.
    means = np.ma.masked_invalid(all_values).mean(axis=0).filled(np.nan)
    rows.append(["mean", "", *_pairs(means)])
    header = ["view", "m from O", "mean", "99th percentile", "along the boundary", "PSNR, dB", "SSIM"]
    title = f"Discontinuity of {name}, conventional → continuous, {size[0]} × {size[1]}"
    ratio = means[0, 2] / means[1, 2]
    said = f"{ratio:.1f} times lower" if np.isfinite(ratio) else "nothing: no near part ends in these views"
    return table(title, header, rows) + f"\nAlong the boundary: {said}.\n"


def _pairs(values: NDArray[np.float64]) -> list[str]:
    return [f"{a:.3g} → {b:.3g}" for a, b in values.T]


def sizes(name: str, scene: nf.Scene, center: Point, size: tuple[int, int], faces: list[int]) -> str:
    """Error of maps by size against the ideal picture, and of that against the truth by the user's distance."""
    rows = []
    fov = nf.Fov.symmetric(90, size[0] / size[1])
    camera = next(iter(views(scene, center, size)))
    how: dict[str, Any] = {"method": "exact", "channels": ("color",), "samples": 4}
    ideal = None
    for face_size in faces:
        reduced = nf.reduce(scene, center=center, r1=R1, r2=R2, face_size=face_size)
        ideal = reduced.render(camera, env=False, **how) if ideal is None else ideal
        frame = reduced.render(camera, **how)
        rows.append([f"map of 6 × {face_size}²", f"{nf.psnr(ideal, frame):.2f}", f"{nf.ssim(ideal, frame):.4f}"])
    for away in (0.25, 0.5, 1.0, 2.0, 4.0, 8.0):
        step = np.subtract(camera.position, center)
        user = np.add(center, step / np.linalg.norm(step) * away)
        moved = nf.Camera(tuple(user), camera.orientation, fov=fov, size=size)
        truth = nf.render(scene, moved, samples=4, channels=("color",))
        frame = reduced.render(moved, env=False, **how)
        rows.append([f"{away:g} m from O, no map", f"{nf.psnr(truth, frame):.2f}", f"{nf.ssim(truth, frame):.4f}"])
    title = f"Errors of maps (against the picture without one) and of parallax (against the truth), {name}"
    return table(title, ["what", "PSNR, dB", "SSIM"], rows)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="one small scene and small pictures")
    quick = parser.parse_args().quick
    size = (240, 136) if quick else (960, 540)
    print(machine(), end="\n\n")
    for name, scene, center in scenes(quick):
        print(discontinuity(name, scene, center, size))
        print(sizes(name, scene, center, size, [64, 128] if quick else [256, 512, 1024, 2048, 4096]))


if __name__ == "__main__":
    main()
