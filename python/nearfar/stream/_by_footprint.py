"""Footprints of objects (visible solid angles from a centre), and portions of objects in their order (vis0, vis1)."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import check, side_by_side
from nearfar._cubemap.envmap import EnvMap
from nearfar._cubemap.lookup import cube_solid_angles
from nearfar._render.bake import bake
from nearfar._scene.scene import Scene, core_of
from nearfar.stream import _map_files as codec
from nearfar.stream._assign import Rings, loads
from nearfar.stream._map_files import RangeScale
from nearfar.stream._maps import TILE
from nearfar.stream._store import Files

FACE_SIZE = 256
"""Texels along a face for measuring footprints; a texel spans 0.35 degrees."""

PORTIONS = 32
"""Greatest number of files that the objects of a region are divided into."""


def footprints(scene: Scene, *, center: ArrayLike, face_size: int = FACE_SIZE) -> NDArray[np.float64]:
    """Measure the solid angle of the visible part of each object, over all six faces of a cube map.

    Returns (objects,) float64, steradians, by object number; the sum is at most 4π. The error of an object with an
    outline of L radians is about 0.4 L/`face_size`, from the texels that the outline cuts. Source: CloVR (2024), "vis0"
    and "vis1": objects by their visible footprint.

    Parameters
    ----------
    scene
        The scene. Moving objects neither count nor hide others.
    center
        World position of the centre O, metres.
    face_size
        Texels along a face, 1 to 16384. Objects narrower than a texel may be missed.
    """
    core_of(scene)
    size = check.integer("face_size", face_size, 1, check.MAX_SIZE)
    middle = check.vector("center", center)
    settings: dict[str, Any] = {"size": size, "samples": 1, "half": False, "device": None}
    env, _ = bake(scene, middle, 0.0, channels=("object_id",), **settings)
    assert env.object_id is not None
    is_hit = env.object_id >= 0
    weights = np.broadcast_to(cube_solid_angles(size), env.object_id.shape)[is_hit]
    return np.bincount(env.object_id[is_hit], weights, len(scene.object_names)).astype(np.float64)


@dataclass(frozen=True, eq=False)
class Portions:
    """Static objects of all rings that are visible from the centre, in descending order of footprint."""

    scene: Scene
    portion: NDArray[np.int32]
    """(objects,) portion of each object, from 1 on; `count` + 1 for objects not sent, 0 for dynamic objects."""
    rest: int
    """Portion of the faces that belong to no object."""
    count: int
    """Number of portions."""

    @classmethod
    def from_rings(cls, rings: Rings, *, scene: Scene) -> Portions:
        """Divide the near objects of rings into portions; `scene` shows these objects at the levels that are sent.

        Faces without an object have no footprint, so they belong to the last portion.
        """
        angles = footprints(rings.scene, center=rings.center)
        visible = np.flatnonzero((rings.ring > 0) & (rings.ring <= rings.count) & (angles > 0.0))
        ordered = visible[np.argsort(-angles[visible], kind="stable")]
        count = max(min(PORTIONS, len(ordered)), 1)
        portion = np.where(rings.ring == 0, 0, count + 1).astype(np.int32)
        portion[ordered] = 1 + np.arange(len(ordered)) * count // max(len(ordered), 1)
        return cls(scene, portion, count if rings.rest <= rings.count else count + 1, count)

    def codes(self) -> NDArray[np.uint16]:
        """Return portion codes for the kernels (objects + 1,): one per object, then one for faces without an object."""
        return np.append(self.portion, self.rest).astype(np.uint16)

    def summary(self) -> list[dict[str, Any]]:
        """Count objects and triangles of each portion and, in the last entry, of the objects that are not sent."""
        return loads(self.scene, self.codes(), self.count + 1)


def encode_whole(env: EnvMap, files: Files, quality: int | None, scale: RangeScale) -> dict[str, Any]:
    """Encode a whole map in twelve files: the colour of each face as in ring 0, and its range as in ring 1."""
    assert env.range is not None
    codes = scale.codes(env.range)
    unchanged, no_tiles = np.zeros((1, *codes.shape[1:]), bool), np.zeros(0, np.int64)
    encode_ranges = partial(codec.encode_ranges, tile=TILE, step=scale.step)
    jobs = [partial(codec.encode_color, face, quality) for face in env.color]
    jobs += [partial(encode_ranges, face[None], None, unchanged, no_tiles) for face in codes]
    encoded = list(side_by_side.results(jobs))
    return {
        "color": [files.add(data, "webp") for data in encoded[:6]],
        "range": [files.add(data, "range") for data in encoded[6:]],
    }
