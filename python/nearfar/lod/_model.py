"""What is known about an object's levels: how good each looks over its size."""

from __future__ import annotations

import os
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from nearfar import _check, _plot
from nearfar.lod import _lod_file
from nearfar.lod._fit import Curve4PL
from nearfar.lod._levels import Levels
from nearfar.lod._samples import Samples

if TYPE_CHECKING:
    from matplotlib.axes import Axes


@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class LodModel:
    """Levels of an object with their curves: what `select` decides by.

    `measure` makes it. Level 0 is the base, which looks like itself; level i > 0 has the curve `curves[i - 1]`.

    Parameters
    ----------
    triangles
        Triangles of each level (K,), level 0 first.
    curves
        K − 1 curves: SSIM over solid angle in steradians.
    center, radius
        The base's bounding sphere, metres in the object's frame.
    sigma
        Least and greatest solid angle at which was measured, steradians. Above the greatest only level 0 is used; below
        the least, curves keep their value there.
    errors
        Greatest distance of each level (K,) from the base, metres.
    name
        Of the object.
    levels
        The geometry, where it is at hand; as many as `triangles`.
    measured
        How it was measured, in values that JSON has.
    samples
        What curves were fitted to; None where nothing was measured.
    """

    triangles: NDArray[np.int64]
    curves: Curve4PL
    center: NDArray[np.float64]
    radius: float
    sigma: tuple[float, float]
    errors: NDArray[np.float64]
    name: str = "object"
    levels: Levels | None = None
    measured: dict[str, Any] = field(default_factory=dict)
    samples: Samples | None = None

    def __len__(self) -> int:
        """How many levels there are, level 0 included."""
        return len(self.triangles)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write all but the geometry as JSON, whole or not at all: curves, samples, and how they were measured."""
        _lod_file.write(_check.path("path", path), self)

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> LodModel:
        """Read what `save` wrote, bit for bit; FormatError for other files and newer versions, OSError for none."""
        return cls(**_lod_file.read(_check.path("path", path)))

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draw each level's scores over solid angle, with its curve.

        Parameters
        ----------
        ax
            Axes of matplotlib to draw on; new ones by default.

        Returns
        -------
        matplotlib.axes.Axes
            The axes with the curves.

        Raises
        ------
        ImportError
            Where matplotlib is not installed.

        References
        ----------
        Liebisch (2021): Figure 3.3.
        """
        low, high = self.sigma
        sigma = np.geomspace(low, high, 256)
        curves = self.curves(sigma) if len(self.curves) else np.empty((0, 256))
        scores = None if self.samples is None else (self.samples.sigma, self.samples.score[1:])
        return _plot.score_curves(ax, sigma, curves, [f"{count:,}" for count in self.triangles[1:]], scores)

    def __repr__(self) -> str:
        counts = ", ".join(f"{count:,}" for count in self.triangles)
        return f"LodModel({self.name!r}: {counts} triangles)"
