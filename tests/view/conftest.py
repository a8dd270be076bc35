"""Bundles for the decoder of the page."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.support.bundled_scenes import bundled_scenes, export_all


@pytest.fixture(scope="session")
def bundles(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    return export_all(bundled_scenes(), tmp_path_factory.mktemp("bundles"))
