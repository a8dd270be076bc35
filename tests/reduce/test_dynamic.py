"""Tests of moving objects: near and far, occluded by nearer objects, posed without rebuilding."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from nearfar._reduce.drawing import MorphKind
from tests.support.reduce_cases import CENTER, R1, R2, camera, place, rho, street

Array = NDArray[np.float64]
USER = CENTER + np.array([0.0, 0.0, 7.0])
SIZE = (480, 270)
OBJECTS = ("color", "object_id")


@pytest.fixture(scope="module")
def scene() -> nf.Scene:
    return street(dynamic=True)


@pytest.fixture(scope="module")
def reduced(scene: nf.Scene) -> nf.ReducedScene:
    return nf.reduce(scene, center=CENTER, r1=R1, r2=R2, face_size=512, samples=1, channels=OBJECTS)


def car_pixels(reduced: nf.ReducedScene, view: nf.Camera, pose: Array, **how: Any) -> NDArray[np.bool_]:
    """Pixels in which the car is visible."""
    car = reduced.scene.object_names.index("car")
    frame = reduced.render(view, at={"car": pose}, channels=("object_id",), **how)
    return np.asarray(frame.require("object_id") == car)


def centroid(mask: NDArray[np.bool_]) -> Array:
    rows, columns = np.nonzero(mask)
    return np.array([columns.mean(), rows.mean()]) + 0.5


def test_maps_of_dynamic_scenes_have_range_and_others_do_not(scene: nf.Scene, reduced: nf.ReducedScene) -> None:
    assert reduced.stats["ranges_computed"] == 6 * 512**2
    still = nf.reduce(street(), center=CENTER, r1=R1, r2=R2, face_size=32, samples=1)
    assert still.stats["ranges_computed"] == 0
    for method in ("vertex", "exact"):
        frame = still.render(camera(USER, (1, 0, 0)), method=method)
        assert frame.stats["dynamic_triangles"] == 0
        frame = reduced.render(camera(USER, (1, 0, 0)), method=method, channels=("color",), tolerance_px=50.0)
        assert frame.stats["dynamic_triangles"] >= 12


def test_empty_far_parts_have_no_map(scene: nf.Scene) -> None:
    alone = nf.reduce(scene.subset(objects=["near", "car"]), center=CENTER, r1=R1, r2=R2)
    assert alone.env is None
    assert alone.stats["map_bytes"] == alone.stats["rays"] == 0


@pytest.mark.parametrize("kind", ["blend", "cylinder"])
def test_a_car_that_leaves_moves_without_a_jump(scene: nf.Scene, kind: MorphKind) -> None:
    reduced = nf.reduce(scene, center=CENTER, r1=R1, r2=R2, face_size=256, samples=1, morph=kind, channels=OBJECTS)
    # A strip of a picture of 480 × 270 pixels, which contains the car's way.
    strip = nf.Fov(-1.0, 1.0, -0.1, 0.05)
    view = nf.Camera.look_at(USER, USER + np.array([1, -0.02, 0.1]), fov=strip, size=(480, 36))
    path, expected = [], []
    for x in np.arange(20.0, 80.0, 1.0):
        at = CENTER + np.array([x, -0.9, 4.0])
        mask = car_pixels(reduced, view, place(*at), method="exact", env=False)
        path.append(centroid(mask))
        expected.append(view.project(nf.morph(at[None], user=USER, center=CENTER, r1=R1, r2=R2, kind=kind))[0, :2])
    # A car of 40 px or less is symmetric about its middle to a pixel.
    assert np.abs(np.array(path) - np.array(expected))[5:].max() < 1.5
    # One metre per frame. Where the weight begins to fall, the picture turns by 7 m / 30 m / 20 m per metre: 2.8 px.
    assert np.linalg.norm(np.diff(path, n=2, axis=0), axis=1).max() < 3.5
    # With the conventional method the car jumps from the user's view to the centre's: 7 m at 50 m are 33 px.
    conventional = reduced.with_morph("none")
    broken = []
    for x in np.arange(35.0, 65.0, 1.0):
        mask = car_pixels(conventional, view, place(*(CENTER + np.array([x, -0.9, 4.0]))), method="exact", env=False)
        broken.append(centroid(mask))
    assert np.linalg.norm(np.diff(broken, axis=0), axis=1).max() > 10.0


def test_far_buildings_occlude_the_car_as_in_the_exact_picture(reduced: nf.ReducedScene) -> None:
    # Positions beside the tower at (100..120, 0..70, 60..80), from in front of it to behind it.
    view = camera(USER, (1, 0.05, 0.65), SIZE)
    seen = []
    for x in np.arange(70.0, 180.0, 10.0):
        pose = np.diag([3.0, 3.0, 3.0, 1.0])
        pose[:3, 3] = x, 2.3, 0.7 * x
        ideal = car_pixels(reduced, view, pose, method="exact", env=False)
        for method in ("vertex", "exact"):
            mask = car_pixels(reduced, view, pose, method=method)
            # The map's silhouettes are as coarse as its texels: two pixels of the car's few dozen.
            edge = ideal ^ mask
            grown = np.zeros_like(ideal)
            for dy in range(-2, 3):
                for dx in range(-2, 3):
                    border = ideal != np.roll(ideal, (dy, dx), (0, 1))
                    grown |= border
            assert not (edge & ~grown).any(), (x, method)
        seen.append(int(ideal.sum()))
    assert seen[0] > 100
    assert 0 in seen


@pytest.mark.slow
def test_near_parts_are_in_front_of_far_ones_for_all_users(reduced: nf.ReducedScene) -> None:
    """Beyond r₁ the picture folds, and displayed distances do not give the order along a ray."""
    user = CENTER + np.array([-35.0, 0.0, 0.0])
    view = camera(user, (1, 0.0, 0.3), SIZE)
    near = reduced.scene.object_names.index("near")
    with_range = reduced.render(view, channels=("object_id",)).require("object_id") == near
    still = nf.reduce(
        reduced.scene.subset(objects=["ground", "wall", "near", "tower"]),
        center=CENTER, r1=R1, r2=R2, face_size=64, samples=1, channels=("color", "object_id"),
    )  # fmt: skip
    without = still.render(view, channels=("object_id",)).require("object_id") == near
    assert with_range.sum() > 20
    np.testing.assert_array_equal(with_range, without)


def test_posing_keeps_static_geometry(scene: nf.Scene, reduced: nf.ReducedScene) -> None:
    posed = [scene.at({"car": place(x, 1, 0)}) for x in (10.0, 45.0, 90.0)]
    assert {tuple(one._core.mesh_ids()) for one in posed} == {tuple(scene._core.mesh_ids())}
    view = camera(USER, (1, 0, 0))
    triangles = []
    for x in (10.0, 45.0, 90.0):
        stats = reduced.render(view, at={"car": place(x, 1, 0)}, channels=("color",)).stats
        triangles.append(stats["frame_triangles"] - stats["dynamic_triangles"])
    assert len(set(triangles)) == 1


def test_moving_objects_are_visible_at_all_distances() -> None:
    scene = street(dynamic=True).at({"car": place(100, 0.75, 0)})
    car = scene.object_names.index("car")
    for kind in ("blend", "none"):
        reduced = nf.reduce(scene, center=CENTER, r1=R1, r2=R2, face_size=256, samples=1, morph=kind)
        assert reduced.env is not None
        assert reduced.env.channels == ("color", "range")
        assert reduced.stats["ranges_computed"] == 6 * 256 * 256
        user = CENTER + np.array([0, 0, 3])
        view = camera(user, (1, -0.02, 0))
        wanted = ("color", "range", "position", "face_id", "normal")
        first = scene.triangle_count - 12
        for x, z in [(20.0, 0.0), (40.0, 0.0), (70.0, 0.0), (300.0, 5.0)]:
            frame = reduced.render(view, at={"car": place(x, 0.75, z)}, channels=wanted)
            seen = frame.require("face_id") >= first
            assert seen.any(), (kind, x)
            points = frame.require("position")[seen].astype(np.float64)
            if kind == "blend":
                points = nf.morph(points, user=user, center=CENTER, r1=R1, r2=R2)
            else:
                # The conventional method's weight is a step: the far part is seen from the centre.
                points[rho(points) > R2] += user - CENTER
            # The displayed distance: float32 at 300 m.
            np.testing.assert_allclose(
                frame.require("range")[seen], np.linalg.norm(points - user, axis=1), rtol=0, atol=5e-3
            )
        # Behind the wall, beyond r₂ and within it.
        for x, z in [(90.0, -60.0), (30.0, -35.0)]:
            behind = reduced.render(camera(CENTER, (1, 0, -0.6)), at={"car": place(x, 0.75, z)}, channels=("face_id",))
            assert (behind.require("face_id") < first).all(), (kind, x)
    truth = nf.render(scene, camera(CENTER, (1, 0, 0)), channels=("object_id",))
    assert (truth.require("object_id") == car).any()


def test_moving_objects_are_not_in_the_map() -> None:
    scene = street(dynamic=True)
    maps = [
        nf.reduce(scene.at({"car": place(x, 0.75, 0)}), center=CENTER, r1=R1, r2=R2, face_size=32, samples=1).env
        for x in (80.0, -80.0)
    ]
    assert maps[0] is not None
    assert maps[1] is not None
    np.testing.assert_array_equal(maps[0].color, maps[1].color)
