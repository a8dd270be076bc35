"""Two simplifiers of surfaces: fast-simplification's quadrics, which move vertices, and meshoptimizer's."""

from __future__ import annotations

import threading
from dataclasses import dataclass
from functools import cached_property
from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar.lod._simplify.carry import Carrier
from nearfar.lod._simplify.normals import unit
from nearfar.lod._simplify.surface import Surface, charts_of, first_alike

EXTENT = 100.0
"""Size of what fast-simplification sees. Its thresholds are absolute: of a small thing the first would let everything
collapse in the order of the list, and a large one would never reach few triangles."""

FIN = 0.5123
"""Height of a fin over its edge, as a share of the edge; an odd number, so that its apex is no vertex of a lattice."""

_TRIES, _NEAR = 3, 0.005
"""Runs until a level has its triangles, but for a share of them."""

_REACHED = 1.01
"""Times the triangles asked for up to which nothing more is given up."""

_ONE_AT_A_TIME = threading.Lock()
"""fast-simplification works in global variables."""


class Quadrics:
    """Garland's and Heckbert's quadrics by fast-simplification, for one base.

    Vertices are welded by place first, so that seams do not open. Open borders and seams of charts are kept straight by
    fins: triangles that stand on their edges and whose planes count like those of the surface.
    """

    def __init__(self, surface: Surface, places: NDArray[np.uint32]) -> None:
        self._package = _package()
        self._surface = surface
        faces, self._origin = _distinct(places[surface.faces])
        used, welded = np.unique(faces, return_inverse=True)
        self._faces = welded.reshape(-1, 3).astype(np.int32)
        self._places = surface.positions[used]
        points = self._places.astype(np.float64)
        low, extent = _box(points)
        self._middle, self._scale = low + extent / 2, EXTENT / extent
        self._points = (points - self._middle) * self._scale
        _, seams = charts_of(surface, *("uvs",) * ("uvs" in surface.attributes))
        self._fins = fins(self._points, self._faces, seams[self._origin])

    @cached_property
    def _carrier(self) -> Carrier:
        return Carrier(self._surface)

    def level(self, target: int) -> Surface:
        """Return the surface in about `target` triangles, with its attributes."""
        if target >= len(self._surface.faces):
            return self._surface
        if target >= len(self._faces):
            # Copies and faces without an area are all that goes.
            return self._carrier.carried(self._places, self._faces.astype(np.uint32), self._origin)
        points, faces = self._points, self._faces
        apexes, feet = self._fins
        rest = np.arange(len(points), len(points) + len(apexes), dtype=np.int32)
        both = np.concatenate([points, apexes]), np.concatenate([faces, np.column_stack([feet, rest])])
        wanted = target
        for _ in range(_TRIES):
            moved, roots = self._run(*both, wanted)
            places = (moved / self._scale + self._middle).astype(np.float32)
            # Flat parts collapse onto corners where a vertex is already: such faces are nothing.
            left = first_alike(places)[roots][faces]
            kept = np.flatnonzero(_is_triangle(left))
            missing = target - len(kept)
            # Fins that are left count too: how many is known after a try.
            if abs(missing) <= _NEAR * target or not 0 < wanted + missing < len(both[1]):
                break
            wanted += missing
        left = left[kept]
        used, renumbered = np.unique(left, return_inverse=True)
        triangles = np.ascontiguousarray(renumbered.reshape(-1, 3), np.uint32)
        return self._carrier.carried(places[used], triangles, self._origin[kept])

    def _run(
        self, points: NDArray[np.float64], faces: NDArray[np.int32], target: int
    ) -> tuple[NDArray[np.float64], NDArray[np.int32]]:
        """Where points have moved, and into which one each has been merged."""
        with _ONE_AT_A_TIME:
            moved, left, merged = self._package.simplify(points, faces, target_count=target, return_collapses=True)
        roots = np.arange(len(points), dtype=np.int32)
        if len(merged):
            # Every point is merged at most once; its list is followed to the end by halving it again and again.
            roots[merged[:, 1]] = merged[:, 0]
            while not np.array_equal(further := roots[roots], roots):
                roots = further
        # What is left of the list is what has three corners still, in its order.
        expected = roots[faces]
        expected = expected[_is_triangle(expected)]
        places = points.copy()
        places[expected] = moved[left]
        return places, roots


def _package() -> ModuleType:
    try:
        import fast_simplification
    except ModuleNotFoundError:
        raise ModuleNotFoundError(
            "method 'fast' needs the Python package fast-simplification: pip install nearfar[lod]",
            name="fast_simplification",
        ) from None
    module: ModuleType = fast_simplification
    return module


def _is_triangle(faces: NDArray[Any]) -> NDArray[np.bool_]:
    a, b, c = faces.T
    return np.asarray((a != b) & (b != c) & (c != a))


def _distinct(faces: NDArray[np.uint32]) -> tuple[NDArray[np.uint32], NDArray[np.int64]]:
    """Faces with three corners, the first of each set of corners, and their numbers."""
    rows = np.flatnonzero(_is_triangle(faces))
    corners = np.ascontiguousarray(np.sort(faces[rows], axis=1), np.uint32)
    first = _core.first_alike(corners.view(np.uint8).reshape(len(rows), -1)) if len(rows) else rows
    rows = rows[first == np.arange(len(rows))]
    return faces[rows], rows


def fins(
    points: NDArray[np.float64], faces: NDArray[np.int32], charts: NDArray[np.uint32]
) -> tuple[NDArray[np.float64], NDArray[np.int32]]:
    """Apexes (K, 3) and feet (K, 2) of fins on edges with one face and on those between charts.

    Collapsing an apex costs nothing, so fins are gone soon; what they leave in the quadrics of their feet is the plane
    across the surface.
    """
    here = np.stack([faces, np.roll(faces, -1, axis=1)], axis=2).reshape(-1, 2)
    sides = np.stack([charts, np.roll(charts, -1, axis=1)], axis=2).reshape(-1, 2)
    swaps = here[:, 0] > here[:, 1]
    ends = np.where(swaps[:, None], here[:, ::-1], here)
    sides = np.where(swaps[:, None], sides[:, ::-1], sides)
    order = np.lexsort((ends[:, 1], ends[:, 0]))
    ends, sides = ends[order], sides[order]
    starts = np.flatnonzero(np.append(True, (ends[1:] != ends[:-1]).any(axis=1)))
    counts = np.diff(np.append(starts, len(ends)))
    number = np.repeat(np.arange(len(starts)), counts)
    differs = (sides != sides[starts[number]]).any(axis=1)
    wanted = (counts == 1) | (np.bincount(number, differs, len(starts)) > 0)
    edge = order[starts[wanted]]
    feet = here[edge][:, ::-1]
    corners = points[faces[edge // 3]]
    normal = unit(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]))
    low, high = points[feet[:, 0]], points[feet[:, 1]]
    apexes = (low + high) / 2 + normal * FIN * np.linalg.norm(high - low, axis=1, keepdims=True)
    flat = ~normal.any(axis=1)
    return apexes[~flat], feet[~flat].astype(np.int32)


@dataclass(frozen=True)
class _Weight:
    """How much a difference of 1 in an attribute counts, as a share of the extent."""

    normals: float = 0.1
    colors: float = 0.1
    uvs: float = 0.5
    """Of what the texture slides over the surface."""


class Picks:
    """meshoptimizer's simplifier: vertices of levels are vertices of the base, with all that they have."""

    def __init__(self, surface: Surface, places: NDArray[np.uint32]) -> None:
        keys = tuple(surface.attributes)
        rows, faces = charts_of(surface, *keys)
        used, renumbered = np.unique(faces, return_inverse=True)
        vertex = rows[used]
        self._faces = np.ascontiguousarray(renumbered.reshape(-1, 3), np.uint32)
        self._surface = surface
        self._vertex = vertex
        material = np.zeros(len(used), np.int32)
        material[self._faces] = surface.materials[:, None]
        self._material = material
        self._positions = np.ascontiguousarray(surface.positions[vertex] + np.float32(0))
        self._weights = self._weigh()
        _, sewn = charts_of(surface, *("uvs",) * ("uvs" in keys))
        self._is_seam = self._seams(places, sewn)

    def _seams(self, places: NDArray[np.uint32], sewn: NDArray[np.uint32]) -> NDArray[np.bool_]:
        """Vertices at whose place charts or materials meet."""
        at = places[self._surface.faces].ravel().astype(np.int64)
        pairs = np.unique(np.column_stack([at, sewn.ravel()]), axis=0)
        meet = np.bincount(pairs[:, 0], minlength=len(places)) > 1
        return np.ascontiguousarray(meet[places[self._vertex]])

    def _weigh(self) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
        surface, weight = self._surface, _Weight()
        columns, weights = [], []
        _, extent = _box(surface.positions[self._vertex].astype(np.float64))
        for key, values in surface.attributes.items():
            rows = values[self._vertex].astype(np.float32)
            if key == "colors":
                rows, share = rows / np.float32(255), weight.colors
            elif key == "normals":
                share = weight.normals
            else:
                share = weight.uvs * _stretch(surface) / extent
            columns.append(rows)
            weights += [share] * rows.shape[1]
        table = np.concatenate(columns, axis=1) if columns else np.zeros((len(self._vertex), 0), np.float32)
        table = np.nan_to_num(table, posinf=0.0, neginf=0.0)
        return np.ascontiguousarray(table, np.float32), np.array(weights, np.float32)

    def level(self, target: int) -> Surface:
        """Return the surface in about `target` triangles; where it must be, without some seams and small parts."""
        if target >= len(self._faces):
            return self._surface
        arrays = (self._positions, *self._weights, self._is_seam, self._faces)
        left = self._faces
        for given in ("nothing", "seams", "parts"):
            found, _ = _core.collapse(*arrays, target, given)
            left = min(left, found, key=len)
            if len(found) <= _REACHED * target:
                break
        used, renumbered = np.unique(left, return_inverse=True)
        vertex = self._vertex[used]
        return Surface(
            np.ascontiguousarray(self._surface.positions[vertex]),
            np.ascontiguousarray(renumbered.reshape(-1, 3), np.uint32),
            np.ascontiguousarray(self._material[left[:, 0]]),
            {key: np.ascontiguousarray(value[vertex]) for key, value in self._surface.attributes.items()},
        )


def _box(points: NDArray[np.float64]) -> tuple[NDArray[np.float64], float]:
    """Least corner and longest side of the box of points; 1 where it has no side."""
    if not len(points):
        return np.zeros(3), 1.0
    low, high = points.min(axis=0), points.max(axis=0)
    return low, float((high - low).max()) or 1.0


def _stretch(surface: Surface) -> float:
    """Metres of surface for a step of 1 in texture coordinates."""
    corners, uvs = surface.positions[surface.faces].astype(np.float64), surface.attributes["uvs"][surface.faces]
    area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1).sum()
    one, other = (uvs[:, 1] - uvs[:, 0]).astype(np.float64), (uvs[:, 2] - uvs[:, 0]).astype(np.float64)
    drawn = np.abs(one[:, 0] * other[:, 1] - one[:, 1] * other[:, 0])
    drawn = drawn[np.isfinite(drawn)].sum()
    return float(np.sqrt(area / drawn)) if drawn > 0 else 0.0
