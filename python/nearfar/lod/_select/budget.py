"""Triangle budgets: checks of the arguments, and the kernel's report."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check
from nearfar.lod._measured_levels import MeasuredLevels

WEIGHTS = ("object", "pixels")
MAX_TRIANGLES = 1 << 62


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


def weight_of(weight: str | ArrayLike) -> str | NDArray[np.float64]:
    """Check the kind of weights, or explicit weights (N,)."""
    if isinstance(weight, str):
        return check.choice("weight", weight, WEIGHTS)
    weights = np.array(check.array("weight", weight, columns=None, dtype=np.float64))
    if weights.ndim != 1:
        raise ValueError(f"weight: expected shape (N,), one for each object, got {weights.shape}")
    weights.flags.writeable = False
    _core.check_weights(weights)
    return weights


def check_budget(
    budget: int | None, weight: str | NDArray[np.float64], floor: float | None, *, mode: str, fade: float
) -> None:
    """Reject arguments that have no meaning without, or with, a budget."""
    if budget is None:
        if floor is not None:
            raise ValueError(f"floor: expected None without a budget, got {floor}")
        if not isinstance(weight, str) or weight != "object":
            raise ValueError(f"weight: expected 'object' without a budget, got {check.value_or_type(weight)}")
        return
    if mode == "off":
        raise ValueError("budget: expected None for the mode 'off', which draws all at level 0")
    if fade > 0:
        raise ValueError(f"fade: expected 0 with a budget, under which levels do not blend, got {fade}")


def weights_for(weight: str | NDArray[np.float64], count: int) -> dict[str, Any]:
    """Kernel arguments for the weights of `count` objects."""
    if isinstance(weight, str):
        return {"by_pixels": weight == "pixels", "weight": None}
    if weight.shape != (count,):
        raise ValueError(f"weight: expected shape ({count},), one for each object, got {weight.shape}")
    return {"by_pixels": False, "weight": weight}


def triangles_of(models: Sequence[MeasuredLevels]) -> NDArray[np.int64]:
    """Triangle counts of all levels, model by model."""
    return np.concatenate([np.empty(0, np.int64), *(model.triangles for model in models)])
