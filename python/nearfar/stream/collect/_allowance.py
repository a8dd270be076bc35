"""How often a conductor may tell who aims: a room closes the connection of a user who says too much."""

from __future__ import annotations

RATE, AT_ONCE = 16_384.0, 8192.0
"""Bytes a second, half of those that a room lets a user say, and bytes that may be said at once."""

MESSAGE, USER = 64, 2
"""Bytes of a message that names nobody, no fewer than a room counts for it, and of each user in it."""


class Allowance:
    """Bytes that may be said, which come back at a rate."""

    def __init__(self) -> None:
        self._left, self._last = AT_ONCE, 0.0

    def take(self, users: int, now: float) -> bool:
        """Use up the bytes of a message that names some users; False if there are not as many."""
        self._left = min(self._left + RATE * max(now - self._last, 0.0), AT_ONCE)
        self._last = now
        size = MESSAGE + USER * users
        if size > self._left:
            return False
        self._left -= size
        return True
