"""Tests of hybrid rigs: geometry against points in space, every headset, published values, invalid input."""

from __future__ import annotations

import dataclasses
import json
import math
import pickle
from typing import Any

import numpy as np
import pytest
from hypothesis import given, strategies as st
from numpy.typing import NDArray

import nearfar as nf
from nearfar.hmd import Eye
from nearfar.stereo import HybridRig
from tests.support import data

Array = NDArray[np.float64]

LEFT = nf.Fov(-1.391937, 1.247409, -1.464287, 1.468819)
RIGHT = nf.Fov(-1.246557, 1.398447, -1.472458, 1.465505)
VIVE = {"left": Eye(LEFT, (-0.032, 0.0, 0.0)), "right": Eye(RIGHT, (0.032, 0.0, 0.0))}
"""The unit of the paper, with its printed tangents."""
SIZE = (1344, 1512)


def vive(mono_plane: float | tuple[float, float] = 8.0, **changed: Any) -> HybridRig:
    arguments: dict[str, Any] = {**VIVE, "mono_plane": mono_plane, "size": SIZE, **changed}
    return HybridRig(**arguments)


def headsets() -> list[nf.Hmd]:
    return [nf.hmd.get(name) for name in nf.hmd.names()]


def rig_turned_outwards(degrees: float) -> HybridRig:
    """Eyes rotated outwards by an angle, at other positions than the origin."""
    half = math.radians(degrees) / 2.0
    fov = nf.Fov(-1.2, 0.9, -1.0, 1.1)
    eyes = {
        "left": Eye(fov, (-0.03, 0.01, -0.05), (0.0, math.sin(half), 0.0, math.cos(half))),
        "right": Eye(nf.Fov(-0.9, 1.2, -1.0, 1.1), (0.033, 0.01, -0.05), (0.0, -math.sin(half), 0.0, math.cos(half))),
    }
    return HybridRig(left=eyes["left"], right=eyes["right"], mono_plane=6.0, size=(200, 160))


def test_the_published_headset_has_the_published_error() -> None:
    """The paper states 4 pixels; its tangents give 3.86, a plane five times as near five times as much."""
    rig = vive()
    assert rig.max_error() == pytest.approx(3.862, abs=1e-3)
    assert rig.max_error(1000.0) == pytest.approx(3.83, abs=5e-3)
    assert rig.max_error(axis="vertical") == pytest.approx(2.18, abs=5e-3)
    assert rig.center_offset == pytest.approx(0.032 / 1.391937, rel=1e-12)
    for plane in (1.6, 3.0, 20.0, 40.0):
        assert vive(plane).max_error() == pytest.approx(3.862 * 8.0 / plane, rel=1e-3)
    assert rig.overlap == pytest.approx(2.0 * rig.center_offset * 8.0)


@pytest.mark.parametrize("hmd", headsets(), ids=lambda hmd: str(hmd.name))
@pytest.mark.parametrize("plane", [0.5, 8.0, 100.0])
def test_every_pixel_of_both_eyes_maps_to_the_third_camera(hmd: nf.Hmd, plane: float) -> None:
    rig = HybridRig.of(hmd, mono_plane=plane)
    edge = np.linspace(0.0, 1.0, 21)
    for eye in ("left", "right"):
        places = np.stack(np.meshgrid(edge * rig.size[0], edge * rig.size[1]), axis=-1).reshape(-1, 2)
        mapped = np.column_stack([places, np.ones(len(places))]) @ np.linalg.inv(rig.homography(eye)).T
        assert (mapped[:, 2] > 0.0).all()
        at = mapped[:, :2] / mapped[:, 2:]
        # Rounding of thousands of pixels.
        assert (at >= -1e-6).all()
        assert (at <= np.array(rig.center_size) + 1e-6).all()


@pytest.mark.parametrize(
    "rig",
    [vive(), rig_turned_outwards(0.0), rig_turned_outwards(5.0), rig_turned_outwards(-8.0)],
    ids=["vive", "0", "5", "-8"],
)
@pytest.mark.parametrize("depth", [7.0, 9.0, 300.0])
def test_cameras_and_homographies_agree_with_shown(rig: HybridRig, depth: float) -> None:
    """Projects a point beyond the plane by the third camera, then maps it to an eye."""
    depth = depth + rig.planes[0] - 6.0
    head = np.array([3.0, 1.7, -2.0])
    turn = np.array([0.1, -0.3, 0.2, 0.9])
    turn /= np.linalg.norm(turn)
    left, right, center = rig.cameras(head, turn)
    assert center.size == rig.center_size
    assert left.size == right.size == rig.size
    rng = np.random.default_rng(4)
    for eye, camera in (("left", left), ("right", right)):
        pixels = rng.uniform(0.0, 1.0, (50, 2)) * rig.size
        fov = camera.fov
        assert isinstance(fov, nf.Fov)
        for pixel in pixels:
            at = tangents(fov, pixel, rig.size)
            # The world point at this depth that the eye sees at these tangents.
            point = at_depth(rig, camera, head, turn, at, depth)
            seen = center.project(point[None])[0, :2]
            mapped = rig.homography(eye) @ [*seen, 1.0]
            shown = tangents(fov, mapped[:2] / mapped[2], rig.size)
            np.testing.assert_allclose(rig.shown(eye, at, depth=depth), shown, atol=1e-9)


def tangents(fov: nf.Fov, pixel: Array, size: tuple[int, int]) -> Array:
    x, y = pixel / size
    return np.array([fov.left + (fov.right - fov.left) * x, fov.up + (fov.down - fov.up) * y])


def at_depth(rig: HybridRig, camera: nf.Camera, head: Array, turn: Array, at: Array, depth: float) -> Array:
    """World point at a depth ahead of the plane of the eyes on the ray of an eye at tangents."""
    forward = rotated(turn, np.array([0.0, 0.0, -1.0]))
    way = rotated(np.array(camera.orientation), np.array([*at, -1.0]))
    middle = head + rotated(turn, 0.5 * np.add(rig.left.position, rig.right.position))
    start = np.array(camera.position)
    return np.asarray(start + way * (depth - (start - middle) @ forward) / (way @ forward))


def rotated(quaternion: Array, vector: Array) -> Array:
    axis, w = quaternion[:3], quaternion[3]
    return np.asarray(vector + 2.0 * np.cross(axis, np.cross(axis, vector) + w * vector))


@given(plane=st.floats(0.3, 200.0), depth=st.floats(0.3, 1e5), x=st.floats(0, 1), y=st.floats(0, 1))
def test_errors_follow_the_closed_form(plane: float, depth: float, x: float, y: float) -> None:
    rig = vive(plane)
    s = rig.center_offset
    grown = max(depth - plane, 0.0) / ((depth + s) * plane)
    for eye, fov, p in (("left", LEFT, -0.032), ("right", RIGHT, 0.032)):
        at = tangents(fov, np.array([x, y]), (1, 1))
        expected = at + (at * s - [p, 0.0]) * grown
        np.testing.assert_allclose(rig.shown(eye, at, depth=depth), expected, atol=1e-12)


def test_the_field_equals_the_error_of_each_pixel() -> None:
    rig = rig_turned_outwards(5.0)
    for depth in (6.5, math.inf):
        field = rig.error_field("left", depth)
        assert field.shape == (160, 200, 2)
        fov = rig.left.fov
        for row, column in ((0, 0), (159, 199), (80, 3)):
            at = tangents(fov, np.array([column + 0.5, row + 0.5]), rig.size)
            moved = np.subtract(rig.shown("left", at, depth=depth), at)
            pitch = np.array([(fov.right - fov.left) / 200, (fov.up - fov.down) / 160])
            np.testing.assert_allclose(field[row, column], moved / pitch, atol=1e-9)
        greatest = max(np.abs(rig.error_field(eye, depth)[..., 0]).max() for eye in ("left", "right"))
        assert greatest <= rig.max_error(depth) <= 1.02 * greatest
    lengths = np.linalg.norm(rig.error_field("right"), axis=-1)
    assert lengths.max() <= rig.max_error(axis="both") <= 1.02 * lengths.max()


def test_arc_minutes_equal_differences_of_angles() -> None:
    rig = vive()
    angles = rig.error_field("left", unit="arcmin")
    for row, column in ((700, 20), (3, 1340), (1511, 600)):
        at = tangents(LEFT, np.array([column + 0.5, row + 0.5]), SIZE)
        shown = np.array(rig.shown("left", at))
        expected = np.degrees(np.arctan(shown) - np.arctan(at)) * 60.0
        np.testing.assert_allclose(angles[row, column], expected, rtol=1e-9)


def test_kinks_equal_those_of_projected_lines() -> None:
    """Measures the angle between the images of two short pieces of a line, in front of and behind the plane."""
    rng = np.random.default_rng(2)
    for rig in (vive(), rig_turned_outwards(0.0), rig_turned_outwards(7.0)):
        m, places, ways = rig.planes[0], rng.uniform(-0.8, 0.8, (40, 2)), rng.uniform(-2.0, 2.0, (40, 2))
        angles = rig.kink_angle("right", places, ways)
        identity = np.array([0.0, 0.0, 0.0, 1.0])
        camera = rig.cameras((0, 0, 0))[1]
        step = 1e-5
        for at, way, angle in zip(places, ways, angles, strict=True):
            point = at_depth(rig, camera, np.zeros(3), identity, at, m)
            moved = [point + sign * step * np.array([*way, -1.0]) for sign in (-1.0, 1.0)]
            before, behind = (tangents_of(camera, p) for p in moved)
            shown = np.array(rig.shown("right", behind, depth=m + step))
            one, other = at - before, shown - at
            cosine = one @ other / np.linalg.norm(one) / np.linalg.norm(other)
            assert math.degrees(math.acos(np.clip(cosine, -1, 1))) == pytest.approx(angle, abs=0.05)


def tangents_of(camera: nf.Camera, point: Array) -> Array:
    fov = camera.fov
    assert isinstance(fov, nf.Fov)
    return tangents(fov, camera.project(point[None])[0, :2], camera.size)


def test_the_kink_of_a_line_through_the_eye_is_undefined() -> None:
    rig = vive()
    at = np.array([[0.3, 0.1]])
    assert np.isnan(rig.kink_angle("left", at, at)).all()


def test_the_third_camera_has_the_eyes_resolution() -> None:
    rig = vive()
    fov, away = rig.center_fov, 8.0 + rig.center_offset
    across = (fov.right - fov.left) * away / rig.center_size[0]
    coarsest = 8.0 * max((f.right - f.left) / SIZE[0] for f in (LEFT, RIGHT))
    assert 0.998 * coarsest < across <= coarsest


def test_a_zone_is_continuous_at_both_ends() -> None:
    # Both pictures meet on the plane in the middle of both in 1/z.
    zone, plane = vive((6.0, 10.0)), vive(7.5)
    at = np.array([0.9, -0.5])
    assert zone.planes == (6.0, 10.0)
    np.testing.assert_allclose(dataclasses.astuple(zone.center_fov), dataclasses.astuple(plane.center_fov))
    np.testing.assert_allclose(zone.shown("left", at, depth=6.0 + 1e-9), at, atol=1e-9)
    np.testing.assert_allclose(zone.shown("left", at, depth=10.0), plane.shown("left", at, depth=10.0))
    np.testing.assert_allclose(zone.quad_layer.position, plane.quad_layer.position)
    between = np.array([zone.shown("left", at, depth=depth) for depth in np.linspace(6.0, 10.0, 50)])
    assert (np.diff(between[:, 0]) > 0.0).all()
    with pytest.raises(ValueError, match="mono_plane: expected one plane for a kink"):
        zone.kink_angle("left", at[None], at[None])


def test_every_headset_of_the_data_makes_a_rig_without_missing_pixels() -> None:
    document = json.loads(data("optics/hmd_frusta.json").read_text(encoding="utf-8"))
    count = 0
    for device in document["devices"]:
        if device["recommended_render_target"] is None:
            continue
        eyes = {}
        for side in ("left", "right"):
            left, right, low, high = device[side]["raw_tangents_lrbt"]
            eyes[side] = Eye.from_matrix(
                nf.Fov(left, right, min(low, high), max(low, high)), device[side]["eye_to_head"]
            )
        size = tuple(device["recommended_render_target"])
        rig = HybridRig(left=eyes["left"], right=eyes["right"], mono_plane=8.0, size=size)
        for eye in eyes:
            corners = np.array([[x, y, 1.0] for x in (0, size[0]) for y in (0, size[1])])
            mapped = corners @ np.linalg.inv(rig.homography(eye)).T
            at = mapped[:, :2] / mapped[:, 2:]
            assert (mapped[:, 2] > 0.0).all(), device["config"]
            assert (at >= -1e-6).all(), device["config"]
            assert (at <= np.array(rig.center_size) + 1e-6).all(), device["config"]
        assert 0.0 < rig.max_error() < 30.0
        count += 1
    assert count > 3


@pytest.mark.parametrize(
    ("changed", "words"),
    [
        ({"left": VIVE["right"], "right": VIVE["left"]}, "right: expected an eye to the right of the left one"),
        ({"right": VIVE["left"]}, "right: expected an eye to the right of the left one"),
        ({"mono_plane": (9.0, 8.0)}, "mono_plane: expected a zone that ends at 9 metres or farther"),
        ({"size": (0, 5)}, r"size\[0\]: expected"),
        ({"left": Eye(LEFT, (-0.032, 0, -9.0)), "right": Eye(RIGHT, (0.032, 0, 9.0))}, "in front of the left eye"),
        ({"left": Eye(LEFT, (-0.032, 0, 0), (0, 0.5, 0, 0.75**0.5))}, "left: expected a view whose corners lie less"),
        ({"left": Eye(nf.Fov(0.5, 0.6, -0.1, 0.1), (-0.032, 0, 0))}, "left: expected an eye whose outer edge"),
    ],
)
def test_impossible_rigs_are_refused(changed: dict[str, Any], words: str) -> None:
    with pytest.raises(ValueError, match=words):
        vive(**changed)


def test_directions_have_one_row_per_position() -> None:
    with pytest.raises(ValueError, match="direction: expected one for each of 1"):
        vive().kink_angle("left", [[0.0, 0.0]], [[1.0, 0.0]] * 2)


def test_rigs_can_be_pickled() -> None:
    rig = vive((6.0, 8.0))
    again = pickle.loads(pickle.dumps(rig))
    assert again == rig
    assert again.center_fov == rig.center_fov
