"""Another r1 with the same map, against a reduction with that r1."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from tests.support.reduce_cases import ALL, CENTER, R2, camera, place, street

VIEW = camera(CENTER + np.array([4.0, 0.2, 3.0]), (0.6, -0.1, -1.0))


def reduced(r1: float, **settings: Any) -> nf.ReducedScene:
    scene = street(dynamic=True).at({"car": place(20.0, 0.75, -10.0)})
    channels = ("color", "range", "object_id")
    return nf.reduce(scene, center=CENTER, r1=r1, r2=R2, face_size=32, samples=1, channels=channels, **settings)


def same(one: nf.ReducedScene, other: nf.ReducedScene) -> None:
    frames = [scene.render(VIEW, channels=ALL[:3], method="vertex") for scene in (one, other)]
    for name in ALL[:3]:
        np.testing.assert_array_equal(frames[0].require(name), frames[1].require(name))


@pytest.mark.slow
@pytest.mark.parametrize("morph", ["blend", "cylinder", "none"])
@pytest.mark.parametrize("unit", ["triangle", "object"])
def test_another_r1_equals_a_reduction_with_it(morph: str, unit: str) -> None:
    changed, expected = reduced(30.0, morph=morph, unit=unit).with_r1(9.0), reduced(9.0, morph=morph, unit=unit)
    same(changed, expected)
    assert changed.r1 == 9.0
    assert changed.partition.unit == unit
    counts = ("triangles", "near", "intermediate", "nsf", "sf", "drawn")
    assert {name: changed.stats[name] for name in counts} == {name: expected.stats[name] for name in counts}
    moved = {"car": place(8.0, 0.75, -6.0)}
    same(changed.at(moved), expected.at(moved))


def test_another_r1_keeps_the_map_and_works_for_loaded_scenes(tmp_path: Path) -> None:
    whole = reduced(30.0)
    assert whole.with_r1(9.0).env is whole.env
    whole.save(tmp_path / "light")
    loaded = nf.ReducedScene.load(tmp_path / "light").with_r1(9.0)
    assert loaded.stats["near"] == reduced(9.0).stats["near"]
    assert loaded.stats["sf"] == whole.stats["sf"]


def test_a_map_from_r1_keeps_its_r1() -> None:
    scene = reduced(30.0, morph="none", boundary="r1")
    with pytest.raises(ValueError, match="r1: expected 30, at which the map begins, got 9"):
        scene.with_r1(9.0)
