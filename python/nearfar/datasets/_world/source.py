"""`nearfar.datasets.world`: a landscape that is generated where it is queried."""

from __future__ import annotations

from typing import SupportsFloat

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import check
from nearfar._scene.scene import Scene
from nearfar.datasets._world import contents, lattice, tiles
from nearfar.datasets._world.contents import Accuracy
from nearfar.datasets._world.parts import Parts
from nearfar.datasets._world.relief import SEA_BED, SUMMIT

_MAX_TILES = 8_192
_MAX_KM = 10_000
_SEEDS = 2**63
_MARGIN = 100.0
"""Greatest height of objects above the ground, and of the ground above the natural relief, metres."""


class World:
    """A landscape of towns, roads, fields, forests, mountains and sea; `query` makes parts of it.

    Only the last tiles are cached: a part depends on the seed and the place alone. Create it with `world`.
    """

    def __init__(self, km: int = 10, seed: int = 0) -> None:
        self._km = check.integer("km", km, 1, _MAX_KM)
        self._seed = check.integer("seed", seed, 0, _SEEDS - 1)

    def __repr__(self) -> str:
        return f"nearfar.datasets.world(km={self._km}, seed={self._seed})"

    @property
    def bounds(self) -> NDArray[np.float64]:
        """Least and greatest corner (2, 3), metres, y up: a box that contains the world, not the smallest one."""
        half = 500.0 * self._km
        return np.array([[-half, SEA_BED - _MARGIN, -half], [half, SUMMIT + _MARGIN, half]])

    def query(self, aabb: ArrayLike, detail: SupportsFloat = 0.0) -> Scene:
        """Make the part of the world that touches a box; arguments and errors are those of `nearfar.SceneSource.query`.

        Half of `detail` is for the ground: a grid of 3.9 m times a power of two. The other half is for objects on the
        ground: simpler shapes, and none of objects whose parts are no farther than that from their feet. ValueError for
        a box with more than 8,192 tiles of 64 × 64 cells at this `detail`.

        Plants, houses, cars and lamps are instances. Objects are called "land_0_3_-2" and "water_0_3_-2" (level, column
        and row of a tile), "oak_3_-2_17" and so on, "house_0_0_12" (column and row of a town), "streets_0_0",
        "road_0_0_to_1_0".
        """
        corners = check.box("aabb", aabb)
        detail = check.at_least_zero("detail", detail)
        low, high = np.maximum(corners[0], self.bounds[0]), np.minimum(corners[1], self.bounds[1])
        parts = Parts(low, high, self.bounds[1][0])
        if (low > high).any():
            return parts.scene()
        accuracy = Accuracy(self._seed, self._level(detail), 0.5 * detail)
        columns, rows = contents.spans(parts, tiles.COUNT * lattice.spacing(accuracy.level))
        if (count := len(columns) * len(rows)) > _MAX_TILES:
            raise ValueError(
                f"aabb: expected at most {_MAX_TILES:,} tiles of the world at detail {detail:g}, "
                f"got {count:,}; take a smaller box or a larger detail"
            )
        for add in (contents.add_ground, contents.add_plants, contents.add_towns, contents.add_roads):
            add(parts, accuracy)
        return parts.scene().query(corners)

    def _level(self, detail: float) -> int:
        """Coarsest level of the ground within an error in metres whose grid ends at the world's border."""
        # A grid of 500 m fits every world, one of 1 km those of an even number of kilometres, and so on.
        coarsest = min(lattice.TOP, 7 + (self._km & -self._km).bit_length() - 1)
        return max(level for level in range(coarsest + 1) if level == 0 or lattice.error(level) <= 0.5 * detail)


def world(km: int = 10, seed: int = 0) -> World:
    """Make an Earth-like landscape of any size, as a source that is queried box by box.

    Continents, mountains, valleys with rivers, coasts; forests by climate, slope and water; a town in most squares of
    3 km, with fields around it and roads to its neighbours. A town lies at the origin. Water is at y = 0. Parts are
    generated on demand, and are the same in every query. ValueError for numbers out of range.

    Parameters
    ----------
    km
        Side of the square in kilometres, 1 to 10,000; its middle is the origin. Smaller worlds are the middles of
        larger ones.
    seed
        0 to 2⁶³ − 1.

    Returns
    -------
    World
        A source with `bounds` and `query(aabb, detail)`.
    """
    return World(km, seed)
