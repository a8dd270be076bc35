"""Round trips of a user's poses by the paper's Eq. 3: Δᵢ = T_is + max over j ≠ i of (T_sj + T_js) + T_si."""

from __future__ import annotations

from collections import deque

import numpy as np
from numpy.typing import NDArray

from nearfar.stream._room_events import Settled

MOST = 10_000
"""Most round trips that are kept, and poses that are waited for."""


class RoundTrips:
    """Poses that others are to acknowledge, and the time until all have."""

    def __init__(self) -> None:
        self._sent: deque[tuple[int, float]] = deque(maxlen=MOST)
        self._seconds: deque[float] = deque(maxlen=MOST)

    def send(self, sequence: int, now: float) -> None:
        """A pose that others acknowledge is sent."""
        self._sent.append((sequence, now))

    def settle(self, sequence: int, now: float) -> list[Settled]:
        """All others have this pose or a later one: the poses that are settled by it."""
        settled = []
        while self._sent and self._sent[0][0] <= sequence:
            number, sent = self._sent.popleft()
            settled.append(Settled(number, now - sent))
        self._seconds.extend(event.seconds for event in settled)
        return settled

    def forget(self) -> None:
        """Nobody is there any more who acknowledges what was sent."""
        self._sent.clear()

    @property
    def seconds(self) -> NDArray[np.float64]:
        """The last round trips, the newest last."""
        return np.array(self._seconds, np.float64)
