"""Properties of Wavefront materials beside their base colour, in glTF's terms."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from nearfar._scene.srgb import to_linear

_MAPS = {
    "a normal map": ("map_bump", "bump", "norm", "map_kn"),
    "a map of emission": ("map_ke",),
    "an opacity map": ("map_d",),
    "a map of metal or gloss": ("map_ks", "map_ns", "map_pr", "map_pm", "map_refl", "refl"),
}


def opacity(entries: Mapping[str, Any]) -> float:
    """Opacity from 0 to 1: `d`, or else 1 − `Tr`. Some programs write the same number as both."""
    stated = min(_numbers(entries["d"], 1.0)) if "d" in entries else 1.0 - max(_numbers(entries.get("tr")))
    return float(np.clip(stated, 0.0, 1.0))


def as_gltf(entries: Mapping[str, Any]) -> dict[str, Any]:
    """Properties of a material that glTF has, too, besides its base colour: emission, metal, roughness, blending.

    Parameters
    ----------
    entries
        Keywords of the material in small letters with their values: numbers, or words as the file has them.
    """
    surface = {"metallicFactor": float(np.clip(_numbers(entries.get("pm"))[0], 0.0, 1.0))}
    if "pr" in entries:
        surface["roughnessFactor"] = float(np.clip(_numbers(entries["pr"], 1.0)[0], 0.0, 1.0))
    material: dict[str, Any] = {"pbrMetallicRoughness": surface, "doubleSided": True}
    emission = _numbers(entries.get("ke"))
    if max(emission) > 0.0:
        # One number stands for all three, and codes are sRGB as those of the diffuse colour.
        codes = np.array((emission * 3)[:3] if len(emission) < 3 else emission[:3])
        material["emissiveFactor"] = to_linear(np.clip(codes, 0.0, 1.0)).tolist()
    if opacity(entries) < 1.0:
        material["alphaMode"] = "BLEND"
    return material


def losses(entries: Mapping[str, Any]) -> tuple[str, ...]:
    """Maps of a material that are neither drawn nor saved, phrased to follow "2 materials"."""
    lost = (what for what, keywords in _MAPS.items() if any(keyword in entries for keyword in keywords))
    return tuple(f"with {what} drawn and saved without it" for what in lost)


def _numbers(value: Any, default: float = 0.0) -> list[float]:
    """The finite numbers of an entry, or the default if it has none."""
    values = value if isinstance(value, list | tuple) else [value]
    found = []
    for item in values:
        try:
            number = float(item)
        except (TypeError, ValueError):
            continue
        if math.isfinite(number):
            found.append(number)
    return found or [default]
