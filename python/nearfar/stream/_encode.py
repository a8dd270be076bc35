"""Encoding of the parts of a bundle: maps as pictures and codes, rings of geometry as GLB files."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from nearfar import _core
from nearfar._base import glb as binary
from nearfar._base import progress
from nearfar.stream import _map_files as codec
from nearfar.stream._assign import Rings
from nearfar.stream._map_files import RangeScale
from nearfar.stream._maps import TILE, RingMaps
from nearfar.stream._moving import rows_of
from nearfar.stream._store import FOLDER, described, named

ACROSS = 16
"""Tiles in a row of a picture of changed tiles."""


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
    """Encode the map of each ring: colour of ring 0 whole, then changed tiles; range whole from ring 1 on."""
    first = maps.map(0)
    listed: list[dict[str, Any]] = [
        {"color": [files.add(codec.encode_color(face, quality), "webp") for face in first.color]}
    ]
    for ring in range(1, maps.rings.count + 1):
        env = maps.map(ring)
        tiles = np.flatnonzero(maps.changed_tiles(ring))
        described: dict[str, Any] = {"tiles": tiles.tolist(), "color": None, "range": None}
        assert env.range is not None
        if len(tiles):
            sheet = codec.sheet_of(codec.tiles_of(env.color, tiles, TILE), ACROSS)
            described["color"] = files.add(codec.encode_color(sheet, quality), "webp")
        if ring == 1:
            every = np.arange(6 * (first.face_size // TILE) ** 2)
            whole = codec.tiles_of(scale.codes(env.range), every, TILE).reshape(6, -1, TILE, TILE)
            described["range"] = [files.add(codec.encode_codes(face), "range") for face in whole]
        elif len(tiles):
            described["range"] = files.add(
                codec.encode_codes(scale.codes(codec.tiles_of(env.range, tiles, TILE))), "range"
            )
        listed.append(described)
    return listed


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
