"""Scores that fall and rise again as an object shrinks: thresholds, budgets, and the sizes of a measurement."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar.lod._measure.views import Screen
from tests.support import data, need
from tests.support.lod_cases import FOV, SMALL, levels
from tests.support.lod_oracle import model

AWAY = np.geomspace(1.5, 1000, 500)
VIEW = nf.Camera((0, 0, 0), fov=FOV, size=(2000, 2000))
DIP = np.array([0.899, 0.826, 0.805, 0.818, 0.85, 0.88, 0.9, 0.913])
"""SSIM of a level of the duck that is drawn 660 to 15 pixels wide."""


def dipping() -> nf.lod.LodModel:
    """Return a model of levels whose SSIM has its minimum between the largest and the smallest size."""
    sigma = np.geomspace(0.3, 1e-5, 8)
    score = np.stack([np.ones(8), DIP + 0.07, DIP, DIP - 0.1])
    views = np.repeat(score[..., None], 4, axis=2).astype(np.float32)
    plain = model(np.ones((3, 4)).tolist(), (1e-5, 0.3))
    return replace(plain, samples=nf.lod.Samples(sigma, score, views)).refit("mean")


def select_over_distance(one: nf.lod.LodModel, **rules: Any) -> nf.lod.Selection:
    centers = np.stack([0 * AWAY, 0 * AWAY, -AWAY], axis=1)
    return nf.lod.select([one], np.zeros(500, int), centers, np.ones(500), camera=VIEW, full=True, **rules)


@pytest.mark.parametrize("d", [0.75, 0.8, 0.85, 0.88, 0.9, 0.95])
def test_levels_never_get_finer_as_an_object_shrinks(d: float) -> None:
    rising = model([(0.95, 1.0, 0.01, 0.99), (0.86, 1.0, 0.001, 0.92), (0.7, 2.0, 0.001, 0.9)], (1e-4, 0.3))
    for one in (dipping(), rising):
        found = select_over_distance(one, d=d)
        assert (np.diff(found.level) >= 0).all()
        sizes = nf.lod.switches(one, view=VIEW, d=d)
        expected = [max((n for n in range(1, 4) if z >= sizes.distance[n]), default=0) for z in AWAY]
        assert found.level.tolist() == expected


def test_a_curve_follows_the_least_score_of_all_smaller_sizes() -> None:
    one = dipping()
    assert one.samples is not None
    least = np.array([[row[size:].min() for size in range(8)] for row in one.samples.score[1:]])
    fitted = one.curves(one.samples.sigma)
    np.testing.assert_allclose(fitted, least, rtol=0, atol=0.015)
    assert (np.diff(one.falling_curves(np.geomspace(1e-5, 0.3, 100)), axis=1) <= 0).all()


def test_budgets_follow_scores_that_rise_again() -> None:
    one = dipping()
    assert one.samples is not None
    away = 1 / np.sqrt(one.samples.sigma / np.pi * (1 - one.samples.sigma / (4 * np.pi)))
    centers = np.stack([0 * away, 0 * away, -away], axis=1)
    coarsest = int(one.triangles[-1]) * 8
    spheres = (np.zeros(8, int), centers, np.ones(8))
    found = nf.lod.select([one], *spheres, camera=VIEW, budget=coarsest, full=True)
    assert found.level.tolist() == 8 * [3]
    # One falling curve alone would be off by 0.09 at the largest size.
    np.testing.assert_allclose(found.score, DIP - 0.1, rtol=0, atol=0.015)
    assert found.spent is not None
    weights = one.samples.sigma
    assert found.spent.score == pytest.approx(np.average(found.score, weights=weights), rel=1e-6)


def test_geometric_sizes_reach_from_twice_the_reference_to_4_pixels() -> None:
    screen = Screen.from_arguments(nf.hmd.QUEST_2, None, None)
    sines = np.array(screen.sines("geometric", 16))
    np.testing.assert_allclose(np.diff(np.log(sines)), np.log(sines[-1] / sines[0]) / 15)
    assert sines[0] == pytest.approx(2 * screen.reference_sine)
    assert 2 * sines[-1] / screen.pixel == pytest.approx(4)
    published = nf.lod.MeasureSettings.published(hmd=nf.hmd.QUEST_2)
    assert (published.directions, published.spacing, published.standard_error) == ("published", "published", 0.0)
    wide = Screen.from_arguments(None, nf.Fov.symmetric(150), (128, 128)).sines("geometric", 8)
    assert 1 > wide[0] > wide[-1] > 0
    own = nf.lod.measure(levels(8, 4), **SMALL | {"spacing": "geometric", "distances": 5}, cache=False)
    assert own.sigma[0] < nf.lod.reference_solid_angle(FOV) < own.sigma[1]


@pytest.mark.slow
def test_a_duck_never_gets_finer_with_distance(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = data("objects/gltf/Duck.glb")
    need("fast_simplification")
    monkeypatch.setenv("NEARFAR_CACHE", str(tmp_path / "cache"))
    view: dict[str, Any] = {"fov": nf.hmd.QUEST_2.left.fov, "size": (458, 480)}
    duck = nf.lod.measure(nf.lod.simplify(path), **view, standard_error=0.05, samples=1, backend="cpu")
    assert duck.samples is not None
    coarsest = duck.samples.score[-1]
    assert coarsest.min() < coarsest[-1] - 0.05  # it rises again
    found = select_over_distance(replace(duck, pixel=None))
    assert (np.diff(found.level) >= 0).all()
    assert found.level[0] < found.level[-1]
