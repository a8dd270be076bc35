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


def look(scene: Scene, eye: Point, center: Point, r1: float, r2: float, *, fov: float) -> Point | None:
    """Return the horizontal direction in which an eye sees the boundary best; None if it is hidden all around."""
    scores = panorama(scene, eye, center, r1, r2).scores(fov)
    return _direction(int(np.argmax(scores))) if scores.max() > 0.0 else None


def choose(
    scene: Scene, place: Viewpoint, distance: float, r1: float, r2: float, *, fov: float
) -> tuple[Point, Point, bool]:
    """Choose a user's place beside a centre, and a view that the boundary crosses.

    Returns the place, at most `distance` metres from the centre; the horizontal direction of view; and whether the
    boundary is in view. If no view shows it, the direction is that of the centre's viewpoint.
    """
    default = beside(scene, place, distance)[0]
    if place.is_outside:
        # Other directions would not show the object.
        scores = panorama(scene, default, place.eye, r1, r2).scores(fov)
        return default, place.forward, bool(scores.max() > 0.0)
    center_scores = panorama(scene, place.eye, place.eye, r1, r2).scores(fov)
    best = (0.0, default, place.forward)
    for turn in np.argsort(-center_scores, kind="stable")[:MAX_COMPARED].tolist():
        forward = _direction(turn)
        for user in beside(scene, replace(place, forward=forward), distance):
            score = float(panorama(scene, user, place.eye, r1, r2).scores(fov)[turn])
            # A user at the centre sees no effect.
            score *= float(np.linalg.norm(np.subtract(user, place.eye))) / distance
            if score > best[0]:
                best = (score, user, forward)
    score, user, forward = best
    return user, forward, score > 0.0


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


def _direction(turn: int) -> Point:
    angle = turn * (2.0 * np.pi / TURNS)
    return float(np.sin(angle)), 0.0, float(-np.cos(angle))
