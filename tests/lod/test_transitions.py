"""Levels from frame to frame: hysteresis, and fades between levels."""

from __future__ import annotations

import math
import pickle
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from tests.support.lod_oracle import model, usual

Array = NDArray[np.float64]

VIEW = nf.Camera((0, 0, 0), fov=nf.Fov.symmetric(95), size=(1440, 1600))
REFERENCE = nf.lod.reference_solid_angle(VIEW)
LENS = nf.RadialLens((0.22, 0.24))


def sized(sigma: Array, away: float = 0.0) -> tuple[Array, Array]:
    """Return spheres 5 m from the eye with these solid angles."""
    center = 5 * np.array([math.sin(away), 0.0, -math.cos(away)])
    return np.tile(center, (len(sigma), 1)), 5 * np.sin(2 * np.arcsin(np.sqrt(sigma / (4 * np.pi))))


def frames(one: nf.lod.LodModel, sigma: Array, steps: int, noise: float, **options: Any) -> NDArray[np.int32]:
    """Return levels of fluctuating sizes, (frames, N); asserts the threshold in each frame."""
    random = np.random.default_rng(0)
    index = np.zeros(len(sigma), int)
    level: NDArray[np.int32] | None = None
    found = []
    for _ in range(steps):
        centers, radii = sized(sigma * random.uniform(1 - noise, 1 + noise, len(sigma)))
        chosen = nf.lod.select([one], index, centers, radii, camera=VIEW, previous=level, full=True, **options)
        level = chosen.level
        coarse = level > 0
        assert (chosen.score[coarse] >= chosen.threshold[coarse]).all()
        found.append(level)
    return np.array(found)


def returns(levels: NDArray[np.int32]) -> int:
    """Count the objects that return to a level that they have left."""
    count = 0
    for level in range(int(levels.max()) + 1):
        is_it = np.pad(levels == level, ((1, 1), (0, 0))).astype(int)
        count += int(((np.diff(is_it, axis=0) == 1).sum(axis=0) > 1).sum())
    return count


@pytest.mark.parametrize("count", [200, 3000])
@pytest.mark.parametrize("one", [usual(12), usual(6, 1), model([(1.0, 1.0, 1.0, 0.99)], (1e-3, 0.05))])
def test_fluctuations_below_the_hysteresis_cause_no_flicker(one: nf.lod.LodModel, count: int) -> None:
    # Scores change by (a − d) b/4 ≤ 0.3 of 6 % and f by 0.27 · 0.2 of it: 0.02. Sizes by 6 %.
    sigma = np.geomspace(1e-4, 1.2 * REFERENCE, count)
    assert returns(frames(one, sigma, 30, 0.03)) > count // 100
    assert returns(frames(one, sigma, 30, 0.03, hysteresis=0.08)) == 0


def test_hysteresis_equals_two_thresholds() -> None:
    random = np.random.default_rng(1)
    models = [usual(7), usual(6, 3), usual(4, 5), model([])]
    count, band = 8000, 0.03
    for many in (count, 400):
        index = random.integers(0, 4, many)
        sigma = np.exp(random.uniform(-10, math.log(1.1 * REFERENCE), many))
        most = np.array([len(one) - 1 for one in models])[index]
        before = random.integers(-1, most + 1).astype(np.int32)
        centers, radii = sized(sigma)
        options: dict[str, Any] = {"camera": VIEW, "previous": before, "hysteresis": band}
        level = nf.lod.select(models, index, centers, radii, **options)
        own = nf.solid_angle(centers, radii, eye=(0, 0, 0))
        for n in range(0, many, many // 400):
            one = models[index[n]]
            share = 1 - band if before[n] == 0 else 1
            expected = 0
            if own[n] <= share * min(REFERENCE, one.sigma[1]):
                threshold = 0.9 + 0.27 * (own[n] - 0.209)
                for step in range(1, len(one)):
                    is_free = before[n] < 0 or step <= before[n]
                    score = one.curves[step - 1](max(own[n], one.sigma[0]))
                    expected = step if score >= threshold + (0 if is_free else band) else expected
            assert level[n] == expected, n


def test_without_hysteresis_the_previous_frame_does_not_matter() -> None:
    centers, radii = sized(np.geomspace(1e-4, 0.2, 500))
    plain = nf.lod.select([usual()], np.zeros(500, int), centers, radii, camera=VIEW)
    for before in (0, 3, 7, -1):
        previous = np.full(500, before)
        held = nf.lod.select([usual()], np.zeros(500, int), centers, radii, camera=VIEW, previous=previous)
        assert np.array_equal(held, plain)


# fades ----------------------------------------------------------------------------------------------------------------
def swept(one: nf.lod.LodModel, count: int, **options: Any) -> nf.lod.Selection:
    sigma = np.geomspace(5e-5, 4 * REFERENCE, count)
    centers, radii = sized(sigma, 0.4)
    return nf.lod.select([one], np.zeros(count, int), centers, radii, camera=VIEW, full=True, **options)


@pytest.mark.parametrize("fade", [0.1, 0.5, 1.0])
@pytest.mark.parametrize(
    ("one", "options"),
    [
        (usual(), {}),
        (usual(12), {"lens": LENS}),
        (usual(3), {"mode": "fovea"}),
        (model([(1.0, 1.0, 1.0, 0.98), (1.0, 1.0, 0.9, 0.97)], (1e-4, 0.05)), {}),
        (model([(1.0, 1.0, 0.04, 0.3), (0.95, 1.0, 0.02, 0.2), (0.96, 1.0, 0.015, 0.1)], (1e-4, 0.3)), {}),
    ],
)
def test_displayed_blends_are_continuous(one: nf.lod.LodModel, options: dict[str, Any], fade: float) -> None:
    coarse = swept(one, 50_000, fade=fade, **options)
    found = swept(one, 200_000, fade=fade, **options)
    # Jumps would not shrink with smaller steps.
    first, second = np.abs(np.diff(coarse.shown)).max(), np.abs(np.diff(found.shown)).max()
    assert second < 0.3 * first
    assert second < 0.05
    assert (found.shown <= found.level).all()
    assert found.shown[0] == found.level[0] == len(one) - 1
    assert found.shown[-1] == found.level[-1] == 0
    assert (found.finer_weight >= 0).all()
    assert (found.finer_weight < 1).all()
    assert (found.coarser <= found.level).all()
    # The longer requested fade covers more of the range.
    assert np.mean(found.shown % 1 != 0) > 0.02 * fade
    plain = swept(one, 50_000, **options)
    assert np.array_equal(plain.level, coarse.level)
    assert np.array_equal(plain.shown, plain.level)


def test_a_level_near_its_threshold_shows_the_finer_one() -> None:
    found = swept(usual(), 200_000, fade=0.5)
    falls = np.flatnonzero((np.diff(found.level) == -1) & (found.level[:-1] < 7))
    assert len(falls) >= 4
    for n in falls:
        assert found.shown[n] == pytest.approx(found.level[n] - 1, abs=0.01)
        assert found.shown[n + 1] == pytest.approx(found.level[n + 1], abs=0.01)
    # Halfway between two thresholds, with a fade over half of the interval, nothing fades.
    n = (falls[0] + falls[1]) // 2
    assert found.shown[n - 200] >= found.shown[n] > found.level[n] - 1


def test_a_selector_equals_the_call_with_its_settings() -> None:
    settings: dict[str, Any] = {"k": 0.2, "d": 0.95, "threshold": "normalized", "lens": LENS, "fade": 0.3}
    selector = nf.lod.Selector(**settings)
    centers, radii = sized(np.geomspace(1e-4, 0.1, 100))
    index = np.zeros(100, int)
    one = selector.select([usual()], index, centers, radii, camera=VIEW, full=True)
    other = nf.lod.select([usual()], index, centers, radii, camera=VIEW, full=True, **settings)
    assert np.array_equal(one.shown, other.shown)
    assert np.array_equal(selector.select([usual()], index, centers, radii, camera=VIEW), other.level)
    assert selector == nf.lod.Selector(**settings)


def test_rules_choose_as_keywords_do_and_keywords_replace_them() -> None:
    rules = nf.lod.LodRules(lens=LENS, mode="fovea", d=0.95)
    centers, radii = sized(np.geomspace(1e-4, 0.1, 100))
    objects = ([usual()], np.zeros(100, int), centers, radii)
    by_keywords = nf.lod.select(*objects, camera=VIEW, lens=LENS, mode="depth", k=0.2, d=0.95)
    assert np.array_equal(nf.lod.select(*objects, camera=VIEW, rules=rules, mode="depth", k=0.2), by_keywords)
    assert nf.lod.Selector(rules, mode="depth").rules == nf.lod.LodRules(lens=LENS, d=0.95, mode="depth")
    assert pickle.loads(pickle.dumps(nf.lod.Selector(rules))) == nf.lod.Selector(rules)
    wrong: dict[str, Any]
    for wrong, message in (
        ({"rules": 0.9}, "rules: expected LodRules"),
        ({"wide": 1}, "wide: expected a parameter .* such as Lod"),
    ):
        with pytest.raises(TypeError, match=message):
            nf.lod.select(*objects, camera=VIEW, **wrong)
