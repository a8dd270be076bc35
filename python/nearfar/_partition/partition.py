"""The near–far partition: divides triangles into near ones, which stay geometry, and far ones, which a map shows."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import card, check, progress
from nearfar._partition import preview
from nearfar._scene.scene import Scene, core_of


def triangle_radii(vertices: ArrayLike, faces: ArrayLike | None = None, *, center: ArrayLike) -> NDArray[Any]:
    """Measure the least and the greatest distance ρ of triangles from the vertical axis through a centre.

    The least ρ is measured to the triangle's projection on the ground plane, not to its corners: a large triangle
    around the axis has all corners far away and a least ρ of 0. The projection of a vertical triangle is a segment.
    Returns (F, 2) least and greatest ρ in metres, in the vertices' type: computed in float64 with an error of at most
    1e-15 of the greatest ρ, then rounded once. ValueError for wrong shapes, vertex numbers out of range, and
    coordinates that are not finite; TypeError for values that are not numbers. Source: Popescu, Lee, Choi, Fahmy
    (2022): ρ of Eq. 1, there measured for vertices.

    Parameters
    ----------
    vertices
        (V, 3), metres, y up. float32 and float64 are kept. Without `faces`, (F, 3, 3): three corners for each triangle.
    faces
        (F, 3) vertex numbers, or None.
    center
        A point on the axis, in the vertices' frame; its height does not matter.
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


Unit = Literal["triangle", "object"]
"""Unit of the partition, which is near or far as a whole."""
UNITS: tuple[Unit, ...] = get_args(Unit)


@dataclass(frozen=True, eq=False, repr=False)
class Partition:
    """Zones of a scene's triangles, divided at two radii about the vertical axis through a centre.

    ρ is the horizontal distance from that axis. A triangle is near (least ρ ≤ r1), intermediate (r1 < least ρ ≤ r2) or
    far. `nsf` (not static far) is drawn as geometry: all near, intermediate and moving triangles. `sf` (static far) is
    baked into the environment map: all static triangles whose greatest ρ exceeds r2. Triangles across r2 are in both
    sets, and renderers split them at r2 in each pixel.

    Zones are stored by instance; the index arrays are computed at each access. Triangles are numbered as in the
    `triangles` of `scene`. Distances are rounded to float32 as in `triangle_radii`, so that the two agree.
    """

    _core: _core.Partition
    scene: Scene
    """The divided scene; with `unit` "object" its near objects are dynamic, so that they are geometry as a whole."""
    center: tuple[float, float, float]
    """World position of the centre, metres."""
    r1: float
    """Radius that bounds the near zone, metres."""
    r2: float
    """Radius that bounds the intermediate zone, metres."""
    source: Scene
    """The scene that was passed to `partition`."""
    unit: Unit = "triangle"
    """"triangle" or "object": the unit in which triangles are geometry or baked."""

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
        """Numbers of the triangles that are baked: static ones whose greatest ρ exceeds r2, ascending."""
        return self._core.triangles("sf")

    def summary(self) -> dict[str, int]:
        """Count triangles and instances.

        Returns
        -------
        dict
            Triangles: `triangles` = `near` + `intermediate` + `far`; `nsf`, `sf`, and `straddling`, the static
            triangles in both; `nsf_at_r1`, near and moving triangles. Instances: `near_instances`,
            `intermediate_instances` and `far_instances` lie in one zone according to their boxes, `mixed_instances` do
            not. Work: `examined`, the triangles of mixed instances, and `measured`, those among them that were not far
            by their coordinates alone.
        """
        return self._core.counts()

    def validate(self) -> None:
        """Measure every triangle again, without boxes and shortcuts; SceneError if one is in a wrong zone."""
        with progress.bar("validate partition") as report:
            self._core.validate(report)

    @card.repr_html
    def _repr_html_(self) -> str:
        """Counts and a top view for notebooks; at most a few thousand triangles of each zone are drawn."""
        counts = self.summary()
        facts = [
            (f"near, ρ ≤ {self.r1:g} m", f"{counts['near']:,} triangles"),
            (f"intermediate, ρ ≤ {self.r2:g} m", f"{counts['intermediate']:,}"),
            ("far", f"{counts['far']:,}"),
            ("drawn as geometry", f"{counts['nsf']:,}"),
            ("baked", f"{counts['sf']:,}, of which {counts['straddling']:,} are drawn, too"),
            ("centre", card.point(self.center)),
        ]
        pixels = preview.picture(self._core, self.scene._core, self.center, self.r1, self.r2)
        legend = [(color, zone) for zone, color in preview.ZONES.items()]
        caption = "from above, −z up; the circles are r₁ and r₂."
        return card.page("Partition", facts, card.picture(pixels, "top view of the zones", caption, legend))

    def __repr__(self) -> str:
        counts = self.summary()
        return (
            f"Partition(r1={self.r1:g}, r2={self.r2:g}: {counts['near']:,} near, "
            f"{counts['intermediate']:,} intermediate, {counts['far']:,} far)"
        )


def partition(scene: Scene, *, center: ArrayLike, r1: float, r2: float, unit: Unit = "triangle") -> Partition:
    """Divide a scene into near geometry and far environment.

    ValueError for radii out of order, a centre that is not finite, and unknown units; TypeError for arguments of
    another type. Source: Popescu, Lee, Choi, Fahmy (2022): near, intermediate and far region, there by vertex, here by
    triangle; CloVR (2024) for "object".

    Parameters
    ----------
    scene
        The scene. Triangles of an instance are not examined if its box lies in one zone.
    center
        World position of the centre, metres; its height does not matter.
    r1, r2
        Radii in metres, 0 ≤ r1 < r2.
    unit
        "triangle": a static triangle is geometry if it reaches inside r2, and baked if it reaches beyond r2. "object":
        every object that reaches inside r2 is geometry as a whole, also beyond r2, and nothing of it is baked; in the
        result's `scene` such objects are dynamic. Faces without an object are divided by triangle.
    """
    core_of(scene)
    inner, outer = check.radii(r1, r2)
    middle = check.vector("center", center)
    check.choice("unit", unit, UNITS)
    source, core = scene, _divide(scene, middle, inner, outer)
    if unit == "object":
        names = scene.object_names
        objects = [names[number] for number in core.near_objects()]
        if objects:
            scene = scene.with_dynamic(objects)
            core = _divide(scene, middle, inner, outer)
    return Partition(core, scene, middle, inner, outer, source, unit)


def _divide(scene: Scene, center: tuple[float, float, float], r1: float, r2: float) -> _core.Partition:
    with progress.bar("partition") as report:
        return _core.Partition(core_of(scene), center=center, r1=r1, r2=r2, report=report)
