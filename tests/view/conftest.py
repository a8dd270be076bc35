"""Bundles for the decoder of the page, and a browser."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from tests.support import need
from tests.support.browser import started
from tests.support.bundled_scenes import bundled_scenes, export_all


@pytest.fixture(scope="session")
def bundles(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    return export_all(bundled_scenes(), tmp_path_factory.mktemp("bundles"))


@pytest.fixture(scope="module")
def chromium() -> Iterator[Any]:
    """A browser for the tests of a file: Playwright allows one at a time."""
    need("browser")
    with started() as program:
        yield program
