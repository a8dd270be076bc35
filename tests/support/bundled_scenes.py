"""Scenes whose bundles cover all features of geometry and maps, with compression and without."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

import nearfar as nf
from tests.support import normal_cases

SCENES: dict[str, dict[str, Any]] = {
    # Copies in several rings, coloured vertices and moving cars; images and moving objects; vertex normals, copies
    # that are mirrored, stretched and sheared, and a cut-out.
    "city": {"center": (3.0, 1.7, -2.0), "radii": [10.0, 22.0, 63.0]},
    "room": {"center": (0.3, 1.6, 0.2), "radii": [1.5, 3.0]},
    "balls": {"center": (0.0, 1.0, 0.0), "radii": [8.0, 12.0]},
}
"""Centre and radii of the bundle of each scene."""

NAMES = [f"{scene}-{kind}" for scene in SCENES for kind in ("packed", "plain")]
"""Bundles: a scene, and whether its arrays are compressed."""


def balls() -> nf.Scene:
    """Copies of one ball on a circle, and a picture with a hole in the middle of it."""
    vertices, faces = normal_cases.ball(2)
    builder = nf.SceneBuilder()
    mesh = builder.mesh(vertices, faces, normals=vertices, material=builder.material(base_color=(0.7, 0.3, 0.1, 1)))
    shear = np.eye(4)
    shear[0, 1] = 0.7
    kinds = [*normal_cases.PLACES.values(), shear]
    for number in range(12):
        angle = number * np.pi / 6
        place = np.eye(4)
        place[:3, 3] = 9 * np.cos(angle), 1, 9 * np.sin(angle)
        builder.instance(mesh, place @ kinds[number % len(kinds)], name=f"ball {number}")
    texels = np.zeros((64, 32, 4), np.uint8)
    texels[..., 0], texels[..., 1] = np.arange(32) * 8, np.arange(64)[:, None] * 4
    # Half visible around a circle, so that colour and alpha must stay separate.
    texels[..., 3] = 255 * np.clip((np.hypot(*np.mgrid[-20:44, -16:16]) - 9) / 6, 0, 1)
    leaf = builder.material(texture=texels, cutoff=0.5)
    corners, uvs = [[-4, 0, 0], [4, 0, 0], [4, 6, 0], [-4, 6, 0]], [[0, 0], [1, 0], [1, 1], [0, 1]]
    builder.instance(builder.mesh(corners, [[0, 1, 2], [0, 2, 3]], material=leaf, uvs=uvs), name="leaf")
    ground = builder.mesh([[-9, 0, -9], [-9, 0, 9], [9, 0, 9], [9, 0, -9]], [[0, 1, 2], [0, 2, 3]])
    builder.instance(ground, name="ground")
    return builder.build(dynamic=["ball 0", "ball 1"])


def bundled_scenes() -> dict[str, nf.Scene]:
    """The scenes by their names."""
    return {"city": nf.datasets.city(blocks=2, detail=1), "room": nf.datasets.room(), "balls": balls()}


def export_all(scenes: Mapping[str, nf.Scene], folder: Path) -> dict[str, Path]:
    """Export all bundles into folders; returns them by name."""
    for name in NAMES:
        scene, kind = name.split("-")
        settings = {**SCENES[scene], "face_size": 64, "samples": 1}
        settings["compression"] = "meshopt" if kind == "packed" else None
        nf.stream.export(scenes[scene], folder / name, **settings)
    return {name: folder / name for name in NAMES}


def farthest(found: NDArray[Any], expected: NDArray[Any]) -> float:
    """Greatest difference on an axis between triangles (N, 3, 3) and the nearest of others, in metres, both ways.

    Readers reverse mirrored faces in different ways, so the order of corners does not matter.
    """
    assert len(found) == len(expected)
    some, others = (
        np.concatenate([triangles.min(axis=1), triangles.max(axis=1), triangles.mean(axis=1)], axis=1)
        for triangles in (found, expected)
    )
    pairs = ((some, others), (others, some))
    return max(float(cKDTree(a).query(b, p=np.inf)[0].max()) for a, b in pairs)
