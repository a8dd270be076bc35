"""Levels measured by boxes, blocks and caches against whole pictures one by one; and what is not measured at all."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from nearfar.lod._measure import views as level_views
from nearfar.lod._measure.one_object import _cautious, coarsest_of_steps
from nearfar.lod._measure.score_table import ScoreTable
from tests.support import data, need, printed_by_threads
from tests.support.lod_cases import (
    FOV,
    SMALL,
    Array,
    ball,
    checkered,
    count_renders,
    levels,
    scene,
    smooth,
    straightforward,
    turn,
)


@pytest.fixture(autouse=True)
def _fresh_cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("NEARFAR_CACHE", str(tmp_path / "cache"))


# against whole pictures ----------------------------------------------------------------------------------------------
def own_ssim(base: Array, test: Array, mask: NDArray[np.bool_]) -> float:
    return float(nf.ssim(base, test, data_range=255.0, mask=mask)) if mask.any() else 1.0


def far_speck() -> nf.Scene:
    """A level of which nothing is seen from anywhere."""
    return nf.Scene.from_arrays(np.array([3, -2, 1]) + 1e-6 * np.eye(3), [[0, 1, 2]])


def cut(rows: int, name: str) -> nf.lod.Levels:
    scenes = {
        "plain": [scene(rows), scene(rows // 2), scene(rows // 4)],
        "smooth": [smooth(rows), smooth(rows // 2)],
        "textured": [checkered(rows), checkered(rows // 2)],
        "vanishing": [scene(rows), far_speck()],
        "growing": [scene(rows), nf.Scene.from_arrays(1.4 * (ball(4)[0] - (3, -2, 1)) + (3, -2, 1), ball(4)[1])],
    }[name]
    return nf.lod.Levels([nf.lod.Level(scene=one) for one in scenes], name=name)


@pytest.mark.parametrize(
    ("name", "fov", "size", "samples"),
    [
        ("plain", FOV, (128, 128), 1),
        ("plain", nf.Fov(-1.1, 0.9, -0.8, 1.0), (121, 97), 4),
        ("smooth", FOV, (128, 128), 1),
        ("textured", FOV, (128, 120), 4),
        ("vanishing", FOV, (96, 96), 1),
        ("growing", nf.Fov.symmetric(110), (96, 64), 1),
    ],
)
def test_boxes_score_as_whole_pictures_do(name: str, fov: nf.Fov, size: tuple[int, int], samples: int) -> None:
    own = cut(12, name)
    model = nf.lod.measure(
        own,
        fov=fov,
        size=size,
        views=8,
        distances=2,
        samples=samples,
        step=None,
        saturated=None,
        backend="cpu",
        cache=False,
    )
    truth = straightforward(own, 8, (1, 2), fov, size, samples, own_ssim)
    assert model.samples is not None
    assert model.samples.views is not None
    # Pictures are the same to the byte but where a ray passes an edge by its rounding, of which none does here; scores
    # are kept in float32 by view, and the percentile before that.
    np.testing.assert_allclose(model.samples.views, truth, atol=1e-7)
    expected = np.percentile(truth, 25, axis=2, method="averaged_inverted_cdf")
    np.testing.assert_allclose(model.samples.score, expected, rtol=0, atol=1e-12)
    assert truth[1:].min() < 0.99


def test_scores_are_those_of_scikit_image() -> None:
    need("skimage")
    from skimage.metrics import structural_similarity

    def theirs(base: Array, test: Array, mask: NDArray[np.bool_]) -> float:
        options = {"gaussian_weights": True, "sigma": 1.5, "use_sample_covariance": False, "data_range": 255.0}
        similar = structural_similarity(base, test, full=True, **options)[1]
        return float(similar[mask].mean())

    own = levels(16, 8)
    model = nf.lod.measure(own, **SMALL | {"distances": 2, "step": None, "saturated": None})
    assert model.samples is not None
    truth = straightforward(own, 8, (1, 2), FOV, (128, 128), 1, theirs)
    expected = np.percentile(truth, 25, axis=2, method="averaged_inverted_cdf")
    np.testing.assert_allclose(model.samples.score, expected, rtol=0, atol=1e-10)


def test_cameras_go_about_the_object_as_it_turns() -> None:
    views = 24
    turns, shown = level_views.turns(views)
    assert len(shown) == views
    assert len(turns) == views - 3  # not turned at all is the same about each axis
    screen = level_views.Screen.of(None, FOV, (128, 128))
    stand = level_views.Stand(screen, (3.0, -2.0, 1.0), 1.2, 1.2)
    points = ball(6)[0]
    for view in range(views):
        camera = stand.camera(2, turns[shown[view]])
        still = stand.camera(2, turns[0])
        # A turned object before a camera that stands still is seen where the object is by a camera that goes about it.
        turned = (points - stand.center) @ turn(view, views).T + stand.center
        np.testing.assert_allclose(camera.project(points), still.project(turned), rtol=0, atol=1e-9)


def test_sizes_grow_from_a_sixteenth_of_the_screen() -> None:
    model = nf.lod.measure(levels(6), hmd=nf.hmd.RIFT_S, distances=5)
    tangent = nf.hmd.RIFT_S.tan_half_angle
    assert model.samples is not None
    expected = 2 * np.pi * (1 - np.cos(np.arcsin(tangent / 4)))
    assert model.samples.sigma[0] == pytest.approx(expected, rel=1e-14)
    # The sphere is a quarter as wide as the screen, and so a sixteenth of a square one.
    camera = nf.Camera((0, 0, 0), fov=nf.Fov(-tangent, tangent, -tangent, tangent), size=(1024, 1024))
    rays = camera.rays()[1]
    share = (rays[..., 2] < -np.cos(np.arcsin(tangent / 4))).mean()
    assert share == pytest.approx(np.pi / 4 / 16 / (1 - (tangent / 4) ** 2), rel=2e-3)
    distances = model.radius / np.sin(np.arccos(1 - model.samples.sigma / (2 * np.pi)))
    np.testing.assert_allclose(np.diff(distances), (distances - model.radius)[0], rtol=1e-9)
    assert model.sigma == (model.samples.sigma[-1], model.samples.sigma[0])


def test_pixels_are_those_of_the_headset() -> None:
    measured = nf.lod.measure(levels(6), hmd=nf.hmd.RIFT_S).measured
    fov = nf.hmd.RIFT_S.left.fov
    assert measured["pixel"] == (fov.right - fov.left) / nf.hmd.RIFT_S.render_size[0]


# which levels are kept, and how far they are measured ----------------------------------------------------------------
def test_each_step_keeps_its_coarsest_level() -> None:
    assert coarsest_of_steps(np.array([1.0, 0.99, 0.96, 0.93, 0.80]), 0.05) == [0, 2, 3, 4]
    assert coarsest_of_steps(np.array([1.0, 0.95, 0.90, 0.85]), 0.05) == [
        0,
        1,
        2,
        3,
    ]  # at a step is above it
    assert coarsest_of_steps(np.array([1.0, 0.7, 0.9, 0.5]), 0.05) == [0, 2, 3]  # coarser and better
    assert coarsest_of_steps(np.array([1.0, 0.7, 0.9, 0.5]), None) == [0, 1, 2, 3]
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


def test_levels_left_out_are_measured_no_further() -> None:
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
    # Five of eight views differ; one of them is seen of levels that cannot be kept at the first four distances.
    assert whole.measured["scores"] == 5 * 7 * 3
    assert whole.measured["renders"] == 5 * 7 * 4
    assert model.measured["scores"] == 5 * 7 * (len(kept) - 1) + 4 * (4 - len(kept))
    assert all(one["score"] is None for one in left)
    for one in (model, whole):
        done = one.measured
        assert done["scores"] + done["cached"] + done["skipped"] == 3 * 7 * 8


@pytest.mark.parametrize("saturated", [None, 0.9])
def test_levels_are_those_of_all_scores_though_some_are_not_asked_for(
    saturated: float | None, monkeypatch: pytest.MonkeyPatch
) -> None:
    random = np.random.default_rng(0)
    own, skipped = levels(8, 7, 6, 5, 4), 0
    how: dict[str, Any] = SMALL | {"views": 96, "distances": 6, "saturated": saturated, "cache": False}
    for _ in range(30):
        # Levels fall, but now and then a coarser one scores more, and SSIM dips where they are smaller.
        fall = np.cumsum(random.uniform(-0.02, 0.04, (5, 6)), axis=0)
        true = np.clip(1 - fall[:, :, None] - random.uniform(0, 0.05, (5, 6, 93)), 0, 1)
        true[0] = 1.0

        def fill(
            table: ScoreTable, size: int, numbers: list[int], among: Any = None, true: NDArray[np.float64] = true
        ) -> None:
            rows = np.ix_(np.array(numbers, int), np.array([size - 1]), np.arange(93) if among is None else among)
            table.is_used[rows] = True
            table.scores[rows] = true[rows]

        monkeypatch.setattr(ScoreTable, "fill", fill)
        model = nf.lod.measure(own, **how, step=0.05)
        whole = nf.lod.measure(own, **how, step=None)
        assert model.samples is not None
        assert whole.samples is not None
        # Where a level looks like the base twice, it counts as the base at smaller sizes.
        scores = np.where(np.isnan(whole.samples.score), 1.0, whole.samples.score)
        kept = sorted({0}.union(*(coarsest_of_steps(scores[:, size], 0.05) for size in range(4))))
        assert list(model.triangles) == list(whole.triangles[kept])
        np.testing.assert_array_equal(model.samples.score, whole.samples.score[kept])
        skipped += 93 * 4 * 6 - model.measured["scores"]
    assert skipped > 30 * 93


def test_what_looks_like_the_base_is_measured_no_further() -> None:
    vertices, faces = ball(12)
    moved = nf.Scene.from_arrays(vertices + 1e-4 * np.sin(7 * vertices), faces)
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
    # It stays where it was when it was measured last: at 0.999 or more, and so within 0.001 of what is left out.
    sigma = np.geomspace(*model.sigma, 50)
    np.testing.assert_allclose(model.curves(sigma), whole.curves(sigma), rtol=0, atol=1e-3)
    np.testing.assert_array_equal(model.samples.filled[1, 2:], model.samples.score[1, 1])


def test_one_level_is_no_work(monkeypatch: pytest.MonkeyPatch) -> None:
    counted = count_renders(monkeypatch)
    model = nf.lod.measure(levels(12), hmd=nf.hmd.VIVE_PRO)
    assert counted == []
    assert (model.measured["renders"], model.measured["scores"], model.measured["skipped"]) == (0, 0, 0)
    assert len(model) == 1
    assert len(model.curves) == 0
    assert model.samples is not None
    np.testing.assert_array_equal(model.samples.score, np.ones((1, 16)))


def test_the_same_again_is_no_work_either(monkeypatch: pytest.MonkeyPatch) -> None:
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


def test_an_object_may_be_smaller_than_a_pixel() -> None:
    model = nf.lod.measure(levels(8, 4), fov=FOV, size=(2, 2), views=4, distances=3, saturated=None)
    assert model.samples is not None
    assert np.isfinite(model.samples.score).all()


@pytest.mark.slow
def test_results_do_not_depend_on_the_number_of_threads() -> None:
    code = (
        "import nearfar as nf; from tests.support.lod_cases import levels\n"
        "model = nf.lod.measure(levels(16, 8), fov=nf.Fov.symmetric(90), size=(256, 256), views=4, distances=4,\n"
        "                       backend='cpu', cache=False)\n"
        "print([x.hex() for x in (*model.samples.score.ravel().tolist(), *model.curves.a.tolist())])"
    )
    assert len(printed_by_threads(code)) == 1


# back ends, real data ------------------------------------------------------------------------------------------------
def test_a_gpu_measures_the_same_curves() -> None:
    need("vulkan")
    options: dict[str, Any] = {"fov": FOV, "size": (256, 256), "views": 8, "distances": 4, "step": None, "cache": False}
    # With one sample pictures differ in pixels whose centre an edge passes by 1/256; with four also in how edges are
    # blended, in both pictures alike.
    for samples, bound in ((1, 2e-3), (4, 2e-2)):
        here = nf.lod.measure(levels(24, 12, 6), **options, samples=samples, backend="cpu")
        there = nf.lod.measure(levels(24, 12, 6), **options, samples=samples, backend="gpu")
        assert there.measured["device"] != here.measured["device"]
        assert here.samples is not None
        assert there.samples is not None
        np.testing.assert_allclose(there.samples.score, here.samples.score, rtol=0, atol=bound)
        sigma = np.geomspace(*here.sigma, 20)
        np.testing.assert_allclose(there.curves(sigma), here.curves(sigma), rtol=0, atol=bound)


def test_a_real_object_falls_from_level_to_level() -> None:
    path = data("objects/bun_zipper.ply")
    need("fast_simplification")
    import fast_simplification

    base = nf.Scene.load(path)
    corners = base.triangles().reshape(-1, 3)
    vertices, faces = np.unique(corners, axis=0, return_inverse=True)
    own = [nf.lod.Level(scene=base)]
    for ratio in (0.3, 0.03, 0.003):
        fewer = fast_simplification.simplify(vertices, faces.reshape(-1, 3).astype(np.int32), 1 - ratio)
        own.append(nf.lod.Level(scene=nf.Scene.from_arrays(*fewer), ratio=ratio))
    model = nf.lod.measure(nf.lod.Levels(own), hmd=nf.hmd.RIFT_S, views=4, distances=5, samples=1, step=None)
    assert model.samples is not None
    assert (np.diff(model.samples.score, axis=0) < 0).all()


# files, plots, scenes that travel ------------------------------------------------------------------------------------
@pytest.fixture(scope="module")
def model(tmp_path_factory: pytest.TempPathFactory) -> Iterator[nf.lod.LodModel]:
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("NEARFAR_CACHE", str(tmp_path_factory.mktemp("cache")))
        yield nf.lod.measure(levels(16, 12, 6), **SMALL | {"distances": 6})


def test_plots_show_each_level(model: nf.lod.LodModel) -> None:
    need("matplotlib")
    import matplotlib as mpl

    mpl.use("Agg")
    axes = model.plot()
    assert len(axes.lines) == 2 * (len(model) - 1)
    assert model.plot(axes) is axes


def test_flat_curves_promise_no_more_than_was_seen() -> None:
    rows = np.array([[0.87, 0.93, 0.95, 0.94], [0.6, 0.8, 0.93, 0.98]])
    fitted = nf.lod.fit_4pl(np.array([0.18, 0.06, 0.03, 0.02]), rows)
    assert fitted.status[0] == "flat"
    cautious = _cautious(fitted, rows)
    assert (cautious.a[0], cautious.d[0]) == (0.87, 0.87)
    np.testing.assert_array_equal([*cautious[1]], [*fitted[1]])
