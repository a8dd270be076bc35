"""Image quality of the near–far methods: discontinuity, size of the map, and distance of the user from the centre.

python -m benchmarks.reduce.quality [--quick] [--plots FOLDER]
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness.pictures import draw_errors, draw_torn
from benchmarks.harness.timing import machine, table
from benchmarks.harness.views import Point, center_for, views
from nearfar._base import data

VIEWS = 10


@dataclass(frozen=True)
class Case:
    """A scene and the centre and radii of its reduction."""

    name: str
    scene: nf.Scene
    center: Point
    r1: float
    r2: float

    @property
    def label(self) -> str:
        """Label for titles."""
        return f"{self.name}, r1 = {self.r1:g} m, r2 = {self.r2:g} m"

    def reduce(self, face_size: int, **how: Any) -> nf.ReducedScene:
        """Reduce the scene with a map of a size."""
        return nf.reduce(self.scene, center=self.center, r1=self.r1, r2=self.r2, face_size=face_size, **how)


def cases(quick: bool) -> Iterator[Case]:
    """Yield the available cities, each with a centre around which surfaces cross r2.

    A user at the distance |U−O| sees the ground between the radii sheared by |U−O| r1 / ((r2−r1) h) pixels per pixel,
    where h is the height of the eyes. So the procedural city, which has a ground, is measured for two pairs of radii.
    """
    for name, file in (
        ("tokyo_core_lod1", "city/tokyo23/tokyo_core_lod1.glb"),
        ("Manhattan", "city/manhattan_deckgl/manhattan_core.glb"),
    ):
        if not quick and (path := data.find(file)) is not None:
            scene = nf.Scene.load(path)
            yield Case(name, scene, center_for(scene, 50.0), 30.0, 50.0)
    city = nf.datasets.city(blocks=3, detail=0) if quick else nf.datasets.city()
    for r1, r2 in ((30.0, 50.0), (10.0, 100.0)):
        yield Case("procedural city", city, nf.datasets.street_view()[0], r1, r2)


def measures(truth: nf.Frame, frame: nf.Frame, case: Case) -> list[float]:
    """Mean and 99th percentile of discontinuity, its absolute mean along the boundary, PSNR in decibels and SSIM."""
    comparison = nf.compare(truth, frame, center=case.center, radius=case.r2)
    torn = [
        np.nan if v is None else v
        for v in (comparison.discontinuity, comparison.discontinuity_p99, comparison.boundary_discontinuity)
    ]
    return [*torn, comparison.psnr, comparison.ssim]


def discontinuity(case: Case, size: tuple[int, int], plots: Path | None) -> str:
    """Table of both methods in ten views, and their means."""
    reduced = case.reduce(1024, channels=("color", "range"))
    methods = {"conventional": reduced.with_morph("none"), "continuous": reduced}
    rows, all_values = [], []
    for number, camera in enumerate(views(reduced, size, VIEWS)):
        truth = nf.render(case.scene, camera, channels=("color",))
        frames = {name: light.render(camera, channels=("color", "position")) for name, light in methods.items()}
        values = [measures(truth, frame, case) for frame in frames.values()]
        all_values.append(values)
        away = np.linalg.norm(np.subtract(camera.position, case.center))
        rows.append([f"{number + 1}", f"{away:.1f}", *_pairs(np.array(values))])
        if plots is not None and number == VIEWS - 1:
            draw_torn(truth, frames, case.label, plots / f"torn_{case.name.split()[0]}_{case.r2:g}.png")
    if not rows:
        return f"{case.label}: nothing ends at r2 in any view.\n"
    means = np.nanmean(np.array(all_values), axis=0)
    rows.append(["mean", "", *_pairs(means)])
    header = ["view", "m from O", "mean", "99th percentile", "along the boundary", "PSNR, dB", "SSIM"]
    title = f"Discontinuity of {case.label}, conventional → continuous, {size[0]} × {size[1]}"
    return table(title, header, rows) + f"\nAlong the boundary: {means[0, 2] / means[1, 2]:.1f} times lower.\n"


def _pairs(values: NDArray[np.float64]) -> list[str]:
    return [f"{a:.3g} → {b:.3g}" for a, b in values.T]


def errors(case: Case, size: tuple[int, int], faces: list[int], plots: Path | None) -> str:
    """Tables: error of maps by size against the ideal picture, and of the ideal picture by the user's distance."""
    how: dict[str, Any] = {"method": "exact", "channels": ("color",), "samples": 4}
    reduced = case.reduce(faces[0], channels=("color", "range"))
    camera = next(views(reduced, size, VIEWS), None)
    if camera is None:
        return f"{case.label}: nothing ends at r2 in any view.\n"
    ideal = reduced.render(camera, env=False, **how)
    by_size, by_distance = [], []
    for face_size in faces:
        frame = case.reduce(face_size).render(camera, **how)
        by_size.append((float(face_size), nf.psnr(ideal, frame), nf.ssim(ideal, frame)))
    for away in (0.25, 0.5, 1.0, 2.0, 4.0, 8.0):
        step = np.subtract(camera.position, case.center)
        user = np.add(case.center, step / np.linalg.norm(step) * away)
        moved = nf.Camera(tuple(user), camera.orientation, fov=camera.fov, size=size)
        truth = nf.render(case.scene, moved, samples=4, channels=("color",))
        frame = reduced.render(moved, env=False, **how)
        by_distance.append((away, nf.psnr(truth, frame), nf.ssim(truth, frame)))
    if plots is not None:
        draw_errors(by_size, by_distance, case.label, plots / f"errors_{case.name.split()[0]}_{case.r2:g}.png")
    rows = [[f"map of 6 × {n:g}²", f"{psnr:.2f}", f"{ssim:.4f}"] for n, psnr, ssim in by_size]
    rows += [[f"{away:g} m from O, no map", f"{psnr:.2f}", f"{ssim:.4f}"] for away, psnr, ssim in by_distance]
    title = f"Errors of maps (against the picture without one) and of parallax (against the truth), {case.label}"
    return table(title, ["what", "PSNR, dB", "SSIM"], rows)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="one small scene and small pictures")
    parser.add_argument("--plots", type=Path, help="folder for pictures and plots")
    arguments = parser.parse_args()
    if arguments.plots is not None:
        arguments.plots.mkdir(parents=True, exist_ok=True)
    size = (240, 136) if arguments.quick else (960, 540)
    print(machine(), end="\n\n")
    for case in cases(arguments.quick):
        print(discontinuity(case, size, arguments.plots), flush=True)
        print(errors(case, size, [64, 128] if arguments.quick else [256, 512, 1024, 2048, 4096], arguments.plots))


if __name__ == "__main__":
    main()
