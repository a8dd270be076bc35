"""Colours of a geometry's surfaces: those of their materials, else those of their classes."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from typing import Any

import numpy as np

from nearfar._base.errors import UnusableError
from nearfar._scene.entries import entry, numbers, typed
from nearfar._scene.materials import PLAIN, BaseColor
from nearfar._scene.srgb import to_linear


def _from_srgb(srgb: tuple[float, float, float]) -> BaseColor:
    """Return the base colour for sRGB values in 0..1."""
    red, green, blue = to_linear(np.array(srgb)).tolist()
    return BaseColor(factor=(red, green, blue, 1.0))


def _color(code: str) -> BaseColor:
    red, green, blue = (int(code[start : start + 2], 16) / 255 for start in (1, 3, 5))
    return _from_srgb((red, green, blue))


_WALL, _ROOF, _GROUND, _PAVED, _ROAD = (_color(c) for c in ("#d9cfbd", "#a5533c", "#77706a", "#9c9a96", "#5f6064"))
_WATER, _GREEN, _GRASS = (_color(code) for code in ("#4d7ba6", "#4f7a3d", "#93a36a"))

SURFACES = {
    "RoofSurface": _ROOF,
    **dict.fromkeys(("WallSurface", "ClosureSurface", "InteriorWallSurface", "CeilingSurface"), _WALL),
    **dict.fromkeys(("GroundSurface", "OuterCeilingSurface", "WaterGroundSurface", "TransportationHole"), _GROUND),
    **dict.fromkeys(("OuterFloorSurface", "FloorSurface"), _PAVED),
    **dict.fromkeys(("WaterSurface", "WaterClosureSurface"), _WATER),
    "Window": _color("#6d8ea6"),
    "Door": _color("#6b4a33"),
    "TrafficArea": _ROAD,
    "AuxiliaryTrafficArea": _GRASS,
    "TransportationMarking": _color("#e8e8e2"),
}
"""Colours of surfaces by semantic class."""

OBJECTS = {
    **{f"Building{part}": _WALL for part in ("", "Part", "Installation", "Room", "Storey", "Unit")},
    **dict.fromkeys(("Bridge", "BridgePart", "Tunnel", "TunnelPart", "TransportSquare"), _PAVED),
    "Road": _ROAD,
    "Railway": _GROUND,
    **dict.fromkeys(("LandUse", "TINRelief"), _GRASS),
    **dict.fromkeys(("PlantCover", "SolitaryVegetationObject"), _GREEN),
    **dict.fromkeys(("WaterBody", "Waterway"), _WATER),
}
"""Colours of surfaces without semantics by type of city object; other types have the plain colour."""


def color_of_surface(surface: str | None, kind: str) -> BaseColor:
    """Return the colour of a surface by its class, else by the type of its object."""
    return SURFACES.get(surface or "", OBJECTS.get(kind, PLAIN))


class Appearance:
    """Materials of a document or a feature, whose entry ``appearance`` lists them, and notes on undrawn parts."""

    def __init__(self, feature: dict[str, Any]) -> None:
        appearance = entry(feature, "appearance", dict, "", {})
        self._theme = appearance.get("default-theme-material")
        self._materials = [
            self._color(item, f"appearance.materials[{number}]")
            for number, item in enumerate(entry(appearance, "materials", list, "appearance.", []))
        ]
        self.notes = Counter[tuple[str, str]]()
        """Numbers of parts that are not drawn, by a noun and its complement."""
        if textures := len(entry(appearance, "textures", list, "appearance.", [])):
            self.notes["texture", "not drawn"] = textures

    def _color(self, item: Any, json_path: str) -> BaseColor:
        material = typed(item, dict, json_path)
        diffuse = material.get("diffuseColor")
        values = numbers([0.8, 0.8, 0.8] if diffuse is None else diffuse, f"{json_path}.diffuseColor", None)
        if values.shape != (3,):
            raise UnusableError(f"{json_path}.diffuseColor: expected three numbers, got {len(values)}")
        red, green, blue = values.clip(0, 1).tolist()
        color = _from_srgb((red, green, blue))
        transparency = material.get("transparency")
        is_clear = isinstance(transparency, int | float) and transparency > 0
        return replace(color, notes=("with transparency drawn opaque",)) if is_clear else color

    def colors(
        self, geometry: dict[str, Any], boundaries: list[Any], depth: int, kind: str, prefix: str
    ) -> list[BaseColor]:
        """Colour of each surface of a geometry whose boundaries have `depth` levels of lists above surfaces."""
        semantics = entry(geometry, "semantics", dict, prefix, {})
        surfaces = entry(semantics, "surfaces", list, f"{prefix}semantics.", [])
        types = [item.get("type") if isinstance(item, dict) else None for item in surfaces]
        class_colors = [color_of_surface(name if isinstance(name, str) else None, kind) for name in types]
        plain = color_of_surface(None, kind)
        labels = _labels(semantics.get("values"), boundaries, depth)
        colors = [_index_or_default(class_colors, label, plain) for label in labels]
        if not self._materials:
            return colors
        theme = self._theme_of(entry(geometry, "material", dict, prefix, {}))
        label = theme.get("value")
        labels = [label] * len(colors) if isinstance(label, int) else _labels(theme.get("values"), boundaries, depth)
        return [_index_or_default(self._materials, label, color) for label, color in zip(labels, colors, strict=True)]

    def _theme_of(self, themes: dict[str, Any]) -> dict[str, Any]:
        """Return the default theme's materials, else those of the first theme."""
        theme = themes.get(self._theme) if isinstance(self._theme, str) else None
        theme = next(iter(themes.values()), None) if theme is None else theme
        return theme if isinstance(theme, dict) else {}


def _index_or_default(items: list[BaseColor], number: int | None, default: BaseColor) -> BaseColor:
    return items[number] if number is not None and 0 <= number < len(items) else default


def _labels(values: Any, boundaries: list[Any], depth: int) -> list[int | None]:
    """Index for each surface from lists nested like the boundaries; None where missing."""
    parts = values if isinstance(values, list) else []
    padded = [*parts[: len(boundaries)], *[None] * (len(boundaries) - len(parts))]
    if depth:
        pairs = zip(padded, boundaries, strict=True)
        return [label for part, inner_boundaries in pairs for label in _labels(part, inner_boundaries, depth - 1)]
    return [part if isinstance(part, int) and not isinstance(part, bool) else None for part in padded]
