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
