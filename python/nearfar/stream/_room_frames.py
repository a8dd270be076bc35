"""Frames of rooms as bytes, specified in docs/rooms.md: writes those of clients and reads those of the server."""

from __future__ import annotations

import struct
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np

from nearfar.stream._room_events import (
    Begin,
    Joined,
    Left,
    Placed,
    Pointer,
    Pose,
    Posed,
    RoomError,
    Said,
    Signalled,
    To,
)

VERSION = 1
MAX_SAY_BYTES = 1 << 12
"""Greatest payload of `say`, bytes."""
MAX_SIGNAL_BYTES = 1 << 14
"""Greatest payload of `signal`, bytes."""
ONE = 32767
"""Integer that represents 1 in a rotation."""
FARTHEST = 1e6
"""Greatest coordinate, and greatest length of a pointer, metres."""
MIN_LENGTH, MAX_LENGTH = 0.9, 1.1
"""Range of quaternion lengths that are accepted as rotations."""

REASONS = (
    "bye", "gone", "version", "frame", "token", "full", "flood", "slow", "silent", "replaced", "ending",
)  # fmt: skip
"""Names of the reasons for which a connection ends, in the order of their codes."""

_TO: tuple[To, ...] = ("group", "room")
_BEGINS: tuple[Begin, ...] = ("head", "left", "right")
_ACKNOWLEDGED, _STOPS, _LEFT, _RIGHT = 1, 2, 4, 8
_POINTER = 4
"""Bit position of the pointer's two flags."""

_HEAD = struct.Struct("<BH")
_HELLO = struct.Struct("<BH")
_ACK = struct.Struct("<HI")
_POSE = struct.Struct("<IQB")
_PLACED = struct.Struct("<3f4h")
_LENGTH = struct.Struct("<f")
_USER = struct.Struct("<H")
_SEQUENCE = struct.Struct("<I")
_TWO = struct.Struct("<HH")


@dataclass(frozen=True)
class Welcome:
    """The server has admitted the user."""

    user: int
    others: int
    ticket: bytes


@dataclass(frozen=True)
class SettledUpTo:
    """All other users of the group have acknowledged this pose of the user, or a later one."""

    sequence: int


@dataclass(frozen=True)
class Refused:
    """The server ends the connection."""

    reason: str
    sentence: str


Frame: TypeAlias = Welcome | Posed | SettledUpTo | Said | Signalled | Joined | Left | Refused
"""Frame of the server."""


def hello(group: int, name: str, ticket: bytes) -> bytes:
    """Encode the first frame: the user, with the ticket of the previous connection, or an empty one."""
    text = name.encode()
    return _frame(1, _HELLO.pack(VERSION, group) + _with_length(text) + _with_length(ticket))


def pose(moved: Pose) -> bytes:
    """Encode a pose."""
    hands = [(moved.left, _LEFT), (moved.right, _RIGHT)]
    flags = _ACKNOWLEDGED * moved.is_acknowledged | _STOPS * moved.stops
    flags |= sum(flag for hand, flag in hands if hand is not None)
    pointer = moved.pointer
    if pointer is not None:
        flags |= (1 + _BEGINS.index(pointer.begin)) << _POINTER
    body = _POSE.pack(moved.sequence, moved.clock, flags)
    body += b"".join(_written(place) for place in (moved.head, moved.left, moved.right) if place is not None)
    return _frame(2, body + (b"" if pointer is None else _LENGTH.pack(pointer.length)))


def ack(user: int, sequence: int) -> bytes:
    """Encode the acknowledgement of another user's pose."""
    return _frame(3, _ACK.pack(user, sequence))


def say(to: To, data: bytes) -> bytes:
    """Encode a message to the group or the room."""
    return _frame(4, bytes([_TO.index(to)]) + data)


def signal(user: int, data: bytes) -> bytes:
    """Encode a message to one user."""
    return _frame(5, _USER.pack(user) + data)


def bye() -> bytes:
    """Encode the user's departure."""
    return _frame(6, b"")


def read(message: bytes) -> Iterator[Frame]:
    """Yield the frames of a server's message; RoomError for malformed ones."""
    at = 0
    while at < len(message):
        if len(message) < at + _HEAD.size:
            raise _fault("a frame is too short")
        kind, length = _HEAD.unpack_from(message, at)
        begin, at = at + _HEAD.size, at + _HEAD.size + length
        if len(message) < at:
            raise _fault("a frame is too short")
        try:
            yield _read(kind, message[begin:at])
        except (struct.error, IndexError, UnicodeDecodeError):
            raise _fault(f"a frame of kind {kind} has no such body") from None


def _read(kind: int, body: bytes) -> Frame:
    match kind:
        case 129:
            user, others = _TWO.unpack_from(body)
            return Welcome(user, others, _rest_of(body, _TWO.size))
        case 130:
            return Posed(_USER.unpack_from(body)[0], _pose(body[_USER.size :]))
        case 131:
            return SettledUpTo(*_SEQUENCE.unpack(body))
        case 132:
            (user,) = _USER.unpack_from(body)
            return Said(user, _at_most(MAX_SAY_BYTES, body[_USER.size + 1 :]), _TO[body[_USER.size]])
        case 133:
            (user,) = _USER.unpack_from(body)
            return Signalled(user, _at_most(MAX_SIGNAL_BYTES, body[_USER.size :]))
        case 134:
            user, group = _TWO.unpack_from(body)
            return Joined(user, _rest_of(body, _TWO.size).decode(), group)
        case 135:
            return Left(*_USER.unpack(body))
        case 136:
            reason = REASONS[body[0]] if body[0] < len(REASONS) else f"reason {body[0]}"
            return Refused(reason, body[1:].decode())
    raise _fault(f"a frame of kind {kind} is none that the server sends")


def _pose(body: bytes) -> Pose:
    sequence, clock, flags = _POSE.unpack_from(body)
    at = _POSE.size
    places: list[Placed | None] = []
    for is_there in (True, flags & _LEFT, flags & _RIGHT):
        places.append(_read_placed(body, at) if is_there else None)
        at += _PLACED.size * bool(is_there)
    pointer = None
    if flags >> _POINTER:
        # Undefined flag values raise IndexError here.
        number = (flags >> _POINTER) - 1
        pointer = Pointer(_BEGINS[number], *_LENGTH.unpack_from(body, at))
        at += _LENGTH.size
        if places[number] is None or not 0.0 <= pointer.length <= FARTHEST:
            raise _fault("a pointer begins at no hand, or has no length")
    head, left, right = places
    if head is None or at != len(body):
        raise _fault("a pose is too long")
    return Pose(sequence, clock, bool(flags & _ACKNOWLEDGED), bool(flags & _STOPS), head, left, right, pointer)


def _read_placed(body: bytes, at: int) -> Placed:
    *position, x, y, z, w = _PLACED.unpack_from(body, at)
    placed = Placed(np.array(position, np.float32), np.array([x, y, z, w]) / ONE)
    # NaN fails the comparison.
    if not all(abs(value) <= FARTHEST for value in position):
        raise _fault("a position is none")
    if not MIN_LENGTH <= np.linalg.norm(placed.rotation) <= MAX_LENGTH:
        raise _fault("a rotation is no unit quaternion")
    placed.position.flags.writeable = placed.rotation.flags.writeable = False
    return placed


def _written(placed: Placed) -> bytes:
    return _PLACED.pack(*placed.position.tolist(), *np.rint(placed.rotation * ONE).astype(int).tolist())


def _frame(kind: int, body: bytes) -> bytes:
    return _HEAD.pack(kind, len(body)) + body


def _with_length(data: bytes) -> bytes:
    return bytes([len(data)]) + data


def _rest_of(body: bytes, at: int) -> bytes:
    """Return a byte string with a one-byte length prefix, which must end the body."""
    if len(body) != at + 1 + body[at]:
        raise _fault("a frame has bytes that are not counted")
    return body[at + 1 :]


def _at_most(most: int, data: bytes) -> bytes:
    if len(data) > most:
        raise _fault("a payload is too long")
    return data


def _fault(sentence: str) -> RoomError:
    return RoomError("frame", f"the server sent what is no frame: {sentence}")
