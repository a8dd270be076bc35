"""How far a picture is broken: neighbours in the truth that are torn apart in it, and where near parts end."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check, progress
from nearfar._camera.camera import Camera
from nearfar._render.frame import Frame


def discontinuity(
    frame: Frame, truth_camera: Camera | None = None, *, epsilon: float = 17.0, min_distance: float = 1.0
) -> NDArray[np.float32]:
    """How far each pixel's neighbours in the true picture are torn apart in this one.

    A pixel's scene point has a place in the truth. The pixels whose places there are within ε of it are its neighbours,
    and its discontinuity is the mean over them of their distance in this picture over their distance in the truth,
    less 1.

    Parameters
    ----------
    frame
        With `position`: the unmorphed scene point of each pixel. Far pixels of a reduced scene have it where the
        map was baked with range.
    truth_camera
        The view that the truth would be rendered from; by default the frame's own.
    epsilon
        Pixels of the truth, from a millionth up to 10,000. Time goes with its square.
    min_distance
        Distances in the truth below this are raised to it: its resolution.

    Returns
    -------
    NDArray
        (H, W) float32: 0 where nothing is torn, 1 where neighbours are twice as far apart, negative where they
        are pushed together. NaN for pixels without a surface, behind the truth's camera, more than 10⁷ pixels
        beside its picture, or without neighbours. For the truth itself it is 0 up to the rounding of positions.

    Raises
    ------
    ValueError, TypeError
        For frames without positions and arguments out of their domains.

    References
    ----------
    Popescu, Lee, Choi, Fahmy (2022), Eq. 5–6.
    """
    if not isinstance(frame, Frame):
        raise TypeError(f"frame: expected a Frame, got {type(frame).__name__}")
    camera = frame.camera if truth_camera is None else truth_camera
    if not isinstance(camera, Camera):
        raise TypeError(f"truth_camera: expected a Camera, got {type(camera).__name__}")
    position = np.ascontiguousarray(frame.require("position"), np.float32)
    with progress.bar("measuring discontinuity") as report:
        flat = _core.discontinuity(
            position.reshape(-1, 3),
            origin=frame.origin,
            width=position.shape[1],
            camera=camera._core,
            epsilon=check.positive("epsilon", epsilon),
            min_distance=check.positive("min_distance", min_distance),
            report=report,
        )
    return flat.reshape(position.shape[:2])


def boundary(frame: Frame, *, center: ArrayLike, radius: float, width: int = 2) -> NDArray[np.bool_]:
    """Pixels along which the near part of a picture ends.

    Near pixels show points at ρ ≤ `radius` from the axis through the centre. They end at the radius, not at a
    silhouette, where a near pixel within 2 % of the radius has a neighbour that shows something beyond.

    Parameters
    ----------
    frame
        With `position`.
    center
        World position O, metres.
    radius
        Metres: r2 of the reduction.
    width
        Pixels to both sides that count as along it.

    Returns
    -------
    NDArray
        (H, W) bool.

    Raises
    ------
    ValueError, TypeError
        For frames without positions and arguments out of their domains.
    """
    if not isinstance(frame, Frame):
        raise TypeError(f"frame: expected a Frame, got {type(frame).__name__}")
    middle, end = np.array(check.vector("center", center)), check.positive("radius", radius)
    reach = check.integer("width", width, 1, 1000)
    away = frame.require("position").astype(np.float64) + np.array(frame.origin) - middle
    rho = np.hypot(away[..., 0], away[..., 2])
    beyond = rho > end
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
