"""Tests of trees with moving objects, and of their near and far parts."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from numpy.typing import NDArray

import nearfar as nf
from nearfar._reduce.drawing import MorphKind
from tests.support import need
from tests.support.reduce_cases import place

need("zarr")

Tree = nf.orthoview.OrthoTree
R1, R2 = 8.0, 25.0


@pytest.fixture(scope="module")
def center(layered: Tree) -> tuple[float, float, float]:
    x, y, z = layered.bounds.mean(axis=0).tolist()
    return x, y, z


@pytest.fixture
def mover(center: tuple[float, float, float]) -> nf.Scene:
    return nf.Scene.from_trimesh(trimesh.creation.box((8, 8, 8)).apply_translation(center))


def camera_at(center: tuple[float, float, float], angle: float, distance: float = 110.0) -> nf.Camera:
    eye = np.add(center, [distance * np.cos(angle), 40.0, distance * np.sin(angle)])
    return nf.Camera.look_at(eye, center, fov=nf.Fov.symmetric(50), size=(64, 64))


@pytest.mark.parametrize("offset", [(0.0, 0.0, 0.0), (0.0, 35.0, 0.0), (30.0, 10.0, -20.0)])
def test_moving_objects_are_visible_where_they_are_nearer(
    layered: Tree, mover: nf.Scene, center: tuple[float, float, float], offset: tuple[float, float, float]
) -> None:
    camera, channels = camera_at(center, 0.7), ("color", "range", "object_id", "position")
    dynamic = layered.with_dynamic(mover)
    (name,) = mover.object_names
    poses = {name: dynamic.poses[name] + place(*offset) - np.eye(4)}
    both = nf.render(dynamic, camera, at=poses, channels=channels)
    alone = nf.render(layered, camera, channels=channels)
    only = nf.render(mover.with_dynamic([name]), camera, at=poses, channels=channels)
    is_nearer = only.require("range") < alone.require("range")
    assert is_nearer.any()
    np.testing.assert_array_equal(both.require("object_id"), np.where(is_nearer, 0, -1))
    for channel in ("color", "range"):
        mask = is_nearer if channel == "range" else is_nearer[..., None]
        expected = np.where(mask, only.require(channel), alone.require(channel))
        np.testing.assert_allclose(both.require(channel), expected, rtol=1e-5, atol=1e-6)
    world = both.require("position")[is_nearer] + both.origin
    np.testing.assert_allclose(world, only.require("position")[is_nearer] + only.origin, atol=1e-3)


def test_a_tree_without_moving_objects_accepts_no_poses(layered: Tree, mover: nf.Scene) -> None:
    with pytest.raises(ValueError, match="nothing moves"):
        layered.at({"box": np.eye(4)})
    assert layered.poses == {}


def test_flights_show_moving_objects(layered: Tree, mover: nf.Scene, center: tuple[float, float, float]) -> None:
    camera, dynamic = camera_at(center, 0.7), layered.with_dynamic(mover)
    (name,) = mover.object_names
    poses = {name: dynamic.poses[name] + place(0.0, 35.0, 0.0) - np.eye(4)}
    with dynamic.fly() as flight:
        flight.look(camera)
        assert flight.wait(60)
        for at in ({}, poses):
            shown = nf.render(flight, camera, at=at or None)
            assert (
                shown.require("range").tobytes() == nf.render(dynamic, camera, at=at or None).require("range").tobytes()
            )


def test_the_near_scene_has_all_near_triangles(
    layered: Tree, thirty: nf.Scene, center: tuple[float, float, float], mover: nf.Scene
) -> None:
    near = nf.orthoview.open(layered.path).near_scene(center, R2)  # No cut has read the guests of leaves.
    assert near is not None
    whole, part = (nf.partition(each, center=center, r1=R1, r2=R2).summary() for each in (thirty, near))
    assert part["near"] == whole["near"] > 0
    assert part["intermediate"] == whole["intermediate"] > 0
    assert part["triangles"] < whole["triangles"]
    with_mover = layered.with_dynamic(mover).near_scene(center, R2)
    assert with_mover is not None
    assert with_mover.triangle_count == near.triangle_count + mover.triangle_count


def true_map(world: nf.Scene, center: tuple[float, float, float], size: int) -> tuple[nf.EnvMap, NDArray[Any]]:
    """The world's map, and its range."""
    env = nf.reduce(world, center=center, r1=R1, r2=R2, face_size=size, channels=("color", "range")).env
    assert env is not None
    assert env.range is not None
    return env, env.range


def test_the_map_of_a_tree_equals_that_of_the_world(
    layered: Tree, thirty: nf.Scene, center: tuple[float, float, float]
) -> None:
    made = layered.far_map(center, R2, face_size=64, samples=4, channels=("range",))
    true, true_range = true_map(thirty, center, 64)
    assert made.range is not None
    is_hit, is_shown = np.isfinite(true_range), np.isfinite(made.range)
    assert is_hit.mean() > 0.05
    assert (is_hit & ~is_shown).mean() < 0.02
    assert (is_shown & ~is_hit).mean() < 0.02
    both = is_hit & is_shown
    assert np.median(np.abs(made.range[both] - true_range[both])) < 0.2
    assert np.sqrt(((made.color - true.color) ** 2).mean()) < 0.08


def test_the_map_of_a_tree_shows_nothing_within_the_radius(
    layered: Tree, thirty: nf.Scene, center: tuple[float, float, float]
) -> None:
    """A map of geometry extends two texels inwards, one of views half a pixel."""
    size = 32
    made = layered.far_map(center, R2, face_size=size, samples=1, channels=("range",), error_px=1e3)
    true, _ = true_map(thirty, center, size)
    cameras = [nf.Camera(center, fov=nf.CubeFace(face), size=(size, size)) for face in range(6)]
    rays = np.stack([camera.rays()[1] for camera in cameras])
    across = np.hypot(rays[..., 0], rays[..., 2])
    own, right = (across * np.asarray(env.range) for env in (made, true))
    assert np.isfinite(own).mean() > 0.05
    assert ((own < R2 - 3.0) & (right > R2)).mean() < 0.005


def test_a_map_of_geometry_alone_equals_the_worlds(
    layered: Tree, thirty: nf.Scene, center: tuple[float, float, float]
) -> None:
    made = layered.far_map(center, R2, face_size=32, samples=4, channels=("range",), error_px=1e-6)
    _, true_range = true_map(thirty, center, 32)
    assert made.range is not None
    is_hit = np.isfinite(true_range)
    # Corners in a leaf's file are rounded to steps of a few millimetres.
    assert (is_hit != np.isfinite(made.range)).mean() < 0.005
    both = is_hit & np.isfinite(made.range)
    assert np.quantile(np.abs(made.range[both] - true_range[both]), 0.99) < 0.05


@pytest.mark.parametrize("morph", ["blend", "none"])
def test_a_tree_is_reduced_like_its_world(
    layered: Tree, thirty: nf.Scene, center: tuple[float, float, float], morph: MorphKind
) -> None:
    camera = nf.Camera.look_at(center, np.add(center, [10.0, -2.0, 3.0]), fov=nf.Fov.symmetric(80), size=(64, 64))
    made, true = (
        nf.reduce(source, center=center, r1=R1, r2=R2, face_size=64, morph=morph).render(camera)
        for source in (layered, thirty)
    )
    assert np.sqrt(((made.require("color") - true.require("color")) ** 2).mean()) < 0.08


def test_moving_objects_are_composited_with_the_map(
    layered: Tree, mover: nf.Scene, center: tuple[float, float, float]
) -> None:
    reduced = nf.reduce(layered.with_dynamic(mover), center=center, r1=R1, r2=R2, face_size=64)
    assert reduced.env is not None
    assert reduced.env.range is not None
    assert set(reduced.poses) == set(mover.object_names)


def test_a_saved_reduction_of_a_tree_is_restored(
    layered: Tree, center: tuple[float, float, float], tmp_path: Path
) -> None:
    reduced = nf.reduce(layered, center=center, r1=R1, r2=R2, face_size=32)
    reduced.save(tmp_path / "reduced")
    camera = camera_at(center, 0.0, 1.0)
    one, other = reduced.render(camera), nf.ReducedScene.load(tmp_path / "reduced").render(camera)
    np.testing.assert_allclose(one.require("color"), other.require("color"), atol=2e-3)


@pytest.mark.parametrize(
    ("how", "message"),
    [
        ({"unit": "object"}, "unit"),
        ({"backend": "gpu"}, "backend"),
        ({"samples": 2}, "samples"),
        ({"channels": ("color", "object_id")}, "channels"),
        ({"center": (1e5, 0.0, 0.0)}, "geometry within r2"),
    ],
)
def test_unsupported_settings_of_trees_are_refused(
    layered: Tree, center: tuple[float, float, float], how: dict[str, Any], message: str
) -> None:
    with pytest.raises(ValueError, match=message):
        nf.reduce(layered, **{"center": center, "r1": R1, "r2": R2, "face_size": 16, **how})


def test_a_tree_without_geometry_has_no_near_scene(thirty: nf.Scene, tmp_path: Path) -> None:
    bare = nf.orthoview.build(thirty, tmp_path / "bare.zarr", cell=40, size=8, directions=5, geometry=False)
    with pytest.raises(ValueError, match="with geometry"):
        bare.near_scene(bare.bounds.mean(axis=0), R2)
