"""Quads for a file: rounded positions and texture coordinates, sectors, and an order that compresses well.

One step of 16 bits over a whole city is 17 cm, which a user 50 m away sees as 3 pixels. Here the step of a quad is a
power of two that grows with its distance, so that it is seen as about the same angle everywhere: each octave of the
distance is a shell with its own step. Steps need not be a property of nodes, because a float32, and a word of the
EXPONENTIAL filter of `EXT_meshopt_compression`, has its own exponent.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nearfar._impostor.quads import Quads

SECTORS = 6
"""Number of sectors by azimuth about O, which engines cull by themselves."""

ERROR_SHARE = 1.0 / 8.0
"""Greatest error of positions as a share of the quads' error."""
MAX_ERROR_PX = 0.25
"""Greatest error of positions, pixels: a fraction of the texel by which neighbouring quads overlap."""
UV_ERROR_TEXELS = 3.0 / 16.0
"""Greatest error of texture coordinates, texels of the longer side: with half a texel for the filter less than the
texel that surrounds each quad."""

_PIXELS_PER_RADIAN = 20.0 * 180.0 / math.pi
_MANTISSA_BITS = 22
"""Greatest number of bits of a coordinate: float32 and the filter hold one more."""

Floats = NDArray[np.float64]
Steps = NDArray[np.int64]


@dataclass(frozen=True)
class Sector:
    """Quads whose middle points lie in one sector."""

    vertices: slice
    """Rows of the sector's vertices."""
    opaque: NDArray[np.uint32]
    """(F, 3) vertex numbers, from the sector's first vertex, of faces of opaque quads."""
    masked: NDArray[np.uint32]
    """(F, 3) the same of quads with transparent texels."""

    @property
    def parts(self) -> list[tuple[bool, NDArray[np.uint32]]]:
        """Whether each primitive is masked, and its faces."""
        return [(masked, faces) for masked, faces in ((False, self.opaque), (True, self.masked)) if len(faces)]


@dataclass(frozen=True)
class Packed:
    """Rounded vertices of quads, and their sectors."""

    steps: Steps
    """(V, 3) positions in steps."""
    exponents: Steps
    """(V,) a step of a vertex is 2 to this power, metres."""
    uv_steps: Steps
    """(V, 2) texture coordinates in steps, v pointing down as in glTF."""
    uv_exponents: Steps
    """(V,) a step of a texture coordinate is 2 to this power."""
    sectors: tuple[Sector, ...]
    error_px: float
    """Greatest error of a position as the worst user of the region sees it, pixels of 1/20 degree."""
    uv_error: float
    """Greatest error of a texture coordinate, texels."""


def pack(quads: Quads, reach: float, error_px: float) -> Packed:
    """Round the quads of a region with a radius of `reach` metres, which have an error of `error_px`, and order them.

    Quads are in the order of sectors, opaque before masked ones, then of steps and of octants about O, so that the high
    bytes of vertices seldom change, and then of rows of the texture, so that its coordinates change little. Vertices
    are in the order of their first use, for which a triangle's corners take a byte.
    """
    points = quads.vertices.astype(np.float64)
    owner = np.zeros(len(points), np.int64)
    owner[quads.faces] = quads.owners[:, None]
    count = np.maximum(np.bincount(owner, minlength=len(quads)), 1)
    middles = np.column_stack([np.bincount(owner, axis, len(quads)) / count for axis in points.T])
    exponents = _exponents(points, owner, len(quads), reach, min(ERROR_SHARE * error_px, MAX_ERROR_PX))
    sector = _sectors(middles)
    octant = (middles > 0.0) @ np.array([4, 2, 1])
    left, top, _, _ = quads.rectangles.T
    rank = np.empty(len(quads), np.int64)
    rank[np.lexsort((left, top, octant, exponents, quads.masked, sector))] = np.arange(len(quads))

    order = np.argsort(rank[quads.owners], kind="stable")
    rows, corners = _by_first_use(quads.faces[order])
    owners = quads.owners[order]
    size = np.array(quads.atlas.shape[1::-1])
    uvs = np.column_stack([quads.uvs[rows, 0], 1.0 - quads.uvs[rows, 1].astype(np.float64)])
    uv_exponent = math.floor(math.log2(2.0 * UV_ERROR_TEXELS / size.max()))
    uv_steps = np.rint(np.ldexp(uvs, -uv_exponent)).astype(np.int64)
    chosen = exponents[owner[rows]]
    steps = np.rint(np.ldexp(points[rows], -chosen[:, None])).astype(np.int64)
    return Packed(
        steps=steps,
        exponents=chosen,
        uv_steps=uv_steps,
        uv_exponents=np.full(len(rows), uv_exponent),
        sectors=_divide(corners, sector[owners], quads.masked[owners]),
        error_px=seen_error(points[rows], np.ldexp(steps, chosen[:, None]), reach),
        uv_error=float(np.abs((np.ldexp(uv_steps, uv_exponent) - uvs) * size).max(initial=0.0)),
    )


def seen_error(points: Floats, shown: Floats, reach: float) -> float:
    """Return the greatest angle, in pixels of 1/20 degree, between points and where they are shown, relative to O.

    No user U within `reach` (R) of O sees P and P′ farther apart than α with

        sin α = |(P − U) × (P′ − P)| / (|U − P| |U − P′|) ≤ (|P × (P′ − P)| + R |P′ − P|) / (m m′),

    where m = |P| − R and m′ = |P′| − R are the least distances, and sin α ≤ |P′ − P| / max(m, m′). The lesser is taken.
    """
    offsets = shown - points
    length = np.linalg.norm(offsets, axis=1)
    margins = [np.maximum(np.linalg.norm(ends, axis=1) - reach, 0.0) for ends in (points, shown)]
    moment = np.linalg.norm(np.cross(points, offsets), axis=1) + reach * length
    is_moved = length > 0.0
    with np.errstate(divide="ignore", invalid="ignore"):
        sines = np.minimum(moment / (margins[0] * margins[1]), length / np.maximum(*margins))
    return float(np.arcsin(np.minimum(sines[is_moved], 1.0)).max(initial=0.0) * _PIXELS_PER_RADIAN)


def _exponents(points: Floats, owner: Steps, count: int, reach: float, error_px: float) -> Steps:
    """Return the exponent of each quad's step: the greatest with which no corner is seen off by more than an error.

    Half a step along each axis moves a point by √3/2 steps. Corners that users may touch have the finest step that a
    float32 holds.
    """
    distances = np.linalg.norm(points, axis=1)
    margin, farthest = np.full(count, np.inf), np.zeros(count)
    np.minimum.at(margin, owner, distances - reach)
    np.maximum.at(farthest, owner, distances)
    step = np.maximum(margin, 0.0) * (2.0 / math.sqrt(3.0) * math.sin(error_px / _PIXELS_PER_RADIAN))
    finest = np.maximum(np.ldexp(farthest, -_MANTISSA_BITS), np.finfo(np.float32).tiny)
    return np.asarray(np.floor(np.log2(np.maximum(step, finest))), np.int64)


def _sectors(middles: Floats) -> Steps:
    """Return the sector of each middle point, by its azimuth about the vertical axis through O."""
    turns = np.arctan2(middles[:, 2], middles[:, 0]) / (2.0 * math.pi) + 0.5
    return np.minimum((turns * SECTORS).astype(np.int64), SECTORS - 1)


def _by_first_use(faces: NDArray[np.uint32]) -> tuple[Steps, Steps]:
    """Return the vertices in the order in which faces use them first, and the faces with numbers in this order."""
    vertices, first, numbers = np.unique(faces.ravel(), return_index=True, return_inverse=True)
    order = np.argsort(first)
    ranks = np.empty(len(order), np.int64)
    ranks[order] = np.arange(len(order))
    return vertices[order].astype(np.int64), ranks[numbers].reshape(-1, 3)


def _divide(corners: Steps, sector: Steps, masked: NDArray[np.bool_]) -> tuple[Sector, ...]:
    """Divide faces in the order of sectors, opaque ones first, and their vertices."""
    sectors = []
    for number in np.unique(sector):
        own = sector == number
        start, end = int(corners[own].min()), int(corners[own].max()) + 1
        opaque, cut = ((corners[own & part] - start).astype(np.uint32) for part in (~masked, masked))
        sectors.append(Sector(slice(start, end), opaque, cut))
    return tuple(sectors)
