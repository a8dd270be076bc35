"""Placement of models by name, as `measure` returns them for a mapping."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar.lod._select.kernel_inputs import models_of
from tests.support.leveled_cases import frames, leveled
from tests.support.lod_cases import SMALL, levels

NAMES = ["egg", "ball", "egg"]


@pytest.fixture
def by_name(models: list[nf.lod.LodModel]) -> dict[str, nf.lod.LodModel]:
    return {"ball": models[0], "egg": models[1]}


@pytest.mark.parametrize(
    "index", [NAMES, np.array(NAMES), np.array(NAMES, object), [1, 0, 1], np.array([1, 0, 1], np.uint8)]
)
def test_models_by_name_are_placed_like_a_list(
    models: list[nf.lod.LodModel], by_name: dict[str, nf.lod.LodModel], index: Any
) -> None:
    places = frames(3, seed=2)
    scene, truth = nf.lod.place(by_name, index, places), nf.lod.place(models, [1, 0, 1], places)
    np.testing.assert_array_equal(leveled(scene).model_index, leveled(truth).model_index)
    np.testing.assert_array_equal(leveled(scene).radii, leveled(truth).radii)
    shown = scene.at_levels([1, 2, 0]).triangles()
    np.testing.assert_array_equal(shown, truth.at_levels([1, 2, 0]).triangles())


def test_measured_objects_can_be_placed_directly(tmp_path: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("NEARFAR_CACHE", str(tmp_path / "cache"))
    measured = nf.lod.measure({"a": levels(8, 4), "b": levels(6)}, **SMALL)
    scene = nf.lod.place(measured, ["b", "a"], frames(2, seed=1))
    assert scene.triangle_count == measured["a"].triangles[0] + measured["b"].triangles[0]


@pytest.mark.parametrize("index", [[], np.array([], str), np.array([], object)])
def test_placing_no_objects_is_allowed(by_name: dict[str, nf.lod.LodModel], index: Any) -> None:
    assert nf.lod.place(by_name, index, np.zeros((0, 4, 4))).triangle_count == 0
    assert nf.lod.place({}, index, np.zeros((0, 4, 4))).triangle_count == 0


def test_names_belong_to_a_mapping(models: list[nf.lod.LodModel]) -> None:
    with pytest.raises(TypeError, match="model_index: expected"):
        nf.lod.place(models, ["ball"], frames(1, seed=0))


def test_lists_of_models_and_indices_pass_unchanged(models: list[nf.lod.LodModel]) -> None:
    index = np.zeros(5, np.int64)
    assert models_of(models, index) == (models, index)
    row, same = models_of({"ball": models[0]}, index)
    assert same is index
    assert row == models[:1]
