"""Tests that pictures are warped about the lens's axis, which is off-centre in an asymmetric eye's picture."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import nearfar as nf

RIFT_S = nf.RadialLens((0.22, 0.24))
COLOURED = nf.ChromaticLens(RIFT_S, nf.RadialLens((0.21, 0.24)), nf.RadialLens((0.2, 0.23)))
EYE = nf.hmd.QUEST_2.left
SIZE = (120, 100)


@pytest.fixture(scope="module")
def frame() -> nf.Frame:
    """Return the left eye's picture of a room in a headset."""
    return nf.render(nf.datasets.room(), nf.hmd.QUEST_2.camera("left", (0, 1.6, 0), size=SIZE), channels=["color"])


def test_an_asymmetric_eyes_picture_is_warped_about_its_optical_axis(frame: nf.Frame) -> None:
    """The axis is at tangents of 0, 56 % of the width and 48 % of the height; there nothing moves."""
    fov = EYE.fov
    across, down = -fov.left / (fov.right - fov.left), fov.up / (fov.up - fov.down)
    assert across > 0.56
    x, y = np.meshgrid((np.arange(SIZE[0]) + 0.5) / SIZE[0], (np.arange(SIZE[1]) + 0.5) / SIZE[1])
    distance = np.hypot(x - across, y - down).astype(np.float32)
    cone = nf.Frame(frame.camera, color=np.repeat(distance[..., None], 3, axis=2))
    warped = RIFT_S.warp(cone, True, fill=np.inf)[..., 0]
    # The minimum of the cone stays within the pixel of the axis.
    row, column = np.unravel_index(warped.argmin(), warped.shape)
    assert (int(column), int(row)) == (int(across * SIZE[0]), int(down * SIZE[1]))
    # The lens shows all others farther out, symmetrically about the axis.
    assert (warped >= distance - 1e-4).all()
    assert (warped - distance)[row, column + 30] == pytest.approx((warped - distance)[row, column - 30], rel=0.1)


@pytest.mark.parametrize("lens", [RIFT_S, COLOURED])
def test_a_frame_supplies_its_field_of_view(frame: nf.Frame, lens: Any) -> None:
    assert frame.color is not None
    by_frame = lens.warp(frame, True, lens_radius=nf.hmd.QUEST_2.tan_half_angle)
    by_hand = lens.warp(frame.color, True, fov=EYE.fov, lens_radius=nf.hmd.QUEST_2.tan_half_angle)
    assert by_frame.dtype == np.float32
    assert by_frame.tobytes() == by_hand.tobytes()
    for source in (frame, frame.camera):
        mesh = lens.warp_mesh(source, cells=(6, 6))
        assert mesh.texcoords.tobytes() == lens.warp_mesh(SIZE, fov=EYE.fov, cells=(6, 6)).texcoords.tobytes()


def test_symmetric_pictures_must_be_requested() -> None:
    image = np.random.default_rng(0).random((30, 40))
    ours = RIFT_S.warp(image, fov="symmetric")
    np.testing.assert_allclose(ours, RIFT_S.warp(image, fov=nf.Fov.symmetric(90.0, 40 / 30)), atol=1e-9)


def test_frames_that_cannot_be_warped_are_refused(frame: nf.Frame) -> None:
    with pytest.raises(ValueError, match="fov: expected None, because size has the field"):
        RIFT_S.warp_mesh(frame, fov="symmetric")
    flat = nf.Camera((0, 0, 0), fov=nf.Orthographic(-1, 1, -1, 1), size=(4, 4))
    with pytest.raises(ValueError, match="image: expected a camera with a Fov"):
        RIFT_S.warp(nf.Frame(flat, color=np.zeros((4, 4, 3), np.float32)))
    with pytest.raises(ValueError, match="size: expected a camera with a Fov, got one with CubeFace"):
        RIFT_S.warp_mesh(nf.Camera((0, 0, 0), fov=nf.CubeFace(0), size=(4, 4)))
    with pytest.raises(ValueError, match="frame has no color: render it with channels="):
        RIFT_S.warp(nf.Frame(frame.camera, range=np.zeros(SIZE[::-1], np.float32)))
