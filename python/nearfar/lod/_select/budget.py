"""Triangle budgets: arguments of the kernel, and its report."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar.lod._measured_levels import MeasuredLevels


@dataclass(frozen=True)
class Spent:
    """Result of spending a budget."""

    price: float
    """λ: weighted score per triangle of the first step that did not fit, or the kept price. 0 if everything that
    improves the score is drawn."""
    triangles: int
    """Number of triangles of the levels of all objects in view."""
    score: float
    """Weighted mean of the levels' scores over the objects in view, as predicted by the curves. NaN if no object in
    view has a weight."""


def weights_for(weight: ArrayLike, count: int) -> dict[str, Any]:
    """Kernel arguments for the weights of `count` objects, as `LodRules` has them."""
    if not isinstance(weight, np.ndarray):
        return {"by_pixels": weight == "pixels", "weight": None}
    if weight.shape != (count,):
        raise ValueError(f"weight: expected shape ({count},), one for each object, got {weight.shape}")
    return {"by_pixels": False, "weight": weight}


def triangles_of(models: Sequence[MeasuredLevels]) -> NDArray[np.int64]:
    """Triangle counts of all levels, model by model."""
    return np.concatenate([np.empty(0, np.int64), *(model.triangles for model in models)])
