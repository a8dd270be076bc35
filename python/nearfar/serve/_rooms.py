"""Rooms of a server, and the keys that sign who may enter them."""

from __future__ import annotations

import os
import secrets
import time
from dataclasses import dataclass, field

from nearfar import _core
from nearfar._base import check, files
from nearfar.stream import _room_names

KEY_BYTES = 16
"""Fewest bytes of a key."""

_MADE_BYTES = 32
_MOST = 2**20
_MOST_RATE = 1e9
_MOST_SECONDS = 86400.0
_MOST_HOURS = 24.0 * 366


@dataclass(frozen=True)
class Rooms:
    """How many rooms and users a server takes, and how much it lets each user send.

    Parameters
    ----------
    rooms, users
        Rooms at the same time; users of a room at the same time.
    message_bytes
        Bytes of a message that a user sends.
    queue_bytes
        Bytes that wait for a user, besides poses; who lets more wait is closed.
    sockets_per_client, rooms_per_client
        Sockets of one client, and rooms that it has begun, at the same time. Programs on this machine may have all.
    messages_per_second, bytes_per_second, said_bytes_per_second
        Rates that a user may send at, and say and signal to others; who sends more is closed.
    poses_per_second
        Poses a second that others get; those beyond are dropped. As many besides may say that none follows.
    burst_seconds
        So much time's worth of messages, of bytes and of poses may come at once.
    hello_seconds
        Time from the beginning of a connection until its user is in the room.
    ping_seconds, silent_seconds
        Times without a byte of a user after which it is sent a ping, and after which it is gone.
    linger_seconds
        Time that a user gets to read why the server ends its connection.
    key
        Secret bytes that sign tickets, with which users get their numbers back after a restart, and tokens; None for
        random ones of this server alone.
    needs_token
        Whether users need a token that `token` made with the same key.
    peers
        Whether pages may exchange files among themselves.
    datagrams
        Whether users may connect by WebTransport, at the server's port of UDP or the next one that is free.

    Raises
    ------
    ValueError
        For a value outside its limits, which the message names, and for tokens without a key.
    TypeError
        If a value has another type.
    """

    rooms: int = 64
    users: int = 256
    sockets_per_client: int = 128
    rooms_per_client: int = 16
    message_bytes: int = 1 << 15
    queue_bytes: int = 1 << 17
    messages_per_second: float = 5000.0
    bytes_per_second: float = 131_072.0
    said_bytes_per_second: float = 32_768.0
    poses_per_second: float = 144.0
    burst_seconds: float = 2.0
    hello_seconds: float = 10.0
    ping_seconds: float = 10.0
    silent_seconds: float = 30.0
    linger_seconds: float = 2.0
    key: bytes | None = field(default=None, repr=False)
    needs_token: bool = False
    peers: bool = True
    datagrams: bool = True

    def __post_init__(self) -> None:
        check.integer("rooms", self.rooms, 1, _MOST)
        # Users have numbers of 16 bits, of which one is always free.
        check.integer("users", self.users, 1, 2**16 - 2)
        for name in ("sockets_per_client", "rooms_per_client"):
            check.integer(name, getattr(self, name), 1, _MOST)
        # Less would not hold the largest signal.
        check.integer("message_bytes", self.message_bytes, 1 << 15, 1 << 24)
        check.integer("queue_bytes", self.queue_bytes, 1 << 15, 1 << 24)
        for name in ("messages_per_second", "bytes_per_second", "said_bytes_per_second", "poses_per_second"):
            check.within(name, getattr(self, name), 1.0, _MOST_RATE)
        for name in ("burst_seconds", "hello_seconds", "ping_seconds", "silent_seconds", "linger_seconds"):
            check.within(name, getattr(self, name), 0.01, _MOST_SECONDS)
        for name in ("peers", "datagrams"):
            check.flag(name, getattr(self, name))
        if self.key is not None:
            _checked("key", self.key)
        if check.flag("needs_token", self.needs_token) and self.key is None:
            raise ValueError("needs_token: expected a key beside it")


def token(room: str, key: bytes, *, hours: float = 24.0) -> str:
    """Make a token that lets one user at a time into a room of a server that has the same key.

    Parameters
    ----------
    room
        The room's name.
    key
        The secret bytes.
    hours
        Time from now on after which nobody can enter with it; who is in the room then stays.

    Raises
    ------
    ValueError
        For what is no name of a room, for a short key, and for times outside (0, 366 days].
    TypeError
        If an argument has another type.
    """
    name, secret = _room_names.room("room", room), _checked("key", key)
    if check.within("hours", hours, 0.0, _MOST_HOURS) == 0.0:
        raise ValueError("hours: expected more than 0, got 0")
    # The end counts in whole seconds; a second more, so that a short time is not over at once.
    ends = int(time.time() + 3600.0 * hours) + 1
    return _core.room_token(name, ends, secrets.token_bytes(16), secret)


def read_key(path: str | os.PathLike[str]) -> bytes:
    """Read a key from a file; ValueError if it is too short, OSError if it cannot be read."""
    place = check.path("path", path)
    secret = place.read_bytes()
    if len(secret) < KEY_BYTES:
        raise ValueError(f"{place}: expected a key of {KEY_BYTES} bytes or more, got {len(secret)}")
    return secret


def kept_key(path: str | os.PathLike[str]) -> bytes:
    """Read a key from a file; make one first, which only its owner can read, if there is none.

    Raises
    ------
    ValueError
        If there is a file that is too short for a key.
    OSError
        If the file can be neither read nor written.
    """
    place = check.path("path", path)
    if not place.exists():
        place.parent.mkdir(parents=True, exist_ok=True)
        files.write_with_mode(place, secrets.token_bytes(_MADE_BYTES), 0o600)
    return read_key(place)


def _checked(name: str, key: bytes) -> bytes:
    secret = check.instance(name, key, bytes, "bytes")
    if len(secret) < KEY_BYTES:
        raise ValueError(f"{name}: expected {KEY_BYTES} bytes or more, got {len(secret)}")
    return secret
