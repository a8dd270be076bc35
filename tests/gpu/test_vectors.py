"""Tests of shaders on every usable adapter with the vectors that all languages read."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from nearfar import gpu
from tests.support.vectors import cases, check

pytestmark = pytest.mark.usefixtures("backend")


def exact_cases(file: str, section: str = "cases") -> list[Any]:
    """Return cases whose inputs are exact in float32; AssertionError if there are none."""
    found = [parameters for parameters in cases(file, section) if "wgsl" in parameters.values[0]["tolerance"]]
    assert found, f"no case of {file}.json has a tolerance for shaders"
    return found


@pytest.mark.parametrize("kind", ["blend", "cylinder"])
def test_morphs_show_points_where_the_formula_says(kind: str) -> None:
    for parameters in exact_cases(kind):
        (case,) = parameters.values
        place = {name: case[name] for name in ("user", "center", "r1", "r2", "strength")}
        found = gpu.morph(np.array(case["points"], np.float32), kind=kind, **place)
        check(found, case["shown"], case["tolerance"]["wgsl"], name=str(parameters.id))


@pytest.mark.parametrize("case", exact_cases("cubemap", "directions"))
def test_directions_pass_through_their_texels(case: dict[str, Any]) -> None:
    directions = np.array(case["directions"], np.float32)
    for name, expected in case["texels"].items():
        size = int(name)
        numbers = np.arange(6 * size**2, dtype=np.float32).reshape(6, size, size)
        np.testing.assert_array_equal(gpu.cube_lookup(numbers, directions), expected)


@pytest.mark.parametrize("case", exact_cases("cubemap", "lookups"))
def test_filters_give_the_values_of_the_map(case: dict[str, Any]) -> None:
    faces = np.array(case["map"], np.float32).reshape(6, case["size"], case["size"])
    directions = np.array(case["directions"], np.float32)
    for name in ("nearest", "min", "max"):
        np.testing.assert_array_equal(gpu.cube_lookup(faces, directions, filter=name), case[name])
