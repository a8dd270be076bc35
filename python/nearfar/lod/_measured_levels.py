"""Levels of one object with the curves that were measured of them: the data that selection and files take."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
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

    def of_levels(self, numbers: NDArray[np.int64]) -> MeasuredLevels:
        """Return the model with some of its levels, by their ascending numbers (N,), of which the first is 0."""
        samples = self.samples
        if samples is not None:
            views = None if samples.views is None else samples.views[numbers]
            samples = replace(samples, score=samples.score[numbers], views=views)
        levels = self.levels
        if levels is not None:
            levels = Levels([levels[number] for number in numbers.tolist()], name=levels.name, frame=levels.frame)
        return replace(
            self,
            triangles=self.triangles[numbers],
            curves=self.curves[numbers[1:] - 1],
            errors=self.errors[numbers],
            levels=levels,
            samples=samples,
        )

    def __len__(self) -> int:
        """Return the number of levels, level 0 included."""
        return len(self.triangles)
