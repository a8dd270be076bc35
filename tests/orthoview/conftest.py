"""Worlds and their trees, for all tests of orthoviews."""

from __future__ import annotations

import shutil
from pathlib import Path

import numpy as np
import pytest
import trimesh
from PIL import Image

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
    return copy_of(tree, tmp_path)


@pytest.fixture(scope="session")
def city(tmp_path_factory: pytest.TempPathFactory) -> nf.orthoview.OrthoTree:
    """A small city with second layers and with the geometry of its leaves, some of which are cars that could move."""
    need("zarr")
    path = tmp_path_factory.mktemp("trees") / "city.zarr"
    box = np.array([[-60.0, -9.0, -60.0], [59.0, 50.0, 59.0]])
    world = nf.datasets.city(blocks=2, detail=1)
    return nf.orthoview.build(world, path, cell=30, aabb=box, size=32, directions=9, layers=2)


@pytest.fixture(scope="session")
def textured(tmp_path_factory: pytest.TempPathFactory) -> nf.orthoview.OrthoTree:
    """A wall with a texture and a ball with colours of its corners and smooth normals, with the page in the store."""
    need("zarr")
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
    path = tmp_path_factory.mktemp("trees") / "textured.zarr"
    tree = nf.orthoview.build(nf.Scene.from_trimesh(world), path, cell=8, size=16, directions=5)
    nf.view.write_page(path)
    return tree


@pytest.fixture
def copied_city(city: nf.orthoview.OrthoTree, tmp_path: Path) -> Path:
    """A copy of the city's store, with the page in it."""
    path = copy_of(city, tmp_path)
    nf.view.write_page(path)
    return path


def copy_of(tree: nf.orthoview.OrthoTree, folder: Path) -> Path:
    """A copy of a tree's store in a folder."""
    path = folder / "copy.zarr"
    shutil.copytree(tree.path, path)
    return path
