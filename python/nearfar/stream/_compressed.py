"""Bytes that files take on their way where the server compresses them, as `nearfar serve` does."""

from __future__ import annotations

import zlib
from collections.abc import Callable

LEAST, MOST = 1 << 10, 1 << 26
"""Files of fewer bytes, and of more, go as they are."""
WORTH = 0.95
"""Share of a file's bytes that a compressed copy may have."""
COMPRESSED = (".webp", ".range")
"""Ends of names of files whose content is compressed."""

_FORMAT = 16 + zlib.MAX_WBITS
"""Of gzip."""
_known: dict[str, int] = {}
"""By the names of files, which are those of their contents."""


def sent(name: str, size: int, read: Callable[[str], bytes]) -> int:
    """Return the bytes that a file takes on its way."""
    if name.endswith(COMPRESSED) or not LEAST <= size <= MOST:
        return size
    if name not in _known:
        _known[name] = _copy(read(name))
    return _known[name] if _known[name] < WORTH * size else size


def sent_now(content: bytes) -> int:
    """Return the bytes that a document takes whose name does not tell its content."""
    packed = _copy(content)
    return packed if len(content) >= LEAST and packed < WORTH * len(content) else len(content)


def _copy(content: bytes) -> int:
    packer = zlib.compressobj(wbits=_FORMAT)
    return len(packer.compress(content)) + len(packer.flush())
