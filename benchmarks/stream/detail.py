"""Bytes saved in a bundle by cutting textures by distance and by levels of detail, and the change of pictures.

python -m benchmarks.stream.detail
"""

from __future__ import annotations

import math
import tempfile
from pathlib import Path
from typing import Any

import numpy as np

import nearfar as nf
from benchmarks.harness.timing import machine, table
from benchmarks.lod.scene import model, places
from nearfar._base import data

HELMET = "objects/gltf/FlightHelmet/FlightHelmet.gltf"
HEIGHT = 0.8
"""Height of the displayed model, metres."""

DISTANCES = (2.0, 5.0, 10.0, 20.0, 39.0)
"""Metres from the centre to the object."""

RADII, REACH, PIXELS = (10.0, 40.0), 1.0, 25.0
SETTINGS: dict[str, Any] = {"radii": RADII, "face_size": 256}


def bytes_of(bundle: nf.stream.Bundle, kind: str) -> int:
    """Bytes of all files of a kind, by suffix."""
    return sum(len(bundle.read(name)) for name in parts_of(bundle) if name.endswith(kind))


def parts_of(bundle: nf.stream.Bundle) -> set[str]:
    """Files of the geometry: GLBs, buffers and textures."""
    rings = bundle._rings
    return {name for ring in rings for name in (ring["geometry"], *ring["parts"]) if name is not None}


def cut(scene: nf.Scene, distance: float, folder: Path) -> list[str]:
    """Bytes of the helmet's textures whole and cut, and the change of its picture for the nearest user."""
    center = (0.0, 0.4, distance)
    whole, small = (
        nf.stream.export(scene, folder / name, center=center, **SETTINGS, pixels_per_degree=value)
        for name, value in (("whole", None), ("cut", PIXELS))
    )
    degrees = 2.0 * math.degrees(math.atan(HEIGHT / 2.0 / (distance - REACH)))
    view = nf.Camera.look_at(
        (0.0, 0.4, distance - REACH),
        (0.0, 0.36, 0.0),
        fov=nf.Fov.symmetric(degrees),
        size=(round(PIXELS * degrees),) * 2,
    )
    pictures = [bundle.at(2, RADII[0]).render(view, samples=16) for bundle in (whole, small)]
    before, after = bytes_of(whole, "webp"), bytes_of(small, "webp")
    quality = [f"{nf.psnr(*pictures):.1f}", f"{nf.ssim(*pictures):.5f}"]
    return [f"{distance:g}", f"{before / 1e3:.1f}", f"{after / 1e3:.1f}", f"{1 - after / before:.0%}", *quality]


def in_room(folder: Path) -> list[str]:
    """Bytes of the textures of the room, whole and cut."""
    room, center = nf.datasets.room(), (0.0, 1.6, 0.0)
    sizes = []
    for value in (None, PIXELS):
        bundle = nf.stream.export(room, folder / "room", center=center, **SETTINGS, pixels_per_degree=value)
        sizes.append(f"{bytes_of(bundle, 'webp') / 1e3:.1f}")
    return sizes


def levels(folder: Path) -> list[list[str]]:
    """Triangles and bytes of a thousand objects in a ball of 20 m, by selection method."""
    random = np.random.default_rng(0)
    models = [model(seed) for seed in range(8)]
    placed = places(random)
    scene = nf.lod.place(models, np.arange(len(placed)) % len(models), placed)
    rows = []
    for lod in (None, "depth"):
        bundle = nf.stream.export(scene, folder / "balls", center=(0.0, 0.0, 0.0), **SETTINGS, lod=lod)
        drawn = sum(row["triangles"] for row in bundle.summary())
        size = sum(len(bundle.read(name)) for name in parts_of(bundle))
        rows.append([str(lod), f"{drawn:,}", f"{size / 1e6:.2f}"])
    return rows


def main() -> None:
    print(machine())
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder)
        helmet = nf.Scene.load(data.require(HELMET))
        rows = [cut(helmet, distance, place) for distance in DISTANCES]
        header = ["metres", "textures, kB", "cut, kB", "saved", "PSNR, dB", "SSIM"]
        print(table("FlightHelmet's textures", header, rows))
        print(table("textures of the room, kB", ["whole", "cut"], [in_room(place)]))
        print(table("levels", ["lod", "triangles", "geometry, MB"], levels(place)))


if __name__ == "__main__":
    main()
