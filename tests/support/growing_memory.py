"""Calls whose memory grows with their input, with inputs for which they need some 70 to 500 MB."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import trimesh
from PIL import Image

import nearfar as nf
from tests.support.valid_calls.objects import EYE, Valid

FRACTIONS, LEAST_BYTES = (0.2, 0.7), 1 << 20
"""Parts of a call's need beyond the headroom that remain, and the least need for which they are tried."""

TEXTURE = 5000
"""Width and height of a texture, texels."""


def _half(valid: Valid) -> trimesh.Trimesh:
    """The first half of the triangles, which have the first half of the vertices."""
    return trimesh.Trimesh(*(rows[: len(rows) // 2] for rows in (valid.vertices, valid.faces)), process=False)


def _glb(valid: Valid) -> Path:
    """A file with so many triangles that reading them takes much more memory than the headroom."""
    path = valid.folder / "triangles.glb"
    if not path.exists():
        part = trimesh.Trimesh(valid.vertices, valid.faces, process=False)
        trimesh.util.concatenate([part] * 3).export(path)
    return path


def _textured_glb(valid: Valid) -> Path:
    """A file with one triangle and a large texture in PNG."""
    path = valid.folder / "texture.glb"
    if not path.exists():
        triangle = trimesh.Trimesh(np.eye(3), [[0, 1, 2]], process=False)
        image = Image.fromarray(np.zeros((TEXTURE, TEXTURE, 3), np.uint8))
        triangle.visual = trimesh.visual.TextureVisuals(uv=np.eye(3)[:, :2], image=image)
        triangle.export(path)
    return path


def _small_scene(valid: Valid) -> nf.Scene:
    """A scene of one triangle in the place of the large one."""
    return nf.Scene.from_arrays(valid.vertices[valid.faces[:1]].reshape(3, 3), [[0, 1, 2]])


CALLS: dict[str, Callable[[Valid], dict[str, Any]]] = {
    "Frame.save": lambda v: {},
    "Scene.load @glb": lambda v: {"path": _glb(v)},
    "Scene.load @png": lambda v: {"path": _textured_glb(v)},
    "Scene.subset": lambda v: {"objects": None, "triangles": np.arange(0, len(v.faces), 2)},
    "bend_rays": lambda v: {"directions": v.directions[:500_000]},
    "cast_rays": lambda v: {"origins": np.tile(EYE, (len(v.directions), 1))},
    "lod.simplify": lambda v: {"mesh": _half(v), "method": "meshopt"},
    "lod.simplify @fast": lambda v: {"mesh": _half(v)},
    "metrics.discontinuity": lambda v: {},
    "morph": lambda v: {},
    "nearest_points": lambda v: {},
    "orthoview.build": lambda v: {"source": _small_scene(v), "size": 512, "geometry": False},
    "reduce": lambda v: {"face_size": 1024},
    "render": lambda v: {"channels": ("color", "range", "position", "normal")},
    "ssim": lambda v: {"full": True},
    "stream.bake_maps": lambda v: {"face_size": 1024},
    "stream.export": lambda v: {"face_size": 512},
}
"""Changes of the arguments of calls in `valid_calls`, by the call's name; what follows " @" tells calls apart."""
