"""Comparison of a store's files with its records."""

from __future__ import annotations

import hashlib

from nearfar._base import progress
from nearfar._base.errors import FormatError
from nearfar.orthoview import _store
from nearfar.orthoview._files import Files


def verify(store: Files, newest: int) -> int:
    """Check the size and the SHA-256 of all shards and geometry files; return their number."""
    records = list(_store.recorded(store, newest))
    listed = [
        (recorded.folder + path, *described)
        for recorded in records
        for files in (recorded.shards, recorded.geometry)
        for path, described in files.items()
    ]
    with progress.bar("checking") as report:
        for done, (name, size, digest) in enumerate(listed):
            _check(store, name, size, digest)
            report(done + 1, len(listed))
    return len(listed)


def _check(store: Files, name: str, size: int, digest: str) -> None:
    content = store.whole(name)
    if content is None:
        raise FormatError(f"{store.place}/{name}: damaged orthoviews: the file is gone")
    if len(content) != size:
        raise FormatError(f"{store.place}/{name}: damaged orthoviews: expected {size} bytes, got {len(content)}")
    if hashlib.sha256(content).hexdigest() != digest:
        raise FormatError(f"{store.place}/{name}: damaged orthoviews: its SHA-256 is not {digest}")
