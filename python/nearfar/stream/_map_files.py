"""Bytes of maps in files: colour as WebP pictures, range as compressed 16-bit codes of its logarithm."""

from __future__ import annotations

import io
import math
import zlib
from dataclasses import dataclass
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

Codes = NDArray[np.uint16]


def encode_color(linear: NDArray[np.float32], quality: int | None) -> bytes:
    """Encode a picture (H, W, 3), linear RGB, as WebP in sRGB; `quality` 0 to 100, or None for a lossless one."""
    height, width = linear.shape[:2]
    codes = _core.encode_srgb(np.ascontiguousarray(linear, np.float32)).reshape(height, width, 3)
    from PIL import Image

    file, settings = io.BytesIO(), {"lossless": True} if quality is None else {"quality": quality}
    Image.fromarray(codes).save(file, "webp", method=4, **settings)
    return file.getvalue()


def encode_texture(texels: NDArray[np.uint8], quality: int | None) -> bytes:
    """Encode a texture (H, W, 4), sRGB with alpha, as WebP; `quality` 0 to 100, or None for a lossless one."""
    from PIL import Image

    opaque = bool((texels[..., 3] == 255).all())
    settings: dict[str, Any] = {"lossless": True, "exact": True} if quality is None else {"quality": quality}
    file = io.BytesIO()
    Image.fromarray(texels[..., :3] if opaque else texels).save(file, "webp", method=4, **settings)
    return file.getvalue()


def decode_color(data: bytes, size: tuple[int, int]) -> NDArray[np.float32]:
    """Decode a picture of known width and height to (H, W, 3), linear RGB; ValueError for anything else."""
    from PIL import Image, UnidentifiedImageError

    try:
        with Image.open(io.BytesIO(data), formats=["webp"]) as image:
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


def encode_codes(codes: Codes) -> bytes:
    """Compress blocks of codes (N, H, W).

    Each code is predicted from its left, upper and upper left neighbours, as left + upper − upper left, within its
    block; residuals are folded to 0, −1, 1, −2, … = 0, 1, 2, 3, …; all high bytes come before all low bytes; zlib.
    """
    across = codes.copy()
    across[:, :, 1:] -= codes[:, :, :-1]
    residual = across.copy()
    residual[:, 1:] -= across[:, :-1]
    signed = residual.view(np.int16)
    folded = ((signed << 1) ^ (signed >> 15)).view(np.uint16).ravel()
    planes = np.concatenate([(folded >> 8).astype(np.uint8), (folded & 255).astype(np.uint8)])
    return zlib.compress(planes.tobytes(), 6)


def decode_codes(data: bytes, shape: tuple[int, int, int]) -> Codes:
    """Decompress blocks of codes of a known shape (N, H, W); ValueError for anything else."""
    count = math.prod(shape)
    reader = zlib.decompressobj()
    try:
        raw = reader.decompress(data, 2 * count + 1)
    except zlib.error as error:
        raise ValueError(f"expected compressed ranges, got {error}") from None
    if len(raw) != 2 * count or not reader.eof:
        raise ValueError(f"expected {2 * count} bytes of ranges, got {'more' if len(raw) > 2 * count else len(raw)}")
    planes = np.frombuffer(raw, np.uint8).reshape(2, count)
    folded = (planes[0].astype(np.uint16) << 8) | planes[1]
    residual = ((folded >> 1) ^ (0 - (folded & 1))).reshape(shape)
    rows: Any = np.cumsum(residual, axis=1, dtype=np.uint16)
    return np.cumsum(rows, axis=2, dtype=np.uint16)


def tiles_of(faces: NDArray[Any], chosen: NDArray[np.int64], side: int) -> NDArray[Any]:
    """Tiles (N, side, side, …) of faces (6, S, S, …), numbered by face, row and column; S is a multiple of `side`."""
    across = faces.shape[1] // side
    blocks = faces.reshape(6, across, side, across, side, *faces.shape[3:]).swapaxes(2, 3)
    return blocks.reshape(6 * across * across, side, side, *faces.shape[3:])[chosen]


def put_tiles(faces: NDArray[Any], chosen: NDArray[np.int64], tiles: NDArray[Any]) -> None:
    """Replace tiles of faces, numbered as in `tiles_of`."""
    side = tiles.shape[1]
    across = faces.shape[1] // side
    blocks = faces.reshape(6, across, side, across, side, *faces.shape[3:])
    face, place = np.divmod(chosen, across * across)
    row, column = np.divmod(place, across)
    blocks[face, row, :, column] = tiles


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
