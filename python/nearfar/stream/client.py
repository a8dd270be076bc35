"""A user of a server's rooms, for scripts and notebooks: joins, poses, speaks, and hears of others."""

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

    When the block has ended, the user's seat is free for another connection with the same token. The end waits for the
    server's confirmation, at most 5 s.

    Parameters
    ----------
    url
        Address of the server, such as http://127.0.0.1:8080/.
    room
        The room's name.
    name
        The name that others are told, at most 64 bytes of UTF-8.
    group
        The group that the user joins: poses go to the group only.
    token
        A token of `nearfar invite`, if the server needs one.
    reconnect
        Whether the user returns by itself, with its number, after the connection broke off or the server ended.
    certificate
        File in PEM of a certificate to trust, such as that of a server that signs itself.

    Returns
    -------
    Room
        The user's place; entering the block raises RoomError with the server's reason if it cannot join.

    Raises
    ------
    ValueError
        For what is no address of a server, for names that a room or a user cannot have, for other groups than 0 to
        65,535, and for a file without a certificate.
    TypeError
        If an argument has another type.
    ImportError
        If aiohttp is not installed: `pip install "nearfar[stream]"`.
    OSError
        If the certificate's file cannot be read.
    """
    return Room(url, room=room, name=name, group=group, token=token, reconnect=reconnect, certificate=certificate)
