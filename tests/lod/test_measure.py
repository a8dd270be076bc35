"""Levels measured in boxes and blocks against whole pictures one by one, on each back end, and of a real object."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from tests.support import data, need, printed_by_threads
from tests.support.lod_cases import FOV, SMALL, Array, ball, checkered, levels, scene, smooth, straightforward

pytestmark = pytest.mark.usefixtures("fresh_cache")


# against whole pictures ----------------------------------------------------------------------------------------------
def own_ssim(base: Array, test: Array, mask: NDArray[np.bool_]) -> float:
    return float(nf.ssim(base, test, data_range=255.0, mask=mask)) if mask.any() else 1.0


def far_speck() -> nf.Scene:
    """Return a level that is invisible from everywhere."""
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
    ("name", "directions", "fov", "size", "samples"),
    [
        ("plain", "even", FOV, (128, 128), 1),
        ("plain", "published", nf.Fov(-1.1, 0.9, -0.8, 1.0), (121, 97), 4),
        ("smooth", "even", FOV, (128, 128), 1),
        ("textured", "even", FOV, (128, 120), 4),
        ("vanishing", "published", FOV, (96, 96), 1),
        ("growing", "even", nf.Fov.symmetric(110), (96, 64), 1),
    ],
)
def test_boxes_score_like_whole_pictures(
    name: str, directions: Any, fov: nf.Fov, size: tuple[int, int], samples: int
) -> None:
    own = cut(12, name)
    views = 8 if directions == "published" else 4
    how: dict[str, Any] = {"fov": fov, "size": size, "views": views, "directions": directions, "samples": samples}
    model = nf.lod.measure(own, **SMALL | how | {"distances": 2}, step=None, saturated=None, cache=False)
    truth = straightforward(own, views, (1, 2), fov, size, samples, own_ssim, directions)
    assert model.samples is not None
    assert model.samples.views is not None
    # Pictures have the same bytes except where rounding decides an edge, which does not occur here; scores
    # are stored in float32.
    np.testing.assert_allclose(model.samples.views, truth, rtol=0, atol=1e-7)
    expected = np.percentile(truth, 25, axis=2, method="averaged_inverted_cdf")
    np.testing.assert_allclose(model.samples.score, expected, rtol=0, atol=1e-7)
    assert truth[1:].min() < 0.99


def test_scores_equal_scikit_image() -> None:
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
    # Half a unit in the last place of float32, in which scores are stored.
    np.testing.assert_allclose(model.samples.score, expected, rtol=0, atol=2**-24)


def test_sizes_grow_from_a_sixteenth_of_the_screen() -> None:
    model = nf.lod.measure(levels(6), hmd=nf.hmd.RIFT_S, spacing="published", distances=5)
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


def test_pixel_density_is_the_headsets() -> None:
    measured = nf.lod.measure(levels(6), hmd=nf.hmd.RIFT_S).measured
    fov = nf.hmd.RIFT_S.left.fov
    assert measured["pixel"] == (fov.right - fov.left) / nf.hmd.RIFT_S.render_size[0]


# back ends, real data, pictures of a model --------------------------------------------------------------------------
@pytest.mark.slow
def test_results_do_not_depend_on_the_number_of_threads() -> None:
    code = (
        "import nearfar as nf; from tests.support.lod_cases import levels\n"
        "model = nf.lod.measure(levels(16, 8), fov=nf.Fov.symmetric(90), size=(256, 256), views=4, distances=4,\n"
        "                       backend='cpu', cache=False)\n"
        "print([x.hex() for x in (*model.samples.score.ravel().tolist(), *model.curves.a.tolist())])"
    )
    assert len(printed_by_threads(code)) == 1


def test_a_gpu_measures_the_same_curves() -> None:
    need("vulkan")
    options = SMALL | {"size": (160, 160), "standard_error": 0.0, "step": None, "cache": False}
    # With one sample, pictures differ in pixels whose centre lies within 1/256 of an edge; with four also in how
    # edges are blended, equally in both pictures.
    for samples, bound in ((1, 5e-3), (4, 2e-2)):
        here = nf.lod.measure(levels(24, 12, 6), **options | {"samples": samples})
        there = nf.lod.measure(levels(24, 12, 6), **options | {"samples": samples, "backend": "gpu"})
        assert there.measured["device"] != here.measured["device"]
        assert here.samples is not None
        assert there.samples is not None
        np.testing.assert_allclose(there.samples.score, here.samples.score, rtol=0, atol=bound)


def test_scores_of_a_real_object_fall_from_level_to_level() -> None:
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
    model = nf.lod.measure(
        nf.lod.Levels(own), fov=FOV, size=(320, 320), views=4, distances=3, samples=1, step=None, spacing="published"
    )
    assert model.samples is not None
    assert (np.diff(model.samples.score, axis=0) < 0).all()


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
