"""Tests of zones: every pixel against its point's displayed position, nothing missing, continuous at both ends."""

from __future__ import annotations

import math

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from nearfar.stereo import HybridRig
from tests.support.gpu_cases import adapter
from tests.support.hybrid_cases import AHEAD, HEAD, rig, scene, textured
from tests.support.reduce_cases import ALL

ZONE = (3.0, 12.0)
SIDES = ("left", "right")


def zoned(size: tuple[int, int] = (96, 80), cant: float = 0.0) -> HybridRig:
    return rig(size=size, cant=cant).with_plane(ZONE)


def depths_of(hybrid: HybridRig, points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Metres ahead of the plane of the eyes."""
    center = hybrid.cameras(HEAD, AHEAD)[2]
    _, ways = nf.Camera(HEAD, AHEAD, fov=nf.Fov.symmetric(1e-6), size=(1, 1)).rays()
    return np.asarray((points - center.position) @ ways[0, 0] - hybrid.center_offset)


def pixel_of(camera: nf.Camera, tangents: tuple[float, float]) -> tuple[float, float]:
    fov, (width, height) = camera.fov, camera.size
    assert isinstance(fov, nf.Fov)
    x = (tangents[0] - fov.left) / (fov.right - fov.left) * width
    return x, (fov.up - tangents[1]) / (fov.up - fov.down) * height


def tangents_of(camera: nf.Camera, point: NDArray[np.float64]) -> tuple[float, float]:
    fov, (width, height) = camera.fov, camera.size
    assert isinstance(fov, nf.Fov)
    x, y = camera.project(point[None])[0, :2]
    return fov.left + (fov.right - fov.left) * x / width, fov.up - (fov.up - fov.down) * y / height


@pytest.mark.parametrize("cant", [0.0, 6.0])
def test_pixels_of_a_zone_show_points_displayed_there(cant: float) -> None:
    hybrid = zoned((768, 640), cant)
    frame = hybrid.render(textured(), HEAD, AHEAD, channels=("position", "range"), far=ZONE[1])
    assert hybrid.max_error(ZONE[1], "both") > 2.0
    for side, camera in zip(SIDES, hybrid.cameras(HEAD, AHEAD), strict=False):
        picture: nf.Frame = getattr(frame, side)
        points = picture.require("position").astype(np.float64) + picture.origin
        depth = depths_of(hybrid, points)
        inside = np.argwhere((depth > ZONE[0]) & (depth < ZONE[1] - hybrid.overlap))
        assert len(inside) > 300
        for row, column in inside[:: len(inside) // 150]:
            point = points[row, column]
            shown = hybrid.shown(side, tangents_of(camera, point), depth=float(depth[row, column]))
            x, y = pixel_of(camera, shown)
            # Iterations leave 0.02 pixels, float32 slightly more.
            assert math.hypot(x - column - 0.5, y - row - 0.5) < 0.03
            away = float(np.linalg.norm(point - camera.position))
            assert picture.require("range")[row, column] == pytest.approx(away, rel=1e-5)


def test_a_zone_has_no_missing_pixel_and_begins_as_separate_stereo() -> None:
    world, hybrid = scene(), zoned((192, 160))
    channels = ("face_id", "position")
    frame = hybrid.render(world, HEAD, AHEAD, channels=channels)
    for side, camera in zip(SIDES, hybrid.cameras(HEAD, AHEAD), strict=False):
        plain = nf.render(world, camera, channels=channels, clip=hybrid.clip(HEAD, AHEAD, near=0.1))
        own, faces = getattr(frame, side).require("face_id"), plain.require("face_id")
        # The room has surfaces everywhere except for the sky above, whose edge moves by some pixels.
        reach = math.ceil(hybrid.max_error(axis="both")) + 1
        solid = np.ones_like(faces, bool)
        for down in range(-reach, reach + 1):
            for right in range(-reach, reach + 1):
                solid &= np.roll(faces, (down, right), (0, 1)) >= 0
        assert solid.mean() > 0.3
        assert (own[solid] >= 0).all()
        depth = depths_of(hybrid, plain.require("position").astype(np.float64) + plain.origin)
        near = depth < ZONE[0]
        assert near.sum() > 30
        np.testing.assert_array_equal(own[near], faces[near])


def test_culling_changes_no_pixel_of_the_eyes() -> None:
    frames = [
        zoned().render(scene(), HEAD, AHEAD, cull=cull, samples=2, channels=ALL) for cull in ("frustum", "discard")
    ]
    for side in SIDES:
        for name in ALL:
            np.testing.assert_array_equal(*(getattr(frame, side).require(name) for frame in frames))
    assert frames[1].stats["pixels"]["discarded"] > 0


def test_a_line_bends_less_per_pixel_than_at_a_plane() -> None:
    """A line to the right of the left eye, in even steps of the picture: its slope changes abruptly, or gradually."""
    middle = 2.0 / (1.0 / ZONE[0] + 1.0 / ZONE[1])
    zone, plane = zoned((1344, 1120)), rig(middle, size=(1344, 1120))
    camera = zone.cameras(HEAD, AHEAD)[0]
    depths = 1.0 / np.linspace(1.0 / 1.5, 1.0 / 30.0, 100)
    turns = []
    for one in (zone, plane):
        tangents = [(0.6 / depth - 0.05, -0.9 / depth + 0.04) for depth in depths]
        path = np.array(
            [pixel_of(camera, one.shown("left", at, depth=d)) for at, d in zip(tangents, depths, strict=True)]
        )
        steps = np.diff(path, axis=0)
        angles = np.unwrap(np.arctan2(steps[:, 1], steps[:, 0]))
        turns.append(np.abs(np.diff(angles)))
    assert turns[0].max() < 0.05 * turns[1].max()
    # In total it bends no more.
    assert turns[0].sum() < 1.01 * turns[1].sum()


def test_zones_are_drawn_for_scenes_on_the_cpu() -> None:
    reduced = nf.reduce(scene(), center=HEAD, r1=20.0, r2=50.0, face_size=16, samples=1)
    with pytest.raises(ValueError, match="mono_plane: expected one plane for ReducedScene"):
        zoned().render(reduced, HEAD)
    with adapter("vulkan"), pytest.raises(ValueError, match="mono_plane: expected one plane on a graphics adapter"):
        zoned().render(scene(), HEAD, backend="gpu")
