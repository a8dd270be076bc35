"""Pyrender as a peer: it draws by OpenGL, in software if there is no GPU."""

from __future__ import annotations

import importlib.util
import os
import warnings
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from nearfar._camera.rotation import rotation


def pyrender() -> Any:
    """Import pyrender for a machine without a screen; None if it is not installed."""
    if importlib.util.find_spec("pyrender") is None:
        return None
    os.environ.setdefault("PYOPENGL_PLATFORM", "egl")
    vars(np).setdefault("infty", np.inf)  # pyrender 0.1.45 was written for NumPy 1
    with warnings.catch_warnings(action="ignore"):
        import pyrender as peer
    return peer


def pose_of(camera: nf.Camera, origin: Any = (0.0, 0.0, 0.0)) -> NDArray[np.float64]:
    """Matrix (4, 4) from the camera's frame to the world's, relative to an origin."""
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = rotation(camera.orientation), np.subtract(camera.position, origin)
    return pose


def scene_of(
    mesh: Any, camera: nf.Camera, *, origin: Any = (0.0, 0.0, 0.0), near: float = 1.0, far: float = 1e4, **settings: Any
) -> Any:
    """Return pyrender's scene of one mesh, whose coordinates are relative to an origin, with a camera."""
    peer, fov = pyrender(), camera.fov
    assert isinstance(fov, nf.Fov)
    scene = peer.Scene(**settings)
    scene.add(mesh)
    eye = peer.PerspectiveCamera(2 * np.arctan(fov.up), near, far, camera.width / camera.height)
    scene.add(eye, pose=pose_of(camera, origin))
    return scene
