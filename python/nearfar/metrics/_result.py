"""The result of a structural similarity: a number that may carry its map."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from numpy.typing import NDArray

from nearfar._base import check


class Similarity(float):
    """Mean structural similarity of two pictures: a float, with the similarity around each pixel on request.

    It unpacks to the mean and the map, as scikit-image's result does: ``mean, map = nf.ssim(a, b, full=True)``.
    """

    _map: NDArray[Any] | None

    def __new__(cls, mean: float, similarities: NDArray[Any] | None = None) -> Similarity:
        """Join a mean with its map."""
        similarity = super().__new__(cls, check.number("mean", mean, finite=False))
        similarity._map = similarities
        return similarity

    @property
    def map(self) -> NDArray[Any]:
        """Similarity around each pixel, in the picture's shape; ValueError unless it was asked for by `full=True`."""
        if self._map is None:
            raise ValueError("map: expected a similarity that was computed with full=True")
        return self._map

    def __iter__(self) -> Iterator[Any]:
        yield float(self)
        yield self.map

    def __reduce__(self) -> tuple[Any, ...]:
        return Similarity, (float(self), self._map)
