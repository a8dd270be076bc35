"""Users of rooms without a server, for valid calls of `nf.stream.client` and `nf.stream.collect`."""

from __future__ import annotations

from typing import Any

from nearfar.stream import client
from nearfar.stream._room_connection import Address, Connection

URL = "http://127.0.0.1:1/"


class _Nowhere(Connection):
    """A connection whose messages go nowhere."""

    async def send(self, data: bytes) -> None:
        del data


class FinishedRoom(client.Room):
    """A room whose events have all been delivered."""

    async def __anext__(self) -> Any:
        raise StopAsyncIteration


def room(kind: type[client.Room] = client.Room) -> client.Room:
    """A user who is in a room."""
    made = kind(URL, room="hall")
    made._connection = _Nowhere(Address.build(URL, "hall", None, None))
    made._was_entered = True
    made._user = 1
    made._is_ready.set()
    return made
