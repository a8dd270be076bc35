"""Tests of the similarity of consecutive pictures after motion compensation."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf

SIZE = (48, 32)
CAMERA = nf.Camera((0.0, 0.0, 0.0), fov=nf.Orthographic(-24, 24, -16, 16), size=SIZE)
STEP = 3
"""Shift of the pictures to the left, pixels."""


def pictures(change: float = 0.0) -> tuple[nf.Frame, nf.Frame]:
    """Return two pictures of a wall whose colours change, from an eye that moves by three of its pixels."""
    rng = np.random.default_rng(6)
    wall = rng.uniform(0.1, 0.9, (SIZE[1], SIZE[0] + STEP, 3)).astype(np.float32)
    changed = np.clip(wall + change * rng.normal(size=wall.shape), 0, 1).astype(np.float32)
    distance, motion = np.full(SIZE[::-1], 9.0, np.float32), np.zeros((*SIZE[::-1], 2), np.float32)
    motion[..., 0] = -STEP
    earlier = nf.Frame(CAMERA, color=wall[:, :-STEP], range=distance)
    moved = replace(CAMERA, position=(float(STEP), 0.0, 0.0))
    return earlier, nf.Frame(moved, color=changed[:, STEP:], range=distance, motion=motion)


def compared(earlier: nf.Frame, later: nf.Frame, seen: NDArray[np.bool_]) -> float:
    """Return SSIM of the later picture and the shifted earlier one, over pixels that both see."""
    color = later.require("color").copy()
    shifted = np.roll(earlier.require("color"), -STEP, axis=1)
    color[seen] = shifted[seen]
    return float(nf.ssim(replace(later, color=color), later, mask=seen))


def test_a_moved_wall_has_similarity_one() -> None:
    assert nf.motion_ssim(*pictures()) == pytest.approx(1.0, abs=1e-9)
    assert nf.ssim(*pictures()) < 0.2


@pytest.mark.parametrize("change", [0.02, 0.2])
def test_changes_count_as_in_ssim(change: float) -> None:
    earlier, later = pictures(change)
    seen = np.ones(SIZE[::-1], bool)
    # Only pixels that were in the earlier picture count, up to its border's outer edge.
    seen[:, -STEP:] = False
    found = nf.motion_ssim(earlier, later, full=True)
    assert float(found) == pytest.approx(compared(earlier, later, seen), abs=1e-6)
    assert found < 1 - change / 10
    assert found.map.shape == SIZE[::-1]


def test_disoccluded_pixels_do_not_count() -> None:
    earlier, later = pictures(0.1)
    hidden = earlier.require("range").copy()
    hidden[10:20, 20:30] = 4.0
    noise = earlier.require("color").copy()
    noise[10:20, 20:30] = 0.0
    seen = np.ones(SIZE[::-1], bool)
    seen[:, -STEP:] = False
    seen[10:20, 20 - STEP : 30 - STEP] = False
    found = nf.motion_ssim(replace(earlier, range=hidden, color=noise), later)
    assert float(found) == pytest.approx(compared(earlier, later, seen), abs=1e-6)


def test_true_pictures_of_a_scene_are_similar() -> None:
    """Pictures of a scene from a moving eye differ by sampling alone."""
    scene = nf.datasets.room()
    first, second = (nf.Camera((0.02 * n, 1.6, 0.0), fov=nf.Fov.symmetric(80, 1.5), size=(150, 100)) for n in range(2))
    settings = {"samples": 16, "backend": "cpu"}
    earlier = nf.render(scene, first, channels=("color", "range"), **settings)  # type: ignore[arg-type]
    channels = ("color", "range", "motion")
    later = nf.render(scene, second, before=first, channels=channels, **settings)  # type: ignore[arg-type]
    found, still = nf.motion_ssim(earlier, later), nf.ssim(earlier, later)
    assert 1 - found < 0.5 * (1 - still), (found, still)


def test_invalid_input_of_motion_similarity_is_refused() -> None:
    earlier, later = pictures()
    with pytest.raises(ValueError, match=r"later: .*motion"):
        nf.motion_ssim(earlier, replace(later, motion=None))
    with pytest.raises(ValueError, match=r"earlier: .*range"):
        nf.motion_ssim(replace(earlier, range=None), later)
    away = replace(later, motion=later.require("motion") * 100)
    with pytest.raises(ValueError, match="later: expected a picture that shows some surface"):
        nf.motion_ssim(earlier, away)
