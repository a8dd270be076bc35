"""Levels under a budget: against an exact dynamic programme, and the cases of nothing to choose."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from numpy.typing import NDArray

import nearfar as nf
from tests.support import printed_by_threads
from tests.support.lod_budget import VIEW, ahead, crowd, small_models
from tests.support.lod_oracle import model, rotation, usual

Array = NDArray[np.float64]

LENS = nf.RadialLens((0.22, 0.24))


def scores_of(one: nf.lod.LodModel, size: float) -> Array:
    """Return the score of each level at a size (K,); NaN for levels without a curve."""
    least, most = one.sigma
    return np.array([1.0, *(one.curves(np.array([np.clip(size, least, most)]))[:, 0] if len(one) > 1 else ())])


def select_drawn(
    models: list[nf.lod.LodModel], *objects: Any, camera: nf.Camera, draws: Any = None, **keywords: Any
) -> nf.lod.Selection:
    """Select levels by a selector, which takes how often each object is drawn."""
    frame = {name: keywords.pop(name) for name in ("price", "full") if name in keywords}
    return nf.lod.Selector(**keywords).select(models, *objects, camera=camera, draws=draws, **frame)


def best(
    models: list[nf.lod.LodModel], index: Any, sizes: Array, weights: Array, draws: NDArray[np.int64], budget: int
) -> float:
    """Return the greatest Σ w·M of all choices whose Σ draws·triangles is within a budget, by trying all sums."""
    reached = np.full(budget + 1, -np.inf)
    reached[0] = 0.0
    for number, size, weight, times in zip(index, sizes, weights, draws.tolist(), strict=True):
        one = models[number]
        after = np.full(budget + 1, -np.inf)
        for triangles, score in zip((times * one.triangles).tolist(), scores_of(one, size), strict=True):
            if not np.isnan(score) and triangles <= budget:
                after[triangles:] = np.maximum(after[triangles:], reached[: budget + 1 - triangles] + weight * score)
        reached = after
    return float(reached.max())


def edges(one: nf.lod.LodModel, scores: Array) -> list[tuple[float, int]]:
    """Return edges of the upper hull of (triangles, score), from coarse to fine: gain of each, and its triangles."""
    known = np.flatnonzero(~np.isnan(scores))
    found: list[tuple[float, int]] = []
    place = known[-1]
    while True:
        finer = [n for n in known if n < place and scores[n] > scores[place]]
        if not finer:
            return found
        with np.errstate(divide="ignore"):
            slopes = [(scores[n] - scores[place]) / np.float64(one.triangles[n] - one.triangles[place]) for n in finer]
        best_one = finer[int(np.flatnonzero(slopes == np.max(slopes))[0])]
        found.append((scores[best_one] - scores[place], int(one.triangles[best_one] - one.triangles[place])))
        place = best_one


def first_that_fails(parts: list[tuple[float, int]], left: int) -> float:
    """Return the gain of the first step that does not fit, in the order of gain per triangle."""
    with np.errstate(divide="ignore"):
        ordered = sorted(parts, key=lambda part: -np.float64(part[0]) / part[1])
    for gain, triangles in ordered:
        if triangles > left:
            return gain
        left -= triangles
    return 0.0


@given(
    st.integers(0, 2**32 - 1), st.integers(1, 8), st.sampled_from(["object", "pixels", "each"]), st.sampled_from([0, 3])
)
@settings(max_examples=60, deadline=None)
def test_sums_are_within_a_step_of_the_optimum(seed: int, count: int, kind: str, most_draws: int) -> None:
    random = np.random.default_rng(seed)
    models = small_models(random)
    index = random.integers(0, len(models), count)
    centers, radii = ahead(count, seed)
    weight = random.uniform(0, 3, count) * (random.random(count) < 0.8) if kind == "each" else kind
    options: dict[str, Any] = {"camera": VIEW, "lens": LENS, "weight": weight, "full": True}
    draws = random.integers(0, most_draws + 1, count) if most_draws else None
    # An object that is never drawn counts once.
    times = np.ones(count, np.int64) if draws is None else np.maximum(draws, 1)
    least, most = (
        sum(int(models[n].triangles[end]) * time for n, time in zip(index, times, strict=True)) for end in (-1, 0)
    )
    sizes = nf.corrected_solid_angle(centers, radii, camera=VIEW, lens=LENS)
    pixel = (1.9 / 1440) * (2.15 / 1600)
    weights = np.asarray({"object": np.ones(count), "pixels": sizes / pixel}.get(kind, weight), np.float64)
    parts = [
        (weight * gain, time * triangles)
        for n, size, weight, time in zip(index, sizes, weights, times.tolist(), strict=True)
        for gain, triangles in edges(models[n], scores_of(models[n], size))
        if weight > 0
    ]
    for budget in sorted({least, most, most + 100, *random.integers(least, most + 1, 4).tolist()}):
        found = select_drawn(models, index, centers, radii, budget=budget, draws=draws, **options)
        spent = found.spent
        assert spent is not None
        each = np.array([models[n].triangles[level] for n, level in zip(index, found.level, strict=True)])
        reached = [scores_of(models[n], s)[k] for n, s, k in zip(index, sizes, found.level, strict=True)]
        assert spent.triangles == each.sum()
        assert spent.drawn == times @ each <= budget
        np.testing.assert_allclose(found.score, reached, rtol=1e-7)
        total = float(weights @ reached)
        exact = best(models, index, sizes, weights, times, budget)
        assert total <= exact + 1e-9 * abs(exact)
        assert total >= exact - first_that_fails(parts, budget - least) - 1e-6 * abs(exact)
        if weights.sum() > 0:
            assert spent.score == pytest.approx(total / weights.sum(), rel=1e-7)
        if budget >= most:
            assert spent.price == 0.0
            assert total == pytest.approx(exact, rel=1e-9)


def triangles_of(models: list[nf.lod.LodModel], index: Any, levels: Any) -> int:
    return sum(int(models[n].triangles[level]) for n, level in zip(index, levels, strict=True) if level >= 0)


def test_a_larger_budget_is_never_worse_and_is_used() -> None:
    scene = crowd(5000)
    before = -1.0
    for budget in (2_000_000, 4_000_000, 10_000_000, 50_000_000):
        found = nf.lod.select(*scene, camera=VIEW, budget=budget, weight="object", full=True)
        assert found.spent is not None
        assert 0.999 * budget < found.spent.triangles <= budget
        assert found.spent.triangles == triangles_of(scene[0], scene[1], found.level)
        assert found.spent.score == pytest.approx(np.nanmean(found.score), rel=1e-9)
        assert found.spent.score > before
        before = found.spent.score
    assert found.counts["culled"] == (found.level == -1).sum() > 0


def test_levels_at_a_price_lie_on_each_hull() -> None:
    models, index, centers, radii = crowd(4000, 3)
    found = nf.lod.select(models, index, centers, radii, camera=VIEW, budget=3_000_000, weight="object", full=True)
    assert found.spent is not None
    price = found.spent.price
    others = 0
    for n in np.flatnonzero(found.level >= 0):
        one = models[index[n]]
        value = scores_of(one, found.sigma_seen[n]) - price * one.triangles
        # Levels tried one by one after the price may have less.
        others += value[found.level[n]] < value.max() - 1e-9
    assert others < 0.02 * (found.level >= 0).sum()


def test_pixel_weights_favour_large_objects() -> None:
    """They are the default: what fills the picture gets most triangles."""
    scene, budget = crowd(3000, 1), 1_500_000
    plain = nf.lod.select(*scene, camera=VIEW, budget=budget, weight="object", full=True)
    pixels = nf.lod.select(*scene, camera=VIEW, budget=budget, full=True)
    explicit = nf.lod.select(*scene, camera=VIEW, budget=budget, weight="pixels")
    np.testing.assert_array_equal(pixels.level, explicit.level)
    seen = plain.level >= 0
    by_size = [np.average(one.score[seen], weights=one.sigma_seen[seen]) for one in (plain, pixels)]
    assert by_size[1] > by_size[0] + 0.01
    assert plain.spent is not None
    assert pixels.spent is not None
    assert pixels.spent.score == pytest.approx(by_size[1], rel=1e-9)
    assert np.nanmean(plain.score) > np.nanmean(pixels.score)


def test_minimum_levels_hold_if_the_budget_allows() -> None:
    models, index, centers, radii = crowd(2000, 2)
    options: dict[str, Any] = {"camera": VIEW, "full": True}
    options |= {"threshold": "literal", "k": 0.0, "reference": 4.0}
    by_threshold = nf.lod.select(models, index, centers, radii, d=0.8, **options)
    needed = int(1.05 * triangles_of(models, index, by_threshold.level))
    held = nf.lod.select(models, index, centers, radii, d=0.9, floor=0.1, budget=needed, **options)
    plain = nf.lod.select(models, index, centers, radii, d=0.9, budget=needed, **options)
    seen = held.level >= 0
    reached = held.score[seen] >= held.threshold[seen] - 0.1 - 1e-9
    assert (reached | (held.level[seen] == 0)).all()
    assert (plain.score[seen] < plain.threshold[seen] - 0.1).any()
    assert held.spent is not None
    assert plain.spent is not None
    assert held.spent.score <= plain.spent.score
    # The budget is too small for all: no object gets more than its minimum level.
    floors = np.full(len(seen), -1)
    for n in np.flatnonzero(seen):
        floors[n] = np.flatnonzero(scores_of(models[index[n]], held.sigma_seen[n]) >= 0.8)[-1]
    least, enough = triangles_of(models, index, np.where(seen, 7, -1)), triangles_of(models, index, floors)
    for budget in (enough - 1, (least + enough) // 2):
        poor = nf.lod.select(models, index, centers, radii, d=0.9, floor=0.1, budget=budget, **options)
        assert (poor.level[seen] >= floors[seen]).all()
        assert (poor.level[seen] > floors[seen]).any()
    just = nf.lod.select(models, index, centers, radii, d=0.9, floor=0.1, budget=enough, **options)
    assert np.array_equal(just.level[seen], floors[seen])


def test_objects_seen_by_both_eyes_count_once() -> None:
    models, index, centers, radii = crowd(3000, 4)
    other = replace(VIEW, position=(0.7, 1.5, -2.1))
    both = nf.lod.select(models, index, centers, radii, camera=[VIEW, other], budget=2_000_000, full=True)
    alone = nf.lod.select(models, index, centers, radii, camera=[VIEW, VIEW], budget=2_000_000)
    single = nf.lod.select(models, index, centers, radii, camera=VIEW, budget=2_000_000)
    assert np.array_equal(alone, single)
    assert both.spent is not None
    assert both.spent.triangles == triangles_of(models, index, both.level) <= 2_000_000
    sizes = [nf.solid_angle(centers, radii, eye=eye.position) for eye in (VIEW, other)]
    seen = both.level >= 0
    assert (both.sigma_seen[seen] <= np.maximum(*sizes)[seen] * (1 + 1e-12)).all()


def test_selectors_compare_their_weights() -> None:
    weight = np.array([1.0, 2.0])
    one = nf.lod.Selector(budget=9, weight=weight)
    weight[0] = 5.0
    assert one == nf.lod.Selector(budget=9, weight=[1.0, 2.0])
    assert one != nf.lod.Selector(budget=9, weight=weight)
    assert len({one, nf.lod.Selector(budget=9, weight=[1.0, 2.0]), nf.lod.Selector()}) == 2


def test_more_triangles_than_sums_can_hold_are_refused() -> None:
    huge = replace(model([(1, 1, 1, 0.5)]), triangles=np.array([2**62, 2**62 - 1]))
    place = np.tile(VIEW.position + 5 * -rotation(VIEW)[:, 2], (5, 1))
    with pytest.raises(ValueError, match=r"models: expected fewer than 2\^64 triangles in 5"):
        nf.lod.select([huge], np.zeros(5, int), place, 0.5, camera=VIEW, budget=2**62)


def test_no_triangles_are_spent_outside_the_panel() -> None:
    lens, models = nf.RadialLens((-0.2,)), [replace(usual(1), triangles=np.array([9000, 800]))]
    own = np.array([[0.85, -1.05, -1.0], [0.84, -1.04, -1.0], [0.0, 0.0, -1.0], [0.1, 0.0, -1.0]]) * 9
    options: dict[str, Any] = {"camera": VIEW, "lens": lens, "mode": "panel", "weight": "pixels"}
    centers = own @ rotation(VIEW).T + VIEW.position
    found = nf.lod.select(models, np.zeros(4, int), centers, 0.3, budget=4 * 800 + 8200, **options)
    assert found.level[:2].tolist() == [1, 1]
    assert sorted(found.level[2:].tolist()) == [0, 1]


# cases of nothing to choose -------------------------------------------------------------------------------------------
def test_budgets_below_the_coarsest_levels_name_the_minimum() -> None:
    models, index, centers, radii = crowd(500)
    seen = nf.lod.select(models, index, centers, radii, camera=VIEW).level >= 0
    least = sum(int(models[n].triangles[-1]) for n in index[seen])
    found = nf.lod.select(models, index, centers, radii, camera=VIEW, budget=least)
    assert found.spent is not None
    assert (found.level[seen] == 7).all()
    with pytest.raises(ValueError, match=f"budget: expected at least {least} triangles"):
        nf.lod.select(models, index, centers, radii, camera=VIEW, budget=least - 1)
    thrice = np.full(len(index), 3)
    with pytest.raises(ValueError, match=f"budget: expected at least {3 * least} triangles.* counting each draw"):
        select_drawn(models, index, centers, radii, camera=VIEW, budget=3 * least - 1, draws=thrice)


def test_equal_slopes_are_taken_in_the_order_of_objects() -> None:
    one = replace(model([(1.0, 1.0, 0.01, 0.5)]), triangles=np.array([110, 10]))
    place = np.tile(VIEW.position + 5 * -rotation(VIEW)[:, 2], (10, 1))
    found = nf.lod.select([one], np.zeros(10, int), place, 0.5, camera=VIEW, budget=100 + 350)
    assert found.level.tolist() == [0, 0, 0, 1, 1, 1, 1, 1, 1, 1]
    assert found.spent is not None
    assert found.spent.triangles == 400


def test_one_object_stops_between_equal_slopes() -> None:
    scores = np.arange(8)[::-1] / 8
    one = replace(model([(score, 1, 1, score) for score in scores]), triangles=np.arange(9, 0, -1) * 100)
    place = [VIEW.position + 5 * -rotation(VIEW)[:, 2]]
    for budget, level in ((100, 8), (199, 8), (200, 7), (899, 1), (900, 0)):
        assert nf.lod.select([one], [0], place, 0.5, camera=VIEW, budget=budget).level.tolist() == [level]
    held = nf.lod.select([one], [0], place, 0.5, camera=VIEW, budget=650, previous=[3], hysteresis=0.1)
    assert held.level.tolist() == [3]


def test_after_a_large_step_small_steps_fill_the_budget() -> None:
    great, small = (
        replace(model([(low, 1, 1, low)]), triangles=np.array([top, 10])) for top, low in ((10**7, 0.0), (60, 0.5))
    )
    for count in (1000, 2**14, 3 * 2**14):
        place = np.tile(VIEW.position + 5 * -rotation(VIEW)[:, 2], (count + 1, 1))
        index, weight = np.r_[0, np.ones(count, int)], np.r_[1.2e5, np.ones(count)]
        found = nf.lod.select([great, small], index, place, 0.5, camera=VIEW, budget=10 + 60 * count, weight=weight)
        assert found.level.tolist() == [1] + [0] * count


def test_a_large_step_goes_first_if_it_is_worth_more_than_those_before_it() -> None:
    great, small = (
        replace(model([(low, 1, 1, low)]), triangles=np.array([top, 10])) for top, low in ((1000, 0.2), (20, 0.5))
    )
    place = np.tile(VIEW.position + 5 * -rotation(VIEW)[:, 2], (11, 1))
    index, frames = np.r_[0, np.ones(10, int)], dict[str, Any]()
    # The large step gains 0.8 times its weight, the ten others 5; near the tie the hysteresis keeps the choice.
    for weight, level in ((4, 1), (5.7, 1), (5.6, 1), (7, 0), (5.7, 0), (5.6, 0), (5.0, 1)):
        options = {"budget": 110 + 1000, "weight": np.r_[weight, np.ones(10)], "hysteresis": 0.1, **frames}
        found = nf.lod.select([great, small], index, place, 0.5, camera=VIEW, full=True, **options)
        assert found.level[0] == level
        assert (found.level[1:] == 0).sum() == (10 if level else 1)
        assert found.spent is not None
        frames = {"previous": found.level, "price": found.spent.price}


def test_no_triangles_are_spent_on_weightless_or_invisible_objects() -> None:
    models, index, centers, radii = crowd(1000)
    weight = np.ones(1000)
    weight[::2] = 0
    found = nf.lod.select(models, index, centers, radii, camera=VIEW, budget=10**9, weight=weight)
    seen = found.level >= 0
    assert (found.level[::2][seen[::2]] == 7).all()
    assert (found.level[1::2][seen[1::2]] < 7).mean() > 0.9
    nobody = nf.lod.select(models, index, centers, radii, camera=VIEW, budget=10**9, weight=np.zeros(1000))
    assert nobody.spent is not None
    assert np.isnan(nobody.spent.score)
    none = nf.lod.select(models, [], np.zeros((0, 3)), np.zeros(0), camera=VIEW, budget=0)
    assert none.spent is not None
    assert (len(none), none.spent.triangles, none.spent.price) == (0, 0, 0.0)


@pytest.mark.parametrize(
    ("options", "error", "message"),
    [
        ({"weight": [1.0, np.nan]}, ValueError, "weight: .* numbers from 1e-150 to 1e150, got NaN at index 1"),
        ({"weight": [1.0, -1.0]}, ValueError, "weight: expected 0, or numbers .*, got -1 at index 1"),
        ({"weight": [1e-200, 1.0]}, ValueError, "weight: expected 0, or numbers .* at index 0"),
        ({"weight": [1.0, 1e200]}, ValueError, "weight: expected 0, or numbers .* at index 1"),
        ({"fade": 0.5}, ValueError, "fade: expected 0 with a budget"),
        ({"budget": None, "floor": 0.1}, ValueError, "floor: expected None without a budget, got 0.1"),
        ({"weight": [1.0]}, ValueError, r"weight: expected shape \(2,\), one for each object, got \(1,\)"),
        ({"price": -0.1}, ValueError, "price: expected"),
        ({"draws": [1]}, ValueError, r"draws: expected shape \(2,\), got \(1,\)"),
        ({"draws": [1, 256]}, ValueError, "draws: expected whole numbers from 0 to 255, got 1 to 256"),
        ({"mode": "off"}, ValueError, "budget: expected None for the mode 'off'"),
    ],
)
def test_other_arguments_are_refused(options: dict[str, Any], error: type[Exception], message: str) -> None:
    given: dict[str, Any] = {"budget": 10**9} | options
    with pytest.raises(error, match=message):
        select_drawn([usual()], [0, 0], VIEW.position + np.array([[0, 0, -5], [0, 0, -6]]), 1.0, camera=VIEW, **given)


def test_scores_of_views_count_by_their_mean() -> None:
    one = usual(2)
    sizes = np.geomspace(0.18, 1e-3, 12)
    views = np.stack(
        [np.ones((12, 4)), *(np.column_stack([low, low, high, high]) for low, high in _halves(one, sizes))]
    )
    samples = nf.lod.Samples(sizes, views.min(axis=2), views.astype(np.float32))
    measured = replace(one, samples=samples, curves=nf.lod.fit_4pl(sizes, views.min(axis=2)[1:]))
    place = [VIEW.position + 5 * -rotation(VIEW)[:, 2]]
    found = nf.lod.select([measured], [0], place, 0.5, camera=VIEW, budget=int(one.triangles[1]), full=True)
    assert found.level[0] == 1
    assert found.score[0] == pytest.approx(measured.refit("mean").curves(found.sigma_seen)[0, 0], abs=1e-9)
    assert found.score[0] > measured.curves(found.sigma_seen)[0, 0] + 0.01


def _halves(one: nf.lod.LodModel, sizes: Array) -> list[tuple[Array, Array]]:
    return [(scores - 0.05, np.minimum(scores + 0.05, 1.0)) for scores in one.curves(sizes)]


BITS = """
import hashlib
import numpy as np
import nearfar as nf
from tests.support.lod_budget import VIEW, crowd
found = nf.lod.select(*crowd(60_000), camera=VIEW, budget=30_000_000, weight="pixels", floor=0.3, full=True)
print(hashlib.sha256(found.level.tobytes() + found.score.tobytes()).hexdigest(), found.spent)
"""


def test_budget_results_do_not_depend_on_threads() -> None:
    assert len(set(printed_by_threads(BITS))) == 1
