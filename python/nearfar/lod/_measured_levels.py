"""Levels of one object with the curves that were measured of them: the data that selection and files take."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar.lod._levels import Levels
from nearfar.lod._measure.fit import Curve4PL
from nearfar.lod._measure.samples import Samples


@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class MeasuredLevels:
    """The data of a `LodModel`, which documents the fields.

    It stands apart from it, so that selectors and files take models without knowing the methods that use them.
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
    samples: Samples | None = None

    def __len__(self) -> int:
        """Return the number of levels, level 0 included."""
        return len(self.triangles)
