"""Levels against the formulas in 40 digits and NumPy, views against projections, and trivial cases."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from numpy.typing import NDArray

import nearfar as nf
from tests.support import printed_by_threads
from tests.support.lod_oracle import choose_level, curves, model, random_spheres, usual

Array = NDArray[np.float64]

LENS = nf.RadialLens((0.22, 0.24))
FOV = nf.Fov(-1.0, 0.9, -1.1, 1.05)
VIEW = nf.Camera((0.5, 1.5, -2.0), fov=FOV, size=(1440, 1600))
TURNED = nf.Camera.look_at((0.5, 1.5, -2.0), (4.0, 0.5, -9.0), fov=FOV, size=(1440, 1600))


# the choice ----------------------------------------------------------------------------------------------------------
@given(
    st.integers(0, 2**32 - 1),
    st.sampled_from(["anchored", "literal", "normalized"]),
    st.sampled_from(["depth", "depth+eccentricity", "fovea"]),
    st.sampled_from([(0.22, 0.24), (-0.2,), (), (0.1, -0.03, 0.02)]),
    st.floats(0, 0.5),
    st.floats(0.5, 1),
    st.sampled_from(["lut", "newton"]),
)
@settings(max_examples=40)
def test_levels_equal_the_formulas(
    seed: int, threshold: Any, mode: Any, k: tuple[float, ...], slope: float, start: float, inverse: Any
) -> None:
    models = [usual(), usual(5, seed), usual(1), model([])]
    centers, radii = random_spheres(8, seed, TURNED)
    index = np.arange(8) % 4
    gaze = None if seed % 2 else np.random.default_rng(seed).normal(size=3)
    lens = nf.RadialLens(k)
    found = nf.lod.select(
        models,
        index,
        centers,
        radii,
        camera=TURNED,
        lens=lens,
        k=slope,
        d=start,
        threshold=threshold,
        mode=mode,
        gaze=gaze,
        cull=False,
        inverse=inverse,
    )
    for n in range(8):
        level, near = choose_level(
            models[index[n]],
            centers[n],
            radii[n],
            TURNED,
            lens=None if mode == "depth" else lens,
            k=slope,
            d=start,
            threshold=threshold,
            fovea=(0.0275, 1 / 48) if mode == "fovea" else None,
            gaze=gaze,
        )
        # An error of 10⁻⁸ in σ′ changes scores by as much at most.
        assert found[n] == level or near < 1e-8


def by_numpy(
    models: list[nf.lod.LodModel],
    index: Any,
    sigma: Array,
    seen: Array,
    reference: float,
    k: float = 0.27,
    d: float = 0.9,
) -> tuple[Any, Any]:
    """Return levels of sizes, and the margin of each decision."""
    level, near = np.zeros(len(index), np.int32), np.full(len(index), np.inf)
    wanted = d + k * (sigma - 0.209)
    for number, one in enumerate(models):
        mine = np.flatnonzero(index == number)
        least, greatest = one.sigma
        for step in range(1, len(one)):
            curve = one.curves[step - 1]
            reached = np.minimum(curve(np.maximum(seen[mine], least)), curve(least))
            level[mine[reached >= wanted[mine]]] = step
            near[mine] = np.fmin(near[mine], np.abs(reached - wanted[mine]))
        level[mine[(seen[mine] > min(reference, greatest)) | (sigma[mine] == 4 * np.pi)]] = 0
    return level, near


def odd_models() -> list[nf.lod.LodModel]:
    """Return crossing, flat, missing, rising and steep curves, and ones of a narrow range."""
    nothing = (math.nan,) * 4
    return [
        *(usual(6, seed) for seed in range(4)),
        usual(12),
        model([(0.95, 1, 0.01, 0.95), nothing, (0.7, 1, 0.01, 0.7)]),
        model([nothing]),
        model([(0.2, 2, 0.01, 1.0), (1.0, 0.5, 1e-3, 0.1)]),
        model([(1.0, 4000.0, 0.02, 0.1), (1.0, 300.0, 0.001, 0.1)]),
        model([(1.0, 1.0, 0.05, 0.5), (1.0, 1.0, 0.01, 0.2)], (0.003, 0.01)),
        model([(1.0, 1.0, 0.05, 0.5), (1.0, 1.0, 0.01, 0.2)], (0.0, math.inf)),
        model([(0.5, 1.0, 0.05, 0.2)], (0.01, 0.01)),
        model([]),
    ]


def test_tables_select_like_curves_for_many_objects() -> None:
    models = odd_models()
    count = 200_000
    random = np.random.default_rng(0)
    index = random.integers(0, len(models), count)
    centers, radii = random_spheres(count, 1, VIEW, 0.85)
    reference = nf.lod.reference_solid_angle(VIEW)
    sigma = nf.solid_angle(centers, radii, eye=VIEW.position)
    seen = nf.corrected_solid_angle(centers, radii, camera=VIEW, lens=LENS)
    expected, near = by_numpy(models, index, sigma, seen, reference)
    found = nf.lod.select(models, index, centers, radii, camera=VIEW, lens=LENS, full=True)
    assert found.counts["culled"] == 0
    assert found.counts["table"] > 0.8 * found.counts["asked"] > 0
    differ = found.level != expected
    assert not differ[near > 1e-8].any()
    assert differ.sum() <= 2
    asked = ~np.isnan(found.sigma_seen)
    assert asked.sum() == found.counts["asked"] == found.counts["lens"]
    np.testing.assert_allclose(found.sigma_seen[asked], seen[asked], rtol=1e-8)
    has_levels = np.array([len(one) > 1 for one in models])[index]
    np.testing.assert_allclose(found.sigma[has_levels], sigma[has_levels], rtol=1e-14)
    exact = nf.lod.select(models, index, centers, radii, camera=VIEW, lens=LENS, inverse="newton", full=True)
    assert np.array_equal(exact.sigma_seen[asked], seen[asked])
    assert (exact.level != expected).sum() <= 1
    # Some of them are decided by curves alone.
    few = slice(0, 2000)
    again = nf.lod.select(models, index[few], centers[few], radii[few], camera=VIEW, lens=LENS, full=True)
    assert again.counts["table"] == 0
    assert np.array_equal(again.level, found.level[few])
    for name in ("sigma", "sigma_seen", "threshold", "score"):
        assert np.array_equal(getattr(again, name), getattr(found, name)[few], equal_nan=True)


@pytest.mark.parametrize("k", [0.27, 0.0, -3.0, 40.0])
def test_tables_decide_below_the_measured_sizes(k: float) -> None:
    least = 0.03
    range_ = (least, 0.18)
    nothing = (math.nan,) * 4
    # At the least size, scores that f crosses at smaller sizes, and scores that it never crosses.
    models = [
        model([(1.0, 1.0, least, 0.704), (1.0, 1.3, least, 0.698), (1.0, 1.6, least, 0.694)], range_),
        model([(0.96, 1.0, 0.3, 0.5), nothing, (0.85, 1.0, 0.01, 0.85)], range_),
        model([(0.7, 2.0, 0.03, 1.0), (1.0, 0.5, 0.001, 0.1)], range_),
        model([(1.0, 4000.0, least, 0.72)], range_),
        usual(3),
        model([]),
    ]
    count = 60_000
    index = np.random.default_rng(9).integers(0, len(models), count)
    centers, radii = random_spheres(count, 9, VIEW, 0.85)
    radii *= 0.3
    # The wide view's own sixteenth as the anchor.
    d = 0.9 - k * (nf.lod.reference_solid_angle(VIEW) - 0.209)
    options: dict[str, Any] = {"camera": VIEW, "lens": LENS, "k": k, "d": d, "full": True}
    found = nf.lod.select(models, index, centers, radii, **options)
    small = found.sigma_seen < least
    assert small[index < 4].mean() > 0.7
    assert found.counts["table"] > 0.9 * found.counts["asked"] > 0.7 * count
    exact = nf.lod.select(models, index, centers, radii, inverse="newton", **options)
    assert np.array_equal(found.level, exact.level)
    assert exact.counts["table"] > 0.9 * exact.counts["asked"]
    for first in range(0, count, 1500):
        few = slice(first, first + 1500)
        formula = nf.lod.select(models, index[few], centers[few], radii[few], **options)
        assert formula.counts["table"] == 0
        assert np.array_equal(formula.level, found.level[few])
        assert np.array_equal(formula.score, found.score[few], equal_nan=True)
    sigma = nf.solid_angle(centers, radii, eye=VIEW.position)
    seen = nf.corrected_solid_angle(centers, radii, camera=VIEW, lens=LENS)
    expected, near = by_numpy(models, index, sigma, seen, nf.lod.reference_solid_angle(VIEW), k, d)
    assert not (found.level != expected)[near > 1e-8].any()
    if k == 0.27:
        assert all(len(np.unique(found.level[small & (index == number)])) > 1 for number in range(2))


def test_scores_belong_to_the_selected_level() -> None:
    models = odd_models()
    centers, radii = random_spheres(3000, 2, VIEW)
    index = np.arange(3000) % len(models)
    found = nf.lod.select(models, index, centers, radii, camera=VIEW, lens=LENS, full=True)
    for n in np.flatnonzero(found.level > 0):
        one = models[index[n]]
        curve, least = one.curves[int(found.level[n]) - 1], one.sigma[0]
        score = min(curve(max(found.sigma_seen[n], least)), curve(least))
        assert found.score[n] == pytest.approx(score, abs=1e-12)
        assert score >= found.threshold[n] - 1e-12
    assert (found.score[found.level == 0] == 1).all()
    assert np.isnan(found.score[found.level < 0]).all()
    assert np.array_equal(found.shown, found.level)
    assert len(found) == 3000
    assert repr(found).startswith("Selection(3000 objects; -1: ")


# no work -------------------------------------------------------------------------------------------------------------
def test_objects_with_one_level_need_no_work() -> None:
    centers, radii = random_spheres(3000, 6, VIEW)
    nothing = {"settled": 0, "large": 0, "asked": 0, "lens": 0, "table": 0, "formula": 0}
    found = nf.lod.select([model([])], np.zeros(3000, int), centers, radii, camera=VIEW, lens=LENS, full=True)
    culled = int((found.level < 0).sum())
    assert found.counts == {"culled": culled, "one_level": 3000 - culled} | nothing
    assert np.isnan(found.sigma).all()
    assert (found.level[found.level >= 0] == 0).all()
    both = nf.lod.select([model([]), usual()], np.arange(3000) % 2, centers, radii, camera=VIEW, lens=LENS, full=True)
    assert both.counts["one_level"] == (both.level[::2] == 0).sum()
    assert both.counts["asked"] == (~np.isnan(both.sigma_seen[1::2])).sum() == both.counts["lens"]
    assert sum(both.counts[name] for name in ("culled", "one_level", "settled", "large", "asked")) == 3000
    off = nf.lod.select([usual()], np.zeros(3000, int), centers, radii, camera=VIEW, mode="off", full=True)
    assert set(off.counts.values()) == {0}
    assert (off.level == 0).all()
    assert (off.shown == 0).all()
    assert np.isnan(off.sigma).all()
    depth = nf.lod.select(
        [usual()], np.zeros(3000, int), centers, radii, camera=VIEW, lens=LENS, mode="depth", full=True
    )
    assert depth.counts["lens"] == 0


def test_empty_selections_are_empty() -> None:
    empty = nf.lod.select([], [], np.empty((0, 3)), [], camera=VIEW, full=True)
    assert empty.level.shape == (0,)
    assert empty.level.dtype == np.int32
    assert nf.lod.select([usual()], [], np.empty((0, 3)), 1.0, camera=VIEW).shape == (0,)


def test_thresholds_that_no_level_reaches_select_level_0() -> None:
    centers, radii = random_spheres(2000, 7, VIEW, 0.8)
    for k, d in ((0.27, 1.5), (1e6, 0.9), (0.0, 1.0 + 1e-9)):
        strict = nf.lod.select(
            [usual()], np.zeros(2000, int), centers, radii, camera=VIEW, threshold="literal", k=k, d=d
        )
        assert (strict <= 0).all() if k < 1 else (strict == 0).mean() > 0.4
    lax = nf.lod.select([usual()], np.zeros(2000, int), centers, radii, camera=VIEW, d=-1.0, full=True)
    assert (lax.level[lax.sigma_seen <= 0.18] == 7).all()


# errors --------------------------------------------------------------------------------------------------------------
def test_models_may_have_curves_only() -> None:
    with pytest.raises(ValueError, match="curves: expected 7, one for each level but level 0, got 1"):
        replace(usual(), curves=curves([(1, 1, 1, 0)]))
    with pytest.raises(ValueError, match=r"curves: expected scores a and d of at most 1e\+100, got 1e\+308"):
        model([(1e308, 1, 1e-3, -1e308)])
    one = nf.lod.LodModel(triangles=np.array([100, 10]), curves=nf.lod.Curve4PL(1.0, 1.0, 1.0, 0.99))
    many = nf.lod.LodModel(triangles=np.array([100, 10]), curves=nf.lod.Curve4PL([1.0], [1.0], [1.0], [0.99]))
    for known in (one, many):
        assert nf.lod.select([known], [0], [(0, 1, -9)], 0.1, camera=VIEW)[0] == 1
        assert (known.sigma, known.radius, known.pixel, known.errors.tolist()) == ((0, 4 * math.pi), 1, None, [0, 0])
        assert (known.curves.status[0], known.curves.reason[0]) == ("fitted", "")
        assert "<svg" in str(known._repr_html_())


def test_models_of_other_sizes_and_samples_are_refused() -> None:
    samples = nf.lod.Samples(np.array([0.1, 0.01]), np.ones((3, 2)))
    with pytest.raises(ValueError, match="samples: expected scores of 8 levels at 2 sizes"):
        replace(usual(), samples=samples)


@pytest.mark.parametrize(
    ("parameters", "message"),
    [
        (([1.0], [1.0], [1.0, 2.0], [0.5]), r"c: expected shape \(1,\), as a has, got \(2,\)"),
        (([[1.0]], [[1.0]], [[1.0]], [[0.5]]), r"a: expected a number or shape \(K,\), got \(1, 1\)"),
        ((1.0, 1.0, 0.0, 0.5), "c: expected numbers above 0, got 0.0"),
        ((1.0, -1.0, 1.0, 0.5), "b: expected numbers above 0, got -1.0"),
        ((math.inf, 1.0, 1.0, 0.5), "a: expected finite numbers, or NaN for no curve, got inf"),
        ((1.0, 1.0, 1.0, 0.5, 0.01), "status: expected the outcomes if rms or reason is given, got None"),
    ],
)
def test_curves_of_other_parameters_are_refused(parameters: Any, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        nf.lod.Curve4PL(*parameters)


BITS = """
import hashlib
import numpy as np
import nearfar as nf
from tests.support.lod_oracle import usual
random = np.random.default_rng(0)
centers = random.normal(size=(20_000, 3)) * 20
camera = nf.Camera((0, 0, 0), fov=nf.Fov.symmetric(100), size=(100, 100))
models = [usual(), usual(5, 1)]
index = np.arange(20_000) % 2
found = nf.lod.select(models, index, centers, random.random(20_000), camera=camera, lens=nf.RadialLens((0.2,)),
                      mode="fovea", fade=0.5, full=True)
parts = [found.level, found.sigma_seen, found.score, found.shown]
print(hashlib.sha256(b"".join(part.tobytes() for part in parts)).hexdigest(), found.counts)
"""


@pytest.mark.slow
def test_bits_do_not_depend_on_the_number_of_threads() -> None:
    assert len(set(printed_by_threads(BITS))) == 1
