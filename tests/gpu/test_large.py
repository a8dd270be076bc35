"""Tests of scenes and images that exceed an adapter's limits and are drawn in parts."""

from __future__ import annotations

import numpy as np
import pytest

import nearfar as nf
from tests.support.gpu_cases import check_color, check_ids

pytestmark = pytest.mark.usefixtures("backend")


def grid(cells: int) -> nf.Scene:
    """Return a square of 1 m cells in the ground plane, two triangles each, row by row along +z."""
    x, z = np.meshgrid(np.arange(cells + 1, dtype=np.float32), np.arange(cells + 1, dtype=np.float32))
    vertices = np.stack([x, np.zeros_like(x), z], axis=-1).reshape(-1, 3)
    corner = (np.arange(cells)[:, None] * (cells + 1) + np.arange(cells)).reshape(-1).astype(np.uint32)
    a, b, c, d = corner, corner + 1, corner + cells + 1, corner + cells + 2
    faces = np.stack([a, c, b, b, c, d], axis=-1).reshape(-1, 3)
    return nf.Scene.from_arrays(vertices, faces)


@pytest.mark.slow
def test_a_mesh_larger_than_a_binding_is_drawn_page_by_page(backend: str) -> None:
    cells = 2200
    scene = grid(cells)
    bound = next(found.largest_binding for found in nf.gpu.adapters() if found.backend == backend)
    # Three words for each face, and as many for half as many vertices.
    if 18 * scene.triangle_count <= bound:
        pytest.skip("this adapter binds the whole mesh")
    size = 300
    # A view from above gives exact ground positions; no pixel's centre lies on an edge.
    camera = nf.Camera(
        (cells / 2 + 0.21, 10.0, cells / 2 + 0.13),
        (-np.sqrt(0.5), 0.0, 0.0, np.sqrt(0.5)),
        fov=nf.Orthographic(-1000.0, 1000.0, -1000.0, 1000.0),
        size=(size, size),
    )
    frame = nf.render(scene, camera, channels=("face_id", "range"), backend="gpu")
    starts = camera.rays()[0]
    column, row = np.floor(starts[..., 0]).astype(np.int64), np.floor(starts[..., 2]).astype(np.int64)
    beyond = (starts[..., 0] - column) + (starts[..., 2] - row) > 1
    expected = 2 * (row * cells + column) + beyond
    assert np.array_equal(frame.require("face_id"), expected)
    assert np.allclose(frame.require("range"), 10.0, rtol=1e-6, atol=0)


def test_many_instances_and_distinct_meshes() -> None:
    scene = nf.datasets.forest(trees=2000, seed=3, detail=1)
    low, high = scene.bounds
    eye = (0.0, float(high[1]) + 5.0, float(high[2]))
    camera = nf.Camera.look_at(eye, (0.0, 0.0, float(low[2]) / 2), fov=nf.Fov.symmetric(70), size=(160, 120))
    cpu, gpu = (
        nf.render(scene, camera, channels=("color", "object_id", "face_id"), backend=backend)
        for backend in ("cpu", "gpu")
    )
    check_ids(cpu.require("object_id"), gpu.require("object_id"), 0.995)
    check_ids(cpu.require("face_id"), gpu.require("face_id"), 0.99)
    check_color(cpu, gpu, percentile=99.0)
