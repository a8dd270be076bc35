"""Converts between sRGB and linear light, and encodes textures as files."""

from __future__ import annotations

import io
from typing import Any

import numpy as np
from numpy.typing import NDArray


def to_linear(srgb: NDArray[Any]) -> NDArray[np.float64]:
    """Decode sRGB in 0..1 (IEC 61966-2-1)."""
    linear_segment = srgb / 12.92
    power_segment = ((np.maximum(srgb, 0.04045) + 0.055) / 1.055) ** 2.4
    return np.where(srgb <= 0.04045, linear_segment, power_segment)


def to_srgb(linear: NDArray[Any]) -> NDArray[np.float64]:
    """Encode linear light in 0..1 as sRGB (IEC 61966-2-1)."""
    linear_segment = linear * 12.92
    power_segment = 1.055 * np.maximum(linear, 0.0031308) ** (1 / 2.4) - 0.055
    return np.where(linear <= 0.0031308, linear_segment, power_segment)


def encode_texture(texels: NDArray[np.uint8], quality: int | None) -> bytes:
    """Encode a texture (H, W, 4), sRGB with alpha, as WebP; `quality` 0 to 100, or None for lossless."""
    settings = {"lossless": True, "exact": True} if quality is None else {"quality": quality}
    return encode_image(texels, "webp", method=4, **settings)


def encode_image(texels: NDArray[np.uint8], kind: str, **settings: Any) -> bytes:
    """Encode texels (H, W, 4) in a format of Pillow, without alpha if all are opaque."""
    from PIL import Image

    is_opaque = bool((texels[..., 3] == 255).all())
    file = io.BytesIO()
    Image.fromarray(texels[..., :3] if is_opaque else texels).save(file, kind, **settings)
    return file.getvalue()
