"""Encodes and decodes colours of views as WebP, lossless or lossy."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nearfar._base import webp


def encode(picture: NDArray[np.uint8], quality: int | None = None, filled: NDArray[np.bool_] | None = None) -> bytes:
    """Encode the colours of a view, sRGB (size, size, 3).

    `quality` is 0 to 100, or None for a lossless file, which decodes to the same picture. `filled` is the mask (size,
    size) of non-empty pixels; by default all. In a lossy file empty pixels take colours from their surroundings: black
    ones would darken neighbouring pixels, and edges take bytes. Readers recognise empty pixels by their depth, 0.
    """
    if quality is not None and filled is not None and filled.any():
        picture = np.rint(webp.fill_unknown(picture[None].astype(np.float32), filled[None])[0]).astype(np.uint8)
    return webp.encode(picture, quality)


def decode(data: bytes, size: int) -> NDArray[np.uint8]:
    """Decode the colours (size, size, 3) of a view; ValueError for other bytes or a picture of another size."""
    return webp.decode(data, (size, size))
