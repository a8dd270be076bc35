"""Encodes views as the chunks of a store, and decodes them."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base.errors import UnusableError
from nearfar.orthoview import _webp, _zstd
from nearfar.orthoview._layout import CONNECTION_BITS, Channels, Layout
from nearfar.orthoview._shard import CHECKSUM_BYTES, checksum

CONNECTION_LIMITS = (4.0, 0.5, 0.7)
"""Thresholds for connected pixels: τ₁ in pixels (planes tilted by up to 70° meet it), τ₂ = cos 60° between a normal and
the vector to the neighbour, τ₃ = cos 46° between normals."""

Encoded = dict[int, bytes]
"""Compressed chunks of a cell's views by direction number; empty views have none."""

Layer = tuple[_core.OrthoViews, NDArray[np.uint8]]
"""One layer of some views, and the connections (D, size, size, 1) of their pixels."""

MIN_UNSEEN_SHARE = 0.01
"""A view keeps its second layer if more than this share of its pixels gain a surface that no first layer shows."""

MIN_THREADED_BYTES = 1 << 15
"""Views of fewer bytes are compressed one after the other: starting threads takes longer than compressing them."""


def drop_unneeded_layers(views: _core.OrthoViews, layout: Layout) -> _core.OrthoViews:
    """Drop second layers that add hardly any surface to the first layers."""
    if layout.layers == 1:
        return views
    return views.keep_behind([unseen_share > MIN_UNSEEN_SHARE for unseen_share in views.unseen()])


def encode(views: _core.OrthoViews | None, layout: Layout) -> Encoded:
    """Compress a cell's views, each with all its layers; an empty cell has none."""
    if views is None:
        return {}
    second = views.second_layer()
    layers = [channels_of(each, layout) for each in (views, second) if each is not None]
    missing = layout.layers - len(layers)

    def chunk(number: int) -> bytes:
        channels = (np.stack([layer[part][number] for layer in layers]) for part in range(3))
        padded = (np.concatenate([part, np.zeros((missing, *part.shape[1:]), part.dtype)]) for part in channels)
        return _compress(Channels(*padded), layout)

    numbers = [number for number, is_empty in enumerate(views.empty()) if not is_empty]
    if layout.view_bytes < MIN_THREADED_BYTES:
        return {number: chunk(number) for number in numbers}
    from nearfar._base import side_by_side  # imported here: its threads import `logging`

    return dict(zip(numbers, side_by_side.results([partial(chunk, number) for number in numbers]), strict=True))


def channels_of(views: _core.OrthoViews, layout: Layout) -> Channels:
    """Channels of one layer of all views of a cell, one after the other."""
    connections = views.connected(CONNECTION_LIMITS)[..., 0]
    depth = views.depths()[..., 0].astype(np.uint32) << np.uint32(CONNECTION_BITS) | connections
    return Channels(views.colors(), depth, _pack_normals(views.normals(), layout.normal_bits))


def _compress(channels: Channels, layout: Layout) -> bytes:
    content = layout.join(channels)
    if layout.color == "zstd":
        return _zstd.compress(content)
    image = _webp.encode(channels.color, layout.quality, channels.depth >> CONNECTION_BITS > 0)
    data = _webp.join(image, _zstd.compress(content[layout.color_bytes :]))
    return data + checksum(data)


def _decompress(chunk: bytes, layout: Layout) -> Channels:
    """Channels of a view; UnusableError for a damaged chunk."""
    if layout.color == "zstd":
        return layout.split(_zstd.decompress(chunk, layout.view_bytes))
    data = chunk[:-CHECKSUM_BYTES]
    if checksum(data) != chunk[-CHECKSUM_BYTES:]:
        raise UnusableError("the checksum of a chunk is wrong")
    image, rest = _webp.split(data)
    color = _webp.decode(image, layout.size, layout.layers)
    others = _zstd.decompress(rest, layout.view_bytes - layout.color_bytes)
    channels = layout.split(np.concatenate([color.reshape(-1), others]))
    channels.color[channels.depth >> CONNECTION_BITS == 0] = 0  # lossy colours also fill pixels that show nothing
    return channels


def decode_cell(chunks: Encoded, layout: Layout) -> _core.OrthoViews | None:
    """Decode both layers of a cell's views; None for an empty cell."""
    if not chunks:
        return None
    first, *second = (views for views, _ in decode(chunks, layout))
    return _core.OrthoViews.with_behind(first, *second) if second else first


def decode(chunks: Encoded, layout: Layout, numbers: Sequence[int] | None = None) -> list[Layer]:
    """Decode the first layer of a cell's views, and the second one if any view has it.

    Missing chunks show nothing. `numbers` are direction numbers of the views to decode; by default all.
    """
    numbers = range(len(layout.directions)) if numbers is None else numbers
    empty = layout.split(np.zeros(layout.view_bytes, np.uint8))
    by_view = [_decompress(chunks[number], layout) if number in chunks else empty for number in numbers]
    directions = tuple(layout.directions[number] for number in numbers)
    layers = []
    for layer in range(layout.layers):
        color, depth, normal = (np.stack([channels[part][layer] for channels in by_view]) for part in range(3))
        depths = (depth >> CONNECTION_BITS).astype(np.uint16)[..., None]
        if layer > 0 and not depths.any():
            break
        normals = _unpack_normals(normal, layout.normal_bits)
        views = _core.OrthoViews.from_arrays(directions, layout.format, color, depths, normals)
        layers.append((views, (depth & ((1 << CONNECTION_BITS) - 1)).astype(np.uint8)[..., None]))
    return layers


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
