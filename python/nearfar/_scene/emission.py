"""Emission of glTF materials, and unlit materials."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from nearfar._scene.coordinates import TRANSFORM, object_of

UNLIT = "KHR_materials_unlit"
STRENGTH = "KHR_materials_emissive_strength"
FACTOR, MAP = "emissiveFactor", "emissiveTexture"

MAX_EMISSION = 65_503.0
"""Maximum emission: its sum with reflected light of at most 1 fits into the 16-bit floats of maps."""

Light = tuple[float, float, float]
"""Linear RGB of light."""

DARK: Light = (0.0, 0.0, 0.0)


def is_unlit(material: Mapping[str, Any]) -> bool:
    """Whether a glTF material is unlit: its base colour is shown unshaded, and other properties are ignored."""
    return UNLIT in object_of(material, "extensions")


def uses_base_coordinates(material: Mapping[str, Any]) -> bool:
    """Whether the emission's texture, if any, uses the base colour's texture coordinates."""
    return MAP not in material or TRANSFORM not in object_of(material[MAP], "extensions")


def emission_of(material: Mapping[str, Any]) -> Light:
    """Emission of a glTF material as drawn: factor × strength, which its texture multiplies.

    Unlit materials emit nothing, and emission whose texture has its own coordinates is not drawn.
    """
    factor = material.get(FACTOR)
    if factor is None or is_unlit(material) or not uses_base_coordinates(material):
        return DARK
    strength = object_of(material, "extensions").get(STRENGTH, {}).get("emissiveStrength", 1.0)
    strength = strength if isinstance(strength, int | float) and math.isfinite(strength) else 1.0
    with np.errstate(over="ignore"):
        light = np.nan_to_num(np.array(factor, np.float64) * strength, nan=0.0, posinf=MAX_EMISSION)
    red, green, blue = np.clip(light, 0.0, MAX_EMISSION).tolist()
    return red, green, blue


def entries(light: Light, *, unlit: bool) -> dict[str, Any]:
    """Return the glTF entries for an emissive or unlit material. The format limits factors to 1."""
    strength = max(*light, 1.0)
    # Readers get the float32 of `light` back: the float64 product of factor and strength rounds to it.
    factor = {FACTOR: [part / strength for part in light]} if light != DARK else {}
    extensions: dict[str, Any] = {UNLIT: {}} if unlit else {}
    if strength > 1.0:
        extensions[STRENGTH] = {"emissiveStrength": strength}
    return factor | ({"extensions": extensions} if extensions else {})


def strip_emission(material: Mapping[str, Any]) -> dict[str, Any]:
    """Copy a glTF material without its emission."""
    extensions = {name: content for name, content in object_of(material, "extensions").items() if name != STRENGTH}
    others = {key: value for key, value in material.items() if key not in (FACTOR, MAP, "extensions")}
    return others | ({"extensions": extensions} if extensions else {})
