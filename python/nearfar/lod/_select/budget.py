"""Budgets of triangles: the arguments of the kernel, and what it reports."""

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
MOST_TRIANGLES = 1 << 62


@dataclass(frozen=True)
class Spent:
    """How a budget was spent."""

    price: float
    """λ: the weighted score that each triangle of the first step adds that did not fit, or the price that was kept. 0
    where all that looks better is drawn."""
    triangles: int
    """Triangles of the levels of all objects in view."""
    score: float
    """Mean of the levels' scores over the objects in view by their weights, as curves predict it. NaN where no object
    in view has a weight."""


def weight_of(weight: str | ArrayLike) -> str | NDArray[np.float64]:
    """Check the kind of weights, or weights (N,) themselves."""
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
    """Refuse what has no meaning without a budget, or with one."""
    if budget is None:
        if floor is not None:
            raise ValueError(f"floor: expected None without a budget, got {floor}")
        if not isinstance(weight, str) or weight != "object":
            raise ValueError(f"weight: expected 'object' without a budget, got {check.shown(weight)}")
        return
    if mode == "off":
        raise ValueError("budget: expected None for the mode 'off', which draws all at level 0")
    if fade > 0:
        raise ValueError(f"fade: expected 0 with a budget, under which levels do not blend, got {fade}")


def weights_for(weight: str | NDArray[np.float64], count: int) -> dict[str, Any]:
    """Arguments of the kernel for weights of so many objects."""
    if isinstance(weight, str):
        return {"by_pixels": weight == "pixels", "weight": None}
    if weight.shape != (count,):
        raise ValueError(f"weight: expected shape ({count},), one for each object, got {weight.shape}")
    return {"by_pixels": False, "weight": weight}


def triangles_of(models: Sequence[MeasuredLevels]) -> NDArray[np.int64]:
    """Triangles of all levels, model by model."""
    return np.concatenate([np.empty(0, np.int64), *(model.triangles for model in models)])
