"""Encoding of the parts of a bundle: maps as images and codes, rings of geometry as GLB files."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cache, partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import glb as binary, progress, side_by_side, webp
from nearfar._scene.moving_rows import rows_of
from nearfar._scene.scene import Scene
from nearfar._scene.srgb import encode_texture
from nearfar.stream import _map_files as codec
from nearfar.stream._assign import Rings
from nearfar.stream._by_footprint import Portions
from nearfar.stream._map_files import RangeScale
from nearfar.stream._maps import TILE, RingMaps
from nearfar.stream._settings import ExportSettings
from nearfar.stream._store import FOLDER, Files, content_name

TILES_PER_ROW = 16
"""Tiles in a row of an image of changed tiles."""

CHANGE_QUALITY_BONUS = 2
"""Added to the quality of map 0 for changed tiles: errors of map 0 stay in unchanged texels beside removed objects."""

MIN_SHARED_BYTES = 4096
"""Least size from which a mesh with several placements in a single group gets its own file, which regions share."""

Textures = list[tuple[str, bytes]]
"""Names and bytes of the files of a scene's textures, in the scene's order."""


def scale_of(maps: RingMaps, error: float) -> RangeScale:
    """Return the scale of codes for all ranges of all maps."""
    ranges: list[Any] = [maps.first.range, *(change["range"] for change in maps.changes if "range" in change)]
    return RangeScale.fit(np.concatenate([np.ravel(values) for values in ranges]), error)


def encode_maps(maps: RingMaps, files: Files, *, quality: int | None, scale: RangeScale) -> Iterator[dict[str, Any]]:
    """Encode the map of each ring, from ring 0 on; yields their manifest entries.

    Ring 0 has full colour, later rings changed texels; ring 1 has full range, later rings changed texels.
    """
    colors, ranges = list[str](), list[str]()
    for ring, kind, data in side_by_side.results(_jobs(maps, quality, scale)):
        if kind:
            (colors if kind == "webp" else ranges).append(files.add(data, kind))
            continue
        entry: dict[str, Any] = {"color": colors}
        if ring:
            entry = {"tiles": np.flatnonzero(maps.changed_tiles(ring)).tolist(), "color": next(iter(colors), None)}
            entry["range"] = ranges if ring == 1 else next(iter(ranges), None)
        yield entry
        colors, ranges = [], []


def _jobs(maps: RingMaps, quality: int | None, scale: RangeScale) -> Iterator[Callable[[], tuple[int, str, bytes]]]:
    """Yield jobs that encode the files of the maps; each job returns ring, kind and content.

    Results arrive in order. A job with an empty kind follows the last file of a ring.
    """
    first = maps.first
    assert first.range is not None
    for face in first.color:
        yield partial(_file, 0, "webp", codec.encode_color, face, quality)
    yield partial(_file, 0, "", bytes)
    change_quality = None if quality is None else min(quality + CHANGE_QUALITY_BONUS, 100)
    encode_ranges = partial(codec.encode_ranges, tile=TILE, step=scale.step)
    color, codes, size = first.color.copy(), scale.codes(first.range), first.face_size
    for ring, change in enumerate(maps.changes, 1):
        before, texels = codes, change["texels"]
        changed = np.zeros((6, size, size), bool)
        tiles = np.flatnonzero(maps.changed_tiles(ring))
        if len(texels):
            codes = codes.copy()
            color.reshape(-1, 3)[texels] = change["color"]
            codes.reshape(-1)[texels] = scale.codes(change["range"])
            changed.reshape(-1)[texels] = True
            tile_colors = codec.tiles_of(color, tiles, TILE)
            yield partial(_file, ring, "webp", encode_changes, tile_colors, changed, tiles, change_quality)
        if ring == 1:
            for face, face_tiles in codec.group_by_face(tiles, size // TILE):
                yield partial(_file, ring, "range", encode_ranges, codes[face], None, changed[face], face_tiles)
        elif len(tiles):
            yield partial(_file, ring, "range", encode_ranges, codes, before, changed, tiles)
        yield partial(_file, ring, "", bytes)


def _file(ring: int, kind: str, encode: Callable[..., bytes], *arguments: Any) -> tuple[int, str, bytes]:
    return ring, kind, encode(*arguments)


def encode_changes(
    colors: NDArray[np.float32], changed: NDArray[np.bool_], tiles: NDArray[np.int64], quality: int | None
) -> bytes:
    """Encode the image of the tiles with changed texels; only these texels and their neighbours keep their colours."""
    is_meaningful = codec.tiles_of(codec.with_neighbours(changed), tiles, TILE)
    return codec.encode_color(codec.sheet_of(webp.fill_unknown(colors, is_meaningful), TILES_PER_ROW), quality)


class TextureFiles:
    """Encodes the textures of a scene, which all regions share; each size of a texture is encoded once."""

    def __init__(self, scene: Scene, quality: int | None) -> None:
        parts = _core.scene_parts(scene._core)
        links, cutoffs = parts["material_textures"], parts["material_cutoffs"]
        self._texels, self._quality = parts["textures"], quality
        self._cut_out = set(links[np.isfinite(cutoffs)].tolist())
        self._encode_once = cache(self._encode)

    def encode(self, halvings: NDArray[np.uint32]) -> Textures:
        """Return the textures, each with its sides halved the given number of times."""
        return [self._encode_once(*key) for key in enumerate(halvings.tolist())]

    def _encode(self, number: int, times: int) -> tuple[str, bytes]:
        texels, is_cut_out = self._texels[number], number in self._cut_out
        halved = _core.halved_texture(texels, times=times, cutout=is_cut_out) if times else texels
        data = encode_texture(halved, self._quality)
        return content_name(data, "webp"), data


Groups = Rings | Portions
"""Static objects in groups that are sent in order."""


class Geometry:
    """Encodes groups of objects, and the dynamic ones; shared meshes and images become separate files."""

    def __init__(self, groups: Groups, files: Files, textures: Textures, settings: ExportSettings) -> None:
        self._groups, self._files, self._textures = groups, files, textures
        core, images = groups.scene._core, list[str | None](_uri(name) for name, _ in textures)
        # Only names of moving objects are written; there may be millions of others.
        names = list(groups.scene.object_names[: int(core.moving_objects().max(initial=-1)) + 1])
        encoding: dict[str, Any] = {"step": settings.step, "compressed": settings.compression is not None}
        with progress.bar("encoding geometry") as report:
            self._export = _core.Export(
                core, groups.codes(), groups.count + 2, names=names, images=images, encoding=encoding, report=report
            )
        self._uris: list[str | None] = []
        for data, mesh_groups, _ in self._export.shared():
            users = sum(group <= groups.count for group in mesh_groups)
            is_file = users > 1 or (users == 1 and len(data) >= MIN_SHARED_BYTES)
            self._uris.append(_uri(files.add(data, "bin")) if is_file else None)

    def groups(self, kind: str) -> Iterator[dict[str, Any]]:
        """Encode the groups from 1 on; yields their manifest entries, for rings without the map."""
        for number, row in enumerate(self._groups.summary()[: self._groups.count], 1):
            encoded = self._encode_group(number, f"{kind} {number}") if row["triangles"] else None
            yield {**row, **({"geometry": None, "parts": []} if encoded is None else encoded[1])}

    def moving(self) -> dict[str, Any] | None:
        """Encode the dynamic objects; returns their manifest entry, None if nothing moves."""
        scene = self._groups.scene
        triangles = scene.triangle_count - scene._core.standing_triangle_count
        encoded = self._encode_group(0, "dynamic objects") if triangles else None
        if encoded is None:
            return None
        data, entry = encoded
        return {**entry, "triangles": triangles, "instances": rows_of(scene, data)}

    def _encode_group(self, group: int, label: str) -> tuple[bytes, dict[str, Any]] | None:
        """Return a group's GLB and its entry; None if all its faces degenerate when positions are rounded."""
        with progress.bar(f"encoding {label}") as report:
            data, facts = self._export.glb(group, uris=self._uris, report=report)
        if not facts["drawn"]:
            return None
        parts = referenced_files(data)
        for name, texture in self._textures:
            if name in parts:
                self._files.add(texture, "webp")
        return data, {"geometry": self._files.add(data, "glb"), "parts": parts, "error": facts["position_error"]}


def referenced_files(data: bytes) -> list[str]:
    """Return the names of the files that a GLB of a bundle refers to."""
    document, _ = binary.header(data)
    entries = [*document.get("buffers", []), *document.get("images", [])]
    return sorted({f"{FOLDER}/{entry['uri']}" for entry in entries if "uri" in entry})


def _uri(name: str) -> str:
    """Return the URI of a file, relative to the folder of all files."""
    return name.removeprefix(f"{FOLDER}/")
