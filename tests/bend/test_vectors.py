"""Tests of bent rays with the vectors that all languages read."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from tests.support.vectors import cases, check

TOLERANCE = 1e-6
"""Tolerance in radians of the polylines; the vectors' bounds are for this value."""


def point_on_polyline(
    line: NDArray[np.float64], user: Any, direction: NDArray[np.float64], s: float
) -> NDArray[np.float64]:
    """Return the point of the polyline at a distance along the direction; its last segment extends to infinity."""
    along = (line - user) @ direction
    if s >= along[-1]:
        return np.asarray(line[-1] + (s - along[-1]) * direction)
    return np.array([np.interp(s, along, line[:, axis]) for axis in range(3)])


@pytest.mark.parametrize("kind", ["blend", "cylinder"])
@pytest.mark.parametrize("case", cases("bend"))
def test_rays_bend_as_the_equation_says(case: dict[str, Any], kind: str) -> None:
    if kind == "blend" and case["r2"] == 0:
        kind = "cylinder"
    place = {name: case[name] for name in ("user", "center", "r1", "r2", "strength")}
    line = nf.bend_rays([case["direction"]], tolerance=TOLERANCE, kind=kind, **place)[0]
    unit = np.array(case["direction"]) / np.linalg.norm(case["direction"])
    found = [point_on_polyline(line, case["user"], unit, s) for s in case["s"]]
    check(found, case["points"], case["tolerance"]["polyline"])
    if case["end"] is not None:
        check(line[-1], case["end"], case["tolerance"]["float64"])


@pytest.mark.parametrize("case", cases("bend", "cylinder_margins"))
def test_the_cylinders_margin_is_the_distance_to_its_near_radius(case: dict[str, Any]) -> None:
    place = {name: case[name] for name in ("center", "r1", "r2")}
    check(nf.fold_margin(case["user"], kind="cylinder", **place), case["margin"], case["tolerance"]["float64"])
