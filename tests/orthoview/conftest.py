"""A world and its tree, for all tests of orthoviews."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

import nearfar as nf
from tests.support import need
from tests.support.orthoview_cases import boxes
from tests.support.orthoview_stores import CELL, SIZE


@pytest.fixture(scope="session")
def world() -> nf.Scene:
    """Boxes in a world of 9 × 9 × 9 leaves or so, dense in one corner and empty in others."""
    return boxes(60, 80.0)[0]


@pytest.fixture(scope="session")
def tree(world: nf.Scene, tmp_path_factory: pytest.TempPathFactory) -> nf.orthoview.OrthoTree:
    need("zarr")
    path = tmp_path_factory.mktemp("trees") / "world.zarr"
    return nf.orthoview.build(world, path, cell=CELL, size=SIZE, directions=5)


@pytest.fixture
def copied(tree: nf.orthoview.OrthoTree, tmp_path: Path) -> Path:
    """A copy of the tree's store."""
    path = tmp_path / "copy.zarr"
    shutil.copytree(tree.path, path)
    return path
