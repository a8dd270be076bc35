"""Emission of materials, and whether they are unlit, in glTF's terms."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from nearfar._scene.coordinates import TRANSFORM

UNLIT = "KHR_materials_unlit"
STRENGTH = "KHR_materials_emissive_strength"
FACTOR, MAP = "emissiveFactor", "emissiveTexture"

MOST_EMISSION = 65_503.0
"""Greatest emission: with the light that a surface reflects, at most 1, maps of 16-bit floats hold it."""

Light = tuple[float, float, float]
"""Linear RGB."""

DARK: Light = (0.0, 0.0, 0.0)


def is_unlit(material: Mapping[str, Any]) -> bool:
    """Whether a glTF material has no properties but its base colour, which is shown as it is."""
    return UNLIT in _extensions(material)


def is_beside_base(material: Mapping[str, Any]) -> bool:
    """Whether the texture of a glTF material's emission, if it has one, has the coordinates of the base colour's."""
    return MAP not in material or TRANSFORM not in _extensions(material[MAP])


def emission_of(material: Mapping[str, Any]) -> Light:
    """Light that is drawn of a glTF material, to be multiplied by its texture: factor × strength.

    Unlit materials emit none, and emission whose texture has coordinates of its own is not drawn.
    """
    factor = material.get(FACTOR)
    if factor is None or is_unlit(material) or not is_beside_base(material):
        return DARK
    strength = _extensions(material).get(STRENGTH, {}).get("emissiveStrength", 1.0)
    strength = strength if isinstance(strength, int | float) and math.isfinite(strength) else 1.0
    with np.errstate(over="ignore"):
        light = np.nan_to_num(np.array(factor, np.float64) * strength, nan=0.0, posinf=MOST_EMISSION)
    red, green, blue = np.clip(light, 0.0, MOST_EMISSION).tolist()
    return red, green, blue


def entries(light: Light, *, unlit: bool) -> dict[str, Any]:
    """Entries of a glTF material that emits light, or that is unlit. The format allows factors up to 1."""
    found: dict[str, Any] = {}
    extensions: dict[str, Any] = {UNLIT: {}} if unlit else {}
    strength = max(*light, 1.0)
    if light != DARK:
        # The product in float64 rounds to the same float32.
        found[FACTOR] = [part / strength for part in light]
    if strength > 1.0:
        extensions[STRENGTH] = {"emissiveStrength": strength}
    return found | ({"extensions": extensions} if extensions else {})


def without(material: Mapping[str, Any]) -> dict[str, Any]:
    """A copy of a glTF material that emits nothing."""
    extensions = {name: content for name, content in _extensions(material).items() if name != STRENGTH}
    rest = {key: value for key, value in material.items() if key not in (FACTOR, MAP, "extensions")}
    return rest | ({"extensions": extensions} if extensions else {})


def _extensions(material: Mapping[str, Any]) -> Mapping[str, Any]:
    extensions = material.get("extensions")
    return extensions if isinstance(extensions, Mapping) else {}
