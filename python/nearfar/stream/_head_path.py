"""Position of the user's eye over time."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import check


@dataclass(frozen=True)
class HeadPath:
    """Positions over time, linearly interpolated."""

    times: NDArray[np.float64]
    """(N,) seconds, ascending."""
    places: NDArray[np.float64]
    """(N, 3) world metres."""
    center: tuple[float, float, float]
    """The centre O."""

    @classmethod
    def parse(cls, given: ArrayLike | None, center: tuple[float, float, float]) -> HeadPath:
        """Check the caller's positions; None stands for the centre."""
        values = np.array(center) if given is None else check.plain("head_path", given)
        if values.ndim == 1:
            return cls(np.zeros(1), np.array([check.vector("head_path", values)]), center)
        rows = check.array("head_path", values, columns=4, dtype=np.float64, finite=True)
        if not len(rows):
            raise ValueError("head_path: expected at least one row, got none")
        if np.abs(rows).max() > check.FARTHEST:
            raise ValueError(f"head_path: expected numbers up to {check.FARTHEST:g}, got {np.abs(rows).max():g}")
        times = rows[:, 0]
        falls = np.flatnonzero(np.diff(times) <= 0.0)
        if len(falls):
            raise ValueError(
                f"head_path: expected ascending times, got {times[falls[0] + 1]:g} after {times[falls[0]]:g}"
            )
        return cls(times, rows[:, 1:], center)

    def position(self, time: float) -> tuple[float, float, float]:
        """Return the position of the eye at a time."""
        x, y, z = (float(np.interp(time, self.times, column)) for column in self.places.T)
        return x, y, z

    def away(self, time: float) -> float:
        """Return the distance in metres from the vertical axis through the centre at a time."""
        x, _, z = self.position(time)
        return math.hypot(x - self.center[0], z - self.center[2])

    def moves_after(self, time: float) -> bool:
        """Return whether the eye moves after a time."""
        return bool(time < self.times[-1]) and len(self.times) > 1
