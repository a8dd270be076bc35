"""Export of a scene as a bundle: plain files for any web server, ring after ring about each centre."""

from __future__ import annotations

import math
import os
from collections.abc import Iterable
from typing import Any, SupportsFloat

from numpy.typing import ArrayLike

from nearfar._base import formats
from nearfar._reduce.walk.regions import Regions
from nearfar._render.level_choice import Lod
from nearfar._scene.scene import Scene, core_of
from nearfar.stream import _store
from nearfar.stream._assign import ascending, assign
from nearfar.stream._bundle import Bundle, open as open_bundle
from nearfar.stream._centers import centers_of, halfway, neighbours
from nearfar.stream._detail import Detail
from nearfar.stream._encode import TextureFiles
from nearfar.stream._growth import Growth
from nearfar.stream._manifest import NAME
from nearfar.stream._radii import chosen
from nearfar.stream._region import Writer, manifest_of
from nearfar.stream._settings import Settings
from nearfar.stream._split import Splitting


def export(
    scene: Scene,
    path: str | os.PathLike[str],
    *,
    center: ArrayLike | Regions,
    grid: SupportsFloat | None = None,
    radii: Iterable[float] | None = None,
    face_size: int = 1024,
    samples: int = 4,
    quality: int | None = 90,
    range_error: float = 2.0**-11,
    step: float = 2.0**-10,
    compression: str | None = "meshopt",
    pixels_per_degree: SupportsFloat | None = 25.0,
    lod: Lod | None = None,
    split_px: SupportsFloat | None = None,
    speed: float = 0.7,
    by_footprint: bool = False,
) -> Bundle:
    """Write a scene as a bundle: near geometry in rings about centres, each with the map of what lies beyond it.

    A client shows the picture of ring 0, which is a map alone, as soon as it has that; each further ring makes nearby
    objects geometry. Each centre has a region of its own; a client uses that of the nearest one. Files are named by
    their content, so that regions share equal ones, and that a server may let clients keep them for ever. Viewers of
    3D Tiles show the near geometry of the first region's rings: `tileset.json` lists it.

    Parameters
    ----------
    scene
        The scene.
    path
        The folder; its parent must exist. An existing folder is replaced if it is empty or contains a bundle's
        `manifest.json`. A URL such as ``s3://bucket/city`` needs fsspec.
    center
        World position O in metres that maps are baked from: an eye's height above the ground. Or several, (K, 3), up to
        1000 at least a millimetre apart, or what `nearfar.regions` returns, whose centres are taken.
    grid
        Spacing in metres of a horizontal grid to which centres move (`snap`); centres that meet become one. None keeps
        them where they are.
    radii
        Radii of the rings of all centres in metres, ascending; by default those of `nearfar.stream.rings` for each.
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
    pixels_per_degree
        Of the client's display, in the middle of the picture: textures are halved while their texels, seen from where
        users are nearest, still suffice for its pixels. Users are within 1 m of a centre, or within half of the way to
        its farthest neighbour. 1 to 500; 25 is that of today's headsets. None keeps textures whole.
    lod
        Levels of the static objects of rings, in a scene whose objects have some, as for `nearfar.render`: a mode such
        as "depth", a selector, a function like `nearfar.lod.select`, or levels as `Scene.at_levels` takes them. Each
        object gets the level for the user who is nearest to it, as for textures; selectors and functions are given it
        straight ahead, at that distance. None writes the scene as it is. Maps are baked from the scene as it is;
        dynamic objects get level 0.
    split_px
        Greatest error in pixels of the client's display (see `pixels_per_degree`; 60 a degree if that is None) of a
        client that moves vertices and splits nothing itself: large triangles of rings are split as `nearfar.tessellate`
        does, for the growth of their ring, all later radii, and the users named above, 0.001 to 1000. A mesh that is
        placed several times stays shared between the placements that need no split. At most 10 million triangles may
        be added to a region. None writes triangles whole.
    speed
        Degrees a second at which pictures turn while rings grow, for a user 1 m beside the centre, as in `Growth`.
    by_footprint
        Whether to write the near objects a second time, in the order of their footprints, with the map of the last ring
        as a whole: that is what the strategies vis0 and vis1, with which CloVR is compared, send instead of rings.

    Returns
    -------
    Bundle
        The bundle, open.

    Raises
    ------
    ValueError
        For numbers out of range, radii that fall or repeat, a centre that is not finite, the same centre twice, a
        centre with nothing around it if radii are to be chosen, triangles that are to be split for users farther than
        0.348 of the first radius from a centre, and a URL whose file system is not known or only reads; before any
        work. During it, if triangles cannot be split as finely as `split_px` asks, or that would add more than 10
        million to a region.
    TypeError
        For arguments of another type.
    OSError
        If the folder cannot be written or contains other files.

    References
    ----------
    CloVR (2024): rings of near geometry, each with its cube map. Maps as changes to the one before are ours.
    """
    from nearfar.stream import _tileset

    core_of(scene)
    settings = Settings.checked(
        face_size, samples, quality, range_error, step, compression, pixels_per_degree, by_footprint, split_px
    )
    centers, given = centers_of(center, grid), None if radii is None else ascending("radii", radii)
    near = neighbours(centers)
    moved = 0.0 if grid is None else math.sqrt(0.5) * float(grid)
    reach = max(Growth.reach, halfway(centers, near)) + moved
    detail = Detail.of(scene, lod, settings.pixels_per_degree, reach)
    _store.check_target(path, f"nearfar.{NAME}")
    bounds = chosen(scene, centers) if given is None else [given] * len(centers)
    splitting = Splitting.of(settings.split_px, detail)
    if splitting is not None:
        for place, own in zip(centers, bounds, strict=True):
            splitting.check(tuple(place.tolist()), own)
    growth = Growth(bounds[0], speed=speed)
    divided = [assign(scene, center=place, radii=own) for place, own in zip(centers, bounds, strict=True)]
    writer = Writer(settings, TextureFiles(scene, settings.quality).halved(detail.halvings(divided)))
    files, regions, dynamic = writer.files, list[dict[str, Any]](), None
    for rings, beside in zip(divided, near, strict=True):
        shown = detail.shown(rings)
        geometry = writer.geometry(shown if splitting is None else splitting.split(shown))
        if not regions:
            dynamic = geometry.moving()
        regions.append({**writer.region(rings, shown, geometry), "neighbours": beside})
    tileset = _tileset.encode(regions[0]["center"], regions[0]["rings"], dynamic, files.content)
    described = _store.described(tileset)
    manifest = manifest_of(
        scene, settings, growth=growth, regions=regions, dynamic=dynamic, tileset=described, files=files
    )
    text = formats.to_json(manifest, compact=True).encode()
    _store.write(path, {**files.content, _store.TILESET: tileset, _store.MANIFEST: text})
    return open_bundle(path)
