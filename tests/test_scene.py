"""The scene: what is merged, what is shared, what may move."""

from __future__ import annotations

import numpy as np

from nearfar._scene import SceneBuilder

TRIANGLE = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], np.float32)
FACE = np.array([[0, 1, 2]], np.uint32)


def shift(x: float = 0.0, y: float = 0.0, z: float = 0.0) -> np.ndarray:
    matrix = np.eye(4)
    matrix[:3, 3] = x, y, z
    return matrix


def street() -> tuple[SceneBuilder, list[int]]:
    """A wall and a house used once, three trees of one mesh, and a car."""
    builder = SceneBuilder()
    meshes = [builder.mesh(TRIANGLE, FACE, material=builder.material((r, 0, 0, 1))) for r in (0, 0.25, 0.5, 1)]
    builder.instance(meshes[0], name="wall")
    builder.instance(meshes[1], shift(5), name="house")
    builder.place_many(meshes[2], np.stack([shift(z=k) for k in range(3)]), "tree")
    builder.instance(meshes[3], shift(y=2), name="car")
    return builder, meshes


def test_what_is_used_once_is_merged_and_the_rest_are_instances() -> None:
    scene = street()[0].build()
    assert scene.object_names == ("wall", "house", "tree_0", "tree_1", "tree_2", "car")
    assert (scene.report.instances, scene.report.meshes, scene.triangle_count) == (4, 2, 6)
    assert street()[0].build(["car"]).report.instances == 5
    np.testing.assert_array_equal(scene.bounds, [[0, 0, 0], [6, 3, 2]])
