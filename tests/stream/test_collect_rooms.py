"""Simulated users of the sphere collection on the real server: groups, scores, a new conductor, malformed messages."""

from __future__ import annotations

import asyncio
from collections.abc import Iterator
from typing import Any

import pytest

from nearfar.serve._server import Server
from nearfar.stream.client import Joined, Room, Said, join
from nearfar.stream.collect import Outcome, Person, Settings, play
from nearfar.stream.collect._messages import MARK, Score, Stage, read
from tests.support import need
from tests.support.room_cases import run, server as served, until

need("aiohttp")

QUICK = Settings(hold=0.05, pause=0.05, rest=0.05, radius=1.5, speeds=(0.0, 0.0, 0.0), duration=3000.0)
HASTY = Person(reaction=0.0, reaction_spread=0.0, intercept=0.0, slope=0.01, lapses=0.0)


@pytest.fixture(scope="module")
def server() -> Iterator[Server]:
    with served() as running:
        yield running


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


def test_four_users_collect_and_continue_without_their_conductor(server: Server) -> None:
    async def script() -> None:
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

    run(script())


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
