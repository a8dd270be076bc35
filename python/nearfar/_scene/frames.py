"""WGS84: conversions between geodetic and Earth-centred coordinates, and local frames, in float64.

Earth-centred coordinates (ECEF, EPSG:4978) are metres: x through longitude 0 on the equator, z through the north pole.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

EQUATOR = 6_378_137.0
"""Semi-major axis of WGS84 in metres."""

FLATTENING = 1 / 298.257223563
_POLE = EQUATOR * (1 - FLATTENING)
"""Semi-minor axis in metres."""

_ECCENTRICITY_SQUARED = FLATTENING * (2 - FLATTENING)


def earth_centred(geodetic: NDArray[np.float64]) -> NDArray[np.float64]:
    """Convert longitude and latitude in radians and height above the ellipsoid in metres (…, 3) to metres (…, 3)."""
    longitude, latitude, height = np.moveaxis(geodetic, -1, 0)
    normal = EQUATOR / np.sqrt(1 - _ECCENTRICITY_SQUARED * np.sin(latitude) ** 2)
    axis_distance = (normal + height) * np.cos(latitude)
    z = (normal * (1 - _ECCENTRICITY_SQUARED) + height) * np.sin(latitude)
    return np.stack([axis_distance * np.cos(longitude), axis_distance * np.sin(longitude), z], axis=-1)


def geodetic(points: NDArray[np.float64]) -> NDArray[np.float64]:
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


def local_to_earth(longitude: float, latitude: float, height: float = 0.0) -> NDArray[np.float64]:
    """Matrix (4, 4) from a local frame to Earth-centred coordinates, in metres, for column vectors.

    The frame is nearfar's: x east, y up along the ellipsoid's normal, z south; its origin is the given place, radians.
    """
    origin = np.array([longitude, latitude, height], np.float64)
    east, north, up = east_north_up(origin).T
    return np.vstack([np.column_stack([east, up, -north, earth_centred(origin)]), [0.0, 0, 0, 1]])


def east_north_up(places: NDArray[np.float64]) -> NDArray[np.float64]:
    """Rotations (…, 3, 3) with columns east, north and up at longitudes and latitudes (…, 2+), radians."""
    longitude, latitude = places[..., 0], places[..., 1]
    (sin_lon, cos_lon), (sin_lat, cos_lat) = ((np.sin(angle), np.cos(angle)) for angle in (longitude, latitude))
    east = [-sin_lon, cos_lon, np.zeros_like(longitude)]
    north = [-sin_lat * cos_lon, -sin_lat * sin_lon, cos_lat]
    up = [cos_lat * cos_lon, cos_lat * sin_lon, sin_lat]
    return np.stack([np.stack(column, axis=-1) for column in (east, north, up)], axis=-1)


def earth_to_local(longitude: float, latitude: float, height: float = 0.0) -> NDArray[np.float64]:
    """Inverse of `local_to_earth`."""
    to_earth = local_to_earth(longitude, latitude, height)
    inverse = np.eye(4)
    inverse[:3, :3] = to_earth[:3, :3].T
    inverse[:3, 3] = -to_earth[:3, :3].T @ to_earth[:3, 3]
    return inverse
