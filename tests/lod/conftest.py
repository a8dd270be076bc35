"""Fixtures shared by tests of levels of detail."""

from __future__ import annotations

from pathlib import Path

import pytest

import nearfar as nf
from tests.support import need
from tests.support.leveled_cases import model_of

METHODS = ("fast", "meshopt")


@pytest.fixture(scope="module")
def models() -> list[nf.lod.LodModel]:
    return [model_of((4, 3, 2), name="ball"), model_of((3, 1), name="egg", stretch=(0.5, 1.5, 0.7))]


@pytest.fixture(params=METHODS)
def method(request: pytest.FixtureRequest) -> str:
    need("fast_simplification")
    return str(request.param)


@pytest.fixture
def fresh_cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Give a test an empty cache."""
    monkeypatch.setenv("NEARFAR_CACHE", str(tmp_path / "cache"))
