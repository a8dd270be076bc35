"""Coordinate frames in float64: geodetic, Earth-centred (WGS84) and local; axes of glTF, tiles and scenes.

Earth-centred coordinates (ECEF, EPSG:4978) are metres: x through longitude 0 on the equator, z through the north pole.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base import check

Floats = NDArray[np.float64]

EQUATOR = 6_378_137.0
"""Semi-major axis of WGS84 in metres."""

FLATTENING = 1 / 298.257223563
_POLE = EQUATOR * (1 - FLATTENING)
"""Semi-minor axis in metres."""

_ECCENTRICITY_SQUARED = FLATTENING * (2 - FLATTENING)

RADIUS = 6_350_000.0
"""Least distance of the ground from the Earth's centre, rounded down, metres."""

LOWEST, HIGHEST = -30_000.0, 100_000.0
"""Range of heights in metres of the centre of an Earth-centred tileset."""

_PLACES, _HEIGHT_PLACES = 9, 3
"""Decimals of an origin's degrees (0.1 mm on the ground) and of its height in metres (1 mm)."""

TO_Z_UP = {
    "X": np.array([[0.0, 0, -1, 0], [0, 1, 0, 0], [1, 0, 0, 0], [0, 0, 0, 1]]),
    "Y": np.array([[1.0, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1]]),
    "Z": np.eye(4),
}
"""Rotations from glTF with the given up axis to the axes of tiles (3D Tiles 1.1, "glTF transforms")."""

Z_UP_TO_SCENE = np.array([[1.0, 0, 0, 0], [0, 0, 1, 0], [0, -1, 0, 0], [0, 0, 0, 1]])
"""Rotation from the axes of tiles to those of scenes: (x, y, z) becomes (x, z, −y)."""


def earth_centred(geodetic: Floats) -> Floats:
    """Convert longitude and latitude in radians and height above the ellipsoid in metres (…, 3) to metres (…, 3)."""
    longitude, latitude, height = np.moveaxis(geodetic, -1, 0)
    normal = EQUATOR / np.sqrt(1 - _ECCENTRICITY_SQUARED * np.sin(latitude) ** 2)
    axis_distance = (normal + height) * np.cos(latitude)
    z = (normal * (1 - _ECCENTRICITY_SQUARED) + height) * np.sin(latitude)
    return np.stack([axis_distance * np.cos(longitude), axis_distance * np.sin(longitude), z], axis=-1)


def geodetic(points: Floats) -> Floats:
    """Convert Earth-centred metres (…, 3) to longitude and latitude in radians and height in metres (…, 3).

    Bowring's iteration of the reduced latitude: three steps reach float64's precision from 5,000 km below the ground to
    geostationary orbits.
    """
    x, y, z = np.moveaxis(points, -1, 0)
    axis_distance = np.hypot(x, y)
    latitude = reduced = np.arctan2(z * EQUATOR, axis_distance * _POLE)
    second_eccentricity = _ECCENTRICITY_SQUARED / (1 - _ECCENTRICITY_SQUARED)
    for _ in range(3):
        rise = z + second_eccentricity * _POLE * np.sin(reduced) ** 3
        latitude = np.arctan2(rise, axis_distance - _ECCENTRICITY_SQUARED * EQUATOR * np.cos(reduced) ** 3)
        reduced = np.arctan2(_POLE * np.sin(latitude), EQUATOR * np.cos(latitude))
    foot_distance, foot_z = EQUATOR * np.cos(reduced), _POLE * np.sin(reduced)
    height = (axis_distance - foot_distance) * np.cos(latitude) + (z - foot_z) * np.sin(latitude)
    return np.stack([np.arctan2(y, x), latitude, height], axis=-1)


def local_to_earth(longitude: float, latitude: float, height: float = 0.0) -> Floats:
    """Matrix (4, 4) from a local frame to Earth-centred coordinates, in metres, for column vectors.

    The local frame has x east, y up along the ellipsoid's normal and z south. Its origin is the given place, in radians
    and metres.
    """
    origin = np.array([longitude, latitude, height], np.float64)
    east, north, up = east_north_up(origin).T
    return np.vstack([np.column_stack([east, up, -north, earth_centred(origin)]), [0.0, 0, 0, 1]])


def east_north_up(places: Floats) -> Floats:
    """Rotations (…, 3, 3) with columns east, north and up at longitudes and latitudes (…, 2+), radians."""
    longitude, latitude = places[..., 0], places[..., 1]
    (sin_lon, cos_lon), (sin_lat, cos_lat) = ((np.sin(angle), np.cos(angle)) for angle in (longitude, latitude))
    east = [-sin_lon, cos_lon, np.zeros_like(longitude)]
    north = [-sin_lat * cos_lon, -sin_lat * sin_lon, cos_lat]
    up = [cos_lat * cos_lon, cos_lat * sin_lon, sin_lat]
    return np.stack([np.stack(column, axis=-1) for column in (east, north, up)], axis=-1)


def earth_to_local(longitude: float, latitude: float, height: float = 0.0) -> Floats:
    """Inverse of `local_to_earth`."""
    to_earth = local_to_earth(longitude, latitude, height)
    inverse = np.eye(4)
    inverse[:3, :3] = to_earth[:3, :3].T
    inverse[:3, 3] = -to_earth[:3, :3].T @ to_earth[:3, 3]
    return inverse


@dataclass(frozen=True)
class Frame:
    """Transform from the tiles' frame to the scene's."""

    to_scene: Floats
    """Rigid transform (4, 4)."""
    origin: tuple[float, float, float] | None = None
    """Longitude and latitude in degrees and height in metres of the scene's (0, 0, 0); None off the Earth."""

    @property
    def note(self) -> str:
        """Sentence that states the origin; empty off the Earth."""
        if self.origin is None:
            return ""
        longitude, latitude, height = self.origin
        place = f"longitude {longitude:.{_PLACES}f}°, latitude {latitude:.{_PLACES}f}°, height {height:.3f} m"
        return f"local frame with its origin at {place}; x points east, y up, z south"


PLAIN = Frame(Z_UP_TO_SCENE)
"""Frame for tilesets off the Earth."""


def local(origin: Sequence[float]) -> Frame:
    """Return the frame at an origin in degrees and metres: x points east, y up and z south."""
    longitude, latitude, height = (float(value) for value in origin)
    return Frame(earth_to_local(np.radians(longitude), np.radians(latitude), height), (longitude, latitude, height))


def local_frame_at(middle: Floats) -> Frame | None:
    """Return the local frame at a point near the Earth's surface, rounded as in `note`; None for other points."""
    longitude, latitude, height = geodetic(middle).tolist()
    if not LOWEST <= height <= HIGHEST:
        return None
    longitude, latitude = np.degrees([longitude, latitude]).tolist()
    return local((round(longitude, _PLACES), round(latitude, _PLACES), round(height, _HEIGHT_PLACES)))


def checked_origin(origin: Any) -> tuple[float, float, float] | None:
    """Check an argument `origin`: longitude, latitude and height; None for None."""
    if origin is None:
        return None
    longitude, latitude, height = check.vector("origin", origin)
    if not (-360 <= longitude <= 360 and -90 <= latitude <= 90 and -1e7 <= height <= 1e9):
        got = f"{longitude:g}, {latitude:g}, {height:g}"
        raise ValueError(
            f"origin: expected longitude within ±360°, latitude within ±90° and a height in metres, got {got}"
        )
    return longitude, latitude, height
