"""Comparison of a store's shards with its records."""

from __future__ import annotations

import hashlib

from nearfar._base import progress
from nearfar._base.errors import FormatError
from nearfar.orthoview import _store
from nearfar.orthoview._files import Files


def verify(store: Files, newest: int) -> int:
    """Check the size and the SHA-256 of all shards; returns their number."""
    records = list(_store.recorded(store, newest))
    count, checked = sum(len(recorded.shards) for recorded in records), 0
    with progress.bar("checking") as report:
        for recorded in records:
            for path, (size, digest) in recorded.shards.items():
                _check(store, recorded.folder + path, size, digest)
                checked += 1
                report(checked, count)
    return checked


def _check(store: Files, name: str, size: int, digest: str) -> None:
    content = store.whole(name)
    if content is None:
        raise FormatError(f"{store.place}/{name}: damaged orthoviews: the shard is gone")
    if len(content) != size:
        raise FormatError(
            f"{store.place}/{name}: damaged orthoviews: expected a shard of {size} bytes, got {len(content)}"
        )
    if hashlib.sha256(content).hexdigest() != digest:
        raise FormatError(f"{store.place}/{name}: damaged orthoviews: the shard's SHA-256 is not {digest}")
