"""Exports trees for splat viewers: files of Gaussians, or tiles of them; see `OrthoTree.export_splats`."""

from __future__ import annotations

import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from numpy.typing import ArrayLike

from nearfar._base import check, files
from nearfar._base.errors import UnusableError
from nearfar.orthoview import _splat_file, _splat_tiles
from nearfar.orthoview._gaussians import SUN
from nearfar.orthoview._splat_cells import Cells, Sun

FORMATS = ("spz", "gltf", "tiles")
SUFFIXES = {".spz": "spz", ".glb": "gltf", "": "tiles"}


def export(
    cells: Cells,
    target: Path,
    *,
    format: str | None,  # noqa: A002 - the name of the public face
    level: int,
    compression: str | None,
) -> dict[str, int]:
    """Write cells of a complete tree for splat viewers; the arguments are those of `OrthoTree.export_splats`."""
    kind = format_of(target) if format is None else check.choice("format", format, FORMATS)
    packed = compression is not None and check.choice("compression", compression, ("spz",)) == "spz"
    if packed and kind == "spz":
        raise ValueError('compression: expected None for format="spz", whose files are SPZ anyway')
    extras: Mapping[str, Any] = {"light": "none" if cells.sun is None else {"sun": list(cells.sun)}}
    try:
        if kind == "tiles":
            with files.atomic_folder(target, marker=_splat_tiles.TILESET) as folder:
                counts = _splat_tiles.write(folder, cells, level, packed=packed, extras=extras)
                _check_any(counts)
        else:
            with files.atomic_file(target) as temporary:
                is_gltf = kind == "gltf"
                counts = _splat_file.write(
                    temporary, target, cells, level, packed=packed or not is_gltf, is_gltf=is_gltf, extras=extras
                )
                _check_any(counts)
    except UnusableError as error:
        raise ValueError(f"level: {error}") from None
    return counts


def _check_any(counts: dict[str, int]) -> None:
    if not counts["splats"]:
        raise ValueError("aabb: expected a box in which views show something")


def format_of(path: Path) -> str:
    """Return the format for a file's suffix."""
    if path.suffix.lower() not in SUFFIXES:
        raise ValueError(f"path: expected a file .spz or .glb, or a folder without a suffix, got {path.name}")
    return SUFFIXES[path.suffix.lower()]


def sun_of(light: str | ArrayLike | None) -> Sun:
    """Return the unit vector towards the sun for an argument `light`; None for no light."""
    if light is None:
        return None
    if isinstance(light, str):
        check.choice("light", light, ("sun",))
        return SUN
    x, y, z = check.vector("light", light)
    length = math.sqrt(x * x + y * y + z * z)
    if not 0.0 < length < math.inf:
        raise ValueError(f"light: expected a direction that is not 0, got {check.value_or_type(light)}")
    return x / length, y / length, z / length
