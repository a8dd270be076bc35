"""Where users of a room are, and the events that tell of them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal, TypeAlias

import numpy as np
from numpy.typing import NDArray

from nearfar._base.errors import Error

Begin: TypeAlias = Literal["head", "left", "right"]
"""Where a pointer begins."""

To: TypeAlias = Literal["group", "room"]
"""Whom something is said to."""


@dataclass(frozen=True)
class User:
    """Another user of a room."""

    number: int
    """The number by which the server calls it."""
    name: str
    """The name that it chose."""
    group: int
    """The group that it chose; poses go to its group only."""


@dataclass(frozen=True, eq=False)
class Placed:
    """Where a head or a hand is."""

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
    """A ray that leaves its begin along −z."""

    begin: Begin
    """The head or the hand at which it begins."""
    length: float
    """Metres."""


@dataclass(frozen=True)
class Pose:
    """Where a user's head, hands and pointer are."""

    sequence: int
    """Its number, greater than that of each pose before."""
    clock: int
    """The sender's clock in microseconds from any begin."""
    is_acknowledged: bool
    """Whether others acknowledge it, so that the sender measures its round trip."""
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
    """A user is there; also of those who were there before."""

    user: int
    """Its number."""
    name: str
    """Its name."""
    group: int
    """Its group."""


@dataclass(frozen=True)
class Left:
    """A user is not there any more."""

    user: int
    """Its number."""


@dataclass(frozen=True)
class Posed:
    """A user of the own group has moved."""

    user: int
    """Its number."""
    pose: Pose
    """Where it is."""


@dataclass(frozen=True)
class Said:
    """A user has said something; all who hear it get what is said in a room in the same order."""

    user: int
    """Its number."""
    data: bytes
    """The bytes that it said."""
    to: To
    """Whether to its group or to the room."""


@dataclass(frozen=True)
class Signalled:
    """A user has sent something to this user alone."""

    user: int
    """Its number."""
    data: bytes
    """The bytes that it sent."""


@dataclass(frozen=True)
class Settled:
    """All others of the group have acknowledged a pose of this user."""

    sequence: int
    """The pose's number."""
    seconds: float
    """Its round trip by the paper's Eq. 3, on this user's clock."""


@dataclass(frozen=True)
class Ended:
    """The connection has ended; nobody is there until those who are there are told anew."""

    reason: str
    """Name of the reason, as docs/rooms.md lists them."""
    sentence: str
    """The reason in words."""
    returns: bool
    """Whether the user returns by itself; if not, this is the last event."""


Event: TypeAlias = Joined | Left | Posed | Said | Signalled | Settled | Ended
"""Anything that happens in a room."""


class RoomError(Error):
    """A connection to a room that cannot be made or has ended; the message tells the server's reason."""

    reason: str
    """Name of the reason, as docs/rooms.md lists them."""
    sentence: str
    """The reason in words."""

    def __init__(self, reason: str, sentence: str) -> None:
        super().__init__(f"the connection to the room has ended ({reason}): {sentence}")
        self.reason, self.sentence = reason, sentence

    def __reduce__(self) -> tuple[Any, ...]:
        return RoomError, (self.reason, self.sentence)
