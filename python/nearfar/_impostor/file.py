"""Writes the quads of impostors as a plain GLB."""

from __future__ import annotations

from typing import Literal, Protocol, get_args

import numpy as np

from nearfar import _core
from nearfar._impostor.quads import Point, Quads
from nearfar._scene.joined import join_scenes, move_origin
from nearfar._scene.scene import Scene

Textures = Literal["webp", "png"]
"""Kind of image in a file of impostors."""

TEXTURES: tuple[Textures, ...] = get_args(Textures)

Geometry = Literal["meshopt", "plain"]
"""Kind of geometry in a file of impostors."""
GEOMETRIES: tuple[Geometry, ...] = get_args(Geometry)

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


def encode(
    quads: Quads | None,
    region: Region,
    *,
    near: Scene | None = None,
    textures: Textures = "webp",
    geometry: Geometry = "meshopt",
) -> bytes:
    """Encode quads about the centre of their region, with near geometry if `near` is set."""
    # Imported here: only files need an imaging library.
    from nearfar._scene import glb, glb_surfaces

    origin = np.zeros(3)
    scenes = [] if quads is None else [quads.scene((0.0, 0.0, 0.0), origin)]
    if near is not None:
        scenes.insert(0, move_origin(near, near.origin - region.center))
    scene = join_scenes(scenes)
    encode = glb_surfaces.png if textures == "png" else glb_surfaces.webp(QUALITY)
    encoder = glb.Encoder(scene._core, scene.object_names, scene._undrawn, encode)
    parts = _core.scene_parts(scene._core)["meshes"]
    roots = [encoder.place(number) for number, mesh in enumerate(parts) if mesh.face_count]
    extras = {"center": list(region.center), "reach": region.reach, "r2": region.r2, "error_px": region.error_px}
    return encoder.finish(roots, scenes=[{"nodes": roots, "extras": {EXTRAS_KEY: extras}}])
