"""Tests of default viewpoints: open places, single objects, and views crossed by the boundary."""

from __future__ import annotations

import numpy as np
import pytest
import trimesh

import nearfar as nf
from nearfar._trace import crossing, viewpoint
from tests.support.reduce_cases import CENTER, R1, R2, street


def solid(extents: tuple[float, float, float]) -> trimesh.Trimesh:
    shift = trimesh.transformations.translation_matrix((0, extents[1] / 2, 0))
    return trimesh.creation.box(extents, shift)


def room() -> nf.Scene:
    """A room of 8 × 3 × 6 m, whose faces look inwards, and a table in it."""
    walls = solid((8, 3, 6))
    walls.invert()
    return nf.Scene.from_trimesh(trimesh.Scene([walls, solid((1, 0.7, 1))]))


@pytest.mark.parametrize("extents", [(0.3, 0.7, 0.4), (4.4, 1.5, 1.8), (30.0, 40.0, 30.0)])
def test_a_single_object_is_seen_from_outside(extents: tuple[float, float, float]) -> None:
    scene = nf.Scene.from_trimesh(solid(extents))
    place = viewpoint.find(scene)
    assert place.is_outside
    low, high = scene.bounds
    assert (np.array(place.eye) < low).any() or (np.array(place.eye) > high).any()
    camera = nf.Camera.look_at(place.eye, place.target, fov=nf.Fov.symmetric(90, 1.6), size=(160, 100))
    seen = nf.render(scene, camera, channels=("face_id",)).require("face_id") >= 0
    assert 0.05 < seen.mean() < 0.9
    assert seen[1:-1, 1:-1].sum() == seen.sum()


def test_a_room_is_seen_from_inside() -> None:
    scene = room()
    place = viewpoint.find(scene)
    assert not place.is_outside
    assert (np.abs(np.array(place.eye)[[0, 2]]) < [4, 3]).all()


@pytest.mark.parametrize("x", [-2.0, 2.0])
def test_the_side_with_more_space_comes_first(x: float) -> None:
    eye = (x, 1.7, 2.0)
    sides = viewpoint.beside(room(), viewpoint.facing(eye, (x, 1.7, 0.0)), 3.0)
    # Walls are 2 and 6 m away, and a user keeps 0.4 of that.
    np.testing.assert_allclose(sides, [(x - np.sign(x) * 3.0, 1.7, 2.0), (x + np.sign(x) * 1.2, 1.7, 2.0)], atol=1e-5)


def test_an_empty_plain_is_not_an_object() -> None:
    scene = nf.Scene.from_trimesh(trimesh.creation.box((300, 1, 300)))
    place = viewpoint.find(scene)
    assert not place.is_outside
    assert place.eye[1] == pytest.approx(0.5 + viewpoint.EYE_HEIGHT, abs=1e-3)


def test_the_default_view_shows_the_boundary_and_all_zones() -> None:
    """The wall from 5 to 120 m is on one side of the street only; the longest open view is on the other side."""
    scene = street(ground=False)
    place = viewpoint.facing_open(scene, (3.0, 1.7, -2.0))
    views = crossing.views(scene, place, 6.0, R1, R2, fov=90.0)
    user, forward = views[0].user, views[0].forward
    assert 0.0 < np.linalg.norm(np.subtract(user, CENTER)) <= 6.0 + 1e-9
    # Other views look elsewhere, or stand on the other side.
    assert len({view.turn for view in views}) > 1
    assert len({(view.turn, view.user) for view in views}) == len(views)
    for other in views[1:]:
        apart = abs((other.turn - views[0].turn + 36) % 72 - 36) * 5
        assert apart >= 30 or (apart == 0 and other.user != user)
    assert [view.score for view in views[1:]] == sorted((view.score for view in views[1:]), reverse=True)
    reduced = nf.reduce(scene, center=CENTER, r1=R1, r2=R2, face_size=128, samples=1, channels=("color", "range"))
    view = nf.Camera.look_at(user, viewpoint.ahead(user, forward), fov=nf.Fov.symmetric(90, 1.6), size=(320, 200))
    truth = nf.render(scene, view, channels=("color", "position"))
    away = truth.require("position").astype(np.float64) + truth.origin - CENTER
    rho = np.hypot(away[..., 0], away[..., 2])
    for zone in (rho <= R1, (rho > R1) & (rho <= R2), rho > R2):
        assert zone.mean() > 0.01
    torn = {}
    for name in ("none", "blend"):
        frame = reduced.with_morph(name).render(view, channels=("color", "position"))
        torn[name] = nf.compare(truth, frame, center=CENTER, radius=R2).boundary_discontinuity
    assert torn["none"] is not None
    assert torn["blend"] is not None
    assert torn["none"] > 2.0 * torn["blend"]


@pytest.mark.parametrize("side", [-1.0, 1.0])
def test_from_outside_the_side_that_sees_more_of_the_boundary_comes_first(side: float) -> None:
    """A screen beside a wall that crosses r2 hides half of the crossing from one side."""
    wall, screen = trimesh.creation.box((0.5, 40, 50)), trimesh.creation.box((4, 40, 2))
    wall.apply_translation((0, 0, -55))
    screen.apply_translation((side * 2.5, 20, -42))
    scene = nf.Scene.from_trimesh(trimesh.Scene([wall, screen]))
    place = viewpoint.facing_open(scene, (0.0, 1.7, 0.0))
    assert place.is_outside
    hidden, seen = (
        crossing.panorama(scene, (x, 1.7, 0.0), place.eye, R1, R2).scores(90.0).max() for x in (side * 6, -side * 6)
    )
    assert 0.0 < hidden < seen
    views = crossing.views(scene, place, 6.0, R1, R2, fov=90.0)
    assert [np.sign(view.user[0]) for view in views] == [-side, side]
    assert views[0].score > views[1].score


def test_a_boundary_hidden_by_walls_is_in_no_view() -> None:
    scene = nf.Scene.from_trimesh(trimesh.creation.box((20, 20, 20)))
    assert crossing.looks(scene, (0, 0, 0), (0, 0, 0), R1, R2, fov=90.0) == []
    assert crossing.views(scene, viewpoint.facing_open(scene, (0, 0, 0)), 2.0, R1, R2, fov=90.0) == []
