"""The `Clip` class: the part of space in which surfaces are seen."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import check

MOST = 8
"""Greatest number of half-spaces, as many as graphics adapters clip by; a box takes six of them."""


@dataclass(frozen=True)
class Clip:
    """Planes and a box that cut off what lies outside of them.

    Parameters
    ----------
    planes
        Half-spaces (N, 4), as (n_x, n_y, n_z, d) in world axes and metres: points x with n·x + d ≥ 0 are seen. n may
        have any length but 0.
    box
        World positions (2, 3) of the least and the greatest corner of a box with sides along the axes, metres: points
        in it are seen; None for no box.

    Raises
    ------
    ValueError, TypeError
        For more than eight half-spaces, of which a box takes six, for numbers that are not finite, for n = 0, and for a
        box whose corners are not in order.
    """

    planes: Iterable[ArrayLike] = ()
    box: ArrayLike | None = None

    def __post_init__(self) -> None:
        rows = [_plane(plane) for plane in check.iterable("planes", self.planes, "half-spaces of four numbers")]
        object.__setattr__(self, "planes", tuple(rows))
        if self.box is not None:
            corners = check.array("box", self.box, columns=3, dtype=np.float64, finite=True)
            if corners.shape != (2, 3) or not (corners[0] < corners[1]).all():
                raise ValueError(f"box: expected its least and its greatest corner, got {check.shown(self.box)}")
            object.__setattr__(self, "box", tuple(map(tuple, corners.tolist())))
        if len(self.half_spaces) > MOST:
            count = len(self.half_spaces)
            raise ValueError(f"planes: expected at most {MOST} half-spaces, of which a box takes six, got {count}")

    @property
    def half_spaces(self) -> NDArray[np.float64]:
        """All half-spaces (N, 4), those of the box at the end."""
        rows = [list(plane) for plane in self.planes]  # type: ignore[arg-type]
        if self.box is not None:
            low, high = np.asarray(self.box, np.float64)
            for axis, normal in enumerate(np.eye(3).tolist()):
                rows += [[*normal, -low[axis]], [*(-x for x in normal), high[axis]]]
        return np.asarray(rows, np.float64).reshape(-1, 4)


def _plane(value: ArrayLike) -> tuple[float, float, float, float]:
    numbers = check.array("planes", np.reshape(np.asarray(value), (1, -1)), columns=4, dtype=np.float64, finite=True)
    x, y, z, d = (float(number) for number in numbers[0])
    if x == y == z == 0.0:
        raise ValueError(f"planes: expected a normal of length above 0, got {check.shown(value)}")
    return x, y, z, d
