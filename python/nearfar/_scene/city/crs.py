"""Coordinate reference systems that files state, and conversions of their points to world metres."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._scene.coordinates import is_number
from nearfar._scene.frames import earth_centred, local

_DIGITS = 5
"""Decimals of a computed origin's degrees: about a metre on the ground."""

_EPSG = re.compile(r"EPSG(?::|/)+(?:[0-9.]*(?::|/))?([0-9]{4,6})", re.IGNORECASE)

_GEOGRAPHIC = {
    *(4167, 4171, 4230, 4258, 4269, 4283, 4326, 4490, 4612),
    *(4619, 4674, 4937, 4979, 6318, 6319, 6668, 6697, 7844),
}
"""EPSG codes of systems in degrees that city files use; they differ from WGS84 by metres, 4230 by up to 200 m."""


def epsg(name: str) -> int | None:
    """Find the EPSG code in a name such as "urn:ogc:def:crs:EPSG::7415" or ".../def/crs/EPSG/0/28992", if any."""
    match = _EPSG.search(name)
    return int(match[1]) if match else None


def is_degrees(name: str) -> bool:
    """Whether a coordinate system's name means longitude and latitude."""
    return "CRS84" in name.upper() or epsg(name) in _GEOGRAPHIC


def parse_projjson(crs: Any) -> tuple[str, bool, float]:
    """Name of a coordinate system in PROJJSON, whether it is in degrees, and metres per unit."""
    if not isinstance(crs, dict):
        return "unknown", False, 1.0
    if crs.get("type") == "BoundCRS":
        return parse_projjson(crs.get("source_crs"))
    components = crs.get("components")
    if isinstance(components, list) and components:
        return parse_projjson(components[0])
    identity = crs.get("id")
    code = f"{identity.get('authority')}:{identity.get('code')}" if isinstance(identity, dict) else ""
    name = " ".join(filter(None, [code, str(crs.get("name", ""))])) or "unknown"
    return name, str(crs.get("type", "")).startswith("Geographic"), _metres(crs.get("coordinate_system"))


def _metres(system: Any) -> float:
    axes = system.get("axis") if isinstance(system, dict) else None
    unit = axes[0].get("unit") if isinstance(axes, list) and axes and isinstance(axes[0], dict) else None
    factor = unit.get("conversion_factor") if isinstance(unit, dict) else None
    return float(factor) if is_number(factor) and 0 < factor < 1e6 else 1.0


@dataclass(frozen=True)
class Projected:
    """Converts projected coordinates, east and north, by their unit only."""

    system: str
    """Name of the coordinate system, for notes."""
    metres: float = 1.0
    """Metres per unit."""

    @property
    def note(self) -> str:
        """Sentence that describes the world's coordinates."""
        return f"coordinates of {self.system} {'as they are' if self.keeps_coordinates else 'in metres'}"

    @property
    def keeps_coordinates(self) -> bool:
        """Whether the world's coordinates are the file's own."""
        return self.metres == 1

    def world(self, points: NDArray[np.float64], heights: NDArray[np.float64]) -> NDArray[np.float64]:
        """Convert points (N, 2) of the file and heights (N,) in metres to world metres (N, 3)."""
        return np.stack([points[:, 0] * self.metres, heights, points[:, 1] * -self.metres], axis=-1)


@dataclass(frozen=True)
class Geodetic:
    """Converts longitudes and latitudes in degrees to the local frame at an origin; the Earth's curvature remains."""

    longitude: float
    latitude: float
    height: float = 0.0
    """Height of the origin above the ellipsoid, metres; longitude and latitude are degrees."""

    @classmethod
    def frame_centred_on(cls, points: NDArray[np.float64]) -> Geodetic:
        """Return the frame at the centre of points (N, 2)."""
        if not len(points):
            return cls(0.0, 0.0)
        longitude, latitude = np.round((points.min(axis=0) + points.max(axis=0)) / 2, _DIGITS).tolist()
        return cls(longitude, latitude)

    @property
    def note(self) -> str:
        height = f", height {self.height:g} m" if self.height else ""
        return f"local frame at longitude {self.longitude:g}°, latitude {self.latitude:g}°{height}"

    @property
    def keeps_coordinates(self) -> bool:
        return False

    def world(self, points: NDArray[np.float64], heights: NDArray[np.float64]) -> NDArray[np.float64]:
        to_local = local((self.longitude, self.latitude, self.height)).to_scene
        earth_points = earth_centred(np.concatenate([np.radians(points), heights[:, None]], axis=1))
        return earth_points @ to_local[:3, :3].T + to_local[:3, 3]


Georeference = Projected | Geodetic
"""Converts points and heights to world positions."""
