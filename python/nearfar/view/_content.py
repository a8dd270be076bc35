"""Files for the viewer by the names that the page requests: of a bundle, or of a reduced scene converted to a bundle.

The bundle of a reduced scene has one region with one ring, the near part. Map 0 shows the whole scene as seen from the
centre; the map of ring 1 is the reduced scene's own map. The conversion is lossless, except that colours are rounded to
8-bit sRGB.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base import formats, remote
from nearfar._camera.camera import Camera, CubeFace
from nearfar._cubemap.envmap import EnvMap
from nearfar._cubemap.layouts import envmap_directions
from nearfar._partition.partition import partition
from nearfar._reduce.folder import DOCUMENT
from nearfar._reduce.reduced_scene import ReducedScene
from nearfar._scene.scene import Scene
from nearfar.stream import _stages, _store
from nearfar.stream._assign import Rings, assign
from nearfar.stream._bundle import Bundle
from nearfar.stream._encode import Geometry, TextureFiles, scale_of
from nearfar.stream._growth import Growth
from nearfar.stream._map_files import with_neighbours
from nearfar.stream._maps import TILE, RingMaps
from nearfar.stream._settings import MAX_FACE_SIZE, ExportSettings
from nearfar.stream._store import Files

Read = Callable[[], bytes]
"""Returns the content of a file."""

SAMPLES = 4
"""Colour samples per texel of map 0 where it shows the near part."""

SETTINGS = ExportSettings(quality=None)
"""Settings of bundles for lossless images."""

BLANK_FACE_SIZE = 64
"""Texels along a face of the blank map of scenes without a map."""


def reduced_folder(path: str | os.PathLike[str]) -> Path | None:
    """Return the folder of a reduced scene at a path; None if there is none."""
    if remote.is_url(path):
        return None
    folder = remote.local(path)
    folder = folder.parent if folder.name == DOCUMENT else folder
    return folder if (folder / DOCUMENT).is_file() else None


def of_bundle(bundle: Bundle, read: Callable[[str], bytes]) -> dict[str, Read]:
    """Return readers for the files of a bundle, which are read on request."""
    manifest = partial(bytes, formats.to_json(bundle._manifest).encode())
    return {**{name: partial(read, name) for name in (*bundle.files, _store.TILESET)}, _store.MANIFEST: manifest}


def reduced_files(folder: Path) -> dict[str, bytes]:
    """Load the reduced scene of a folder and convert it to a bundle; returns the bundle's files by name."""
    return files_of(ReducedScene.load(folder))


def files_of(reduced: ReducedScene) -> dict[str, bytes]:
    """Convert a reduced scene to a bundle; returns its files by name, including manifest and tileset.

    ValueError for the conventional method, which has no morph.
    """
    if reduced.morph == "none":
        raise ValueError("morph: expected 'blend' or 'cylinder' to show, got 'none'; see ReducedScene.with_morph")
    near_scene = reduced._near_part
    rings = _rings(near_scene, reduced)
    maps = _maps(near_scene, reduced, rings)
    files = Files()
    textures = TextureFiles(near_scene, SETTINGS.quality).encode(np.zeros(near_scene._core.texture_count, np.uint32))
    geometry = Geometry(rings, files, textures, SETTINGS)
    dynamic = geometry.moving()
    scale = scale_of(maps, SETTINGS.range_error)
    entries = list(_stages.ring_entries(maps, scale, geometry.groups("ring"), files, SETTINGS))
    region = _stages.region_entry(rings, scale, entries, findings=())
    region["fold_margin"] = max(reduced._core.fold_margin(reduced.center, None, 1.0), 0.0)
    facts = {
        "color_space": "sRGB",
        "morph": {"kind": reduced.morph, "near_share": reduced.r1 / reduced.r2},
        "unit": "triangle",
        "growth": Growth((reduced.r2,)).to_manifest(),
        "triangles": reduced.stats["triangles"],
        "bounds": near_scene.bounds.tolist() if near_scene.triangle_count else [[*reduced.center], [*reduced.center]],
    }
    face_size, notes = maps.first.face_size, near_scene.report.notes
    manifest = _stages.manifest_of(facts, face_size, [region], dynamic, notes, files)
    return {**files.content, **_stages.closing_files(manifest, files)}


def _rings(near_scene: Scene, reduced: ReducedScene) -> Rings:
    """Assign all static geometry to ring 1, also parts that would lie beyond it because of rounding."""
    rings = assign(near_scene, center=reduced.center, radii=[reduced.r2])
    return replace(rings, ring=np.minimum(rings.ring, 1), rest=1)


def _maps(near_scene: Scene, reduced: ReducedScene, rings: Rings) -> RingMaps:
    """Build the maps: first the reduced scene's map with its static near part in front, then its own map."""
    far_map = _far_map(reduced)
    static = near_scene.subset(triangles=np.arange(near_scene._core.standing_triangle_count))
    near_color, is_near = _render_near_part(static, reduced, far_map)
    color = np.where(is_near[..., None], near_color, far_map.color)
    first = EnvMap(reduced.center, color=color, range=far_map.range)
    texels = np.flatnonzero(is_near)
    assert far_map.range is not None
    change: dict[str, NDArray[Any]] = {
        "texels": texels,
        "color": far_map.color.reshape(-1, 3)[texels],
        "range": far_map.range.reshape(-1)[texels],
    }
    return RingMaps(rings, first, (change,), SAMPLES)


def _far_map(reduced: ReducedScene) -> EnvMap:
    """Convert the reduced scene's map to float32 with range, and to a face size of whole tiles."""
    env = reduced.env
    if env is None:
        shape = (6, BLANK_FACE_SIZE, BLANK_FACE_SIZE)
        return EnvMap(reduced.center, color=np.zeros((*shape, 3), np.float32), range=np.full(shape, np.inf, np.float32))
    size = min(-(-env.face_size // TILE) * TILE, MAX_FACE_SIZE)
    if size == env.face_size:
        color, ranges = env.color, env.range
    else:
        directions = envmap_directions(size)
        color = env.sample(directions)
        ranges = None if env.range is None else env.sample(directions, channel="range", filter="max")
    if ranges is None:
        # Only moving objects need the map's range, and there are none.
        ranges = np.full((6, size, size), np.inf)
    return EnvMap(reduced.center, color=np.asarray(color, np.float32), range=np.asarray(ranges, np.float32))


def _render_near_part(
    static: Scene, reduced: ReducedScene, far_map: EnvMap
) -> tuple[NDArray[np.float32], NDArray[np.bool_]]:
    """Render the colours (6, S, S, 3) seen from the centre, and mark texels within one texel of the near part."""
    size = far_map.face_size
    zones = partition(static, center=reduced.center, r1=reduced.r1, r2=reduced.r2)
    counts = {**reduced._counts, **zones.summary()}
    facts: dict[str, Any] = {"morph": reduced.morph, "boundary": "r2", "counts": counts, "is_whole": False}
    static_reduced = ReducedScene(static, zones, replace(far_map, range=None), **facts)
    settings: dict[str, Any] = {"samples": SAMPLES, "channels": ("color", "face_id"), "tolerance_px": np.inf}
    cameras = [Camera(reduced.center, fov=CubeFace(face), size=(size, size)) for face in range(6)]
    frames = [static_reduced.render(camera, **settings) for camera in cameras]
    is_near = np.stack([frame.require("face_id") >= 0 for frame in frames])
    return np.stack([frame.require("color") for frame in frames]), with_neighbours(is_near)
