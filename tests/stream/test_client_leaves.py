"""Users who leave rooms: their seats are free as soon as the block has ended, whatever the server does."""

from __future__ import annotations

import asyncio
import itertools
from collections.abc import Iterator
from contextlib import suppress

import pytest

from nearfar.serve._limits import Rooms, token
from nearfar.serve._server import Server
from nearfar.stream import _room, _room_connection
from nearfar.stream.client import Ended, Joined, Left, RoomError, Said, join
from tests.support import need
from tests.support.room_cases import HANGS, KEY, answers, server as served, until, wire

need("aiohttp")

ROUNDS = 25
LATE = 5e-3
"""Seconds by which the first connection to the server is slower than the second."""


@pytest.fixture(scope="module")
def server() -> Iterator[Server]:
    with served(Rooms(key=KEY, needs_token=True)) as running:
        yield running


@pytest.fixture(autouse=True)
def is_waited_for(monkeypatch: pytest.MonkeyPatch) -> None:
    """Make users wait until the server has closed, however slow the machine is."""
    monkeypatch.setattr(_room_connection, "CLOSE_TIMEOUT", 2 * HANGS)


@pytest.fixture
def is_not_waited_for(is_waited_for: None, monkeypatch: pytest.MonkeyPatch) -> None:
    """Make users wait only briefly for a server that never closes."""
    monkeypatch.setattr(_room_connection, "CLOSE_TIMEOUT", 0.05)


async def test_a_user_who_left_over_a_slow_connection_can_enter_over_a_fast_one(server: Server) -> None:
    given = token("hall", KEY)
    async with wire(server.url, LATE) as slow:
        for _ in range(ROUNDS):
            async with join(slow.url, room="hall", token=given):
                # It begins to read.
                await asyncio.sleep(0)
            async with join(server.url, room="hall", token=given):
                pass


async def test_a_user_who_cancelled_entering_or_leaving_can_enter_again(server: Server) -> None:
    given = token("hall", KEY)
    async with wire(server.url, LATE) as slow:
        for number in range(ROUNDS):
            # Entering takes two delays, leaving one.
            with suppress(TimeoutError):
                async with asyncio.timeout(4 * LATE * number / ROUNDS), join(slow.url, room="hall", token=given):
                    pass
            async with join(server.url, room="hall", token=given):
                pass


async def test_a_user_not_admitted_in_time_can_enter_again(server: Server, monkeypatch: pytest.MonkeyPatch) -> None:
    given = token("hall", KEY)
    async with wire(server.url, LATE) as slow:
        for number in range(ROUNDS):
            with monkeypatch.context() as short:
                short.setattr(_room, "ENTRY_TIMEOUT", 4 * LATE * number / ROUNDS)
                with suppress(RoomError):
                    async with join(slow.url, room="hall", token=given):
                        pass
            async with join(server.url, room="hall", token=given):
                pass


async def test_a_user_who_leaves_while_reconnecting_can_enter_again(
    server: Server, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(_room, "RECONNECT_PAUSES", (1e-3, 1e-3))
    given = token("hall", KEY)
    async with wire(server.url, LATE) as slow, join(server.url, room="hall", token=token("hall", KEY)) as other:
        for number in range(ROUNDS):
            async with join(slow.url, room="hall", token=given) as user:
                slow.cut()
                # Nothing else shows when the server knows of it.
                await until(other, Left)
                await asyncio.sleep(4 * LATE * number / ROUNDS)
            async with join(server.url, room="hall", token=given) as user:
                await until(other, Joined, lambda event: event.user == user.user)
            await until(other, Left, lambda event: event.user == user.user)


async def test_leaving_does_not_wait_for_a_broken_connection(server: Server) -> None:
    async with wire(server.url) as way, join(way.url, room="hall", token=token("hall", KEY)) as user:
        way.cut()
        assert (await until(user, Ended)).reason == "gone"


async def test_a_user_cancelled_while_leaving_has_left(server: Server) -> None:
    given = token("hall", KEY)
    async with wire(server.url, LATE) as slow:
        is_leaving = asyncio.Event()

        async def leave() -> None:
            async with join(slow.url, room="hall", token=given):
                is_leaving.set()

        leaving = asyncio.create_task(leave())
        await is_leaving.wait()
        for _ in range(3):
            leaving.cancel()
            await asyncio.sleep(0)
        with pytest.raises(asyncio.CancelledError):
            await leaving
        async with join(server.url, room="hall", token=given):
            pass


@pytest.mark.usefixtures("is_not_waited_for")
async def test_leaving_a_server_that_never_closes(server: Server) -> None:
    async with wire(server.url) as way, join(way.url, room="hall", token=token("hall", KEY)):
        way.passes.clear()


@pytest.mark.usefixtures("is_not_waited_for")
async def test_leaving_a_server_that_does_not_read(server: Server) -> None:
    async with wire(server.url) as way, join(way.url, room="hall", token=token("hall", KEY)) as user:
        way.passes.clear()

        async def speak() -> None:
            while True:
                await user.say(bytes(4096))

        with suppress(TimeoutError):
            await asyncio.wait_for(speak(), 0.2)


@pytest.mark.usefixtures("is_not_waited_for")
async def test_leaving_a_server_that_never_stops_sending() -> None:
    said = bytes.fromhex("840310020000") + bytes(4096)
    async with answers(itertools.repeat(said)) as url, join(url, room="hall") as user:
        await until(user, Said)
