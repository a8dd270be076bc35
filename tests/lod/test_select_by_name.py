"""Selection from models by name, as `measure` returns them for a mapping."""

from __future__ import annotations

import re
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from tests.support.leveled_cases import view

CENTERS = np.array([(0.0, 0.0, -4.0), (0.5, 0.0, -9.0), (-1.0, 0.5, -20.0), (0.2, 0.1, -60.0)])
NAMES = ["egg", "ball", "egg", "ball"]
NUMBERS = [1, 0, 1, 0]


@pytest.mark.parametrize("index", [NAMES, np.array(NAMES), np.array(NAMES, object), NUMBERS])
def test_models_by_name_are_selected_like_a_list(models: list[nf.lod.LodModel], index: Any) -> None:
    by_name = {"ball": models[0], "egg": models[1]}
    truth = nf.lod.select(models, NUMBERS, CENTERS, 1.0, camera=view(), full=True)
    found = nf.lod.select(by_name, index, CENTERS, 1.0, camera=view(), full=True)
    np.testing.assert_array_equal(found.level, truth.level)
    np.testing.assert_array_equal(found.score, truth.score)
    np.testing.assert_array_equal(nf.lod.Selector().select(by_name, index, CENTERS, 1.0, camera=view()), truth.level)
    assert len(np.unique(truth.level)) > 1


def test_other_names_are_refused(models: list[nf.lod.LodModel]) -> None:
    message = re.escape("model_index: expected names of models, ['ball'], got 'egg'")
    with pytest.raises(ValueError, match=message):
        nf.lod.select({"ball": models[0]}, NAMES, CENTERS, 1.0, camera=view())
