"""Order of the steps from a scene to the files of a bundle, for `export` and for regions on demand.

The steps are: check settings and centres; assign rings; bake maps; choose levels and split the near parts; encode
files; write the manifest with its notes.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Sequence
from typing import Any, Unpack

from numpy.typing import ArrayLike

from nearfar._base import check, formats
from nearfar._base.settings import gather
from nearfar._reduce.walk.regions import Regions
from nearfar._render.level_choice import Lod
from nearfar._scene.scene import Scene, core_of
from nearfar.stream import _store
from nearfar.stream._assign import Rings, assign, check_radii
from nearfar.stream._bundle import Bundle, open as open_bundle
from nearfar.stream._by_footprint import Portions, encode_whole
from nearfar.stream._detail import Detail, Splitting
from nearfar.stream._encode import TILES_PER_ROW, Geometry, TextureFiles, encode_maps, scale_of
from nearfar.stream._growth import Growth
from nearfar.stream._manifest import EMPTY_RING, FORMAT, NEAR_SHARE, ORIENTATION, VERSION
from nearfar.stream._map_files import RangeScale
from nearfar.stream._maps import TILE, RingMaps, bake_maps
from nearfar.stream._notes import findings_of
from nearfar.stream._pieces import divide
from nearfar.stream._radii import choose_radii
from nearfar.stream._regions import centers_of, half_gap, neighbours, reach_of
from nearfar.stream._settings import ExportKeywords, ExportSettings
from nearfar.stream._store import Files


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
    """Write a scene as a bundle and open it: rings of near geometry, each with a map of the scene beyond it.

    A client shows ring 0, which is a map alone, as soon as it has arrived; each further ring turns nearby objects into
    geometry. Static objects of 10,000 triangles or more that are wider than 20 m are divided into square pieces, so
    that only their near parts are sent; each piece counts as an object. Each centre has its own region; a client uses
    the region of the nearest centre. Files are named by their content, so that regions share equal files and clients
    may cache them for ever. Viewers of 3D Tiles show the near geometry of the first region's rings: `tileset.json`
    lists it.

    ValueError before any work for numbers out of range, radii that do not ascend, a centre that is not finite, the same
    centre twice, a centre without surrounding objects if radii are to be chosen, `split_px` for users farther than
    0.348 of the first radius from a centre, and a URL whose file system is unknown or read-only. ValueError during the
    work if triangles cannot be split as finely as `split_px` asks, or if that would add more than 10 million to a
    region. OSError if the folder cannot be written or contains other files. Source: CloVR (2024): rings of near
    geometry, each with its cube map; storing maps as changes is our addition.

    Parameters
    ----------
    scene
        The scene.
    path
        The folder; its parent must exist. An existing folder is replaced if it is empty or contains a bundle's
        `manifest.json`. A URL such as ``s3://bucket/city`` needs fsspec.
    center
        World position O in metres that maps are baked from, at eye height above the ground; or up to 1000 such
        positions (K, 3), at least a millimetre apart; or the result of `nearfar.regions`, whose centres are used.
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
        Fields of `settings`, which they replace.
    """
    options = gather(ExportSettings, settings, keywords)
    core_of(scene)
    centers, fixed_radii = centers_of(center, grid), None if radii is None else check_radii("radii", radii)
    neighbour_lists = neighbours(centers)
    reach = reach_of(grid, half_gap(centers, neighbour_lists))
    detail = Detail.from_options(scene.leveled, lod, options.pixels_per_degree, reach)
    _store.check_target(path, f"nearfar.{FORMAT}")
    splitting = Splitting.from_pixels(options.split_px, detail)
    scene = divide(scene)
    all_rings = rings_about(scene, centers, fixed_radii, splitting)
    textures = TextureFiles(scene, options.quality).encode(detail.halvings(all_rings))
    files, regions, dynamic = Files(), list[dict[str, Any]](), None
    for rings, numbers in zip(all_rings, neighbour_lists, strict=True):
        leveled = detail.select_levels(rings)
        geometry = Geometry(leveled if splitting is None else splitting.split(leveled), files, textures, options)
        dynamic = geometry.moving() if not regions else dynamic
        maps, scale = bake(rings, options)
        entries = list(ring_entries(maps, scale, geometry.groups("ring"), files, options))
        region = region_entry(rings, scale, entries, findings_of(rings), numbers)
        if options.by_footprint:
            portions = Geometry(Portions.from_rings(rings, scene=leveled.scene), files, textures, options)
            region["by_footprint"] = {
                "portions": list(portions.groups("portion")),
                "map": encode_whole(maps.map(rings.count), files, options.quality, scale),
            }
        regions.append(region)
    manifest = manifest_of(scene_facts(scene, options), options.face_size, regions, dynamic, scene._notes, files)
    _store.write(path, {**files.content, **closing_files(manifest, files)})
    return open_bundle(path)


def rings_about(
    scene: Scene, centers: Iterable[ArrayLike], radii: tuple[float, ...] | None, splitting: Splitting | None = None
) -> list[Rings]:
    """Divide the objects about each centre into rings, by the given radii or by radii chosen for each centre."""
    points = [check.vector("center", center) for center in centers]
    regions = [(point, choose_radii(scene, point) if radii is None else radii) for point in points]
    if splitting is not None:
        for point, region_radii in regions:
            splitting.check(point, region_radii)
    return [assign(scene, center=point, radii=region_radii) for point, region_radii in regions]


def bake(rings: Rings, settings: ExportSettings) -> tuple[RingMaps, RangeScale]:
    """Bake the maps of rings; return them with the scale of their ranges."""
    maps = bake_maps(rings, face_size=settings.face_size, samples=settings.samples)
    return maps, scale_of(maps, settings.range_error)


def ring_entries(
    maps: RingMaps, scale: RangeScale, near: Iterable[dict[str, Any]], files: Files, settings: ExportSettings
) -> Iterator[dict[str, Any]]:
    """Encode the rings in order, from ring 0 on; `near` has the geometry entries of rings 1 to n."""
    pictures = encode_maps(maps, files, quality=settings.quality, scale=scale)
    yield {**EMPTY_RING, "map": next(pictures)}
    for ring, picture in zip(near, pictures, strict=True):
        yield {**ring, "map": picture}


def region_entry(
    rings: Rings,
    scale: RangeScale,
    entries: list[dict[str, Any]],
    findings: Sequence[str],
    neighbours: Sequence[int] = (),
) -> dict[str, Any]:
    """Return a region's manifest entry, from the entries of its rings and the findings on them."""
    return {
        "center": list(rings.center),
        "fold_margin": NEAR_SHARE * rings.radii[-1],
        "findings": findings,
        "range": scale.to_manifest(),
        "rings": entries,
        "by_footprint": None,
        "neighbours": neighbours,
    }


def scene_facts(scene: Scene, settings: ExportSettings) -> dict[str, Any]:
    """Return the first entries of a manifest, which describe the scene and how clients show it."""
    return {
        "color_space": "sRGB",
        "morph": {"kind": "cylinder", "near_share": NEAR_SHARE},
        "growth": Growth((1.0,), speed=settings.speed).to_manifest(),
        "triangles": scene.triangle_count,
        "bounds": scene.bounds.tolist(),
        "display": {"pixels_per_degree": settings.pixels_per_degree, "split_px": settings.split_px},
    }


def manifest_of(
    facts: dict[str, Any],
    face_size: int,
    regions: list[dict[str, Any]],
    dynamic: dict[str, Any] | None,
    notes: Sequence[str],
    files: Files,
) -> dict[str, Any]:
    """Return the manifest of a bundle whose tileset is still empty."""
    return formats.header(
        FORMAT,
        VERSION,
        **facts,
        map={"face_size": face_size, "orientation": ORIENTATION, "tile": TILE, "across": TILES_PER_ROW},
        regions=regions,
        dynamic=dynamic,
        tileset=_store.file_entry(b""),
        notes=list(notes),
        files=files.file_entries(),
    )


def closing_files(manifest: dict[str, Any], files: Files) -> dict[str, bytes]:
    """Encode the tileset and the manifest of a bundle, by name; they are written after its other files."""
    from nearfar.stream import _tileset

    first = manifest["regions"][0]
    tileset = _tileset.encode(first["center"], first["rings"], manifest["dynamic"], files.content)
    document = formats.to_json({**manifest, "tileset": _store.file_entry(tileset)}, compact=True)
    return {_store.TILESET: tileset, _store.MANIFEST: document.encode()}
