"""Client of a server's rooms for scripts and notebooks: joins a room, sends poses and messages, receives events."""

from __future__ import annotations

import os

from nearfar.stream._room import Room
from nearfar.stream._room_events import (
    Ended,
    Joined,
    Left,
    Placed,
    Pointer,
    Pose,
    Posed,
    RoomError,
    Said,
    Settled,
    Signalled,
    User,
)

__all__ = [
    "Ended",
    "Joined",
    "Left",
    "Placed",
    "Pointer",
    "Pose",
    "Posed",
    "Room",
    "RoomError",
    "Said",
    "Settled",
    "Signalled",
    "User",
    "join",
]


def join(
    url: str,
    *,
    room: str,
    name: str = "",
    group: int = 0,
    token: str | None = None,
    reconnect: bool = True,
    certificate: str | os.PathLike[str] | None = None,
) -> Room:
    """Join a room of a server when an `async with` block begins, and leave it when the block ends.

    Entering the block raises RoomError with the server's reason if joining fails. Leaving it waits at most 5 s for the
    server to confirm that the user's seat is free for another connection with the same token. ValueError for an
    invalid server address, invalid names of a room or a user, groups outside 0 to 65,535, and a file without a
    certificate; ImportError if aiohttp is not installed (`pip install "nearfar[stream]"`); OSError if the certificate
    file cannot be read.

    Parameters
    ----------
    url
        Address of the server, such as http://127.0.0.1:8080/.
    room
        The room's name.
    name
        Name that other users see, at most 64 bytes of UTF-8.
    group
        Group to join; poses are sent only to the group.
    token
        Token from `nearfar invite`, if the server needs one.
    reconnect
        Whether to reconnect with the same user number after the connection broke or the server ended.
    certificate
        PEM file with a certificate to trust, such as a server's self-signed one.
    """
    return Room(url, room=room, name=name, group=group, token=token, reconnect=reconnect, certificate=certificate)
