"""The `Clip` class: planes and a box that limit the visible space."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import check
from nearfar._base.settings import set_fields

MAX = 8
"""Maximum number of half-spaces, the limit of graphics adapters; a box takes six of them."""


@dataclass(frozen=True)
class Clip:
    """Planes and a box; geometry outside them is not visible.

    ValueError and TypeError for more than eight half-spaces, including six for a box, numbers that are not finite,
    normals of length 0, and a box whose corners are not in order.

    Parameters
    ----------
    planes
        Half-spaces (N, 4), as (n_x, n_y, n_z, d) in world axes and metres: points x with n·x + d ≥ 0 are visible. n may
        have any length but 0.
    box
        World positions (2, 3) of the least and the greatest corner of an axis-aligned box, metres: points in it are
        visible; None for no box.
    """

    planes: ArrayLike = ()
    box: ArrayLike | None = None

    def __post_init__(self) -> None:
        set_fields(self, planes=tuple(map(tuple, _planes(self.planes).tolist())))
        if self.box is not None:
            corners = check.array("box", self.box, columns=3, dtype=np.float64, finite=True)
            if corners.shape != (2, 3) or not (corners[0] < corners[1]).all():
                raise ValueError(
                    f"box: expected its least and its greatest corner, got {check.value_or_type(self.box)}"
                )
            set_fields(self, box=tuple(map(tuple, corners.tolist())))
        count = len(self.half_spaces)
        if count > MAX:
            raise ValueError(f"planes: expected at most {MAX} half-spaces, of which a box takes six, got {count}")

    @property
    def half_spaces(self) -> NDArray[np.float64]:
        """All half-spaces (N, 4); the box's are last."""
        rows = np.asarray(self.planes, np.float64).reshape(-1, 4).tolist()
        if self.box is not None:
            low, high = np.asarray(self.box, np.float64)
            for axis, normal in enumerate(np.eye(3).tolist()):
                rows += [[*normal, -low[axis]], [*(-x for x in normal), high[axis]]]
        return np.asarray(rows, np.float64).reshape(-1, 4)


def _planes(value: ArrayLike) -> NDArray[np.float64]:
    """Check half-spaces (N, 4), N at most `MAX`; an empty sequence is allowed."""
    plain = check.plain("planes", value)
    if plain.size == 0:
        return np.empty((0, 4))
    if plain.ndim != 2 or plain.shape[1] != 4:
        raise ValueError(f"planes: expected half-spaces of four numbers, got shape {plain.shape}")
    if len(plain) > MAX:
        raise ValueError(f"planes: expected at most {MAX} half-spaces, of which a box takes six, got {len(plain)}")
    rows = check.array("planes", plain, columns=4, dtype=np.float64, finite=True)
    if (rows[:, :3] == 0.0).all(axis=1).any():
        raise ValueError(f"planes: expected normals of length above 0, got {check.value_or_type(value)}")
    return rows
