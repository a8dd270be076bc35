"""Calls whose memory grows with their input, with inputs of which kernels need some 50 to 500 MB."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import trimesh
from PIL import Image

from tests.support.valid_calls.objects import Valid

FRACTIONS = (0.2, 0.7)
"""Parts of a call's need beyond the headroom that remain."""

TEXTURE = 5000
"""Width and height of a texture, texels."""


def _mesh(valid: Valid) -> trimesh.Trimesh:
    """The triangles of the scene's object "near", a fifth of them."""
    return trimesh.Trimesh(valid.vertices, valid.faces[: len(valid.faces) // 5], process=False)


def _glb(valid: Valid) -> Path:
    """A file with many triangles."""
    path = valid.folder / "triangles.glb"
    if not path.exists():
        trimesh.Trimesh(valid.vertices, valid.faces, process=False).export(path)
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


CALLS: dict[str, Callable[[Valid], dict[str, Any]]] = {
    "Frame.save": lambda v: {},
    "Scene.load @glb": lambda v: {"path": _glb(v)},
    "Scene.load @png": lambda v: {"path": _textured_glb(v)},
    "Scene.subset": lambda v: {"objects": None, "triangles": np.arange(0, len(v.faces), 2)},
    "bend_rays": lambda v: {"directions": v.directions[:500_000]},
    "cast_rays": lambda v: {},
    "lod.simplify": lambda v: {"mesh": _mesh(v)},
    "metrics.discontinuity": lambda v: {},
    "morph": lambda v: {},
    "nearest_points": lambda v: {},
    "orthoview.build": lambda v: {"size": 512},
    "reduce": lambda v: {"face_size": 1024},
    "render": lambda v: {"channels": ("color", "range", "position", "normal")},
    "ssim": lambda v: {"full": True},
    "stream.bake_maps": lambda v: {"face_size": 1024},
    "stream.export": lambda v: {"face_size": 512},
}
"""Changes of the arguments of calls in `valid_calls`, by the call's name; what follows " @" tells calls apart."""
