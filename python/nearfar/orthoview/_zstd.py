"""Zstandard frames of known size, with a checksum of their content."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base.errors import UnusableError

COMPRESSION: dict[str, Any] = {"level": 3, "checksum": True}
"""Settings. A frame carries a checksum of its content, so that readers detect damage."""


def compress(content: NDArray[np.uint8]) -> bytes:
    from numcodecs.zstd import Zstd  # imported here: `import nearfar` does not need it

    return bytes(Zstd(**COMPRESSION).encode(np.ascontiguousarray(content)))


def decompress(frame: bytes, size: int) -> NDArray[np.uint8]:
    """Decompress a frame of `size` bytes; UnusableError if it is damaged."""
    from numcodecs.zstd import Zstd

    content = np.zeros(size, np.uint8)
    try:
        # A buffer of the expected size: a damaged frame may state any size.
        Zstd().decode(frame, content)
    except (RuntimeError, ValueError) as error:
        raise UnusableError(f"a chunk: {error}") from None
    return content
