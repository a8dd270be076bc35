"""Tests of radial lenses with the vectors that all languages read."""

from __future__ import annotations

import math
from typing import Any

import pytest

import nearfar as nf
from tests.support.vectors import cases, check


@pytest.mark.parametrize("case", cases("lens", "radial"))
def test_distorted_radii_equal_the_polynomial(case: dict[str, Any]) -> None:
    lens, tolerance = nf.RadialLens(case["k"]), case["tolerance"]
    check(lens.distort(case["r"]), case["distorted"], 0.0, share=tolerance["distort"])
    check(lens.derivative(case["r"]), case["derivative"], tolerance["derivative"])


@pytest.mark.parametrize("case", cases("lens", "radial"))
def test_every_method_undistorts_radii(case: dict[str, Any]) -> None:
    lens, tolerance, shown = nf.RadialLens(case["k"]), case["tolerance"], case["distorted"]
    exact = tolerance["undistort"]
    check(lens.undistort(shown), case["undistorted"], 0.0, share=exact)
    check(lens.undistort(shown, method="lut"), case["undistorted"], 0.0, share=exact + tolerance["lut"])
    steps = lens.undistort(shown, method="fixed_point", iterations=4)
    check(steps, case["fixed_point"], 0.0, share=tolerance["fixed_point"])


@pytest.mark.parametrize("case", cases("lens", "radial"))
def test_lenses_fold_at_the_root_of_the_derivative(case: dict[str, Any]) -> None:
    lens = nf.RadialLens(case["k"])
    if case["r_max"] is None:
        assert lens.r_max == math.inf
    else:
        check(lens.r_max, case["r_max"], 0.0, share=case["tolerance"]["fold"])
        check(lens.distorted_max, case["distorted_max"], 0.0, share=case["tolerance"]["distort"])


@pytest.mark.parametrize("case", cases("lens", "points"))
def test_points_are_distorted_and_undistorted(case: dict[str, Any]) -> None:
    lens, tolerance = nf.RadialLens(case["k"], case["tangential"]), case["tolerance"]
    check(lens.distort_points(case["points"]), case["distorted"], tolerance["distort"])
    check(lens.undistort_points(case["distorted"]), case["undistorted"], tolerance["undistort"])
