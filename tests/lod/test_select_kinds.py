"""Size measures with both lens axes and on the panel, limits on sizes, and pixel densities of models."""

from __future__ import annotations

import itertools
from dataclasses import replace
from typing import Any

import mpmath
import numpy as np
import pytest

import nearfar as nf
from tests.support.lod_oracle import choose_level, model, random_spheres, rotation, size, usual

LENSES = {
    "rift": nf.RadialLens((0.22, 0.24)),
    "vive": nf.RadialLens((0.2063, 0.0576)),
    "barrel": nf.RadialLens((-0.2,)),
}
FOV = nf.Fov(-1.0, 0.9, -1.1, 1.05)
VIEW = nf.Camera.look_at((0.5, 1.5, -2.0), (4.0, 0.5, -9.0), fov=FOV, size=(1440, 1600))
KINDS: dict[str, dict[str, Any]] = {"axis": {}, "area": {"size": "area"}, "panel": {"mode": "panel"}}
CLOSE = 1e-7
"""Share of a size or a score within which the inverse table may decide differently from 40 digits."""


PIXELS: list[tuple[float | None, str]] = [(None, "seen"), (0.8e-3, "own"), (2.6e-3, "seen")]


@pytest.mark.parametrize(
    ("kind", "lens", "pixel", "limit"),
    # Each two of the three go with each other.
    [
        (kind, lens, *PIXELS[(row + column) % 3])
        for row, kind in enumerate(KINDS)
        for column, lens in enumerate([None, *LENSES])
    ],
)
def test_levels_of_all_size_measures_equal_the_formulas(
    kind: str, lens: str | None, pixel: float | None, limit: str
) -> None:
    glass = None if lens is None else LENSES[lens]
    own = replace(usual(5, seed=3), pixel=pixel)
    centers, radii = random_spheres(15, 17, VIEW)
    options = KINDS[kind] | {"camera": VIEW, "lens": glass, "limit": limit, "cull": False}
    expected = [
        choose_level(own, *one, VIEW, lens=glass, kind=kind, limit=limit) for one in zip(centers, radii, strict=True)
    ]
    for inverse in ("lut", "newton"):
        found = nf.lod.select([own], np.zeros(15, int), centers, radii, inverse=inverse, **options)
        sure = np.array([near > CLOSE for _, near in expected])
        assert sure.mean() > 0.9
        assert np.array_equal(found.level[sure], np.array([level for level, _ in expected])[sure])


@pytest.mark.parametrize("lens", [None, *LENSES])
@pytest.mark.parametrize("kind", ["area", "panel"])
def test_sizes_equal_the_formulas(kind: str, lens: str | None) -> None:
    glass = None if lens is None else LENSES[lens]
    centers, radii = random_spheres(40, 5, VIEW)
    with mpmath.workdps(40):
        spheres = zip(centers, radii, strict=True)
        exact = [float(size(center, radius, VIEW, glass, 1.0, kind)[1]) for center, radius in spheres]
    # The threshold is below all scores: every object is requested.
    options: dict[str, Any] = KINDS[kind] | {"camera": VIEW, "lens": glass, "d": -9.0, "cull": False, "full": True}
    errors: dict[Any, float] = {"lut": 1e-7, "newton": 1e-12}
    for inverse, off in errors.items():
        found = nf.lod.select([usual()], np.zeros(40, int), centers, radii, inverse=inverse, **options)
        seen = found.sigma_seen
        assert np.isfinite(exact).mean() > 0.4
        assert not np.isnan(seen).any()
        np.testing.assert_allclose(seen, exact, rtol=off)


def test_both_axes_give_the_area_of_small_objects() -> None:
    random = np.random.default_rng(0)
    ahead = random.uniform(2, 30, 400)
    own = np.stack([random.uniform(-0.8, 0.8, 400) * ahead, random.uniform(-0.8, 0.8, 400) * ahead, -ahead], axis=1)
    centers = own @ rotation(VIEW).T + VIEW.position
    lens = LENSES["rift"]
    for share, off in ((1e-3, 1e-5), (0.1, 0.02)):
        radii = share * np.linalg.norm(own, axis=1)
        exact = nf.corrected_solid_angle(centers, radii, camera=VIEW, lens=lens, exact=True)
        found = nf.lod.select(
            [usual()], np.zeros(400, int), centers, radii, camera=VIEW, lens=lens, size="area", d=-9.0, full=True
        )
        assert np.abs(found.sigma_seen / exact - 1).max() < off


def test_near_objects_lose_detail_only_if_they_look_small() -> None:
    # At the edge of the Rift's view, larger than σ₁/₁₆ and smaller behind the lens; its curve passes at all sizes.
    good = model([[1, 1, 1, 0.99]], sigma=(1e-4, 1.0))
    edge = np.array([0.85, 0.0, -1.0])
    place = rotation(VIEW) @ (3 * edge / np.linalg.norm(edge)) + np.array(VIEW.position)
    found = {
        limit: nf.lod.select([good], [0], place[None], 0.75, camera=VIEW, lens=LENSES["rift"], limit=limit, full=True)
        for limit in ("seen", "own")
    }
    reference = nf.lod.reference_solid_angle(VIEW)
    assert found["seen"].sigma_seen[0] < reference < found["seen"].sigma[0]
    assert (found["seen"].level[0], found["own"].level[0]) == (1, 0)
    assert found["own"].counts["large"] == 1


def test_finer_pixels_require_more_detail() -> None:
    centers, radii = random_spheres(500, 2, VIEW)
    own = replace(usual(), pixel=2 / 1440)
    levels = []
    for factor in (0.5, 1, 2, 4):
        camera = replace(VIEW, size=(int(1440 * factor), int(1600 * factor)))
        levels.append(nf.lod.select([own], np.zeros(500, int), centers, radii, camera=camera).level)
    seen = levels[0] > 0
    assert all((finer <= coarser).all() for coarser, finer in itertools.pairwise(levels))
    assert levels[-1][seen].mean() < levels[0][seen].mean() - 0.5


def test_curves_of_unknown_pixel_density_hold_for_all() -> None:
    centers, radii = random_spheres(500, 2, VIEW)
    small, large = (
        nf.lod.select([usual()], np.zeros(500, int), centers, radii, camera=replace(VIEW, size=size)).level
        for size in ((720, 800), (2880, 3200))
    )
    assert np.array_equal(small, large)


@pytest.mark.parametrize("lens", [None, *LENSES])
def test_panel_magnification(lens: str | None) -> None:
    glass = None if lens is None else LENSES[lens]
    angles = np.array([0.0, 10.0, 30.0, 40.0])
    found = nf.lod.panel_magnification(angles, lens=glass, view=FOV)
    assert found[0] == 1.0
    for angle, value in zip(angles[1:], found[1:], strict=True):
        # Counts pixels: the area that a small square around the direction covers on the panel.
        step, direction = 1e-5, np.radians(angle)
        away = np.array([[direction - step, 0], [direction + step, 0], [direction, -step], [direction, step]])
        rays = np.stack([np.sin(away[:, 0]), away[:, 1], np.cos(away[:, 0])], axis=1)
        points = rays[:, :2] / rays[:, 2:]
        if glass is not None:
            radii = np.hypot(*points.T)
            points *= (glass.undistort(radii) / radii)[:, None]
        area = np.linalg.norm(points[1] - points[0]) * np.linalg.norm(points[3] - points[2]) / (2 * step) ** 2
        assert value == pytest.approx(area, rel=1e-7)
    assert nf.lod.panel_magnification([90.0, 120.0], lens=glass, view=FOV).tolist() == [np.inf, np.inf]


def test_points_keep_size_zero_beyond_the_fold() -> None:
    place = [np.array(VIEW.position) + rotation(VIEW) @ (0.85, -1.05, -1.0)]
    options: dict[str, Any] = {"camera": VIEW, "lens": LENSES["barrel"], "mode": "panel", "full": True}
    for radius, seen in ((0.0, 0.0), (1e-3, np.inf)):
        found = nf.lod.select([usual()], [0], place, radius, d=-9.0, **options)
        assert found.sigma_seen[0] == seen
        assert found.level[0] == (0 if radius else 7)


def test_published_lenses_never_save_on_the_panel() -> None:
    for name in ("rift", "vive"):
        found = nf.lod.panel_magnification(np.linspace(0, 45, 100), lens=LENSES[name], view=FOV)
        assert found.min() >= 1.0
        assert found.max() > 1.0
