"""Tests of choosing the mono plane: closed forms, every headset, and an adaptive plane."""

from __future__ import annotations

import math

import numpy as np
import pytest

import nearfar as nf
from nearfar.stereo import AdaptivePlane, HybridRig, mono_plane_for

HEADSETS = [nf.hmd.get(name) for name in nf.hmd.names()]


@pytest.mark.parametrize("hmd", HEADSETS, ids=lambda hmd: str(hmd.name))
@pytest.mark.parametrize("axis", ["horizontal", "vertical", "both"])
def test_the_plane_has_the_requested_error(hmd: nf.Hmd, axis: str) -> None:
    for error, depth in ((0.5, math.inf), (1.0, 100.0), (4.0, 1000.0)):
        plane = mono_plane_for(hmd=hmd, error_px=error, depth=depth, axis=axis)
        assert HybridRig.of(hmd, mono_plane=plane).max_error(depth, axis) == pytest.approx(error, rel=1e-9)


def test_the_plane_follows_the_closed_form() -> None:
    hmd = nf.hmd.VIVE
    rig = HybridRig.of(hmd, mono_plane=8.0)
    s = rig.center_offset
    for depth in (20.0, 500.0):
        plane = mono_plane_for(hmd=hmd, error_px=1.0, depth=depth)
        # E in pixels: the error at an infinite depth times the plane's distance.
        e = rig.max_error() * 8.0
        assert plane == pytest.approx(depth * e / (e + depth + s), rel=1e-9)


def test_a_plane_for_a_bend_bounds_it_for_every_line_of_that_slope() -> None:
    rng = np.random.default_rng(0)
    for hmd in HEADSETS:
        plane = mono_plane_for(hmd=hmd, kink_deg=0.5, slope=0.5)
        rig = HybridRig.of(hmd, mono_plane=plane)
        if (np.array(rig.left.orientation) != [0.0, 0.0, 0.0, 1.0]).any():
            continue
        worst = 0.0
        for eye, fov in (("left", rig.left.fov), ("right", rig.right.fov)):
            at = rng.uniform([fov.left, fov.down], [fov.right, fov.up], (2000, 2))
            at[:4] = [(x, y) for x in (fov.left, fov.right) for y in (fov.down, fov.up)]
            turn = rng.uniform(0.0, 2.0 * np.pi, len(at))
            # 360 directions at the corners, where the bend is greatest.
            at, turn = (
                np.concatenate([at, np.repeat(at[:4], 360, axis=0)]),
                np.concatenate([turn, np.tile(np.radians(np.arange(360)), 4)]),
            )
            ways = at + 0.5 * np.column_stack([np.cos(turn), np.sin(turn)])
            worst = max(worst, float(rig.kink_angle(eye, at, ways).max()))
        assert 0.499 < worst <= 0.5 + 1e-9, hmd.name


def test_an_error_above_that_of_the_nearest_plane_gives_the_nearest() -> None:
    assert mono_plane_for(hmd=nf.hmd.VIVE, error_px=1e6) == 0.1
    assert mono_plane_for(hmd=nf.hmd.VIVE, kink_deg=89.0, slope=1e3) == 0.1


def test_an_adaptive_plane_at_rest_has_the_requested_error() -> None:
    plane = AdaptivePlane(nf.hmd.VIVE, error_px=1.0, hysteresis=0.1, rate=2.0)
    far = plane.rig.planes[0]
    assert plane.rig.max_error() == pytest.approx(1.0, rel=1e-9)
    for depth in (5.0, 60.0, 1000.0, math.inf, 12.0):
        for _ in range(300):
            rig = plane.update(depth, 1.0 / 72.0)
        wanted = plane.wanted(depth)
        assert wanted * (1.0 - 1e-12) <= rig.planes[0] <= 1.1 * wanted * (1.0 + 1e-12)
        assert rig.max_error(depth) <= 1.0 + 1e-9
    assert plane.wanted(math.inf) == far
    assert plane.wanted(0.2) == 0.5


def test_an_adaptive_plane_moves_at_most_at_its_rate() -> None:
    plane = AdaptivePlane(nf.hmd.VIVE, rate=0.5)
    before = plane.rig.planes[0]
    after = plane.update(3.0, 0.1).planes[0]
    assert math.log(before / after) == pytest.approx(0.05)
    # Within the hysteresis it does not move, and a step of zero duration changes nothing.
    assert plane.update(3.0, 0.0).planes[0] == after
    for _ in range(1000):
        plane.update(3.0, 0.1)
    rest = plane.rig
    assert plane.update(3.05, 1.0) is rest
    assert plane.update(10.0, 0.1).planes[0] / rest.planes[0] == pytest.approx(math.exp(0.05))
