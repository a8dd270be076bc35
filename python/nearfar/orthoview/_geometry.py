"""Encodes the triangles of a leaf as GLB files: one of static triangles, one of moving ones.

The format is that of bundles: meshopt compression, each mesh stored once with its placements, only properties of
materials that nearfar draws, textures in separate WebP files. Positions are multiples of a step, relative to a point in
the middle of the leaf. These points are an even number of steps apart, so that a corner is rounded alike in all leaves
(ties are rounded to even), and adjacent triangles of different leaves stay joined.
"""

from __future__ import annotations

import hashlib
import math
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import files, glb
from nearfar._scene.moving_rows import rows_of
from nearfar._scene.scene import Scene
from nearfar._scene.srgb import encode_texture
from nearfar.orthoview._grid import Grid, Place
from nearfar.orthoview._owners import owned_mask

MAX_STEP = 2.0**-10
"""Greatest step of positions, metres. Meshes placed once are off by at most half a step, instances by one step."""

STEP_SHARE = 2.0**-14
"""Greatest step of positions as a share of a leaf's side."""

_MAX_WEBP_SIDE = 16383
"""Greatest side of a WebP image; larger textures are halved."""

_MIN_STEP = 2.0**-40
"""Least step that the exporter accepts, metres."""

_MIDDLE_STEPS = 1024
"""Middle points of leaves are multiples of this number of steps, which is 1 m for the greatest step."""

QUALITY = 90
"""WebP quality of textures, 0 to 100."""

IMAGES = "../../../../images"
"""Folder of the texture files, relative to the folder of a GLB."""


def step_of(grid: Grid) -> float:
    """Step of positions in the leaves of a grid, a power of two, metres."""
    _, exponent = math.frexp(min(MAX_STEP, STEP_SHARE * grid.cell))
    return max(2.0 ** (exponent - 1), _MIN_STEP)


class Images:
    """Texture files, which all leaves share, named by a hash of their content; the first one creates the folder."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._written: set[str] = set()

    def add(self, texels: NDArray[np.uint8]) -> str:
        """Write a texture (H, W, 4), sRGB with alpha, unless its file exists; return the file's name."""
        shape = np.array(texels.shape, "<u4").tobytes()
        # 64 bits of a SHA-256: no two textures share a name by chance.
        name = f"{hashlib.sha256(shape + texels.tobytes()).hexdigest()[:16]}.webp"
        path = self._folder / name
        if name not in self._written and not path.exists():
            self._folder.mkdir(parents=True, exist_ok=True)
            with files.atomic_file(path) as temporary:
                files.write(temporary, encode_texture(_shrink_to_fit(texels), QUALITY))
        self._written.add(name)
        return name


def _shrink_to_fit(texels: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Halve a texture until it fits into a WebP image."""
    while max(texels.shape[:2]) > _MAX_WEBP_SIDE:
        texels = _core.halved_texture(texels, times=1, cutout=False)
    return texels


def cell_glb(part: Scene, grid: Grid, place: Place, images: Images | None = None) -> bytes | None:
    """Encode the static triangles that belong to a leaf as a GLB in world metres, y up; None if there are none.

    `part` is the result of querying the leaf's box. `images` stores the textures; None leaves them out. The `extras` of
    the GLB's `asset` have the number of `triangles`, the greatest `error` of a position along an axis, metres, and the
    bounding `box` in metres. Triangles that rounding leaves without area are omitted.
    """
    is_owned = _owned_triangles(part, grid, place, moving=False)
    if not is_owned.any():
        return None
    core = part._core if is_owned.all() else part._core.subset_of_triangles(is_owned)
    middle = _middle(grid, place)
    return _encode(_relative_to(core, middle), step_of(grid), images, [])


def moving_glb(part: Scene, grid: Grid, place: Place, images: Images | None = None) -> bytes | None:
    """Encode the moving triangles that belong to a leaf, in their present poses; see `cell_glb`.

    Each node is an instance with the name of its object. The `extras` also have `moving`, a row for each node in order:
    its `object`; and, where they are not the identity, `transform` (applied when the file was loaded) and `rest` (the
    placement in the rest pose).
    """
    is_owned = _owned_triangles(part, grid, place, moving=True)
    if not is_owned.any():
        return None
    movers = part.subset(triangles=is_owned)
    object_count = int(movers._core.moving_objects().max()) + 1
    data = _encode(_relative_to(movers._core, None), step_of(grid), images, list(movers.object_names[:object_count]))
    if data is None:
        return None
    document, _ = glb.header(data)
    document["asset"]["extras"]["moving"] = rows_of(movers, data)
    return glb.with_document(data, document)


def _owned_triangles(part: Scene, grid: Grid, place: Place, *, moving: bool) -> NDArray[np.bool_]:
    """Mask (T,) of the moving or the static triangles that belong to a leaf."""
    static_count = part._core.standing_triangle_count  # static triangles come first
    if moving and static_count == part.triangle_count:
        return np.zeros(part.triangle_count, bool)
    is_owned = owned_mask(part, grid, place)
    is_owned[slice(0, static_count) if moving else slice(static_count, None)] = False
    return is_owned


def _middle(grid: Grid, place: Place) -> NDArray[np.float64]:
    """World position (3,) in metres that positions in a leaf's file are relative to."""
    unit = _MIDDLE_STEPS * step_of(grid)
    return np.asarray(np.rint(grid.box(0, place).mean(axis=0) / unit) * unit)


def _relative_to(core: _core.Scene, origin: NDArray[np.float64] | None) -> _core.Scene:
    """The same scene relative to another origin, without unused textures."""
    parts = _core.scene_parts(core)
    if origin is not None:
        parts["placements"][:, :, 3] += np.array(parts["origin"]) - origin
        parts["origin"] = tuple(origin.tolist())
    if parts["textures"]:
        _prune(parts, core.mesh_ids())
    return _core.Scene(parts)


def _prune(parts: dict[str, Any], meshes: NDArray[np.uint64]) -> None:
    """Remove textures of materials that no face uses."""
    _, rows = np.unique(meshes, return_index=True)
    is_material_used = np.zeros(len(parts["material_colors"]) + 1, bool)
    for row in rows.tolist():
        is_material_used[_core.mesh_parts(parts["meshes"][row])["materials"]] = True
    # The last flag belongs to faces without a material, whose index is −1.
    is_used = np.zeros(len(parts["textures"]) + 1, bool)
    links = ("material_textures", "material_emission_textures")
    for name in links:
        parts[name] = np.where(is_material_used[:-1], parts[name], -1).astype(np.int32)
        is_used[parts[name]] = True
    numbers = np.append(np.cumsum(is_used[:-1]) - 1, -1).astype(np.int32)
    for name in links:
        parts[name] = numbers[parts[name]]
    parts["textures"] = [texels for texels, is_shown in zip(parts["textures"], is_used, strict=False) if is_shown]
    parts["texture_samplers"] = parts["texture_samplers"][is_used[:-1]]


def _encode(core: _core.Scene, step: float, images: Images | None, names: list[str]) -> bytes | None:
    """Encode a scene as a GLB; None if rounding leaves no face with an area."""
    uris: list[str | None] = [None] * core.texture_count
    if images is not None and uris:
        uris = [f"{IMAGES}/{images.add(texels)}" for texels in _core.scene_parts(core)["textures"]]
    group = np.zeros(1, np.uint16)  # all objects are in group 0: a single entry applies to all
    encoding: dict[str, Any] = {"step": step, "compressed": True}
    export = _core.Export(core, group, 1, names=names, images=uris, encoding=encoding)
    data, facts = export.glb(0, uris=[None] * len(export.shared()))
    if not facts["drawn"]:
        return None
    low, high = core.bounds()
    error = facts["position_error"]
    # Rounded outwards to whole steps, and a step larger, so that flat boxes have a volume and all corners are inside.
    box = [(np.floor((low - error) / step) - 1) * step, (np.ceil((high + error) / step) + 1) * step]
    document, _ = glb.header(data)
    document["asset"]["extras"] = {
        "triangles": facts["drawn"],
        "error": error,
        "box": [corner.tolist() for corner in box],
    }
    return glb.with_document(data, document)
