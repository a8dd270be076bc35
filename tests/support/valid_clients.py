"""Valid calls of every public callable of `nf.stream.client` and `nf.stream.collect`."""

from __future__ import annotations

from typing import Any

import numpy as np

from nearfar.stream import client, collect
from nearfar.stream._room_connection import Address, Connection
from tests.support.valid_fields import fields
from tests.support.valid_objects import Valid

URL = "http://127.0.0.1:1/"

ROOM_CALLS = (
    *(f"nearfar.stream.client.{name}" for name in ("join", "Room", "Room.pose", "Room.say", "Room.signal")),
    "nearfar.stream.collect.play",
)
"""Callables that need aiohttp."""


class _Nowhere(Connection):
    """A connection whose messages go nowhere."""

    async def send(self, data: bytes) -> None:
        del data


class _Told(client.Room):
    """A room of which all has been told."""

    async def __anext__(self) -> Any:
        raise StopAsyncIteration


def room(kind: type[client.Room] = client.Room) -> client.Room:
    """A user who is in a room."""
    made = kind(URL, room="hall")
    made._connection = _Nowhere(Address.of(URL, "hall", None, None))
    made._was_entered = True
    made._user = 1
    made._there.set()
    return made


def clients(valid: Valid) -> dict[str, dict[str, Any]]:
    """Return valid keywords by the callable's name."""
    del valid
    head = client.Placed(np.zeros(3, np.float32), np.array([0.0, 0.0, 0.0, 1.0]))
    pointer = client.Pointer("head", 20.0)
    pose = client.Pose(1, 0, False, False, head, pointer=pointer)
    place = (np.zeros(3), np.array([0.0, 0.0, 0.0, 1.0]))
    joining: dict[str, Any] = {"url": URL, "room": "hall", "name": "Ada", "group": 1, "token": "1.2.3"}
    return {
        "nearfar.stream.client.Ended": {"reason": "bye", "sentence": "the user left", "returns": False},
        "nearfar.stream.client.Joined": {"user": 1, "name": "Ada", "group": 0},
        "nearfar.stream.client.Left": {"user": 1},
        "nearfar.stream.client.Placed": fields(head),
        "nearfar.stream.client.Pointer": fields(pointer),
        "nearfar.stream.client.Pose": fields(pose),
        "nearfar.stream.client.Posed": {"user": 1, "pose": pose},
        "nearfar.stream.client.Room": joining,
        "nearfar.stream.client.Room.pose": {
            "position": place[0], "rotation": place[1], "left": place, "right": place, "pointer": ("left", 3.0),
            "acknowledged": True,
        },
        "nearfar.stream.client.Room.say": {"data": b"hit", "to": "room"},
        "nearfar.stream.client.Room.signal": {"user": 1, "data": b"offer"},
        "nearfar.stream.client.Said": {"user": 1, "data": b"hit", "to": "group"},
        "nearfar.stream.client.Settled": {"sequence": 1, "seconds": 0.1},
        "nearfar.stream.client.Signalled": {"user": 1, "data": b"offer"},
        "nearfar.stream.client.User": {"number": 1, "name": "Ada", "group": 0},
        "nearfar.stream.client.join": joining,
        "nearfar.stream.collect.Collected": {"level": "easy", "seconds": 4.0, "misses": 0},
        "nearfar.stream.collect.Outcome": {"group": 1, "trial": 1, "spheres": ()},
        "nearfar.stream.collect.Person": fields(collect.Person()),
        "nearfar.stream.collect.Settings": fields(collect.Settings()),
        "nearfar.stream.collect.play": {
            "room": room(_Told), "settings": collect.Settings(), "person": collect.Person(),
        },
        "nearfar.stream.collect.simulate": {
            "settings": collect.Settings(users=1, trials=1, duration=0.1), "person": collect.Person(), "groups": 1,
            "leg": (0.01, 0.001),
        },
    }  # fmt: skip
