"""Export of a scene as a bundle: plain files for any web server, ring after ring."""

from __future__ import annotations

import os
from collections.abc import Iterable
from typing import Any

from numpy.typing import ArrayLike

from nearfar._base import check, formats
from nearfar._scene.scene import Scene, core_of
from nearfar.stream import _store
from nearfar.stream._assign import ascending, assign
from nearfar.stream._bundle import Bundle, open as open_bundle
from nearfar.stream._encode import ACROSS, Files, encode_geometry, encode_maps, scale_of
from nearfar.stream._growth import Growth
from nearfar.stream._manifest import NAME, NEAR_SHARE, ORIENTATION, VERSION
from nearfar.stream._maps import MOST_SAMPLES, TILE, bake_maps
from nearfar.stream._notes import findings_of
from nearfar.stream._radii import rings as choose

MOST_FACE_SIZE = 4096


def export(
    scene: Scene,
    path: str | os.PathLike[str],
    *,
    center: ArrayLike,
    radii: Iterable[float] | None = None,
    face_size: int = 1024,
    samples: int = 4,
    quality: int | None = 90,
    range_error: float = 2.0**-11,
    step: float = 2.0**-10,
    compression: str | None = "meshopt",
    speed: float = 0.7,
) -> Bundle:
    """Write a scene as a bundle: near geometry in rings about a centre, each with the map of what lies beyond it.

    A client shows the picture of ring 0, which is a map alone, as soon as it has that; each further ring makes nearby
    objects geometry. Files are named by their content, so that a server may let clients keep them for ever. Viewers of
    3D Tiles show the near geometry of all rings: `tileset.json` lists it.

    Parameters
    ----------
    scene
        The scene.
    path
        The folder; its parent must exist. An existing folder is replaced if it is empty or contains a bundle's
        `manifest.json`. A URL such as ``s3://bucket/city`` needs fsspec.
    center
        World position O in metres that the maps are baked from: an eye's height above the ground.
    radii
        Radii of the rings in metres, ascending; by default those of `nearfar.stream.rings`.
    face_size
        Texels along a face of the maps, a multiple of 64 up to 4096.
    samples
        Colour samples per texel, 1 to 1024.
    quality
        Quality of the WebP pictures of maps and textures, 0 to 100; None for lossless ones.
    range_error
        Greatest relative error of the maps' ranges, 10⁻⁶ to 0.1. Where 16 bits do not suffice for it, the error is
        larger; the manifest states it.
    step
        Positions are rounded to multiples of this, metres, so that neighbours stay joined; it becomes a power of two
        that is not greater. Beyond 2²³ steps from the scene's origin they are as precise as float32.
    compression
        Of geometry: "meshopt" (`EXT_meshopt_compression`), or None for files that any reader of glTF 2.0 loads.
    speed
        Degrees a second by which a client's picture may turn while a ring grows, for a user 1 m beside the centre; see
        `Growth`.

    Returns
    -------
    Bundle
        The bundle, open.

    Raises
    ------
    ValueError
        For numbers out of range, radii that fall or repeat, a centre that is not finite, and a URL whose file system is
        not known or only reads; before any work.
    TypeError
        For arguments of another type.
    OSError
        If the folder cannot be written, has no parent or contains other files: before any work. If the disk is full:
        then what was there stays.

    References
    ----------
    CloVR (2024): rings of near geometry, each with its cube map. Maps as changes to the one before are ours.
    """
    from nearfar.stream import _tileset

    core_of(scene)
    size = check.integer("face_size", face_size, TILE, MOST_FACE_SIZE)
    if size % TILE:
        raise ValueError(f"face_size: expected a multiple of {TILE}, got {size}")
    count = check.integer("samples", samples, 1, MOST_SAMPLES)
    level = None if quality is None else check.integer("quality", quality, 0, 100)
    error = check.within("range_error", range_error, 1e-6, 0.1)
    grid = check.within("step", step, 1e-6, 1.0)
    if compression is not None:
        check.choice("compression", compression, ("meshopt",))
    middle = check.vector("center", center)
    given = None if radii is None else ascending("radii", radii)
    _store.check_target(path, f"nearfar.{NAME}")
    rings = assign(scene, center=middle, radii=choose(scene, center=middle) if given is None else given)
    growth = Growth(rings.radii, speed=speed)
    maps = bake_maps(rings, face_size=size, samples=count)
    files, scale = Files(), scale_of(maps, error)
    pictures = encode_maps(maps, files, quality=level, scale=scale)
    nothing: dict[str, Any] = {"objects": 0, "triangles": 0, "stored": 0, "geometry": None, "parts": []}
    near, moving = encode_geometry(rings, files, step=grid, compressed=compression is not None, quality=level)
    geometry = [{"radius": 0.0, **nothing}, *near]
    tileset = _tileset.encode(middle, geometry, moving, files.content)
    manifest = formats.header(
        NAME,
        VERSION,
        color_space="sRGB",
        center=list(middle),
        morph={"kind": "cylinder", "near_share": NEAR_SHARE},
        growth=growth.described(),
        triangles=scene.triangle_count,
        bounds=scene.bounds.tolist(),
        map={
            "face_size": size,
            "orientation": ORIENTATION,
            "tile": TILE,
            "across": ACROSS,
            "range": {"least": scale.least, "step": scale.step, "error": scale.error},
        },
        rings=[{**ring, "map": picture} for ring, picture in zip(geometry, pictures, strict=True)],
        dynamic=moving,
        notes=list(scene.report.notes),
        findings=findings_of(rings),
        tileset=_store.described(tileset),
        files=files.listed(),
    )
    text = formats.to_json(manifest, compact=True).encode()
    _store.write(path, {**files.content, _store.TILESET: tileset, _store.MANIFEST: text})
    return open_bundle(path)
