"""Poses and events of a room; bounded queues of unread events and of poses that await acknowledgement."""

from __future__ import annotations

import asyncio
from collections import OrderedDict, deque
from dataclasses import dataclass
from itertools import count
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from nearfar._base.errors import Error

PointerOrigin = Literal["head", "left", "right"]
"""Origin of a pointer."""

To = Literal["group", "room"]
"""Recipients of a message."""

MAX_EVENTS = 4096
MAX_BYTES = 1 << 20
"""Limits of the queue: number of events, and payload bytes; the oldest events are discarded."""

MAX_ROUND_TRIPS = 10_000
"""Greatest number of stored round-trip times, and of poses that await acknowledgement."""


@dataclass(frozen=True)
class User:
    """Another user of a room."""

    number: int
    """Number that the server assigned."""
    name: str
    """Name that the user chose."""
    group: int
    """Group that the user chose; poses are sent only to their group."""


@dataclass(frozen=True, eq=False)
class Placed:
    """Position and rotation of a head or a hand."""

    position: NDArray[np.float32]
    """Metres from the scene's origin, y up, shape (3,)."""
    rotation: NDArray[np.float64]
    """Unit quaternion (x, y, z, w), in units of 1/32767, shape (4,)."""

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Placed):
            return NotImplemented
        return np.array_equal(self.position, other.position) and np.array_equal(self.rotation, other.rotation)

    def __hash__(self) -> int:
        return hash((self.position.tobytes(), self.rotation.tobytes()))


@dataclass(frozen=True)
class Pointer:
    """A ray that points along −z of its origin."""

    begin: PointerOrigin
    """Head or hand at which the ray starts."""
    length: float
    """Length, metres."""


@dataclass(frozen=True)
class Pose:
    """Pose of a user's head, hands and pointer."""

    sequence: int
    """Sequence number, greater than that of each earlier pose."""
    clock: int
    """Sender's clock, microseconds from an arbitrary start."""
    is_acknowledged: bool
    """Whether others acknowledge it, so that the sender measures its round-trip time."""
    stops: bool
    """Whether no pose follows until the user moves again."""
    head: Placed
    left: Placed | None = None
    right: Placed | None = None
    pointer: Pointer | None = None


@dataclass(frozen=True)
class Joined:
    """A user has entered the room, or was there already when this user entered."""

    user: int
    name: str
    group: int


@dataclass(frozen=True)
class Left:
    """A user has left the room."""

    user: int


@dataclass(frozen=True)
class Posed:
    """A user of the own group has sent a pose."""

    user: int
    pose: Pose


@dataclass(frozen=True)
class Said:
    """A message to a group or the room; all recipients receive a room's messages in the same order."""

    user: int
    """Number of the sender."""
    data: bytes
    to: To
    """Recipients: the sender's group or the room."""


@dataclass(frozen=True)
class Signalled:
    """A message to this user alone."""

    user: int
    """Number of the sender."""
    data: bytes


@dataclass(frozen=True)
class Settled:
    """All other users of the group have acknowledged a pose of this user."""

    sequence: int
    """Sequence number of the pose."""
    seconds: float
    """Round-trip time by the paper's Eq. 3, on this user's clock."""


@dataclass(frozen=True)
class Ended:
    """The connection has ended; forget all users until new `Joined` events announce them."""

    reason: str
    """Name of the reason, listed in docs/rooms.md."""
    sentence: str
    """Description of the reason."""
    returns: bool
    """Whether the client reconnects; if not, this is the last event."""


Event = Joined | Left | Posed | Said | Signalled | Settled | Ended
"""Any event of a room."""


class RoomError(Error):
    """A connection to a room failed or has ended; the message has the server's reason."""

    reason: str
    """Name of the reason, listed in docs/rooms.md."""
    sentence: str
    """Description of the reason."""

    def __init__(self, reason: str, sentence: str) -> None:
        super().__init__(f"the connection to the room has ended ({reason}): {sentence}")
        self.reason, self.sentence = reason, sentence

    def __reduce__(self) -> tuple[Any, ...]:
        return RoomError, (self.reason, self.sentence)


class Inbox:
    """Events in order. A newer pose replaces a queued one of the same user, as on the server."""

    def __init__(self) -> None:
        self._waiting: OrderedDict[tuple[str, int], Event] = OrderedDict()
        self._numbers = count()
        self._bytes = 0
        self._is_ended = False
        self._change = asyncio.Event()
        self.dropped = 0
        """Number of events discarded because the queue was full."""

    def add(self, event: Event) -> None:
        if isinstance(event, Posed):
            self._waiting[("pose", event.user)] = event
        else:
            if isinstance(event, Left):
                self._waiting.pop(("pose", event.user), None)
            self._waiting[("event", next(self._numbers))] = event
            self._bytes += _payload(event)
        while len(self._waiting) > MAX_EVENTS or self._bytes > MAX_BYTES:
            self._pop()
            self.dropped += 1
        self._change.set()

    def end(self) -> None:
        """Mark the end: no event follows the queued ones."""
        self._is_ended = True
        self._change.set()

    async def take(self) -> Event | None:
        """Remove and return the first event, waiting for one; None after the last."""
        while not self._waiting:
            if self._is_ended:
                return None
            self._change.clear()
            await self._change.wait()
        return self._pop()

    def _pop(self) -> Event:
        _, event = self._waiting.popitem(last=False)
        self._bytes -= _payload(event)
        return event


def _payload(event: Event) -> int:
    return len(event.data) if isinstance(event, Said | Signalled) else 0


class RoundTrips:
    """Poses that await acknowledgement, and the time until all users have acknowledged them.

    That is the paper's Eq. 3: Δᵢ = T_is + max over j ≠ i of (T_sj + T_js) + T_si.
    """

    def __init__(self) -> None:
        self._sent: deque[tuple[int, float]] = deque(maxlen=MAX_ROUND_TRIPS)
        self._seconds: deque[float] = deque(maxlen=MAX_ROUND_TRIPS)

    def send(self, sequence: int, now: float) -> None:
        """Record a sent pose that others acknowledge."""
        self._sent.append((sequence, now))

    def settle(self, sequence: int, now: float) -> list[Settled]:
        """Record that all others have this pose or a later one; return the poses that this settles."""
        settled = []
        while self._sent and self._sent[0][0] <= sequence:
            number, sent_time = self._sent.popleft()
            settled.append(Settled(number, now - sent_time))
        self._seconds.extend(event.seconds for event in settled)
        return settled

    def forget(self) -> None:
        """Discard outstanding poses, because no user is left to acknowledge them."""
        self._sent.clear()

    @property
    def seconds(self) -> NDArray[np.float64]:
        """Return the last round-trip times, the newest last."""
        return np.array(self._seconds, np.float64)
