"""Decodes KTX 2 images: Basis Universal (KHR_texture_basisu), and uncompressed pixels."""

from __future__ import annotations

import struct
import zlib
from dataclasses import dataclass
from importlib.util import find_spec
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base.errors import UnusableError
from nearfar._scene.budget import Budget
from nearfar._scene.materials import MAX_TEXELS
from nearfar._scene.srgb import to_srgb

BASISU = "KHR_texture_basisu"
KIND = "image/ktx2"
SIGNATURE = b"\xabKTX 20\xbb\r\n\x1a\n"

_START = struct.Struct("<12s9I4I2Q")
_LEVEL = struct.Struct("<3Q")
_MAX_LEVELS = 32
_LEVELS = slice(40, 44)
"""Byte range of the number of levels."""

_ETC1S, _UASTC = 163, 166
_MODELS = {_ETC1S: "ETC1S", _UASTC: "UASTC"}
"""Colour models of Basis Universal by number in the Khronos Data Format."""

_NO_SCHEME, _BASIS_LZ, _ZSTANDARD, _ZLIB = range(4)
_BLOCK, _BLOCK_BYTES = 4, 16

_FLOAT16, _FLOAT32 = np.dtype("<f2"), np.dtype("<f4")
_UINT8, _UINT16 = np.dtype("u1"), np.dtype("<u2")
_PIXELS: dict[int, tuple[np.dtype[Any], str]] = {
    **dict.fromkeys((23, 29), (_UINT8, "RGB")),
    **dict.fromkeys((30, 36), (_UINT8, "BGR")),
    **dict.fromkeys((37, 43), (_UINT8, "RGBA")),
    **dict.fromkeys((44, 50), (_UINT8, "BGRA")),
    84: (_UINT16, "RGB"),
    91: (_UINT16, "RGBA"),
    90: (_FLOAT16, "RGB"),
    97: (_FLOAT16, "RGBA"),
    106: (_FLOAT32, "RGB"),
    109: (_FLOAT32, "RGBA"),
}
"""Types and channels of supported pixel formats, by Vulkan format number."""

_BLOCKS = ((131, 146, "BC"), (147, 156, "ETC2 or EAC"), (157, 184, "ASTC"), (1000066000, 1000066013, "ASTC"))
"""Ranges of Vulkan's block-compressed formats."""


@dataclass(frozen=True)
class _Header:
    format: int
    width: int
    height: int
    scheme: int
    model: int
    start: int
    length: int
    """Start and length of the largest level, bytes."""
    unpacked: int
    """Bytes of the largest level without supercompression."""
    is_flipped: bool


def decode(data: bytes, budget: Budget) -> NDArray[np.uint8]:
    """Decode the largest level: texels (H, W, 4), sRGB with linear alpha, row 0 on top; UnusableError if impossible.

    All sizes are counted before anything is decoded. Integers are sRGB, as in glTF; floats are linear.
    """
    header = _header(data)
    budget.count_unpacked(4 * header.width * header.height + header.unpacked)
    is_basis = header.model in _MODELS and header.format == 0
    texels = _decode_basis(data, header) if is_basis else _decode_pixels(data, header)
    return texels[::-1] if header.is_flipped else texels


def _header(data: bytes) -> _Header:
    if len(data) < _START.size:
        raise UnusableError("is cut off")
    (_, kind, _, width, height, depth, layers, faces, levels, scheme, *ranges) = _START.unpack_from(data)
    if not (width and height) or depth or layers or faces != 1:
        raise UnusableError("is not a single two-dimensional image")
    if width * height > MAX_TEXELS:
        raise UnusableError(f"has {width} × {height} texels, and at most {MAX_TEXELS:,} are read")
    if levels > _MAX_LEVELS or len(data) < _START.size + max(levels, 1) * _LEVEL.size:
        raise UnusableError(f"is cut off before its {levels} levels, or they are too many")
    start, length, unpacked = _LEVEL.unpack_from(data, _START.size)
    descriptor = _part(data, ranges[0], ranges[1])
    if start + length > len(data) or len(descriptor) < 16:
        raise UnusableError("is cut off")
    if scheme in (_NO_SCHEME, _BASIS_LZ):
        unpacked = 0 if scheme else length
    is_flipped = b"KTXorientation\0ru" in _part(data, ranges[2], ranges[3])
    return _Header(kind, width, height, scheme, descriptor[12], start, length, unpacked, is_flipped)


def _part(data: bytes, start: int, length: int) -> bytes:
    if start + length > len(data):
        raise UnusableError("is cut off")
    return data[start : start + length]


def _decode_basis(data: bytes, header: _Header) -> NDArray[np.uint8]:
    """Decode Basis Universal with the package opengl_basisu."""
    name = _MODELS[header.model]
    schemes = (_BASIS_LZ,) if header.model == _ETC1S else (_NO_SCHEME, _ZSTANDARD)
    blocks = -(-header.width // _BLOCK) * -(-header.height // _BLOCK)
    if header.scheme not in schemes or (header.model == _UASTC and header.unpacked != blocks * _BLOCK_BYTES):
        raise UnusableError(f"has a level of another size than its {header.width} × {header.height} texels ({name})")
    if not find_spec("opengl_basisu"):
        raise UnusableError(
            f"is compressed by Basis Universal ({name}), which the Python package opengl-basisu decodes: "
            'pip install "nearfar[formats]"'
        )
    import opengl_basisu

    if not int.from_bytes(data[_LEVELS], "little"):
        # 0 means one level, from which readers make smaller ones; the package needs the number 1.
        data = data[: _LEVELS.start] + (1).to_bytes(4, "little") + data[_LEVELS.stop :]
    try:
        texels: NDArray[Any] = opengl_basisu.open(data).transcode("rgba8").data
    except MemoryError:
        raise
    except Exception as error:  # its errors have no common type, and Cython passes C++ exceptions on
        raise UnusableError(f"cannot be decoded: {error}") from None
    if texels.shape != (header.height, header.width, 4):
        raise UnusableError(f"has other sizes than its header's {header.width} × {header.height}")
    return texels.astype(np.uint8, copy=False)


def _decode_pixels(data: bytes, header: _Header) -> NDArray[np.uint8]:
    """Decode pixels that are not block-compressed."""
    if header.format not in _PIXELS:
        families = (name for first, last, name in _BLOCKS if first <= header.format <= last)
        format_name = f"{next(families, f'colour model {header.model}')} (Vulkan's format {header.format})"
        raise UnusableError(f"has {format_name}, which is not read: save it as PNG, JPEG or by Basis Universal")
    kind, channels = _PIXELS[header.format]
    size = header.width * header.height * len(channels) * kind.itemsize
    level = data[header.start : header.start + header.length]
    if header.scheme == _ZLIB:
        try:
            level = zlib.decompressobj().decompress(level, size + 1)
        except zlib.error as error:
            raise UnusableError(f"cannot be unpacked: {error}") from None
    elif header.scheme != _NO_SCHEME:
        raise UnusableError("is packed by Zstandard, which is read for Basis Universal only: save it unpacked")
    if len(level) != size:
        raise UnusableError(f"has a level of {len(level)} bytes for {header.width} × {header.height} texels")
    values = np.frombuffer(level, kind).reshape(header.height, header.width, len(channels))
    texels = np.full((header.height, header.width, 4), 255, np.uint8)
    for index, channel in enumerate("RGBA"):
        if channel in channels:
            texels[:, :, index] = _bytes(values[:, :, channels.index(channel)], is_alpha=channel == "A")
    return texels


def _bytes(values: NDArray[Any], *, is_alpha: bool) -> NDArray[np.uint8]:
    if values.dtype == _UINT16:
        return (values >> 8).astype(np.uint8)
    if values.dtype == _UINT8:
        return values
    light = np.clip(np.nan_to_num(values.astype(np.float32)), 0, 1)
    return np.asarray(np.rint((light if is_alpha else to_srgb(light)) * 255).astype(np.uint8))
