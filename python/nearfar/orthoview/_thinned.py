"""Finds duplicates: pixels of a view whose surface another view of the same cell shows better.

A pixel's *fineness* is the number of pixels per square metre of its surface. A surfel is a duplicate if the four pixels
of another view around its place are all surfels of the same plane and finer, or equally fine and of an earlier view.
So two pixels are never duplicates of each other, and a duplicate always lies between better pixels. A ball is a
duplicate if another view shows a surfel at its place, or an earlier view a ball.

Gaussians have no back side. If the two sides of a surface are closer than the pixel size, one shows through the other.
Therefore floors keep only their upper side, and walls the side that more views show. So the ground has no lower side,
and the interiors of houses that a cell's side cuts open do not show through their outer walls.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar.orthoview._gaussians import Floats, Surfaces

Integers = NDArray[np.int64]

MAX_PLANE_DISTANCE = 0.5
"""Greatest distance between two surfels' planes, in pixels."""

MIN_COSINE = 0.7
"""Least cosine between the normals of surfels of one surface, as of connected pixels."""

FLOOR_COSINE = 0.5
"""Least y component of a unit normal (either sign) at which a surface is a floor."""

_FINENESS_TOLERANCE = np.float32(1e-4)
"""Relative tolerance for rounding errors of fineness."""


@dataclass(frozen=True, eq=False)
class Picture:
    """A view of a cell: arrays (size, size) of its pixels."""

    axes: Floats
    """Rows (3, 3): right, up, towards the viewer."""
    extents: tuple[float, float, float]
    """Width and height of the picture and range of depths, metres."""
    depth: Floats
    """Metres behind the front; NaN for empty pixels."""
    normal: Floats
    """Unit normals towards the viewer, world axes (size, size, 3)."""
    color: NDArray[np.uint8]
    is_surfel: NDArray[np.bool_]
    fineness: Floats
    """Pixels per square metre of surface; 0 for balls, −1 for empty pixels."""

    @classmethod
    def from_views(
        cls,
        views: _core.OrthoViews,
        bits: NDArray[np.uint8],
        axes: NDArray[np.float64],
        extents: NDArray[np.float64],
        steps: int,
    ) -> Picture:
        """Convert the first view; `bits` are the connections of its pixels."""
        width, height, depth = extents.tolist()
        codes, rows = views.depths()[0, ..., 0], axes.astype(np.float32)
        is_shown = codes > 0
        behind = np.where(is_shown, (codes.astype(np.float32) - 0.5) * np.float32(depth / steps), np.float32(np.nan))
        normal = np.where(is_shown[..., None], views.vectors()[0], np.float32(0.0))
        is_surfel = _core.orthoview_surfels(bits)[0, ..., 0] & is_shown
        pixel = width * height / codes.size
        fineness = np.where(is_surfel, np.maximum(normal @ rows[2], 1e-3) / np.float32(pixel), np.float32(0.0))
        return cls(
            rows,
            (width, height, depth),
            behind,
            normal,
            views.colors()[0],
            is_surfel,
            np.where(is_shown, fineness, np.float32(-1.0)),
        )

    @property
    def pitch(self) -> tuple[float, float]:
        """Width and height of a pixel, metres."""
        size = len(self.depth)
        return self.extents[0] / size, self.extents[1] / size

    def surfaces(self) -> Surfaces:
        """Non-empty pixels, row by row."""
        row, column = np.nonzero(self.fineness >= 0.0)
        (width, height), half_extents = self.pitch, np.array(self.extents, np.float32) / 2
        position = np.stack(
            [
                (column + np.float32(0.5)) * np.float32(width) - half_extents[0],
                half_extents[1] - (row + np.float32(0.5)) * np.float32(height),
                half_extents[2] - self.depth[row, column],
            ],
            axis=1,
        )
        return Surfaces(
            (position @ self.axes).astype(np.float32),
            self.normal[row, column],
            self.color[row, column],
            self.is_surfel[row, column],
        )


def is_duplicate(pictures: list[Picture], number: int, rows: NDArray[np.int64]) -> NDArray[np.bool_]:
    """Whether pixels of picture `number` are duplicates of other pictures' pixels, or back sides.

    `rows` are indices of the pixels in `surfaces()` of the picture.
    """
    picture_of_rows = pictures[number]
    surfaces = picture_of_rows.surfaces()
    fineness = picture_of_rows.fineness[picture_of_rows.fineness >= 0.0]
    remaining = rows
    for other, picture in enumerate(pictures):
        if other == number or not len(remaining):
            continue
        balls = remaining[~surfaces.is_surfel[remaining]]
        surfels = remaining[surfaces.is_surfel[remaining]]
        # Fineness that a surfel of the other view with this normal would have.
        pixel = np.float32(picture.pitch[0] * picture.pitch[1])
        possible_fineness = (surfaces.normal[surfels] @ picture.axes[2]) / pixel
        surfels = surfels[possible_fineness >= fineness[surfels] * (1 - _FINENESS_TOLERANCE)]
        middle, normal, is_before = surfaces.middle, surfaces.normal, other < number
        same_surfel = _same_surfel(picture, middle[surfels], normal[surfels], fineness[surfels], is_before)
        same_ball = _same_ball(picture, middle[balls], picture_of_rows, is_before)
        duplicates = np.concatenate([surfels[same_surfel], balls[same_ball]])
        remaining = np.setdiff1d(remaining, duplicates, assume_unique=True)
    surfels = remaining[surfaces.is_surfel[remaining]]
    backs = surfels[_is_back(pictures, number, surfaces.middle[surfels], surfaces.normal[surfels])]
    return ~np.isin(rows, np.setdiff1d(remaining, backs, assume_unique=True), assume_unique=True)


def _is_back(pictures: list[Picture], number: int, middle: Floats, normal: Floats) -> NDArray[np.bool_]:
    """Whether surfels (N,) of a picture are on the side of a thin surface that is left out."""
    others = [picture for other, picture in enumerate(pictures) if other != number]
    behind = np.zeros(len(middle), np.int32)
    for picture in others:
        behind += _has_plane(picture, middle, -normal)
    thin = np.flatnonzero(behind)
    same_side = np.ones(len(thin), np.int32)  # their own picture shows this side
    for picture in others:
        same_side += _has_plane(picture, middle[thin], normal[thin])
    up = normal[thin, 1]
    is_back = np.zeros(len(middle), bool)
    is_back[thin] = np.where(np.abs(up) > FLOOR_COSINE, up < 0, behind[thin] > same_side)
    return is_back


def _has_plane(picture: Picture, middle: Floats, normal: Floats) -> NDArray[np.bool_]:
    """Whether a picture's pixels at points (N, 3) are surfels of planes through the points with the given normals."""
    has = np.zeros(len(middle), bool)
    index = np.flatnonzero(normal @ picture.axes[2] > 0)
    column, row, depth, is_inside = _project(picture, middle[index])
    index, column, row, depth = index[is_inside], column[is_inside], row[is_inside], depth[is_inside]
    c, r = column.astype(np.int64), row.astype(np.int64)
    reach = np.float32(MAX_PLANE_DISTANCE * max(picture.pitch))
    # On a plane tilted by 75.5°, depths of points that are a pixel and `reach` apart differ by 4.8 pixels.
    is_match = picture.is_surfel[r, c] & (np.abs(depth - picture.depth[r, c]) <= 10 * reach)
    index, column, row, depth, c, r = (values[is_match] for values in (index, column, row, depth, c, r))
    is_match = np.einsum("ni,ni->n", picture.normal[r, c], normal[index]) >= MIN_COSINE
    is_match &= _off_plane(picture, (c, column), (r, row), depth) <= reach
    has[index[is_match]] = True
    return has


def _project(picture: Picture, middle: Floats) -> tuple[Floats, Floats, Floats, NDArray[np.bool_]]:
    """Project points into a picture: columns and rows in pixels, depths in metres, and whether they are in it."""
    width, height, depth = picture.extents
    size = np.float32(len(picture.depth))
    right, up, toward = (middle @ picture.axes.T).T
    column = (right / np.float32(width) + np.float32(0.5)) * size
    row = (np.float32(0.5) - up / np.float32(height)) * size
    is_inside = (column >= 0) & (column < size) & (row >= 0) & (row < size)
    return column, row, np.float32(depth / 2) - toward, is_inside


def _same_surfel(
    picture: Picture, middle: Floats, normal: Floats, fineness: Floats, is_before: bool
) -> NDArray[np.bool_]:
    """Whether surfels (N,) lie between four finer surfels of a picture that are in the same plane."""
    column, row, depth, is_same = _project(picture, middle)
    size, reach = len(picture.depth), np.float32(MAX_PLANE_DISTANCE * max(picture.pitch))
    first_column, first_row = np.floor(column - 0.5), np.floor(row - 0.5)
    for down, right in ((0, 0), (0, 1), (1, 0), (1, 1)):
        index = np.flatnonzero(is_same)
        if not len(index):
            break
        # Beyond the picture's edges the outermost pixels are repeated.
        c = np.clip(first_column[index] + right, 0, size - 1).astype(np.int64)
        r = np.clip(first_row[index] + down, 0, size - 1).astype(np.int64)
        other_fineness = picture.fineness[r, c]
        better = other_fineness >= fineness[index] if is_before else other_fineness > fineness[index]
        better &= picture.is_surfel[r, c]
        better &= np.einsum("ni,ni->n", picture.normal[r, c], normal[index]) >= MIN_COSINE
        is_same[index] = better & (_off_plane(picture, (c, column[index]), (r, row[index]), depth[index]) <= reach)
    return is_same


def _off_plane(
    picture: Picture, columns: tuple[Integers, Floats], rows: tuple[Integers, Floats], depth: Floats
) -> Floats:
    """Distances (N,) in metres of points, given by column, row and depth, from the planes of pixels (c, r)."""
    (c, column), (r, row), (width, height) = columns, rows, picture.pitch
    normal = picture.normal[r, c] @ picture.axes.T
    distance: Floats = np.abs(
        (column - c - np.float32(0.5)) * np.float32(width) * normal[:, 0]
        - (row - r - np.float32(0.5)) * np.float32(height) * normal[:, 1]
        - (depth - picture.depth[r, c]) * normal[:, 2]
    )
    return distance


def _same_ball(picture: Picture, middle: Floats, picture_of_balls: Picture, is_before: bool) -> NDArray[np.bool_]:
    """Whether balls (N,) lie where another picture shows a surfel, or an earlier picture a ball."""
    column, row, depth, is_same = _project(picture, middle)
    index = np.flatnonzero(is_same)
    c, r = column[index].astype(np.int64), row[index].astype(np.int64)
    counts = picture.fineness[r, c] >= (0.0 if is_before else np.finfo(np.float32).tiny)
    width, height = picture.pitch
    squared = (
        ((column[index] - c - np.float32(0.5)) * np.float32(width)) ** 2
        + ((row[index] - r - np.float32(0.5)) * np.float32(height)) ** 2
        + (depth[index] - picture.depth[r, c]) ** 2
    )
    radius = np.hypot(*picture_of_balls.pitch) / 2
    is_same[index] = counts & (np.nan_to_num(squared, nan=np.inf) <= radius * radius)
    return is_same
