"""Limits of a server and of its rooms, and the keys that sign tokens and tickets of rooms."""

from __future__ import annotations

import os
import secrets
import time
from dataclasses import dataclass, field

from nearfar import _core
from nearfar._base import check, files
from nearfar.stream._room_frames import room_name

KEY_BYTES = 16
"""Least size of a key, bytes."""

_NEW_KEY_BYTES = 32
_MAX_COUNT = 2**20
_MAX_RATE = 1e9
_MAX_SECONDS = 86400.0
_MAX_HOURS = 24.0 * 366


@dataclass(frozen=True)
class Limits:
    """Limits on connections and regions, and timeouts for clients."""

    connections: int = 1024
    """Greatest number of connections; further ones wait until one ends."""
    per_client: int = 256
    """Greatest number of connections per address; further ones are closed at once. Local programs are exempt."""
    header_bytes: int = 1 << 15
    """Greatest size in bytes of a request's target and headers, where each header counts 32 more; at least 8192."""
    header_seconds: float = 30.0
    """Timeout for a handshake, for the headers of a request, and between two requests of a connection."""
    silent_seconds: float = 60.0
    """Timeout for a client that reads nothing of a response."""
    grace_seconds: float = 3.0
    """Time for open responses to finish when the server closes."""
    regions: int = 64
    """Greatest number of a scene's regions in progress; further requests are refused with 503."""
    regions_per_client: int = 4
    """Greatest number of a scene's regions in progress per address; further requests are refused with 429."""
    threads: int = 2
    """Threads that make regions of a scene. The first one makes only coarse maps."""
    memory_bytes: int = 256 << 20
    """Bytes of a scene's regions that may stay in memory if they cannot be written to disk."""

    def __post_init__(self) -> None:
        for name in ("connections", "per_client", "regions", "regions_per_client"):
            check.integer(name, getattr(self, name), 1, _MAX_COUNT)
        # Smaller limits would reject the headers that browsers send.
        check.integer("header_bytes", self.header_bytes, 1 << 13, 1 << 20)
        for name in ("header_seconds", "silent_seconds"):
            check.in_range(name, getattr(self, name), 0.01, _MAX_SECONDS)
        check.in_range("grace_seconds", self.grace_seconds, 0.0, _MAX_SECONDS)
        check.integer("threads", self.threads, 1, 256)
        check.integer("memory_bytes", self.memory_bytes, 0, 1 << 62)


@dataclass(frozen=True)
class Rooms:
    """Limits on rooms and users, and on the traffic of each user; docs/rooms.md describes each.

    ValueError that names a value out of range, and for tokens without a key.
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
    """Secret bytes that sign tokens, and tickets that restore users' numbers after a restart of the server; None for a
    random key that is lost when the server ends."""
    needs_token: bool = False
    """Whether users need a token made by `token` with the same key."""
    peers: bool = True
    """Whether pages may exchange files among themselves."""
    datagrams: bool = True
    """Whether users may connect by WebTransport, at the server's port over UDP or the next free one."""

    def __post_init__(self) -> None:
        # Numbers of users have 16 bits, and one must stay free.
        check.integer("users", self.users, 1, 2**16 - 2)
        for name in ("rooms", "sockets_per_client", "rooms_per_client"):
            check.integer(name, getattr(self, name), 1, _MAX_COUNT)
        # Smaller limits would reject the largest signal.
        for name in ("message_bytes", "queue_bytes"):
            check.integer(name, getattr(self, name), 1 << 15, 1 << 24)
        for name in ("messages_per_second", "bytes_per_second", "said_bytes_per_second", "poses_per_second"):
            check.in_range(name, getattr(self, name), 1.0, _MAX_RATE)
        for name in ("burst_seconds", "hello_seconds", "ping_seconds", "silent_seconds", "linger_seconds"):
            check.in_range(name, getattr(self, name), 0.01, _MAX_SECONDS)
        for name in ("peers", "datagrams"):
            check.flag(name, getattr(self, name))
        if self.key is not None:
            _check_key("key", self.key)
        if check.flag("needs_token", self.needs_token) and self.key is None:
            raise ValueError("needs_token: expected a key as well, got none")


def token(room: str, key: bytes, *, hours: float = 24.0) -> str:
    """Make a token that admits one user at a time to the named room of a server with the same key.

    The token is valid for `hours` from now on; users who are in the room when it expires may stay. ValueError for an
    invalid room name, a short key, and times outside (0, 366 days]; TypeError if an argument has another type.
    """
    name, secret = room_name("room", room), _check_key("key", key)
    if check.in_range("hours", hours, 0.0, _MAX_HOURS) == 0.0:
        raise ValueError("hours: expected more than 0, got 0")
    # Rounded up to whole seconds, so that a short validity does not expire at once.
    ends = int(time.time() + 3600.0 * hours) + 1
    return _core.room_token(name, ends, secrets.token_bytes(16), secret)


def read_key(path: str | os.PathLike[str]) -> bytes:
    """Read a key from a file; ValueError if it is too short, OSError if it cannot be read."""
    file = check.path("path", path)
    return _check_key(str(file), file.read_bytes())


def ensure_key(path: str | os.PathLike[str]) -> bytes:
    """Read a key from a file; if there is none, first generate one that only its owner can read.

    ValueError if the file is too short for a key, OSError if it can be neither read nor written.
    """
    file = check.path("path", path)
    if not file.exists():
        file.parent.mkdir(parents=True, exist_ok=True)
        files.write_with_mode(file, secrets.token_bytes(_NEW_KEY_BYTES), 0o600)
    return read_key(file)


def _check_key(name: str, key: bytes) -> bytes:
    secret = check.instance(name, key, bytes, "bytes")
    if len(secret) < KEY_BYTES:
        raise ValueError(f"{name}: expected a key of {KEY_BYTES} bytes or more, got {len(secret)}")
    return secret
