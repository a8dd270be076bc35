"""Tests of notebook cards of scenes, in particular that their cost is bounded."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar import _core
from nearfar._scene import preview
from tests.support.card_cases import Card


def grid(cells: int) -> nf.Scene:
    """A rolling surface of 2 cells² triangles, each cell a metre wide."""
    x, z = np.meshgrid(np.arange(cells + 1.0), np.arange(cells + 1.0))
    vertices = np.stack([x, 3 * np.sin(x / 9) * np.cos(z / 11), z], axis=-1).reshape(-1, 3).astype(np.float32)
    corner = (np.arange(cells)[:, None] * (cells + 1) + np.arange(cells)).reshape(-1)
    one = np.stack([corner, corner + cells + 1, corner + 1], axis=1)
    other = np.stack([corner + 1, corner + cells + 1, corner + cells + 2], axis=1)
    faces = np.stack([one, other], axis=1).reshape(-1, 3).astype(np.uint32)
    return nf.Scene.from_arrays(vertices, faces, object_names=["<hill>"])


def test_counts_extent_and_notes_are_listed() -> None:
    scene = nf.datasets.room()
    shown = Card(scene._repr_html_())
    assert shown.facts()["triangles"] == f"{scene.triangle_count:,}"
    assert shown.facts()["extent"].startswith("800 × ")
    assert all(note in shown.text for note in scene.report.notes)
    (picture,) = shown.pictures()
    assert picture.shape == (preview.SIZE[1], preview.SIZE[0], 3)
    assert len(np.unique(picture.reshape(-1, 3), axis=0)) > 100


def test_notes_and_invalid_faces_are_listed() -> None:
    made = grid(2)
    scene = nf.Scene(made._core, made._names, dropped=3, notes=("a note <&>",))
    shown = Card(scene._repr_html_())
    assert shown.facts()["dropped"] == "3 unusable faces"
    assert "a note <&>" in shown.text


@pytest.mark.parametrize("make", [lambda: nf.datasets.room(), lambda: grid(20), lambda: grid(3)])
def test_the_dense_part_fills_the_picture(make: Callable[[], nf.Scene]) -> None:
    """Four distant corners of ground must not shrink the rest to a dot."""
    scene = make()
    camera = preview.dense_view(scene._core, scene.bounds)
    low, high = preview.dense_bounds(scene._core, scene.bounds)
    points = scene.triangles().reshape(-1, 3)
    seen = camera.project(points[((points >= low) & (points <= high)).all(axis=1)])[:, :2] / preview.SIZE
    assert ((seen > 0.0) & (seen < 1.0)).all()
    assert np.ptp(seen, axis=0).max() > 0.7


def test_large_scenes_are_sampled_without_building_their_trees(monkeypatch: pytest.MonkeyPatch) -> None:
    scene = grid(400)
    drawn = []
    render = _core.render_truth

    def spy(core: Any, *arguments: Any, **settings: Any) -> Any:
        drawn.append(core)
        return render(core, *arguments, **settings)

    monkeypatch.setattr(preview, "MAX_EXACT_ELEMENTS", 100_000)
    monkeypatch.setattr(preview, "POINT_COUNT", 40_000)
    monkeypatch.setattr(_core, "render_truth", spy)
    shown = Card(scene._repr_html_())
    assert drawn == []
    (picture,) = shown.pictures()
    assert (picture[..., 3] > 0).mean() > 0.1, "the points close up"
    assert re.search(r"; (39|40),\d{3} of 320,000 triangles", shown.text)
    monkeypatch.setattr(preview, "MAX_EXACT_ELEMENTS", 1_000_000)
    assert "of 320,000" not in Card(scene._repr_html_()).text
    assert drawn == [scene._core]


def test_instances_cost_as_much_as_their_meshes() -> None:
    scene = nf.datasets.city(blocks=4, detail=1)
    assert preview.element_count(scene._core) < scene.triangle_count


@pytest.mark.parametrize(("total", "wanted"), [(0, 5), (3, 5), (1000, 10), (100_000, 5_000)])
def test_samples_are_evenly_spaced_and_limited(total: int, wanted: int) -> None:
    chosen = preview.sample_mask(total, wanted)
    assert chosen.shape == (total,)
    assert chosen.sum() <= wanted + 1
    if total <= wanted:
        assert chosen.all()
    else:
        assert np.abs(np.flatnonzero(chosen).mean() - total / 2) < 0.1 * total


def test_empty_and_damaged_scenes_are_shown_without_a_picture() -> None:
    scene = grid(2)
    empty = scene.subset(triangles=np.zeros(scene.triangle_count, bool))
    shown = Card(empty._repr_html_())
    assert shown.facts()["triangles"] == "0"
    assert shown.pictures() == []
    broken = nf.Scene.__new__(nf.Scene)
    assert broken._repr_html_() == "<pre>&lt;nearfar._scene.scene.Scene, damaged&gt;</pre>"


@pytest.mark.parametrize("scale", [1e-9, 1e9])
def test_scenes_of_any_size_are_shown(scale: float) -> None:
    scene = nf.Scene.from_arrays(scale * np.eye(3), [[0, 1, 2]])
    shown = Card(scene._repr_html_())
    assert len(shown.pictures()) == 1
    assert scene.report.unit_note
    assert scene.report.unit_note in shown.text
