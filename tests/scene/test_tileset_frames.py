"""Tests of the frames of tilesets against PROJ, and of their bounding volumes."""

from __future__ import annotations

import numpy as np
import pytest

from nearfar._scene import frames
from nearfar._scene.frames import earth_centred
from nearfar._scene.tileset import volumes


def test_an_explicit_default_frame_changes_nothing() -> None:
    frame = frames.local_frame_at(earth_centred(np.array([0.123456789123, -0.7, 12.3456])))
    assert frame is not None
    assert frame.origin is not None
    np.testing.assert_array_equal(frame.to_scene, frames.local(frame.origin).to_scene)
    assert f"longitude {frame.origin[0]:.9f}°" in frame.note
    assert frames.local_frame_at(np.zeros(3)) is None
    assert frames.local_frame_at(np.array([500_000.0, 5_300_000.0, 100.0])) is None  # A national grid.


def test_boxes_hold_their_regions() -> None:
    rng = np.random.default_rng(3)
    frame = frames.local((10.0, 45.0, 0.0)).to_scene
    for _ in range(60):
        west, south = rng.uniform(-3, 3), rng.uniform(-1.5, 1.4)
        width, depth = 10 ** rng.uniform(-6, 0.5), 10 ** rng.uniform(-6, -0.8)
        region = volumes.Region(west, south, west + width, min(south + depth, 1.57), -50, 300)
        inside = rng.uniform((region.west, region.south, -50), (region.east, region.north, 300), (2000, 3))
        placed = earth_centred(inside) @ frame[:3, :3].T + frame[:3, 3]
        low, high = region.bounds(frame)
        assert (placed >= low - 1e-6).all()
        assert (placed <= high + 1e-6).all()
        # They are slightly larger: by a part of the sagitta of an eighth of the sides.
        assert (np.ptp(region.bounds(frame), axis=0) <= 2.6 * (np.ptp(placed, axis=0) + 60)).all()


@pytest.mark.parametrize(("axes", "cells"), [(2, 4), (3, 8)])
def test_parts_fill_their_volume(axes: int, cells: int) -> None:
    turned = np.linalg.qr(np.random.default_rng(5).normal(size=(3, 3)))[0] * np.array([[3.0], [4.0], [5.0]])
    whole = volumes.Box(np.array([1.0, 2.0, 3.0]), turned)
    parts = [whole.part(1, tuple(number >> axis & 1 for axis in range(axes))) for number in range(cells)]
    size = [abs(np.linalg.det(part.axes)) for part in parts]
    assert sum(size) == pytest.approx(abs(np.linalg.det(whole.axes)))
    np.testing.assert_allclose(np.mean([part.middle for part in parts], axis=0), whole.middle, atol=1e-12)
    region = volumes.Region(3.0, 0.1, 3.4, 0.3, 0.0, 100.0)  # Across the date line.
    last = region.part(3, (7,) * axes)
    assert (last.east, last.north, last.high) == pytest.approx((3.4, 0.3, 100.0))
    assert last.low == pytest.approx(87.5 if axes == 3 else 0.0)
