"""Properties of Wavefront materials besides the base colour, converted to glTF."""

from __future__ import annotations

import math
from collections.abc import Mapping
from contextlib import suppress
from typing import Any

import numpy as np

from nearfar._scene.emission import DARK, MAP, MAX_EMISSION, Light, entries as emission_entries
from nearfar._scene.srgb import to_linear

EMISSION_MAP = "map_ke"
EMISSION_IMAGE = "map_ke image"
"""Key of the image loaded for a material's emission map."""

_MAPS = {
    "a normal map": ("map_bump", "bump", "norm", "map_kn"),
    "a map of emission": (EMISSION_MAP,),
    "an opacity map": ("map_d",),
    "a map of metal or gloss": ("map_ks", "map_ns", "map_pr", "map_pm", "map_refl", "refl"),
}


def opacity(entries: Mapping[str, Any]) -> float:
    """Opacity from 0 to 1: `d`, else 1 − `Tr`; some programs write the same number for both."""
    stated = min(_numbers(entries["d"], 1.0)) if "d" in entries else 1.0 - max(_numbers(entries.get("tr")))
    return float(np.clip(stated, 0.0, 1.0))


def as_gltf(entries: Mapping[str, Any]) -> dict[str, Any]:
    """Convert a material's emission, metalness, roughness and blending to glTF.

    Entries are the material's keywords in lower case with their values: numbers, or words of the file.
    """
    surface = {"metallicFactor": float(np.clip(_numbers(entries.get("pm"))[0], 0.0, 1.0))}
    if "pr" in entries:
        surface["roughnessFactor"] = float(np.clip(_numbers(entries["pr"], 1.0)[0], 0.0, 1.0))
    material: dict[str, Any] = {"pbrMetallicRoughness": surface, "doubleSided": True}
    has_map = EMISSION_IMAGE in entries
    # Without its map, which may be dark in most places, emission is left out.
    emission = _emission(entries) if has_map or EMISSION_MAP not in entries else DARK
    material |= emission_entries(emission, unlit=False)
    if has_map and emission != DARK:
        material[MAP] = {"index": 0}
    if opacity(entries) < 1.0:
        material["alphaMode"] = "BLEND"
    return material


def _emission(entries: Mapping[str, Any]) -> Light:
    """Emission as linear RGB; it is white if there is a map but no colour."""
    numbers = _numbers(entries.get("ke"), 1.0 if EMISSION_IMAGE in entries else 0.0)
    # One number stands for all three. Values up to 1 are sRGB, like the diffuse colour; above 1 they are linear.
    codes = np.clip((numbers * 3)[:3] if len(numbers) < 3 else numbers[:3], 0.0, MAX_EMISSION)
    red, green, blue = np.where(codes > 1.0, codes, to_linear(np.minimum(codes, 1.0))).tolist()
    return red, green, blue


def losses(entries: Mapping[str, Any]) -> tuple[str, ...]:
    """Notes on maps of a material that are neither drawn nor saved, phrased to follow "2 materials"."""
    unused = {*entries} - ({EMISSION_MAP} if EMISSION_IMAGE in entries else set())
    maps = (name for name, keywords in _MAPS.items() if not unused.isdisjoint(keywords))
    return tuple(f"with {name} drawn and saved without it" for name in maps)


def _numbers(value: Any, default: float = 0.0) -> list[float]:
    """Finite numbers of an entry; the default if it has none."""
    values = value if isinstance(value, list | tuple) else [value]
    numbers = []
    for item in values:
        with suppress(TypeError, ValueError):
            numbers.append(float(item))
    return [number for number in numbers if math.isfinite(number)] or [default]
