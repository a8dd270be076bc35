"""What is known about an object's levels: how good each looks over its size."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar.lod._fit import Curve4PL
from nearfar.lod._levels import Levels


@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class LodModel:
    """Levels of an object with their curves: what `select` decides by.

    `measure` makes it. Level 0 is the base, which looks like itself; level i > 0 has the curve `curves[i - 1]`.

    Parameters
    ----------
    triangles
        Triangles of each level (K,), level 0 first.
    curves
        K − 1 curves: SSIM over solid angle in steradians.
    center, radius
        The base's bounding sphere, metres in the object's frame.
    sigma
        Least and greatest solid angle at which was measured, steradians. Above the greatest only level 0 is used; below
        the least, curves keep their value there.
    errors
        Greatest distance of each level (K,) from the base, metres.
    name
        Of the object.
    levels
        The geometry, where it is at hand; as many as `triangles`.
    measured
        How it was measured, in values that JSON has.
    """

    triangles: NDArray[np.int64]
    curves: Curve4PL
    center: NDArray[np.float64]
    radius: float
    sigma: tuple[float, float]
    errors: NDArray[np.float64]
    name: str = "object"
    levels: Levels | None = None
    measured: dict[str, Any] = field(default_factory=dict)

    def __len__(self) -> int:
        """How many levels there are, level 0 included."""
        return len(self.triangles)

    def __repr__(self) -> str:
        counts = ", ".join(f"{count:,}" for count in self.triangles)
        return f"LodModel({self.name!r}: {counts} triangles)"
