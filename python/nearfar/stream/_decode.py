"""Decoding of the parts of a bundle: maps from images and codes, scenes and dynamic objects from GLB files."""

from __future__ import annotations

import math
import tempfile
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path, PurePosixPath
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import check, formats
from nearfar._base.errors import FormatError, SceneError
from nearfar._scene.glb import placement_of
from nearfar._scene.moving_rows import frames_of, nodes_of
from nearfar._scene.names import Names, distinct
from nearfar._scene.options import LoadOptions
from nearfar._scene.scene import Scene
from nearfar._scene.serialize import empty_core
from nearfar.stream import _map_files as codec
from nearfar.stream._map_files import RangeScale

Read = Callable[[str], bytes]
"""Returns the bytes of a file by name."""

DecodeFile = Callable[[str, Callable[[bytes], Any]], Any]
"""Decodes the content of a file by name with a function; errors name the file."""


@dataclass(frozen=True)
class Layout:
    """Division of maps into files."""

    face_size: int
    tile: int
    tiles_per_row: int
    """Tiles in a row of an image of changed tiles."""
    scale: RangeScale

    @classmethod
    def parse(cls, entry: dict[str, Any]) -> Layout:
        """Read the layout from a manifest; ValueError for impossible values."""
        size = check.integer("face_size", entry["face_size"], 1, codec.MAX_PIXELS)
        tile = check.integer("tile", entry["tile"], 1, size)
        if size % tile:
            raise ValueError(f"tile: expected a divisor of {size}, got {tile}")
        tiles_per_row = check.integer("across", entry["across"], 1, codec.MAX_PIXELS // tile)
        least, step = (check.positive(name, entry["range"][name]) for name in ("least", "step"))
        if not math.isfinite(least * math.exp(min(codec.NO_SURFACE * step, 700.0))) or codec.NO_SURFACE * step > 700.0:
            raise ValueError(f"step: expected ranges that are finite, got {step:g}")
        return cls(size, tile, tiles_per_row, RangeScale(least, step))

    @property
    def tiles(self) -> int:
        """Number of tiles of all faces."""
        return 6 * (self.face_size // self.tile) ** 2

    def check(self, maps: Sequence[dict[str, Any]]) -> None:
        """Raise ValueError for map entries that do not fit the layout."""
        if len(maps[0]["color"]) != 6:
            raise ValueError("map: expected six pictures for ring 0")
        for number, entry in enumerate(maps[1:], 1):
            tiles = check.items("tiles", entry["tiles"], int, "numbers of tiles")
            if any(not before < after for before, after in zip([-1, *tiles], [*tiles, self.tiles], strict=True)):
                raise ValueError(f"tiles: expected ascending numbers below {self.tiles}")
            if bool(tiles) != isinstance(entry["color"], str):
                raise ValueError("map: expected a picture if tiles change and none otherwise")
            if number == 1 and (isinstance(entry["range"], str) or len(entry["range"]) != 6):
                raise ValueError("map: expected six files of ranges for ring 1")
            if number > 1 and bool(tiles) != isinstance(entry["range"], str):
                raise ValueError("map: expected ranges if tiles change and none otherwise")


def decode_map(
    maps: Sequence[dict[str, Any]], layout: Layout, decode_file: DecodeFile
) -> tuple[NDArray[np.float32], NDArray[np.float32] | None]:
    """Decode the last of consecutive maps from ring 0 on: colour (6, S, S, 3), linear RGB, and range (6, S, S), metres.

    Range is None if only ring 0 is given.
    """
    side, tile, codes = layout.face_size, layout.tile, None

    def decode_color(name: str, width: int, height: int) -> Any:
        return decode_file(name, partial(codec.decode_color, size=(width, height)))

    def decode_ranges(name: str, before: codec.Codes | None, count: int, tiles: NDArray[np.int64]) -> Any:
        settings: Any = {"before": before, "count": count, "size": side, "tiles": tiles, "tile": tile}
        return decode_file(name, partial(codec.decode_ranges, step=layout.scale.step, **settings))

    faces = np.stack([decode_color(name, side, side) for name in maps[0]["color"]])
    for entry in maps[1:]:
        tiles = np.array(entry["tiles"], np.int64)
        if codes is None:
            named = zip(entry["range"], codec.group_by_face(tiles, side // tile), strict=True)
            parts = [decode_ranges(name, None, 1, face_tiles) for name, (_, face_tiles) in named]
            codes, changed = (np.concatenate(arrays) for arrays in zip(*parts, strict=True))
        elif len(tiles):
            codes, changed = decode_ranges(entry["range"], codes, 6, tiles)
        if len(tiles):
            # Replace changed texels and their neighbours by those of the image of tiles.
            rows = -(-len(tiles) // layout.tiles_per_row)
            sheet = decode_color(entry["color"], layout.tiles_per_row * tile, rows * tile)
            replaced = codec.tiles_of(codec.with_neighbours(changed), tiles, tile)[..., None]
            new_tiles = codec.tiles_of_sheet(sheet, len(tiles), tile)
            codec.put_tiles(faces, tiles, np.where(replaced, new_tiles, codec.tiles_of(faces, tiles, tile)))
    return faces, None if codes is None else layout.scale.ranges(codes)


def ring_scene(name: str, parts: Sequence[str], read: Read, location: str, *, moves: bool = False) -> Scene:
    """Read the geometry of a ring, all of it dynamic with `moves`; FormatError that names the file if it is damaged."""
    from nearfar._scene import load

    with tempfile.TemporaryDirectory() as folder:
        paths = {part: Path(folder) / PurePosixPath(part).name for part in (name, *parts)}
        for part, path in paths.items():
            path.write_bytes(read(part))
        try:
            return Scene(**load.load(paths[name], LoadOptions(), moves=moves))
        except SceneError as error:
            raise FormatError(str(error).replace(str(paths[name]), location)) from None


def moving_scene(entry: dict[str, Any], read: Read, location: str) -> Scene:
    """Read the dynamic objects; FormatError that names the file if it is damaged or does not fit its manifest entry.

    Meshes come from the glTF reader; placements are taken from the document itself, so that they stay bit-exact.
    """
    name = entry["geometry"]
    loaded = ring_scene(name, entry["parts"], read, location, moves=True)
    with formats.guarded(location):
        origin, nodes = nodes_of(read(name))
        rows = check.items("instances", entry["instances"], dict, "descriptions of instances")
        if not len(rows) == len(nodes) == len(loaded._names):
            raise ValueError(f"expected {len(rows)} dynamic objects, got {len(nodes)}")
        placements = np.array([placement_of(node) for node in nodes])
        if not np.isfinite(placements).all():
            raise ValueError("expected finite matrices")
        names = Names(tuple(dict.fromkeys(str(row["object"]) for row in rows)))
        frames, at_load = frames_of(rows, names, placements, location)
        parts = {
            **_core.scene_parts(loaded._core),
            "origin": origin,
            "meshes": _merge_meshes(loaded._core),
            "placements": placements,
            "objects": np.array([names.number("object", row["object"]) for row in rows], np.int32),
        }
        core = _core.Scene(parts)
        if not np.abs(core.bounds()).max() <= check.FARTHEST:
            raise ValueError(f"expected positions up to {check.FARTHEST:g} m")
        return Scene(core, names, frames=frames, load_placements=at_load, notes=loaded._notes, undrawn=loaded._undrawn)


def _merge_meshes(core: _core.Scene) -> list[_core.Mesh]:
    """Merge the reader's meshes, one per material, to one mesh per object; objects that shared meshes still do."""
    owner, meshes = core.moving_objects(), _core.scene_parts(core)["meshes"]
    order = np.argsort(owner, kind="stable")
    objects = np.split(order, np.flatnonzero(np.diff(owner[order])) + 1)
    keys = [tuple(core.mesh_ids()[rows].tolist()) for rows in objects]
    merged = dict[tuple[int, ...], _core.Mesh]()
    for key, rows in zip(keys, objects, strict=True):
        if key not in merged:
            parts, placements = [meshes[row] for row in rows], np.tile(np.eye(4)[:3], (len(rows), 1, 1))
            is_one = len(rows) == 1
            merged[key] = parts[0] if is_one else _core.Mesh.merged(parts, placements, np.zeros(len(rows), np.int32))
    return [merged[key] for key in keys]


def join_rings(moving: Scene | None, rings: Sequence[tuple[str, Scene]]) -> Scene:
    """Join dynamic objects and named rings into one scene; each ring becomes one object that is drawn whole."""
    if not rings:
        return Scene(empty_core((0.0, 0.0, 0.0)), Names(())) if moving is None else moving
    base = empty_core(rings[0][1]._core.origin) if moving is None else moving._core
    core, meshes = _core.with_surfaces(base, [_move_to_zero(scene._core) for _, scene in rings])
    moving_names = () if moving is None else moving.object_names
    names = distinct([*moving_names, *(name for name, _ in rings)])
    placements = np.tile(np.eye(4)[:3], (len(rings), 1, 1))
    placements[:, :, 3] = [scene.origin - np.asarray(core.origin) for _, scene in rings]
    numbers = np.arange(len(moving_names), len(names), dtype=np.int32)
    joined = _core.with_instances(core, meshes, placements, numbers, 0)
    at_load = placements if moving is None else np.concatenate([moving._load_placements, placements])
    return Scene(joined, Names(names), frames=None if moving is None else moving._frames, load_placements=at_load)


def _move_to_zero(core: _core.Scene) -> _core.Scene:
    """Move a scene's origin to 0, so that its merged mesh keeps small coordinates."""
    return _core.Scene(_core.scene_parts(core) | {"origin": (0.0, 0.0, 0.0)}) if any(core.origin) else core
