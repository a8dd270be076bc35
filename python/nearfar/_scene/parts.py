"""Mixins of `Scene`: subsets and queries; rendering."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any, Self, SupportsFloat

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check
from nearfar._camera.shot import Shot, check_begin, check_request
from nearfar._scene.arrays import triangle_mask

if TYPE_CHECKING:
    from nearfar._core import GpuDevice, GpuJob, Scene as CoreScene
    from nearfar._scene.levels import LevelTable
    from nearfar._scene.names import Names


class PartsMixin:
    """Mixin that creates scenes from parts of a scene."""

    _core: CoreScene
    _names: Names
    _load_placements: NDArray[np.float64]
    _table: LevelTable | None

    if TYPE_CHECKING:

        def _derived(
            self, core: CoreScene, load_placements: NDArray[np.float64], table: LevelTable | None = None, **changes: Any
        ) -> Self: ...

    @property
    def triangle_count(self) -> int:
        """Number of triangles of all instances."""
        return self._core.triangle_count

    def subset(self, *, objects: Iterable[str] | None = None, triangles: ArrayLike | None = None) -> Self:
        """Return a scene of only some objects, by name, or some triangles, by number or a mask (T,) of bool.

        Object numbers and names do not change. A subset by triangles has no levels, because parts of objects have none.
        ValueError for unknown names, triangle numbers out of range, both arguments or none.
        """
        if (objects is None) == (triangles is None):
            count = "none" if objects is None else "both"
            raise ValueError(f"subset: expected either objects or triangles, got {count}")
        owner = self._core.moving_objects()
        if objects is not None:
            flags = self._names.flags("objects", objects)
            return self._derived(self._core.subset_of_objects(flags), self._load_placements[flags[owner]], self._table)
        assert triangles is not None
        mask = triangle_mask(check.plain("triangles", triangles), self.triangle_count)
        before = np.concatenate([[0], np.cumsum(mask)])[self._core.triangle_offsets()]
        remains = np.diff(before)[self._core.instance_count - len(owner) :] > 0
        return self._derived(self._core.subset_of_triangles(mask), self._load_placements[remains])

    def query(self, aabb: ArrayLike, detail: SupportsFloat = 0.0) -> Self:
        """Return a scene of the whole triangles that touch a box; arguments and errors as in `SceneSource.query`.

        The time grows with the result, not with the scene; the first query builds the search trees. Meshes keep only
        the vertices that they use; faces, vertices and instances keep their order. Instances entirely inside stay
        instances of the same meshes. Names, object numbers and `origin` do not change. The result shows the scene's
        current levels, and has no levels of its own. A scene in memory ignores `detail`: it always returns all of its
        triangles.
        """
        box = check.box("aabb", aabb)
        check.at_least_zero("detail", detail)
        return self._query(box, builds=True)

    def touches(self, aabb: ArrayLike) -> bool:
        """Return False if no triangle touches a box; True may be a false alarm. It takes microseconds.

        The box and its errors are as in `query`.
        """
        least, greatest = check.box("aabb", aabb).tolist()
        return self._core.touches(tuple(least), tuple(greatest))

    def _query(self, box: NDArray[np.float64], *, builds: bool) -> Self:
        """Scene of the triangles that touch a box (2, 3); tests all without search trees, which `builds` creates."""
        least, greatest = box.tolist()
        core, remains = self._core.query(tuple(least), tuple(greatest), builds)
        return self._derived(core, self._load_placements if remains is None else self._load_placements[remains])


class RenderMixin:
    """Mixin that renders a scene exactly."""

    _core: CoreScene

    @property
    def default_channels(self) -> tuple[str, ...]:
        """Images that `nearfar.render` computes by default."""
        return ("color", "range", "object_id")

    @property
    def backends(self) -> tuple[str, ...]:
        """Backends that can render the scene."""
        return ("cpu", "gpu")

    def displayed(self, points: ArrayLike, user: ArrayLike) -> NDArray[np.float64]:
        """Return the world positions (N, 3) where a picture shows points: unchanged, for any user."""
        check.vector("user", user)
        return check.array("points", points, columns=3, dtype=np.float64)

    def trace(self, shot: Shot, report: Callable[[int, int], None] | None = None) -> list[dict[str, NDArray[Any]]]:
        """Trace the pictures of a shot, one for each camera; `nearfar.render` makes frames of them."""
        check_request(shot, report)
        return [_core.render_truth(self._core, camera._core, shot.settings, report=report) for camera in shot.cameras]

    def begin(self, device: GpuDevice, shot: Shot, report: Callable[[int, int], None] | None = None) -> list[GpuJob]:
        """Begin the pictures of a shot on a graphics device, one for each camera.

        Pictures of two cameras are drawn in one pass if the adapter supports it.
        """
        check_begin(device, shot, report)
        return device.truth(self._core, [camera._core for camera in shot.cameras], shot.settings, report=report)
