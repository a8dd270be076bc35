"""Poses of users of a room, and events."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal, TypeAlias

import numpy as np
from numpy.typing import NDArray

from nearfar._base.errors import Error

PointerOrigin: TypeAlias = Literal["head", "left", "right"]
"""Origin of a pointer."""

To: TypeAlias = Literal["group", "room"]
"""Recipients of a message."""


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
    """The head."""
    left: Placed | None = None
    """The left hand."""
    right: Placed | None = None
    """The right hand."""
    pointer: Pointer | None = None
    """The pointer."""


@dataclass(frozen=True)
class Joined:
    """A user has entered the room, or was there already when this user entered."""

    user: int
    """Number of the user."""
    name: str
    """Name of the user."""
    group: int
    """Group of the user."""


@dataclass(frozen=True)
class Left:
    """A user has left the room."""

    user: int
    """Number of the user."""


@dataclass(frozen=True)
class Posed:
    """A user of the own group has sent a pose."""

    user: int
    """Number of the user."""
    pose: Pose
    """Pose of the user."""


@dataclass(frozen=True)
class Said:
    """A message to a group or the room; all recipients receive a room's messages in the same order."""

    user: int
    """Number of the sender."""
    data: bytes
    """Payload."""
    to: To
    """Recipients: the sender's group or the room."""


@dataclass(frozen=True)
class Signalled:
    """A message to this user alone."""

    user: int
    """Number of the sender."""
    data: bytes
    """Payload."""


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


Event: TypeAlias = Joined | Left | Posed | Said | Signalled | Settled | Ended
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
