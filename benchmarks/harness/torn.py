"""Pictures with a known tear: halves that are pulled apart, slide along each other or overlap, sheared and curved."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

import nearfar as nf

Array = NDArray[np.float64]

WIDE = nf.Camera((3, 2, 1), fov=nf.Fov.symmetric(90), size=(160, 160))
MIDDLE = 80.2
"""Position of the line, which runs between pixel centres at any angle."""
KINDS = ("opening", "sliding", "overlap")
"""Names of the motions of both halves."""


def pixels(view: nf.Camera = WIDE) -> Array:
    """Middles of the picture's pixels (H, W, 2)."""
    return np.stack(np.meshgrid(np.arange(view.width) + 0.5, np.arange(view.height) + 0.5), axis=-1)


def picture(truth: Array, view: nf.Camera = WIDE) -> nf.Frame:
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
    across = np.array([np.cos(direction), np.sin(direction)])
    along = np.array([-across[1], across[0]])
    offset = pixels() - MIDDLE
    away = offset @ across
    side = np.sign(away)
    if kind == "sliding":
        back = offset - (side * tear / 2.0)[..., None] * along
    else:
        back = offset - (side * (tear / 2.0 if kind == "opening" else -tear / 2.0))[..., None] * across
    if curvature:
        # The inverse of x + c x², for |c x| small.
        x = back @ across
        flat = 2.0 * x / (1.0 + np.sqrt(np.maximum(1.0 + 4.0 * curvature * x, 1e-3)))
        back += (flat - x)[..., None] * across
    back[..., 0] -= shear * back[..., 1]
    if kind == "opening":
        back[np.abs(away) < tear / 2.0] = np.nan
    return picture(back + MIDDLE)


def at_the_line(found: NDArray[np.float32], tear: float, direction: float, *, kind: str = "opening") -> Array:
    """Values of the pixels along the line, away from the picture's edges."""
    offset = pixels() - MIDDLE
    apart = tear / 2.0 if kind == "opening" else 0.0
    away = np.abs(offset @ (np.cos(direction), np.sin(direction))) - apart
    beside = (np.abs(away) < 1) & (np.linalg.norm(offset, axis=-1) < 40) & ~np.isnan(found)
    return np.asarray(found[beside], np.float64)
