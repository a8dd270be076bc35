"""Discontinuity of a picture (distances between points that are neighbours in the truth), and near-part boundaries."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import background, check, progress
from nearfar._camera.camera import Camera
from nearfar._render.frame import Frame

EPSILON = 17.0
"""Radius of a neighbourhood in pixels of the truth, as published (Popescu, Lee, Choi, Fahmy 2022, Eq. 5–6)."""


def discontinuity(
    frame: Frame, truth_camera: Camera | None = None, *, epsilon: float = EPSILON, min_distance: float = 1.0
) -> NDArray[np.float32]:
    """Measure for each pixel how far its neighbours in the true picture are torn apart in this picture.

    Each pixel's scene point is projected to the true picture. The neighbours of a pixel are the pixels whose points
    project within ε (`epsilon`) of its own. Its discontinuity is the mean over the neighbours of the ratio (distance in
    this picture) / (distance in the truth), minus 1.

    Parameters
    ----------
    frame
        Frame with `position`, the unmorphed scene point of each pixel. Far pixels of a reduced scene have it if the
        map was baked with range.
    truth_camera
        View of the true picture, of the frame's size in pixels, because distances in pixels of both are compared; by
        default the frame's camera.
    epsilon
        Radius ε of the neighbourhood in pixels of the truth, from 10⁻⁶ to 10,000. Time grows with its square.
    min_distance
        Least distance in the truth in pixels, its resolution; smaller distances are raised to it.

    Returns
    -------
    NDArray
        (H, W) float32: 0 for no tear, 1 if neighbours are twice as far apart, negative if they are closer together. NaN
        for pixels without a surface, behind the truth's camera, more than 10⁷ pixels outside its picture, or without
        neighbours. For the truth itself it is 0 up to the rounding of positions.

    Raises
    ------
    ValueError, TypeError
        Frames without positions, a `truth_camera` of another size, and arguments out of range.

    References
    ----------
    Popescu, Lee, Choi, Fahmy (2022), Eq. 5–6.
    """
    check.instance("frame", frame, Frame)
    camera = truth_view(frame.camera, truth_camera)
    position = np.ascontiguousarray(frame.require("position"), np.float32)
    with progress.bar("measuring discontinuity") as report:
        flat = _core.discontinuity(
            position,
            origin=frame.origin,
            camera=camera._core,
            epsilon=check.positive("epsilon", epsilon),
            min_distance=check.positive("min_distance", min_distance),
            report=report,
        )
    return flat.reshape(position.shape[:2])


def truth_view(own: Camera, truth: Camera | None) -> Camera:
    """Return the truth's camera, by default a frame's own; TypeError or ValueError for one of another size."""
    if truth is None:
        return own
    (width, height), expected = check.instance("truth_camera", truth, Camera).size, own.size
    if (width, height) != expected:
        raise ValueError(
            f"truth_camera: expected {expected[0]} × {expected[1]} pixels, as the frame has, got {width} × {height}"
        )
    return truth


def boundary_mask(
    frame: Frame, *, center: ArrayLike, radius: float, width: int = 2, surfaces: bool = False
) -> NDArray[np.bool_]:
    """Find the pixels along the boundary of a picture's near part.

    Near pixels show points at a horizontal distance ρ ≤ `radius` from the axis through the centre. The boundary is
    between a near pixel with ρ ≥ 0.98 `radius` and a neighbour with ρ > `radius`; the lower limit excludes silhouettes
    of nearer objects.

    Parameters
    ----------
    frame
        Frame with `position`.
    center
        World position O, metres.
    radius
        Radius at which the near part ends, metres: r2 of the reduction.
    width
        Number of pixels on each side of the outermost near pixels that belong to the boundary, 1 to 1000.
    surfaces
        True limits the boundary to surfaces that cross the radius: the neighbour has ρ ≤ 1.02 `radius`, too. This
        excludes silhouettes of objects that end at the radius in front of much farther ones, which every picture with
        one map shifts.

    Returns
    -------
    NDArray
        (H, W) bool, true along the boundary.

    Raises
    ------
    ValueError, TypeError
        Frames without positions and arguments out of range.
    """
    check.instance("frame", frame, Frame)
    middle, end = np.array(check.vector("center", center)), check.positive("radius", radius)
    reach = check.integer("width", width, 1, 1000)
    position, origin = frame.require("position"), np.array(frame.origin)
    farthest = 1.02 * end if check.flag("surfaces", surfaces) else np.inf
    return background.run(lambda: _edge(position, origin, middle, end, farthest, reach))


def _edge(
    position: NDArray[np.float32],
    origin: NDArray[np.float64],
    middle: NDArray[np.float64],
    end: float,
    farthest: float,
    reach: int,
) -> NDArray[np.bool_]:
    """Pixels within `reach` of the outermost near ones, which are within `end` of the axis beside a pixel beyond it."""
    away = position.astype(np.float64) + origin - middle
    rho = np.hypot(away[..., 0], away[..., 2])
    beyond = (rho > end) & (rho <= farthest)
    edge = np.zeros(beyond.shape, bool)
    for axis in (0, 1):
        first = (slice(None),) * axis + (slice(None, -1),)
        second = (slice(None),) * axis + (slice(1, None),)
        for one, other in ((first, second), (second, first)):
            edge[one] |= (rho[one] <= end) & (rho[one] >= 0.98 * end) & beyond[other]
    for _ in range(reach):
        grown = edge.copy()
        grown[1:] |= edge[:-1]
        grown[:-1] |= edge[1:]
        grown[:, 1:] |= edge[:, :-1]
        grown[:, :-1] |= edge[:, 1:]
        edge = grown
    return edge
