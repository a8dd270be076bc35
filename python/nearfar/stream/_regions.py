"""Regions of a bundle: their centres, neighbours, and the distance that a user may walk in each."""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property
from typing import TYPE_CHECKING, Any, SupportsIndex

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import check

if TYPE_CHECKING:
    from typing import Self


class InRegions:
    """Regions of a `Bundle`; its base class."""

    _manifest: dict[str, Any]
    number: int

    @cached_property
    def centers(self) -> NDArray[np.float64]:
        """(K, 3) centres O of all regions, world metres; read-only."""
        return _fixed([region["center"] for region in self._regions])

    @cached_property
    def fold_margins(self) -> NDArray[np.float64]:
        """(K,) horizontal distances in metres from each region's centre within which no picture of all rings folds.

        Each is 0.7 of the last ring's radius: `nearfar.fold_margin` at O with kind="cylinder". While a client shows a
        smaller radius, it is 0.7 of that radius.
        """
        return _fixed([region["fold_margin"] for region in self._regions])

    @property
    def findings(self) -> tuple[str, ...]:
        """Reasons why the region may show little, a sentence each: its centre, empty rings, endless objects, units."""
        return tuple(self._region["findings"])

    def neighbours(self, region: SupportsIndex) -> tuple[int, ...]:
        """Return the neighbours of a region, whose first rings are worth fetching ahead.

        Parameters
        ----------
        region
            0 to K − 1.

        Returns
        -------
        tuple
            Ascending numbers of regions: two centres are neighbours if no third one is within or on the sphere whose
            diameter joins them. The graph of neighbours is connected.

        References
        ----------
        Gabriel, Sokal (1969): A new statistical approach to geographic variation analysis.
        """
        return tuple(self._regions[self._check_index(region)]["neighbours"])

    def nearest(self, point: ArrayLike) -> int:
        """Return the region with the nearest centre; the first of equally near ones.

        Parameters
        ----------
        point
            World position of the user's eye, metres.
        """
        offsets = self.centers - check.vector("point", point)
        # Scaled, so that no square overflows.
        return int(np.argmin(np.linalg.norm(offsets / np.abs(offsets).max(), axis=1))) if offsets.any() else 0

    def region(self, region: SupportsIndex) -> Self:
        """Return the same bundle for another region; both share the cache of read files.

        Parameters
        ----------
        region
            0 to K − 1.
        """
        return replace(self, number=self._check_index(region))  # type: ignore[type-var]

    @property
    def _regions(self) -> list[dict[str, Any]]:
        regions: list[dict[str, Any]] = self._manifest["regions"]
        return regions

    @property
    def _region(self) -> dict[str, Any]:
        return self._regions[self.number]

    def _check_index(self, region: SupportsIndex) -> int:
        return check.integer("region", region, 0, len(self._regions) - 1)


def _fixed(values: list[Any]) -> NDArray[np.float64]:
    array = np.array(values, np.float64)
    array.setflags(write=False)
    return array
