"""Scenes that several benchmarks measure: files of the data folder by name, and procedural cities."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import nearfar as nf
from nearfar._base import data

FILES = {
    "Tokyo core": "city/tokyo23/tokyo_core_lod1.glb",
    "Manhattan core": "city/manhattan_deckgl/manhattan_core.glb",
    "FlightHelmet": "objects/gltf/FlightHelmet/FlightHelmet.gltf",
    "Duck": "objects/gltf/Duck.glb",
    "garage": "interior/garage/garage.gltf",
    "armadillo": "objects/armadillo.obj",
    "bunny": "objects/bun_zipper.ply",
}
"""Paths below the data folder."""


def path_of(name: str) -> Path | None:
    """Path of a file by name; None if it is missing."""
    return data.find(FILES[name])


def load(name: str) -> nf.Scene | None:
    """Load a scene by name; None if its file is missing."""
    path = path_of(name)
    return None if path is None else nf.Scene.load(path)


def present(*names: str) -> Iterator[tuple[str, nf.Scene]]:
    """Yield names and scenes of the files that are present."""
    for name in names:
        if (scene := load(name)) is not None:
            yield name, scene


def city(quick: bool) -> nf.Scene:
    """Make the procedural city, or a small one."""
    return nf.datasets.city(blocks=3, detail=0) if quick else nf.datasets.city()
