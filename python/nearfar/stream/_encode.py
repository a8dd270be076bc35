"""Encoding of the parts of a bundle: maps as pictures and codes, rings of geometry as GLB files."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from nearfar import _core
from nearfar._base import glb as binary
from nearfar._base import progress
from nearfar._scene.moving_rows import moving_rows
from nearfar._scene.scene import Scene
from nearfar.stream import _map_files as codec
from nearfar.stream._assign import Rings
from nearfar.stream._map_files import RangeScale
from nearfar.stream._maps import TILE, RingMaps
from nearfar.stream._store import FOLDER, described, named

ACROSS = 16
"""Tiles in a row of a picture of changed tiles."""

LEAST_SHARED = 4096
"""Bytes from which a mesh of several placements is a file of its own even if one ring has it; regions share it."""

Textures = list[tuple[str, bytes]]
"""Names and bytes of the files of a scene's textures, in the scene's order."""


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


def encode_textures(scene: Scene, quality: int | None) -> Textures:
    """Encode the textures of a scene, which all regions share."""
    pictures = [codec.encode_texture(texels, quality) for texels in _core.scene_parts(scene._core)["textures"]]
    return [(named(data, "webp"), data) for data in pictures]


def encode_geometry(
    rings: Rings, files: Files, *, textures: Textures, step: float, compressed: bool
) -> list[dict[str, Any]]:
    """Encode the geometry of each ring from 1 on; meshes and images that rings share are files of their own."""
    scene = rings.scene
    with progress.bar("encoding geometry") as report:
        export = _core.Export(
            scene._core,
            rings.codes(),
            rings.count + 2,
            names=list(scene.object_names),
            images=[_beside(name) for name, _ in textures],
            step=step,
            compressed=compressed,
            report=report,
        )
    uris: list[str | None] = []
    for data, groups, _ in export.shared():
        users = sum(1 <= group <= rings.count for group in groups)
        is_file = users > 1 or (users == 1 and len(data) >= LEAST_SHARED)
        uris.append(_beside(files.add(data, "bin")) if is_file else None)
    listed = []
    for ring, row in enumerate(rings.summary()[: rings.count], 1):
        described: dict[str, Any] = {"geometry": None, "parts": []}
        if row["triangles"]:
            with progress.bar(f"encoding ring {ring}") as report:
                data, facts = export.glb(ring, uris=uris, report=report)
            parts = referenced(data)
            for name, texture in textures:
                if name in parts:
                    files.add(texture, "webp")
            described = {"geometry": files.add(data, "glb"), "parts": parts, "error": facts["position_error"]}
        counts = {"objects": row["objects"], "triangles": row["triangles"], "stored": row["stored"]}
        listed.append({"radius": row["radius"], **counts, **described})
    return listed


def referenced(data: bytes) -> list[str]:
    """Names of the files that a GLB of a bundle refers to."""
    document, _ = binary.header(data)
    entries = [*document.get("buffers", []), *document.get("images", [])]
    return sorted({f"{FOLDER}/{entry['uri']}" for entry in entries if "uri" in entry})


def _beside(name: str) -> str:
    """URI of a file as other files in its folder refer to it."""
    return name.removeprefix(f"{FOLDER}/")


def encode_moving(scene: Scene, files: Files) -> dict[str, Any] | None:
    """Encode the dynamic objects of a scene, with the transforms that they were loaded with; None if nothing moves."""
    from nearfar._scene import glb

    moving = scene.subset(objects=[scene.object_names[n] for n in np.unique(scene._core.moving_objects())])
    if not moving.triangle_count:
        return None
    name = files.add(glb.encode(moving._core, moving.object_names, moving._undrawn), "glb")
    return {"geometry": name, "triangles": moving.triangle_count, "instances": moving_rows(moving)}
