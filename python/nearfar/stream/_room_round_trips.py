"""Round-trip times of a user's poses by the paper's Eq. 3: Δᵢ = T_is + max over j ≠ i of (T_sj + T_js) + T_si."""

from __future__ import annotations

from collections import deque

import numpy as np
from numpy.typing import NDArray

from nearfar.stream._room_events import Settled

MAX = 10_000
"""Greatest number of stored round-trip times, and of poses that await acknowledgement."""


class RoundTrips:
    """Poses that await acknowledgement, and the time until all users have acknowledged them."""

    def __init__(self) -> None:
        self._sent: deque[tuple[int, float]] = deque(maxlen=MAX)
        self._seconds: deque[float] = deque(maxlen=MAX)

    def send(self, sequence: int, now: float) -> None:
        """Record a sent pose that others acknowledge."""
        self._sent.append((sequence, now))

    def settle(self, sequence: int, now: float) -> list[Settled]:
        """Record that all others have this pose or a later one; return the poses that this settles."""
        settled = []
        while self._sent and self._sent[0][0] <= sequence:
            number, sent = self._sent.popleft()
            settled.append(Settled(number, now - sent))
        self._seconds.extend(event.seconds for event in settled)
        return settled

    def forget(self) -> None:
        """Discard outstanding poses, because no user is left to acknowledge them."""
        self._sent.clear()

    @property
    def seconds(self) -> NDArray[np.float64]:
        """Return the last round-trip times, the newest last."""
        return np.array(self._seconds, np.float64)
