"""Tests of pickled scenes: the same pictures, byte for byte, and the same poses."""

from __future__ import annotations

import copy
import pickle
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar._base import cache
from nearfar._scene.builder import SceneBuilder
from nearfar._scene.serialize import core_of_parts, parts_of


def furnished() -> nf.Scene:
    """Instances, a cut-out texture, vertex colours and normals, a moving object, far from the origin."""
    builder = SceneBuilder()
    random = np.random.default_rng(0)
    texture = random.integers(0, 256, (8, 8, 4)).astype(np.uint8)
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.0]])
    faces = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])
    uvs = random.uniform(0, 2, (4, 2))
    board = builder.mesh(corners, faces, material=builder.material((1, 1, 1, 1), texture, 0.4), uvs=uvs)
    colors = random.integers(0, 256, (4, 4)).astype(np.uint8)
    tinted = builder.mesh(2 * corners, faces, colors=colors, normals=corners - 0.25)
    for n in range(3):
        place = np.eye(4)
        place[:3, 3] = (1.5 * n - 1 + 50_000, 0.2 * n, -n)
        builder.instance(board, place, name=f"board{n}")
    place = np.eye(4)
    place[:3, 3] = (50_000, -1, 0)
    builder.instance(tinted, place, name="tinted")
    return builder.build(["board1"])


SCENES: dict[str, Callable[[], nf.Scene]] = {
    "furnished": furnished,
    "city": lambda: nf.datasets.city(blocks=2, detail=0),
    "nameless": lambda: nf.Scene.from_arrays(np.eye(3), [[0, 1, 2]], face_object=[5]),
    "empty": lambda: nf.Scene.from_arrays(np.eye(3), [[0, 1, 2]]).subset(triangles=[]),
}


def picture(scene: nf.Scene) -> dict[str, Any]:
    low, high = (50_000 - np.ones(3), 50_000 + np.ones(3)) if not scene.triangle_count else scene.bounds
    middle, size = (low + high) / 2, np.linalg.norm(high - low)
    eye = middle + size * np.array([0.3, 0.4, 0.8])
    camera = nf.Camera.look_at(eye, middle, fov=nf.Fov.symmetric(70), size=(64, 64))
    frame = nf.render(scene, camera, channels=("color", "range", "object_id", "face_id"), samples=2, backend="cpu")
    return {name: frame.require(name) for name in frame.channels}


@pytest.mark.parametrize("name", SCENES)
@pytest.mark.parametrize(
    "way", [lambda scene: pickle.loads(pickle.dumps(scene)), copy.deepcopy], ids=["pickle", "copy"]
)
def test_pictures_of_pickled_scenes_have_the_same_bytes(name: str, way: Any) -> None:
    scene = SCENES[name]()
    back = way(scene)
    assert back.object_names == scene.object_names
    assert back.report == scene.report
    np.testing.assert_array_equal(back.origin, scene.origin)
    np.testing.assert_array_equal(back.triangles(), scene.triangles())
    seen = picture(back)
    for channel, image in picture(scene).items():
        np.testing.assert_array_equal(seen[channel], image)


def test_moving_objects_can_be_posed_as_before() -> None:
    scene = furnished()
    back = pickle.loads(pickle.dumps(scene))
    pose = scene.transform("board1").copy()
    np.testing.assert_array_equal(back.transform("board1"), pose)
    pose[:3, 3] += (0.3, 0.5, 0)
    one, other = picture(scene.at({"board1": pose})), picture(back.at({"board1": pose}))
    assert not np.array_equal(one["color"], picture(scene)["color"])
    for channel in one:
        np.testing.assert_array_equal(one[channel], other[channel])


def test_shared_meshes_are_pickled_once() -> None:
    scene = furnished()
    parts = parts_of(scene._core)
    assert len(parts["meshes"]) < scene.report.instances
    assert len(np.unique(core_of_parts(parts).mesh_ids())) == scene.report.meshes


def test_hashes_depend_on_content_only(tmp_path: Path) -> None:
    key = cache.key(parts_of(furnished()._core))
    code = "from tests.scene import test_serialize as own\nprint(own.cache.key(own.parts_of(own.furnished()._core)))"
    process = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=600)
    assert process.stdout.strip() == key
    moved = furnished().at({"board1": np.eye(4)})
    assert cache.key(parts_of(moved._core)) != key
