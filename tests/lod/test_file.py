"""Models of levels as files: restored bit for bit, valid by the schema, and damaged files refused."""

from __future__ import annotations

import functools
import json
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from tests.support import valid
from tests.support.lod_cases import levels


@pytest.fixture(scope="module")
def model(tmp_path_factory: pytest.TempPathFactory) -> nf.lod.LodModel:
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("NEARFAR_CACHE", str(tmp_path_factory.mktemp("cache")))
        own = levels(16, 12, 6, name="Kugel äöü")
        return nf.lod.measure(own, fov=nf.Fov.symmetric(90), size=(96, 96), views=4, distances=5, samples=1, step=None)


def of_kind(model: nf.lod.LodModel, kind: str) -> nf.lod.LodModel:
    """Return the model, or a variant that is harder to store."""
    assert model.samples is not None
    if kind == "whole":
        return model
    if kind == "without samples":
        return replace(model, samples=None)
    if kind == "without views":
        return replace(model, samples=replace(model.samples, views=None))
    if kind == "unfittable":
        curves = nf.lod.fit_4pl([1.0, 2.0], np.ones((2, 2)))
        score = model.samples.score.copy()
        score[1:, 2:] = np.nan
        return replace(model, curves=curves, samples=replace(model.samples, score=score))
    return replace(model, triangles=model.triangles[:1], errors=model.errors[:1], curves=model.curves[:0], samples=None)


KINDS = ("whole", "without samples", "without views", "unfittable", "base alone")


@pytest.mark.parametrize("kind", KINDS)
def test_model_files_load_bit_for_bit(model: nf.lod.LodModel, kind: str, tmp_path: Path) -> None:
    given = of_kind(model, kind)
    given.save(tmp_path / "a.json")
    assert valid(json.loads((tmp_path / "a.json").read_text(encoding="utf-8")), "lod")
    found = nf.lod.LodModel.load(tmp_path / "a.json")
    assert (found.name, found.radius, found.sigma, found.measured) == (
        given.name,
        given.radius,
        given.sigma,
        given.measured,
    )
    assert found.levels is None
    for name in ("triangles", "errors", "center"):
        np.testing.assert_array_equal(getattr(found, name), getattr(given, name))
        assert getattr(found, name).dtype == getattr(given, name).dtype
    assert len(found.curves) == len(given.curves)
    for name in ("a", "b", "c", "d", "rms", "status", "reason"):
        np.testing.assert_array_equal(getattr(found.curves, name), getattr(given.curves, name))
    assert (found.samples is None) == (given.samples is None)
    if given.samples is not None and found.samples is not None:
        for name in ("sigma", "score", "views"):
            one, other = getattr(found.samples, name), getattr(given.samples, name)
            assert (one is None) == (other is None)
            if one is not None:
                np.testing.assert_array_equal(one, other)
                assert one.dtype == other.dtype
    found.save(tmp_path / "b.json")
    assert (tmp_path / "a.json").read_bytes() == (tmp_path / "b.json").read_bytes()


DAMAGE: dict[str, Any] = {
    "name": 3,
    "center": [1, 2],
    "radius": 0,
    "sigma": [2, 1],
    "levels": [],
    "samples": {"sigma": [1], "score": [[1, 2]], "views": None},
    "measured": [],
}


@pytest.mark.parametrize("key", DAMAGE)
def test_damaged_files_are_named(model: nf.lod.LodModel, key: str, tmp_path: Path) -> None:
    path = tmp_path / "a.json"
    model.save(path)
    document = json.loads(path.read_text(encoding="utf-8"))
    for change in ({key: DAMAGE[key]}, None):
        changed = document | change if change else {name: value for name, value in document.items() if name != key}
        path.write_text(json.dumps(changed), encoding="utf-8")
        assert not valid(changed, "lod") or key in ("sigma", "samples")
        with pytest.raises(nf.FormatError, match=r"a\.json: damaged"):
            nf.lod.LodModel.load(path)


@pytest.mark.parametrize(
    ("level", "change"),
    [
        (0, {"triangles": 0}),
        (1, {"triangles": 1.5}),
        (0, {"curve": {}}),
        (1, {"curve": None}),
        (1, {"curve": {"a": 1}}),
        (1, {"error": "much"}),
    ],
)
def test_damaged_levels_are_named(model: nf.lod.LodModel, level: int, change: dict[str, Any], tmp_path: Path) -> None:
    path = tmp_path / "a.json"
    model.save(path)
    document = json.loads(path.read_text(encoding="utf-8"))
    document["levels"][level] |= change
    path.write_text(json.dumps(document), encoding="utf-8")
    with pytest.raises(nf.FormatError, match=r"a\.json: damaged"):
        nf.lod.LodModel.load(path)


def test_foreign_and_newer_model_files_are_refused(model: nf.lod.LodModel, tmp_path: Path) -> None:
    path = tmp_path / "a.json"
    model.save(path)
    document = json.loads(path.read_text(encoding="utf-8"))
    path.write_text(json.dumps(document | {"version": 3}), encoding="utf-8")
    with pytest.raises(nf.FormatError, match="version 3"):
        nf.lod.LodModel.load(path)
    path.write_text(json.dumps(document | {"format": "nearfar.hmd"}), encoding="utf-8")
    with pytest.raises(nf.FormatError, match="expected format"):
        nf.lod.LodModel.load(path)
    with pytest.raises(FileNotFoundError):
        nf.lod.LodModel.load(tmp_path / "none.json")


def test_saving_refuses_the_suffix_of_geometry(model: nf.lod.LodModel, tmp_path: Path) -> None:
    with pytest.raises(ValueError, match=r"path: expected the name of a JSON file, got .*; `export`"):
        model.save(tmp_path / "x.glb")
    assert not list(tmp_path.iterdir())


WRONG: tuple[Any, ...] = (float("inf"), float("nan"), -1, 2**70, 1.5, None, "x", [], {}, True)


def places(value: Any, *path: Any) -> Iterator[tuple[Any, ...]]:
    """List paths to the numbers and texts of a document; of lists, to the last entry."""
    if isinstance(value, dict | list) and value:
        entries = value.items() if isinstance(value, dict) else [(len(value) - 1, value[-1])]
        for key, entry in entries:
            yield from places(entry, *path, key)
    else:
        yield path


def test_loadable_models_can_be_saved_again(model: nf.lod.LodModel, tmp_path: Path) -> None:
    model.save(tmp_path / "a.json")
    text = (tmp_path / "a.json").read_text(encoding="utf-8")
    loaded = 0
    for *way, last in places(json.loads(text)):
        for value in WRONG:
            changed = json.loads(text)
            functools.reduce(lambda part, key: part[key], way, changed)[last] = value
            (tmp_path / "b.json").write_text(json.dumps(changed), encoding="utf-8")
            try:
                found = nf.lod.LodModel.load(tmp_path / "b.json")
            except nf.FormatError as error:
                assert "b.json" in str(error)  # noqa: PT017
                continue
            assert not (isinstance(value, float) and value != 1.5), (way, last, value)
            found.save(tmp_path / "c.json")
            assert str(nf.lod.LodModel.load(tmp_path / "c.json")) == str(found)
            loaded += 1
    assert loaded
