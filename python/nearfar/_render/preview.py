"""Pictures of a frame's images for display: 8-bit colours of ranges, numbers, normals and positions."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar import _core

CAPTIONS = {
    "color": "colour",
    "albedo": "colour of the materials",
    "shading_normal": "normals used for shading",
    "normal": "normals as colours",
    "range": "range, near is bright",
    "object_id": "objects as colours",
    "face_id": "triangles as colours",
    "coverage": "share of samples that show a triangle",
    "motion": "motion: to the right is red, down is green",
    "position": "height above the lowest point, high is bright",
}
"""Captions of the pictures of a frame's images, most informative first."""


def pixels(name: str, image: NDArray[Any]) -> NDArray[np.uint8]:
    """Convert one image of a frame, (H, W) or (H, W, 3), to sRGB (H, W, 3); pixels that hit nothing are dark grey."""
    if name in ("color", "albedo"):
        color = np.ascontiguousarray(np.nan_to_num(image), np.float32)
        codes = _core.encode_srgb(color).reshape(color.shape)
        return codes if name == "color" else np.where(np.isfinite(image), codes, np.uint8(48))
    if name == "coverage":
        is_hit, shade = image > 0.0, np.repeat(image[..., None], 3, axis=-1)
    elif name == "motion":
        is_hit, shade = np.isfinite(image).all(axis=-1), _motion_colors(image)
    elif name in ("normal", "shading_normal"):
        is_hit, shade = np.isfinite(image).all(axis=-1), 0.5 + 0.5 * np.nan_to_num(image)
    elif name in ("object_id", "face_id"):
        # Multiples of three irrational steps give adjacent numbers very different colours.
        steps = np.array([0.6180339887, 0.7548776662, 0.5698402909])
        is_hit, shade = image >= 0, 0.25 + 0.7 * np.mod((image[..., None] + 1.0) * steps, 1.0)
    else:
        is_hit, shade = _shades(image[..., 1] if name == "position" else np.log(np.maximum(image, 1e-6)))
        shade = np.repeat((shade if name == "position" else 1.1 - shade)[..., None], 3, axis=-1)
    picture = np.full((*is_hit.shape, 3), 48, np.uint8)
    picture[is_hit] = np.clip(255.0 * shade[is_hit], 0.0, 255.0).astype(np.uint8)
    return picture


def _motion_colors(image: NDArray[Any]) -> NDArray[Any]:
    """Convert motion components to red and green: grey is no motion, the fastest 1 % are saturated."""
    values = np.nan_to_num(image)
    scale = max(float(np.percentile(np.abs(values), 99.0)), 1e-6)
    shade = 0.5 + 0.5 * np.clip(values / scale, -1.0, 1.0)
    return np.concatenate([shade, np.full((*shade.shape[:2], 1), 0.5)], axis=-1)


def _shades(values: NDArray[Any]) -> tuple[NDArray[np.bool_], NDArray[Any]]:
    """Return a mask of finite values, and the values scaled so that their 1st and 99th percentile become 0.1 and 1."""
    is_finite = np.isfinite(values)
    if not is_finite.any():
        return is_finite, np.zeros(values.shape)
    low, high = np.percentile(values[is_finite], [1.0, 99.0])
    scaled = np.where(is_finite, values, low) - low
    return is_finite, 0.1 + 0.9 * np.clip(scaled / max(float(high - low), 1e-12), 0.0, 1.0)
