"""Choice of a user's place and view so that the boundary of the near part, at r2, is in the picture."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from nearfar._scene.scene import Scene
from nearfar._trace.rays import cast_rays
from nearfar._trace.viewpoint import Point, Viewpoint, beside

PITCHES = 61
"""Number of rays from top to bottom; they are denser at the horizon, where distant surfaces are."""

MAX_PITCH_DEG = 40.0
"""Greatest angle in degrees between a ray and the horizon."""

AZIMUTHS = 360
"""Number of rays around an eye at each pitch."""

TURNS = 72
"""Number of compared viewing directions."""

MAX_COMPARED = 6
"""Number of directions for which user places on both sides are compared."""

MIN_ANGLE_DEG = 30.0
"""Least angle in degrees between the directions of further views."""

MAX_RATIO = 1.5
"""Greatest ratio between r2 and the axis distances of neighbouring points that may be on one surface across r2."""

GROUND_WEIGHT = 0.05
"""Weight of horizontal boundaries, such as on the ground, where the picture is torn along the boundary."""

MIN_SHARE = 0.05
"""Share of a picture at which a zone counts as well visible."""


@dataclass(frozen=True)
class Panorama:
    """Zones and boundary around an eye by azimuth, clockwise from −z."""

    shares: NDArray[np.float64]
    """(3, AZIMUTHS) share of the rays that hit near, intermediate and far surfaces."""
    crossing: NDArray[np.float64]
    """(AZIMUTHS,) weighted length of the boundary, degrees."""

    def scores(self, fov: float) -> NDArray[np.float64]:
        """Return (TURNS,) scores of views by horizontal field of view, degrees; 0 if the boundary is not in view."""
        # The outer tenth of a picture is left out, so that the boundary is well inside it.
        half_window = max(round(0.4 * fov * AZIMUTHS / 360.0), 1)
        window = np.arange(-half_window, half_window + 1)
        middles = np.arange(TURNS) * (AZIMUTHS // TURNS)
        azimuths = (middles[:, None] + window) % AZIMUTHS
        visible = np.minimum(self.shares[:, azimuths].mean(axis=-1) / MIN_SHARE, 1.0).sum(axis=0)
        return np.asarray(np.sqrt(self.crossing[azimuths].sum(axis=-1)) * visible, np.float64)


@dataclass(frozen=True)
class View:
    """A user's place, and a direction of view that the boundary crosses."""

    user: Point
    forward: Point
    """Horizontal unit direction."""
    turn: int = 0
    """Number of the direction, clockwise from −z in steps of 360° / TURNS."""
    score: float = 0.0


def looks(scene: Scene, eye: Point, center: Point, r1: float, r2: float, *, fov: float) -> list[View]:
    """Views of an eye that the boundary crosses, the best first, in directions at least `MIN_ANGLE_DEG` apart."""
    scores = panorama(scene, eye, center, r1, r2).scores(fov)
    turns = _apart(scores, int(np.argmax(scores)))
    return [View(eye, _direction(turn), turn, float(scores[turn])) for turn in turns if scores[turn] > 0.0]


def views(scene: Scene, place: Viewpoint, distance: float, r1: float, r2: float, *, fov: float) -> list[View]:
    """Views of users beside a centre that the boundary crosses, the best first.

    Users stand at most `distance` metres to the left or to the right of the centre. The other views' directions are at
    least `MIN_ANGLE_DEG` apart. A user outside a scene looks at its middle: another direction would not show it.
    """
    if place.is_outside:
        users = beside(scene, place, distance)
        tops = [float(panorama(scene, user, place.eye, r1, r2).scores(fov).max()) for user in users]
        seen = [View(user, place.forward, score=top) for user, top in zip(users, tops, strict=True) if top > 0.0]
        return sorted(seen, key=lambda view: -view.score)
    center_scores = panorama(scene, place.eye, place.eye, r1, r2).scores(fov)

    def on_both_sides(turns: list[int]) -> list[View]:
        rated = []
        for turn in turns:
            forward = _direction(turn)
            for user in beside(scene, replace(place, forward=forward), distance):
                score = float(panorama(scene, user, place.eye, r1, r2).scores(fov)[turn])
                # A user at the centre sees no effect.
                score *= float(np.linalg.norm(np.subtract(user, place.eye))) / distance
                rated.append(View(user, forward, turn, score))
        return [view for view in rated if view.score > 0.0]

    best_turns = np.argsort(-center_scores, kind="stable")[:MAX_COMPARED].tolist()
    best = max(on_both_sides(best_turns), key=lambda view: view.score, default=None)
    turns = _apart(center_scores, best_turns[0] if best is None else best.turn)
    others = [view for view in on_both_sides(turns) if view != best]
    return [*([] if best is None else [best]), *sorted(others, key=lambda view: -view.score)]


def panorama(scene: Scene, eye: Point, center: Point, r1: float, r2: float) -> Panorama:
    """Cast rays around an eye, and measure zones and boundary about the axis through a centre."""
    u = np.linspace(-1.0, 1.0, PITCHES)
    pitch = np.radians(MAX_PITCH_DEG) * u * np.abs(u)
    steps = np.gradient(pitch)
    azimuth = np.arange(AZIMUTHS) * (2.0 * np.pi / AZIMUTHS)
    up, azimuths = np.meshgrid(pitch, azimuth, indexing="ij")
    rays = np.stack([np.cos(up) * np.sin(azimuths), np.sin(up), -np.cos(up) * np.cos(azimuths)], axis=-1)
    points = cast_rays(scene, np.asarray(eye, np.float64), rays.reshape(-1, 3)).position.reshape(*up.shape, 3)
    rho = np.hypot(points[..., 0] - center[0], points[..., 2] - center[2])
    weights = (steps / steps.sum())[:, None]
    zones = (rho <= r1, (rho > r1) & (rho <= r2), rho > r2)
    crosses_sideways = _is_across(rho, np.roll(rho, -1, axis=1), r2)
    crosses_downwards = _is_across(rho[:-1], rho[1:], r2)
    upright = (crosses_sideways * np.degrees(steps)[:, None]).sum(axis=0)
    level = crosses_downwards.sum(axis=0) * (360.0 / AZIMUTHS)
    return Panorama(np.stack([(zone * weights).sum(axis=0) for zone in zones]), upright + GROUND_WEIGHT * level)


def _is_across(first_rho: NDArray[np.float64], second_rho: NDArray[np.float64], r2: float) -> NDArray[np.bool_]:
    """Return whether neighbouring points lie on both sides of r2, perhaps on one surface; False for NaN."""
    nearer, farther = np.minimum(first_rho, second_rho), np.maximum(first_rho, second_rho)
    return np.asarray((nearer <= r2) & (farther > r2) & (nearer * MAX_RATIO >= r2) & (farther <= MAX_RATIO * r2))


def _apart(scores: NDArray[np.float64], first: int) -> list[int]:
    """Up to `MAX_COMPARED` directions: `first`, and the best ones at least `MIN_ANGLE_DEG` from those before."""
    found, least = [first], MIN_ANGLE_DEG / 360.0 * TURNS
    for turn in np.argsort(-scores, kind="stable").tolist():
        if all(abs((turn - other + TURNS // 2) % TURNS - TURNS // 2) >= least for other in found):
            found.append(turn)
    return found[:MAX_COMPARED]


def _direction(turn: int) -> Point:
    angle = turn * (2.0 * np.pi / TURNS)
    return float(np.sin(angle)), 0.0, float(-np.cos(angle))
