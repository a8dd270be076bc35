"""Places of points on the ground: metres of a projection, or degrees, which become metres of a local frame."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from nearfar._scene.frames import earth_centred, earth_to_local

_DIGITS = 5
"""Decimals of degrees of an origin that nobody stated: a metre."""


class Ground(Protocol):
    """Turns points and heights to nearfar's world."""

    @property
    def note(self) -> str:
        """A sentence on what the world's coordinates are."""

    @property
    def is_kept(self) -> bool:
        """Whether they are the file's."""

    def world(self, points: NDArray[np.float64], heights: NDArray[np.float64]) -> NDArray[np.float64]:
        """Points (N, 2) as the file has them and heights (N,) in metres as world metres (N, 3)."""


@dataclass(frozen=True)
class Projected:
    """Coordinates of a projection, east and north, which stay what they are."""

    system: str
    """Name for notes."""
    metres: float = 1.0
    """Metres in a unit."""

    @property
    def note(self) -> str:
        return (
            f"coordinates of {self.system} as they are"
            if self.metres == 1
            else f"coordinates of {self.system} in metres"
        )

    @property
    def is_kept(self) -> bool:
        return self.metres == 1

    def world(self, points: NDArray[np.float64], heights: NDArray[np.float64]) -> NDArray[np.float64]:
        return np.stack([points[:, 0] * self.metres, heights, points[:, 1] * -self.metres], axis=-1)


@dataclass(frozen=True)
class Geodetic:
    """Longitudes and latitudes in degrees, in the local frame at an origin; the Earth's curve is kept."""

    longitude: float
    latitude: float
    height: float = 0.0
    """Degrees, and metres above the ellipsoid."""

    @classmethod
    def around(cls, points: NDArray[np.float64]) -> Geodetic:
        """The frame in the middle of points (N, 2)."""
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
        places = earth_centred(np.concatenate([np.radians(points), heights[:, None]], axis=1))
        return places @ to_local[:3, :3].T + to_local[:3, 3]
