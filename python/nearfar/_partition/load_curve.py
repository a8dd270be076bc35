"""The load curve: the number of triangles that stay geometry for each r2, and the greatest r2 for a budget."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, SupportsFloat, SupportsIndex, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import card, check, plot, progress
from nearfar._scene.scene import Scene, core_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes

SAMPLES = 512
"""Number of radii at which a plotted curve is evaluated."""

LISTED_RADII = (30, 50, 100, 200)
"""Radii in metres whose counts notebooks show beside the curve."""


class LoadCurve:
    """Number of triangles that stay geometry as a function of r2, and its inverse; each value is a binary search."""

    def __init__(self, core: _core.LoadCurve, center: tuple[float, float, float]) -> None:
        self._core = check.instance("core", core, _core.LoadCurve, "what load_curve passes")
        self._center = check.vector("center", center)

    @property
    def center(self) -> tuple[float, float, float]:
        """World position of the centre, metres."""
        return self._center

    @property
    def triangle_count(self) -> int:
        """Number of triangles of the scene."""
        return self._core.total

    @property
    def moving_count(self) -> int:
        """Number of moving triangles, which stay geometry at any radius."""
        return self._core.moving

    @overload
    def count(self, r2: SupportsFloat) -> int: ...
    @overload
    def count(self, r2: ArrayLike) -> int | NDArray[np.int64]: ...
    def count(self, r2: Any) -> int | NDArray[np.int64]:
        """Count the triangles that stay geometry: `partition(scene, center=..., r1=..., r2=r2).summary()["nsf"]`.

        `r2` is a radius or radii of any shape in metres, at least 0; infinity is allowed. ValueError for negative radii
        and NaN; TypeError for values that are not numbers.
        """
        radii = check.array("r2", r2, columns=None, dtype=np.float64)
        counts = self._core.count(radii.reshape(-1)).reshape(radii.shape)
        return counts if counts.ndim else int(counts)

    @overload
    def radius(self, budget: SupportsIndex | float) -> float: ...
    @overload
    def radius(self, budget: ArrayLike) -> float | NDArray[np.float64]: ...
    def radius(self, budget: Any) -> float | NDArray[np.float64]:
        """Find the greatest r2 for a budget, or for each of many budgets, of triangles that stay geometry.

        Returns metres in the shape of `budget`: the float64 just below the distance of the first triangle that exceeds
        the budget; infinite if the whole scene is within the budget. ValueError if even r2 = 0 exceeds it, because too
        many triangles move or lie on the axis; TypeError for values that are not whole numbers.
        """
        budgets = check.counts("budget", budget)
        radii = self._core.radius(budgets.reshape(-1)).reshape(budgets.shape)
        return radii if radii.ndim else float(radii)

    def plot(self, ax: Axes | None = None, *, published: bool = True) -> Axes:
        """Plot the number of triangles that stay geometry against r2, on logarithmic axes of matplotlib or new ones.

        `published` marks the numbers of Popescu et al. (2022) for a model of Manhattan with 3.7 million triangles: 371
        triangles within 30 m, and fewer than 1,000 within 50 m. ImportError if matplotlib is not installed; ValueError
        if the scene has no static triangle, so that there is no curve.
        """
        if self.triangle_count == self.moving_count:
            raise ValueError("load curve: expected a scene with static triangles, got none")
        radii, published = self._radii(), check.flag("published", published)
        return plot.load_curve(ax, radii, np.asarray(self.count(radii)), self.triangle_count, published=published)

    def _radii(self) -> NDArray[np.float64]:
        """Return the radii in metres at which the curve is drawn."""
        farthest = self._farthest()
        return np.geomspace(min(1.0, farthest / 2.0), 1.1 * farthest, SAMPLES)

    def _farthest(self) -> float:
        """Return the distance of the farthest triangle in metres; 1 if all of them lie on the axis."""
        if self.count(0.0) == self.triangle_count:
            return 1.0
        return float(self.radius(self.triangle_count - 1))

    @card.repr_html
    def _repr_html_(self) -> str:
        """Plot and counts for notebooks."""
        facts = [("triangles", f"{self.triangle_count:,}"), ("of them moving", f"{self.moving_count:,}")]
        if self.triangle_count == self.moving_count:
            return card.page("LoadCurve", facts)
        facts += [(f"r₂ = {radius} m", f"{self.count(float(radius)):,} triangles") for radius in LISTED_RADII]
        radii = self._radii()
        line = card.Line(radii, np.asarray(self.count(radii), np.float64))
        return card.page("LoadCurve", facts, card.plot([line], "r₂, m", "triangles left", log_y=True))

    def __repr__(self) -> str:
        return f"LoadCurve({self.triangle_count:,} triangles, {self.moving_count:,} of them moving)"


def load_curve(scene: Scene, *, center: ArrayLike) -> LoadCurve:
    """Measure and sort the least distance of every static triangle from the vertical axis through a centre.

    `count` and `radius` of the curve take O(log n) for n triangles. ValueError for a centre that is not finite;
    TypeError for arguments of another type. Source: Popescu, Lee, Choi, Fahmy (2022): triangle counts of Manhattan
    within r2, which `LoadCurve.plot` marks.

    Parameters
    ----------
    scene
        The scene.
    center
        World position of the centre, metres; its height does not matter.
    """
    middle = check.vector("center", center)
    core = core_of(scene)
    with progress.bar("load curve") as report:
        return LoadCurve(_core.LoadCurve(core, center=middle, report=report), middle)
