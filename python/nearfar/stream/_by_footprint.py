"""Near objects in the sending order of vis0 and vis1: by their footprint, the solid angle seen from the centre."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base import side_by_side
from nearfar._cubemap.envmap import EnvMap
from nearfar._scene.scene import Scene
from nearfar.stream import _map_files as codec
from nearfar.stream._assign import Rings, loads
from nearfar.stream._encode import Files
from nearfar.stream._footprints import footprints
from nearfar.stream._map_files import RangeScale
from nearfar.stream._maps import TILE

PORTIONS = 32
"""Greatest number of files that the objects of a region are divided into."""


@dataclass(frozen=True, eq=False)
class Portions:
    """Static objects of all rings that are visible from the centre, in descending order of footprint."""

    scene: Scene
    """The scene."""
    portion: NDArray[np.int32]
    """(objects,) portion of each object, from 1 on; `count` + 1 for objects not sent, 0 for dynamic objects."""
    rest: int
    """Portion of the faces that belong to no object."""
    count: int
    """Number of portions."""

    @classmethod
    def from_rings(cls, rings: Rings, *, scene: Scene) -> Portions:
        """Divide the near objects of rings into portions; `scene` holds the objects as they are sent.

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
        """Count objects and triangles of each portion, and last of the objects that are not sent."""
        return loads(self.scene, self.codes(), self.count + 1)


def encode_whole(env: EnvMap, files: Files, quality: int | None, scale: RangeScale) -> dict[str, Any]:
    """Encode a map like ring 0's colour and ring 1's range: one file per face for each of the two."""
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
