"""Models exported by other programs look like the plain files that they were made from."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import nearfar as nf
from tests.support import need
from tests.support.exporters import FULL, SOURCES, cameras, pictures, render_views, scene, share, shared
from tests.support.exporters_cases import CASES, DEFAULTS
from tests.support.exporters_run import EXPORTERS, transform

pytestmark = pytest.mark.slow

MIN = 0.999
"""Least share of pixels within 1/255 of the plain file's."""

NEEDS = {"gltfpack": "exporters", "glTF-Transform": "exporters", "Blender": "blender", "Assimp": "assimp"}
"""Required parts of exporters; trimesh is always present."""


@pytest.mark.parametrize("exporter", EXPORTERS)
def test_exported_models_look_like_the_plain_files(exporter: str, tmp_path: Path) -> None:
    need("data")
    if exporter in NEEDS:
        need(NEEDS[exporter])
    EXPORTERS[exporter](CASES[exporter], tmp_path)
    shares = {f"{case.source}, {case.settings}": share(case, tmp_path / case.file) for case in CASES[exporter]}
    assert {name: found for name, found in shares.items() if not found >= MIN} == {}


def test_there_are_forty_models_by_five_exporters() -> None:
    assert len(CASES) == 5
    assert sum(map(len, CASES.values())) >= 40
    assert {case.source for cases in CASES.values() for case in cases} == set(SOURCES)


@pytest.mark.parametrize("source", SOURCES)
def test_pictures_show_the_models(source: str) -> None:
    """Otherwise every model would look like the plain file."""
    need("data")
    for camera in cameras(source):
        frame = nf.render(scene(source), camera, channels=("coverage",), samples=1, backend="cpu")
        assert frame.require("coverage").mean() > 0.1


def test_coarsely_quantised_models_look_as_in_another_reader(tmp_path: Path) -> None:
    """By default gltfpack moves edges by more than a thousandth of all pixels; glTF-Transform reads the same file."""
    need("data")
    need("exporters")
    EXPORTERS["gltfpack"](DEFAULTS, tmp_path)
    decoded = [(tmp_path / case.file, tmp_path / f"decoded-{case.file}") for case in DEFAULTS]
    transform([(*paths, [["dequantize", {}], ["decode", {}]]) for paths in decoded], tmp_path)
    for case, (packed, plain) in zip(DEFAULTS, decoded, strict=True):
        assert not nf._base.glb.header(plain.read_bytes())[0].get("extensionsRequired")
        ours, theirs = (render_views(nf.Scene.load(path), case.source, FULL) for path in (packed, plain))
        assert shared(ours, theirs) >= MIN, case
        assert np.any(np.asarray(ours) != np.asarray(pictures(case.source, FULL)))
