"""Writes the quads of impostors as a plain GLB."""

from __future__ import annotations

import os
from typing import Literal, Protocol, get_args

import numpy as np

from nearfar._base import check, files
from nearfar._impostor.quads import Point, Quads

Textures = Literal["webp", "png"]
"""Kind of image in a file of impostors."""

QUALITY = 80
"""Quality of WebP, 0 to 100."""

EXTRAS_KEY = "nearfar"


class Region(Protocol):
    """Region of users that the quads are made for."""

    @property
    def center(self) -> Point: ...
    @property
    def reach(self) -> float: ...
    @property
    def r2(self) -> float: ...
    @property
    def error_px(self) -> float: ...


def save(path: str | os.PathLike[str], quads: Quads | None, region: Region, textures: Textures) -> None:
    """Write quads about the centre of their region; `Impostors.save` describes the file."""
    # Imported here: only files need an imaging library.
    from nearfar._scene import glb, glb_surfaces

    target = check.path("path", path, ".glb")
    check.choice("textures", textures, get_args(Textures))
    if quads is None:
        raise ValueError("save: expected impostors with quads, got none")
    scene = quads.scene((0.0, 0.0, 0.0), np.zeros(3))
    encode = glb_surfaces.png if textures == "png" else glb_surfaces.webp(QUALITY)
    encoder = glb.Encoder(scene._core, scene.object_names, scene._undrawn, encode)
    root = encoder.place(0)
    extras = {"center": list(region.center), "reach": region.reach, "r2": region.r2, "error_px": region.error_px}
    data = encoder.finish([root], scenes=[{"nodes": [root], "extras": {EXTRAS_KEY: extras}}])
    with files.atomic_file(target) as aside:
        files.write(aside, data)
