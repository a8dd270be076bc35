"""Budgets of triangles: the arguments of the kernel, and what it reports."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import check
from nearfar.lod._measured_levels import MeasuredLevels

WEIGHTS = ("object", "pixels")
MOST_TRIANGLES = 1 << 62


@dataclass(frozen=True)
class Spent:
    """How a budget was spent."""

    price: float
    """λ: the weighted score that one more triangle would add. 0 where all that looks better is drawn."""
    triangles: int
    """Triangles of the levels of all objects in view."""
    score: float
    """Mean of the levels' scores over the objects in view by their weights, as curves predict it. NaN for none."""


def weight_of(weight: str | ArrayLike) -> str | NDArray[np.float64]:
    """Check the kind of weights, or weights (N,) themselves."""
    if isinstance(weight, str):
        return check.choice("weight", weight, WEIGHTS)
    return check.array("weight", weight, columns=None, dtype=np.float64)


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
