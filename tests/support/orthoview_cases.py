"""Scenes and formats for tests of orthoviews."""

from __future__ import annotations

import functools
from typing import Any

import numpy as np
import trimesh
from numpy.typing import NDArray

import nearfar as nf
from nearfar import _core
from nearfar._scene.srgb import to_linear
from tests.support import orthoview_oracle as oracle
from tests.support.orthoview_oracle import DIRECTIONS, Picture

SIZE, SIDE = 32, 20.0
CORNER = np.array([40.0, -3.0, -60.0])
FORMAT = (SIZE, 12, 24)
STEPS = oracle.steps_of(12)


@functools.cache
def boxes(count: int = 40, side: float = SIDE, height: float = 1.0) -> tuple[nf.Scene, NDArray[np.float64]]:
    """Rotated boxes in and about a cell, with the linear RGB of each triangle; `height` scales them along y."""
    rng = np.random.default_rng(3)
    parts = []
    for _ in range(count):
        box = trimesh.creation.box(rng.uniform(0.03, 0.25, 3) * side)
        turn = trimesh.transformations.random_rotation_matrix(rng.random(3))
        turn[:3, 3] = CORNER + rng.uniform(-0.1, 1.1, 3) * side
        parts.append(box.apply_transform(turn))
    mesh = trimesh.util.concatenate(parts)
    mesh.vertices[:, 1] = CORNER[1] + height * (mesh.vertices[:, 1] - CORNER[1])
    corners = mesh.triangles.reshape(-1, 3)
    codes = rng.integers(0, 256, (len(mesh.faces), 3))
    rgba = np.column_stack([np.repeat(codes, 3, axis=0), np.full(len(corners), 255)]).astype(np.uint8)
    loose = trimesh.Trimesh(corners, np.arange(len(corners)).reshape(-1, 3), vertex_colors=rgba, process=False)
    return nf.Scene.from_trimesh(loose), to_linear(codes / 255)


def leaf(
    scene: nf.Scene,
    corner: Any = CORNER,
    side: float = SIDE,
    directions: Any = None,
    way: str | None = None,
    behind: bool = False,
) -> _core.OrthoViews:
    return _core.OrthoViews.of_cell(
        scene._core, (tuple(corner), side), directions or DIRECTIONS, FORMAT, method=way, behind=behind
    )


def picture(views: _core.OrthoViews, number: int) -> Picture:
    """A view of the core: depth as the index of its step, from 0."""
    depths = views.depths()[number, ..., 0].astype(np.float64)
    return Picture(
        np.where(depths > 0, depths - 1, np.inf),
        to_linear(views.colors()[number] / 255),
        oracle.decoded(views.normals()[number], 12),
    )


def check_alike(got: Picture, right: Picture, *, share: float) -> None:
    """Check depth within the step of its surface, colour within half a code, and normals within the codes' cells."""
    is_there = np.isfinite(right.depth)
    apart = is_there != np.isfinite(got.depth)
    both = is_there & ~apart
    steps = np.abs(got.depth - np.minimum(np.floor(right.depth), STEPS - 1))[both]
    colors = np.abs(got.color - right.color)[both].max(axis=1)
    angles = np.degrees(np.arccos(np.clip((got.normal * right.normal).sum(axis=2)[both], -1, 1)))
    # Rays through edges, and depths at the border between two steps, fall on either side in float32.
    wrong = apart.sum() + ((steps > 0) | (colors > 0.006) | (angles > 0.1)).sum()
    assert wrong <= share * is_there.sum(), (apart.sum(), steps.max(), colors.max(), angles.max())
