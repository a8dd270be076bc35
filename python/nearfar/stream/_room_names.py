"""Names of rooms and of users, under the server's rules."""

from __future__ import annotations

import unicodedata

from nearfar._base import check

MAX_BYTES = 64
"""Greatest size of a name, bytes."""


def room(argument: str, value: str) -> str:
    """Check a room's name; ValueError for one that cannot be part of a room's address."""
    name = _name(argument, value)
    # Clients and proxies resolve dots as folders.
    if not name or "/" in name or name in (".", ".."):
        got = check.shortened(value)
        raise ValueError(f"{argument}: expected 1 to {MAX_BYTES} bytes without a slash, but not . or .., got {got}")
    return name


def user(argument: str, value: str) -> str:
    """Check a user's name, which may be empty; ValueError for invisible characters, which make names look alike."""
    name = _name(argument, value)
    if any(unicodedata.category(letter) == "Cf" for letter in name):
        raise ValueError(f"{argument}: expected no characters that only format, got {check.shortened(value)}")
    return name


def _name(argument: str, value: str) -> str:
    name = check.text(argument, value)
    if len(name.encode()) > MAX_BYTES:
        raise ValueError(f"{argument}: expected at most {MAX_BYTES} bytes of UTF-8, got {check.shortened(value)}")
    if any(unicodedata.category(letter) == "Cc" for letter in name):
        raise ValueError(f"{argument}: expected no control characters, got {check.shortened(value)}")
    return name
