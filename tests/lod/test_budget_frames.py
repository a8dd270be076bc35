"""Budgets over many frames: the price of the previous frame, and stable levels."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
from hypothesis import given, settings, strategies as st

import nearfar as nf
from tests.support.lod_budget import VIEW, ahead, crowd, small_models
from tests.support.lod_oracle import model, rotation


def turns(hysteresis: float, *, keeps: bool) -> tuple[int, list[int]]:
    """Return changes of levels while sizes fluctuate, and the triangles of each frame."""
    models, index, centers, radii = crowd(3000, 5)
    random = np.random.default_rng(6)
    level, price, changes, drawn = None, None, 0, []
    for _ in range(12):
        trembling = radii * random.uniform(0.99, 1.01, len(radii))
        found = nf.lod.select(
            models, index, centers, trembling, camera=VIEW, budget=2_000_000, hysteresis=hysteresis,
            previous=level if keeps else None, price=price if keeps else None,
        )  # fmt: skip
        assert found.spent is not None
        changes += 0 if level is None else int((found.level != level).sum())
        level, price = found.level, found.spent.price
        drawn.append(found.spent.triangles)
    return changes, drawn


def test_levels_are_stable_while_sizes_fluctuate() -> None:
    free, _ = turns(0.0, keeps=False)
    held, drawn = turns(0.2, keeps=True)
    assert held < 0.2 * free
    assert all(1_600_000 <= triangles <= 2_000_000 for triangles in drawn)


def test_a_price_is_kept_if_it_uses_most_of_the_budget() -> None:
    scene = crowd(3000, 7)
    first = nf.lod.select(*scene, camera=VIEW, budget=2_000_000)
    assert first.spent is not None
    price = first.spent.price
    for budget, is_kept in ((2_000_000, True), (2_100_000, True), (2_500_000, False), (1_900_000, False)):
        found = nf.lod.select(*scene, camera=VIEW, budget=budget, price=price, hysteresis=0.1)
        assert found.spent is not None
        assert (found.spent.price == price) == is_kept
        assert found.spent.triangles <= budget


@given(st.integers(0, 2**32 - 1), st.integers(2, 40), st.sampled_from(["object", "pixels"]), st.floats(0, 1))
@settings(max_examples=80, deadline=None)
def test_static_scenes_keep_all_levels(seed: int, count: int, weight: str, hysteresis: float) -> None:
    random = np.random.default_rng(seed)
    models = small_models(random)
    index = random.integers(0, len(models), count)
    triangles = [one.triangles for one in models]
    least, most = (sum(int(triangles[number][end]) for number in index) for end in (-1, 0))
    centers, radii = ahead(count, seed)
    scene = models, index, centers, radii
    options: dict[str, Any] = {"camera": VIEW, "weight": weight, "budget": int(random.integers(least, most + 2))}
    first = nf.lod.select(*scene, **options)
    assert first.spent is not None
    options |= {"price": first.spent.price, "hysteresis": hysteresis}
    for previous in (first.level, None):
        again = nf.lod.select(*scene, **options, previous=previous)
        assert again.level.tolist() == first.level.tolist()
        assert again.spent is not None
        assert again.spent.triangles == first.spent.triangles


def test_large_static_scenes_keep_all_levels() -> None:
    scene = crowd(60_000, 8)
    first = nf.lod.select(*scene, camera=VIEW, budget=30_000_000)
    assert first.spent is not None
    for previous in (first.level, None):
        again = nf.lod.select(
            *scene, camera=VIEW, budget=30_000_000, previous=previous, price=first.spent.price, hysteresis=0.1
        )
        assert np.array_equal(again.level, first.level)


def test_budget_left_by_a_kept_price_goes_to_previous_levels() -> None:
    triangles = ([9000, 10], [2010, 10], [510, 10])
    scores = (0.0, 0.8, 0.96)
    models = [
        replace(model([(score, 1, 1, score)]), triangles=np.array(own))
        for own, score in zip(triangles, scores, strict=True)
    ]
    place = np.tile(VIEW.position + 5 * -rotation(VIEW)[:, 2], (3, 1))
    first = nf.lod.select(models, [0, 1, 2], place, 0.5, camera=VIEW, budget=9620)
    assert first.spent is not None
    kept: dict[str, Any] = {"price": first.spent.price, "hysteresis": 0.1}
    assert first.level.tolist() == [0, 1, 0]
    for previous, level in (([0, 1, 0], [0, 1, 0]), ([0, 1, 1], [0, 1, 1]), (None, [0, 1, 0])):
        found = nf.lod.select(models, [0, 1, 2], place, 0.5, camera=VIEW, budget=9620, previous=previous, **kept)
        assert found.level.tolist() == level
        assert found.spent is not None
        assert found.spent.price == first.spent.price


def test_a_high_price_leaves_minimum_levels() -> None:
    one = replace(model([(0.2, 1, 1, 0.2)]), triangles=np.array([100, 10]))
    place = np.tile(VIEW.position + 5 * -rotation(VIEW)[:, 2], (3, 1))
    found = nf.lod.select(
        [one], [0, 0, 0], place, 0.5, camera=VIEW, budget=1000, weight=[1e-150] * 3, price=1e308, hysteresis=1.0,
        floor=0.0,
    )  # fmt: skip
    assert found.level.tolist() == [0, 0, 0]


def test_levels_below_the_hull_are_not_kept() -> None:
    # The middle level costs more than the coarsest and looks worse.
    crossed = replace(model([(0.2, 1, 1, 0.2), (0.3, 1, 1, 0.3)]), triangles=np.array([1000, 300, 10]))
    place = np.tile(VIEW.position + 5 * -rotation(VIEW)[:, 2], (2, 1))
    for previous in (None, [1, 1], [2, 2], [0, 0]):
        found = nf.lod.select(
            [crossed], [0, 0], place, 0.5, camera=VIEW, budget=600, previous=previous, hysteresis=0.1 if previous else 0
        )
        assert found.level.tolist() == [2, 2]
