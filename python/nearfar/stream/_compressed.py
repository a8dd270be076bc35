"""Transfer sizes of files that the server compresses, as `nearfar serve` does."""

from __future__ import annotations

import zlib
from collections.abc import Callable

MIN, MAX = 1 << 10, 1 << 26
"""Sizes in bytes outside of which files are sent uncompressed."""
WORTH = 0.95
"""Greatest ratio of compressed to original size for which the compressed copy is sent."""
COMPRESSED = (".webp", ".range")
"""Suffixes of files whose content is already compressed."""

_FORMAT = 16 + zlib.MAX_WBITS
"""zlib's `wbits` for the gzip format."""
_known: dict[str, int] = {}
"""Compressed sizes by file name; a name identifies the content."""


def transfer_size(name: str, size: int, read: Callable[[str], bytes]) -> int:
    """Return the transfer size of a file in bytes."""
    if name.endswith(COMPRESSED) or not MIN <= size <= MAX:
        return size
    if name not in _known:
        _known[name] = _copy(read(name))
    return _known[name] if _known[name] < WORTH * size else size


def sent_now(content: bytes) -> int:
    """Return the transfer size in bytes of a document whose name does not identify its content."""
    packed = _copy(content)
    return packed if len(content) >= MIN and packed < WORTH * len(content) else len(content)


def _copy(content: bytes) -> int:
    packer = zlib.compressobj(wbits=_FORMAT)
    return len(packer.compress(content)) + len(packer.flush())
