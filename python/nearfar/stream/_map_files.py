"""Bytes of maps in files: colour as WebP pictures, range as compressed 16-bit codes of its logarithm."""

from __future__ import annotations

import io
import math
import warnings
import zlib
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._scene.srgb import to_linear

MOST_PIXELS = 16383
"""Greatest width and height of a WebP picture."""

NOTHING = 65535
"""Code of texels without a surface."""

NEAREST = 1e-3
"""Ranges below this are stored as this, metres."""

_LINEAR = to_linear(np.arange(256) / 255.0).astype(np.float32)

PLANES = 9
"""Planes of bytes that ranges are divided into."""

MOST_BYTES = 4
"""Bytes that a texel takes at most in all planes: two flags, a pair of bits, a byte and a word."""

Codes = NDArray[np.uint16]


def encode_color(linear: NDArray[np.float32], quality: int | None) -> bytes:
    """Encode a picture (H, W, 3), linear RGB, as WebP in sRGB; `quality` 0 to 100, or None for a lossless one."""
    height, width = linear.shape[:2]
    codes = _core.encode_srgb(np.ascontiguousarray(linear, np.float32)).reshape(height, width, 3)
    from PIL import Image

    file, settings = io.BytesIO(), {"lossless": True} if quality is None else {"quality": quality}
    Image.fromarray(codes).save(file, "webp", method=4, **settings)
    return file.getvalue()


def decode_color(data: bytes, size: tuple[int, int]) -> NDArray[np.float32]:
    """Decode a picture of known width and height to (H, W, 3), linear RGB; ValueError for anything else."""
    from PIL import Image, UnidentifiedImageError

    try:
        with warnings.catch_warnings():
            # The size is known and checked before anything is decoded.
            warnings.simplefilter("ignore", Image.DecompressionBombWarning)
            image = Image.open(io.BytesIO(data), formats=["webp"])
        with image:
            if image.size != size:
                raise ValueError(f"expected a picture of {size[0]} × {size[1]} pixels, got {image.size}")
            linear: NDArray[np.float32] = _LINEAR[np.asarray(image.convert("RGB"))]
            return linear
    except UnidentifiedImageError:
        raise ValueError("expected a WebP picture, got something else") from None
    except (OSError, SyntaxError, Image.DecompressionBombError) as error:
        raise ValueError(f"expected a WebP picture, got {error}") from None


@dataclass(frozen=True)
class RangeScale:
    """Codes of range: code c stands for `least` · exp(c · `step`), and 65535 for nothing.

    The relative error of a range is at most exp(`step`/2) − 1, the same at every distance.
    """

    least: float
    """Range of code 0, metres."""
    step: float
    """Natural logarithm of the ratio of two consecutive codes' ranges."""

    @classmethod
    def of(cls, ranges: NDArray[np.float32], error: float) -> RangeScale:
        """Make the scale whose relative error is at most `error`, or as small as 16 bits allow."""
        finite = ranges[np.isfinite(ranges)]
        if not len(finite):
            return cls(1.0, 2.0 * math.log1p(error))
        # One float32 step wider, so that the codes of both ends are in range.
        least = max(float(finite.min()), NEAREST) * (1.0 - 2.0**-23)
        span = math.log(max(float(finite.max()), least) * (1.0 + 2.0**-23) / least)
        return cls(least, max(2.0 * math.log1p(error), span / (NOTHING - 1)))

    @property
    def error(self) -> float:
        """Greatest relative error of a stored range from `NEAREST` on, before it is rounded to float32."""
        return math.expm1(0.5 * self.step)

    def codes(self, ranges: NDArray[Any]) -> Codes:
        """Codes of ranges in metres, which may be infinite."""
        is_hit = np.isfinite(ranges)
        logarithms = np.log(np.maximum(np.where(is_hit, ranges, self.least), NEAREST, dtype=np.float64) / self.least)
        codes = np.rint(logarithms / self.step)
        return np.where(is_hit, np.clip(codes, 0, NOTHING - 1), NOTHING).astype(np.uint16)

    def ranges(self, codes: Codes) -> NDArray[np.float32]:
        """Ranges that codes stand for."""
        table = self.least * np.exp(np.arange(NOTHING + 1) * self.step)
        table[NOTHING] = np.inf
        ranges: NDArray[np.float32] = table[codes].astype(np.float32)
        return ranges


def encode_ranges(
    codes: Codes, before: Codes | None, changed: NDArray[np.bool_], tiles: NDArray[np.int64], tile: int, step: float
) -> bytes:
    """Compress codes of faces (N, S, S): all of them, or with the codes `before` those of `changed` texels alone.

    `changed` is stored too; `tiles` has the ascending numbers of all tiles with changed texels, `step` is the scale's.
    """
    listed = tiles.astype(np.uint32)
    earlier = None if before is None else before.ravel()
    settings: dict[str, Any] = {"size": codes.shape[1], "tile": tile, "tiles": listed, "step": step}
    planes = _core.encode_ranges(codes.ravel(), earlier, changed.ravel(), **settings)
    lengths = np.array([len(plane) for plane in planes], "<u4").tobytes()
    # Flushing ends a block, so that each plane has a code of its own.
    writer = zlib.compressobj(9)
    parts = [writer.compress(part) + writer.flush(zlib.Z_SYNC_FLUSH) for part in (lengths, *planes)]
    return b"".join([*parts, writer.flush()])


def decode_ranges(
    data: bytes, before: Codes | None, count: int, size: int, tiles: NDArray[np.int64], tile: int, step: float
) -> tuple[Codes, NDArray[np.bool_]]:
    """Decompress codes and changed texels, (`count`, `size`, `size`) each; ValueError for anything else."""
    texels = count * size * size if before is None else len(tiles) * tile * tile
    head = 4 * PLANES
    # Each plane may end with a byte that is not full.
    raw = _decompressed(data, head + PLANES + MOST_BYTES * texels)
    ends = head + np.cumsum(np.frombuffer(raw[: len(raw) // 4 * 4][:head], "<u4"), dtype=np.int64)
    if len(ends) != PLANES or ends[-1] != len(raw):
        raise ValueError("expected ranges of planes whose lengths are listed, got others")
    planes = [raw[start:end] for start, end in pairwise([head, *ends.tolist()])]
    earlier = None if before is None else before.ravel()
    settings: dict[str, Any] = {"size": size, "tile": tile, "tiles": tiles.astype(np.uint32), "step": step}
    codes, changed = _core.decode_ranges(planes, earlier, faces=count, **settings)
    return codes.reshape(count, size, size), changed.reshape(count, size, size)


def _decompressed(data: bytes, most: int) -> bytes:
    """Unpack at most so many bytes."""
    reader = zlib.decompressobj()
    try:
        raw = reader.decompress(data, most + 1)
    except zlib.error as error:
        raise ValueError(f"expected compressed ranges, got {error}") from None
    if len(raw) > most or not reader.eof or reader.unused_data:
        raise ValueError(f"expected compressed ranges of at most {most} bytes, got others")
    return raw


def with_neighbours(mask: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Texels of faces (N, S, S) that are marked or lie beside a marked one of their face, diagonally too."""
    wide = mask.copy()
    wide[:, 1:] |= mask[:, :-1]
    wide[:, :-1] |= mask[:, 1:]
    rows = wide.copy()
    wide[:, :, 1:] |= rows[:, :, :-1]
    wide[:, :, :-1] |= rows[:, :, 1:]
    return wide


def filled(tiles: NDArray[np.float32], known: NDArray[np.bool_]) -> NDArray[np.float32]:
    """Replace unknown texels of tiles (N, side, side, 3) by the mean of the least block around them with known ones.

    Sides of blocks are powers of two, as `side` is; the mean is that of the means of a block's quarters. Smoother
    fillings take more bytes as pictures.
    """
    count, side = known.shape[:2]
    partly = ~known.all(axis=(1, 2))
    if side == 1 or not partly.any():
        return tiles
    if not partly.all():
        whole = tiles.copy()
        whole[partly] = filled(tiles[partly], known[partly])
        return whole
    blocks = (count, side // 2, 2, side // 2, 2)
    number = known.reshape(blocks).sum(axis=(2, 4))
    sums = np.where(known[..., None], tiles, 0).reshape(*blocks, 3).sum(axis=(2, 4))
    means = filled(sums / np.maximum(number, 1, dtype=np.float32)[..., None], number > 0)
    return np.where(known[..., None], tiles, means.repeat(2, axis=1).repeat(2, axis=2))


def tiles_of(faces: NDArray[Any], chosen: NDArray[np.int64], side: int) -> NDArray[Any]:
    """Tiles (N, side, side, …) of faces (6, S, S, …), numbered by face, row and column; S is a multiple of `side`."""
    blocks, (face, row, column) = _blocks(faces, chosen, side)
    tiles: NDArray[Any] = blocks[face, row, :, column]
    return tiles


def by_face(tiles: NDArray[np.int64], across: int) -> list[tuple[slice, NDArray[np.int64]]]:
    """Each face as a slice of faces, and the numbers of its own tiles among `tiles`, from 0 on."""
    face, place = np.divmod(tiles, across * across)
    return [(slice(number, number + 1), place[face == number]) for number in range(6)]


def put_tiles(faces: NDArray[Any], chosen: NDArray[np.int64], tiles: NDArray[Any]) -> None:
    """Replace tiles of faces, numbered as in `tiles_of`."""
    blocks, (face, row, column) = _blocks(faces, chosen, tiles.shape[1])
    blocks[face, row, :, column] = tiles


def _blocks(
    faces: NDArray[Any], chosen: NDArray[np.int64], side: int
) -> tuple[NDArray[Any], tuple[NDArray[np.int64], ...]]:
    """A view of contiguous faces by face, row of tiles, row, column of tiles and column; the places of tiles in it."""
    across = faces.shape[1] // side
    blocks = faces.reshape(6, across, side, across, side, *faces.shape[3:])
    return blocks, np.unravel_index(chosen, (6, across, across))


def sheet_of(tiles: NDArray[Any], across: int) -> NDArray[Any]:
    """One picture of tiles (N, side, side, 3), `across` in a row; black tiles fill the last row."""
    count, side = tiles.shape[:2]
    rows = -(-count // across)
    padded = np.zeros((rows * across, *tiles.shape[1:]), tiles.dtype)
    padded[:count] = tiles
    return padded.reshape(rows, across, side, side, 3).swapaxes(1, 2).reshape(rows * side, across * side, 3)


def tiles_of_sheet(sheet: NDArray[Any], count: int, side: int) -> NDArray[Any]:
    """The tiles of a picture that `sheet_of` made."""
    rows, across = sheet.shape[0] // side, sheet.shape[1] // side
    return sheet.reshape(rows, side, across, side, 3).swapaxes(1, 2).reshape(rows * across, side, side, 3)[:count]
