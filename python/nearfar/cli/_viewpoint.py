"""Viewpoints and user positions of commands, and the reports and original scenes of reduced scenes in folders."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import nearfar as nf
from nearfar._base import check, formats
from nearfar._reduce import default_radii
from nearfar._trace import crossing, viewpoint
from nearfar._trace.viewpoint import Viewpoint
from nearfar.cli._options import Point
from nearfar.cli._scenes import PARTS, open_scene

KNOWN: dict[str, Callable[[], tuple[Point, Point]]] = {
    "city": nf.datasets.street_view,
    "room": nf.datasets.room_view,
    "factory": nf.datasets.factory_view,
    # In these scenes the viewer stands at the origin.
    **dict.fromkeys(("beams", "spheres", "landscape"), lambda: ((0.0, 1.7, 0.0), (0.0, 1.7, -10.0))),
}
"""Functions that return eye and target, by name of the procedural scene."""


@dataclass(frozen=True)
class Stand:
    """User beside a centre, and the point that the user looks at."""

    user: Point
    target: Point
    shows_boundary: bool
    """Whether the boundary is in view; taken as true for a target that is given or read."""


def choose(scene: nf.Scene, source: str, eye: Point | None = None) -> Viewpoint:
    """Choose a viewpoint: at `eye` if set, else the view of a procedural scene, else an open place of the scene."""
    name = source.partition(":")[0]
    is_known = eye is None and name in KNOWN
    return viewpoint.facing(*KNOWN[name]()) if is_known else default_radii.find_place(scene, eye)


def stands(
    scene: nf.Scene,
    place: Viewpoint,
    r1: float,
    r2: float,
    *,
    fov: float = 90.0,
    user: Point | None = None,
    target: Point | None = None,
    distance: float | None = None,
) -> list[Stand]:
    """Positions and views of a user with the boundary in the picture, the best first; given values are kept.

    If no view shows the boundary, returns one: from beside the centre, in the direction of the centre's viewpoint.
    """
    distance = default_radii.user_distance(r1, r2) if distance is None else distance
    if user is not None and target is not None:
        return [Stand(user, target, True)]
    if target is not None:
        is_overhead = target[0] == place.eye[0] and target[2] == place.eye[2]
        ahead = place if is_overhead else viewpoint.facing(place.eye, target)
        return [Stand(each, target, True) for each in viewpoint.beside(scene, ahead, distance)]
    if user is None:
        views = crossing.views(scene, place, distance, r1, r2, fov=fov)
        user = viewpoint.beside(scene, place, distance)[0]
    else:
        views = crossing.looks(scene, user, place.eye, r1, r2, fov=fov)
    default = Stand(user, place.middle or viewpoint.ahead(user, place.forward), False)
    found = [Stand(view.user, place.middle or viewpoint.ahead(view.user, view.forward), True) for view in views]
    # From outside a scene all views of an eye look at the scene's middle, so they may be equal: duplicates are removed.
    return list(dict.fromkeys(found)) or [default]


def report_of(folder: str) -> dict[str, Any]:
    """Return the report of `nearfar reduce` beside a reduced scene; empty if there is none."""
    path, document = Path(folder) / "report.json", None
    if path.is_file():
        with suppress(ValueError):
            document = formats.from_json(path.read_text(encoding="utf-8"))
    return document if isinstance(document, dict) else {}


def view_of(folder: str) -> Stand | None:
    """Return the user and target of the pictures in a reduced scene's folder, from its report; None without one."""
    report = report_of(folder)
    try:
        user, target = (check.vector(name, report[name]) for name in ("user", "target"))
    except (KeyError, TypeError, ValueError):
        return None
    return Stand(user, target, True) if user != target else None


def open_truth(folder: str, truth: str | None, loading: nf.LoadOptions) -> tuple[str, nf.Scene]:
    """Open the original scene of a folder, from `truth` or its report; also return its name."""
    if truth is not None:
        return truth, open_scene(truth, loading)
    report = report_of(folder)
    source = report.get("source")
    if not isinstance(source, str):
        raise ValueError(f"--truth: expected the scene that {folder} was made from; no report.json there names it")
    try:
        stated = _merge_options(report, loading)
    except (TypeError, ValueError) as error:
        raise ValueError(f"{folder}/report.json: {error}") from None
    try:
        return source, open_scene(source, stated)
    except FileNotFoundError:
        raise ValueError(f"--truth: expected the scene that {folder} was made from; {source} is not there") from None


def _merge_options(report: dict[str, Any], loading: nf.LoadOptions) -> nf.LoadOptions:
    """Replace options by the report's; options that are set and select a part of a tileset or a city (`PARTS`) stay."""
    parts = report.get("parts")
    stated = {name: report.get(name) for name in ("up", "scale", "on_invalid", "blend")}
    if isinstance(parts, dict):
        stated |= {name: parts.get(name) for name in PARTS if getattr(loading, name) is None}
    options: dict[str, Any] = {name: value for name, value in stated.items() if value is not None}
    return replace(loading, **options)
