"""Colours by class of surface and city object, which city models name but seldom colour."""

from __future__ import annotations

import numpy as np

from nearfar._scene.materials import PLAIN, BaseColor
from nearfar._scene.srgb import to_linear


def color(srgb: tuple[float, float, float]) -> BaseColor:
    """Return the base colour for sRGB values in 0..1."""
    red, green, blue = to_linear(np.array(srgb)).tolist()
    return BaseColor(factor=(red, green, blue, 1.0))


def _color(code: str) -> BaseColor:
    red, green, blue = (int(code[at : at + 2], 16) / 255 for at in (1, 3, 5))
    return color((red, green, blue))


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
