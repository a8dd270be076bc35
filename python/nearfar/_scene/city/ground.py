"""Converts points on the ground to world metres: from a projection's metres, or from degrees via a local frame."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nearfar._scene.frames import earth_centred, earth_to_local

_DIGITS = 5
"""Decimals of degrees in a computed origin: about a metre."""


@dataclass(frozen=True)
class Projected:
    """Projected coordinates, east and north, kept as they are."""

    system: str
    """Name of the coordinate system, for notes."""
    metres: float = 1.0
    """Metres per unit."""

    @property
    def note(self) -> str:
        """Sentence that describes the world's coordinates."""
        return f"coordinates of {self.system} {'as they are' if self.is_kept else 'in metres'}"

    @property
    def is_kept(self) -> bool:
        """Whether the world's coordinates are the file's own."""
        return self.metres == 1

    def world(self, points: NDArray[np.float64], heights: NDArray[np.float64]) -> NDArray[np.float64]:
        """Convert points (N, 2) of the file and heights (N,) in metres to world metres (N, 3)."""
        return np.stack([points[:, 0] * self.metres, heights, points[:, 1] * -self.metres], axis=-1)


@dataclass(frozen=True)
class Geodetic:
    """Local frame at an origin for longitudes and latitudes in degrees; the Earth's curvature is kept."""

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
    def is_kept(self) -> bool:
        return False

    def world(self, points: NDArray[np.float64], heights: NDArray[np.float64]) -> NDArray[np.float64]:
        longitude, latitude = np.radians((self.longitude, self.latitude)).tolist()
        to_local = earth_to_local(longitude, latitude, self.height)
        earth_points = earth_centred(np.concatenate([np.radians(points), heights[:, None]], axis=1))
        return earth_points @ to_local[:3, :3].T + to_local[:3, 3]


Ground = Projected | Geodetic
"""Converts points and heights to world positions."""
