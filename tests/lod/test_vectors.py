"""The four-parameter logistic curve against the vectors that all languages read."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import nearfar as nf
from tests.support.vectors import cases, check


@pytest.mark.parametrize("case", cases("fit_4pl", "values"))
def test_curves_have_the_values_of_the_formula(case: dict[str, Any]) -> None:
    a, b, c, d = (case[name] for name in "abcd")
    curve = nf.lod.Curve4PL(a, b, c, d, 0.0, "fitted", "")
    check(curve(case["x"]), case["y"], case["tolerance"]["float64"])
    check([curve(x) for x in case["x"]], case["y"], case["tolerance"]["float64"])


@pytest.mark.parametrize("case", cases("fit_4pl", "fits"))
def test_fits_find_the_parameters_of_exact_samples(case: dict[str, Any]) -> None:
    curve = nf.lod.fit_4pl(case["x"], case["y"])
    assert curve.status == "fitted"
    share = case["tolerance"]["float64"]
    check([curve.b, curve.c], [case["b"], case["c"]], 0.0, share=share)
    plateaus = [case["a"], case["d"]]
    check([curve.a, curve.d], plateaus, share * np.abs(plateaus).max())
