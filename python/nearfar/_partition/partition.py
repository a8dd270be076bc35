"""The near–far partition: which triangles stay geometry and which become part of the environment map."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check, progress
from nearfar._scene.scene import Scene, core_of


def triangle_radii(vertices: ArrayLike, faces: ArrayLike | None = None, *, center: ArrayLike) -> NDArray[Any]:
    """Least and greatest distance ρ of triangles from the vertical axis through a centre.

    The least one is taken to the triangle in the ground plane, not to its corners: a large ground triangle around the
    axis has all corners far away and a least ρ of 0. Vertical walls are segments there and measured as such.

    Parameters
    ----------
    vertices
        (V, 3), metres, y up. float32 and float64 are kept. Without `faces`, (F, 3, 3): three corners for each triangle.
    faces
        (F, 3) vertex numbers, or None.
    center
        A point on the axis, in the vertices' frame; its height does not matter.

    Returns
    -------
    NDArray
        (F, 2) least and greatest ρ in metres, in the vertices' type: computed in float64 to within 1e-15 of the
        greatest, then rounded once.

    Raises
    ------
    ValueError
        For other shapes, vertex numbers out of range, and coordinates that are not finite.
    TypeError
        For values that are not numbers.

    References
    ----------
    Popescu, Lee, Choi, Fahmy (2022): ρ of Eq. 1, measured for triangles instead of vertices, because a large
    triangle around the axis has all of its vertices far away.
    """
    axis = check.vector("center", center)
    if faces is None:
        corners = check.array("vertices", vertices, columns=None)
        if corners.ndim != 3 or corners.shape[1:] != (3, 3):
            raise ValueError(f"vertices: expected shape (F, 3, 3) where faces is None, got {corners.shape}")
        rows, indices = corners.reshape(-1, 3), None
    else:
        rows = check.array("vertices", vertices)
        indices = check.array("faces", faces, dtype=np.uint32)
    with progress.bar("triangle radii") as report:
        return _core.triangle_radii(rows, indices, axis, report)


class Partition:
    """A scene divided at two radii about the vertical axis through a centre.

    A triangle is near (least ρ ≤ r1), intermediate (≤ r2) or far. What is drawn as geometry, `nsf`, is everything near,
    intermediate or moving; what is baked into the environment map, `sf`, is every standing triangle that reaches
    beyond r2. Triangles across r2 are in both, and pixels are split there.

    Zones are kept by instance; the index arrays are made at each access. Triangles are numbered as in
    `Scene.triangles`. Distances are rounded to float32 as those of `triangle_radii` are, so both agree.
    """

    def __init__(self, core: _core.Partition, center: tuple[float, float, float], r1: float, r2: float) -> None:
        self._core = core
        self._center, self._r1, self._r2 = center, r1, r2

    @property
    def center(self) -> tuple[float, float, float]:
        """World position of the centre, metres."""
        return self._center

    @property
    def r1(self) -> float:
        """Radius of the near zone, metres."""
        return self._r1

    @property
    def r2(self) -> float:
        """Radius of the intermediate zone, metres."""
        return self._r2

    @property
    def near(self) -> NDArray[np.int64]:
        """Numbers of the triangles with least ρ ≤ r1, ascending."""
        return self._core.triangles("near")

    @property
    def intermediate(self) -> NDArray[np.int64]:
        """Numbers of the triangles with r1 < least ρ ≤ r2, ascending."""
        return self._core.triangles("intermediate")

    @property
    def far(self) -> NDArray[np.int64]:
        """Numbers of the triangles with least ρ > r2, ascending."""
        return self._core.triangles("far")

    @property
    def nsf(self) -> NDArray[np.int64]:
        """Numbers of the triangles that are drawn as geometry: near, intermediate and all moving ones, ascending."""
        return self._core.triangles("nsf")

    @property
    def sf(self) -> NDArray[np.int64]:
        """Numbers of the triangles that are baked: standing ones whose greatest ρ exceeds r2, ascending."""
        return self._core.triangles("sf")

    def summary(self) -> dict[str, int]:
        """Count triangles and instances.

        Returns
        -------
        dict
            Triangles: `triangles` = `near` + `intermediate` + `far`; `nsf`, `sf` and `straddling`, the standing ones in
            both; `nsf_at_r1`, near ones and all moving ones. Instances of one zone: `near_instances`,
            `intermediate_instances`, `far_instances`, and the `mixed_instances` that their boxes did not decide. The
            work that was needed: `examined`, the triangles of mixed instances, and `measured`, those of them that their
            coordinates alone did not show to be far.
        """
        return self._core.counts()

    def validate(self) -> None:
        """Measure every triangle anew, without boxes and shortcuts; SceneError where one is in a wrong zone."""
        with progress.bar("validate partition") as report:
            self._core.validate(report)

    def __repr__(self) -> str:
        counts = self.summary()
        return (
            f"Partition(r1={self._r1:g}, r2={self._r2:g}: {counts['near']:,} near, "
            f"{counts['intermediate']:,} intermediate, {counts['far']:,} far)"
        )


def partition(scene: Scene, *, center: ArrayLike, r1: float, r2: float) -> Partition:
    """Divide a scene into near geometry and far environment.

    Parameters
    ----------
    scene
        The scene. Instances that their boxes decide are not looked into.
    center
        World position of the centre, metres; its height does not matter.
    r1, r2
        Radii in metres, 0 ≤ r1 < r2.

    Returns
    -------
    Partition
        Zones of all triangles.

    Raises
    ------
    ValueError
        For radii out of order and a centre that is not finite.
    TypeError
        For arguments of another type.

    References
    ----------
    Popescu, Lee, Choi, Fahmy (2022): near, intermediate and far region; by triangle instead of by vertex.
    """
    near, far = check.radii(r1, r2)
    middle = check.vector("center", center)
    with progress.bar("partition") as report:
        core = _core.Partition(core_of(scene), center=middle, r1=near, r2=far, report=report)
    return Partition(core, middle, near, far)
