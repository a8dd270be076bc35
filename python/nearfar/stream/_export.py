"""Export of a scene as a bundle: static files for any web server, with rings about each centre."""

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
from nearfar.stream._radii import choose_radii
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
    """Write a scene as a bundle: near geometry in rings about centres, each with a map of the scene beyond it.

    A client shows ring 0, which is a map alone, as soon as it has arrived; each further ring turns nearby objects into
    geometry. Each centre has its own region; a client uses the region of the nearest centre. Files are named by their
    content, so that regions share equal files and clients may cache them for ever. Viewers of 3D Tiles show the near
    geometry of the first region's rings: `tileset.json` lists it.

    Parameters
    ----------
    scene
        The scene.
    path
        The folder; its parent must exist. An existing folder is replaced if it is empty or contains a bundle's
        `manifest.json`. A URL such as ``s3://bucket/city`` needs fsspec.
    center
        World position O in metres that maps are baked from, at eye height above the ground. Or several, (K, 3), up to
        1000 at least a millimetre apart, or the result of `nearfar.regions`, whose centres are used.
    grid
        Spacing in metres of a horizontal grid to which centres move (`snap`); equal centres are merged. None leaves
        them where they are.
    radii
        Radii of the rings of all centres in metres, ascending; by default those of `nearfar.stream.rings` for each.
    face_size
        Texels along a face of the maps, a multiple of 64 up to 4096.
    samples
        Colour samples per texel, 1 to 1024.
    quality
        Quality of the WebP images of maps and textures, 0 to 100; None for lossless images.
    range_error
        Greatest relative error of the maps' ranges, 10⁻⁶ to 0.1. If 16 bits do not suffice, the error is larger; the
        manifest states it.
    step
        Positions are rounded to multiples of this, metres, so that neighbours stay joined; it is rounded down to a
        power of two. Beyond 2²³ steps from the scene's origin positions have the precision of float32.
    compression
        Compression of geometry: "meshopt" (`EXT_meshopt_compression`), or None for files that any glTF 2.0 reader
        loads.
    pixels_per_degree
        Resolution of the client's display in the middle of the picture: textures are halved while their texels still
        suffice for its pixels at the nearest user position. Users are within 1 m of a centre, or within half of the
        distance to its farthest neighbour. 1 to 500; 25 suits today's headsets. None keeps full-size textures.
    lod
        Rule for the levels of the static objects of rings, in a scene with levels, as for `nearfar.render`: a mode
        such as "depth", a selector, a function like `nearfar.lod.select`, or levels as `Scene.at_levels` takes them.
        Each object gets the level for the nearest user position, as for textures; selectors and functions see it
        straight ahead, at that distance. None writes the scene as it is. Maps are baked from the scene as it is;
        dynamic objects get level 0.
    split_px
        Greatest error in pixels of the client's display (see `pixels_per_degree`; 60 per degree if that is None) for
        a client that morphs vertices and splits nothing itself: large triangles of rings are split as by
        `nearfar.tessellate`, for the growth of their ring, all later radii, and the user positions above, 0.001 to
        1000. Placements of a mesh that need no split still share it. At most 10 million triangles may be added to a
        region. None splits no triangle.
    speed
        Degrees per second by which the picture turns while a ring grows, for a user 1 m from the centre, as in
        `Growth`.
    by_footprint
        Whether to write the near objects a second time, ordered by footprint, with the full map of the last ring: the
        strategies vis0 and vis1, with which CloVR is compared, send these instead of rings.

    Returns
    -------
    Bundle
        The bundle, open.

    Raises
    ------
    ValueError
        For numbers out of range, radii that fall or repeat, a centre that is not finite, the same centre twice, a
        centre without surrounding objects if radii are to be chosen, triangles to be split for users farther than 0.348
        of the first radius from a centre, and a URL whose file system is unknown or read-only; before any work. During
        it, if triangles cannot be split as finely as `split_px` asks, or that would add more than 10 million to a
        region.
    TypeError
        For arguments of another type.
    OSError
        If the folder cannot be written or contains other files.

    References
    ----------
    CloVR (2024): rings of near geometry, each with its cube map. Storing maps as changes is our addition.
    """
    from nearfar.stream import _tileset

    core_of(scene)
    settings = Settings.validate(
        face_size, samples, quality, range_error, step, compression, pixels_per_degree, by_footprint, split_px
    )
    centers, given = centers_of(center, grid), None if radii is None else ascending("radii", radii)
    near = neighbours(centers)
    moved = 0.0 if grid is None else math.sqrt(0.5) * float(grid)
    reach = max(Growth.reach, halfway(centers, near)) + moved
    detail = Detail.from_options(scene, lod, settings.pixels_per_degree, reach)
    _store.check_target(path, f"nearfar.{NAME}")
    bounds = choose_radii(scene, centers) if given is None else [given] * len(centers)
    splitting = Splitting.from_pixels(settings.split_px, detail)
    if splitting is not None:
        for place, own in zip(centers, bounds, strict=True):
            splitting.check(tuple(place.tolist()), own)
    growth = Growth(bounds[0], speed=speed)
    divided = [assign(scene, center=place, radii=own) for place, own in zip(centers, bounds, strict=True)]
    writer = Writer(settings, TextureFiles(scene, settings.quality).halved(detail.halvings(divided)))
    files, regions, dynamic = writer.files, list[dict[str, Any]](), None
    for rings, beside in zip(divided, near, strict=True):
        shown = detail.select_levels(rings)
        geometry = writer.geometry(shown if splitting is None else splitting.split(shown))
        if not regions:
            dynamic = geometry.moving()
        regions.append({**writer.region(rings, shown, geometry), "neighbours": beside})
    tileset = _tileset.encode(regions[0]["center"], regions[0]["rings"], dynamic, files.content)
    described = _store.file_entry(tileset)
    manifest = manifest_of(
        scene, settings, growth=growth, regions=regions, dynamic=dynamic, tileset=described, files=files
    )
    text = formats.to_json(manifest, compact=True).encode()
    _store.write(path, {**files.content, _store.TILESET: tileset, _store.MANIFEST: text})
    return open_bundle(path)
