"""Discontinuity of a picture: how far it tears neighbours in the truth apart. Boundary of the near part."""

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
    this picture) / (distance in the truth), minus 1. ValueError and TypeError for frames without positions, a
    `truth_camera` of another size, and arguments out of range. Source: Popescu, Lee, Choi, Fahmy (2022), Eq. 5–6.

    Parameters
    ----------
    frame
        Frame with `position`, the unmorphed scene point of each pixel. Far pixels of a reduced scene have it if the
        map was baked with range.
    truth_camera
        View of the true picture, by default the frame's camera. It has the frame's size in pixels, because distances in
        pixels of both pictures are compared.
    epsilon
        Radius ε of the neighbourhood in pixels of the truth, from 10⁻⁶ to 10,000. Time grows with its square.
    min_distance
        Least distance in the truth, in pixels: its resolution. Smaller distances are replaced by it.

    Returns
    -------
    NDArray
        (H, W) float32: 0 for no tear, 1 if neighbours are twice as far apart, negative if they are closer together. NaN
        for pixels without a surface, behind the truth's camera, more than 10⁷ pixels outside its picture, or without
        neighbours. For the truth itself it is 0 up to the rounding of positions.
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


def truth_view(frame_camera: Camera, truth: Camera | None) -> Camera:
    """Return the truth's camera, by default the frame's; TypeError or ValueError for a camera of another size."""
    if truth is None:
        return frame_camera
    if (size := check.instance("truth_camera", truth, Camera).size) != frame_camera.size:
        expected, got = ("{} × {}".format(*pixels) for pixels in (frame_camera.size, size))
        raise ValueError(f"truth_camera: expected {expected} pixels, as the frame has, got {got}")
    return truth


def boundary_mask(
    frame: Frame, *, center: ArrayLike, radius: float, width: int = 2, surfaces: bool = False
) -> NDArray[np.bool_]:
    """Find the pixels along the boundary of a picture's near part.

    Near pixels show points at a horizontal distance ρ ≤ `radius` from the axis through the centre. The boundary is
    between a near pixel with ρ ≥ 0.98 `radius` and a neighbour with ρ > `radius`; the lower limit excludes silhouettes
    of nearer objects. Returns (H, W) bool, true along the boundary. ValueError and TypeError for frames without
    positions and arguments out of range.

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
        True limits the boundary to surfaces that cross the radius: the neighbour must have ρ ≤ 1.02 `radius`, too. This
        excludes silhouettes of objects that end at the radius in front of much farther objects, which every picture
        with one map shifts.
    """
    check.instance("frame", frame, Frame)
    axis, end = check.vector("center", center), check.positive("radius", radius)
    grow = check.integer("width", width, 1, 1000)
    frame.require("position")
    farthest = 1.02 * end if check.flag("surfaces", surfaces) else np.inf
    return background.run(lambda: _edge(distances(frame, axis), end, farthest, grow))


def distances(frame: Frame, center: tuple[float, float, float]) -> NDArray[np.float64]:
    """Return the horizontal distances (H, W) of a frame's positions from the vertical axis through a centre, metres."""
    offsets = frame.require("position").astype(np.float64) + np.array(frame.origin) - np.array(center)
    return np.asarray(np.hypot(offsets[..., 0], offsets[..., 2]))


def _edge(rho: NDArray[np.float64], end: float, farthest: float, grow: int) -> NDArray[np.bool_]:
    """Find pixels within `grow` pixels of near pixels (ρ ≤ `end`) that adjoin a far pixel."""
    is_far = (rho > end) & (rho <= farthest)
    edge = np.zeros(is_far.shape, bool)
    for first, second in ((np.s_[:-1], np.s_[1:]), (np.s_[:, :-1], np.s_[:, 1:])):
        for near, far in ((first, second), (second, first)):
            edge[near] |= (rho[near] <= end) & (rho[near] >= 0.98 * end) & is_far[far]
    for _ in range(grow):
        grown = edge.copy()
        grown[1:] |= edge[:-1]
        grown[:-1] |= edge[1:]
        grown[:, 1:] |= edge[:, :-1]
        grown[:, :-1] |= edge[:, 1:]
        edge = grown
    return edge
