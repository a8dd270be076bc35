"""Assignment of whole objects to rings: an object belongs to the first ring whose radius it reaches inside."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from itertools import islice, pairwise
from typing import Any, Literal, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import card, check, progress
from nearfar._scene.report import count
from nearfar._scene.scene import Scene, core_of

Rule = Literal["object", "vertex"]
"""Points of an object that are compared with a radius: all points of its triangles, or only their vertices."""

MAX_RINGS = 1000
"""Greatest number of rings."""


@dataclass(frozen=True, eq=False, repr=False)
class Rings:
    """Static objects of a scene in rings about the vertical axis through a centre.

    Ring i holds the objects whose least ρ (distance from the axis) lies between the radii i − 1 and i. Ring 0 has no
    objects: its map shows all static ones. The maps always show objects beyond the last radius and never show dynamic
    objects.
    """

    scene: Scene
    center: tuple[float, float, float]
    """World position of the centre O, metres."""
    radii: tuple[float, ...]
    """Radii of the rings 1 to n in metres, ascending."""
    rule: Rule
    """Rule for what counts as inside: "object" or "vertex"."""
    least: NDArray[np.float32]
    """(objects,) least ρ of each object in metres; infinite beyond the last radius."""
    ring: NDArray[np.int32]
    """(objects,) ring of each object, 1 to n; n + 1 beyond the last radius; 0 for dynamic objects."""
    rest: int
    """Ring of the faces that belong to no object; they are treated as one object."""
    measured: int
    """Triangles whose distances were computed; the others lie in boxes beyond the last radius."""

    @property
    def count(self) -> int:
        """Number of rings n, without ring 0."""
        return len(self.radii)

    def objects(self, ring: int) -> tuple[str, ...]:
        """Return the names of a ring's objects; ring 0 has the dynamic ones, n + 1 those beyond the last radius."""
        number = check.integer("ring", ring, 0, self.count + 1)
        return tuple(self.scene.object_names[index] for index in np.flatnonzero(self.ring == number))

    def summary(self) -> list[dict[str, Any]]:
        """Count objects and triangles of each ring.

        The row of each ring, from 1 to n + 1, has `radius` in metres (infinite for n + 1), `objects`, `triangles` as
        drawn, and `stored`, the triangles that no earlier ring has: meshes with several instances are sent once.
        """
        rows = loads(self.scene, self.codes(), self.count + 1)
        return [{"radius": radius, **row} for radius, row in zip((*self.radii, np.inf), rows, strict=True)]

    def codes(self) -> NDArray[np.uint16]:
        """Return ring codes for the kernels (objects + 1,): one per object, then one for faces without an object."""
        return np.append(self.ring, self.rest).astype(np.uint16)

    @card.repr_html
    def _repr_html_(self) -> str:
        facts = [("centre", card.point(self.center)), ("rule", self.rule)]
        for number, row in enumerate(self.summary(), 1):
            name = f"ring {number}, to {row['radius']:g} m" if number <= self.count else "beyond"
            counts = (f"{row[kind]:,} {kind}" for kind in ("objects", "triangles", "stored"))
            facts.append((name, ", ".join(counts)))
        return card.page("Rings", facts)

    def __repr__(self) -> str:
        objects = count(int((self.ring <= self.count).sum()), "object")
        return f"Rings({count(self.count, 'ring')} to {self.radii[-1]:g} m: {objects})"


def assign(scene: Scene, *, center: ArrayLike, radii: Iterable[float], rule: Rule = "object") -> Rings:
    """Divide the objects of a scene into rings.

    ValueError for radii that fall or repeat, no radii, a centre that is not finite, and unknown rules. Source: CloVR
    (2024): "any object that has a vertex inside the cylinder" is near geometry.

    Parameters
    ----------
    scene
        The scene.
    center
        World position of the centre O, metres; its height does not matter.
    radii
        Radii of the rings in metres, positive and ascending, for example from `ring_radii`.
    rule
        Points that count. "object": an object belongs to the first ring that contains any point of its triangles.
        "vertex": only vertices count, as published. Use it for reproduction only: a floor under the user stays in the
        map if its corners are far away.
    """
    core_of(scene)
    middle = check.vector("center", center)
    check.choice("rule", rule, get_args(Rule))
    bounds = check_radii("radii", radii)
    least, least_of_rest, measured = object_radii(scene, middle, bounds[-1], rule)
    ring = 1 + np.searchsorted(bounds, least, side="left").astype(np.int32)
    ring[scene._core.moving_objects()] = 0
    return Rings(scene, middle, bounds, rule, least, ring, 1 + int(np.searchsorted(bounds, least_of_rest)), measured)


def loads(scene: Scene, codes: NDArray[np.uint16], last: int) -> list[dict[str, Any]]:
    """Count objects, triangles as drawn and triangles that no earlier group stores, for each group from 1 to `last`."""
    counts = _core.ring_loads(scene._core, codes, last + 1)
    objects = np.bincount(codes[:-1], minlength=last + 1)
    columns = zip(objects[1:].tolist(), *counts[1:, :2].T.tolist(), strict=True)
    return [dict(zip(("objects", "triangles", "stored"), row, strict=True)) for row in columns]


def object_radii(
    scene: Scene, center: tuple[float, float, float], reach: float, rule: Rule
) -> tuple[NDArray[np.float32], float, int]:
    """Return the least ρ of each object, the least ρ of faces without an object, and the number of measured triangles.

    Beyond `reach` the least ρ is infinite.
    """
    settings: dict[str, Any] = {"center": center, "reach": reach, "rule": rule}
    with progress.bar("rings") as report:
        least, measured = _core.object_radii(scene._core, len(scene.object_names), **settings, report=report)
    return least[:-1], float(least[-1]), measured


def check_radii(name: str, radii: Iterable[float]) -> tuple[float, ...]:
    """Convert radii to numbers; ValueError unless they are positive and ascending."""
    limited = islice(check.iterable(name, radii, "radii"), MAX_RINGS + 1)
    bounds = tuple(check.positive(f"{name}[{n}]", radius) for n, radius in enumerate(limited))
    if not 1 <= len(bounds) <= MAX_RINGS:
        got = len(bounds) if len(bounds) <= MAX_RINGS else "more"
        raise ValueError(f"{name}: expected 1 to {MAX_RINGS} radii, got {got}")
    for before, after in pairwise(bounds):
        if after <= before:
            raise ValueError(f"{name}: expected ascending radii, got {after:g} after {before:g}")
    return bounds
