"""Bytes saved in a bundle by cutting textures by distance and by levels of detail, and the change of pictures."""

from __future__ import annotations

import math
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

import nearfar as nf
from benchmarks.harness import scenes
from benchmarks.harness.pictures import similarity
from benchmarks.harness.report import folder_or_temporary, start, table
from benchmarks.lod.scene import model, places
from nearfar._base import data
from nearfar.stream._manifest import geometry_files

HEIGHT = 0.8
"""Height of the displayed model, metres."""

DISTANCES = (2.0, 5.0, 10.0, 20.0, 39.0)
"""Metres from the centre to the object."""

RADII, REACH, PIXELS = (10.0, 40.0), 1.0, 25.0
SETTINGS: dict[str, Any] = {"radii": RADII, "face_size": 256}


def bytes_of(bundle: nf.stream.Bundle, suffix: str = "") -> int:
    """Bytes of the geometry's files with a suffix: GLBs, buffers and textures."""
    names = {name for ring in bundle._rings for name in geometry_files(ring)}
    return sum(len(bundle.read(name)) for name in names if name.endswith(suffix))


def texture_row(scene: nf.Scene, distance: float, folder: Path) -> list[float]:
    """Bytes of the helmet's textures whole and cut, and the change of its picture for the nearest user."""
    full, cut = (
        nf.stream.export(scene, folder / str(value), center=(0.0, 0.4, distance), **SETTINGS, pixels_per_degree=value)
        for value in (None, PIXELS)
    )
    degrees = 2.0 * math.degrees(math.atan(HEIGHT / 2.0 / (distance - REACH)))
    size, fov = (round(PIXELS * degrees),) * 2, nf.Fov.symmetric(degrees)
    view = nf.Camera.look_at((0.0, 0.4, distance - REACH), (0.0, 0.36, 0.0), fov=fov, size=size)
    frames = [bundle.at(2, RADII[0]).render(view, samples=16) for bundle in (full, cut)]
    before, after = bytes_of(full, "webp"), bytes_of(cut, "webp")
    return [distance, before / 1e3, after / 1e3, 1 - after / before, *similarity(*frames)]


def levels(folder: Path) -> list[list[object]]:
    """Triangles and bytes of a thousand objects in a ball of 20 m, by selection method."""
    models, matrices = [model(seed) for seed in range(8)], places(np.random.default_rng(0))
    scene = nf.lod.place(models, np.arange(len(matrices)) % len(models), matrices)
    rows: list[list[object]] = []
    for lod in (None, "depth"):
        bundle = nf.stream.export(scene, folder / "balls", center=(0.0, 0.0, 0.0), **SETTINGS, lod=lod)
        rows.append([str(lod), sum(row["triangles"] for row in bundle.summary()), bytes_of(bundle) / 1e6])
    return rows


def main() -> None:
    start(__doc__)
    with folder_or_temporary() as folder:
        helmet = nf.Scene.load(data.require(scenes.FILES["FlightHelmet"]))
        rows = [texture_row(helmet, distance, folder) for distance in DISTANCES]
        header = "metres {:g} | textures, kB {:.1f} | cut, kB {:.1f} | saved {:.0%} | PSNR, dB {:.1f} | SSIM {:.5f}"
        print(table("FlightHelmet's textures", header, rows))
        export = partial(nf.stream.export, nf.datasets.room(), folder / "room", center=(0.0, 1.6, 0.0), **SETTINGS)
        sizes = [bytes_of(export(pixels_per_degree=value), "webp") / 1e3 for value in (None, PIXELS)]
        print(table("textures of the room, kB", "whole {:.1f} | cut {:.1f}", [sizes]))
        print(table("levels", "lod | triangles {:,} | geometry, MB {:.2f}", levels(folder)))


if __name__ == "__main__":
    main()
