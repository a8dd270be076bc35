"""Tests of cube map orientation and lookup with the vectors that all languages read."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import nearfar as nf
from tests.support.vectors import cases, check


@pytest.mark.parametrize("dtype", [np.float64, np.float32])
@pytest.mark.parametrize("case", cases("cubemap", "directions"))
def test_directions_pass_through_their_texels(case: dict[str, Any], dtype: Any) -> None:
    directions = np.array(case["directions"], dtype)
    for name, expected in case["texels"].items():
        size = int(name)
        np.testing.assert_array_equal(nf.envmap_texels(directions, size=size), expected)
        numbers = np.arange(6 * size**2, dtype=np.int32).reshape(6, size, size)
        np.testing.assert_array_equal(nf.cube_lookup(numbers, directions), expected)


@pytest.mark.parametrize("case", cases("cubemap", "texels"))
def test_texels_have_their_directions(case: dict[str, Any]) -> None:
    centers = nf.envmap_directions(case["size"]).reshape(-1, 3)
    check(centers[case["texels"]], case["directions"], case["tolerance"]["float64"])
    np.testing.assert_array_equal(nf.envmap_texels(case["directions"], size=case["size"]), case["texels"])


@pytest.mark.parametrize("case", cases("cubemap", "lookups"))
def test_filters_give_the_values_of_the_map(case: dict[str, Any]) -> None:
    faces = np.array(case["map"]).reshape(6, case["size"], case["size"])
    for name in ("nearest", "linear", "min", "max"):
        bound = case["tolerance"]["float64"] if name == "linear" else 0.0
        check(nf.cube_lookup(faces, case["directions"], filter=name), case[name], bound)
