"""The published radii against those chosen by the ground: PSNR, SSIM and tear for ten users.

python -m benchmarks.reduce.radii [--quick]
"""

from __future__ import annotations

import argparse
from dataclasses import replace

import numpy as np

import nearfar as nf
from benchmarks.harness.timing import machine, table
from benchmarks.harness.views import views

USERS = 10
R1, R2 = 30.0, 50.0
DENSITY = 20.0
"""Density in pixels per degree at which tears are measured."""


def dense(view: nf.Camera) -> nf.Camera:
    """The same view with the density `DENSITY`."""
    assert isinstance(view.fov, nf.Fov)
    more = DENSITY / np.radians(view.width / (view.fov.right - view.fov.left))
    return replace(view, size=(round(view.width * more), round(view.height * more)))


def measures(reduced: nf.ReducedScene, view: nf.Camera, truth: nf.Frame) -> list[float]:
    """PSNR in decibels and SSIM of a picture, its mean tear along r2 in pixels, and its share that is a kink."""
    frame = reduced.render(view, channels=("color",), method="exact")
    placed = reduced.render(dense(view), channels=("position",), method="exact", env=False)
    torn = nf.metrics.boundary_tear(placed, center=reduced.center, radius=reduced.r2)
    return [nf.psnr(truth, frame), nf.ssim(truth, frame), torn.tear or 0.0, torn.kink or 0.0]


def compare(scene: nf.Scene, size: tuple[int, int], users: int) -> str:
    """Table of both pairs of radii, user by user, and their means."""
    center = nf.datasets.street_view()[0]
    published = nf.reduce(scene, center=center, r1=R1, r2=R2)
    chosen = published.with_r1(nf.choose_radii(scene, center, r2=R2).r1)
    rows, values = [], []
    for number, view in enumerate(views(published, size, users), start=1):
        truth = nf.render(scene, view, channels=("color",))
        values.append([measures(reduced, view, truth) for reduced in (published, chosen)])
        rows.append([f"{number}", *_pairs(np.array(values[-1]))])
    rows.append(["mean", *_pairs(np.mean(values, axis=0))])
    header = ["user", "PSNR, dB", "SSIM", "tear, px", "of which kink, px"]
    drawn = " and ".join(f"{one.stats['drawn']:,}" for one in (published, chosen))
    title = f"Continuous pictures with r₁ = {R1:g} m → {chosen.r1:.3g} m, r₂ = {R2:g} m; {drawn} triangles are drawn"
    return table(title, header, rows)


def _pairs(values: np.ndarray[tuple[int, ...], np.dtype[np.float64]]) -> list[str]:
    return [f"{a:.3g} → {b:.3g}" for a, b in values.T]


def main() -> None:
    """Print the table of the procedural city."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="a small city, small pictures, two users")
    quick = parser.parse_args().quick
    print(machine(), end="\n\n")
    scene = nf.datasets.city(blocks=3, detail=0) if quick else nf.datasets.city()
    print(compare(scene, (240, 136) if quick else (960, 540), 2 if quick else USERS))


if __name__ == "__main__":
    main()
