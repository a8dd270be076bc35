"""A small scene whose bundle has files of every kind, and the reading of all of them by a client."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

import nearfar as nf
from tests.support.reduce_cases import box

SETTINGS: dict[str, Any] = {"center": (0.0, 1.7, 0.0), "radii": (5.0, 12.0), "face_size": 64, "samples": 1}


def village(*, height: float = 3.0) -> nf.Scene:
    """Ground with a texture, a wall, a mesh in both rings, and a moving car."""
    builder = nf.SceneBuilder()
    noise = np.random.default_rng(8).integers(0, 255, (8, 8, 4), np.uint8)
    noise[..., 3] = 255
    painted = builder.material((1, 1, 1, 1), texture=noise)
    corners, faces = box((-30, -0.5, -30), (30, 0, 30))
    builder.instance(builder.mesh(corners, faces, material=painted, uvs=corners[:, [0, 2]]), name="ground")
    builder.instance(builder.mesh(*box((-9, 0, -10), (9, height, -9))), name="wall")
    post = builder.mesh(*box((-0.2, 0, -0.2), (0.2, 2, 0.2)))
    for name, x, z in (("near", 3, -2), ("far", -8, 3), ("beyond", 20, 4)):
        matrix = np.eye(4)
        matrix[:3, 3] = (x, 0, z)
        builder.instance(post, matrix, name=name)
    builder.instance(builder.mesh(*box((1, 0, -5), (3, 1.5, -4))), name="car")
    return builder.build(dynamic=["car"])


def write(path: str | Path, **changes: Any) -> nf.stream.Bundle:
    """Export the village; `height` is that of its wall."""
    scene = village(height=changes.pop("height", 3.0))
    return nf.stream.export(scene, path, **{**SETTINGS, **changes})


def use(bundle: nf.stream.Bundle) -> None:
    """Read all that a client reads."""
    for ring in range(bundle.count + 1):
        bundle.at(ring)


def content(folder: Path) -> dict[str, bytes]:
    """Files of a folder by their paths in it."""
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*") if path.is_file()}
