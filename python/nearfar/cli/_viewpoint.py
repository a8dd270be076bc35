"""Default viewpoints and user positions of commands."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import nearfar as nf
from nearfar._reduce import default_radii
from nearfar._trace import crossing, viewpoint
from nearfar._trace.viewpoint import Viewpoint
from nearfar.cli._options import Point

KNOWN: dict[str, Callable[[], tuple[Point, Point]]] = {
    "city": nf.datasets.street_view,
    "room": nf.datasets.room_view,
    "factory": nf.datasets.factory_view,
    # Their viewer stands at the origin.
    **dict.fromkeys(("beams", "spheres", "landscape"), lambda: ((0.0, 1.7, 0.0), (0.0, 1.7, -10.0))),
}
"""Functions that return eye and target, by name of the procedural scene."""


@dataclass(frozen=True)
class Stand:
    """User beside a centre who looks at the boundary."""

    user: Point
    target: Point
    crosses: bool
    """Whether the boundary is in view."""


def choose(scene: nf.Scene, source: str, eye: Point | None = None) -> Viewpoint:
    """Choose a viewpoint: at `eye` if set, else the view of a procedural scene, else an open place of the scene."""
    name = source.partition(":")[0]
    is_known = eye is None and name in KNOWN
    return viewpoint.facing(*KNOWN[name]()) if is_known else default_radii.find_place(scene, eye)


def stand(
    scene: nf.Scene,
    place: Viewpoint,
    r1: float,
    r2: float,
    *,
    fov: float = 90.0,
    user: Point | None = None,
    target: Point | None = None,
    distance: float | None = None,
) -> Stand:
    """Choose a user's position and view so that the boundary is in the picture; given values are kept."""
    distance = default_radii.user_distance(r1, r2) if distance is None else distance
    if user is None and target is None:
        user, forward, crosses = crossing.choose(scene, place, distance, r1, r2, fov=fov)
        return Stand(user, place.middle or viewpoint.ahead(user, forward), crosses)
    if user is None:
        user = viewpoint.beside(scene, place, distance)[0]
    if target is not None:
        return Stand(user, target, True)
    direction = crossing.look(scene, user, place.eye, r1, r2, fov=fov)
    return Stand(user, place.middle or viewpoint.ahead(user, direction or place.forward), direction is not None)
