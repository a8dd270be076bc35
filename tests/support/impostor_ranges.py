"""Random scenes for impostors, and the comparison of a picture's range with the truth by the error bound."""

from __future__ import annotations

import itertools
from dataclasses import dataclass
from typing import Any

import numpy as np
import trimesh
from numpy.typing import NDArray

import nearfar as nf
from tests.support.reduce_cases import box

Floats = NDArray[np.float64]
Mask = NDArray[np.bool_]

KINDS = ("box", "sphere", "wall")
FOV = 90.0
OVER = 3
"""Finer sampling of the truth along each axis."""
FLAT = 0.99
"""Least cosine between normals of neighbouring pixels that show one surface."""


@dataclass(frozen=True)
class Shape:
    """A box, sphere or wall on the ground, at a direction and distance from the centre."""

    kind: str
    turn: float
    distance: float
    """In multiples of r₂; less than 1 is near."""
    size: float
    height: float

    def mesh(self, r2: float) -> tuple[Any, Any]:
        """Vertices and faces, metres."""
        at = self.distance * r2 * np.array([np.cos(self.turn), 0.0, np.sin(self.turn)])
        size = self.size * r2
        if self.kind == "sphere":
            ball = trimesh.creation.icosphere(subdivisions=2, radius=0.5 * size)
            return ball.vertices + at + [0.0, self.height * size, 0.0], ball.faces
        depth = 0.02 * size if self.kind == "wall" else size
        corners, faces = box((-0.5 * size, 0.0, -0.5 * depth), (0.5 * size, (0.2 + self.height) * size, 0.5 * depth))
        cos, sin = np.cos(2.0 * self.turn), np.sin(2.0 * self.turn)
        return corners @ np.array([[cos, 0, sin], [0, 1, 0], [-sin, 0, cos]]) + at, faces


def scene_of(shapes: list[Shape], r2: float, *, has_ground: bool) -> nf.Scene:
    """Return a scene of shapes that leave the middle free, each an object."""
    build = nf.SceneBuilder()
    if has_ground:
        ground = 6.0 * r2 * np.array([[-1, 0, -1], [-1, 0, 1], [1, 0, 1], [1, 0, -1]], float)
        build.instance(build.mesh(ground, [[0, 1, 2], [0, 2, 3]]), name="ground")
    for number, shape in enumerate(shapes):
        build.instance(build.mesh(*shape.mesh(r2)), name=f"{shape.kind}_{number}")
    return build.build()


@dataclass(frozen=True)
class Compared:
    """Masks (H, W) of pixels of the quads or of nothing, for which the truth has a far surface or nothing."""

    counted: Mask
    missing: Mask
    """Pixels that show something behind the true surface, or nothing, and no surface near the pixel explains it."""
    wrong: Mask
    """Other pixels whose range no surface near the pixel explains."""


def compare(scene: nf.Scene, impostors: nf.Impostors, user: Floats, turn: float, size: int) -> Compared:
    """Compare the range of a picture with the truth's: it must be one that the bound allows for a surface nearby.

    Nearby are pixels within the width of a texel and a half, by which masks grow past a surface's end, and half a texel
    by which texture coordinates may be off, each as large as the user sees them.
    """
    toward = np.add(user, (np.sin(turn), 0.0, -np.cos(turn)))
    cameras = [
        nf.Camera.look_at(user, toward, fov=nf.Fov.symmetric(FOV), size=(pixels, pixels))
        for pixels in (OVER * size, size)
    ]
    channels = ("range", "normal", "object_id", "position")
    truth = nf.render(scene, cameras[0], channels=channels)
    shown = nf.render(impostors, cameras[1], channels=channels)
    radius, found = OVER * nearby(impostors, size), shown.require("range").astype(np.float64)
    low, high = allowed(impostors, truth)
    edges = (radius, radius + 1)
    images = [np.pad(image, (edges, edges), mode="edge") for image in (low, high, truth.require("object_id"))]
    normals = np.pad(truth.require("normal"), (edges, edges, (0, 0)), mode="edge")

    def beside(image: Any, dy: int, dx: int) -> Any:
        """Values of a finer image beside each pixel."""
        first = [radius + OVER // 2 + step for step in (dy, dx)]
        return image[first[0] : first[0] + OVER * size : OVER, first[1] : first[1] + OVER * size : OVER]

    is_sky, ok = ~np.isfinite(found), np.zeros(found.shape, np.bool_)
    steps = range(-radius, radius + 1)
    for dy, dx in itertools.product(steps, steps):
        low_here, high_here, object_here = (beside(image, dy, dx) for image in images)
        ok |= (low_here <= found) & (found <= high_here) | is_sky & (object_here < 0)
        for other in ((dy, dx + 1), (dy + 1, dx)):
            # Between neighbours on one flat surface every range may be shown.
            low_there, high_there, object_there = (beside(image, *other) for image in images)
            is_flat = (beside(normals, dy, dx) * beside(normals, *other)).sum(axis=-1) > FLAT
            is_same = is_flat & (object_here == object_there)
            ok |= is_same & (np.minimum(low_here, low_there) <= found) & (found <= np.maximum(high_here, high_there))
    rho = np.linalg.norm((truth.require("position") + truth.origin - impostors.center)[..., [0, 2]], axis=-1)
    middle = np.s_[OVER // 2 :: OVER, OVER // 2 :: OVER]
    # Quads have the object numbers of their surfaces; near geometry alone has the same range where it is shown.
    near = nf.render(impostors.near, cameras[1], channels=("range",)).require("range").astype(np.float64)
    is_geometry = np.isfinite(near) & (near <= found)
    counted = ~is_geometry & ~(rho[middle] <= impostors.r2)
    bad = counted & ~ok
    # The sky's range is infinite, and nothing is behind it.
    is_behind = (truth.require("object_id")[middle] >= 0) & ~(found <= high[middle])
    return Compared(counted, bad & is_behind, bad & ~is_behind)


def allowed(impostors: nf.Impostors, truth: nf.Frame) -> tuple[Floats, Floats]:
    """Return the least and greatest range (H, W) at which the bound lets any layer show each of the truth's points.

    By definition: the greatest s = |P − P′| for which s k ≤ sin ε · m · max(m − s, t′ − k), t′ = t ± s, for each layer.
    """
    points = truth.require("position").astype(np.float64) + truth.origin - impostors.center
    sine = np.sin(np.radians(impostors.settings.error_px / 20.0))
    m = np.linalg.norm(points, axis=-1) - impostors.reach
    nearer, farther = np.zeros_like(m), np.zeros_like(m)
    for at, _ in impostors.layers:
        offset = np.subtract(at, impostors.center)
        k, t = impostors.reach + np.linalg.norm(offset), np.linalg.norm(points - offset, axis=-1)
        both = m * m * sine / (k + m * sine)
        nearer = np.fmax(nearer, np.fmax(both, m * (t - k) * sine / (k + m * sine)))
        rest = k - m * sine
        with np.errstate(divide="ignore"):
            beyond = np.where(rest > 0.0, m * (t - k) * sine / rest, np.inf)
        farther = np.fmax(farther, np.fmax(both, beyond))
    ranges = truth.require("range").astype(np.float64)
    with np.errstate(invalid="ignore"):
        return np.nan_to_num((ranges - nearer) * (1.0 - 1e-4), nan=np.inf), (ranges + farther) * (1.0 + 1e-4)


def nearby(impostors: nf.Impostors, size: int) -> int:
    """Return the radius in pixels within which pixels are nearby."""
    texel = 2.0 / impostors.settings.face_size
    # A layer's centre may be twice `reach` farther from a surface than the user is.
    nearest = impostors.r2 - impostors.reach
    larger = (nearest + 2.0 * impostors.reach) / nearest
    pixel = 2.0 * np.tan(np.radians(0.5 * FOV)) / size
    return int(np.ceil(2.0 * np.sqrt(2.0) * texel * larger / pixel + 0.5))
