"""Frames of tilesets: the Earth's, a local one at an origin, and the axes of glTF and of scenes; float64."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base import check
from nearfar._scene.frames import earth_to_local, geodetic

Floats = NDArray[np.float64]

RADIUS = 6_350_000.0
"""Least distance of the ground from the Earth's centre, rounded down, metres."""

LOWEST, HIGHEST = -30_000.0, 100_000.0
"""Range of heights in metres of the centre of a tileset in the Earth's frame."""

_PLACES, _HEIGHT_PLACES = 9, 3
"""Decimals of an origin in degrees and metres: a resolution of 0.1 mm and 1 mm."""

TO_Z_UP = {
    "X": np.array([[0.0, 0, -1, 0], [0, 1, 0, 0], [1, 0, 0, 0], [0, 0, 0, 1]]),
    "Y": np.array([[1.0, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1]]),
    "Z": np.eye(4),
}
"""Rotations from glTF with the given up axis to the axes of tiles (3D Tiles 1.1, "glTF transforms")."""

Z_UP_TO_SCENE = np.array([[1.0, 0, 0, 0], [0, 0, 1, 0], [0, -1, 0, 0], [0, 0, 0, 1]])
"""Rotation from the axes of tiles to those of scenes: (x, y, z) becomes (x, z, −y)."""


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
        where = f"longitude {longitude:.{_PLACES}f}°, latitude {latitude:.{_PLACES}f}°, height {height:.3f} m"
        return f"local frame with its origin at {where}; x points east, y up, z south"


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
