"""Views and sizes that decide a level before curves do: out of view, around the eye, or beyond all ranges."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from tests.support.lod_oracle import choose_level, distance_to_view, model, random_spheres, rotation, usual

Array = NDArray[np.float64]

LENS = nf.RadialLens((0.22, 0.24))
FOV = nf.Fov(-1.0, 0.9, -1.1, 1.05)
VIEW = nf.Camera((0.5, 1.5, -2.0), fov=FOV, size=(1440, 1600))
TURNED = nf.Camera.look_at((0.5, 1.5, -2.0), (4.0, 0.5, -9.0), fov=FOV, size=(1440, 1600))


def in_view(centers: Array, radii: Array, camera: nf.Camera) -> NDArray[np.bool_]:
    own = (centers - camera.position) @ rotation(camera)
    assert isinstance(camera.fov, nf.Fov)
    return np.asarray(distance_to_view(own, camera.fov) <= radii)


# the view ------------------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("camera", [VIEW, TURNED, nf.hmd.get("PIMAX_5K_PLUS").camera("left", (0, 1, 0))])
def test_culled_objects_are_out_of_view(camera: nf.Camera) -> None:
    random = np.random.default_rng(3)
    centers = random.normal(size=(4000, 3)) * 5 + camera.position
    radii = np.exp(random.uniform(-4, 1, 4000))
    level = nf.lod.select([usual()], np.zeros(4000, int), centers, radii, camera=camera)
    visible = in_view(centers, radii, camera)
    assert (level[visible] >= 0).all()
    # Plane tests keep a few objects beside the corners of the view.
    assert np.mean(level[~visible] >= 0) < 0.02
    assert 0.05 < visible.mean() < 0.95
    alone = nf.lod.select([usual()], np.zeros(4000, int), centers, radii, camera=camera, cull=False)
    assert np.array_equal(alone[level >= 0], level[level >= 0])
    assert (alone >= 0).all()


def one(center: Any, radius: float, camera: nf.Camera = VIEW, **options: Any) -> Any:
    """Select for one sphere at a position in the camera's axes."""
    place = rotation(camera) @ np.array(center, np.float64) + camera.position
    return nf.lod.select([usual()], [0], place[None], radius, camera=camera, full=True, **options)


def test_spheres_around_across_and_behind_the_view_are_culled_correctly() -> None:
    inside = one((0.2, 0.0, -0.1), 0.5)
    assert (inside.level[0], inside.sigma[0]) == (0, 4 * np.pi)
    assert one((0.0, 0.0, 0.4), 0.5).level[0] == 0
    # At the right edge, by the sphere's width: half in view, a little in view, and outside.
    edge = np.array([0.9, 0.0, -1.0]) / math.hypot(0.9, 1)
    outward = np.array([1.0, 0.0, 0.9]) / math.hypot(0.9, 1)
    assert one(10 * edge, 0.01).level[0] > 0
    assert one(10 * edge + 0.0099 * outward, 0.01).level[0] > 0
    assert one(10 * edge + 0.0101 * outward, 0.01).level[0] == -1
    # Behind the eye; the second one extends into the view around its corner.
    assert one((0, 0, 5), 1.0).level[0] == -1
    assert one((0, 0, 5), 4.999).level[0] == -1
    assert one((3.0, 0.0, 0.5), 2.9).level[0] == 0
    assert one((0, 0, 5), 1.0, cull=False).level[0] == choose_level(usual(), np.array([0.5, 1.5, 3.0]), 1.0, VIEW)[0]


@pytest.mark.parametrize("scale", [1e-300, 1e-150, 1e-30, 1e30, 1e150, 1e300])
def test_levels_do_not_depend_on_the_unit(scale: float) -> None:
    camera = nf.Camera((0, 0, 0), fov=FOV, size=(100, 100))
    centers, radii = random_spheres(400, 4, nf.Camera((0, 0, 0), fov=FOV, size=(100, 100)))
    expected = nf.lod.select([usual()], np.zeros(400, int), centers, radii, camera=camera, lens=LENS, full=True)
    found = nf.lod.select(
        [usual()], np.zeros(400, int), centers * scale, radii * scale, camera=camera, lens=LENS, full=True
    )
    assert np.array_equal(found.level, expected.level)
    np.testing.assert_allclose(found.sigma_seen, expected.sigma_seen, rtol=1e-9)


def test_tiny_objects_have_the_coarsest_level_sufficient_at_the_least_size() -> None:
    for radius in (0.0, 1e-200, 1e-9):
        found = one((0, 0, -3), radius, lens=LENS)
        assert found.level[0] == choose_level(usual(), np.array([0.5, 1.5, -5.0]), radius, VIEW, lens=LENS)[0] > 0
    hard = one((0, 0, -3), 0.0, d=2.0)
    assert (hard.level[0], hard.score[0]) == (0, 1)


# ranges --------------------------------------------------------------------------------------------------------------
def test_sizes_beyond_the_measured_range_use_its_ends() -> None:
    # Sufficient at any size, so that ranges alone decide.
    good = model([(1.0, 1.0, 1.0, 0.99)], (1e-3, 0.05))
    reference = nf.lod.reference_solid_angle(VIEW)
    for sigma, level in ((0.0499, 1), (0.0501, 0), (1e-3, 1), (1e-5, 1)):
        radius = 5 * math.sin(2 * math.asin(math.sqrt(sigma / (4 * math.pi))))
        found = nf.lod.select([good], [0], [(0.5, 1.5, -7.0)], radius, camera=VIEW, full=True)
        assert found.sigma[0] == pytest.approx(sigma, rel=1e-12)
        assert found.level[0] == level
    wide = model([(1.0, 1.0, 1.0, 0.99)], (1e-3, 1.0))
    for share, level in ((0.999, 1), (1.001, 0)):
        radius = 5 * math.sin(2 * math.asin(math.sqrt(share * reference / (4 * math.pi))))
        for limit, counted in (("seen", "asked"), ("own", "large")):
            found = nf.lod.select([wide], [0], [(0.5, 1.5, -7.0)], radius, camera=VIEW, limit=limit, full=True)
            assert found.level[0] == level
            assert found.counts["asked" if level else counted] == 1
        other = nf.lod.select([wide], [0], [(0.5, 1.5, -7.0)], radius, camera=VIEW, reference=1.01 * reference)
        assert other[0] == 1
    # Below the least size a curve that would continue to rise or fall stays constant.
    for a in (0.0, 1.0):
        rising = model([(a, 1.0, 1e-4, 0.5)], (1e-3, 0.1))
        score = rising.curves[0](1e-3)
        found = nf.lod.select([rising], [0], [(0.5, 1.5, -7.0)], 1e-6, camera=VIEW, k=0.0, d=score - 1e-9, full=True)
        assert (found.level[0], found.score[0]) == (1, pytest.approx(score))
        assert nf.lod.select([rising], [0], [(0.5, 1.5, -7.0)], 1e-6, camera=VIEW, k=0.0, d=score + 1e-9)[0] == 0


def test_a_lens_may_magnify_beyond_the_measured_sizes() -> None:
    bulging = nf.RadialLens((-0.1,))
    good = model([(1.0, 1.0, 1.0, 0.99)], (1e-3, 0.02))
    radius = 5 * math.sin(2 * math.asin(math.sqrt(0.0199 / (4 * math.pi))))
    place = np.array(VIEW.position) + 5 * np.array([0.6, 0.0, -0.8])
    found = nf.lod.select([good], [0], place[None], radius, camera=VIEW, lens=bulging, full=True)
    assert found.sigma[0] < 0.02 < found.sigma_seen[0]
    assert found.level[0] == 0


def test_beyond_the_fold_of_a_lens_sizes_are_undistorted() -> None:
    folded = nf.RadialLens((-0.5,))
    centers, radii = random_spheres(500, 5, VIEW)
    found = nf.lod.select([usual()], np.zeros(500, int), centers, radii, camera=VIEW, lens=folded, full=True)
    seen = nf.corrected_solid_angle(centers, radii, camera=VIEW, lens=folded)
    asked = ~np.isnan(found.sigma_seen)
    # Near the fold the inverse is arbitrarily steep: tables end before it.
    np.testing.assert_allclose(found.sigma_seen[asked], seen[asked], rtol=1e-8)
    assert 0 < np.mean(found.sigma_seen[asked] == found.sigma[asked]) < 1
