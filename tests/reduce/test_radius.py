"""The morph's radius of a single frame, against a reduction with that radius, and the reported fold margin."""

from __future__ import annotations

import math
import warnings
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar._reduce.drawing import Method, MorphKind
from tests.support.gpu_cases import edges
from tests.support.growth_cases import AHEAD, CAR, KINDS, USER, reduced
from tests.support.reduce_cases import ALL, CENTER, R1, R2, camera, rho


def agree(frame: nf.Frame, expected: nf.Frame, *, pixels: int = 0) -> None:
    """Assert that pixels show the same objects; at silhouettes, some pixels may differ."""
    inner = ~edges(expected.require("object_id"))
    differ = (frame.require("object_id") != expected.require("object_id")) & inner
    assert differ.sum() <= pixels
    same = inner & ~differ & (expected.require("object_id") >= 0)
    assert same.mean() > 0.3
    np.testing.assert_allclose(frame.require("range")[same], expected.require("range")[same], rtol=1e-2)
    close = np.abs(frame.require("color")[same] - expected.require("color")[same]).max(axis=-1)
    assert np.quantile(close, 0.99) < 0.02


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize(
    ("methods", "radius"), [(("exact",), 12.0), (("vertex", "exact"), 25.0), (("vertex", "exact"), 41.0)]
)
def test_a_smaller_radius_equals_a_reduction_with_it(
    kind: MorphKind, methods: tuple[Method, ...], radius: float
) -> None:
    """A reduction with that radius, whose far part is traced from the centre, gives the same picture."""
    settings: dict[str, Any] = {"channels": ALL, "env": False, "tolerance_px": 0.25}
    with warnings.catch_warnings():
        # A user 6 m from the axis folds a morph of 12 m.
        warnings.simplefilter("ignore")
        whole = reduced(kind)
        frames = [whole.render(camera(USER, AHEAD), radius=radius, method=method, **settings) for method in methods]
        expected = reduced(kind, radius).render(camera(USER, AHEAD), method="exact", **settings)
    beyond = rho(expected.require("position")) > radius
    assert (beyond & (rho(expected.require("position")) < R2)).sum() > 100
    for frame in frames:
        agree(frame, expected, pixels=0 if radius == 12.0 else 10)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("method", ["vertex", "exact"])
def test_radius_zero_shows_everything_from_the_centre(kind: MorphKind, method: Method) -> None:
    whole = reduced(kind)
    frame = whole.render(camera(USER, AHEAD), radius=0.0, method=method, channels=ALL, env=False)
    truth = nf.render(whole.scene, camera(CENTER, AHEAD), channels=ALL)
    inner = ~edges(truth.require("object_id"))
    differ = (frame.require("object_id") != truth.require("object_id")) & inner
    assert differ.sum() <= 3
    same = inner & ~differ
    np.testing.assert_allclose(frame.require("color")[same], truth.require("color")[same], atol=2e-3)
    if kind == "blend":
        np.testing.assert_allclose(frame.require("range")[same], truth.require("range")[same], rtol=1e-3)
    assert frame.stats["fold_margin"] == math.inf
    assert frame.stats["opposed_directions"] == 0


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("method", ["vertex", "exact"])
def test_the_whole_radius_is_the_default(kind: MorphKind, method: Method) -> None:
    whole = reduced(kind)
    frames = [
        whole.render(camera(USER, AHEAD), radius=radius, method=method, channels=ALL[:2]) for radius in (None, R2)
    ]
    for channel in ALL[:2]:
        np.testing.assert_array_equal(frames[0].require(channel), frames[1].require(channel))


@pytest.mark.parametrize("kind", KINDS)
def test_the_picture_is_continuous_in_the_radius(kind: MorphKind) -> None:
    """Points move by less than a pixel for a small step of the radius, so that no step causes a jump."""
    whole = reduced(kind)
    points = whole.scene.triangles().reshape(-1, 3).astype(np.float64) + whole.scene.origin
    points = points[(rho(points) < R2) & (rho(points) > 10.0)]
    view = camera(USER, AHEAD)
    shown = []
    for radius in np.linspace(30.0, R2, 201):
        moved = nf.morph(points, user=USER, center=CENTER, r1=R1 * radius / R2, r2=float(radius), kind=kind)
        shown.append(view.project(moved)[:, :2])
    inside = np.isfinite(shown).all(axis=(0, 2))
    assert inside.sum() > 3
    assert np.abs(np.diff(np.array(shown)[:, inside], axis=0)).max() < 1.0


def test_the_conventional_method_has_no_radius() -> None:
    with pytest.raises(ValueError, match="radius: expected None without a morph"):
        reduced("none").render(camera(USER, AHEAD), radius=20.0)


@pytest.mark.parametrize("kind", KINDS)
def test_frames_report_the_fold_margin(kind: MorphKind) -> None:
    whole = reduced(kind)
    for step in (0.0, 3.0, 8.0):
        user = CENTER + np.array([step, 0.2, 0.0])
        expected = nf.fold_margin(user, center=CENTER, r1=R1, r2=R2, kind=kind)
        frame = whole.render(camera(user, AHEAD))
        assert frame.stats["fold_margin"] == pytest.approx(expected, abs=0.01)
    half = whole.render(camera(USER, AHEAD), radius=R2 / 2)
    expected = nf.fold_margin(USER, center=CENTER, r1=R1 / 2, r2=R2 / 2, kind=kind)
    assert half.stats["fold_margin"] == pytest.approx(expected, abs=0.01)
    assert reduced("none").render(camera(USER, AHEAD)).stats["fold_margin"] == math.inf


def test_a_folded_picture_is_reported_once() -> None:
    whole = reduced("blend")
    away = camera(CENTER + np.array([22.0, 0.0, 0.0]), AHEAD)
    with pytest.warns(UserWarning, match="the picture folds: the user is 2.* m beyond the fold margin"):
        whole.render(away)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        folded = whole.render(away)
        whole.at(CAR).render(away)
    assert folded.stats["fold_margin"] < -2.0


def test_auto_bends_rays_only_where_vertices_fold() -> None:
    whole = reduced("blend")
    steps: dict[float, Method] = {5.0: "vertex", 22.0: "exact"}
    for step, method in steps.items():
        view = camera(CENTER + np.array([step, 0.0, 0.0]), AHEAD)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            auto, told = whole.render(view, channels=ALL[:2]), whole.render(view, method=method, channels=ALL[:2])
        np.testing.assert_array_equal(auto.require("color"), told.require("color"))
        assert auto.stats == told.stats
        # If rays cannot be bent, vertices are moved.
        for cause in ({"user": view.position + np.array([0.03, 0, 0])}, {"t_max": 500.0}, {"tolerance_px": math.inf}):
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                auto, told = (whole.render(view, method=name, **cause) for name in ("auto", "vertex"))
            np.testing.assert_array_equal(auto.require("color"), told.require("color"))
