"""A simulated user in a room with scripted events: late poses, users who leave, changed numbers."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Callable
from typing import Any, cast

import numpy as np

from nearfar._camera.camera import orientation_of
from nearfar.stream._room import Room
from nearfar.stream._room_events import Ended, Event, Joined, Left, Placed, Pointer, Pose, Posed, Said, User
from nearfar.stream.collect import Person, Settings
from nearfar.stream.collect._messages import Score, Stage, write
from nearfar.stream.collect._play import _User


class ScriptedRoom:
    """A room that delivers scripted events; an action among them changes the room."""

    group, is_connected = 1, True

    def __init__(self, *events: Event | Callable[[ScriptedRoom], None]) -> None:
        self.user = 2
        self.users: dict[int, User] = {}
        self._events = events

    async def __aiter__(self) -> AsyncIterator[Event]:
        for event in self._events:
            if isinstance(event, Joined):
                self.users[event.user] = User(event.user, event.name, event.group)
            elif isinstance(event, Left):
                self.users.pop(event.user)
            if callable(event):
                event(self)
            else:
                yield event

    async def say(self, data: bytes, *, to: str) -> None:
        """Discard a message."""


def user_after(*events: Event | Callable[[ScriptedRoom], None]) -> Any:
    """A simulated user who has received all events."""

    async def script() -> _User:
        user = _User(cast("Room", ScriptedRoom(*events)), Settings(users=64), Person(), 0)
        await user.hear()
        return user

    return asyncio.run(script())


def pose_event(user: int, sequence: int, yaw: float, *, stops: bool = False) -> Posed:
    """A pose of a user who points along a yaw."""
    head = Placed(np.zeros(3, np.float32), np.array(orientation_of(yaw, 0.0)))
    return Posed(user, Pose(sequence, 0, False, stops, head, pointer=Pointer("head", 1.0)))


JOINED = Joined(7, "", 1)


def test_a_pose_older_than_the_last_one_moves_no_pointer() -> None:
    user = user_after(JOINED, pose_event(7, 5, 0.0, stops=True), pose_event(7, 4, 1.0))
    np.testing.assert_allclose(user._rays[7][1], (0.0, 0.0, -1.0), atol=1e-6)
    # A user with a new number starts at 1.
    user = user_after(JOINED, pose_event(7, 5, 1.0), Left(7), JOINED, pose_event(7, 1, 0.0))
    np.testing.assert_allclose(user._rays[7][1], (0.0, 0.0, -1.0), atol=1e-6)


def test_a_pose_of_an_absent_user_creates_no_pointer() -> None:
    assert user_after(JOINED, pose_event(7, 1, 0.0), Left(7), pose_event(7, 2, 0.0))._rays == {}


def test_messages_of_users_who_left_since_are_processed() -> None:
    """The room knows of users who left before their last messages are processed."""

    def leaves(room: ScriptedRoom) -> None:
        room.users.pop(7)

    said = Said(7, write(Score(Stage(1, 1), False, 3, 1)), "room")
    assert sorted(user_after(JOINED, leaves, said).task.scores) == [1]


def test_a_user_with_a_new_number_starts_afresh() -> None:
    def renamed(room: ScriptedRoom) -> None:
        room.user, room.users = 9, {}

    ended = Ended("gone", "the connection broke off", returns=True)
    before = user_after(JOINED, ended, JOINED)
    assert (before.task.user, before.task.present) == (2, {2, 7})
    after = user_after(JOINED, ended, renamed, JOINED)
    assert (after.task.user, after.task.present, after.task.conductor) == (9, {7, 9}, 7)


def test_a_groups_score_is_removed_with_its_last_user() -> None:
    said = Said(8, write(Score(Stage(1, 1), False, 3, 1)), "room")
    others = (Joined(8, "", 4), Joined(9, "", 4))
    assert sorted(user_after(*others, said, Left(8)).task.scores) == [4]
    assert sorted(user_after(*others, said, Left(8), Left(9)).task.scores) == []
