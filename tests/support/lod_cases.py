"""Objects with several levels that need no files, and a slow definition of their measurement."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from nearfar._scene.builder import SceneBuilder
from nearfar.lod._measure import score_table, scores as level_scores

Array = NDArray[np.float64]

FOV = nf.Fov.symmetric(90.0)
SMALL: dict[str, Any] = {
    "fov": FOV,
    "size": (128, 128),
    "views": 8,
    "spacing": "published",
    "distances": 4,
    "standard_error": 0.0,
    "samples": 1,
    "backend": "cpu",
}


def ball(rows: int, *, bumps: float = 0.08) -> tuple[Array, NDArray[np.uint32]]:
    """Vertices and faces of a bumpy sphere about (3, −2, 1), 4 × rows × (rows − 1) triangles."""
    polar, around = np.linspace(0, np.pi, rows + 1), np.linspace(0, 2 * np.pi, 2 * rows, endpoint=False)
    theta, phi = (grid.ravel() for grid in np.meshgrid(polar, around, indexing="ij"))
    way = np.stack([np.sin(theta) * np.cos(phi), np.cos(theta), np.sin(theta) * np.sin(phi)], axis=1)
    radius = 1 + bumps * np.sin(5 * theta) * np.cos(4 * phi) + bumps / 2 * np.sin(9 * theta + 3 * phi) * np.sin(theta)
    columns = 2 * rows
    i, j = (grid.ravel() for grid in np.meshgrid(np.arange(rows), np.arange(columns), indexing="ij"))
    a, b = i * columns + j, i * columns + (j + 1) % columns
    upper, lower = np.stack([a, b, b + columns], axis=1), np.stack([a, b + columns, a + columns], axis=1)
    faces = np.concatenate([upper[i > 0], lower[i < rows - 1]])
    return way * radius[:, None] + (3, -2, 1), faces.astype(np.uint32)


def scene(rows: int, **options: Any) -> nf.Scene:
    return nf.Scene.from_arrays(*ball(rows, **options))


def smooth(rows: int) -> nf.Scene:
    """The sphere with vertex normals of an exact sphere."""
    builder = SceneBuilder()
    vertices, faces = ball(rows)
    builder.instance(builder.mesh(vertices, faces, normals=vertices - (3, -2, 1)), name="smooth")
    return builder.build()


def levels(*rows: int, name: str = "ball") -> nf.lod.Levels:
    """Levels of bumpy spheres with decreasing numbers of rows."""
    return nf.lod.Levels([nf.lod.Level(scene=scene(count), error=1 / count) for count in rows], name=name)


def checkered(rows: int) -> nf.Scene:
    """The sphere with a texture."""
    builder = SceneBuilder()
    board = np.kron((np.indices((8, 8)).sum(axis=0) % 2) * 200 + 30, np.ones((2, 2))).astype(np.uint8)
    texture = np.dstack([board, board[::-1], np.full_like(board, 120), np.full_like(board, 255)])
    vertices, faces = ball(rows)
    uvs = (vertices[:, :2] - vertices[:, :2].min(axis=0)) / np.ptp(vertices[:, :2], axis=0)
    builder.instance(
        builder.mesh(vertices, faces, material=builder.material((1, 1, 1, 1), texture), uvs=uvs), name="board"
    )
    return builder.build()


AXES = np.array([[1, 0, 0], [0, 1, 0], [1, 1, 0], [1, -1, 0]]) / np.sqrt([[1], [1], [2], [2]])


def fibonacci(views: int) -> Array:
    """Directions (V, 3) about z: equal steps along the axis, and the golden section of a circle around it."""
    along = np.linspace(1 - 1 / views, 1 / views - 1, views)
    around = np.exp(2j * np.pi * np.arange(views) * 2 / (3 + np.sqrt(5))) * np.sqrt(1 - along**2)
    return np.stack([around.real, around.imag, along], axis=1)


def turn(view: int, views: int, directions: str = "even") -> Array:
    """Rotation of the object for a view (Rodrigues).

    Published, a quarter of the views turns about each axis. Even, the shortest turn brings a direction to +z.
    """
    if directions == "published":
        steps = views // 4
        axis, angle = AXES[view // steps], 2 * np.pi * (view % steps) / steps
    else:
        side = fibonacci(views)[view]
        axis, angle = np.cross(side, (0, 0, 1)), np.arccos(side[2])
    x, y, z = axis / np.linalg.norm(axis)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    turned: Array = np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross
    return turned


def whole_camera(own: nf.lod.Levels, turned: Array, number: int, fov: nf.Fov, size: tuple[int, int]) -> nf.Camera:
    """The whole picture of a view, without a box: symmetric, as wide as `size`, at the number-th distance."""
    tangent = max(-fov.left, fov.right)
    pixel = (fov.right - fov.left) / size[0]
    nearest = own.radius / (0.25 * tangent) - own.radius
    distance = number * nearest + own.radius
    back = turned.T
    whole = nf.Fov(*(side * pixel / 2 for side in (-size[0], size[0], -size[1], size[1])))
    eye, up = own.center + distance * back[:, 2], back[:, 1]
    return nf.Camera.look_at(eye, own.center, fov=whole, size=size, up=up)


def luma_and_mask(scene: nf.Scene, camera: nf.Camera, samples: int) -> tuple[Array, NDArray[np.bool_]]:
    frame = nf.render(scene, camera, samples=samples, channels=("color", "range"), backend="cpu")
    codes = frame.to_image().astype(np.float64)
    luma: Array = 0.2126 * codes[..., 0] + 0.7152 * codes[..., 1] + 0.0722 * codes[..., 2]
    return luma, np.isfinite(frame.require("range"))


def straightforward(
    own: nf.lod.Levels,
    views: int,
    numbers: Sequence[int],
    fov: nf.Fov,
    size: tuple[int, int],
    samples: int,
    similarity: Any,
    directions: str = "even",
) -> Array:
    """Scores (K, D, V): whole pictures of base and level, compared one by one for each level, view and distance."""
    found = np.empty((len(own), len(numbers), views))
    for k, level in enumerate(own):
        for d, number in enumerate(numbers):
            for view in range(views):
                camera = whole_camera(own, turn(view, views, directions), number, fov, size)
                base, first = luma_and_mask(own[0].scene, camera, samples)
                test, second = luma_and_mask(level.scene, camera, samples)
                found[k, d, view] = similarity(base, test, first | second)
    return found


def assert_same(one: nf.lod.LodModel, other: nf.lod.LodModel) -> None:
    """Check that models are equal bit for bit, except for counts of work."""
    assert one.samples is not None
    assert other.samples is not None
    assert (one.name, one.radius, one.sigma) == (other.name, other.radius, other.sigma)
    for name in ("triangles", "errors", "center"):
        np.testing.assert_array_equal(getattr(one, name), getattr(other, name))
    for name in ("a", "b", "c", "d", "rms", "status", "reason"):
        np.testing.assert_array_equal(getattr(one.curves, name), getattr(other.curves, name))
    for name in ("sigma", "score", "views"):
        np.testing.assert_array_equal(getattr(one.samples, name), getattr(other.samples, name))


def count_renders(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """Record the pictures of each block of views that `measure` compares from now on."""
    counted: list[int] = []

    def scores(base: nf.Scene, levels: Sequence[level_scores.Compared], cameras: Any, *rest: Any) -> Any:
        counted.append(len(cameras) + sum(len(level.indices) for level in levels))
        return level_scores.scores(base, levels, cameras, *rest)

    monkeypatch.setattr(score_table, "scores", scores)
    return counted
