"""Scenes and bundles of the page's tests, each made once."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import nearfar as nf
from tests.support.bundled_scenes import bundled_scenes, export_all

CENTER = (3.0, 1.7, -2.0)


@pytest.fixture(scope="session")
def bundles(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    """Bundles for the decoder of the page."""
    return export_all(bundled_scenes(), tmp_path_factory.mktemp("bundles"))


@pytest.fixture(scope="session")
def city() -> nf.Scene:
    return nf.datasets.city(blocks=3, detail=1)


@pytest.fixture(scope="session")
def street(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A bundle of one ring around CENTER, which a page loads very quickly."""
    folder = tmp_path_factory.mktemp("street") / "bundle"
    settings: dict[str, Any] = {"center": CENTER, "radii": (10.0,), "face_size": 64, "samples": 1}
    nf.stream.export(nf.datasets.city(blocks=2, detail=1), folder, **settings)
    return folder
