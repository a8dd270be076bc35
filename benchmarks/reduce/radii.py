"""The published radii against those chosen by the ground: PSNR, SSIM and tear for ten users."""

from __future__ import annotations

import numpy as np

import nearfar as nf
from benchmarks.harness import scenes
from benchmarks.harness.pictures import similarity
from benchmarks.harness.report import start, table
from benchmarks.harness.views import views
from nearfar._camera.density import with_density

USERS = 10
R1, R2 = 30.0, 50.0
DENSITY = 20.0
"""Density in pixels per degree at which tears are measured."""


def measures(reduced: nf.ReducedScene, view: nf.Camera, truth: nf.Frame) -> list[float]:
    """PSNR in decibels and SSIM of a picture, its mean tear along r2 in pixels, and its share that is a kink."""
    frame = reduced.render(view, channels=("color",), method="exact")
    positions = reduced.render(with_density(view, DENSITY), channels=("position",), method="exact", env=False)
    torn = nf.metrics.boundary_tear(positions, center=reduced.center, radius=reduced.r2)
    return [*similarity(truth, frame), torn.tear or 0.0, torn.kink or 0.0]


def compare(scene: nf.Scene, size: tuple[int, int], users: int) -> str:
    center = nf.datasets.street_view()[0]
    published = nf.reduce(scene, center=center, r1=R1, r2=R2)
    by_ground = published.with_r1(nf.choose_radii(scene, center, r2=R2).r1)
    rows, values = [], []
    for number, view in enumerate(views(published, size, users), start=1):
        truth = nf.render(scene, view, channels=("color",))
        values.append([measures(reduced, view, truth) for reduced in (published, by_ground)])
        rows.append([number, *zip(*values[-1], strict=True)])
    rows.append(["mean", *zip(*np.mean(values, axis=0), strict=True)])
    names = ("PSNR, dB", "SSIM", "tear, px", "of which kink, px")
    header = ["user", *(f"{name} {{:.3g}} → {{:.3g}}" for name in names)]
    counts = " and ".join(f"{reduced.stats['drawn']:,}" for reduced in (published, by_ground))
    title = (
        f"Continuous pictures with r₁ = {R1:g} m → {by_ground.r1:.3g} m, r₂ = {R2:g} m; {counts} triangles are drawn"
    )
    return table(title, header, rows)


def main() -> None:
    quick = start(__doc__, "--quick").quick
    print(compare(scenes.city(quick), (240, 136) if quick else (960, 540), 2 if quick else USERS))


if __name__ == "__main__":
    main()
