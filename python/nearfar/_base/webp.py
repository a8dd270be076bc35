"""Encodes and decodes 8-bit pictures as WebP, and fills unknown pixels so that they take few bytes."""

from __future__ import annotations

import io
import warnings
from typing import Any

import numpy as np
from numpy.typing import NDArray


def encode(picture: NDArray[np.uint8], quality: int | None) -> bytes:
    """Encode a picture (H, W, 3), sRGB; `quality` 0 to 100, None for a lossless file."""
    from PIL import Image

    settings: dict[str, Any] = {"lossless": True} if quality is None else {"quality": quality}
    file = io.BytesIO()
    Image.fromarray(picture).save(file, "webp", method=4, **settings)
    return file.getvalue()


def decode(data: bytes, size: tuple[int, int]) -> NDArray[np.uint8]:
    """Decode a picture of known width and height to (H, W, 3), sRGB; ValueError for anything else."""
    from PIL import Image, UnidentifiedImageError

    try:
        with warnings.catch_warnings():
            # The header's size is checked before the pixels are decoded.
            warnings.simplefilter("ignore", Image.DecompressionBombWarning)
            image = Image.open(io.BytesIO(data), formats=["webp"])
        with image:
            if image.size != size:
                raise ValueError(f"expected a picture of {size[0]} × {size[1]} pixels, got {image.size}")
            return np.array(image.convert("RGB"))
    except UnidentifiedImageError:
        raise ValueError("expected a WebP picture, got something else") from None
    except (OSError, SyntaxError, Image.DecompressionBombError) as error:
        raise ValueError(f"expected a WebP picture, got {error}") from None


def fill_unknown(tiles: NDArray[np.float32], is_known: NDArray[np.bool_]) -> NDArray[np.float32]:
    """Replace unknown pixels of tiles (N, side, side, 3) by the mean of the smallest block around them with known ones.

    Blocks are halves, quarters and so on of a tile, as long as their sides are even; a block's mean is the mean of its
    quarters' means. Smoother fillings need more bytes in WebP.
    """
    count, side = is_known.shape[:2]
    is_partial = ~is_known.all(axis=(1, 2))
    if side == 1 or not is_partial.any():
        return tiles
    if not is_partial.all():
        result = tiles.copy()
        result[is_partial] = fill_unknown(tiles[is_partial], is_known[is_partial])
        return result
    if side % 2:
        means = np.array([tile[known].mean(axis=0) for tile, known in zip(tiles, is_known, strict=True)])
        return np.where(is_known[..., None], tiles, means[:, None, None])
    blocks = (count, side // 2, 2, side // 2, 2)
    known_counts = is_known.reshape(blocks).sum(axis=(2, 4))
    sums = np.where(is_known[..., None], tiles, 0).reshape(*blocks, 3).sum(axis=(2, 4))
    means = fill_unknown(sums / np.maximum(known_counts, 1, dtype=np.float32)[..., None], known_counts > 0)
    return np.where(is_known[..., None], tiles, means.repeat(2, axis=1).repeat(2, axis=2))
