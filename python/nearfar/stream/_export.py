"""Export of a scene as a bundle: static files for any web server, with rings about each centre."""

from __future__ import annotations

import os
from collections.abc import Iterable
from typing import Unpack

from numpy.typing import ArrayLike

from nearfar._base.settings import gather
from nearfar._reduce.walk.regions import Regions
from nearfar._render.level_choice import Lod
from nearfar._scene.scene import Scene
from nearfar.stream._bundle import Bundle, open as open_bundle
from nearfar.stream._settings import ExportKeywords, ExportSettings
from nearfar.stream._stages import write_bundle


def export(
    scene: Scene,
    path: str | os.PathLike[str],
    *,
    center: ArrayLike | Regions,
    grid: float | None = None,
    radii: Iterable[float] | None = None,
    lod: Lod | None = None,
    settings: ExportSettings | None = None,
    **keywords: Unpack[ExportKeywords],
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
        Radii of the rings of all centres in metres, ascending; by default those of `ring_radii` for each.
    lod
        Rule for the levels of the static objects of rings, in a scene with levels, as for `nearfar.render`: a mode
        such as "depth", a selector, a function like `nearfar.lod.select`, or levels as `Scene.at_levels` takes them.
        Each object gets the level for the nearest user position, as for textures; selectors and functions see it
        straight ahead, at that distance. None writes the scene as it is. Maps are baked from the scene as it is;
        dynamic objects get level 0.
    settings
        Quality and compression of the files, as `ExportSettings`.
    keywords
        Fields of `settings`, which they replace: `face_size`, `samples`, `quality`, `range_error`, `step`,
        `compression`, `pixels_per_degree`, `split_px`, `speed`, `by_footprint`.

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
    chosen = gather(ExportSettings, settings, keywords)
    write_bundle(scene, path, center=center, grid=grid, radii=radii, lod=lod, settings=chosen)
    return open_bundle(path)
