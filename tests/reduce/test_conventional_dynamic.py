"""Moving objects beyond the near part of the conventional method: shown from the centre, from the user, or omitted."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar._reduce.drawing import ConventionalDynamic
from tests.support.gpu_cases import ADAPTERS, adapter, check_color, check_ids, edges
from tests.support.reduce_cases import ALL, CENTER, R1, R2, camera, place, rho, street

USER = CENTER + np.array([5.0, 0.3, 4.0])
AHEAD = (0.9, 0.0, 0.6)
BEHIND_TOWER, BEFORE_TOWER, ACROSS = place(140.0, 3.0, 91.0), place(70.0, 0.75, 45.0), place(45.8, 0.75, 26.5)
"""Poses of the car beyond r2, the first one hidden from user and centre, and across r2."""


def conventional(pose: np.ndarray[Any, Any] = BEFORE_TOWER, **settings: Any) -> nf.ReducedScene:
    scene = street(dynamic=True).at({"car": pose})
    return nf.reduce(
        scene, center=CENTER, r1=R1, r2=R2, face_size=128, morph="none", channels=("color", "object_id"), **settings
    )


def car_of(frame: nf.Frame, reduced: nf.ReducedScene) -> np.ndarray[Any, Any]:
    return np.asarray(frame.require("object_id") == reduced.scene.object_names.index("car"))


@pytest.mark.parametrize("env", [True, False])
@pytest.mark.parametrize("pose", [BEHIND_TOWER, BEFORE_TOWER, ACROSS], ids=["behind", "before", "across"])
def test_from_the_user_the_object_is_drawn_over_far_geometry(pose: np.ndarray[Any, Any], env: bool) -> None:
    reduced, view = conventional(pose), camera(USER, AHEAD, (320, 180))
    frame = reduced.render(view, conventional_dynamic="user", channels=ALL[:3], env=env)
    alone = reduced.scene.subset(objects=["car"])
    truth = nf.render(alone, view, channels=ALL[:3])
    seen = truth.require("object_id") >= 0
    assert seen.sum() >= 8
    np.testing.assert_array_equal(car_of(frame, reduced), seen)
    np.testing.assert_allclose(frame.require("range")[seen], truth.require("range")[seen], rtol=1e-5)
    np.testing.assert_allclose(frame.require("color")[seen], truth.require("color")[seen], atol=1e-4)
    others = reduced.render(view, conventional_dynamic="omit", channels=ALL[:3], env=env)
    np.testing.assert_array_equal(frame.require("object_id")[~seen], others.require("object_id")[~seen])


def test_near_geometry_hides_the_object() -> None:
    reduced = conventional(place(60.0, 1.0, 3.0 + 60.0))
    view = camera(CENTER + np.array([1.0, 0.0, 1.0]), (1.0, -0.03, 1.25))
    frame = reduced.render(view, conventional_dynamic="user", channels=ALL[:3])
    truth = nf.render(reduced.scene.subset(objects=["car", "near"]), view, channels=ALL[:3])
    names = reduced.scene.object_names
    near = truth.require("object_id") == reduced.scene.subset(objects=["car", "near"]).object_names.index("near")
    assert near.any()
    assert (frame.require("object_id")[near] == names.index("near")).all()


def test_omitted_objects_end_at_the_near_part() -> None:
    reduced, view = conventional(ACROSS), camera(USER, AHEAD, (320, 180))
    frame = reduced.render(view, conventional_dynamic="omit", channels=("object_id", "range"))
    shown = car_of(frame, reduced)
    whole = nf.render(reduced.scene.subset(objects=["car"]), view, channels=("object_id", "position"))
    inside = (whole.require("object_id") >= 0) & (rho(whole.require("position")) <= R2)
    assert 0 < inside.sum() < (whole.require("object_id") >= 0).sum()
    np.testing.assert_array_equal(shown, inside)
    assert not car_of(conventional().render(view, conventional_dynamic="omit"), reduced).any()


def test_the_centre_is_the_default_and_omitted_objects_are_not_traced() -> None:
    reduced, view = conventional(), camera(USER, AHEAD)
    default, named = reduced.render(view), reduced.render(view, conventional_dynamic="center")
    for name in default.channels:
        np.testing.assert_array_equal(default.require(name), named.require(name))
    ways: tuple[ConventionalDynamic, ...] = ("center", "user", "omit")
    moving = [reduced.render(view, conventional_dynamic=way).stats["dynamic_triangles"] for way in ways]
    assert moving == [12, 12, 0]


@pytest.mark.parametrize("limits", [(0.0, 60.0), (70.0, math.inf)])
def test_ray_limits_apply_to_the_object(limits: tuple[float, float]) -> None:
    reduced, view = conventional(), camera(USER, AHEAD, (320, 180))
    whole = reduced.render(view, conventional_dynamic="user", channels=("object_id", "range"))
    part = reduced.render(
        view, conventional_dynamic="user", channels=("object_id", "range"), t_min=limits[0], t_max=limits[1]
    )
    distance = whole.require("range")
    expected = car_of(whole, reduced) & (distance >= limits[0]) & (distance <= limits[1])
    found = car_of(part, reduced)
    # Where the nearer faces are cut off, the farther ones are visible.
    assert (found | ~expected).all()
    assert expected.any() == found.any()


@pytest.mark.parametrize(
    ("name", "env", "way"),
    [(ADAPTERS[(env + number) % 2], env, way) for env in (True, False) for number, way in enumerate(("user", "omit"))],
)
def test_adapters_agree_on_moving_objects(name: str, env: bool, way: str) -> None:
    for pose in (BEHIND_TOWER, ACROSS):
        reduced, view = conventional(pose), camera(USER, AHEAD, (320, 180))
        settings: dict[str, Any] = {"channels": ALL[:3], "conventional_dynamic": way, "env": env}
        with adapter(name):
            cpu, gpu = (reduced.render(view, backend=backend, **settings) for backend in ("cpu", "gpu"))
        check_ids(cpu.require("object_id"), gpu.require("object_id"))
        check_color(cpu, gpu)
        inner = ~edges(cpu.require("object_id")) & car_of(cpu, reduced)
        assert car_of(gpu, reduced)[inner].all()


def test_a_morph_and_unknown_names_are_refused() -> None:
    reduced, view = conventional(), camera(USER, AHEAD)
    with pytest.raises(ValueError, match="conventional_dynamic: expected 'center' with a morph"):
        reduced.with_morph("blend").render(view, conventional_dynamic="omit")
