"""Footprints: the solid angle of each object as seen from a centre."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import check
from nearfar._cubemap.lookup import cube_solid_angles
from nearfar._render.bake import bake
from nearfar._scene.scene import Scene, core_of

FACE_SIZE = 256
"""Texels along a face for measuring footprints; a texel spans 0.35 degrees."""


def footprints(scene: Scene, *, center: ArrayLike, face_size: int = FACE_SIZE) -> NDArray[np.float64]:
    """Measure the solid angle of the visible part of each object, over all six faces of a cube map.

    Parameters
    ----------
    scene
        The scene. Moving objects neither count nor hide others.
    center
        World position of the centre O, metres.
    face_size
        Texels along a face, 1 to 16384. Objects narrower than a texel may be missed.

    Returns
    -------
    NDArray
        (objects,) float64, steradians, by object number; the sum is at most 4π. The error of an object with an outline
        of L radians is about 0.4 L/`face_size`, from the texels that the outline cuts.

    Raises
    ------
    ValueError
        For a centre that is not finite and sizes out of range.
    TypeError
        For arguments of another type.

    References
    ----------
    CloVR (2024), "vis0" and "vis1": objects by their visible footprint.
    """
    core_of(scene)
    size = check.integer("face_size", face_size, 1, check.MAX_SIZE)
    middle = check.vector("center", center)
    settings: dict[str, Any] = {"size": size, "samples": 1, "half": False, "device": None}
    env, _ = bake(scene, middle, 0.0, channels=("object_id",), **settings)
    assert env.object_id is not None
    seen = env.object_id >= 0
    weights = np.broadcast_to(cube_solid_angles(size), env.object_id.shape)[seen]
    return np.bincount(env.object_id[seen], weights, len(scene.object_names)).astype(np.float64)
