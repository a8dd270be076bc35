"""Tests of steady pictures: against loops, changed cuts, disocclusion, moving objects, jumps, invalid input."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from itertools import pairwise, product
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar import _core
from nearfar._render.ranged import ranged
from tests.support import printed_by_threads
from tests.support.flight_cases import camera_at
from tests.support.steady_oracle import blended

Steady = nf.orthoview.Steady
Tree = nf.orthoview.OrthoTree
RATE = 72
"""Pictures per second."""

EYES = {
    "perspective": (nf.Fov(-0.7, 0.5, -0.4, 0.6), nf.Fov(-0.7, 0.5, -0.4, 0.6)),
    "zoom": (nf.Fov.symmetric(70), nf.Fov.symmetric(50)),
    "cube": (nf.CubeFace(5), nf.Fov.symmetric(90)),
    "parallel": (nf.Orthographic(-3, 4, -3, 3), nf.Orthographic(-3, 4, -3, 3)),
    "from parallel": (nf.Orthographic(-3, 4, -3, 3), nf.Fov.symmetric(60)),
    "to parallel": (nf.Fov.symmetric(60), nf.Orthographic(-3, 4, -3, 3)),
}
"""Projections of a picture and of the next one."""


def camera_of(fov: Any, position: tuple[float, float, float], turn: float = 0.0, size: int = 9) -> nf.Camera:
    half = np.array([0.3 * turn, turn, 0.2 * turn, 2.0])
    x, y, z, w = (half / np.linalg.norm(half)).tolist()
    return nf.Camera(position, (x, y, z, w), fov=fov, size=(size, size))


def noise(camera: nf.Camera, seed: int, **images: Any) -> nf.Frame:
    """A picture of noise: two surfaces, one of them slanted, and sky."""
    rng, (width, height) = np.random.default_rng(seed), camera.size
    color = rng.uniform(0, 1, (height, width, 3)).astype(np.float32)
    distance = 8 + 0.02 * np.arange(width) + 0.01 * rng.uniform(size=(height, width))
    distance[:, width // 3 : width // 2] = 4.0
    distance[: height // 4] = np.inf
    return nf.Frame(camera, color=color, range=distance.astype(np.float32), **images)


@pytest.mark.parametrize(
    ("name", "step"), [*((name, 0.002) for name in EYES), *product(["cube", "parallel"], [0.0, 0.2])]
)
def test_the_kernel_equals_loops(name: str, step: float) -> None:
    before, after = EYES[name]
    past = noise(camera_of(before, (100.0, 2.0, -50.0)), 1)
    now = noise(camera_of(after, (100.0 + step, 2.0 - 0.5 * step, -50.0 - step), step / 8), 2)
    for fade in ((0.05, 0.3), (0.5, 0.02))[: 2 if step == 0.002 else 1]:
        mixed, agrees = _core.blend_past(ranged("past", past), ranged("now", now), fade=fade)
        expected, expected_agrees = blended(past, now, fade)
        np.testing.assert_array_equal(agrees, expected_agrees)
        np.testing.assert_allclose(mixed, expected, atol=2e-6)
        if before == after:
            assert agrees.mean() > 0.5


def test_the_kernel_with_motion_equals_loops() -> None:
    rng = np.random.default_rng(4)
    motion = rng.normal(0, 2, (20, 20, 2)).astype(np.float32)
    motion[5:9] = rng.normal(0, 0.05, (4, 20, 2))
    motion[3, 4] = np.nan
    past = noise(camera_of(nf.Fov.symmetric(60), (0.0, 0.0, 0.0), size=20), 1)
    now = noise(camera_of(nf.Fov.symmetric(60), (0.02, 0.0, -0.1), size=20), 2, motion=motion)
    fade = (0.1, 0.4)
    mixed, agrees = _core.blend_past(ranged("past", past), ranged("now", now), fade=fade, motion=motion)
    expected, expected_agrees = blended(past, now, fade)
    np.testing.assert_array_equal(agrees, expected_agrees)
    assert 0.2 < agrees.mean() < 0.95
    np.testing.assert_allclose(mixed, expected, atol=2e-6)


def eye(tree: Tree, angle: float) -> nf.Camera:
    """A view of the whole tree from above."""
    return camera_at(tree, 187.0, angle, size=(120, 120))


def directions_of(tree: Tree, camera: nf.Camera) -> set[Any]:
    return set(tree.cut(camera, geometry=False).keys())


def fades(before: nf.Frame, after: Callable[[int], nf.Frame]) -> list[float]:
    """SSIM of consecutive pictures during a fade."""
    steady = Steady()
    pictures = [steady.next(before, 0.0)]
    pictures += [steady.next(after(n), n / RATE) for n in range(1, 25)]
    return [float(nf.ssim(one, other)) for one, other in pairwise(pictures)]


def test_a_changed_cut_fades_for_a_still_camera(layered: Tree, record_property: Callable[[str, object], None]) -> None:
    camera = eye(layered, 0.3)
    fine, coarse = (layered.render(camera, geometry=False, error_px=error) for error in (1.0, 2.0))
    popped = float(nf.ssim(fine, coarse))
    record_property("SSIM of the swapped cut", popped)
    assert popped < 0.995
    assert min(fades(fine, lambda _: coarse)) >= 0.999


def test_changed_directions_fade(layered: Tree, record_property: Callable[[str, object], None]) -> None:
    """A camera that crosses the bisector of two directions sees cells from another one, a tiny step later."""
    low, high = 0.3, 0.3 + np.pi / 4
    start = directions_of(layered, eye(layered, low))
    assert directions_of(layered, eye(layered, high)) != start
    while high - low > 1e-7:
        middle = (low + high) / 2
        low, high = (middle, high) if directions_of(layered, eye(layered, middle)) == start else (low, middle)
    one, other = (layered.render(eye(layered, angle), geometry=False) for angle in (low, high))
    popped = float(nf.ssim(one, other))
    record_property("SSIM of other directions", popped)
    assert popped < 0.999
    turned = [layered.render(eye(layered, high + n * 1e-7), geometry=False) for n in range(25)]
    assert min(fades(one, lambda n: turned[n])) >= 0.999


def board(position: float, eye: float = 0.0, color: float = 1.0, **images: Any) -> nf.Frame:
    """A board 2 m away in front of a wall 8 m away, its left edge at a column when seen from the middle."""
    camera = nf.Camera((eye, 0.0, 0.0), fov=nf.Fov.symmetric(90), size=(64, 64))
    column = np.arange(64) + 0.5
    # A tangent is (column − 32)/32.
    is_board = np.broadcast_to((column >= position - 32 * eye / 2) & (column < position + 16 - 32 * eye / 2), (64, 64))
    depth = np.where(is_board, 2.0, 8.0)
    secant = np.linalg.norm(camera.rays()[1] / camera.rays()[1][..., 2:], axis=-1)
    shade = np.where(is_board, color, 0.25)[..., None].repeat(3, axis=-1)
    return nf.Frame(camera, color=shade.astype(np.float32), range=(depth * secant).astype(np.float32), **images)


def test_disoccluded_pixels_are_new() -> None:
    steady, before = Steady(), board(20.0, color=0.9)
    steady.next(before, 0.0)
    # The board moves 4 pixels to the left, the wall 1.
    after = board(20.0, eye=0.25)
    frame = steady.next(after, 1 / RATE)
    color, fresh = frame.require("color")[32, :, 0], after.require("color")[32, :, 0]
    # The board fades from its old colour; neighbouring pixels mix it with the wall's.
    np.testing.assert_allclose(color[17:31], 1 - 0.1 * np.exp(-1 / RATE / 0.05), atol=1e-6)
    # The wall is disoccluded by 3 pixels to its right, and the border's right.
    np.testing.assert_array_equal(color[33:35], fresh[33:35])
    np.testing.assert_allclose(color, fresh, atol=0.1)
    assert 0.9 < frame.stats["agreed"] < 1 - 64 * 3 / 64**2


def test_still_pictures_do_not_change() -> None:
    steady, picture = Steady(), noise(camera_of(nf.Fov.symmetric(60), (3.0, 1.0, 2.0), 0.4), 1)
    for n in range(5):
        frame = steady.next(picture, n / 30)
        np.testing.assert_allclose(frame.require("color"), picture.require("color"), atol=1e-6)
        assert frame.stats["agreed"] == float(n > 0)


def test_a_removed_surface_fades_for_a_still_camera() -> None:
    steady = Steady(seconds=0.2)
    steady.next(board(20.0), 0.0)
    for n in (1, 2):
        frame = steady.next(board(40.0), 0.1 * n)
        expected = 0.25 + 0.75 * np.exp(-0.5 * n)
        np.testing.assert_allclose(frame.require("color")[:, 20:36], expected, atol=1e-6)


def test_moving_objects_leave_no_trail() -> None:
    """The board moves 4 pixels to the right, and the camera is still."""
    motion = np.zeros((64, 64, 2), np.float32)
    motion[:, 24:40, 0] = 4.0
    steady = Steady()
    steady.next(board(20.0), 0.0)
    after = board(24.0, motion=motion)
    frame = steady.next(after, 1 / RATE)
    np.testing.assert_array_equal(frame.require("color"), after.require("color"))


def test_jumps_pass_unblended() -> None:
    rng, steady = np.random.default_rng(1), Steady()
    camera = nf.Camera((0.0, 0.0, 0.0), fov=nf.Fov.symmetric(60), size=(32, 32))
    steady.next(noise(camera, 1), 0.0)
    elsewhere = noise(replace(camera, position=(500.0, 20.0, 3.0), orientation=(0.0, 1.0, 0.0, 0.0)), 2)
    frame = steady.next(elsewhere, 0.01)
    np.testing.assert_array_equal(frame.require("color"), elsewhere.require("color"))
    assert frame.stats["agreed"] < 0.25
    # Afterwards pictures fade again.
    color = rng.uniform(0, 1, (32, 32, 3)).astype(np.float32)
    again = steady.next(replace(elsewhere, color=color), 0.02)
    assert again.stats["agreed"] == 1.0
    expected = color + np.exp(-0.02) * (elsewhere.require("color") - color)
    np.testing.assert_allclose(again.require("color"), expected, atol=1e-6)


def test_pictures_after_a_reset_or_of_another_size_pass_or_fade() -> None:
    steady, picture = Steady(), board(20.0)
    assert steady.next(picture, 5.0).stats["agreed"] == 0.0
    steady.restart()
    assert steady.next(picture, 1.0).stats["agreed"] == 0.0
    small = nf.Camera((0.0, 0.0, 0.0), fov=nf.Fov.symmetric(90), size=(16, 16))
    images: dict[str, Any] = {name: picture.require(name)[2::4, 2::4] for name in ("color", "range")}
    assert steady.next(nf.Frame(small, **images), 1.1).stats["agreed"] > 0.9


def test_later_writes_to_a_picture_are_ignored() -> None:
    steady, picture = Steady(), board(20.0)
    steady.next(picture, 0.0)
    picture.require("color")[:] = 0.0
    picture.require("range")[:] = np.inf
    frame = steady.next(board(20.0), 0.1)
    np.testing.assert_allclose(frame.require("color"), board(20.0).require("color"), atol=1e-6)


def test_bytes_do_not_depend_on_threads() -> None:
    code = """
import hashlib
import nearfar as nf
scene = nf.datasets.room()
cameras = [nf.Camera((0.01 * n, 1.6, 0.0), fov=nf.Fov.symmetric(90, 1.5), size=(90, 60)) for n in range(3)]
steady = nf.orthoview.Steady()
for n, camera in enumerate(cameras):
    frame = steady.next(nf.render(scene, camera, backend="cpu"), n / 30)
blurred = nf.orthoview.motion_blur(frame, cameras[0])
print(frame.stats["agreed"], [hashlib.sha256(one.color.tobytes()).hexdigest() for one in (frame, blurred)])
"""
    printed = printed_by_threads(code)
    assert len(printed) == 1
    assert float(printed.pop().split()[0]) > 0.9


def test_invalid_input_of_steady_is_refused() -> None:
    picture = board(20.0)
    steady = Steady()
    with pytest.raises(ValueError, match=r"frame: .*range"):
        steady.next(replace(picture, range=None), 0.0)
    steady.next(picture, 1.0)
    with pytest.raises(ValueError, match="time: expected more than 1, that of the picture before"):
        steady.next(picture, 1.0)
    # Refused values are not kept.
    assert steady.next(picture, 1.1).stats["agreed"] == 1.0
