"""Levels kept by a measurement, how far it measures them, and measurements without rendering."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from nearfar.lod._measure import statistic, views as level_views
from nearfar.lod._measure.one_object import coarsest_of_steps
from nearfar.lod._measure.score_table import ScoreTable
from tests.support.lod_cases import FOV, SMALL, ball, count_renders, levels, scene

pytestmark = pytest.mark.usefixtures("fresh_cache")


def test_each_step_keeps_its_coarsest_level() -> None:
    assert coarsest_of_steps(np.array([1.0, 0.99, 0.96, 0.93, 0.80]), 0.05) == [0, 2, 3, 4]
    assert coarsest_of_steps(np.array([1.0, 0.95, 0.90, 0.85]), 0.05) == [0, 1, 2, 3]  # at a step is above it
    assert coarsest_of_steps(np.array([1.0, 0.7, 0.9, 0.5]), 0.05) == [0, 2, 3]  # Coarser and better.
    assert coarsest_of_steps(np.array([1.0, 1.0, 1.0]), 0.05) == [0, 2]
    assert coarsest_of_steps(np.array([1.0, -0.2]), 0.05) == [0, 1]
    random = np.random.default_rng(0)
    for _ in range(200):
        found = np.concatenate([[1.0], random.uniform(-0.1, 1, random.integers(1, 9))])
        kept = {0}
        for n in range(1, 30):
            above = [k for k in range(1, len(found)) if found[k] >= 1 - 0.05 * n]
            kept |= {max(above)} if above else set()
        assert coarsest_of_steps(found, 0.05) == sorted(kept)


def test_dropped_levels_are_not_measured_further(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(level_views, "MIN_SUBSET", 1)
    own, how = levels(40, 38, 36, 10), SMALL | {"distances": 7, "saturated": None}
    model = nf.lod.measure(own, **how, step=0.3)
    whole = nf.lod.measure(own, **how, step=None, cache=False)
    assert model.samples is not None
    assert whole.samples is not None
    kept = [list(whole.triangles).index(count) for count in model.triangles]
    assert len(kept) < 4
    assert set(kept) == {0}.union(*(coarsest_of_steps(whole.samples.score[:, size], 0.3) for size in range(4)))
    assert model.levels is not None
    assert [level.triangle_count for level in model.levels] == list(model.triangles)
    np.testing.assert_array_equal(model.errors, whole.errors[kept])
    known = ~np.isnan(model.samples.score)
    np.testing.assert_array_equal(model.samples.score[known], whole.samples.score[kept][known])
    left = model.measured["left_out"]
    assert [one["triangles"] for one in left] == [n for n in whole.triangles if n not in model.triangles]
    # Levels that cannot be kept are rendered in one view at the first four distances.
    assert whole.measured["scores"] == 8 * 7 * 3
    assert whole.measured["renders"] == 8 * 7 * 4
    assert model.measured["scores"] == 8 * 7 * (len(kept) - 1) + 4 * (4 - len(kept))
    assert all(one["score"] is None for one in left)
    for one in (model, whole):
        done = one.measured
        assert done["scores"] + done["cached"] + done["skipped"] == 3 * 7 * 8


@pytest.mark.parametrize("saturated", [None, 0.9])
def test_kept_levels_equal_those_from_all_scores(saturated: float | None, monkeypatch: pytest.MonkeyPatch) -> None:
    random = np.random.default_rng(0)
    own, skipped = levels(8, 7, 6, 5, 4), 0
    how: dict[str, Any] = SMALL | {"views": 96, "distances": 6, "saturated": saturated, "cache": False}
    for _ in range(12):
        # Scores fall with levels, but now and then a coarser one scores more, and SSIM dips at smaller sizes.
        fall = np.cumsum(random.uniform(-0.02, 0.04, (5, 6)), axis=0)
        true = np.clip(1 - fall[:, :, None] - random.uniform(0, 0.05, (5, 6, 96)), 0, 1)
        true[0] = 1.0

        def fill(
            table: ScoreTable, size: int, numbers: list[int], among: Any = None, true: NDArray[np.float64] = true
        ) -> None:
            rows = np.ix_(np.array(numbers, int), np.array([size - 1]), np.arange(96) if among is None else among)
            table.is_used[rows] = True
            table.scores[rows] = true[rows]

        monkeypatch.setattr(ScoreTable, "fill", fill)
        model = nf.lod.measure(own, **how, step=0.05)
        whole = nf.lod.measure(own, **how, step=None)
        assert model.samples is not None
        assert whole.samples is not None
        # After a level equals the base twice, it counts as the base at smaller sizes.
        scores = np.where(np.isnan(whole.samples.score), 1.0, whole.samples.score)
        kept = sorted({0}.union(*(coarsest_of_steps(scores[:, size], 0.05) for size in range(4))))
        assert list(model.triangles) == list(whole.triangles[kept])
        np.testing.assert_array_equal(model.samples.score, whole.samples.score[kept])
        skipped += 96 * 4 * 6 - model.measured["scores"]
    assert skipped > 12 * 96


def test_levels_equal_to_the_base_are_not_measured_further() -> None:
    vertices, faces = ball(12)
    moved = nf.Scene.from_arrays(vertices + 5e-5 * np.sin(7 * vertices), faces)
    own = nf.lod.Levels([nf.lod.Level(scene=scene(12)), nf.lod.Level(scene=moved), nf.lod.Level(scene=scene(6))])
    options: dict[str, Any] = SMALL | {"distances": 8, "step": None, "cache": False}
    model = nf.lod.measure(own, **options)
    whole = nf.lod.measure(own, **options, saturated=None)
    assert model.samples is not None
    assert whole.samples is not None
    assert np.isnan(whole.samples.score).sum() == 0
    missing = np.isnan(model.samples.score)
    assert missing[1, 2:].all()
    assert not missing[2].any()
    assert model.measured["scores"] < whole.measured["scores"]
    # The score stays at its last measured value: at least 0.999, and so within 0.001 of the omitted ones.
    sigma = np.geomspace(*model.sigma, 50)
    np.testing.assert_allclose(model.curves(sigma), whole.curves(sigma), rtol=0, atol=1e-3)
    np.testing.assert_array_equal(model.samples.filled[1, 2:], model.samples.score[1, 1])


def test_one_level_needs_no_rendering(monkeypatch: pytest.MonkeyPatch) -> None:
    counted = count_renders(monkeypatch)
    model = nf.lod.measure(levels(12), hmd=nf.hmd.VIVE_PRO)
    assert counted == []
    assert (model.measured["renders"], model.measured["scores"], model.measured["skipped"]) == (0, 0, 0)
    assert len(model) == 1
    assert len(model.curves) == 0
    assert model.samples is not None
    np.testing.assert_array_equal(model.samples.score, np.ones((1, 16)))


def test_repeated_measurements_need_no_rendering(monkeypatch: pytest.MonkeyPatch) -> None:
    counted = count_renders(monkeypatch)
    own = nf.lod.Levels([nf.lod.Level(scene=scene(12)), nf.lod.Level(scene=scene(12))])
    model = nf.lod.measure(own, **SMALL)
    assert counted == []
    assert model.samples is not None
    np.testing.assert_array_equal(model.samples.score, 1.0)
    assert list(model.curves.status) == ["flat"]
    np.testing.assert_array_equal(model.curves([0.01, 0.1]), 1.0)


def test_few_distances_give_no_curve() -> None:
    model = nf.lod.measure(levels(12, 6), **SMALL | {"distances": 2})
    assert list(model.curves.status) == ["unfittable"]
    assert "4 different x" in model.curves.reason[0]
    assert model.samples is not None
    assert np.isfinite(model.samples.score).all()
    with pytest.raises(ValueError, match="size: expected at least 11 pixels, SSIM's window, got 11 × 10"):
        nf.lod.measure(levels(8, 4), fov=FOV, size=(11, 10))


def test_an_object_may_be_smaller_than_a_pixel() -> None:
    model = nf.lod.measure(levels(8, 4), fov=FOV, size=(11, 11), views=4, distances=3, saturated=None)
    assert model.samples is not None
    assert np.isfinite(model.samples.score).all()


def test_views_end_at_the_standard_error(monkeypatch: pytest.MonkeyPatch) -> None:
    random = np.random.default_rng(1)
    true = np.ones((3, 6, 144))
    # The spread of single views, from which the error of a quantile follows: 12 views suffice for the first half.
    true[1:] = 0.9 - random.uniform(0, 1, (2, 6, 144)) * np.array([0.01, 0.01, 0.01, 0.4, 0.4, 0.4])[:, None]

    def fill(table: ScoreTable, size: int, numbers: list[int], among: Any = None) -> None:
        rows = np.ix_(np.array(numbers, int), np.array([size - 1]), np.arange(144) if among is None else among)
        table.is_used[rows] = True
        table.scores[rows] = true[rows]

    monkeypatch.setattr(ScoreTable, "fill", fill)
    how: dict[str, Any] = SMALL | {"views": 144, "distances": 6, "step": None, "saturated": None, "cache": False}
    full = nf.lod.measure(levels(8, 7, 6), **how)
    quick = nf.lod.measure(levels(8, 7, 6), **how | {"standard_error": 0.02})
    assert full.samples is not None
    assert quick.samples is not None
    assert full.samples.views is not None
    assert quick.samples.views is not None
    assert np.isfinite(full.samples.views).all()
    counts = np.isfinite(quick.samples.views[1:]).sum(axis=2)
    assert (counts[:, :3] == 12).all()
    assert (counts[:, 3:] > 12).all()
    assert (counts[:, 3:] < 144).all()
    # Four standard errors.
    np.testing.assert_allclose(quick.samples.score, full.samples.score, rtol=0, atol=0.08)
    assert quick.measured["scores"] == counts.sum()


@pytest.mark.parametrize("percentile", [25.0, 75.0, "mean"])
def test_standard_errors_are_those_of_random_subsets(percentile: Any) -> None:
    random = np.random.default_rng(2)
    views = random.normal(0.8, 0.05, 144)
    subsets = np.array([random.permutation(views)[:36] for _ in range(2000)])
    spread = statistic.of_views(subsets, percentile).std()
    assert statistic.standard_errors(subsets, percentile, 144).mean() == pytest.approx(spread, rel=0.35)
    assert statistic.standard_errors(views[None], percentile, 144) == 0
