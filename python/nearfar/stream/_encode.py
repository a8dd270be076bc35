"""Encoding of the parts of a bundle: maps as pictures and codes, rings of geometry as GLB files."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import glb as binary, progress
from nearfar.stream import _map_files as codec
from nearfar.stream._assign import Rings
from nearfar.stream._map_files import RangeScale
from nearfar.stream._maps import TILE, RingMaps
from nearfar.stream._moving import rows_of
from nearfar.stream._store import FOLDER, described, named

ACROSS = 16
"""Tiles in a row of a picture of changed tiles."""

BETTER = 2
"""Steps by which the quality of changes exceeds that of map 0: what stays keeps errors beside objects that left."""


@dataclass
class Files:
    """Files by name; equal content is stored once."""

    content: dict[str, bytes] = field(default_factory=dict)

    def add(self, data: bytes, kind: str) -> str:
        """Add a file and return its name."""
        name = named(data, kind)
        self.content[name] = data
        return name

    def listed(self) -> dict[str, Any]:
        """Size and hash of each file by name, in the order of the names."""
        return {name: described(self.content[name]) for name in sorted(self.content)}


def scale_of(maps: RingMaps, error: float) -> RangeScale:
    """Codes for all ranges of all maps."""
    ranges: list[Any] = [maps.first.range, *(change["range"] for change in maps.changes if "range" in change)]
    return RangeScale.of(np.concatenate([np.ravel(values) for values in ranges]), error)


def encode_maps(maps: RingMaps, files: Files, *, quality: int | None, scale: RangeScale) -> list[dict[str, Any]]:
    """Encode the map of each ring: colour of ring 0 whole, then changed texels; range whole from ring 1 on."""
    first = maps.first
    assert first.range is not None
    color, codes, size = first.color.copy(), scale.codes(first.range), first.face_size
    listed: list[dict[str, Any]] = [{"color": [files.add(codec.encode_color(face, quality), "webp") for face in color]}]
    better = None if quality is None else min(quality + BETTER, 100)
    for ring, change in enumerate(maps.changes, 1):
        before, texels = codes.copy(), change["texels"]
        changed = np.zeros((6, size, size), bool)
        if len(texels):
            color.reshape(-1, 3)[texels] = change["color"]
            codes.reshape(-1)[texels] = scale.codes(change["range"])
            changed.reshape(-1)[texels] = True
        tiles = np.flatnonzero(maps.changed_tiles(ring))
        described: dict[str, Any] = {"tiles": tiles.tolist(), "color": None, "range": None}
        if len(tiles):
            described["color"] = files.add(encode_changes(color, changed, tiles, better), "webp")
        if ring == 1:
            described["range"] = [
                files.add(codec.encode_ranges(codes[face], None, changed[face], own, TILE, scale.step), "range")
                for face, own in codec.by_face(tiles, size // TILE)
            ]
        elif len(tiles):
            described["range"] = files.add(
                codec.encode_ranges(codes, before, changed, tiles, TILE, scale.step), "range"
            )
        listed.append(described)
    return listed


def encode_changes(
    color: NDArray[np.float32], changed: NDArray[np.bool_], tiles: NDArray[np.int64], quality: int | None
) -> bytes:
    """Encode the picture of the tiles in which texels change; only those and their neighbours show anything of use."""
    known = codec.tiles_of(codec.with_neighbours(changed), tiles, TILE)
    return codec.encode_color(codec.sheet_of(codec.filled(codec.tiles_of(color, tiles, TILE), known), ACROSS), quality)


def encode_geometry(
    rings: Rings, files: Files, *, step: float, compressed: bool, quality: int | None
) -> tuple[list[dict[str, Any]], dict[str, Any] | None]:
    """Encode the geometry of each ring from 1 on, and the dynamic objects, None if nothing moves.

    Meshes and images that several of them have are files of their own.
    """
    scene = rings.scene
    textures = [codec.encode_texture(texels, quality) for texels in _core.scene_parts(scene._core)["textures"]]
    images = [named(data, "webp") for data in textures]
    with progress.bar("encoding geometry") as report:
        export = _core.Export(
            scene._core,
            rings.codes(),
            rings.count + 2,
            names=list(scene.object_names),
            images=[_beside(name) for name in images],
            step=step,
            compressed=compressed,
            report=report,
        )
    uris: list[str | None] = []
    for data, groups, _ in export.shared():
        users = sum(group <= rings.count for group in groups)
        uris.append(_beside(files.add(data, "bin")) if users > 1 else None)

    def encoded(group: int, label: str) -> tuple[bytes, dict[str, Any]] | None:
        with progress.bar(f"encoding {label}") as report:
            data, facts = export.glb(group, uris=uris, report=report)
        if not facts["drawn"]:  # faces may lose their area when positions are rounded
            return None
        parts = referenced(data)
        for name, texture in zip(images, textures, strict=True):
            if name in parts:
                files.add(texture, "webp")
        return data, {"geometry": files.add(data, "glb"), "parts": parts, "error": facts["position_error"]}

    listed = []
    for ring, row in enumerate(rings.summary()[: rings.count], 1):
        found = encoded(ring, f"ring {ring}") if row["triangles"] else None
        counts = {name: row[name] for name in ("radius", "objects", "triangles", "stored")}
        listed.append({**counts, **({"geometry": None, "parts": []} if found is None else found[1])})
    moving = scene.triangle_count - scene._core.standing_triangle_count
    found = encoded(0, "dynamic objects") if moving else None
    if found is None:
        return listed, None
    data, described = found
    return listed, {**described, "triangles": moving, "instances": rows_of(scene, data)}


def referenced(data: bytes) -> list[str]:
    """Names of the files that a GLB of a bundle refers to."""
    document, _ = binary.header(data)
    entries = [*document.get("buffers", []), *document.get("images", [])]
    return sorted({f"{FOLDER}/{entry['uri']}" for entry in entries if "uri" in entry})


def _beside(name: str) -> str:
    """URI of a file as other files in its folder refer to it."""
    return name.removeprefix(f"{FOLDER}/")
