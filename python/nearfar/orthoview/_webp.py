"""Encodes views with their colours as WebP, lossless or lossy, and all other bytes in a Zstandard frame.

A chunk is the length of the image as little-endian uint32, the image, and a Zstandard frame of the other bytes. The
image shows all layers, one below the other.
"""

from __future__ import annotations

import struct

import numpy as np
from numpy.typing import NDArray

from nearfar._base import webp
from nearfar._base.errors import UnusableError

LENGTH = struct.Struct("<I")
"""Length of the image at the beginning of a chunk."""


def encode(picture: NDArray[np.uint8], quality: int | None = None, filled: NDArray[np.bool_] | None = None) -> bytes:
    """Encode the colours of a view's layers, sRGB (layers, size, size, 3), as one image.

    `quality` is 0 to 100, or None for a lossless file, which decodes to the same picture. `filled` is the mask (layers,
    size, size) of non-empty pixels; by default all. In a lossy file empty pixels take colours from their surroundings,
    since black pixels would darken their neighbours and need more bytes. Readers recognise empty pixels by depth 0.
    """
    if quality is not None and filled is not None:
        shown = filled.any(axis=(1, 2))
        picture = picture.copy()
        picture[shown] = np.rint(webp.fill_unknown(picture[shown].astype(np.float32), filled[shown])).astype(np.uint8)
    return webp.encode(picture.reshape(-1, *picture.shape[2:]), quality)


def decode(data: bytes, size: int, layers: int = 1) -> NDArray[np.uint8]:
    """Decode the colours (layers, size, size, 3) of a view; ValueError for other bytes or a picture of another size."""
    return webp.decode(data, (size, layers * size)).reshape(layers, size, size, 3)


def join(image: bytes, rest: bytes) -> bytes:
    """Join an image and a Zstandard frame to a chunk."""
    return LENGTH.pack(len(image)) + image + rest


def split(chunk: bytes) -> tuple[bytes, bytes]:
    """Image and Zstandard frame of a chunk; UnusableError for a chunk that is too short."""
    end = LENGTH.size + LENGTH.unpack_from(chunk)[0] if len(chunk) >= LENGTH.size else 0
    if not LENGTH.size <= end <= len(chunk):
        raise UnusableError("a chunk: its image is longer than the chunk")
    return chunk[LENGTH.size : end], chunk[end:]
