"""Worlds and their trees, shared by all tests of orthoviews. Trees are built once; tests that change one copy it."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
import trimesh
from PIL import Image

import nearfar as nf
from tests.support import need
from tests.support.flight_cases import Gate, gated
from tests.support.orthoview_cases import boxes
from tests.support.orthoview_stores import CELL, SIZE, built_once, few_boxes, layered_tree, world_of
from tests.support.shared_folders import make_once

Tree = nf.orthoview.OrthoTree


@pytest.fixture(scope="session")
def world() -> nf.Scene:
    """Boxes in a world of 12 × 11 × 12 leaves."""
    return boxes(24, 80.0)[0]


@pytest.fixture(scope="session")
def tree(world: nf.Scene, tmp_path_factory: pytest.TempPathFactory) -> Tree:
    return built_once(tmp_path_factory, "world.zarr", world, cell=CELL, size=SIZE, directions=5)


@pytest.fixture(scope="session")
def few() -> nf.Scene:
    """A few boxes in several subtrees, for tests that build."""
    return few_boxes()


@pytest.fixture(scope="session")
def few_tree(few: nf.Scene, tmp_path_factory: pytest.TempPathFactory) -> Tree:
    return built_once(tmp_path_factory, "few.zarr", few, cell=CELL, size=SIZE, directions=5)


@pytest.fixture(scope="session")
def thirty() -> nf.Scene:
    """Thirty boxes."""
    return world_of(range(30))


@pytest.fixture(scope="session")
def layered(tmp_path_factory: pytest.TempPathFactory) -> Tree:
    """A tree of the thirty boxes."""
    return layered_tree(tmp_path_factory)


@pytest.fixture
def gate(monkeypatch: pytest.MonkeyPatch) -> Iterator[Gate]:
    """A gate for all reads of flights."""
    with gated(monkeypatch) as gate:
        yield gate


@pytest.fixture
def copied_few(few_tree: Tree, tmp_path: Path) -> Path:
    """A copy of the store with few boxes."""
    return copy_of(few_tree, tmp_path)


@pytest.fixture
def copied(tree: Tree, tmp_path: Path) -> Path:
    """A copy of the tree's store."""
    return copy_of(tree, tmp_path)


@pytest.fixture(scope="session")
def city(tmp_path_factory: pytest.TempPathFactory) -> Tree:
    """A small city with second layers and with the geometry of its leaves, including cars that may move."""
    box = np.array([[-60.0, -9.0, -60.0], [59.0, 50.0, 59.0]])
    world = nf.datasets.city(blocks=2, detail=1)
    return built_once(tmp_path_factory, "city.zarr", world, cell=30, aabb=box, size=32, directions=9, layers=2)


@pytest.fixture(scope="session")
def textured(tmp_path_factory: pytest.TempPathFactory) -> Tree:
    """A wall with a texture and a ball with vertex colours and smooth normals, with the page in the store."""
    codes = np.random.default_rng(5).integers(0, 255, (8, 8, 3), np.uint8)
    wall = trimesh.creation.box((16.0, 8.0, 1.0))
    image = Image.fromarray(codes)
    wall.visual = trimesh.visual.TextureVisuals(uv=np.asarray(wall.vertices)[:, :2] / 6.0, image=image)
    ball = trimesh.creation.icosphere(2, 2.0)
    ball.apply_translation((-1.0, 1.0, 3.0))
    ball.visual.vertex_colors = np.random.default_rng(6).integers(0, 255, (len(ball.vertices), 4), np.uint8)
    world = trimesh.Scene()
    world.add_geometry(wall, node_name="wall")
    world.add_geometry(ball, node_name="ball")
    scene = nf.Scene.from_trimesh(world)

    def make(path: Path) -> None:
        nf.orthoview.build(scene, path, cell=8, size=16, directions=5)
        nf.view.write_page(path)

    need("zarr")
    return nf.orthoview.open(make_once(tmp_path_factory, "textured.zarr", make))


@pytest.fixture
def copied_city(city: Tree, tmp_path: Path) -> Path:
    """A copy of the city's store, with the page in it."""
    path = copy_of(city, tmp_path)
    nf.view.write_page(path)
    return path


def copy_of(tree: Tree, folder: Path) -> Path:
    """A copy of a tree's store in a folder."""
    path = folder / "copy.zarr"
    shutil.copytree(tree.path, path)
    return path
