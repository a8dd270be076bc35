"""The `SceneSource` protocol: the interface of worlds that may be larger than memory."""

from __future__ import annotations

from typing import Protocol, SupportsFloat, runtime_checkable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import check
from nearfar._scene.report import Unread
from nearfar._scene.scene import Scene


@runtime_checkable
class SceneSource(Protocol):
    """A world that is queried for scenes box by box.

    `Scene` is a source, and so are the result of `nearfar.open_source` and any object with `bounds` and `query`.

    A source may also have `touches(aabb) -> bool`, which returns False if nothing is in the box. Functions that visit a
    world cell by cell call it, if it exists, before they query a part.
    """

    @property
    def bounds(self) -> NDArray[np.float64]:
        """World box (2, 3), least and greatest corner, metres; infinite on unbounded sides."""

    def query(self, aabb: ArrayLike, detail: SupportsFloat = 0.0) -> Scene:
        """Return a scene of the triangles that touch a box, whole and not clipped.

        The box (2, 3) has a least and a greatest corner, world, metres; it includes its sides, which may be infinite.
        `detail` is the maximum geometric error of the result in metres; 0 for full detail. The triangles of a query do
        not depend on earlier queries, and a triangle that touches two boxes is the same in both results. The scene has
        the source's frame of reference and object names; it is empty if nothing touches the box. ValueError for a box
        with NaN or with a least corner above the greatest, and a `detail` that is negative or not finite; TypeError for
        values that are not numbers.
        """


def may_touch(source: SceneSource, box: NDArray[np.float64]) -> bool:
    """Return whether a source may have geometry in a box (2, 3); False only if the source says that it has none."""
    touches = getattr(source, "touches", None)
    return touches is None or bool(touches(box))


def unread_in(source: SceneSource | None, part: Scene) -> list[str]:
    """Notes on what a query of a source, or with None the file of a scene, could not read.

    Notes that a scene in memory gives to all its parts do not count: they are about its file.
    """
    of_source = getattr(source, "_notes", ())
    return [note for note in part._notes if isinstance(note, Unread) and note not in of_source]


def bounds_of(source: SceneSource) -> NDArray[np.float64]:
    """Return the box (2, 3) of a source; ValueError or TypeError if it has none."""
    bounds: NDArray[np.float64] = check.array("source.bounds", source.bounds, dtype=np.float64)
    if bounds.shape != (2, 3):
        raise ValueError(f"source: expected bounds (2, 3), got {bounds.shape}")
    return bounds


def source_of(name: str, value: object) -> SceneSource:
    """Return a source; TypeError for anything else."""
    if not isinstance(value, SceneSource):
        raise TypeError(f"{name}: expected a source with bounds and query, got {check.type_and_value(value)}")
    return value
