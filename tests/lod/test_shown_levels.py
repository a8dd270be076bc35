"""Levels that are never shown: tables and files omit them, and mark switches that are only limits."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import nearfar as nf
from nearfar._base import glb as glb_file
from tests.support.leveled_cases import frames, model_of

FOV = nf.Fov.symmetric(90, 1.0)


def curves(*, least: tuple[float, ...]) -> nf.lod.Curve4PL:
    """Flat curves: a level scores the same at every size."""
    count = len(least)
    one = np.ones(count)
    return nf.lod.Curve4PL(
        np.array(least), one, one, np.array(least), 0 * one, np.full(count, "flat"), np.full(count, "")
    )


def falling(model: nf.lod.LodModel, good: tuple[float, ...]) -> nf.lod.LodModel:
    """Return the model with curves that stay at `good` for all sizes."""
    samples = nf.lod.Samples(np.array([0.15, 0.1]), np.tile(np.array([1.0, *good])[:, None], 2))
    return replace(model, curves=curves(least=good), sigma=(1e-4, 0.15), samples=samples)


@pytest.fixture(scope="module")
def scan() -> nf.lod.LodModel:
    """Return a model whose levels 1 to 3 are good enough at all measured sizes, level 4 at none."""
    return falling(model_of((4, 3, 2, 1, 0), name="scan"), (1.0, 0.99, 0.98, 0.2))


def test_levels_that_end_with_a_coarser_one_are_never_shown(scan: nf.lod.LodModel) -> None:
    found = nf.lod.switches(scan, view=FOV)
    assert found.solid_angle[1] == found.solid_angle[2] == found.solid_angle[3] == pytest.approx(0.15)
    assert found.is_ever_shown.tolist() == [True, False, False, True, False]
    assert found.is_limit.tolist() == [False, True, True, True, False]
    rows = str(found).splitlines()[1:]
    assert ["beyond what was measured" in row for row in rows] == found.is_limit.tolist()
    assert ["never shown" in row for row in rows] == (~found.is_ever_shown).tolist()
    assert "never shown: level 3 is good enough up to the same or a greater size" in rows[1]
    # f(0) is 0.9 − 0.27 × 0.209.
    assert "never shown: its score is at most 0.200, and 0.844 is needed" in rows[4]
    part = found.of_levels(np.array([0, 3]))
    assert part.coverages() == [found.screen_coverage[3], 0.0]
    assert part.is_ever_shown.tolist() == [True, True]


def test_a_measured_switch_is_not_a_limit() -> None:
    found = nf.lod.switches(model_of((3, 2, 1)), view=FOV)
    assert not found.is_limit.any()
    assert found.is_ever_shown.all()
    assert "measured" not in str(found)


def test_a_screen_below_the_measured_sizes_is_not_a_limit(scan: nf.lod.LodModel) -> None:
    narrow = nf.Fov.symmetric(20, 1.0)
    assert nf.lod.reference_solid_angle(narrow) < scan.sigma[1]
    assert not nf.lod.switches(scan, view=narrow).is_limit.any()


@pytest.mark.parametrize("suffix", ["glb", "json"])
def test_files_omit_levels_that_are_never_shown(scan: nf.lod.LodModel, tmp_path: Path, suffix: str) -> None:
    path = tmp_path / f"scan.{suffix}"
    scan.export(path, view=FOV)
    back = nf.lod.LodModel.load(path)
    assert back.triangles.tolist() == scan.triangles[[0, 3]].tolist()
    assert back.errors.tolist() == scan.errors[[0, 3]].tolist()
    assert back.curves.a.tolist() == [0.98]
    assert back.samples is not None
    assert back.samples.score[:, 0].tolist() == [1.0, 0.98]
    one, other = (nf.lod.switches(model, view=FOV) for model in (back, scan))
    assert one.solid_angle.tolist() == other.solid_angle[[0, 3]].tolist()
    scan.export(path, view=FOV, all_levels=True)
    assert nf.lod.LodModel.load(path).triangles.tolist() == scan.triangles.tolist()


def test_exported_scenes_omit_levels_that_are_never_shown(scan: nf.lod.LodModel, tmp_path: Path) -> None:
    other = model_of((3, 2, 1), name="ball")
    placed = nf.lod.place([scan, other], [0, 1, 0], frames(3, seed=4))
    counts = {}
    for all_levels in (False, True):
        nf.lod.export(placed, tmp_path / "scene.glb", view=FOV, all_levels=all_levels)
        document = glb_file.Reader((tmp_path / "scene.glb").read_bytes()).document
        roots = [document["nodes"][number] for number in document["scenes"][0]["nodes"]]
        counts[all_levels] = [1 + len(root["extensions"]["MSFT_lod"]["ids"]) for root in roots]
        assert [len(root["extras"]["MSFT_screencoverage"]) for root in roots] == counts[all_levels]
    assert counts == {False: [2, 3, 2], True: [5, 3, 5]}


def test_a_model_that_shows_only_its_base_is_a_plain_mesh(tmp_path: Path) -> None:
    model = falling(model_of((2, 1)), (0.1,))
    model.export(tmp_path / "ball.glb", view=FOV)
    document = glb_file.Reader((tmp_path / "ball.glb").read_bytes()).document
    assert len(document["nodes"]) == 1
    assert "extensionsUsed" not in document
    assert len(nf.lod.LodModel.load(tmp_path / "ball.glb")) == 1


def dipping() -> nf.lod.LodModel:
    """Return a model whose scores fall with size, with coarser levels below finer ones."""
    return replace(model_of((3, 2, 1, 0)), sigma=(1e-4, 1.2))


def test_a_quality_holds_at_all_measured_sizes() -> None:
    model = dipping()
    at_most = nf.lod.reference_solid_angle(FOV)
    plain = nf.lod.switches(model, view=FOV)
    assert (plain.solid_angle[1:] <= at_most).all()
    assert plain.score[1] == pytest.approx(float(model.curves[0](model.sigma[1])))
    for quality in (0.95, 0.7, 0.61):
        found = nf.lod.switches(model, view=FOV, quality=quality)
        for level, size in enumerate(found.solid_angle[1:]):
            curve = model.curves[level]
            assert curve(size) == pytest.approx(quality, abs=1e-9) or (size == 1.2 and curve(1.2) > quality)
        # `select` chooses the same levels straight ahead.
        away = np.geomspace(1.7, 300, 200)
        centers = np.stack([0 * away, 0 * away, -away * model.radius], axis=1)
        camera = nf.Camera((0, 0, 0), fov=FOV, size=(100, 100))
        rule = nf.lod.LodThreshold(0.0, quality, "constant")
        spheres = (np.zeros(200, int), centers, np.full(200, model.radius))
        levels = nf.lod.select([model], *spheres, camera=camera, threshold=rule)
        sizes = 2 * np.pi * (1 - np.sqrt(1 - away**-2))
        expected = [max((n for n in range(1, 4) if size <= found.solid_angle[n]), default=0) for size in sizes]
        assert levels.tolist() == expected
    with pytest.raises(ValueError, match=r"d: expected None beside a quality, got 0\.9"):
        nf.lod.switches(model, view=FOV, quality=0.8, d=0.9)
    with pytest.raises(ValueError, match="quality: expected"):
        nf.lod.switches(model, view=FOV, quality=1.5)


def test_a_floor_gives_the_heights_at_which_levels_begin() -> None:
    found = nf.lod.switches(dipping(), view=FOV, d=2.0, floor=(0.5, 0.25))
    assert found.screen_height.tolist() == pytest.approx([1.0, 0.5, 0.25, 0.0])
    assert found.is_ever_shown.tolist() == [True, True, True, False]
    later = nf.lod.switches(dipping(), view=FOV, d=0.0, floor=(0.01,))
    assert later.solid_angle.tolist() == nf.lod.switches(dipping(), view=FOV, d=0.0).solid_angle.tolist()
    for floor in ((0.1, 0.5), (0.0,), (1.5,)):
        with pytest.raises(ValueError, match="floor: expected descending numbers above 0 and at most 1"):
            nf.lod.switches(dipping(), view=FOV, floor=floor)
