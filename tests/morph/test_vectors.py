"""Tests of both morphs with the vectors that all languages read."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import nearfar as nf
from tests.support.vectors import cases, check


def morph_case(case: dict[str, Any], kind: str, dtype: Any) -> Any:
    place = {name: case[name] for name in ("user", "center", "r1", "r2", "strength")}
    found = nf.morph(np.array(case["points"], dtype), kind=kind, **place)
    assert found.dtype == dtype
    return found


@pytest.mark.parametrize(("dtype", "consumer"), [(np.float64, "float64"), (np.float32, "float32")])
@pytest.mark.parametrize("case", cases("blend"))
def test_the_blend_equals_the_formula(case: dict[str, Any], dtype: Any, consumer: str) -> None:
    check(morph_case(case, "blend", dtype), case["shown"], case["tolerance"][consumer])


@pytest.mark.parametrize(("dtype", "consumer"), [(np.float64, "float64"), (np.float32, "float32")])
@pytest.mark.parametrize("case", cases("cylinder"))
def test_the_cylinder_equals_the_formula(case: dict[str, Any], dtype: Any, consumer: str) -> None:
    check(morph_case(case, "cylinder", dtype), case["shown"], case["tolerance"][consumer])
