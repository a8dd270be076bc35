"""Order of the steps from a scene to the files of a bundle, for `export` and regions on demand; it computes nothing.

Settings and centres are checked. Then come rings, maps, near parts with their levels and splits, files, and last the
manifest with its notes.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Sequence
from typing import Any

from numpy.typing import ArrayLike

from nearfar._base import check, formats
from nearfar._reduce.walk.regions import Regions
from nearfar._render.level_choice import Lod
from nearfar._scene.scene import Scene, core_of
from nearfar.stream import _store
from nearfar.stream._assign import Rings, ascending, assign
from nearfar.stream._by_footprint import Portions, encode_whole
from nearfar.stream._centers import centers_of, half_gap, neighbours, reach_of
from nearfar.stream._detail import Detail
from nearfar.stream._encode import TILES_PER_ROW, Files, Geometry, TextureFiles, encode_maps, scale_of
from nearfar.stream._growth import Growth
from nearfar.stream._manifest import EMPTY_RING, NAME, NEAR_SHARE, ORIENTATION, VERSION
from nearfar.stream._map_files import RangeScale
from nearfar.stream._maps import TILE, RingMaps, bake_maps
from nearfar.stream._notes import findings_of
from nearfar.stream._radii import choose_radii
from nearfar.stream._settings import ExportSettings
from nearfar.stream._split import Splitting


def write_bundle(
    scene: Scene,
    path: str | os.PathLike[str],
    *,
    center: ArrayLike | Regions,
    grid: float | None,
    radii: Iterable[float] | None,
    lod: Lod | None,
    settings: ExportSettings,
) -> None:
    """Write a scene as a bundle; arguments as in `export`."""
    core_of(scene)
    centers, fixed_radii = centers_of(center, grid), None if radii is None else ascending("radii", radii)
    near = neighbours(centers)
    reach = reach_of(grid, half_gap(centers, near))
    detail = Detail.from_options(scene.leveled, lod, settings.pixels_per_degree, reach)
    _store.check_target(path, f"nearfar.{NAME}")
    splitting = Splitting.from_pixels(settings.split_px, detail)
    all_rings = rings_about(scene, centers, fixed_radii, splitting)
    textures = TextureFiles(scene, settings.quality).halved(detail.halvings(all_rings))
    files, regions, dynamic = Files(), list[dict[str, Any]](), None
    for rings, numbers in zip(all_rings, near, strict=True):
        leveled = detail.select_levels(rings)
        geometry = Geometry(leveled if splitting is None else splitting.split(leveled), files, textures, settings)
        dynamic = geometry.moving() if not regions else dynamic
        maps, scale = bake(rings, settings)
        entries = list(ring_entries(maps, scale, geometry.groups("ring"), files, settings))
        region = region_entry(rings, scale, entries, findings_of(rings), numbers)
        if settings.by_footprint:
            portions = Geometry(Portions.from_rings(rings, scene=leveled.scene), files, textures, settings)
            region["by_footprint"] = {
                "portions": list(portions.groups("portion")),
                "map": encode_whole(maps.map(rings.count), files, settings.quality, scale),
            }
        regions.append(region)
    manifest = manifest_of(scene_facts(scene, settings), settings.face_size, regions, dynamic, scene._notes, files)
    _store.write(path, {**files.content, **closing_files(manifest, files)})


def rings_about(
    scene: Scene, centers: Iterable[ArrayLike], radii: tuple[float, ...] | None, splitting: Splitting | None = None
) -> list[Rings]:
    """Divide the objects about each centre, by the same radii or by those chosen for each centre."""
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
        NAME,
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
