"""Tests of the default radii of commands."""

from __future__ import annotations

import math

import numpy as np
import pytest
import trimesh

import nearfar as nf
from nearfar._reduce import default_radii
from nearfar._trace import viewpoint
from tests.support.reduce_cases import street


def box(extents: tuple[float, float, float]) -> trimesh.Trimesh:
    """A box that stands on the ground."""
    return trimesh.creation.box(extents, trimesh.transformations.translation_matrix((0, extents[1] / 2, 0)))


def room() -> nf.Scene:
    """A room of 8 × 3 × 6 m, whose faces look inwards, and a table in it."""
    walls = box((8, 3, 6))
    walls.invert()
    return nf.Scene.from_trimesh(trimesh.Scene([walls, box((1, 0.7, 1))]))


def test_cities_have_50_metres_and_the_radius_of_little_shear() -> None:
    scene, place = street(), viewpoint.facing((3.0, 1.7, -2.0), (9, 0, 9))
    chosen = default_radii.choose(scene, place)
    expected = nf.choose_radii(scene, place.eye, r2=50)
    assert chosen.r1 == pytest.approx(expected.r1, rel=5e-3)
    assert chosen.r2 == 50.0
    assert chosen.reason == (
        "r2 = 50 m is the default where a scene reaches 75 m away; with r1 = 8.76 m the greatest shear of "
        "the ground between the radii is 1, in pixels per pixel, for a user 8 m beside the centre"
    )


def test_rooms_have_radii_within_their_walls() -> None:
    scene = room()
    chosen = default_radii.choose(scene, viewpoint.find(scene))
    assert 0.5 < chosen.r1 < chosen.r2 < 4.0
    assert chosen.reason.startswith("r2 is two thirds of the way to the walls")


def test_radii_of_objects_divide_them_in_thirds() -> None:
    helmet = nf.Scene.from_trimesh(box((0.3, 0.7, 0.4)))
    place = viewpoint.find(helmet)
    chosen = default_radii.choose(helmet, place)
    rho = np.hypot(*(helmet.triangles()[..., [0, 2]] - np.array(place.eye)[[0, 2]]).reshape(-1, 2).T)
    assert rho.min() < chosen.r1 < chosen.r2 < rho.max()
    assert "thirds" in chosen.reason


@pytest.mark.parametrize(
    ("given", "radii"),
    [
        ((None, 20.0), (8.0, 20.0)),
        ((None, 90.0), (15.8, 90.0)),
        ((60.0, None), (60.0, 100.0)),
        ((5.0, None), (5.0, 50.0)),
        ((5.0, 7.0), (5.0, 7.0)),
    ],
)
def test_a_missing_radius_follows_from_the_other(
    given: tuple[float | None, float | None], radii: tuple[float, float]
) -> None:
    assert default_radii.complete_radii(*given) == pytest.approx(radii)
    chosen = default_radii.choose(street(), viewpoint.facing((3.0, 1.7, -2.0), (9, 0, 9)), *given)
    assert (chosen.r1, chosen.r2) == pytest.approx(radii)
    assert bool(chosen.reason) == (None in given)


@pytest.mark.parametrize("r2", [0.1, 1.0, 4.0, 16.0, 17.0, 50.0, 400.0])
def test_the_default_user_does_not_fold_the_picture(r2: float) -> None:
    r1, _ = default_radii.complete_radii(None, r2)
    away = default_radii.user_distance(r1, r2)
    assert 0.1 * r1 < away <= 0.9 * r1
    assert nf.fold_margin((away, 0, 0), center=(0, 0, 0), r1=r1, r2=r2) > 0.0
    assert math.isfinite(r1)
