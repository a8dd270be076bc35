"""Tests of motion blur: against loops and shifted pictures."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar import _core
from nearfar._render.ranged import ranged
from nearfar.orthoview._steady import pose_between
from tests.support.steady_oracle import averaged

FOVS: dict[str, Any] = {
    "perspective": nf.Fov(-0.7, 0.5, -0.4, 0.6),
    "cube": nf.CubeFace(5),
    "parallel": nf.Orthographic(-3, 4, -3, 3),
}


def picture(fov: Any, size: int = 18) -> nf.Frame:
    rng = np.random.default_rng(2)
    color = rng.uniform(0, 1, (size, size, 3)).astype(np.float32)
    distance = 8 + rng.uniform(0, 0.5, (size, size))
    distance[5:12, 4:9] = 3.0
    distance[:4] = np.inf
    camera = nf.Camera((10.0, 2.0, -7.0), fov=fov, size=(size, size))
    return nf.Frame(camera, color=color, range=distance.astype(np.float32))


@pytest.mark.parametrize("name", FOVS)
def test_blur_equals_loops(name: str) -> None:
    frame = picture(FOVS[name])
    turned = nf.Camera(
        (10.6, 1.8, -7.4), (0.0, float(np.sin(0.02)), 0.0, float(np.cos(0.02))), fov=FOVS[name], size=(18, 18)
    )
    poses = [pose_between(frame.camera, turned, share) for share in (0.1, 0.5, 1.0)]
    found = _core.blur_motion(ranged("frame", frame), [pose._core for pose in poses])
    np.testing.assert_allclose(found, averaged(frame, poses), atol=2e-6)
    # The eye has moved by 0.72 m, about the width of a pixel at 10 m.
    assert np.abs(found - frame.require("color")).mean() > 0.05


def test_a_blurred_wall_is_the_mean_of_shifted_pictures() -> None:
    rng = np.random.default_rng(2)
    color = rng.uniform(0, 1, (8, 40, 3)).astype(np.float32)
    camera = nf.Camera((0.0, 0.0, 0.0), fov=nf.Orthographic(-20, 20, -4, 4), size=(40, 8))
    frame = nf.Frame(camera, color=color, range=np.full((8, 40), 5.0, np.float32))
    before = nf.Camera((-8.0, 0.0, 0.0), fov=camera.fov, size=camera.size)
    # Poses are at 1/8, 3/8, 5/8 and 7/8 of the way of 8 pixels; half of the time at half of them.
    for shutter, shifts in ((1.0, (1, 3, 5, 7)), (0.5, (1, 3))):
        blurred = nf.orthoview.motion_blur(frame, before, shutter=shutter, poses=len(shifts)).require("color")
        expected = np.mean([np.roll(color, shift, axis=1) for shift in shifts], axis=0)
        np.testing.assert_allclose(blurred[:, 8:], expected[:, 8:], atol=1e-6)
        # At the left only some poses show the wall.
        np.testing.assert_allclose(blurred[:, 1:3], color[:, 0:2], atol=1e-6)
        np.testing.assert_array_equal(blurred[:, 0], color[:, 0])


@pytest.mark.parametrize("name", FOVS)
def test_a_still_camera_blurs_nothing(name: str) -> None:
    frame = picture(FOVS[name])
    blurred = nf.orthoview.motion_blur(frame, frame.camera)
    np.testing.assert_allclose(blurred.require("color"), frame.require("color"), atol=1e-6)
    np.testing.assert_array_equal(blurred.require("range"), frame.require("range"))


def test_poses_are_interpolated() -> None:
    """A quarter of a rotation by 90° about y is one by 22.5°."""
    half = np.sqrt(0.5)
    camera = nf.Camera((0.0, 0.0, 0.0), fov=nf.Fov.symmetric(60), size=(4, 4))
    for sign in (1.0, -1.0):
        other = nf.Camera((4.0, 8.0, 0.0), (0.0, sign * half, 0.0, sign * half), fov=camera.fov, size=(4, 4))
        between = pose_between(camera, other, 0.25)
        assert between.position == (1.0, 2.0, 0.0)
        angle = np.radians(22.5) / 2
        np.testing.assert_allclose(between.orientation, (0.0, np.sin(angle), 0.0, np.cos(angle)), atol=1e-12)
    assert pose_between(camera, camera, 0.3) == camera


def test_invalid_input_of_motion_blur_is_refused() -> None:
    frame = picture(FOVS["perspective"])
    with pytest.raises(ValueError, match=r"frame: .*color"):
        nf.orthoview.motion_blur(nf.Frame(frame.camera, range=frame.range), frame.camera)
