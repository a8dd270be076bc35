"""Encoding of maps: colour as WebP images, range as compressed 16-bit logarithmic codes."""

from __future__ import annotations

import math
import zlib
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import webp
from nearfar._scene.srgb import to_linear

MAX_PIXELS = 16383
"""Greatest width and height of a WebP image."""

NO_SURFACE = 65535
"""Code of texels without a surface."""

MIN_RANGE = 1e-3
"""Least stored range, metres; smaller ranges are clamped to it."""

_LINEAR = to_linear(np.arange(256) / 255.0).astype(np.float32)

PLANE_COUNT = 9
"""Number of byte planes that ranges are divided into."""

MAX_TEXEL_BYTES = 4
"""Greatest number of bytes per texel in all planes: two flags, a pair of bits, a byte and a word."""

Codes = NDArray[np.uint16]


def encode_color(linear: NDArray[np.float32], quality: int | None) -> bytes:
    """Encode an image (H, W, 3), linear RGB, as WebP in sRGB; `quality` 0 to 100, None for lossless."""
    height, width = linear.shape[:2]
    codes = _core.encode_srgb(np.ascontiguousarray(linear, np.float32)).reshape(height, width, 3)
    return webp.encode(codes, quality)


def decode_color(data: bytes, size: tuple[int, int]) -> NDArray[np.float32]:
    """Decode an image of known width and height to (H, W, 3), linear RGB; ValueError for anything else."""
    return np.asarray(_LINEAR[webp.decode(data, size)])


@dataclass(frozen=True)
class RangeScale:
    """Logarithmic codes of range: code c stands for `least` · exp(c · `step`), and 65535 for no surface.

    The relative error of a range is at most exp(`step`/2) − 1, the same at every distance.
    """

    least: float
    """Range of code 0, metres."""
    step: float
    """Natural logarithm of the ratio of two consecutive codes' ranges."""

    @classmethod
    def fit(cls, ranges: NDArray[np.float32], error: float) -> RangeScale:
        """Make the scale whose relative error is at most `error`, or the finest scale of 16 bits."""
        finite = ranges[np.isfinite(ranges)]
        if not len(finite):
            return cls(1.0, 2.0 * math.log1p(error))
        # Widened by one float32 step, so that the codes of both ends are in range.
        least = max(float(finite.min()), MIN_RANGE) * (1.0 - 2.0**-23)
        span = math.log(max(float(finite.max()), least) * (1.0 + 2.0**-23) / least)
        return cls(least, max(2.0 * math.log1p(error), span / (NO_SURFACE - 1)))

    @property
    def error(self) -> float:
        """Greatest relative error of a stored range from `MIN_RANGE` on, before it is rounded to float32."""
        return math.expm1(0.5 * self.step)

    def to_manifest(self) -> dict[str, float]:
        return {"least": self.least, "step": self.step, "error": self.error}

    def codes(self, ranges: NDArray[Any]) -> Codes:
        """Return the codes of ranges in metres, which may be infinite."""
        is_hit = np.isfinite(ranges)
        logarithms = np.log(np.maximum(np.where(is_hit, ranges, self.least), MIN_RANGE, dtype=np.float64) / self.least)
        codes = np.clip(np.rint(logarithms / self.step), 0, NO_SURFACE - 1)
        return np.where(is_hit, codes, NO_SURFACE).astype(np.uint16)

    def ranges(self, codes: Codes) -> NDArray[np.float32]:
        table = self.least * np.exp(np.arange(NO_SURFACE + 1) * self.step)
        table[NO_SURFACE] = np.inf
        return np.asarray(table[codes].astype(np.float32))


def encode_ranges(
    codes: Codes, before: Codes | None, changed: NDArray[np.bool_], tiles: NDArray[np.int64], tile: int, step: float
) -> bytes:
    """Compress codes of faces (N, S, S): all codes, or with the codes `before` only the codes of `changed` texels.

    `changed` is stored too; `tiles` lists all tiles with changed texels in ascending order; `step` is the scale's.
    """
    earlier = None if before is None else before.ravel()
    layout: dict[str, Any] = {"size": codes.shape[1], "tile": tile, "tiles": tiles.astype(np.uint32), "step": step}
    planes = _core.encode_ranges(codes.ravel(), earlier, changed.ravel(), layout)
    lengths = np.array([len(plane) for plane in planes], "<u4").tobytes()
    # A sync flush ends the block, so that each plane gets its own Huffman code.
    writer = zlib.compressobj(9)
    parts = [writer.compress(part) + writer.flush(zlib.Z_SYNC_FLUSH) for part in (lengths, *planes)]
    return b"".join([*parts, writer.flush()])


def decode_ranges(
    data: bytes, before: Codes | None, count: int, size: int, tiles: NDArray[np.int64], tile: int, step: float
) -> tuple[Codes, NDArray[np.bool_]]:
    """Decompress codes and changed texels, (`count`, `size`, `size`) each; ValueError for invalid data."""
    texels = count * size * size if before is None else len(tiles) * tile * tile
    header_bytes = 4 * PLANE_COUNT
    # Each plane may end with a partly filled byte.
    raw = _decompress(data, header_bytes + PLANE_COUNT + MAX_TEXEL_BYTES * texels)
    ends = header_bytes + np.cumsum(np.frombuffer(raw[: len(raw) // 4 * 4][:header_bytes], "<u4"), dtype=np.int64)
    if len(ends) != PLANE_COUNT or ends[-1] != len(raw):
        raise ValueError("expected ranges in planes of the listed lengths, got others")
    planes = [raw[start:end] for start, end in pairwise([header_bytes, *ends.tolist()])]
    earlier = None if before is None else before.ravel()
    layout: dict[str, Any] = {"size": size, "tile": tile, "tiles": tiles.astype(np.uint32), "step": step}
    codes, changed = _core.decode_ranges(planes, earlier, count, layout)
    return codes.reshape(count, size, size), changed.reshape(count, size, size)


def _decompress(data: bytes, max_bytes: int) -> bytes:
    """Decompress at most `max_bytes`; ValueError for more."""
    reader = zlib.decompressobj()
    try:
        raw = reader.decompress(data, max_bytes + 1)
    except zlib.error as error:
        raise ValueError(f"expected compressed ranges, got {error}") from None
    if len(raw) > max_bytes or not reader.eof or reader.unused_data:
        raise ValueError(f"expected compressed ranges of at most {max_bytes} bytes, got others")
    return raw


def with_neighbours(mask: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Return the mask of faces (N, S, S) dilated by one texel within each face, diagonally too."""
    columns = mask.copy()
    columns[:, 1:] |= mask[:, :-1]
    columns[:, :-1] |= mask[:, 1:]
    dilated = columns.copy()
    dilated[:, :, 1:] |= columns[:, :, :-1]
    dilated[:, :, :-1] |= columns[:, :, 1:]
    return dilated


def tiles_of(faces: NDArray[Any], numbers: NDArray[np.int64], side: int) -> NDArray[Any]:
    """Extract tiles (N, side, side, …) of faces (6, S, S, …), numbered by face, row and column; `side` divides S."""
    blocks, (face, row, column) = _blocks(faces, numbers, side)
    return np.asarray(blocks[face, row, :, column])


def group_by_face(tiles: NDArray[np.int64], per_row: int) -> list[tuple[slice, NDArray[np.int64]]]:
    """Group tiles by face; return each face as a slice, and its tiles' numbers counted from 0 within the face."""
    face, number = np.divmod(tiles, per_row * per_row)
    return [(slice(n, n + 1), number[face == n]) for n in range(6)]


def put_tiles(faces: NDArray[Any], numbers: NDArray[np.int64], tiles: NDArray[Any]) -> None:
    """Replace tiles of faces, numbered as in `tiles_of`."""
    blocks, (face, row, column) = _blocks(faces, numbers, tiles.shape[1])
    blocks[face, row, :, column] = tiles


def _blocks(
    faces: NDArray[Any], numbers: NDArray[np.int64], side: int
) -> tuple[NDArray[Any], tuple[NDArray[np.int64], ...]]:
    """Return a view of contiguous faces with axes (face, tile row, row, tile column, column), and indices of tiles."""
    per_row = faces.shape[1] // side
    blocks = faces.reshape(6, per_row, side, per_row, side, *faces.shape[3:])
    return blocks, np.unravel_index(numbers, (6, per_row, per_row))


def sheet_of(tiles: NDArray[Any], per_row: int) -> NDArray[Any]:
    """Join tiles (N, side, side, 3) to one image with `per_row` in a row; the last row is filled with black tiles."""
    count, side = tiles.shape[:2]
    rows = -(-count // per_row)
    padded = np.zeros((rows * per_row, *tiles.shape[1:]), tiles.dtype)
    padded[:count] = tiles
    return padded.reshape(rows, per_row, side, side, 3).swapaxes(1, 2).reshape(rows * side, per_row * side, 3)


def tiles_of_sheet(sheet: NDArray[Any], count: int, side: int) -> NDArray[Any]:
    """Extract the tiles of an image that `sheet_of` made."""
    rows, per_row = sheet.shape[0] // side, sheet.shape[1] // side
    return sheet.reshape(rows, side, per_row, side, 3).swapaxes(1, 2).reshape(rows * per_row, side, side, 3)[:count]
