"""Metrics of pictures, against slow definitions written down and against scikit-image."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

import nearfar as nf
from support import need, printed_by_threads
from test_reduce import CENTER, R1, R2, camera, street

Array = NDArray[np.float64]


def pictures(height: int = 37, width: int = 53) -> tuple[Array, Array]:
    """Two smooth pictures in 0..1 that differ a little, without random numbers."""
    y, x = np.mgrid[:height, :width].astype(np.float64)
    first = 0.5 + 0.3 * np.sin(0.31 * x + 0.02 * x * y) + 0.2 * np.cos(0.23 * y)
    return first, np.clip(first + 0.05 * np.sin(1.7 * x - 0.9 * y), 0, 1)


def slow_ssim(a: Array, b: Array, weights: Array, extent: float) -> Array:
    """Wang et al. 2004, Eq. 13, window by window, pictures mirrored at their borders."""
    size = len(weights)
    before = size // 2
    pads = [(before, size - 1 - before)] * 2
    padded = [np.pad(picture, pads, mode="symmetric") for picture in (a, b)]
    window = np.outer(weights, weights)
    c1, c2 = (0.01 * extent) ** 2, (0.03 * extent) ** 2
    out = np.empty_like(a)
    for i, j in np.ndindex(*a.shape):
        x, y = (picture[i : i + size, j : j + size] for picture in padded)
        mx, my = (window * x).sum(), (window * y).sum()
        vx, vy = (window * (x - mx) ** 2).sum(), (window * (y - my) ** 2).sum()
        cov = (window * (x - mx) * (y - my)).sum()
        out[i, j] = (2 * mx * my + c1) * (2 * cov + c2) / ((mx**2 + my**2 + c1) * (vx + vy + c2))
    return out


@pytest.mark.parametrize(("window", "size"), [("gaussian", 11), ("gaussian", 10), ("uniform", 7), ("uniform", 4)])
def test_ssim_is_its_definition(window: str, size: int) -> None:
    a, b = pictures(23, 29)
    offsets = np.arange(size) - (size - 1) / 2
    weights = np.exp(-0.5 * (offsets / 1.5) ** 2) if window == "gaussian" else np.ones(size)
    expected = slow_ssim(a, b, weights / weights.sum(), 1.0)
    mean, found = nf.ssim(a, b, data_range=1, window=window, size=size, full=True)
    # Second moments of values in 0..1 cancel to 1e-16, over c2 = 9e-4.
    np.testing.assert_allclose(found, expected, atol=1e-12)
    before = size // 2
    inner = expected[before : 23 - (size - 1 - before), before : 29 - (size - 1 - before)]
    assert mean == pytest.approx(inner.mean(), abs=1e-13)


def test_the_global_window_is_the_whole_picture() -> None:
    a, b = pictures()
    c1, c2 = 1e-4, 9e-4
    covariance = ((a - a.mean()) * (b - b.mean())).mean()
    expected = (2 * a.mean() * b.mean() + c1) * (2 * covariance + c2)
    expected /= (a.mean() ** 2 + b.mean() ** 2 + c1) * (a.var() + b.var() + c2)
    assert nf.ssim(a, b, data_range=1, window="global") == pytest.approx(expected, abs=1e-13)


@pytest.mark.parametrize("channels", [0, 3])
def test_ssim_and_psnr_are_scikit_images(channels: int) -> None:
    need("skimage")
    from skimage.metrics import peak_signal_noise_ratio, structural_similarity

    a, b = pictures()
    if channels:
        a, b = (np.stack([p, p**2, 1 - p], axis=-1) for p in (a, b))
    common: dict[str, Any] = {"data_range": 1.0, "full": True, "use_sample_covariance": False}
    axis = {"channel_axis": -1} if channels else {}
    options: list[tuple[dict[str, Any], dict[str, Any]]] = [
        ({"window": "gaussian"}, {"gaussian_weights": True, "sigma": 1.5}),
        ({"window": "uniform", "size": 7}, {"win_size": 7}),
    ]
    for ours, theirs in options:
        mean, found = nf.ssim(a, b, data_range=1, full=True, **ours)
        expected_mean, expected = structural_similarity(a, b, **common, **axis, **theirs)
        assert abs(mean - expected_mean) < 1e-12
        np.testing.assert_allclose(found, expected, rtol=0, atol=1e-10)
    assert nf.psnr(a, b, data_range=1) == pytest.approx(peak_signal_noise_ratio(a, b, data_range=1), abs=1e-10)


def test_equal_pictures_are_exactly_alike() -> None:
    a, b = pictures()
    for window in ("gaussian", "uniform", "global"):
        assert nf.ssim(a, a, data_range=1, window=window) == 1.0
        assert nf.ssim(a, b, data_range=1, window=window) == nf.ssim(b, a, data_range=1, window=window) < 1.0
    assert nf.psnr(a, a, data_range=1) == math.inf
    assert nf.rmse(a, a) == 0.0
    assert nf.rmse(a, b) == pytest.approx(np.sqrt(np.mean((a - b) ** 2)), rel=1e-13)


def test_masks_choose_what_counts() -> None:
    a, b = pictures()
    mask = np.zeros(a.shape, bool)
    mask[10:20, 15:30] = True
    _, found = nf.ssim(a, b, data_range=1, full=True)
    assert nf.ssim(a, b, data_range=1, mask=mask) == pytest.approx(found[mask].mean(), abs=1e-15)
    with pytest.raises(ValueError, match="mask"):
        nf.ssim(a, b, data_range=1, mask=np.zeros(a.shape))
    with pytest.raises(ValueError, match="mask"):
        nf.ssim(a, b, data_range=1, mask=mask[1:])


def test_eight_bits_and_frames_are_taken_as_they_are() -> None:
    a, b = (np.round(255 * p).astype(np.uint8) for p in pictures())
    assert nf.psnr(a, b, data_range=255) == pytest.approx(nf.psnr(a / 255, b / 255, data_range=1), abs=1e-10)
    view = camera(CENTER, (1, 0, 0))
    frame = nf.render(street(), view, channels=("color",))
    assert nf.ssim(frame, frame) == 1.0
    assert nf.psnr(frame, frame) == math.inf
    with pytest.raises(TypeError, match="two frames or two arrays"):
        nf.rmse(frame, a)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda a, b: nf.ssim(a, b), "data_range: expected"),
        (lambda a, b: nf.psnr(a, b), "data_range: expected"),
        (lambda a, b: nf.psnr(a, b, data_range=0), "data_range"),
        (lambda a, b: nf.ssim(a, b[1:], data_range=1), "test: expected shape"),
        (lambda a, b: nf.rmse(a[:0], b[:0]), "at least one value"),
        (lambda a, b: nf.rmse(a * np.nan, b), "reference"),
        (lambda a, b: nf.ssim(a, b, data_range=1, window="box"), "window"),
        (lambda a, b: nf.ssim(a, b, data_range=1, size=0), "size"),
        (lambda a, b: nf.ssim(a, b, data_range=1, sigma=0), "sigma"),
        (lambda a, b: nf.ssim(a[0], b[0], data_range=1), "reference: expected shape"),
    ],
)
def test_refuses_what_cannot_be_compared(call: Any, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        call(*pictures())


def slow_discontinuity(frame: nf.Frame, epsilon: float, least: float) -> Array:
    """Eq. 5–6, every pixel against every other."""
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
    """Truth, conventional and continuous picture from 7 m beside the centre."""
    scene = street()
    reduced = nf.reduce(scene, center=CENTER, r1=R1, r2=R2, face_size=256, samples=1, channels=("color", "range"))
    view = camera(CENTER + np.array([0, 0.2, 7.0]), (1, -0.03, 0.1), (96, 60))
    wanted = ("color", "position")
    return {
        "truth": nf.render(scene, view, channels=wanted),
        "conventional": reduced.with_morph("none").render(view, channels=wanted),
        "continuous": reduced.render(view, channels=wanted),
    }


@pytest.mark.parametrize("name", ["truth", "conventional", "continuous"])
@pytest.mark.parametrize(("epsilon", "least"), [(17.03, 1.0), (3.1, 0.25), (200.3, 5.0)])
def test_discontinuity_is_its_definition(frames: dict[str, nf.Frame], name: str, epsilon: float, least: float) -> None:
    expected = slow_discontinuity(frames[name], epsilon, least)
    found = nf.discontinuity(frames[name], epsilon=epsilon, min_distance=least)
    np.testing.assert_array_equal(np.isnan(found), np.isnan(expected))
    # Points whose distance is ε to float32 may count or not: one of some hundred neighbours. Whole numbers would be
    # the distances of all pixels that are not moved, so ε is none.
    np.testing.assert_allclose(found, expected, rtol=2e-4, atol=2e-3)


def test_the_truth_is_whole(frames: dict[str, nf.Frame]) -> None:
    # Positions on triangles of 4,000 m are rounded to 2.4e-4 m, which 5 m away is 2e-3 px of the 96 across 90 degrees.
    assert np.nanmax(np.abs(nf.discontinuity(frames["truth"]))) < 2e-3


def test_walls_are_torn_at_the_boundary_by_the_conventional_method_alone() -> None:
    channels = ("color", "range")
    reduced = nf.reduce(street(ground=False), center=CENTER, r1=R1, r2=R2, face_size=256, samples=1, channels=channels)
    view = camera(CENTER + np.array([0, 0.2, 7.0]), (1, 0.0, -0.5), (320, 200))
    torn = {}
    for morph in ("none", "blend"):
        frame = reduced.with_morph(morph).render(view, channels=("position",))
        edge = nf.boundary(frame, center=CENTER, radius=R2)
        assert edge.sum() > 50
        torn[morph] = float(np.nanmean(np.abs(nf.discontinuity(frame)[edge])))
    # The wall recedes, so that the morph shears it between the radii, which counts as discontinuity too.
    assert torn["none"] > 5 * torn["blend"]


def test_pixels_without_a_surface_or_neighbours_have_none(frames: dict[str, nf.Frame]) -> None:
    sky = np.isnan(frames["truth"].require("position")[..., 0])
    assert sky.any()
    np.testing.assert_array_equal(np.isnan(nf.discontinuity(frames["truth"])), sky)
    behind = nf.Camera.look_at((0, 2, 0), (-1, 2, 0), fov=nf.Fov.symmetric(20, 1), size=(8, 8))
    view = nf.Camera.look_at((0, 2, 0), (1, 2, 0), fov=nf.Fov.symmetric(20, 1), size=(8, 8))
    seen = nf.render(street(), view, channels=("position",))
    assert np.isnan(nf.discontinuity(seen, behind)).all()
    assert np.isnan(nf.discontinuity(seen, epsilon=1e-3)).all()
    with pytest.raises(ValueError, match="position"):
        nf.discontinuity(nf.render(street(), view, channels=("color",)))
    with pytest.raises(TypeError, match="frame"):
        nf.discontinuity(np.zeros((3, 3)))  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="epsilon"):
        nf.discontinuity(seen, epsilon=0)


@given(st.lists(st.tuples(st.integers(-1, 5), st.integers(-1, 5)), min_size=1, max_size=60))
def test_object_completion_is_its_definition(pairs: list[tuple[int, int]]) -> None:
    reference, test = (np.array(ids, np.int32) for ids in zip(*pairs, strict=True))
    wanted = [o for o in range(6) if (reference == o).any()]
    found = nf.object_completion(reference, test)
    if not wanted:
        assert all(math.isnan(value) for value in found)
        return
    counts = [(int((reference == o).sum()), int((test == o).sum())) for o in wanted]
    assert found[0] == pytest.approx(np.mean([here > 0 for _, here in counts]))
    assert found[1] == pytest.approx(np.mean([min(here, there) / there for there, here in counts]))


BITS = """
import hashlib
import numpy as np
import nearfar as nf
from test_metrics import pictures
from test_reduce import CENTER, camera, street
a, b = pictures(301, 203)
frame = nf.render(street(), camera(CENTER, (1, -0.1, 0.2), (320, 200)), channels=("position",))
parts = [nf.rmse(a, b), nf.ssim(a, b, data_range=1), nf.discontinuity(frame).tobytes()]
print(hashlib.sha256(repr(parts).encode()).hexdigest())
"""


def test_bits_do_not_depend_on_the_number_of_threads() -> None:
    assert len(set(printed_by_threads(BITS))) == 1
