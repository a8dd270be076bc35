"""Pictures with a known tear: halves that are pulled apart, slide along each other or overlap, sheared and curved."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

import nearfar as nf

Array = NDArray[np.float64]

DEFAULT_VIEW = nf.Camera((3, 2, 1), fov=nf.Fov.symmetric(90), size=(160, 160))
LINE_POSITION = 80.2
"""Position of the line, which runs between pixel centres at any angle."""
KINDS = ("opening", "sliding", "overlap")
"""Names of the motions of both halves."""


def pixels(view: nf.Camera = DEFAULT_VIEW) -> Array:
    """Middles of the picture's pixels (H, W, 2)."""
    return np.stack(np.meshgrid(np.arange(view.width) + 0.5, np.arange(view.height) + 0.5), axis=-1)


def picture(truth: Array, view: nf.Camera = DEFAULT_VIEW) -> nf.Frame:
    """Make the frame whose pixels show points at given places (H, W, 2) of the truth."""
    fov = view.fov
    assert isinstance(fov, nf.Fov)
    x = fov.left + (fov.right - fov.left) * truth[..., 0] / view.width
    y = fov.up + (fov.down - fov.up) * truth[..., 1] / view.height
    points = np.stack([x, y, -np.ones_like(x)], axis=-1) * 10.0
    return nf.Frame(view, position=points.astype(np.float32), origin=view.position)


def torn(
    tear: float, direction: float, *, kind: str = "opening", shear: float = 0.0, curvature: float = 0.0
) -> nf.Frame:
    """Make a picture that is torn along a line through its middle, with shear and curvature over all of it.

    `direction` in radians is that across the line. Halves are "opening", with nothing between them, "sliding" along
    each other, or "overlap", where one hides the other. A curvature c shows a point that is x pixels from the middle,
    across the line, at x + c x².
    """
    normal = np.array([np.cos(direction), np.sin(direction)])
    tangent = np.array([-normal[1], normal[0]])
    offset = pixels() - LINE_POSITION
    distances = offset @ normal
    side = np.sign(distances)
    if kind == "sliding":
        truth = offset - (side * tear / 2.0)[..., None] * tangent
    else:
        truth = offset - (side * (tear / 2.0 if kind == "opening" else -tear / 2.0))[..., None] * normal
    if curvature:
        # The inverse of x + c x², for |c x| small.
        x = truth @ normal
        uncurved = 2.0 * x / (1.0 + np.sqrt(np.maximum(1.0 + 4.0 * curvature * x, 1e-3)))
        truth += (uncurved - x)[..., None] * normal
    truth[..., 0] -= shear * truth[..., 1]
    if kind == "opening":
        truth[np.abs(distances) < tear / 2.0] = np.nan
    return picture(truth + LINE_POSITION)


def at_the_line(values: NDArray[np.float32], tear: float, direction: float, *, kind: str = "opening") -> Array:
    """Values of the pixels along the line, away from the picture's edges."""
    offset = pixels() - LINE_POSITION
    half_gap = tear / 2.0 if kind == "opening" else 0.0
    distances = np.abs(offset @ (np.cos(direction), np.sin(direction))) - half_gap
    beside = (np.abs(distances) < 1) & (np.linalg.norm(offset, axis=-1) < 40) & ~np.isnan(values)
    return np.asarray(values[beside], np.float64)
