"""Names of rooms and of their users, as the server takes them."""

from __future__ import annotations

import unicodedata

from nearfar._base import check

MOST_BYTES = 64
"""Most bytes of a name."""


def room(argument: str, value: str) -> str:
    """Check a room's name; ValueError for one that no address of a room can have."""
    name = _name(argument, value)
    # Clients and proxies take dots for folders.
    if not name or "/" in name or name in (".", ".."):
        got = check.shortened(value)
        raise ValueError(f"{argument}: expected 1 to {MOST_BYTES} bytes without a slash, but not . or .., got {got}")
    return name


def user(argument: str, value: str) -> str:
    """Check a user's name, which may be empty; ValueError for letters that nobody sees, with which names look alike."""
    name = _name(argument, value)
    if any(unicodedata.category(letter) == "Cf" for letter in name):
        raise ValueError(f"{argument}: expected no characters that only format, got {check.shortened(value)}")
    return name


def _name(argument: str, value: str) -> str:
    name = check.text(argument, value)
    if len(name.encode()) > MOST_BYTES:
        raise ValueError(f"{argument}: expected at most {MOST_BYTES} bytes of UTF-8, got {check.shortened(value)}")
    if any(unicodedata.category(letter) == "Cc" for letter in name):
        raise ValueError(f"{argument}: expected no control characters, got {check.shortened(value)}")
    return name
