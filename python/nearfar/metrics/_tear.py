"""Tears of a picture: residuals after the best affine fit to each pixel's neighbourhood in the truth."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check, progress
from nearfar._camera.camera import Camera, Fov
from nearfar._render.frame import Frame
from nearfar.metrics._discontinuity import boundary_mask, distances, truth_view

EPSILON = 4.0
"""Radius of a neighbourhood in pixels of the truth."""
EPSILONS = (1e-6, 10_000.0)
"""Least and greatest radius; time grows with its square."""


def tear(frame: Frame, truth_camera: Camera | None = None, *, epsilon: float = EPSILON) -> NDArray[np.float32]:
    """Measure for each pixel by how many pixels its neighbours in the true picture are torn apart in this picture.

    Each pixel's scene point is projected to the true picture. The pixels whose points project within ε (`epsilon`) of a
    pixel's own, and the pixel itself, are its neighbourhood. The best affine map from positions in the truth to
    positions in this picture accounts for translation, scale, rotation and shear. The tear is the root mean square of
    the residual distances, divided by 0.264, the residual of a disc that is torn by one pixel. ValueError and TypeError
    for frames without positions, a `truth_camera` of another size, and arguments out of range. The published measure,
    `discontinuity`, counts shear, too.

    Parameters
    ----------
    frame, truth_camera
        As in `discontinuity`.
    epsilon
        Radius ε of the neighbourhood in pixels of the truth, from 10⁻⁶ to 10,000. Time grows with its square.

    Returns
    -------
    NDArray
        (H, W) float32, pixels of this picture: 0 for a neighbourhood that is only moved, scaled or sheared, T for one
        torn by T pixels along a line through its middle. A bend, where the slope changes by s, has the value s ε / 2 at
        any resolution, while the value of a tear grows with the resolution. NaN for pixels without a surface, behind
        the truth's camera, more than 10⁷ pixels outside its picture, or without neighbours.
    """
    check.instance("frame", frame, Frame)
    radius = check.in_range("epsilon", epsilon, *EPSILONS)
    return _tears(frame, truth_view(frame.camera, truth_camera), radius)[0]


@dataclass(frozen=True, kw_only=True)
class BoundaryTear:
    """Tear of a picture along the boundary of its near part; from `boundary_tear`. Means over no pixels are None."""

    pixels: int
    """Number of pixels along the boundary that have neighbours."""
    shared: float | None
    """Share of these pixels whose neighbourhood lies on both sides; a tear is hidden where one side hides the other."""
    tear: float | None
    """Mean tear in pixels, over the boundary pixels whose neighbourhood lies on both sides."""
    kink: float | None
    """Mean over the same pixels of the tear's part due to a change of slope; in pixels, equal at any resolution."""
    pixels_per_degree: float | None
    """Resolution of the picture on the camera's axis, pixels per degree; None for an orthographic view."""


def boundary_tear(
    frame: Frame, *, center: ArrayLike, radius: float, epsilon: float = EPSILON, surfaces: bool = False
) -> BoundaryTear:
    """Measure the tear of a picture of a reduced scene along the boundary of its near part.

    Compare tears at the resolution of a headset, some 20 pixels per degree: at a lower one the change of slope that
    every morph has at its radii counts as much as the tear itself. Arguments are as in `boundary_mask`, `epsilon`
    as in `tear`, up to 5,000. ValueError and TypeError for frames without positions and arguments out of range.

    Means are over the pixels of `boundary_mask` whose neighbourhood within ε lies on both sides of `radius`. Let T be
    the tear for ε, and T₂ the tear for 2 ε. The kink is √((T₂² − T²) / 3), at most T: doubling ε doubles the value of a
    kink, but not of a real tear.
    """
    edge = boundary_mask(frame, center=center, radius=radius, surfaces=surfaces)
    epsilon = check.in_range("epsilon", epsilon, EPSILONS[0], EPSILONS[1] / 2)
    is_far = distances(frame, check.vector("center", center)) > check.positive("radius", radius)
    torn, is_two_sided = _tears(frame, frame.camera, epsilon, side=is_far, mask=edge)
    defined = edge & ~np.isnan(torn)
    counted = defined & is_two_sided
    torn_wide, _ = _tears(frame, frame.camera, 2.0 * epsilon, mask=counted)
    tears, wide_tears = (values[counted].astype(np.float64) for values in (torn, torn_wide))
    kink = np.minimum(np.sqrt(np.maximum(wide_tears**2 - tears**2, 0.0) / 3.0), tears)
    fov = frame.camera.fov
    return BoundaryTear(
        pixels=int(defined.sum()),
        shared=float(counted.sum() / defined.sum()) if defined.any() else None,
        tear=float(torn[counted].mean()) if counted.any() else None,
        kink=float(kink.mean()) if counted.any() else None,
        pixels_per_degree=(
            float(np.radians(frame.camera.size[0] / (fov.right - fov.left))) if isinstance(fov, Fov) else None
        ),
    )


def _tears(
    frame: Frame, truth: Camera, epsilon: float, *, side: NDArray[np.bool_] | None = None,
    mask: NDArray[np.bool_] | None = None,
) -> tuple[NDArray[np.float32], NDArray[np.bool_]]:  # fmt: skip
    """Return tears (H, W) and, if `side` is each pixel's side of a border, whether its neighbourhood has both sides."""
    position = np.ascontiguousarray(frame.require("position"), np.float32)
    with progress.bar("measuring tears") as report:
        torn, is_two_sided = _core.tear(
            position,
            origin=frame.origin,
            camera=truth._core,
            epsilon=epsilon,
            side=None if side is None else side.reshape(-1),
            mask=None if mask is None else mask.reshape(-1),
            report=report,
        )
    shape = position.shape[:2]
    return torn.reshape(shape), is_two_sided if side is None else is_two_sided.reshape(shape)
