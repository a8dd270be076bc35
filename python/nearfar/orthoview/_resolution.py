"""Computes the size of views that a display needs."""

from __future__ import annotations

import math
from typing import SupportsFloat, SupportsIndex

from nearfar._base import check
from nearfar.orthoview._grid import directions_of, widest

_MAX = 4096
"""Greatest size of a view."""

_ROUNDING = 1e-12
"""Relative rounding error allowed before a whole number is rounded up."""


def size_for(
    pixels: SupportsIndex,
    *,
    cell: SupportsFloat,
    distance: SupportsFloat,
    fov: SupportsFloat,
    angle: SupportsFloat = 0.0,
    directions: SupportsIndex = 9,
) -> int:
    """Return the size of views whose pixels are as fine as a display's.

    Parameters
    ----------
    pixels
        Width of the display, p.
    cell
        Side of a leaf, s, metres.
    distance
        Distance beyond which views replace geometry, r, metres.
    fov
        Horizontal field of view, α, radians, between 0 and π.
    angle
        Angle between a surface's normal and the view, θ, radians, at least 0 and below π/2: a view shows a surface
        tilted by θ with fewer pixels.
    directions
        As in `nearfar.orthoview.build`. The widest view of a cell is w sides wide: w = 1 for 5, √2 for 9, 1.633 for
        13 and 26.

    Returns
    -------
    int
        Least multiple of 4 that is at least q = p/cos θ · w s/(2 r tan(α/2)).

    Raises
    ------
    ValueError
        Values out of range, or a size above 4096 pixels.
    TypeError
        Values that are not numbers.

    Notes
    -----
    Chaudhuri et al., section 4.1, who take w = 1. At the distance r a display's pixel is 2 r tan(α/2)/p wide; the
    largest side of a view's pixel is w s/q.
    """
    width = check.integer("pixels", pixels, 1, 1 << 20)
    side, least_distance = check.positive("cell", cell), check.positive("distance", distance)
    field_of_view, tilt = check.number("fov", fov), check.number("angle", angle)
    if not 0 < field_of_view < math.pi:
        raise ValueError(f"fov: expected radians between 0 and π, got {field_of_view:g}")
    if not 0 <= tilt < math.pi / 2:
        raise ValueError(f"angle: expected radians from 0 to below π/2, got {tilt:g}")
    widest_view = widest(directions_of(directions))
    visible_width = 2 * least_distance * math.tan(field_of_view / 2) * math.cos(tilt)
    if not width * widest_view * side <= _MAX * visible_width:
        values = f"{width}, {side:g}, {least_distance:g}, {field_of_view:g}, {tilt:g}"
        raise ValueError(
            f"pixels, cell, distance, fov, angle: expected values for which {_MAX} pixels are enough, got {values}"
        )
    return max(4, 4 * math.ceil(width * widest_view * side / visible_width / 4 * (1 - _ROUNDING)))
