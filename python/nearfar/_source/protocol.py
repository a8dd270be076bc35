"""The `SceneSource` protocol: the interface of worlds that may be larger than memory."""

from __future__ import annotations

from typing import Protocol, SupportsFloat, runtime_checkable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import check
from nearfar._scene.scene import Scene


@runtime_checkable
class SceneSource(Protocol):
    """World that scenes are taken from, box by box.

    `Scene` is one, and so is what `nearfar.open_source` returns. Any class with `bounds` and `query` becomes one.

    It may also have `touches(aabb) -> bool`, which returns False where nothing is. What visits a world cell by cell
    asks it, where it is there, before it looks into a part.
    """

    @property
    def bounds(self) -> NDArray[np.float64]:
        """World box (2, 3), least and greatest corner, metres; infinite where the world has no end."""

    def query(self, aabb: ArrayLike, detail: SupportsFloat = 0.0) -> Scene:
        """Return a scene of the triangles that touch a box, whole and not clipped.

        The triangles of a query do not depend on earlier ones, and a triangle that touches two boxes is the same in the
        results of both.

        Parameters
        ----------
        aabb
            Least and greatest corner (2, 3), world, metres. The sides belong to the box and may be infinite.
        detail
            Greatest geometric error in metres that the result may have; 0 asks for everything that there is.

        Returns
        -------
        Scene
            In the source's frame and with its names of objects. Empty where nothing is.

        Raises
        ------
        ValueError
            A box with NaN or with a least corner above the greatest, a `detail` that is negative or not finite.
        """


def may_touch(source: SceneSource, box: NDArray[np.float64]) -> bool:
    """Whether anything of a source may touch a box (2, 3); False only if it says that nothing does."""
    touches = getattr(source, "touches", None)
    return touches is None or bool(touches(box))


def bounds_of(source: SceneSource) -> NDArray[np.float64]:
    """The box (2, 3) of a source; ValueError or TypeError for one that has none."""
    bounds: NDArray[np.float64] = check.array("source.bounds", source.bounds, dtype=np.float64)
    if bounds.shape != (2, 3):
        raise ValueError(f"source: expected bounds (2, 3), got {bounds.shape}")
    return bounds


def source_of(name: str, value: object) -> SceneSource:
    """Return a source; TypeError for anything else."""
    if not isinstance(value, SceneSource):
        raise TypeError(f"{name}: expected a source with bounds and query, got {check.described(value)}")
    return value
