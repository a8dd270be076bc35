"""Tests of motion vectors: against points followed over frames, for scenes, moving objects and reduced scenes."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from tests.support.gpu_cases import adapter
from tests.support.reduce_cases import CENTER, place, street

SIZE = (96, 64)
FOV = nf.Fov(-0.9, 0.7, -0.5, 0.6)


def looking(eye: tuple[float, float, float], target: tuple[float, float, float]) -> nf.Camera:
    return nf.Camera.look_at(eye, target, fov=FOV, size=SIZE)


THEN, NOW = looking((3.0, 1.7, -2.0), (9.0, 1.5, -9.0)), looking((3.4, 1.6, -2.3), (9.0, 1.7, -8.0))


def centers() -> NDArray[np.float64]:
    y, x = np.mgrid[0 : SIZE[1], 0 : SIZE[0]]
    return np.stack([x, y], axis=-1) + 0.5


def followed(points: NDArray[np.float64], camera: nf.Camera) -> NDArray[np.float64]:
    """Motion (H, W, 2) of pixels from their points (H, W, 3) in an earlier camera."""
    return np.asarray(centers() - camera.project(points.reshape(-1, 3))[:, :2].reshape(*points.shape[:2], 2))


def test_motion_follows_camera_and_objects() -> None:
    scene = street(dynamic=True)
    then, now = place(7.0, 0.75, -9.0), place(7.5, 0.75, -8.0) @ turn(0.3)
    frame = nf.render(
        scene,
        NOW,
        at={"car": now},
        before=THEN,
        before_at={"car": then},
        channels=("motion", "position", "object_id", "range"),
    )
    points = frame.require("position").astype(np.float64) + frame.origin
    car = frame.require("object_id") == scene.object_names.index("car")
    assert 30 < car.sum() < 2000
    points[car] = (points[car] - now[:3, 3]) @ now[:3, :3] @ then[:3, :3].T + then[:3, 3]
    hit = np.isfinite(frame.require("range"))
    expected = followed(np.where(hit[..., None], points, 0.0), THEN)
    # Positions are rounded by 1e-4 m on the ground's triangles, which are 2 km long; motion uses ray positions.
    np.testing.assert_allclose(frame.require("motion")[hit], expected[hit], atol=1e-2)
    standing = followed(frame.require("position") + np.array(frame.origin), THEN)
    assert np.linalg.norm(expected - standing, axis=-1)[car].mean() > 2.0


def turn(angle: float) -> NDArray[np.float64]:
    matrix = np.eye(4)
    matrix[:3, :3] = [[np.cos(angle), 0, np.sin(angle)], [0, 1, 0], [-np.sin(angle), 0, np.cos(angle)]]
    return matrix


def test_the_sky_moves_with_rotation_only() -> None:
    scene = street(ground=False)
    moved = nf.Camera(THEN.position, NOW.orientation, fov=FOV, size=SIZE)
    motions = [nf.render(scene, camera, before=THEN, channels=("motion", "object_id")) for camera in (moved, NOW)]
    sky = [frame.require("object_id") < 0 for frame in motions]
    both = sky[0] & sky[1]
    assert both.mean() > 0.2
    np.testing.assert_allclose(motions[0].require("motion")[both], motions[1].require("motion")[both], atol=2e-3)
    expected = followed(np.array(THEN.position) + 1e9 * moved.rays()[1], THEN)
    np.testing.assert_allclose(motions[0].require("motion")[sky[0]], expected[sky[0]], atol=2e-3)


def test_only_requested_channels_are_kept_and_still_pixels_have_zero_motion() -> None:
    frame = nf.render(street(), NOW, before=NOW, channels=("motion",))
    assert frame.channels == ("motion",)
    np.testing.assert_allclose(frame.require("motion"), 0.0, atol=1e-4)


def test_motion_of_points_behind_the_earlier_camera_is_nan() -> None:
    back = looking((3.0, 1.7, -2.0), (-3.0, 1.5, 5.0))
    assert np.isnan(nf.render(street(), NOW, before=back, channels=("motion",)).require("motion")).any()


@pytest.mark.parametrize("morph", ["blend", "cylinder", "none"])
def test_motion_of_reduced_scenes_follows_displayed_positions(morph: str) -> None:
    """Compares every surface with its displayed position for the earlier user."""
    light = nf.reduce(
        street(), center=CENTER, r1=12.0, r2=30.0, face_size=64, samples=1, morph=morph, channels=("color", "range")
    )
    frame = nf.render(light, NOW, before=THEN, channels=("motion", "position", "range"))
    hit = np.isfinite(frame.require("range"))
    points = (frame.require("position") + np.array(frame.origin))[hit].astype(np.float64)
    if morph == "none":
        away = points - CENTER
        far = np.hypot(away[:, 0], away[:, 2]) > 30.0
        shown = np.where(far[:, None], np.array(THEN.position) + away, points)
    else:
        shown = nf.morph(points, user=THEN.position, center=CENTER, r1=12.0, r2=30.0, kind=morph)
    expected = centers()[hit] - THEN.project(shown)[:, :2]
    # Moved triangles are split to half a pixel, and motion follows the rays. The side of r2 of some points is rounding.
    assert (np.abs(frame.require("motion")[hit] - expected) > 0.15).mean() < 1e-3


def test_paths_compare_each_frame_with_the_one_before() -> None:
    scene = street(dynamic=True)
    poses = [{"car": place(7.0, 0.75, -9.0)}, {"car": place(7.5, 0.75, -8.0)}]
    first, second = nf.render_path(scene, [THEN, NOW], at=poses, channels=("motion",))
    np.testing.assert_allclose(first.require("motion"), 0.0, atol=1e-4)
    expected = nf.render(scene, NOW, at=poses[1], before=THEN, before_at=poses[0], channels=("motion",))
    np.testing.assert_array_equal(second.require("motion"), expected.require("motion"))


@pytest.mark.parametrize("name", ["vulkan", "gl"])
def test_adapters_have_the_same_motion(name: str) -> None:
    scene = street()
    expected = nf.render(scene, NOW, before=THEN, channels=("motion", "face_id"), backend="cpu")
    with adapter(name):
        found = nf.render(scene, NOW, before=THEN, channels=("motion", "face_id"), backend="gpu")
    same = expected.require("face_id") == found.require("face_id")
    assert same.mean() > 0.99
    np.testing.assert_allclose(found.require("motion")[same], expected.require("motion")[same], atol=2e-2)


def test_motion_is_saved_and_loaded(tmp_path: Path) -> None:
    frame = nf.render(street(), NOW, before=THEN, channels=("color", "motion"))
    frame.save(tmp_path / "frame.exr")
    again = nf.Frame.load(tmp_path / "frame.exr")
    np.testing.assert_array_equal(again.require("motion"), frame.require("motion"))


def test_arguments_are_checked() -> None:
    scene, small = street(), nf.Camera((0, 0, 0), fov=FOV, size=(8, 8))
    with pytest.raises(ValueError, match="channels: expected motion with the camera"):
        nf.render(scene, NOW, channels=("motion",))
    with pytest.raises(ValueError, match="before: expected a camera of"):
        nf.render(scene, NOW, before=small, channels=("motion",))
    with pytest.raises(ValueError, match="cameras: expected all of one size for motion"):
        list(nf.render_path(scene, [NOW, small], channels=("motion",)))
