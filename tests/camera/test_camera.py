"""Tests of cameras: every projection against independent formulas, and invalid arguments."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, strategies as st

import nearfar as nf
from nearfar._camera.camera import Projection
from tests.support.render_oracle import CUBE_TABLE, rotate

ASYMMETRIC = nf.Fov(-1.1, 0.7, -0.4, 0.9)
WINDOW = nf.Orthographic(-3.0, 5.0, -2.0, 1.0)
PROJECTIONS: list[Projection] = [ASYMMETRIC, WINDOW, *(nf.CubeFace(face) for face in range(6))]
TURNED = (0.18257418583505536, 0.3651483716701107, -0.5477225575051661, 0.7302967433402214)


def grid(width: int, height: int) -> tuple[np.ndarray, np.ndarray]:
    """Return positions of all pixel centres as fractions of width and height, from the left and from the top."""
    return np.meshgrid((np.arange(width) + 0.5) / width, (np.arange(height) + 0.5) / height)


def test_perspective_rays_follow_the_tangents() -> None:
    camera = nf.Camera((1e6, 2, 3), TURNED, fov=ASYMMETRIC, size=(7, 5))
    s, t = grid(7, 5)
    local = np.stack([-1.1 + 1.8 * s, 0.9 - 1.3 * t, -np.ones_like(s)], -1)
    expected = rotate(TURNED, local / np.linalg.norm(local, axis=-1, keepdims=True))
    origins, directions = camera.rays()
    assert directions.shape == (5, 7, 3)
    # A few roundings of float64 at 1.
    np.testing.assert_allclose(directions, expected, atol=4e-15)
    assert (origins == (1e6, 2, 3)).all()


def test_orthographic_rays_start_on_the_image_plane() -> None:
    camera = nf.Camera((1, 2, 3), TURNED, fov=WINDOW, size=(8, 6))
    s, t = grid(8, 6)
    local = np.stack([-3 + 8 * s, 1 - 3 * t, np.zeros_like(s)], -1)
    origins, directions = camera.rays()
    # A turn in float64 is a dozen roundings of numbers up to 10: 2e-15 each.
    np.testing.assert_allclose(origins, np.array([1, 2, 3]) + rotate(TURNED, local), atol=1e-14)
    np.testing.assert_allclose(
        directions, np.broadcast_to(rotate(TURNED, np.array([0.0, 0, -1])), (6, 8, 3)), atol=1e-15
    )


@pytest.mark.parametrize("face", range(6))
def test_cube_faces_follow_the_table_of_the_graphics_interfaces(face: int) -> None:
    camera = nf.Camera((0, 0, 0), TURNED, fov=nf.CubeFace(face), size=(9, 9))
    directions = camera.rays()[1]
    (s_axis, s_sign), (t_axis, t_sign), (m_axis, m_sign) = CUBE_TABLE[face]
    major = directions[..., m_axis] * m_sign
    assert (major > 0).all()
    s, t = grid(9, 9)
    # One division and a normalisation in float64.
    np.testing.assert_allclose((directions[..., s_axis] * s_sign / major + 1) / 2, s, atol=1e-15)
    np.testing.assert_allclose((directions[..., t_axis] * t_sign / major + 1) / 2, t, atol=1e-15)


def test_six_faces_see_every_direction_once() -> None:
    rng = np.linspace(0, 1, 4001)[1:-1]
    y, turn = 1 - 2 * rng, np.arange(len(rng)) * 2.399963229728653
    radius = np.sqrt(1 - y * y)
    points = np.column_stack([radius * np.cos(turn), y, radius * np.sin(turn)]) + np.array([5, 6, 7])
    seen = np.zeros(len(points), int)
    for face in range(6):
        pixels = nf.Camera((5, 6, 7), fov=nf.CubeFace(face), size=(64, 64)).project(points)
        with np.errstate(invalid="ignore"):
            seen += ((pixels[:, :2] >= 0) & (pixels[:, :2] < 64)).all(axis=1)
    assert (seen == 1).all()


@given(
    st.sampled_from(PROJECTIONS),
    st.tuples(*[st.floats(-1e4, 1e4)] * 3),
    st.floats(1e-3, 1e4),
)
def test_projection_inverts_rays(projection: Projection, position: tuple[float, float, float], distance: float) -> None:
    camera = nf.Camera(position, TURNED, fov=projection, size=(6, 6))
    origins, directions = camera.rays()
    back = camera.project((origins + distance * directions).reshape(-1, 3)).reshape(6, 6, 3)
    s, t = grid(6, 6)
    # World coordinates of 10⁴ are rounded by 10⁻¹², and pixels are at most 12 to the tangent or the metre.
    tolerance = 1e-9 + 5e-11 / distance
    np.testing.assert_allclose(back[..., 0], 6 * s, atol=tolerance)
    np.testing.assert_allclose(back[..., 1], 6 * t, atol=tolerance)
    behind = camera.project((origins - distance * directions).reshape(-1, 3))
    assert np.isnan(behind).all()


def test_the_camera_position_has_no_image() -> None:
    camera = nf.Camera((1, 2, 3), fov=ASYMMETRIC, size=(4, 4))
    assert np.isnan(camera.project([[1, 2, 3]])).all()
    assert camera.project(np.empty((0, 3))).shape == (0, 3)


@given(
    st.tuples(*[st.floats(-100, 100)] * 3),
    st.tuples(*[st.floats(-100, 100)] * 3),
)
def test_look_at_centres_the_target_and_keeps_up_upright(eye: tuple[float, ...], target: tuple[float, ...]) -> None:
    away = np.subtract(target, eye)
    if np.linalg.norm(away) < 1e-3 or np.hypot(away[0], away[2]) < 1e-3 * np.linalg.norm(away):
        return
    camera = nf.Camera.look_at(eye, target, fov=nf.Fov.symmetric(90), size=(10, 10))
    x, y, depth = camera.project([target])[0]
    # Positions of 100 are rounded by 10⁻¹⁴, at 10⁻³ metres that is 10⁻¹¹ radians.
    assert (x, y) == pytest.approx((5, 5), abs=1e-9)
    assert depth == pytest.approx(np.linalg.norm(away), rel=1e-9)
    above = camera.project(np.array([target]) + np.linalg.norm(away) * np.array([0, 1e-2, 0]))[0]
    assert above[0] == pytest.approx(5, abs=1e-6)
    assert above[1] < 5


@pytest.mark.parametrize(
    "target", [(0, 0, -1), (0, 0, 1), (1, 0, 0), (-1, 0, 0), (1, -1, 0.5), (-3, 2, 9), (0, 0.99, -0.01)]
)
def test_look_at_gives_a_rotation(target: tuple[float, float, float]) -> None:
    camera = nf.Camera.look_at((0, 0, 0), target, fov=ASYMMETRIC, size=(4, 4))
    forward = np.array(target) / np.linalg.norm(target)
    # Four roundings of numbers below 1, 1.1e-16 each, and the same again for the turn.
    np.testing.assert_allclose(rotate(camera.orientation, np.array([0.0, 0, -1])), forward, atol=1e-15)
    right = rotate(camera.orientation, np.array([1.0, 0, 0]))
    assert abs(right[1]) < 1e-15
    assert nf.Camera((0, 0, 0), fov=ASYMMETRIC, size=(4, 4)).orientation == (0, 0, 0, 1)


def test_fields_of_view() -> None:
    wide = nf.Fov.symmetric(90, 2.0)
    # tan(45°) in float64 is one rounding below 1.
    np.testing.assert_allclose([wide.left, wide.right, wide.down, wide.up], [-1, 1, -0.5, 0.5], atol=2e-16)
    angles = nf.Fov.from_angles(-0.9, 0.8, 0.7, -0.6)
    expected = [math.tan(-0.9), math.tan(0.8), math.tan(-0.6), math.tan(0.7)]
    assert [angles.left, angles.right, angles.down, angles.up] == expected


def test_cameras_are_values() -> None:
    one, two = (nf.Camera((1, 2, 3), fov=ASYMMETRIC, size=(4, 4)) for _ in range(2))
    assert one == two
    assert hash(one) == hash(two)
    assert one.rays()[0].shape == (4, 4, 3)
    assert (one.width, one.height) == (4, 4)
    with pytest.raises(AttributeError):
        one.position = (0.0, 0.0, 0.0)  # type: ignore[misc]


def test_cube_faces_are_square() -> None:
    with pytest.raises(ValueError, match="square"):
        nf.Camera((0, 0, 0), fov=nf.CubeFace(0), size=(4, 5))


def test_invalid_directions_and_fields_of_view_are_refused() -> None:
    with pytest.raises(ValueError, match="target: expected another point"):
        nf.Camera.look_at((1, 2, 3), (1, 2, 3), fov=ASYMMETRIC, size=(4, 4))
    with pytest.raises(ValueError, match="up: expected a direction away"):
        nf.Camera.look_at((1, 2, 3), (1, 9, 3), fov=ASYMMETRIC, size=(4, 4))
    with pytest.raises(ValueError, match=r"up: .*got \(0, 0, 0\)"):
        nf.Camera.look_at((1, 2, 3), (1, 9, 3), fov=ASYMMETRIC, size=(4, 4), up=(0, 0, 0))
