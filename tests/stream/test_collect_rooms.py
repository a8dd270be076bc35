"""Simulated users of the sphere collection on the real server, and in a room with scripted events."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Callable
from typing import Any, cast

import numpy as np

from nearfar._camera.camera import orientation_of
from nearfar.serve._server import Server
from nearfar.stream._room import Room
from nearfar.stream._room_events import Ended, Event, Joined, Left, Placed, Pointer, Pose, Posed, Said, User
from nearfar.stream.client import join
from nearfar.stream.collect import Outcome, Person, Settings, play
from nearfar.stream.collect._messages import MARK, Score, Stage, read, write
from nearfar.stream.collect._play import _User
from tests.support.room_cases import run, until

QUICK = Settings(hold=0.05, pause=0.05, rest=0.05, radius=1.5, speeds=(0.0, 0.0, 0.0), duration=3000.0)
HASTY = Person(reaction=0.0, reaction_spread=0.0, intercept=0.0, slope=0.01, lapses=0.0)


async def simulated(url: str, room: str, group: int, seed: int, settings: Settings) -> list[Outcome]:
    async with join(url, room=room, group=group) as place:
        return await play(place, settings, person=HASTY, seed=seed)


async def score(watcher: Room, spheres: int, group: int, but: int = -1) -> tuple[int, Score]:
    """The next score of a group with at least so many spheres, and its sender, other than the excluded user."""

    def is_wanted(event: Said) -> bool:
        sender = watcher.users.get(event.user)
        message = read(event.data) if event.data[:1] == bytes([MARK]) else None
        is_theirs = sender is not None and sender.group == group and event.user != but
        return is_theirs and isinstance(message, Score) and message.spheres >= spheres

    event = await until(watcher, Said, is_wanted)
    message = read(event.data)
    assert isinstance(message, Score)
    assert event.to == "room"
    return event.user, message


async def cancelled(*tasks: asyncio.Task[Any]) -> None:
    for task in tasks:
        task.cancel()
    await asyncio.wait(tasks)


async def test_four_users_collect_and_continue_without_their_conductor(server: Server) -> None:
    async with join(server.url, room="four", group=9) as watcher:
        playing: dict[int, asyncio.Task[Any]] = {}
        for seed in range(4):
            task = asyncio.create_task(simulated(server.url, "four", 1, seed, QUICK))
            playing[(await until(watcher, Joined)).user] = task
        # A user that sends malformed messages in another group does not disturb this one.
        await watcher.say(bytes([MARK, 1, 1, 0]), to="room")
        conductor, first = await score(watcher, 2, 1)
        assert conductor == min(playing)
        await cancelled(playing.pop(conductor))
        other, later = await score(watcher, first.spheres + 1, 1, but=conductor)
        assert other == min(playing)
        assert later.stage == first.stage == Stage(1, 1)
        assert all(not task.done() for task in playing.values())
        await cancelled(*playing.values())


def test_two_groups_play_concurrently_to_the_end(server: Server) -> None:
    short = Settings(users=2, trials=2, duration=0.5, hold=0.05, pause=0.05, rest=0.05, radius=1.5)

    async def script() -> list[list[Outcome]]:
        return await asyncio.gather(
            *(simulated(server.url, "two", group, 10 * group + user, short) for group in (1, 2) for user in range(2))
        )

    found = run(script())
    for one, other in (found[:2], found[2:]):
        assert [outcome.trial for outcome in one] == [1, 2]
        for own, heard in zip(one, other, strict=True):
            assert [sphere.level for sphere in own.spheres] == [sphere.level for sphere in heard.spheres]
            assert [sphere.misses for sphere in own.spheres] == [sphere.misses for sphere in heard.spheres]
    assert [outcome.group for outcome in (*found[0], *found[2])] == [1, 1, 2, 2]


# A simulated user in a room with scripted events ----------------------------------------------------------------------
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
