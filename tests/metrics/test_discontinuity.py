"""Tests of discontinuity against its definition."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, strategies as st
from numpy.typing import NDArray

import nearfar as nf
from tests.support.reduce_cases import CENTER, R1, R2, camera, street

Array = NDArray[np.float64]


def slow_discontinuity(frame: nf.Frame, epsilon: float, least: float) -> Array:
    """Evaluate Eq. 5–6, every pixel against every other."""
    position = frame.require("position").astype(np.float64) + frame.origin
    height, width = position.shape[:2]
    pixels = np.stack(np.meshgrid(np.arange(width) + 0.5, np.arange(height) + 0.5), axis=-1).reshape(-1, 2)
    truth = frame.camera.project(position.reshape(-1, 3))
    known = np.isfinite(truth).all(axis=1) & (truth[:, 2] > 0)
    out = np.full(height * width, np.nan)
    for p in np.flatnonzero(known):
        there = np.linalg.norm(truth[:, :2] - truth[p, :2], axis=1)
        others = known & (there < epsilon)
        others[p] = False
        if others.any():
            here = np.linalg.norm(pixels[others] - pixels[p], axis=1)
            out[p] = (here / np.maximum(there[others], least)).mean() - 1.0
    return out.reshape(height, width)


@pytest.fixture(scope="module")
def frames() -> dict[str, nf.Frame]:
    """Return truth, conventional and continuous picture from 7 m beside the centre."""
    scene = street()
    reduced = nf.reduce(scene, center=CENTER, r1=R1, r2=R2, face_size=256, samples=1, channels=("color", "range"))
    view = camera(CENTER + np.array([0, 0.2, 7.0]), (1, -0.03, 0.1), (64, 40))
    channels = ("color", "position")
    return {
        "truth": nf.render(scene, view, channels=channels),
        "conventional": reduced.with_morph("none").render(view, channels=channels),
        "continuous": reduced.render(view, channels=channels),
    }


@pytest.mark.parametrize(
    ("name", "epsilon", "least"),
    [("truth", 17.03, 1.0), ("conventional", 3.1, 0.25), ("continuous", 200.3, 5.0)],
)
def test_discontinuity_equals_its_definition(
    frames: dict[str, nf.Frame], name: str, epsilon: float, least: float
) -> None:
    expected = slow_discontinuity(frames[name], epsilon, least)
    found = nf.metrics.discontinuity(frames[name], epsilon=epsilon, min_distance=least)
    np.testing.assert_array_equal(np.isnan(found), np.isnan(expected))
    # A point whose distance equals ε to float32 may count or not: one of some hundred neighbours. Unmoved pixels
    # have integer distances, so ε is not an integer.
    np.testing.assert_allclose(found, expected, rtol=2e-4, atol=2e-3)


def test_the_truth_has_no_discontinuity(frames: dict[str, nf.Frame]) -> None:
    # Positions on triangles of 4,000 m are rounded to 2.4e-4 m, which 5 m away is 2e-3 px of the 64 across 90 degrees.
    assert np.nanmax(np.abs(nf.metrics.discontinuity(frames["truth"]))) < 2e-3


def test_only_the_conventional_method_tears_walls_at_the_boundary() -> None:
    channels = ("color", "range")
    reduced = nf.reduce(street(ground=False), center=CENTER, r1=R1, r2=R2, face_size=256, samples=1, channels=channels)
    view = camera(CENTER + np.array([0, 0.2, 7.0]), (1, 0.0, -0.5), (320, 200))
    torn = {}
    for morph in ("none", "blend"):
        frame = reduced.with_morph(morph).render(view, channels=("position",))
        edge = nf.metrics.boundary_mask(frame, center=CENTER, radius=R2)
        assert edge.sum() > 50
        torn[morph] = float(np.nanmean(np.abs(nf.metrics.discontinuity(frame)[edge])))
    # The wall recedes, so that the morph shears it between the radii, which counts as discontinuity too.
    assert torn["none"] > 5 * torn["blend"]


def test_a_truth_of_another_size_is_refused(frames: dict[str, nf.Frame]) -> None:
    # With half the pixels across, every distance in the truth would be halved, and an intact picture would be torn.
    frame = frames["truth"]
    half = nf.Camera(frame.camera.position, frame.camera.orientation, fov=frame.camera.fov, size=(32, 20))
    for wrong in (half, nf.Camera((0, 0, 0), fov=nf.Fov.symmetric(90, 1), size=(64, 41))):
        with pytest.raises(ValueError, match="truth_camera: expected 64 × 40 pixels, as the frame"):
            nf.metrics.discontinuity(frame, wrong)
    same = nf.Camera(frame.camera.position, frame.camera.orientation, fov=frame.camera.fov, size=(64, 40))
    np.testing.assert_array_equal(nf.metrics.discontinuity(frame, same), nf.metrics.discontinuity(frame))


def test_pixels_without_a_surface_or_neighbours_have_none(frames: dict[str, nf.Frame]) -> None:
    sky = np.isnan(frames["truth"].require("position")[..., 0])
    assert sky.any()
    np.testing.assert_array_equal(np.isnan(nf.metrics.discontinuity(frames["truth"])), sky)
    behind = nf.Camera.look_at((0, 2, 0), (-1, 2, 0), fov=nf.Fov.symmetric(20, 1), size=(8, 8))
    view = nf.Camera.look_at((0, 2, 0), (1, 2, 0), fov=nf.Fov.symmetric(20, 1), size=(8, 8))
    seen = nf.render(street(), view, channels=("position",))
    assert np.isnan(nf.metrics.discontinuity(seen, behind)).all()
    assert np.isnan(nf.metrics.discontinuity(seen, epsilon=1e-3)).all()
    with pytest.raises(ValueError, match="position"):
        nf.metrics.discontinuity(nf.render(street(), view, channels=("color",)))


@given(st.integers(0, 2**32 - 1), st.floats(0.3, 40), st.floats(0.05, 3))
def test_random_points_equal_the_definition(seed: int, epsilon: float, least: float) -> None:
    # Points in clusters, far outside the picture, behind the camera, and missing ones.
    random = np.random.default_rng(seed)
    view = nf.Camera((0, 0, 0), fov=nf.Fov.symmetric(90, 1.5), size=(27, 18))
    position = random.normal(size=(18, 27, 3)) * random.choice([0.01, 1, 30]) + [0, 0, random.choice([-50, -3, 0])]
    position[random.uniform(size=(18, 27)) < 0.1] = np.nan
    frame = nf.Frame(view, position=position.astype(np.float32))
    expected = slow_discontinuity(frame, epsilon, least)
    found = nf.metrics.discontinuity(frame, epsilon=epsilon, min_distance=least)
    # A pair at the distance ε, up to rounding, may count or not.
    differs = ~np.isclose(found, expected, rtol=2e-3, atol=2e-3, equal_nan=True)
    assert differs.mean() <= 0.02


def test_coincident_and_missing_pixels_are_handled() -> None:
    view = nf.Camera((0, 0, 0), fov=nf.Fov.symmetric(90, 1), size=(12, 12))
    heap = nf.Frame(view, position=np.full((12, 12, 3), [0, 0, -5], np.float32))
    # All pixels are neighbours at distance 0, which is raised to a pixel: δ + 1 is the mean distance of pixels.
    y, x = np.mgrid[:12, :12]
    apart = np.hypot(x[..., None, None] - x, y[..., None, None] - y).sum(axis=(2, 3)) / 143
    np.testing.assert_allclose(nf.metrics.discontinuity(heap), apart - 1, rtol=1e-5)
    nothing = nf.Frame(view, position=np.full((12, 12, 3), np.nan, np.float32))
    assert np.isnan(nf.metrics.discontinuity(nothing)).all()


def test_outlines_in_front_of_far_surfaces_do_not_cross_the_radius() -> None:
    """Measures a floor that crosses the radius, and a wall that ends there in front of another one far behind."""
    columns, rows = np.meshgrid(np.arange(40), np.arange(30))
    ahead = np.where(rows < 15, np.where(columns < 20, 49.5, 90.0), 48.0 + (29 - rows) * 0.3)
    position = np.stack([np.zeros_like(ahead), np.zeros_like(ahead), -ahead], axis=-1).astype(np.float32)
    view = nf.Camera((0, 0, 0), fov=nf.Fov.symmetric(60, 4 / 3), size=(40, 30))
    frame = nf.Frame(view, position=position, origin=view.position)
    every, crossed = (
        nf.metrics.boundary_mask(frame, center=(0, 0, 0), radius=50, width=1, surfaces=way) for way in (False, True)
    )
    assert every[:14, 18:21].all()
    assert not crossed[:12].any()
    floor = crossed[15:]
    assert floor.any(axis=0).all()
    np.testing.assert_array_equal(every[18:], crossed[18:])
