"""Curves refitted to another statistic of the same views: result, record, and that nothing is rendered."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar.lod._measure import statistic
from tests.support.leveled_cases import model_of
from tests.support.lod_cases import SMALL, assert_same, count_renders, levels

pytestmark = pytest.mark.usefixtures("fresh_cache")

WHOLE: dict[str, Any] = SMALL | {"views": 24, "distances": 6, "step": None, "saturated": None}


@pytest.fixture(scope="module")
def model() -> nf.lod.LodModel:
    return nf.lod.measure(levels(20, 12, 8, 5), **WHOLE, cache=False)


@pytest.mark.parametrize("percentile", [0, 37.5, 100, "mean"])
def test_refitting_equals_a_new_measurement_without_rendering(
    percentile: Any, model: nf.lod.LodModel, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert model.levels is not None
    counted = count_renders(monkeypatch)
    other = model.refit(percentile)
    assert counted == []
    truth = nf.lod.measure(model.levels, **WHOLE, percentile=percentile, cache=False)
    assert counted
    assert_same(other, truth)
    assert other.levels is model.levels
    assert other.measured["percentile"] == truth.measured["percentile"] == percentile
    assert (model.curves.a != other.curves.a).any()
    assert_same(other.refit(25), model)


def test_percentiles_and_means_are_those_of_the_views(model: nf.lod.LodModel) -> None:
    assert model.samples is not None
    views = model.samples.views
    assert views is not None
    for percentile in (0, 5, 50):
        found = model.refit(percentile).samples
        assert found is not None
        expected = np.percentile(views.astype(np.float64), percentile, axis=2, method="averaged_inverted_cdf")
        np.testing.assert_array_equal(found.score, expected)
    mean = model.refit("mean").samples
    assert mean is not None
    np.testing.assert_allclose(mean.score, views.astype(np.float64).mean(axis=2), rtol=1e-15)
    np.testing.assert_array_equal(mean.views, views)


def test_refitting_keeps_levels_and_sizes() -> None:
    own = levels(40, 38, 36, 10)
    model = nf.lod.measure(own, **SMALL | {"distances": 8}, step=0.3, saturated=0.95)
    other = model.refit("mean")
    assert model.samples is not None
    assert other.samples is not None
    assert np.isnan(model.samples.score).any()
    np.testing.assert_array_equal(np.isnan(other.samples.score), np.isnan(model.samples.score))
    np.testing.assert_array_equal(other.triangles, model.triangles)
    assert len(other) < 4
    # Beyond the measured sizes of a level, its curve stays at the last score of the new statistic.
    least = np.array([[row[size:].min() for size in range(8)] for row in other.samples.filled[1:]])
    refitted = nf.lod.fit_4pl(other.samples.sigma, least)
    fitted = refitted.status != "flat"
    np.testing.assert_array_equal(other.curves.a[fitted], refitted.a[fitted])


def test_the_record_names_the_statistic_that_chose_levels(tmp_path: Path) -> None:
    model = nf.lod.measure(levels(12, 6), **SMALL)
    other = model.refit(5).refit("mean")
    assert (other.measured["percentile"], other.measured["chosen_by"]) == ("mean", 25.0)
    assert "chosen_by" not in model.measured
    other.save(tmp_path / "model.json")
    read = nf.lod.LodModel.load(tmp_path / "model.json")
    assert_same(read, other)
    assert read.measured == other.measured
    assert_same(read.refit(25), model)


def test_models_without_the_scores_of_views_are_refused() -> None:
    model = nf.lod.measure(levels(12, 6), **SMALL)
    assert model.samples is not None
    for samples in (None, replace(model.samples, views=None)):
        with pytest.raises(ValueError, match=r"model: expected the scores of single views .* in 'ball'"):
            replace(model, samples=samples).refit(5)
    with pytest.raises(ValueError, match="model: expected the scores of single views"):
        model_of((2, 1)).refit("mean")


def test_one_level_has_no_curve_to_refit() -> None:
    model = nf.lod.measure(levels(8), **SMALL)
    assert_same(model.refit("mean"), model)


def test_flat_curves_do_not_exceed_measured_scores() -> None:
    rows = np.array([[0.87, 0.93, 0.95, 0.94], [0.6, 0.8, 0.93, 0.98]])
    fitted = nf.lod.fit_4pl(np.array([0.18, 0.06, 0.03, 0.02]), rows)
    assert fitted.status[0] == "flat"
    cautious = statistic.cautious(fitted, rows)
    assert (cautious.a[0], cautious.d[0]) == (0.87, 0.87)
    np.testing.assert_array_equal([*cautious[1]], [*fitted[1]])
