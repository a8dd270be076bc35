"""Tests of tear against its definition, and on maps with a known tear."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, strategies as st
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.metrics.tear import DEFAULT_VIEW, picture, pixels, torn_picture, values_along_line
from nearfar._reduce.drawing import MorphKind
from nearfar.metrics._tear import _tears

Array = NDArray[np.float64]

SIZE = (48, 36)
MIDDLE = np.array([24.0, 18.0])
VIEW = nf.Camera((3, 2, 1), fov=nf.Fov.symmetric(90, SIZE[0] / SIZE[1]), size=SIZE)
UNIT_STEP = np.sqrt(0.25 - 4 * (2 / (3 * np.pi)) ** 2)


def slow_tear(frame: nf.Frame, epsilon: float) -> Array:
    """Compare every pixel with every other, by least squares."""
    truth = frame.camera.project(frame.require("position").astype(np.float64).reshape(-1, 3) + frame.origin)
    here = pixels(VIEW).reshape(-1, 2)
    known = np.isfinite(truth).all(axis=1) & (truth[:, 2] > 0)
    out = np.full(len(here), np.nan)
    for p in np.flatnonzero(known):
        near = known & (np.linalg.norm(truth[:, :2] - truth[p, :2], axis=1) < epsilon)
        if near.sum() > 1:
            places = np.column_stack([truth[near, :2] - truth[p, :2], np.ones(near.sum())])
            fit, *_ = np.linalg.lstsq(places, here[near], rcond=1e-5)
            out[p] = np.sqrt(((here[near] - places @ fit) ** 2).sum(axis=1).mean()) / UNIT_STEP
    return out.reshape(SIZE[1], SIZE[0])


@pytest.mark.parametrize("epsilon", [2.3, 4.0, 9.1])
def test_tear_equals_its_definition(epsilon: float) -> None:
    random = np.random.default_rng(5)
    wavy = pixels(VIEW) + 3 * np.sin(pixels(VIEW)[..., ::-1] / 3) + random.normal(size=(36, 48, 2)) * 0.3
    frame = picture(wavy, VIEW)
    frame.require("position")[3:9, 5:20] = np.nan
    found, expected = nf.metrics.tear(frame, epsilon=epsilon), slow_tear(frame, epsilon)
    np.testing.assert_array_equal(np.isnan(found), np.isnan(expected))
    differs = ~np.isclose(found, expected, rtol=1e-4, atol=1e-3, equal_nan=True)
    # A pair at the distance ε, up to rounding, may count or not.
    assert differs.mean() < 0.005


@pytest.mark.slow
@given(st.integers(0, 2**32 - 1), st.floats(0.3, 30))
def test_random_points_equal_the_definition_of_tear(seed: int, epsilon: float) -> None:
    random = np.random.default_rng(seed)
    # Positions that differ by less than 10⁻⁴ pixels are rounding, which decides whether they are collinear.
    spreads = [(0.01, 0.01), *((wide, wide * thin) for wide in (1, 30, 1000) for thin in (1, 0, 1e-3))]
    truth = MIDDLE + random.normal(size=(SIZE[1], SIZE[0], 2)) * random.choice(np.array(spreads))
    frame = picture(truth, VIEW)
    frame.require("position")[random.uniform(size=truth.shape[:2]) < 0.7] = np.nan
    found, expected = nf.metrics.tear(frame, epsilon=epsilon), slow_tear(frame, epsilon)
    differs = ~np.isclose(found, expected, rtol=2e-3, atol=2e-2, equal_nan=True)
    assert differs.mean() <= 0.02


@pytest.mark.parametrize("shear", [0.0, 0.3, 5.0])
def test_affine_maps_have_no_tear(shear: float) -> None:
    turned = (pixels(VIEW) - MIDDLE) @ np.array([[0.9, 0.3], [shear, 1.2]]) + MIDDLE
    assert np.nanmax(nf.metrics.tear(picture(turned, VIEW))) < 1e-3


@pytest.mark.parametrize("shear", [0.0, 0.5, 5.0])
@pytest.mark.parametrize("direction", [0.0, 0.5, 1.2, np.pi / 2])
@pytest.mark.parametrize("kind", ["opening", "sliding"])
def test_tear_measures_width_in_every_direction_at_every_shear(kind: str, direction: float, shear: float) -> None:
    for tear in (1.0, 3.0, 10.0, 40.0):
        values = nf.metrics.tear(torn_picture(tear, direction, kind=kind, shear=shear))
        found = values_along_line(values, tear, direction, kind=kind)
        # Neighbourhoods hold some fifty pixels, and the line is up to a pixel beside their middles.
        assert found.mean() == pytest.approx(tear, rel=0.06)
        assert found.max() == pytest.approx(tear, rel=0.11)


@pytest.mark.parametrize("direction", [0.0, 0.5, np.pi / 2])
def test_curvature_adds_little_to_a_tear(direction: float) -> None:
    """A curvature c alone reads about 12 c."""
    curved = nf.metrics.tear(torn_picture(0.0, direction, kind="sliding", curvature=0.002))
    assert values_along_line(curved, 0.0, direction, kind="sliding").mean() == pytest.approx(0.024, rel=0.2)
    for tear in (1.0, 3.0, 10.0, 40.0):
        found = nf.metrics.tear(torn_picture(tear, direction, curvature=0.002))
        assert values_along_line(found, tear, direction).mean() == pytest.approx(tear, rel=0.1)


@pytest.mark.parametrize("direction", [0.0, 0.5, np.pi / 2])
def test_an_overlap_that_hides_a_side_measures_zero(direction: float) -> None:
    found = nf.metrics.tear(torn_picture(10.0, direction, kind="overlap"))
    assert values_along_line(found, 10.0, direction, kind="overlap").max() < 1e-3


@pytest.mark.parametrize(("epsilon", "columns"), [(4.0, (77, 82)), (2.0, (79, 80))])
def test_borders_separate_neighbourhoods(epsilon: float, columns: tuple[int, int]) -> None:
    left = pixels(DEFAULT_VIEW)[..., 0] < 80.2
    both = _tears(torn_picture(0.0, 0.0), DEFAULT_VIEW, epsilon, side=left)[1]
    found = np.flatnonzero(both.any(axis=0))
    assert (found.min(), found.max()) == columns
    assert not _tears(torn_picture(0.0, 0.0), DEFAULT_VIEW, epsilon, side=np.ones_like(left))[1].any()


def test_only_requested_pixels_are_measured() -> None:
    frame = torn_picture(3.0, 0.5)
    wanted = np.random.default_rng(3).random((160, 160)) < 0.3
    some, every = _tears(frame, DEFAULT_VIEW, 4.0, mask=wanted)[0], nf.metrics.tear(frame)
    np.testing.assert_array_equal(np.isnan(some), ~wanted | np.isnan(every))
    np.testing.assert_array_equal(some[wanted], every[wanted])


@pytest.fixture(scope="module")
def plane() -> nf.Scene:
    corners = np.array([[-2000, 0, -2000], [2000, 0, -2000], [2000, 0, 2000], [-2000, 0, 2000]], np.float32)
    return nf.Scene.from_arrays(corners, np.array([[0, 2, 1], [0, 3, 2]], np.uint32))


def seen_ground(plane: nf.Scene, morph: MorphKind, r1: float, focal: float) -> nf.metrics.BoundaryTear:
    """Return the border at 50 m of a reduced ground, seen from 8 m beside the centre, by bent rays without a map."""
    eye = np.array([0.0, 1.7, 0.0])
    reduced = nf.reduce(plane, center=eye, r1=r1, r2=50, morph=morph, face_size=16, channels=("color", "range"))
    half = 200.0 / focal
    size = (400, round(0.06 * focal))
    camera = nf.Camera((8.0, 1.7, 0.0), fov=nf.Fov(-half, half, -0.06, 0.0), size=size)
    frame = reduced.render(camera, method="exact", env=False, channels=("position",), samples=1)
    return nf.metrics.boundary_tear(frame, center=eye, radius=50)


@pytest.mark.parametrize(("r1", "gain"), [(30.0, 11.8), (8.77, 24.0)])
def test_the_conventional_method_tears_the_ground_and_the_continuous_one_bends_it(
    plane: nf.Scene, r1: float, gain: float
) -> None:
    """The tear grows with the picture's density; the bend keeps its value, being only a change of slope."""
    torn, bent = ([seen_ground(plane, morph, r1, focal) for focal in (480.0, 1146.0)] for morph in ("none", "blend"))
    assert torn[1].pixels_per_degree == pytest.approx(20.0, rel=1e-3)
    values = [found.tear or np.nan for found in (*torn, *bent)]
    assert values[1] / values[0] == pytest.approx(1146 / 480, rel=0.05)
    assert values[3] / values[2] == pytest.approx(1.0, rel=0.05)
    assert values[1] / values[3] == pytest.approx(gain, rel=0.05)
    assert (torn[1].kink or np.nan) < 0.08 * values[1]
    assert (bent[1].kink or np.nan) > 0.95 * values[3]


def test_an_invisible_border_has_no_tear(plane: nf.Scene) -> None:
    camera = nf.Camera.look_at((0, 1.7, 0), (0, 9, -5), fov=nf.Fov.symmetric(60), size=(40, 30))
    frame = nf.render(plane, camera, channels=("position",))
    found = nf.metrics.boundary_tear(frame, center=(0, 1.7, 0), radius=50)
    assert (found.pixels, found.shared, found.tear, found.kink) == (0, None, None, None)
