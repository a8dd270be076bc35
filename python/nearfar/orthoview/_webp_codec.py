"""WebP as a codec of Zarr v3, with the name and the settings of the package imagecodecs.

So readers with imagecodecs-zarr open such stores without nearfar, and readers with nearfar without imagecodecs.
"""

from __future__ import annotations

import asyncio
from dataclasses import dataclass
from typing import Any

from zarr.abc.codec import ArrayBytesCodec

from nearfar.orthoview import _webp

NAME = "imagecodecs_webp"


@dataclass(frozen=True)
class WebpCodec(ArrayBytesCodec):  # type: ignore[misc]  # zarr's types are not read
    """Codec of chunks whose last axes are a square sRGB picture, and whose other axes have the length 1."""

    level: float | None = None
    """Quality of a lossy file, 0 to 100."""
    lossless: bool = True

    is_fixed_size = False

    def __post_init__(self) -> None:
        if not self.lossless and (self.level is None or not 0 <= self.level <= 100):
            raise ValueError(f"level: expected 0 to 100 for lossy WebP, got {self.level}")

    @classmethod
    def from_dict(cls, data: dict[str, Any]) -> WebpCodec:
        """Create the codec from its entry in an array's document."""
        return cls(**data.get("configuration", {}))

    def to_dict(self) -> dict[str, Any]:
        """Return the codec's entry for an array's document."""
        settings = {"lossless": True} if self.lossless else {"level": self.level, "lossless": False}
        return {"name": NAME, "configuration": settings}

    def compute_encoded_size(self, input_byte_length: int, chunk_spec: Any) -> int:
        """Raise: the length of a WebP file is not known beforehand; zarr asks only codecs of fixed size."""
        raise ValueError(f"{NAME}: lengths of files are not known beforehand")

    def _encode_sync(self, chunk: Any, spec: Any) -> Any:
        array = chunk.as_numpy_array()
        *leading, height, width, values = array.shape
        if array.dtype != "u1" or values != 3 or height != width or any(number != 1 for number in leading):
            raise ValueError(f"chunk: expected a square picture of 3 × uint8, got {array.shape} {array.dtype}")
        quality = None if self.lossless or self.level is None else round(self.level)
        return spec.prototype.buffer.from_bytes(_webp.encode(array.reshape(height, width, values), quality))

    def _decode_sync(self, chunk: Any, spec: Any) -> Any:
        picture = _webp.decode(chunk.to_bytes(), spec.shape[-2])
        return spec.prototype.nd_buffer.from_numpy_array(picture.reshape(spec.shape))

    async def _encode_single(self, chunk: Any, spec: Any) -> Any:
        return await asyncio.to_thread(self._encode_sync, chunk, spec)

    async def _decode_single(self, chunk: Any, spec: Any) -> Any:
        return await asyncio.to_thread(self._decode_sync, chunk, spec)


# zarr warns if two classes have the same name, so the entry point is the class of imagecodecs if that is installed.
try:
    from imagecodecs.zarr import Webp as Codec
except ImportError:
    Codec = WebpCodec
