"""Places with users, and the pictures of a far part that a method draws together with the exact near part."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import binary_dilation

import nearfar as nf
from benchmarks.harness.pictures import blocks
from benchmarks.harness.views import Point

BAND = 12
"""Samples beside the seam of near and far part whose points of the scene are looked for."""

GRID = 2
"""Samples along each side of a pixel; the same places for every method."""

PIXELS_PER_RADIAN = 20.0 * 180.0 / np.pi
"""Density of the pixels in which errors are stated, 20 a degree."""

Floats = NDArray[np.float32]


@dataclass(frozen=True, eq=False)
class Far:
    """Samples of a far part for one user."""

    color: Floats
    """(H, W, 3) linear RGB."""
    range: Floats
    """(H, W) metres from the user; +inf where the method shows nothing."""
    shown: NDArray[np.float64]
    """(H, W, 3) world position of the point whose colour a sample shows, as far as the method knows it; else NaN."""


class Method(Protocol):
    """Way to show the far part."""

    @property
    def triangles(self) -> int:
        """Number of triangles or splats that are drawn."""
        ...

    @property
    def bytes(self) -> int:
        """Size of the files."""
        ...

    @property
    def setting(self) -> str:
        """Parameters, and what was chosen for the budget."""
        ...

    def picture(self, place: Place, user: nf.Camera) -> tuple[nf.Frame, NDArray[np.bool_]]:
        """Draw `GRID`² samples for each pixel of both parts; return them, and whether each is of the far part.

        The frame's `position` is the point of the scene whose colour is shown.
        """
        ...


@dataclass(frozen=True, eq=False)
class Place:
    """A scene, the region of its users, and the users by their distance from the centre."""

    name: str
    scene: nf.Scene
    center: Point
    reach: float
    r2: float
    users: Mapping[float, list[nf.Camera]] = field(default_factory=dict)
    """Cameras by distance from the centre, metres."""
    baking: dict[str, Any] = field(default_factory=dict)
    """Further arguments of the bake of impostors."""
    _near_pictures: dict[nf.Camera, nf.Frame] = field(default_factory=dict)

    @cached_property
    def zones(self) -> nf.Partition:
        """Partition at r2."""
        return nf.partition(self.scene, center=self.center, r1=0.0, r2=self.r2)

    @cached_property
    def is_near(self) -> NDArray[np.bool_]:
        """Whether each triangle (T,) reaches inside r2, and so is geometry for all methods."""
        near = np.zeros(self.scene.triangle_count, np.bool_)
        near[self.zones.nsf] = True
        return near

    @cached_property
    def near(self) -> nf.Scene:
        """Near part, the same for all methods but those with a cube map, which move it or cut it off at r2."""
        return self.scene.subset(triangles=self.is_near)

    @cached_property
    def far(self) -> nf.Scene:
        """All other triangles."""
        return self.scene.subset(triangles=~self.is_near)

    def tolerance(self, pixels: float) -> float:
        """Greatest difference of inverse distances, 1/m, that users see as at most so many pixels."""
        return pixels / (PIXELS_PER_RADIAN * self.reach)

    def near_picture(self, user: nf.Camera) -> nf.Frame:
        """Samples of the near part alone; the sky where there is none."""
        if user not in self._near_pictures:
            channels = ("color", "range", "position")
            self._near_pictures[user] = nf.render(self.near, fine(user), channels=channels)
        return self._near_pictures[user]

    @cached_property
    def visible(self) -> nf.Scene:
        """The far triangles that probes see."""
        return self.scene.subset(triangles=self.sample_counts > 0)

    def compose(self, user: nf.Camera, far: Far, *, moved: bool = False) -> tuple[nf.Frame, NDArray[np.bool_]]:
        """Put samples of a far part behind the near part.

        If the method has `moved` surfaces, so that `far.shown` is where something is displayed, the nearest points of
        the scene take its place close to the seam.
        """
        near = self.near_picture(user)
        is_far = far.range < near.require("range")
        color = np.where(is_far[..., None], far.color, near.require("color"))
        shown = far.shown
        if moved:
            band = is_far & binary_dilation(~is_far, iterations=BAND) & np.isfinite(shown[..., 0])
            shown = shown.copy()
            shown[band] = nearest(self.visible, shown[band])
        position = np.where(is_far[..., None], shown - near.origin, near.require("position"))
        return nf.Frame(near.camera, near.origin, color=color, position=position.astype(np.float32)), is_far

    def probes(self) -> list[Point]:
        """Viewpoints of the region: the centre, the circle at the end of reach, and half-way, above and below it."""
        turns = np.arange(6) * (np.pi / 3.0)
        around = self.reach * np.column_stack([np.cos(turns), np.zeros(6), np.sin(turns)])
        inner = 0.5 * around + np.outer([1, -1] * 3, [0.0, min(0.5, 0.5 * self.reach), 0.0])
        steps = np.concatenate([np.zeros((1, 3)), around, inner])
        return [tuple(np.add(self.center, step).tolist()) for step in steps]

    @cached_property
    def sample_counts(self) -> NDArray[np.int64]:
        """Samples (T,) of each far triangle in the probes' cube maps."""
        counts = np.zeros(self.scene.triangle_count, np.int64)
        for number, probe in enumerate(self.probes()):
            for face in range(6):
                size = 1024 if number < 7 else 512
                camera = nf.Camera(probe, fov=nf.CubeFace(face), size=(size, size))
                faces = nf.render(self.scene, camera, channels=("face_id",)).require("face_id")
                counts += np.bincount(faces[faces >= 0], minlength=len(counts))
        return np.where(self.is_near, 0, counts)


def fine(user: nf.Camera) -> nf.Camera:
    """Return the user's view with a pixel for each sample."""
    return nf.Camera(user.position, user.orientation, fov=user.fov, size=(GRID * user.width, GRID * user.height))


def average(samples: nf.Frame, user: nf.Camera) -> nf.Frame:
    """Average samples over the pixels of the user's picture."""
    color = blocks(samples.require("color"), GRID).mean(axis=(1, 3))
    return nf.Frame(user, color=np.ascontiguousarray(color, np.float32))


def draw_scene(scene: nf.Scene, user: nf.Camera, *channels: str) -> nf.Frame:
    """Draw samples of a scene; `channels` are further ones."""
    return nf.render(scene, fine(user), channels=("color", "range", *channels))


def points_of(frame: nf.Frame) -> NDArray[np.float64]:
    """Return the world positions (H, W, 3) that a frame with ranges displays; NaN without a surface."""
    origins, directions = frame.camera.rays()
    distance = frame.require("range")[..., None].astype(np.float64)
    return np.where(
        np.isfinite(distance), origins + directions * np.where(np.isfinite(distance), distance, 0.0), np.nan
    )


def nearest(scene: nf.Scene, points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the surface points nearest to points (N, 3)."""
    if not len(points):
        return points
    found = nf.nearest_points(scene, points)
    corners = scene.triangles()[found.triangle_index].astype(np.float64) + scene.origin
    second, third = found.barycentric.T[:, :, None]
    return np.asarray(corners[:, 0] * (1.0 - second - third) + corners[:, 1] * second + corners[:, 2] * third)


def move_along(scene: nf.Scene, points: NDArray[np.float64], directions: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the surface points nearest to points (N, 3) on the lines through them; the points where there is none.

    A colour was baked along such a line, so it belongs to one of the surfaces on it.
    """
    ways = [directions, -directions]
    distances = np.stack([nf.cast_rays(scene, points, way).t_hit for way in ways])
    nearest = np.where(distances[0] <= distances[1], distances[0], -distances[1])[:, None]
    return np.where(np.isfinite(nearest), points + directions * np.where(np.isfinite(nearest), nearest, 0.0), points)


def baked_at(scene: nf.Scene, points: NDArray[np.float64], center: Point) -> NDArray[np.float64]:
    """Return for displayed points (H, W, 3) the points of the scene in the same direction from a centre."""
    found = points.copy()
    is_shown = np.isfinite(points[..., 0])
    rays = points[is_shown] - center
    found[is_shown] = move_along(scene, points[is_shown], rays / np.linalg.norm(rays, axis=1, keepdims=True))
    return found


Fit = Callable[[float], Any]

TRIES = 4
"""Greatest number of results that are made for a budget."""


def fill(
    make: Fit, cost: Callable[[Any], float], budget: float, low: float, high: float, *, first: float | None = None
) -> Any:
    """Make the result with the greatest parameter whose cost, which grows with it, keeps a budget.

    The first try is `high`, or `first` if it is given, and there are at most `TRIES`. Further parameters are chosen by
    interpolation of logarithms, within `low` and `high`; it ends when 92 % of the budget are used. If nothing keeps it,
    the cheapest result is returned.
    """
    value, best = high if first is None else first, None
    inside: tuple[float, float] | None = None
    outside: tuple[float, float] | None = None
    for _ in range(TRIES):
        result = make(value)
        spent = max(cost(result), 1.0)
        if spent <= budget:
            inside = (np.log(value), np.log(spent))
            best = result
            if spent >= 0.92 * budget or value >= high:
                break
        else:
            outside = (np.log(value), np.log(spent))
            best = best if inside else result
        target = np.log(0.99 * budget)
        if inside and outside:
            share = (target - inside[1]) / (outside[1] - inside[1])
            value = float(np.exp(inside[0] + np.clip(share, 0.1, 0.95) * (outside[0] - inside[0])))
        else:
            known = inside or outside
            assert known is not None
            # Costs grow with the parameter (triangles) or with its square (edges of maps). Upwards a step between both;
            # downwards the longer one, which gets inside the budget with fewer tries.
            power = 1.5 if inside else 1.0
            value = float(np.clip(np.exp(known[0] + (target - known[1]) / power), low, high))
            if value == np.exp(known[0]):
                break
    return best
