"""View directions of measurements: even directions, and the published axes."""

from __future__ import annotations

import itertools
import math
from typing import Any, get_args

import numpy as np
import pytest

import nearfar as nf
from nearfar.lod._measure import views as level_views
from tests.support.lod_cases import FOV, SMALL, Array, ball, fibonacci, levels, turn


def orbit() -> level_views.Orbit:
    screen = level_views.Screen.from_arguments(None, FOV, (128, 128))
    return level_views.Orbit(screen, (3.0, -2.0, 1.0), 1.2, 1.2, screen.sines("published", 4))


def cameras(views: int, directions: level_views.Directions) -> list[nf.Camera]:
    """Return the camera of each distinct picture."""
    return [orbit().camera(1, one) for one in level_views.turns(views, directions)[0]]


def sides(seen: list[nf.Camera]) -> Array:
    """Return directions (N, 3) from the object to its cameras."""
    away = np.array([camera.position for camera in seen]) - orbit().center
    return np.asarray(away / np.linalg.norm(away, axis=1, keepdims=True))


def widest_gap(directions: Array) -> float:
    """Return the greatest angle in degrees between any direction and the nearest of the given ones."""
    return math.degrees(math.acos((fibonacci(20_000) @ directions.T).max(axis=1).min()))


@pytest.mark.parametrize("directions", get_args(level_views.Directions))
def test_cameras_move_inversely_to_the_objects_rotation(directions: level_views.Directions) -> None:
    views = 24
    turns, shown = level_views.turns(views, directions)
    assert len(shown) == views
    still = orbit().camera(2, (0.0, 0.0, 0.0, 1.0))
    points = ball(6)[0]
    for view in range(views):
        camera = orbit().camera(2, turns[shown[view]])
        # A turned object before a fixed camera looks like the fixed object before a camera that moves around it.
        turned = (points - orbit().center) @ turn(view, views, directions).T + orbit().center
        np.testing.assert_allclose(camera.project(points), still.project(turned), rtol=0, atol=1e-9)


def test_published_views_are_rotations_about_four_axes_across_the_view() -> None:
    shown = level_views.turns(144, "published")[1]
    assert np.bincount(shown).tolist() == [4] + 140 * [1]
    seen = sides(cameras(144, "published"))[shown].reshape(4, 36, 3)
    # About each axis a circle in steps of 10 degrees through the front, +z, in a plane across the axis.
    axes = np.array([(1, 0, 0), (0, 1, 0), (1, 1, 0), (1, -1, 0)])
    np.testing.assert_allclose(np.einsum("sij,sj->si", seen, axes), 0.0, atol=1e-12)
    np.testing.assert_allclose(seen[:, :, 2], np.tile(np.cos(np.radians(10 * np.arange(36))), (4, 1)), atol=1e-12)
    np.testing.assert_allclose(np.einsum("sij,sij->si", seen, np.roll(seen, 1, axis=1)), np.cos(np.radians(10)))
    different, counts = np.unique((seen.reshape(-1, 3) + 0.0).round(9) + 0.0, axis=0, return_counts=True)
    assert len(different) == 138
    assert sorted(counts)[-3:] == [1, 4, 4]
    assert [different[number].tolist() for number in np.flatnonzero(counts == 4)] == [[0, 0, -1], [0, 0, 1]]


def test_published_back_views_are_rolled_and_so_distinct() -> None:
    seen = np.array([one.project(ball(5)[0]) for one in cameras(144, "published")])
    apart = np.abs(seen[:, None] - seen[None]).max(axis=(2, 3))
    assert apart[~np.eye(len(seen), dtype=bool)].min() > 0.5


@pytest.mark.parametrize("views", [4, 5, 8, 37, 144])
def test_even_directions_cover_all_sides(views: int) -> None:
    turns, shown = level_views.turns(views, "even")
    assert len(turns) == views
    assert shown.tolist() == list(range(views))
    seen = sides(cameras(views, "even"))
    np.testing.assert_allclose(seen, fibonacci(views), atol=1e-12)
    # N caps of this angle cover the sphere up to overlaps; without overlaps the factor would be 1.
    ideal = math.degrees(math.acos(1 - 2 / views))
    assert widest_gap(seen) < 1.4 * ideal
    between = np.degrees(np.arccos(np.clip(seen @ seen.T, -1, 1)))
    assert between[~np.eye(views, dtype=bool)].min() > ideal


def test_even_directions_leave_smaller_gaps_than_published_ones() -> None:
    even, published = (widest_gap(sides(cameras(144, name))) for name in get_args(level_views.Directions))
    assert even < 13.5
    assert published > 22


@pytest.mark.parametrize("directions", get_args(level_views.Directions))
def test_every_rotation_axis_is_across_the_view(directions: level_views.Directions) -> None:
    for x, y, z, w in level_views.turns(144, directions)[0]:
        assert z == 0.0
        assert math.hypot(x, y, w) == pytest.approx(1.0, rel=1e-15)
        # Even views use the shortest rotations, at most half a turn.
        assert directions == "published" or w >= 0.0


@pytest.mark.parametrize(("directions", "views"), [("even", 96), ("even", 250), ("published", 144)])
def test_the_first_views_cover_all_sides(directions: level_views.Directions, views: int) -> None:
    pictures = cameras(views, directions)
    subsets = level_views.nested_turns(len(pictures))
    assert len(subsets[0]) == math.ceil(len(pictures) / 12)
    gaps = [widest_gap(sides(pictures)[turns]) for turns in subsets]
    assert gaps[0] < 65
    assert gaps == sorted(gaps, reverse=True)
    for few, more in itertools.pairwise(subsets):
        assert set(few) < set(more)
        assert len(more) <= 2 * len(few)
    assert subsets[-1].tolist() == list(range(len(pictures)))


@pytest.mark.parametrize("directions", get_args(level_views.Directions))
def test_a_model_records_its_view_directions(directions: level_views.Directions) -> None:
    options: dict[str, Any] = SMALL | {"directions": directions, "cache": False}
    model = nf.lod.measure(levels(8, 4), **options)
    assert model.measured["directions"] == directions
    axes = [[1, 0, 0], [0, 1, 0], [1, 1, 0], [1, -1, 0]]
    assert model.measured["axes"] == (axes if directions == "published" else None)
    assert model.samples is not None
    assert model.samples.views is not None
    # The unrotated view is the same picture for all four published axes.
    pictures = 8 if directions == "even" else 5
    assert model.measured["scores"] == 4 * pictures
    assert model.measured["renders"] == 4 * pictures * 2
    assert model.samples.views.shape == (2, 4, 8)
    assert np.isfinite(model.samples.views).all()
