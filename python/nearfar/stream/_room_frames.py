"""Binary frames of rooms, specified in docs/rooms.md: encodes the client's frames and decodes the server's.

Also checks names of rooms and users by the server's rules, and checks and rounds poses as frames store them.
"""

from __future__ import annotations

import struct
import unicodedata
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from nearfar._base import check
from nearfar.stream._room_events import (
    Joined,
    Left,
    Placed,
    Pointer,
    PointerOrigin,
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
MAX_NAME_BYTES = 64
"""Greatest size of a name, bytes."""
MAX_METRES = 1e6
"""Greatest coordinate, and greatest length of a pointer."""
MIN_NORM, MAX_NORM = 0.9, 1.1
"""Range of quaternion lengths that are accepted as rotations."""

REASONS = (
    "bye", "gone", "version", "frame", "token", "full", "flood", "slow", "silent", "replaced", "ending",
)  # fmt: skip
"""Names of the reasons for which a connection ends, in the order of their codes."""

_TO: tuple[To, ...] = ("group", "room")
_POINTER_ORIGINS: tuple[PointerOrigin, ...] = ("head", "left", "right")
_ACKNOWLEDGED, _STOPS, _LEFT, _RIGHT = 1, 2, 4, 8
_POINTER_SHIFT = 4
"""Bit position of the pointer's two flags: 0 without a pointer, else 1 + its origin's index in `_POINTER_ORIGINS`."""

_HEADER = struct.Struct("<BH")
_USER = struct.Struct("<H")
_POSE = struct.Struct("<IQB")
_PLACED = struct.Struct("<3f4h")


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
    """The server refuses or ends the connection."""

    reason: str
    sentence: str


Frame = Welcome | Posed | SettledUpTo | Said | Signalled | Joined | Left | Refused
"""Frame of the server."""


def hello(group: int, name: str, ticket: bytes) -> bytes:
    """Encode the first frame: the user, and the ticket of the previous connection, which may be empty."""
    text = name.encode()
    return _frame(1, struct.pack("<BHB", VERSION, group, len(text)) + text + bytes([len(ticket)]) + ticket)


def pose(value: Pose) -> bytes:
    flags = _ACKNOWLEDGED * value.is_acknowledged | _STOPS * value.stops
    flags |= _LEFT * (value.left is not None) | _RIGHT * (value.right is not None)
    length = b""
    if value.pointer is not None:
        flags |= (1 + _POINTER_ORIGINS.index(value.pointer.begin)) << _POINTER_SHIFT
        length = struct.pack("<f", value.pointer.length)
    body = _POSE.pack(value.sequence, value.clock, flags)
    for placed in (value.head, value.left, value.right):
        if placed is not None:
            body += _PLACED.pack(*placed.position.tolist(), *np.rint(placed.rotation * ONE).astype(int).tolist())
    return _frame(2, body + length)


def ack(user: int, sequence: int) -> bytes:
    """Encode the acknowledgement of another user's pose."""
    return _frame(3, struct.pack("<HI", user, sequence))


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
    end = 0
    while end < len(message):
        begin = end + _HEADER.size
        kind, length = _HEADER.unpack_from(message, end) if begin <= len(message) else (0, 0)
        end = begin + length
        if len(message) < end:
            raise _fault("a frame is too short")
        try:
            frame = _read(kind, message[begin:end])
        except (struct.error, IndexError, UnicodeDecodeError):
            raise _fault(f"a frame of kind {kind} has a malformed body") from None
        yield frame


def _read(kind: int, body: bytes) -> Frame:
    match kind:
        case 129:
            user, others = struct.unpack_from("<HH", body)
            return Welcome(user, others, _strip_length(body[4:]))
        case 130:
            return Posed(_USER.unpack_from(body)[0], _read_pose(body[2:]))
        case 131:
            return SettledUpTo(*struct.unpack("<I", body))
        case 132:
            return Said(_USER.unpack_from(body)[0], _check_payload(body[3:], MAX_SAY_BYTES), _TO[body[2]])
        case 133:
            return Signalled(_USER.unpack_from(body)[0], _check_payload(body[2:], MAX_SIGNAL_BYTES))
        case 134:
            user, group = struct.unpack_from("<HH", body)
            return Joined(user, _strip_length(body[4:]).decode(), group)
        case 135:
            return Left(*_USER.unpack(body))
        case 136:
            reason = REASONS[body[0]] if body[0] < len(REASONS) else f"reason {body[0]}"
            return Refused(reason, body[1:].decode())
    raise _fault(f"a frame has the kind {kind}, which the server does not send")


def _read_pose(body: bytes) -> Pose:
    sequence, clock, flags = _POSE.unpack_from(body)
    offset = _POSE.size
    placed: list[Placed | None] = []
    for is_present in (True, flags & _LEFT, flags & _RIGHT):
        placed.append(_read_placed(body, offset) if is_present else None)
        offset += _PLACED.size * bool(is_present)
    pointer = None
    if flags >> _POINTER_SHIFT:
        # Undefined flag values raise IndexError here.
        number = (flags >> _POINTER_SHIFT) - 1
        pointer = Pointer(_POINTER_ORIGINS[number], *struct.unpack_from("<f", body, offset))
        offset += 4
        if placed[number] is None:
            raise _fault("a pointer begins at a missing hand")
        if not 0.0 <= pointer.length <= MAX_METRES:
            raise _fault("a pointer's length is out of range")
    head, left, right = placed
    if head is None or offset != len(body):
        raise _fault("a pose is too long")
    return Pose(sequence, clock, bool(flags & _ACKNOWLEDGED), bool(flags & _STOPS), head, left, right, pointer)


def _read_placed(body: bytes, offset: int) -> Placed:
    *position, x, y, z, w = _PLACED.unpack_from(body, offset)
    placed = Placed(np.array(position, np.float32), np.array([x, y, z, w]) / ONE)
    # NaN fails the comparison.
    if not all(abs(value) <= MAX_METRES for value in position):
        raise _fault("a position is out of range")
    if not MIN_NORM <= np.linalg.norm(placed.rotation) <= MAX_NORM:
        raise _fault("a rotation is not a unit quaternion")
    placed.position.flags.writeable = placed.rotation.flags.writeable = False
    return placed


def _frame(kind: int, body: bytes) -> bytes:
    return _HEADER.pack(kind, len(body)) + body


def _strip_length(data: bytes) -> bytes:
    """Return a byte string without its one-byte length prefix; nothing may follow it."""
    if len(data) != 1 + data[0]:
        raise _fault("a frame is too long")
    return data[1:]


def _check_payload(data: bytes, max_bytes: int) -> bytes:
    if len(data) > max_bytes:
        raise _fault("a payload is too long")
    return data


def _fault(sentence: str) -> RoomError:
    return RoomError("frame", f"expected valid frames from the server, got an invalid one: {sentence}")


def room_name(argument: str, value: str) -> str:
    """Return a room's name in Unicode's form C, as servers do; ValueError if it cannot be part of an address."""
    name = _text(argument, unicodedata.normalize("NFC", check.text(argument, value)))
    # Clients and proxies resolve dots as folders.
    if not name or "/" in name or name in (".", ".."):
        got = check.shortened(value)
        raise ValueError(f"{argument}: expected 1 to {MAX_NAME_BYTES} bytes without a slash, not . or .., got {got}")
    return name


def user_name(argument: str, value: str) -> str:
    """Check a user's name, which may be empty; ValueError for invisible characters: they make names look alike."""
    name = _text(argument, value)
    if any(unicodedata.category(letter) == "Cf" for letter in name):
        raise ValueError(f"{argument}: expected no invisible formatting characters, got {check.shortened(value)}")
    return name


def _text(argument: str, value: str) -> str:
    name = check.text(argument, value)
    if len(name.encode()) > MAX_NAME_BYTES:
        raise ValueError(f"{argument}: expected at most {MAX_NAME_BYTES} bytes of UTF-8, got {check.shortened(value)}")
    if any(unicodedata.category(letter) == "Cc" for letter in name):
        raise ValueError(f"{argument}: expected no control characters, got {check.shortened(value)}")
    return name


def parse_pose(names: tuple[str, str], position: ArrayLike, rotation: ArrayLike) -> Placed:
    """Convert the pose of a head or a hand; errors name the arguments by `names`."""
    point = check.vector(names[0], position)
    quaternion = check.array(names[1], rotation, columns=None, dtype=np.float64)
    if max(map(abs, point)) > MAX_METRES:
        raise ValueError(f"{names[0]}: expected coordinates within {MAX_METRES:g} m of the origin, got {point}")
    if quaternion.shape != (4,):
        raise ValueError(f"{names[1]}: expected a quaternion (x, y, z, w), got shape {quaternion.shape}")
    norm = float(np.linalg.norm(quaternion))
    # NaN fails the comparison.
    if not MIN_NORM <= norm <= MAX_NORM:
        raise ValueError(f"{names[1]}: expected a quaternion of length 1, got one of length {norm:g}")
    return Placed(np.array(point, np.float32), np.rint(quaternion / norm * ONE) / ONE)


def parse_hand(name: str, value: tuple[ArrayLike, ArrayLike] | None) -> Placed | None:
    """Convert the pose of a hand; None stays None."""
    if value is None:
        return None
    if not isinstance(value, tuple | list) or len(value) != 2:
        raise TypeError(f"{name}: expected a position and a quaternion, got {check.type_and_value(value)}")
    return parse_pose((name, name), *value)


def parse_pointer(ray: tuple[PointerOrigin, float] | None, left: Placed | None, right: Placed | None) -> Pointer | None:
    """Convert a pointer from its origin and length; None stays None. ValueError if its hand is missing."""
    if ray is None:
        return None
    if not isinstance(ray, tuple | list) or len(ray) != 2:
        raise TypeError(f"pointer: expected its origin and its length in metres, got {check.type_and_value(ray)}")
    begin, length = ray
    check.choice("pointer", begin, ("head", "left", "right"))
    if (begin == "left" and left is None) or (begin == "right" and right is None):
        raise ValueError(f"pointer: expected a hand as its origin, got {begin!r} without that hand's pose")
    return Pointer(begin, float(np.float32(check.in_range("pointer", length, 0.0, MAX_METRES))))
