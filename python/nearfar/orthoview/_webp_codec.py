"""Zarr v3 codec for views whose colours are stored as WebP; zarr finds it by nearfar's entry point."""

from __future__ import annotations

import asyncio
from dataclasses import dataclass
from typing import Any

import numpy as np
from zarr.abc.codec import ArrayBytesCodec

from nearfar.orthoview import _webp, _zstd

NAME = "nearfar_webp_view"


@dataclass(frozen=True)
class WebpViewCodec(ArrayBytesCodec):  # type: ignore[misc]  # mypy does not read zarr's types
    """Codec of chunks that contain a view's bytes, colours first."""

    size: int
    """Width and height of a layer, pixels."""
    layers: int
    quality: int | None = None
    """WebP quality, 0 to 100; None for lossless files."""

    is_fixed_size = False

    def __post_init__(self) -> None:
        if self.quality is not None and not 0 <= self.quality <= 100:
            raise ValueError(f"quality: expected 0 to 100 or None for lossless WebP, got {self.quality}")

    @classmethod
    def from_dict(cls, data: dict[str, Any]) -> WebpViewCodec:
        """Create the codec from its entry in an array's document."""
        return cls(**data["configuration"])

    def to_dict(self) -> dict[str, Any]:
        """Return the codec's entry for an array's document."""
        settings = {"size": self.size, "layers": self.layers, "quality": self.quality}
        return {"name": NAME, "configuration": settings}

    def compute_encoded_size(self, input_byte_length: int, chunk_spec: Any) -> int:
        """Raise a ValueError: zarr calls this only for codecs of fixed size, and lengths of WebP files vary."""
        raise ValueError(f"{NAME}: the lengths of WebP files are not known in advance")

    @property
    def _picture(self) -> tuple[int, int, int, int]:
        return self.layers, self.size, self.size, 3

    def _encode_sync(self, chunk: Any, spec: Any) -> Any:
        array = chunk.as_numpy_array()
        content, end = array.reshape(-1), int(np.prod(self._picture))
        if array.dtype != "u1" or len(content) <= end:
            raise ValueError(f"chunk: expected more than {end} × uint8, got {array.shape} {array.dtype}")
        image = _webp.encode(content[:end].reshape(self._picture), self.quality)
        return spec.prototype.buffer.from_bytes(_webp.join(image, _zstd.compress(content[end:])))

    def _decode_sync(self, chunk: Any, spec: Any) -> Any:
        content = np.empty(int(np.prod(spec.shape)), np.uint8)
        end = int(np.prod(self._picture))
        image, rest = _webp.split(chunk.to_bytes())
        content[:end] = _webp.decode(image, self.size, self.layers).reshape(-1)
        content[end:] = _zstd.decompress(rest, len(content) - end)
        return spec.prototype.nd_buffer.from_numpy_array(content.reshape(spec.shape))

    async def _encode_single(self, chunk: Any, spec: Any) -> Any:
        return await asyncio.to_thread(self._encode_sync, chunk, spec)

    async def _decode_single(self, chunk: Any, spec: Any) -> Any:
        return await asyncio.to_thread(self._decode_sync, chunk, spec)
