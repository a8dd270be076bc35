"""Encodes views as the chunks of a store, and decodes them."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base.errors import UnusableError
from nearfar.orthoview import _webp
from nearfar.orthoview._layout import BEHIND, CHANNELS, COMPRESSION, CONNECTION_BITS, Layout
from nearfar.orthoview._shard import CHECKSUM_BYTES, checksum

CONNECTION_LIMITS = (4.0, 0.5, 0.7)
"""Thresholds for connected pixels: τ₁ in pixels (a plane at up to 70° from across the view), τ₂ = cos 60° between a
normal and the vector to the neighbour, τ₃ = cos 46° between normals."""

Encoded = dict[tuple[int, str], bytes]
"""Compressed chunks of a cell by direction number and channel; empty views have none."""

MIN_UNSEEN_SHARE = 0.01
"""Least share of a view's pixels that only its second layer, and no first layer of any view, must show to be kept."""


def drop_unneeded_layers(views: _core.OrthoViews, layout: Layout) -> _core.OrthoViews:
    """Drop second layers that show little that no first layer shows."""
    if layout.layers == 1:
        return views
    return views.keep_behind([unseen_share > MIN_UNSEEN_SHARE for unseen_share in views.unseen()])


def encode(views: _core.OrthoViews | None, layout: Layout) -> Encoded:
    """Compress both layers of a cell's views; an empty cell has none."""
    if views is None:
        return {}
    second = views.second_layer()
    behind = {} if second is None else _encode_layer(second, layout)
    named = {(number, BEHIND + channel): chunk for (number, channel), chunk in behind.items()}
    return _encode_layer(views, layout) | named


def _encode_layer(views: _core.OrthoViews, layout: Layout) -> Encoded:
    from numcodecs.zstd import Zstd

    from nearfar._base import side_by_side  # imported here: its threads import `logging`

    compressor = Zstd(**COMPRESSION)
    of_channel = {
        "color": views.colors(),
        "depth": views.depths().astype(layout.dtype("depth")) << CONNECTION_BITS | views.connected(CONNECTION_LIMITS),
        "normal": _pack_normals(views.normals(), layout.normal_bits),
    }
    non_empty = [number for number, is_empty in enumerate(views.empty()) if not is_empty]
    pairs = [(number, channel) for number in non_empty for channel in CHANNELS]
    has_surface = views.depths()[..., 0] > 0

    def chunk(number: int, channel: str) -> bytes:
        values = np.ascontiguousarray(of_channel[channel][number])
        if channel == "color" and layout.color == "webp":
            data = _webp.encode(values, layout.quality, has_surface[number])
            return data + checksum(data)
        return bytes(compressor.encode(values))

    return dict(zip(pairs, side_by_side.results([partial(chunk, *pair) for pair in pairs]), strict=True))


def _without_checksum(chunk: bytes) -> bytes:
    data = chunk[:-CHECKSUM_BYTES]
    if checksum(data) != chunk[-CHECKSUM_BYTES:]:
        raise UnusableError("the checksum of a chunk is wrong")
    return data


def split_layers(chunks: Encoded) -> list[Encoded]:
    """Split chunks into those of the first layer and, if there are any, those of the second one, under equal keys."""
    first = {pair: chunk for pair, chunk in chunks.items() if not pair[1].startswith(BEHIND)}
    second = {(n, name.removeprefix(BEHIND)): chunks[n, name] for n, name in chunks if name.startswith(BEHIND)}
    return [first, second] if second else [first]


def decode_cell(chunks: Encoded, layout: Layout) -> _core.OrthoViews | None:
    """Decode both layers of a cell's views; None for an empty cell."""
    if not chunks:
        return None
    first, *second = (decode(layer, layout)[0] for layer in split_layers(chunks))
    return _core.OrthoViews.with_behind(first, *second) if second else first


def decode(
    chunks: Encoded, layout: Layout, numbers: Sequence[int] | None = None
) -> tuple[_core.OrthoViews, NDArray[np.uint8]]:
    """Decode the first layer of a cell's views, and the connections (D, size, size, 1) of their pixels.

    Missing chunks show nothing. `numbers` are those of the views' directions; by default all.
    """
    from numcodecs.zstd import Zstd

    numbers = range(len(layout.directions)) if numbers is None else numbers
    compressor, arrays = Zstd(), {}
    for channel in CHANNELS:
        shape = (layout.size, layout.size, layout.values(channel))
        values = np.zeros((len(numbers), *shape), layout.dtype(channel))
        for row, number in enumerate(numbers):
            if (number, channel) in chunks:
                if channel == "color" and layout.color == "webp":
                    values[row] = _webp.decode(_without_checksum(chunks[number, channel]), layout.size)
                else:
                    _decompress(compressor, chunks[number, channel], values[row])
        arrays[channel] = values
    color, depth, normals = arrays["color"], arrays["depth"], _unpack_normals(arrays["normal"], layout.normal_bits)
    color[depth[..., 0] == 0] = 0  # lossy colours also fill pixels that show nothing
    depths = (depth >> CONNECTION_BITS).astype(np.uint16)
    connections = (depth & ((1 << CONNECTION_BITS) - 1)).astype(np.uint8)
    directions = tuple(layout.directions[number] for number in numbers)
    return _core.OrthoViews.from_arrays(directions, layout.format, color, depths, normals), connections


def _decompress(compressor: Any, chunk: bytes, target: NDArray[Any]) -> None:
    """Decompress a chunk of known size into `target`; UnusableError if it is damaged."""
    content = bytearray(target.nbytes)
    try:
        # A buffer of the expected size: a damaged chunk may state any size.
        decoded = compressor.decode(chunk, content)
    except (RuntimeError, ValueError) as error:
        raise UnusableError(f"a chunk: {error}") from None
    target[:] = np.frombuffer(decoded, target.dtype).reshape(target.shape)


def _pack_normals(normals: NDArray[np.uint16], bits: int) -> NDArray[np.uint8]:
    """Pack two 8-bit numbers into two bytes, or two 12-bit numbers into three."""
    if bits == 16:
        return normals.astype(np.uint8)
    x, y = normals[..., 0], normals[..., 1]
    return np.stack([x >> 4, (x & 15) << 4 | y >> 8, y & 255], axis=-1).astype(np.uint8)


def _unpack_normals(packed: NDArray[np.uint8], bits: int) -> NDArray[np.uint16]:
    numbers = packed.astype(np.uint16)
    if bits == 16:
        return numbers
    high, middle, low = np.moveaxis(numbers, -1, 0)
    return np.stack([high << 4 | middle >> 4, (middle & 15) << 8 | low], axis=-1)
