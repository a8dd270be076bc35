"""Sizes: a sixteenth of the screen, and the factors for a lens and for eccentricity."""

from __future__ import annotations

import math

import numpy as np
import pytest

import nearfar as nf

LENS = nf.RadialLens((0.22, 0.24))


def test_acuity_equals_guenter() -> None:
    away = np.array([0.0, 5.0, 20.0, 60.0])
    np.testing.assert_allclose(nf.lod.acuity(away), (1 / 48) / (0.0275 * away + 1 / 48))
    np.testing.assert_allclose(
        nf.lod.acuity(away, slope=0.022, limit_deg=0.02, pixel_deg=0.1), np.minimum(1, 0.1 / (0.022 * away + 0.02))
    )
    assert nf.lod.acuity(3.0).shape == ()


def test_distortion_equals_the_limit_for_small_objects() -> None:
    camera = nf.Camera((0, 0, 0), fov=nf.Fov.symmetric(87), size=(10, 10))
    away = np.array([0.0, 10.0, 43.0, 70.0])
    angles = np.radians(away)
    centers = np.stack([np.sin(angles), 0 * angles, -np.cos(angles)], axis=1)
    seen = nf.corrected_solid_angle(centers, 1e-6, camera=camera, lens=LENS)
    expected = seen / nf.solid_angle(centers, 1e-6, eye=(0, 0, 0))
    np.testing.assert_allclose(nf.lod.distortion(away, lens=LENS, view=camera), expected, rtol=1e-9)
    assert nf.lod.distortion([90.0, 120.0], lens=LENS, view=camera).tolist() == [1, 1]
    assert nf.lod.distortion([60.0], lens=nf.RadialLens((-0.5,)), view=nf.Fov.symmetric(87)).tolist() == [1]


def test_the_reference_size_is_a_sixteenth_of_the_screen() -> None:
    for tangent in (0.5, 1.0, 3.9):
        expected = 2 * math.pi * (1 - math.cos(math.asin(tangent / 4)))
        fov = nf.Fov(-tangent / 2, tangent, -1, 1)
        camera = nf.Camera((0, 0, 0), fov=fov, size=(4, 4))
        assert nf.lod.reference_solid_angle(fov) == nf.lod.reference_solid_angle(camera) == pytest.approx(expected)
    # Behind the lens of a Vive Pro less is seen than its screen is wide; the generic lens has no edge.
    for hmd, tangent in ((nf.hmd.QUEST_2, 1.279942), (nf.hmd.VIVE_PRO, 1.0913085010692714)):
        same = nf.Fov(-tangent, 1e-3, -1, 1)
        assert nf.lod.reference_solid_angle(hmd) == nf.lod.reference_solid_angle(same)
    assert nf.lod.reference_solid_angle(nf.hmd.QUEST_2.with_lens()) == nf.lod.reference_solid_angle(nf.hmd.QUEST_2)
    with pytest.raises(ValueError, match="view: expected a tangent to the side below 4, got 4"):
        nf.lod.reference_solid_angle(nf.Fov(-4, 4, -1, 1))
