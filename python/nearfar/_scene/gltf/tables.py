"""Table of a glTF document's accessors: where their rows are, and whether the rows can be used unchanged."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._scene.budget import TooLargeError
from nearfar._scene.gltf.buffers import COMPONENTS, WIDTHS, Buffers

_NONE = -1
_BYTE, _FLOAT = 5120, 5126
"""Component types with the least and the greatest code."""

_MAX_WIDTH = max(WIDTHS.values())
_SIZES = {code: np.dtype(kind).itemsize for code, kind in COMPONENTS.items()}
_EMPTY_ROW = (0, 0, 4, 0, 1, _FLOAT, 0)
"""Row of an accessor that cannot be used unchanged."""

_ACCESSOR_DEFAULTS = {"bufferView": _NONE, "byteOffset": 0, "componentType": 0, "count": _NONE}
_VIEW_DEFAULTS = {"buffer": _NONE, "byteOffset": 0, "byteLength": _NONE, "byteStride": _NONE}
"""Entries of an accessor and of a buffer view with their defaults."""

_UNUSED_ROW = (_NONE, 0, 0, 0, 0, 0, 0)
"""Row of an accessor that is not in use."""

Numbers = NDArray[np.int64]


@dataclass(frozen=True)
class Table:
    """Rows of A accessors in blocks of bytes."""

    blocks: list[NDArray[np.uint8]]
    rows: Numbers
    """Columns (A, 7): block, first byte, stride, count, width, component type, and whether normalised."""
    is_plain: NDArray[np.bool_]
    """Whether the rows can be used unchanged from a buffer (A,)."""

    def allows(self, widths: tuple[int, ...], kinds: Iterable[int] = COMPONENTS) -> NDArray[np.bool_]:
        """Whether each accessor is plain, with one of the widths and one of the component types (A,)."""
        has_width, has_kind = np.zeros(_MAX_WIDTH + 1, bool), np.zeros(_FLOAT - _BYTE + 1, bool)
        has_width[[*widths]] = True
        has_kind[[kind - _BYTE for kind in kinds]] = True
        return self.is_plain & has_width[self.rows[:, 4]] & has_kind[self.rows[:, 5] - _BYTE]

    @property
    def counts(self) -> Numbers:
        """Numbers of rows (A,)."""
        return self.rows[:, 3]

    @property
    def is_tight(self) -> NDArray[np.bool_]:
        """Whether rows follow each other without gaps (A,)."""
        return np.asarray(self.rows[:, 2] == _sizes(self.rows[:, 5]) * self.rows[:, 4])


def _sizes(kinds: Numbers) -> Numbers:
    """Bytes per component of each type; 0 for unknown types."""
    unique_kinds, indices = np.unique(kinds, return_inverse=True)
    return np.array([_SIZES.get(kind, 0) for kind in unique_kinds.tolist()], np.int64)[indices]


def table(header: dict[str, Any], buffers: Buffers, accessor_numbers: Collection[int]) -> Table | None:
    """Make a table with the accessors in `accessor_numbers`; rows of others are empty. None if entries are damaged."""
    try:
        accessors, views = _accessors(header, accessor_numbers), _views(header)
    except (AttributeError, LookupError, OverflowError, TypeError, ValueError):
        return None
    if not len(accessors) or not len(views):
        return None
    view, offset, kind, count, width, is_fraction, is_sparse = accessors.T
    is_usable = (view >= 0) & (view < len(views)) & (is_sparse == 0) & (width > 0)
    view = np.where(is_usable, view, 0)
    blocks, block, start, length = _blocks(buffers, views, np.unique(view[is_usable]).tolist())
    size = _sizes(kind) * width
    step = np.where(views[view, 3] == _NONE, size, views[view, 3])
    is_usable &= (size > 0) & (step >= size) & (count >= 0) & (offset >= 0) & (length[view] >= 0)
    # Prevents overflow of products; no valid file has so many rows or bytes.
    is_usable &= np.maximum(count, offset) <= length[view]
    is_usable &= (step <= np.maximum(length[view], size)) & (count <= np.iinfo(np.int64).max // np.maximum(step, 1))
    end = offset + np.where(count > 0, (count - 1) * np.where(is_usable, step, 0) + size, 0)
    is_usable &= end <= length[view]
    rows = np.column_stack([block[view], start[view] + offset, step, count, width, kind, is_fraction])
    rows[~is_usable] = _EMPTY_ROW
    return Table(blocks, rows, is_usable)


def _accessors(header: dict[str, Any], accessor_numbers: Collection[int]) -> Numbers:
    """Columns (A, 7): view, first byte, component type, count, width, whether normalised, whether sparse."""
    rows: list[tuple[Any, ...]] = []
    for number, accessor in enumerate(header.get("accessors", [])):
        if number not in accessor_numbers:
            rows.append(_UNUSED_ROW)
            continue
        numbers = (accessor.get(key, default) for key, default in _ACCESSOR_DEFAULTS.items())
        width, is_normalized = WIDTHS.get(accessor.get("type"), 0), accessor.get("normalized", False) is True
        rows.append((*numbers, width, int(is_normalized), int("sparse" in accessor)))
    return _numbers(rows)


def _views(header: dict[str, Any]) -> Numbers:
    """Columns (V, 4): buffer, first byte, length and stride, −1 for none."""
    views = header.get("bufferViews", [])
    return _numbers([tuple(view.get(*item) for item in _VIEW_DEFAULTS.items()) for view in views])


def _numbers(rows: list[tuple[Any, ...]]) -> Numbers:
    """Convert rows to an array; TypeError if they contain anything but integers."""
    if not {type(value) for row in rows for value in row} <= {int}:
        raise TypeError("expected whole numbers")
    return np.array(rows, np.int64)


def _blocks(
    buffers: Buffers, views: Numbers, view_numbers: list[int]
) -> tuple[list[NDArray[np.uint8]], Numbers, Numbers, Numbers]:
    """Blocks of bytes, and for each view (V,) its block, its first byte there and its length, −1 if it is unread."""
    blocks: list[NDArray[np.uint8]] = []
    block_by_buffer: dict[int, int] = {}
    block, start, length = (np.full(len(views), value, np.int64) for value in (0, 0, _NONE))
    for number in view_numbers:
        buffer, first_byte, size, _ = views[number].tolist()
        try:
            is_packed = buffers.is_packed(number)
            if is_packed or buffer not in block_by_buffer:
                content = buffers.view(number) if is_packed else buffers.bytes_of(buffer)
                blocks.append(np.frombuffer(content, np.uint8))
        except (TooLargeError, MemoryError):
            raise
        except Exception:  # resolvers may raise any type; a later read of the view reports it
            continue
        if is_packed:
            block[number], length[number] = len(blocks) - 1, len(blocks[-1])
            continue
        content_block = block_by_buffer.setdefault(buffer, len(blocks) - 1)
        if 0 <= first_byte <= first_byte + size <= len(blocks[content_block]):
            block[number], start[number], length[number] = content_block, first_byte, size
    return blocks, block, start, length
