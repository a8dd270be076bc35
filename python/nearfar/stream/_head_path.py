"""Position of the user's eye over time."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import check
from nearfar.stream._link import check_ascending


@dataclass(frozen=True)
class HeadPath:
    """Positions over time, linearly interpolated."""

    times: NDArray[np.float64]
    """(N,) seconds, ascending."""
    positions: NDArray[np.float64]
    """(N, 3) world metres."""
    center: tuple[float, float, float]
    """The centre O."""

    @classmethod
    def parse(cls, path: ArrayLike | None, center: tuple[float, float, float]) -> HeadPath:
        """Check the caller's positions; None stands for the centre."""
        values = np.array(center) if path is None else check.plain("head_path", path)
        if values.ndim == 1:
            return cls(np.zeros(1), np.array([check.vector("head_path", values)]), center)
        rows = check.array("head_path", values, columns=4, dtype=np.float64, finite=True)
        if not len(rows):
            raise ValueError("head_path: expected at least one row, got none")
        if np.abs(rows).max() > check.FARTHEST:
            raise ValueError(f"head_path: expected numbers up to {check.FARTHEST:g}, got {np.abs(rows).max():g}")
        check_ascending("head_path", rows[:, 0])
        return cls(rows[:, 0], rows[:, 1:], center)

    def position(self, time: float) -> tuple[float, float, float]:
        """Return the position of the eye at a time."""
        x, y, z = (float(np.interp(time, self.times, column)) for column in self.positions.T)
        return x, y, z

    def axis_distance(self, time: float) -> float:
        """Return the distance in metres from the vertical axis through the centre at a time."""
        x, _, z = self.position(time)
        return math.hypot(x - self.center[0], z - self.center[2])

    def moves_after(self, time: float) -> bool:
        """Return whether the eye moves after a time."""
        return bool(time < self.times[-1]) and len(self.times) > 1
