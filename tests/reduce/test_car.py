"""Tests of a car that drives from near to far: no jump, equal occlusion (benchmarks/reduce/dynamic.py)."""

from __future__ import annotations

import numpy as np
import pytest

import nearfar as nf
from benchmarks.reduce.dynamic import (
    CAR,
    CENTER,
    END,
    METHODS,
    R1,
    R2,
    RATE,
    SPEED,
    TURNS,
    USER,
    Array,
    camera,
    centroids,
    changes,
    city,
    distances,
    drive,
    is_torn,
    lone_car,
    project_car,
)

VIEW = camera(960)
FOCAL = 480.0
"""Focal length in pixels: 960 pixels across 90°. The car is within 30° of the axis, where pixels per angle are at most
4/3 of it."""


@pytest.fixture(scope="module")
def scene() -> nf.Scene:
    return city(4, 1)


@pytest.mark.parametrize("turn", TURNS)
def test_the_path_is_drivable(scene: nf.Scene, turn: str) -> None:
    poses = drive(turn)
    away = distances(poses)
    assert away[0] == pytest.approx(np.hypot(15.0, 1.7))
    assert END - SPEED / RATE < away[-1] < END
    # The car moves ahead at constant speed (a chord of the bend is 2e-4 shorter).
    assert (np.diff(away) > 0.0).all()
    moved = np.diff(poses[:, :3, 3], axis=0)
    np.testing.assert_allclose(np.linalg.norm(moved, axis=1), SPEED / RATE, rtol=1e-3)
    ahead = (moved * poses[1:, :3, 2]).sum(axis=1) / (SPEED / RATE)
    # The car turns by at most 5° per picture.
    assert ahead.min() > np.cos(np.radians(5.0))
    np.testing.assert_allclose(np.linalg.det(poses), 1.0, rtol=1e-12)


def test_the_car_jumps_with_the_conventional_method_only() -> None:
    poses = drive("left")
    away = distances(poses)
    jump = {method: changes(project_car(VIEW, poses, method)) for method in METHODS}
    # The user is 5.4 m from the centre. From r₁ on the picture turns by that over the distance, a 20th of it per
    # metre: this begins abruptly, and so does its end. The truth's own changes, where the car turns, come elsewhere.
    bend = np.linalg.norm(USER - CENTER) / R1 * (SPEED / RATE) / (R2 - R1) * FOCAL * 4.0 / 3.0
    assert jump["continuous"].max() < bend + jump["truth"].max() < 3.1
    # With the conventional method the car jumps at r₂ from the user's view to the centre's: 5 m sideways at 50 m.
    at = int(jump["conventional"].argmax())
    assert abs(away[at + 1] - R2) < 2.0 * SPEED / RATE
    assert jump["conventional"].max() > 0.9 * (USER - CENTER)[0] / R2 * FOCAL > 10.0 * jump["continuous"].max()
    # In all other pictures both motions are as steady as the truth.
    quiet = np.minimum(np.abs(away - R1), np.abs(away - R2))[1:-1] > 2.0 * SPEED / RATE
    for method in ("conventional", "continuous"):
        assert jump[method][quiet].max() < 2.0 * jump["truth"].max(), method


def poses_near_radius(radius: float) -> Array:
    """Poses of pictures in which part of the car is within a metre of a radius."""
    poses = drive("left")
    # Half of the car's length is 2.25 m.
    return poses[np.abs(distances(poses) - radius) < 3.25]


@pytest.mark.parametrize("radius", [R1, R2])
def test_pixels_of_the_car_move_together(scene: nf.Scene, radius: float) -> None:
    poses = poses_near_radius(radius)
    assert len(poses) >= 14
    masks = lone_car(scene, VIEW, poses, "continuous")
    offset = centroids(masks) - project_car(VIEW, poses, "continuous")
    # Across a radius one end is morphed differently from the other, half a car or 2.25 m further: 2.25 of 20 m of the
    # transition from the user's to the centre's view are 10 px at 30 m. The outline's middle shifts by less than half.
    assert np.ptp(offset, axis=0).max() < 5.0
    assert not any(map(is_torn, masks))
    # The car crosses a radius within ten pictures, which distribute the change of its middle: 2.7 px, above, and
    # the rounding of four middles of hundreds of pixels, a tenth of a pixel each.
    assert changes(centroids(masks)).max() < 2.7 / 2.0
    if radius == R2:
        conventional = lone_car(scene, VIEW, poses, "conventional")
        # 48 px apart, and at most 20 px wide: for its length of 4.5 m the car is in both places.
        assert sum(map(is_torn, conventional)) >= 8
        assert np.linalg.norm(np.ptp(centroids(conventional), axis=0)) > 40.0


@pytest.mark.parametrize("turn", TURNS)
def test_vertex_and_exact_pictures_occlude_the_car_equally(scene: nf.Scene, turn: str) -> None:
    channels = ("color", "object_id")
    reduced = nf.reduce(scene, center=CENTER, r1=R1, r2=R2, face_size=256, samples=1, channels=channels)
    view, number = camera(480), scene.object_names.index(CAR)
    seen, differ = [], 0
    for pose in drive(turn)[::24]:
        vertex, exact = (
            reduced.render(view, at={CAR: pose}, channels=("object_id",), method=method).require("object_id") == number
            for method in ("vertex", "exact")
        )
        seen.append(int(exact.sum()))
        differ += int((vertex ^ exact).sum())
    # The vertices' morph is off by half a pixel at most, which changes only a few pixels along outlines; a
    # wrong order of car and tree, or of car and house, would change a large part of it in several of 9 pictures.
    assert differ < 0.02 * sum(seen)
    assert seen[0] > 250
    # The car disappears behind the house; along the park it is visible to the end.
    assert (seen[-1] == 0) == (turn == "right")
