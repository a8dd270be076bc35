"""Tests of temporal anti-aliasing: the kernel against loops, still and moving pictures, motion of hybrid pictures."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from nearfar import _core
from nearfar.stereo import HybridRig, TemporalAntialiasing
from tests.support.hybrid_cases import AHEAD, HEAD, cut, places, rig, scene, towards
from tests.support.reduce_cases import place
from tests.support.steady_oracle import cubic

Image = NDArray[np.float64]
SIDES = ("left", "right")


def luma_chroma(color: Image) -> Image:
    r, g, b = np.moveaxis(color, -1, 0)
    return np.stack([r / 4 + g / 2 + b / 4, (r - b) / 2, g / 2 - (r + b) / 4], -1)


def rgb(color: Image) -> Image:
    luma, orange, green = np.moveaxis(color, -1, 0)
    return np.stack([luma - green + orange, luma + green, luma - green - orange], -1)


def mixed_slowly(color: Image, motion: Image, away: Image, gathered: Image, share: float) -> Image:
    height, width = color.shape[:2]
    result = color.copy()
    for y in range(height):
        for x in range(width):
            around_it = [
                (v, u) for v in (y - 1, y, y + 1) for u in (x - 1, x, x + 1) if 0 <= v < height and 0 <= u < width
            ]
            moved = motion[min(around_it, key=lambda at: (away[at], at != (y, x)))]
            at = np.array([x + 0.5, y + 0.5]) - moved
            if not ((at >= 0.0) & (at <= (width, height))).all():
                continue
            column, row = np.floor(at - 0.5).astype(int)
            across, down = cubic(at[0] - 0.5 - column), cubic(at[1] - 0.5 - row)
            before = np.zeros(3)
            for j in range(4):
                for i in range(4):
                    v, u = np.clip(row - 1 + j, 0, height - 1), np.clip(column - 1 + i, 0, width - 1)
                    before += down[j] * across[i] * gathered[v, u]
            around = luma_chroma(color[max(y - 1, 0) : y + 2, max(x - 1, 0) : x + 2].reshape(-1, 3))
            low, high = around.min(axis=0), around.max(axis=0)
            growth = 2.0 - min(float(np.hypot(*moved)) / 4.0, 1.0)
            middle, half = (low + high) / 2, np.maximum(growth * (high - low) / 2, 1e-12)
            beside = luma_chroma(before) - middle
            held = rgb(middle + beside / max(1.0, (np.abs(beside) / half).max()))
            result[y, x] = held + (color[y, x] - held) * share
    return result


@pytest.mark.parametrize("size", [(19, 23), (1, 1), (1, 7)])
def test_the_temporal_kernel_equals_loops(size: tuple[int, int]) -> None:
    rng = np.random.default_rng(3)
    color = rng.uniform(0.0, 1.0, (*size, 3)).astype(np.float32)
    # If all pixels around have one colour, history is discarded.
    color[: size[0] // 2] = 0.25
    gathered = rng.uniform(0.0, 1.0, (*size, 3)).astype(np.float32)
    motion = rng.normal(0.0, 3.0, (*size, 2)).astype(np.float32)
    motion[rng.uniform(size=size) < 0.1] = np.nan
    motion[rng.uniform(size=size) < 0.1] = 0.0
    away = rng.choice(np.array([2.0, 5.0, 9.0, np.inf], np.float32), size) + rng.uniform(0, 0.1, size).astype(
        np.float32
    )
    wide = [image.astype(np.float64) for image in (color, motion, away, gathered)]
    for share in (0.1, 1.0):
        found = _core.gather_frames(color, motion, away, gathered, share)
        expected = mixed_slowly(wide[0], wide[1], wide[2], wide[3], share)
        np.testing.assert_allclose(found, expected, atol=3e-6)


def test_a_still_picture_converges_to_supersampling() -> None:
    world, hybrid = nf.datasets.beams(), rig(size=(72, 60))
    smooth = TemporalAntialiasing(offsets=8)
    for _ in range(8):
        frame = smooth.render(hybrid, world, HEAD, AHEAD)
    assert smooth.count == 8
    once = hybrid.render(world, HEAD, AHEAD)
    many, truth = (hybrid.render(world, HEAD, AHEAD, samples=samples) for samples in (8, 64))
    for side in SIDES:
        reference = getattr(truth, side).require("color")
        errors = [
            float(np.sqrt(np.mean((getattr(one, side).require("color") - reference) ** 2)))
            for one in (once, many, frame)
        ]
        assert errors[2] < 0.5 * errors[0]
        assert errors[2] < 2.0 * errors[1]


def test_pictures_of_a_moving_head_become_smoother() -> None:
    world, hybrid = nf.datasets.beams(), rig(size=(72, 60))
    smooth = TemporalAntialiasing()
    for step in range(20):
        # 3 cm and 0.2 degrees per frame.
        position = np.add(HEAD, (0.03 * step, 0.0, -0.02 * step))
        orientation = towards(position, (9.0 + 0.04 * step, 1.5, -9.0))
        frame = smooth.render(hybrid, world, position, orientation)
    once, truth = (hybrid.render(world, position, orientation, samples=samples) for samples in (1, 64))
    for side in SIDES:
        reference = getattr(truth, side).require("color")
        error, plain = (np.abs(getattr(one, side).require("color") - reference).mean() for one in (frame, once))
        # Moving pictures are blurred slightly by each lookup.
        assert error < 0.92 * plain


def test_moving_objects_leave_no_temporal_trail() -> None:
    world, hybrid = scene(), rig(size=(120, 100))
    smooth = TemporalAntialiasing(share=0.05)
    there, gone = place(7.0, 0.75, -8.0), place(7.0, 0.75, 300.0)
    for _ in range(12):
        before = smooth.render(hybrid, world, HEAD, AHEAD, at={"car": there}, channels=("color", "object_id"))
    after = smooth.render(hybrid, world, HEAD, AHEAD, at={"car": gone}, channels=("color",))
    fresh = hybrid.render(world, HEAD, AHEAD, at={"car": gone})
    for side in SIDES:
        car = getattr(before, side).require("object_id") == world.object_names.index("car")
        assert car.sum() > 30
        was, now, new = (getattr(frame, side).require("color")[car] for frame in (before, after, fresh))
        trail = np.abs(now - new).max(axis=1)
        # The ground and the wall behind it have one colour each; the rest lies along their edges.
        assert np.abs(was - new).max(axis=1).mean() > 0.1
        assert np.median(trail) < 1e-3
        assert trail.mean() < 0.02


def test_frames_have_the_requested_channels() -> None:
    smooth = TemporalAntialiasing()
    for _ in range(2):
        frame = smooth.render(rig(), scene(), HEAD, AHEAD, channels=("range", "motion"))
    assert frame.left.channels == frame.right.channels == ("range", "motion")
    assert frame.center is not None
    assert frame.center.channels == ("range", "motion")
    assert np.nanmax(np.abs(frame.left.require("motion"))) < 1e-3
    assert frame.left.camera == rig().cameras(HEAD, AHEAD)[0]


def test_changed_eyes_reset_the_history_and_a_changed_plane_does_not() -> None:
    smooth = TemporalAntialiasing()
    for one, count in ((rig(), 1), (rig(9.0), 2), (rig(size=(60, 50)), 1)):
        smooth.render(one, scene(), HEAD, AHEAD)
        assert smooth.count == count
    smooth.restart()
    assert smooth.count == 0


def moved_places(points: Image, hybrid: HybridRig, pose: tuple[Any, Any], number: int) -> Image:
    """Pixels (H, W, 2) at which a camera of an earlier rig saw points (H, W, 3)."""
    camera = hybrid.cameras(*pose)[number]
    return camera.project(points.reshape(-1, 3))[:, :2].reshape(*points.shape[:2], 2)


def test_motion_follows_own_surfaces_and_the_shared_picture() -> None:
    """Compares own surfaces with followed points; beyond the plane the positions at which both pictures show them."""
    world, hybrid = scene(), rig(size=(120, 100))
    then, now = (np.subtract(HEAD, (0.1, 0.0, 0.05)), towards(HEAD, (8.9, 1.4, -9.0))), (HEAD, AHEAD)
    car = {"car": place(7.0, 0.75, -8.0)}
    channels = ("motion", "position", "object_id", "coverage")
    frame = hybrid.render(
        world, *now, at=car, before=then, before_at={"car": place(7.0, 0.75, -7.0)}, channels=channels
    )
    for number, side in enumerate(SIDES):
        picture: nf.Frame = getattr(frame, side)
        camera = hybrid.cameras(*now)[number]
        near = nf.render(world.at(car), camera, clip=cut(hybrid, 0.1, 12.0), channels=("face_id",))
        own = np.asarray(near.require("face_id") >= 0)
        points = picture.require("position").astype(np.float64) + picture.origin
        points[picture.require("object_id") == world.object_names.index("car"), 2] += 1.0
        here = np.stack(np.meshgrid(np.arange(120) + 0.5, np.arange(100) + 0.5), -1)
        motion = picture.require("motion")
        known = np.asarray(np.isfinite(points).all(axis=-1))
        expected = here - moved_places(np.where(known[..., None], points, HEAD), hybrid, then, number)
        np.testing.assert_allclose(motion[own & known], expected[own & known], atol=2e-2)
        # Eq. 9: the shared picture's pixels, mapped to the eye now and before.
        matrix = hybrid.homography(side)
        before = moved_places(np.where(known[..., None], points, HEAD), hybrid, then, 2)
        center_now = moved_places(np.where(known[..., None], points, HEAD), hybrid, now, 2)
        at = places(hybrid, side) - (center_now - before)
        mapped = np.concatenate([at, np.ones((*at.shape[:2], 1))], -1) @ matrix.T
        expected = here - mapped[..., :2] / mapped[..., 2:]
        far = known & ~own
        assert far.sum() > 500
        assert np.percentile(np.abs(motion - expected)[far], 98) < 0.02
        assert np.linalg.norm(motion[far], axis=-1).mean() > 1.0


def test_pixels_of_all_cameras_are_jittered_equally() -> None:
    """Positions in the shared picture then belong to the shifted pixels."""
    hybrid, jitter = rig(), (0.3, -0.2)
    shifted = hybrid._core.jittered(jitter)
    at, plain = np.array([40.0, 30.0, 1.0]), np.array(hybrid.homography("left"))
    moved = np.array(shifted.homography("left")) @ at
    expected = plain @ np.add(at, (*jitter, 0.0))
    np.testing.assert_allclose(moved[:2] / moved[2] + jitter, expected[:2] / expected[2], atol=1e-10)
    with pytest.raises(ValueError, match="jitter: expected at most 1 pixel"):
        hybrid._core.jittered((2.0, 0.0))


def test_wrong_arguments_are_named() -> None:
    settings: dict[str, Any] = {"channels": ("motion",)}
    with pytest.raises(ValueError, match="channels: expected motion with the head's pose"):
        rig().render(scene(), HEAD, **settings)
    with pytest.raises(ValueError, match="before: expected a unit quaternion"):
        rig().render(scene(), HEAD, before=(HEAD, (0.0, 0.0, 0.0, 2.0)), **settings)
