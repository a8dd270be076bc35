"""Views as the chunks of a store, and back."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar.orthoview._directions import Direction
from nearfar.orthoview._layout import CHANNELS, CONNECTION_BITS, ZSTD_LEVEL, Layout

CONNECTED = (4.0, 0.5, 0.7)
"""Bounds of connected pixels: τ₁ in pixels (a plane at up to 70° from across the view), τ₂ = cos 60° between a normal
and the vector to the neighbour, τ₃ = cos 46° between normals."""

Chunks = dict[tuple[int, str], bytes]
"""Compressed chunks of a cell, by the number of the direction and the channel; none for views that show nothing."""


def encoded(views: _core.OrthoViews, layout: Layout) -> Chunks:
    """Compress the views of a cell."""
    from numcodecs.zstd import Zstd

    compressor = Zstd(level=ZSTD_LEVEL)
    of_channel = {
        "color": views.colors(),
        "depth": views.depths().astype(layout.dtype("depth")) << CONNECTION_BITS | views.connected(CONNECTED),
        "normal": _packed(views.normals(), layout.normal_bits),
    }
    shown = [number for number, is_empty in enumerate(views.empty()) if not is_empty]
    return {
        (number, channel): bytes(compressor.encode(np.ascontiguousarray(of_channel[channel][number])))
        for number in shown
        for channel in CHANNELS
    }


def decoded(chunks: Chunks, layout: Layout) -> _core.OrthoViews:
    """Read the views of a cell from their chunks."""
    from numcodecs.zstd import Zstd

    compressor, arrays = Zstd(), {}
    for channel in CHANNELS:
        shape = (layout.size, layout.size, layout.values(channel))
        whole = np.zeros((len(layout.directions), *shape), layout.dtype(channel))
        for number in range(len(layout.directions)):
            if (number, channel) in chunks:
                found = compressor.decode(chunks[number, channel])
                whole[number] = np.frombuffer(found, layout.dtype(channel)).reshape(shape)
        arrays[channel] = whole
    views, _ = from_stored(arrays["color"], arrays["depth"], arrays["normal"], layout, layout.directions)
    return views


def from_stored(
    color: NDArray[np.uint8],
    depth: NDArray[Any],
    normal: NDArray[np.uint8],
    layout: Layout,
    directions: tuple[Direction, ...],
) -> tuple[_core.OrthoViews, NDArray[np.uint8]]:
    """Views from a store's arrays (D, size, size, values), and the connections (D, size, size, 1) of their pixels."""
    depths = (depth >> CONNECTION_BITS).astype(np.uint16)
    bits = (depth & ((1 << CONNECTION_BITS) - 1)).astype(np.uint8)
    normals = _unpacked(normal, layout.normal_bits)
    return _core.OrthoViews.from_arrays(directions, layout.format, color, depths, normals), bits


def _packed(normals: NDArray[np.uint16], bits: int) -> NDArray[np.uint8]:
    """Two numbers of 8 bits as two bytes, or of 12 bits as three."""
    if bits == 16:
        return normals.astype(np.uint8)
    x, y = normals[..., 0], normals[..., 1]
    return np.stack([x >> 4, (x & 15) << 4 | y >> 8, y & 255], axis=-1).astype(np.uint8)


def _unpacked(packed: NDArray[np.uint8], bits: int) -> NDArray[np.uint16]:
    numbers = packed.astype(np.uint16)
    if bits == 16:
        return numbers
    high, middle, low = np.moveaxis(numbers, -1, 0)
    return np.stack([high << 4 | middle >> 4, (middle & 15) << 8 | low], axis=-1)
