"""Environment maps of all rings: the first one in full, each further one as changes to the previous one."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import check, progress
from nearfar._cubemap.envmap import EnvMap
from nearfar.stream._assign import Rings

TILE = 64
"""Side of the tiles in which changes are sent, texels."""

MAX_SAMPLES = 1024


@dataclass(frozen=True, eq=False, repr=False)
class RingMaps:
    """Maps of rings 0 to n: map i shows all static objects beyond ring i.

    A texel whose first surface belongs to a ring after i + 1 is the same in maps i and i + 1, so each map after the
    first is stored as its changed texels.
    """

    rings: Rings
    first: EnvMap
    """Map 0, which shows all static objects."""
    changes: tuple[dict[str, NDArray[Any]], ...]
    """For each ring from 1 on `texels`, ascending numbers of the changed texels, and their new values by channel."""
    samples: int
    """Colour samples per texel."""

    @property
    def rays(self) -> int:
        """Number of rays whose results are stored: all rays of map 0, and for each change the rays of its texels.

        Fewer rays are traced, because each is traced once for all maps.
        """
        extra = self.samples > 1 and len(self.first.channels) > 1
        changed = sum(len(change["texels"]) for change in self.changes)
        return (6 * self.first.face_size**2 + changed) * (self.samples + extra)

    def map(self, ring: int) -> EnvMap:
        """Return the whole map of the scene beyond a ring, 0 to n."""
        number = check.integer("ring", ring, 0, self.rings.count)
        values = {name: np.array(getattr(self.first, name)) for name in self.first.channels}
        for change in self.changes[:number]:
            for name, image in values.items():
                image.reshape(-1, *image.shape[3:])[change["texels"]] = change[name]
        return EnvMap(self.rings.center, **values, object_names=self.first.object_names)

    def changed_tiles(self, ring: int) -> NDArray[np.bool_]:
        """Return the tiles (6, N, N) with texels that change from the previous ring's map to a ring's, 1 to n.

        N = ⌈face size / 64⌉.
        """
        number = check.integer("ring", ring, 1, self.rings.count)
        side = self.first.face_size
        face, texel = np.divmod(self.changes[number - 1]["texels"], side * side)
        tiles_per_row = -(-side // TILE)
        tiles = np.zeros((6, tiles_per_row, tiles_per_row), bool)
        tiles[face, texel // side // TILE, texel % side // TILE] = True
        return tiles

    def __repr__(self) -> str:
        changed = sum(len(change["texels"]) for change in self.changes)
        share = changed / (6 * self.first.face_size**2)
        return f"RingMaps({1 + self.rings.count} maps of 6 × {self.first.face_size}², changes of {share:.2f} maps)"


def bake_maps(rings: Rings, *, face_size: int = 1024, samples: int = 4, object_id: bool = False) -> RingMaps:
    """Bake the maps of all rings from their centre; a texel is stored once per change.

    The maps have range, because whole objects reach beyond the radius into the map. Source: CloVR (2024): a map for
    each ring. Storing only changes is our addition.

    Parameters
    ----------
    rings
        Rings of a scene's objects, from `assign`.
    face_size
        Texels along a face, 1 to 16384.
    samples
        Colour samples per texel, 1 to 1024; range is taken at the texel's centre.
    object_id
        Whether to store object numbers too, for measurements.
    """
    check.instance("rings", rings, Rings)
    size = check.integer("face_size", face_size, 1, check.MAX_SIZE)
    count = check.integer("samples", samples, 1, MAX_SAMPLES)
    check.flag("object_id", object_id)
    settings: dict[str, Any] = {"center": rings.center, "size": size, "samples": count}
    settings |= {"range": True, "object_id": object_id}
    core, codes = rings.scene._core, rings.codes()
    with progress.bar("baking maps") as report:
        faces, changed = _core.bake_rings(core, settings, rings=codes, count=rings.count, report=report)
    shaped = {name: image.reshape(6, size, size, *image.shape[2:]) for name, image in faces.items()}
    names = rings.scene.object_names if object_id else ()
    changes = tuple(
        {"texels": texels}
        | {name: image[:0].reshape(0, *image.shape[3:]) for name, image in shaped.items()}
        | {name: image[:, 0] for name, image in values.items()}
        for texels, values in changed
    )
    return RingMaps(rings, EnvMap(rings.center, **shaped, object_names=names), changes, count)
