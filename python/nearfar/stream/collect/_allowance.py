"""Rate limit on the conductor's messages: a room disconnects a user who sends too many bytes."""

from __future__ import annotations

RATE, AT_ONCE = 16_384.0, 8192.0
"""Bytes per second, half of the room's limit, and burst size in bytes."""

MESSAGE, USER = 64, 2
"""Message size in bytes without users, at least the room's minimum charge, and additional bytes per user."""


class Allowance:
    """Token bucket of bytes."""

    def __init__(self) -> None:
        self._left, self._last = AT_ONCE, 0.0

    def take(self, users: int, now: float) -> bool:
        """Consume the bytes of a message that lists some users; False if too few are left."""
        self._left = min(self._left + RATE * max(now - self._last, 0.0), AT_ONCE)
        self._last = now
        size = MESSAGE + USER * users
        if size > self._left:
            return False
        self._left -= size
        return True
