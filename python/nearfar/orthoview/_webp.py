"""Encodes and decodes colours of views as WebP, lossless or lossy."""

from __future__ import annotations

import io
import warnings
from typing import Any

import numpy as np
from numpy.typing import NDArray


def encode(picture: NDArray[np.uint8], quality: int | None = None, filled: NDArray[np.bool_] | None = None) -> bytes:
    """Encode the colours of a view, sRGB (size, size, 3).

    `quality` is 0 to 100, or None for a lossless file, which decodes to the same picture. `filled` is the mask (size,
    size) of non-empty pixels; by default all. In a lossy file empty pixels take colours from their surroundings: black
    ones would darken neighbouring pixels, and edges take bytes. Readers recognise empty pixels by their depth, 0.
    """
    from PIL import Image

    if quality is not None and filled is not None and filled.any():
        picture = np.rint(_spread(picture.astype(np.float32), filled)).astype(np.uint8)
    settings: dict[str, Any] = {"lossless": True} if quality is None else {"quality": quality}
    file = io.BytesIO()
    Image.fromarray(picture).save(file, "webp", method=4, **settings)
    return file.getvalue()


def _spread(colors: NDArray[np.float32], filled: NDArray[np.bool_]) -> NDArray[np.float32]:
    """Fill empty pixels with the mean colour of the smallest block of 2ᵏ × 2ᵏ pixels around them that is not empty."""
    if filled.all():
        return colors
    size = len(filled)
    if size % 2:
        return np.where(filled[..., None], colors, colors[filled].mean(axis=0))
    block_count = size // 2
    counts = filled.reshape(block_count, 2, block_count, 2).sum(axis=(1, 3), dtype=np.float32)
    totals = (colors * filled[..., None]).reshape(block_count, 2, block_count, 2, 3).sum(axis=(1, 3))
    blocks = _spread(totals / np.maximum(counts, 1)[..., None], counts > 0)
    return np.where(filled[..., None], colors, blocks.repeat(2, axis=0).repeat(2, axis=1))


def decode(data: bytes, size: int) -> NDArray[np.uint8]:
    """Decode the colours (size, size, 3) of a view; ValueError for other bytes or a picture of another size."""
    from PIL import Image, UnidentifiedImageError

    try:
        with warnings.catch_warnings():
            # The size is checked before anything is decoded.
            warnings.simplefilter("ignore", Image.DecompressionBombWarning)
            image = Image.open(io.BytesIO(data), formats=["webp"])
        with image:
            if image.size != (size, size):
                raise ValueError(f"expected a picture of {size} × {size} pixels, got {image.size}")
            return np.array(image.convert("RGB"))
    except UnidentifiedImageError:
        raise ValueError("expected a WebP picture, got something else") from None
    except (OSError, SyntaxError, Image.DecompressionBombError) as error:
        raise ValueError(f"expected a WebP picture, got {error}") from None
