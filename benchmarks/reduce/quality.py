"""Image quality of the near–far methods: discontinuity, size of the map, and distance of the user from the centre."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

import nearfar as nf
from benchmarks.harness import scenes
from benchmarks.harness.pictures import similarity
from benchmarks.harness.report import save_figure, start, subplots, table
from benchmarks.harness.views import Point, center_for, views

VIEWS = 10

Points = Sequence[tuple[float, float, float]]
"""Position on the axis, PSNR in decibels and SSIM."""


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
    for name, scene in scenes.present(*([] if quick else ["Tokyo core", "Manhattan core"])):
        yield Case(name, scene, center_for(scene, 50.0), 30.0, 50.0)
    city = scenes.city(quick)
    for r1, r2 in ((30.0, 50.0), (10.0, 100.0)):
        yield Case("procedural city", city, nf.datasets.street_view()[0], r1, r2)


def measures(truth: nf.Frame, frame: nf.Frame, case: Case) -> list[float]:
    """Mean and 99th percentile of discontinuity, its absolute mean along the boundary, PSNR in decibels and SSIM."""
    comparison = nf.compare(truth, frame, center=case.center, radius=case.r2)
    torn = comparison.discontinuity, comparison.discontinuity_p99, comparison.boundary_discontinuity
    return [*(np.nan if value is None else value for value in torn), comparison.psnr, comparison.ssim]


def discontinuity(case: Case, size: tuple[int, int], plots: Path | None) -> str:
    reduced = case.reduce(1024, channels=("color", "range"))
    methods = {"conventional": reduced.with_morph("none"), "continuous": reduced}
    rows, all_values = [], []
    for number, camera in enumerate(views(reduced, size, VIEWS)):
        truth = nf.render(case.scene, camera, channels=("color",))
        frames = {name: light.render(camera, channels=("color", "position")) for name, light in methods.items()}
        values = [measures(truth, frame, case) for frame in frames.values()]
        all_values.append(values)
        rows.append([number + 1, np.linalg.norm(np.subtract(camera.position, case.center)), *zip(*values, strict=True)])
        if plots is not None and number == VIEWS - 1:
            draw_torn(truth, frames, case.label, plots / f"torn_{case.name.split()[0]}_{case.r2:g}.png")
    if not rows:
        return f"{case.label}: nothing ends at r2 in any view.\n"
    means = np.nanmean(np.array(all_values), axis=0)
    rows.append(["mean", None, *zip(*means, strict=True)])
    names = ("mean", "99th percentile", "along the boundary", "PSNR, dB", "SSIM")
    header = ["view", "m from O {:.1f}", *(f"{name} {{:.3g}} → {{:.3g}}" for name in names)]
    title = f"Discontinuity of {case.label}, conventional → continuous, {size[0]} × {size[1]}"
    return table(title, header, rows) + f"\nAlong the boundary: {means[0, 2] / means[1, 2]:.1f} times lower.\n"


def errors(case: Case, size: tuple[int, int], faces: list[int], plots: Path | None) -> str:
    """Tables: error of maps by size against the ideal picture, and of the ideal picture by the user's distance."""
    settings: dict[str, Any] = {"method": "exact", "channels": ("color",), "samples": 4}
    reduced = case.reduce(faces[0], channels=("color", "range"))
    camera = next(views(reduced, size, VIEWS), None)
    if camera is None:
        return f"{case.label}: nothing ends at r2 in any view.\n"
    ideal = reduced.render(camera, env=False, **settings)
    by_size, by_distance = [], []
    for face_size in faces:
        frame = case.reduce(face_size).render(camera, **settings)
        by_size.append((float(face_size), *similarity(ideal, frame)))
    for distance in (0.25, 0.5, 1.0, 2.0, 4.0, 8.0):
        step = np.subtract(camera.position, case.center)
        user = np.add(case.center, step / np.linalg.norm(step) * distance)
        user_camera = nf.Camera(tuple(user), camera.orientation, fov=camera.fov, size=size)
        truth = nf.render(case.scene, user_camera, samples=4, channels=("color",))
        frame = reduced.render(user_camera, env=False, **settings)
        by_distance.append((distance, *similarity(truth, frame)))
    if plots is not None:
        draw_errors(by_size, by_distance, case.label, plots / f"errors_{case.name.split()[0]}_{case.r2:g}.png")
    rows = [(f"map of 6 × {n:g}²", *quality) for n, *quality in by_size]
    rows += [(f"{away:g} m from O, no map", *quality) for away, *quality in by_distance]
    title = f"Errors of maps (against the picture without one) and of parallax (against the truth), {case.label}"
    return table(title, "what | PSNR, dB {:.2f} | SSIM {:.4f}", rows)


def draw_torn(truth: nf.Frame, frames: Mapping[str, nf.Frame], title: str, path: Path) -> None:
    """Draw the truth and each method's picture, and below them their discontinuity on one scale."""
    figure, axes = subplots(2, 1 + len(frames), figsize=(4.4 * (1 + len(frames)), 5.4))
    axes[0, 0].imshow(truth.to_image())
    axes[0, 0].set_title("truth")
    axes[1, 0].remove()
    image: Any = None
    for column, (name, frame) in enumerate(frames.items(), start=1):
        axes[0, column].imshow(frame.to_image())
        axes[0, column].set_title(name)
        torn = np.abs(nf.metrics.discontinuity(frame))
        image = axes[1, column].imshow(np.clip(torn, 0.0, 4.0), cmap="inferno", vmin=0.0, vmax=4.0)
        axes[1, column].set_title(f"its discontinuity, mean {np.nanmean(torn):.2f}")
    figure.colorbar(image, ax=axes[1, :].tolist()[1:], shrink=0.8, label="|δ|")
    for axis in axes.flat:
        axis.set(xticks=[], yticks=[])
    figure.suptitle(title)
    save_figure(figure, path, dpi=90)


def draw_errors(by_size: Points, by_distance: Points, title: str, path: Path) -> None:
    """Draw the error of maps by size and the error of parallax by distance side by side, on one scale."""
    figure, axes = subplots(1, 2, figsize=(8.0, 3.6), sharey=True)
    for axis, points, label in (
        (axes[0], by_size, "texels across a face of the map"),
        (axes[1], by_distance, "metres from the centre"),
    ):
        positions, psnr, _ = zip(*points, strict=True)
        axis.plot(positions, psnr, marker="o")
        axis.set_xscale("log", base=2)
        axis.set_xticks(positions, [f"{value:g}" for value in positions])
        axis.minorticks_off()
        axis.set_xlabel(label)
        axis.grid(visible=True, alpha=0.3)
    axes[0].set(ylabel="PSNR, dB", title="the map, against no map")
    axes[1].set_title("parallax, against the truth")
    figure.suptitle(title)
    save_figure(figure, path)


def main() -> None:
    arguments = start(__doc__, "--quick", "--plots")
    size = (240, 136) if arguments.quick else (960, 540)
    for case in cases(arguments.quick):
        print(discontinuity(case, size, arguments.plots), flush=True)
        print(errors(case, size, [64, 128] if arguments.quick else [256, 512, 1024, 2048, 4096], arguments.plots))


if __name__ == "__main__":
    main()
