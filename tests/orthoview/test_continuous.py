"""Tests of pictures whose levels change splat by splat, within a budget of splats, and by a direction of gaze."""

from __future__ import annotations

import itertools
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.orthoview.counts import swap_distances
from tests.support.flight_cases import camera_at, holes
from tests.support.orthoview_stores import built_once, world_of

Tree = nf.orthoview.OrthoTree


@pytest.fixture(scope="module")
def scene() -> nf.Scene:
    return world_of(range(25))


@pytest.fixture(scope="module")
def shared_tree(scene: nf.Scene, tmp_path_factory: pytest.TempPathFactory) -> Tree:
    return built_once(tmp_path_factory, "continuous.zarr", scene, cell=10, size=32, directions=9)


def changes(tree: Tree, camera: nf.Camera, errors: NDArray[np.float64], continuous: bool) -> NDArray[np.float64]:
    """RMS changes of the picture from one error to the next."""
    settings: dict[str, Any] = {"geometry": False, "continuous": continuous, "channels": ("color",)}
    frames = (tree.render(camera, error_px=error, **settings).require("color") for error in errors.tolist())
    return np.array([np.sqrt(((one - other) ** 2).mean()) for one, other in itertools.pairwise(frames)])


def test_pictures_change_gradually_while_the_error_doubles(shared_tree: Tree) -> None:
    """Uses a still camera. If cells changed as a whole, a single step would cause most of the total change."""
    camera, errors = camera_at(shared_tree, 170.0), np.geomspace(1, 2, 41)
    jumps, smooth = (changes(shared_tree, camera, errors, continuous) for continuous in (False, True))
    assert jumps.max() > 0.01
    assert smooth.max() < 0.75 * jumps.max()
    whole = changes(shared_tree, camera, errors[[0, -1]], True)[0]
    assert whole > 0.01
    # Pixels change at random, each about once: squares add up.
    assert smooth.max() < 3 * whole / np.sqrt(len(errors) - 1)


@pytest.mark.parametrize("distance", [90.0, 140.0])
def test_two_levels_leave_no_more_holes_than_one(shared_tree: Tree, scene: nf.Scene, distance: float) -> None:
    for angle, error_px in itertools.product((0.3, 2.5), (1.0, 1.5)):
        camera = camera_at(shared_tree, distance, angle)
        truth = nf.render(scene, camera, clip=nf.Clip(box=shared_tree.bounds), channels=("range",))
        frames = [
            shared_tree.render(camera, geometry=False, error_px=error_px, continuous=continuous, channels=("range",))
            for continuous in (False, True)
        ]
        assert holes(frames[1], truth) <= holes(frames[0], truth) + 0.004
        assert frames[1].stats["splats"] != frames[0].stats["splats"]


def test_an_error_of_half_a_pixel_moves_splats_by_less_than_a_pixel(shared_tree: Tree) -> None:
    """The centres of four pixels lie √2/4 from their parent's; on steep surfaces they lie farther away."""
    found = [
        swap_distances(shared_tree, camera_at(shared_tree, distance, angle), 0.5)
        for distance, angle in ((200, 0.3), (400, 2.1))
    ]
    pixels = np.concatenate(found)
    assert len(pixels) > 10_000
    assert 0.25 < np.median(pixels) / (0.5 * np.sqrt(2) / 4) < 1.5
    assert np.quantile(pixels, 0.99) < 1


def flight(tree: Tree) -> list[nf.Camera]:
    return [camera_at(tree, 150.0 - 4 * n, 0.3 + 0.1 * n) for n in range(12)]


@pytest.mark.parametrize("continuous", [False, True])
@pytest.mark.parametrize("budget", [6000, 4000])
def test_a_flight_keeps_to_a_budget(shared_tree: Tree, budget: int, continuous: bool) -> None:
    tree = nf.orthoview.open(shared_tree.path)
    settings: dict[str, Any] = {"geometry": False, "continuous": continuous, "channels": ("color",)}
    errors, splats = [], []
    for camera in flight(shared_tree):
        frame = tree.render(camera, budget=budget, **settings)
        error = frame.stats["error_px"]
        errors.append(error)
        splats.append(frame.stats["splats"])
        # The same error without a budget draws the same splats; a slightly smaller error exceeds the budget.
        assert tree.render(camera, error_px=error, **settings).stats["splats"] == splats[-1]
        assert error > 1
        if not continuous:
            assert tree.render(camera, error_px=error / 1.003, **settings).stats["splats"] > budget
    assert max(splats) <= budget
    assert max(errors) > 1.2 * min(errors)
    assert not continuous or min(splats) >= 0.9 * budget


def test_a_sufficient_budget_changes_nothing(shared_tree: Tree) -> None:
    camera = camera_at(shared_tree, 100)
    whole = shared_tree.render(camera, geometry=False)
    bound = shared_tree.render(camera, geometry=False, budget=int(whole.stats["splats"]))
    assert bound.stats == whole.stats
    assert bound.stats["error_px"] == 1
    np.testing.assert_array_equal(bound.require("color"), whole.require("color"))


def test_views_are_omitted_if_no_error_meets_the_budget(shared_tree: Tree) -> None:
    """An eye inside the world is surrounded by leaves."""
    middle = shared_tree.bounds.mean(axis=0)
    camera = nf.Camera.look_at(middle, middle + np.array([1, -0.2, 0.3]), fov=nf.Fov.symmetric(90), size=(64, 64))
    least = shared_tree.render(camera, geometry=False, error_px=64)
    few = shared_tree.render(camera, geometry=False, budget=int(least.stats["splats"]) // 4)
    assert 0 < few.stats["splats"] <= least.stats["splats"] // 4
    assert few.stats["views"] < least.stats["views"]
    assert shared_tree.render(camera, geometry=False, budget=1).stats["splats"] <= 1


def test_the_gaze_keeps_full_detail(shared_tree: Tree) -> None:
    camera, middle = replace(camera_at(shared_tree, 45), size=(384, 384)), (192.0, 192.0)
    settings: dict[str, Any] = {"geometry": False, "error_px": 4.0}
    evenly, foveated = shared_tree.render(camera, **settings), shared_tree.render(camera, gaze=middle, **settings)
    assert foveated.stats["splats"] < 0.95 * evenly.stats["splats"]
    same = (evenly.require("color") == foveated.require("color")).all(axis=2)
    assert same[180:204, 180:204].all()
    assert not same.all()
