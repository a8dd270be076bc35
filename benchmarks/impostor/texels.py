"""Scene points of the texels of impostors, recomputed from the quads' triangles and texture coordinates alone."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from nearfar._impostor.bake import PIXELS_PER_DEGREE
from nearfar._impostor.quads import CUTOFF, Quads

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Mask = NDArray[np.bool_]

AXES = np.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], float)
RIGHT = np.array([[0, 0, -1], [0, 0, 1], [1, 0, 0], [1, 0, 0], [1, 0, 0], [-1, 0, 0]], float)
DOWN = np.array([[0, -1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1], [0, -1, 0], [0, -1, 0]], float)
"""Direction of each cube face's middle, and of its columns and rows."""

AROUND = np.array([(0, 0), (-1, 0), (1, 0), (0, -1), (0, 1), (-1, -1), (1, -1), (-1, 1), (1, 1)])
"""A texel and its neighbours, as offsets of columns and rows."""

SAMPLES = (np.stack([np.arange(16), 7 * np.arange(16) % 16], axis=-1) + 0.5) / 16.0
"""Positions (16, 2) in a texel that the bake samples: one in each row and each column of a grid."""


def angle(a: Floats, b: Floats) -> Floats:
    """Return the angle in radians between vectors (…, 3)."""
    return np.asarray(np.arctan2(np.linalg.norm(np.cross(a, b), axis=-1), (a * b).sum(axis=-1)))


@dataclass(frozen=True)
class Points:
    """Points that a layer's centre sees in the directions of texels, (N, 3) relative to O; NaN for none."""

    far: Floats
    """Point of the nearest surface beyond r₂, from which the texel was baked if anything was."""
    first: Floats
    """Point of the nearest surface of all, or the same."""
    normal: Floats
    """Normal of the surface beyond r₂, of any length."""
    plane: Floats
    """Point of the quad's plane."""
    is_behind: Mask
    """(N,) whether the plane is behind the nearest surface of all, so that masks may grow there."""

    def errors(self, shown: Floats, users: Floats) -> Floats:
        """Return the greatest angle (N,), radians, by which users (N, K, 3) see a shown point off its scene point.

        Masks grow over what lies before the plane or on it, so the nearest surface of all counts where it is closer.
        """
        seen = shown[:, None] - users
        far, first = (angle(point[:, None] - users, seen).max(axis=1) for point in (self.far, self.first))
        return np.asarray(np.nan_to_num(np.fmin(far, first), nan=np.inf), np.float64)

    def distances(self, centers: Floats) -> tuple[Floats, Floats]:
        """Return the distance (N,) of the plane from the surface beyond r₂, and from the nearest surface of all.

        It is a share of the surface's distance from the layer's centre; infinite if no surface is seen.
        """
        apart, away = (
            [np.linalg.norm(point - other, axis=1) for point in (self.far, self.first)]
            for other in (self.plane, centers)
        )
        far, first = (np.nan_to_num(one / other, nan=np.inf) for one, other in zip(apart, away, strict=True))
        return far, first


@dataclass(frozen=True)
class Faces:
    """Each quad's cube map: centre of the layer relative to O, face, and place on the face in texels."""

    center: Floats
    face: Ints
    corner: Floats
    """(Q, 2) column and row of the quad's left and upper edge on the face."""
    plane: Floats
    """(Q, 3) inverse depth a + b u + c v over the face, where u and v are −1 to 1."""

    @classmethod
    def from_quads(cls, quads: Quads, size: int) -> Self:
        """Find the face of each quad: the one over which all its vertices lie at the same offset from their texels."""
        centers = np.repeat([at for at, _ in quads.layers], [count for _, count in quads.layers], axis=0)
        owner = np.zeros(len(quads.vertices), np.int64)
        owner[quads.faces] = quads.owners[:, None]
        rays = quads.vertices.astype(np.float64) - centers[owner]
        texels = texel_coordinates(quads) - quads.rectangles[owner, :2]
        counts = np.bincount(owner, minlength=len(quads))
        best = np.full(len(quads), np.inf)
        face, corner = np.zeros(len(quads), np.int64), np.zeros((len(quads), 2))
        for number in range(6):
            depth = rays @ AXES[number]
            with np.errstate(all="ignore"):
                on_face = np.stack([rays @ RIGHT[number], rays @ DOWN[number]], axis=-1) / depth[:, None]
                offsets = (on_face + 1.0) * 0.5 * size - texels
                offsets[~(depth > 0.0)] = np.inf
                mean = np.stack([np.bincount(owner, x, len(quads)) for x in offsets.T], axis=-1) / counts[:, None]
                spread = np.zeros(len(quads))
                np.maximum.at(spread, owner, np.abs(offsets - mean[owner]).max(axis=1))
            is_better = np.nan_to_num(spread, nan=np.inf) < best
            best[is_better], face[is_better], corner[is_better] = spread[is_better], number, mean[is_better]
        assert best.max(initial=0.0) < 0.02, f"quads are no rectangles of a cube face: off by {best.max()} texels"
        corner = np.rint(corner)
        # The plane of least squares through the vertices, about their mean.
        u, v = ((texels + corner[owner]) * 2.0 / size - 1.0).T
        w = 1.0 / (rays * AXES[face[owner]]).sum(axis=1)
        return cls(centers, face, corner, _planes(owner, counts, u, v, w))

    def directions(self, quad: Ints, texels: Floats, size: int) -> tuple[Floats, Floats]:
        """Return rays (N, 3) with depth 1 at positions (N, 2) in texels of quads, and the planes' inverse depths."""
        u, v = ((self.corner[quad] + texels) * 2.0 / size - 1.0).T
        face = self.face[quad]
        rays = AXES[face] + u[:, None] * RIGHT[face] + v[:, None] * DOWN[face]
        return rays, (self.plane[quad] * np.stack([np.ones_like(u), u, v], axis=-1)).sum(axis=1)

    def places(self, quad: Ints, points: Floats, size: int) -> Floats:
        """Return the places (N, 2) in texels of quads at which points, relative to O, lie: inverse to `directions`."""
        rays, face = points - self.center[quad], self.face[quad]
        along = (np.stack([(rays * axes[face]).sum(axis=1) for axes in (RIGHT, DOWN)], axis=-1)).T
        on_face = (along / (rays * AXES[face]).sum(axis=1)).T
        return np.asarray((on_face + 1.0) * 0.5 * size - self.corner[quad], np.float64)


def _planes(owner: Ints, counts: Ints, u: Floats, v: Floats, w: Floats) -> Floats:
    def sums(x: Floats) -> Floats:
        return np.asarray(np.bincount(owner, x, len(counts)), np.float64)

    mean = [sums(x) / counts for x in (u, v, w)]
    du, dv, dw = (x - m[owner] for x, m in zip((u, v, w), mean, strict=True))
    uu, uv, vv, uw, vw = (sums(a * b) for a, b in ((du, du), (du, dv), (dv, dv), (du, dw), (dv, dw)))
    det = uu * vv - uv * uv
    b, c = (uw * vv - vw * uv) / det, (vw * uu - uw * uv) / det
    return np.stack([mean[2] - b * mean[0] - c * mean[1], b, c], axis=-1)


def texel_coordinates(quads: Quads) -> Floats:
    """Return column and row (V, 2) in the atlas, in texels from its left and upper edge."""
    height, width = quads.atlas.shape[:2]
    uvs = quads.uvs.astype(np.float64)
    return np.stack([uvs[:, 0] * width, (1.0 - uvs[:, 1]) * height], axis=-1)


class Texels:
    """Texels of impostors, and the surfaces of a scene from which they were baked."""

    def __init__(self, scene: nf.Scene, impostors: nf.Impostors) -> None:
        assert impostors._quads is not None
        self.quads, self.size, self.impostors = impostors._quads, impostors.settings.face_size, impostors
        self.faces = Faces.from_quads(self.quads, self.size)
        zones = nf.partition(scene, center=impostors.center, r1=0.0, r2=impostors.r2)
        is_far = np.ones(scene.triangle_count, np.bool_)
        is_far[zones.nsf] = False
        self.far = scene.subset(triangles=np.flatnonzero(is_far))
        moving = set(scene.poses)
        self.still = scene.subset(objects=[name for name in scene.object_names if name not in moving])
        self._center = np.array(impostors.center)
        # The quads' triangles over the atlas: rays down through texels find the triangle that shows them.
        flat = np.column_stack([texel_coordinates(self.quads), np.zeros(len(self.quads.vertices))])
        self._atlas = nf.Scene.from_arrays(flat, self.quads.faces)

    def shown_texels(self) -> Ints:
        """Return column and row (N, 2) of all texels in the atlas that quads show."""
        inside = np.zeros(self.quads.atlas.shape[:2], np.bool_)
        for left, top, right, bottom in self.quads.rectangles.tolist():
            inside[top:bottom, left:right] = True
        inside &= self.quads.atlas[..., 3] >= 255.0 * CUTOFF
        return np.argwhere(inside)[:, ::-1]

    def triangles(self, places: NDArray[np.floating[Any]]) -> tuple[Ints, Floats]:
        """Return the triangle (N,) that shows each place (N, 2) in the atlas, and the weights (N, 3) of its corners."""
        origins = np.column_stack([places, np.ones(len(places))])
        hits = nf.cast_rays(self._atlas, origins, np.tile([0.0, 0.0, -1.0], (len(places), 1)))
        assert hits.hit.all()
        second, third = hits.barycentric.astype(np.float64).T
        return hits.triangle_index, np.stack([1.0 - second - third, second, third], axis=-1)

    def points(self, quad: Ints, places: Floats) -> Points:
        """Trace the directions of places (N, 2) in texels from each quad's left and upper edge."""
        rays, w = self.faces.directions(quad, places, self.size)
        center, length = self.faces.center[quad], np.linalg.norm(rays, axis=1)
        far, first = (nf.cast_rays(scene, center + self._center, rays) for scene in (self.far, self.still))
        units = rays / length[:, None]
        corners = np.full((len(quad), 3, 3), np.nan)
        numbers, rows = np.unique(far.triangle_index[far.hit], return_inverse=True)
        if len(numbers):
            hit = self.far.subset(triangles=numbers)
            corners[far.hit] = (hit.triangles() + (hit.origin - self._center))[rows]
        normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        # Hit distances are float32; the triangle's plane is more exact, unless it is seen edge-on.
        with np.errstate(all="ignore"):
            exact = (normal * (corners[:, 0] - center)).sum(axis=1) / (normal * units).sum(axis=1)
        near = np.where(first.hit, first.t_hit, np.nan).astype(np.float64)
        distance = np.where(np.abs(exact / far.t_hit - 1.0) < 1e-3, exact, np.where(far.hit, far.t_hit, np.nan))
        far_point, first_point = (center + t[:, None] * units for t in (distance, near))
        is_behind = length / w > first.t_hit
        return Points(far_point, first_point, normal, center + rays / w[:, None], is_behind)

    def scene_points(self, quad: Ints, texels: Ints) -> tuple[Floats, Points]:
        """Return the place of the scene point of each texel (N, 2), in texels of the quad, and the points there.

        A texel at a silhouette is drawn if enough of its samples lie on the plane, whatever is in its centre. So the
        place is the centre if the bound holds there, and else the sample that sees a surface nearest to the plane. The
        plane is behind the nearest surface of all if it is so in the centre.
        """
        places, centers = np.asarray(texels + 0.5, np.float64), self.faces.center[quad]
        middle = self.points(quad, places)
        rest = np.flatnonzero(~self.are_within(quad, middle))
        samples = texels[rest, None] + SAMPLES
        numbers = np.repeat(rest, len(SAMPLES))
        sampled, _ = self.points(quad[numbers], samples.reshape(-1, 2)).distances(centers[numbers])
        nearest = sampled.reshape(samples.shape[:2])
        is_nearer = nearest.min(axis=1) < np.minimum(*middle.distances(centers))[rest]
        places[rest[is_nearer]] = samples[is_nearer, nearest.argmin(axis=1)[is_nearer]]
        return places, replace(self.points(quad, places), is_behind=middle.is_behind)

    def are_within(self, quad: Ints, points: Points) -> Mask:
        """Return whether the users farthest off see the quads' planes off surfaces beyond r₂ by at most the error."""
        users = self.worst_users(points.plane, points.plane - self.faces.center[quad], np.random.default_rng(0), 0)
        limit = np.radians(self.impostors.settings.error_px / PIXELS_PER_DEGREE) * (1.0 + 1e-6)
        seen = points.plane[:, None] - users
        return np.asarray(angle(points.far[:, None] - users, seen).max(axis=1) <= limit)

    def worst_users(self, points: Floats, directions: Floats, draw: np.random.Generator, count: int) -> Floats:
        """Return users (N, K, 3): the most distant ones from lines of sight, and `count` random ones.

        Lines of sight go through points (N, 3) with directions (N, 3), relative to O.
        """
        unit = directions / np.linalg.norm(directions, axis=1, keepdims=True)
        side = points - (points * unit).sum(axis=1, keepdims=True) * unit
        # From the centre itself every perpendicular is as far from the line.
        side += np.cross(unit, draw.normal(size=unit.shape)) * 1e-9
        side /= np.linalg.norm(side, axis=1, keepdims=True)
        turns = np.linspace(-np.pi, np.pi, 16, endpoint=False)[:, None]
        around = np.cos(turns) * unit[:, None] + np.sin(turns) * side[:, None]
        random = draw.normal(size=(len(points), count, 3))
        random /= np.linalg.norm(random, axis=2, keepdims=True)
        random *= np.cbrt(draw.uniform(size=(len(points), count, 1)))
        return self.impostors.reach * np.concatenate([around, random], axis=1)
