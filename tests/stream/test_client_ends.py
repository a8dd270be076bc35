"""Connections to rooms that end: by the server, within a message, by malformed data; and reconnection."""

from __future__ import annotations

import asyncio

import numpy as np
import pytest

from nearfar.serve._limits import Rooms
from nearfar.serve._server import Server
from nearfar.stream import _room, _room_frames as frames
from nearfar.stream._room_connection import Address, Connection
from nearfar.stream._room_events import MAX_BYTES, MAX_EVENTS, Event, Inbox, Left, Placed, Pose, Posed, RoundTrips, Said
from nearfar.stream.client import Ended, Joined, RoomError, Settled, join
from tests.support import need
from tests.support.room_cases import KEY, REST, answers, run, server as served, until, wire

need("aiohttp")

GARBAGE = [
    b"\xff" * 9,
    frames.hello(0, "a user's frame", b""),
    b"\x87\x02\x00",
    b"\x82\x23\x00" + bytes(35),
]


async def test_users_reconnect_with_their_numbers_after_a_restart() -> None:
    first = served(Rooms(key=KEY))
    async with (
        wire(first.url) as way,
        join(way.url, room="hall", name="Ada") as ada,
        join(way.url, room="hall", name="Grace") as grace,
    ):
        numbers = (ada.user, grace.user)
        sequence = await ada.pose((0.0, 0.0, 0.0))
        way.lead_to(None)
        # In a thread, so that users can answer.
        await asyncio.to_thread(first.close)
        for room in (ada, grace):
            end = await until(room, Ended)
            assert (end.reason, end.sentence, end.returns) == ("ending", "the server is shutting down", True)
        said = asyncio.create_task(ada.say(b"as soon as it is possible", to="room"))
        # It has no recipient, and nothing waits for it.
        assert await ada.pose((0.0, 0.0, 0.0)) == sequence + 1
        second = served(Rooms(key=KEY))
        way.lead_to(second.url)
        assert (await until(ada, Joined)).name == "Grace"
        assert (await until(grace, Joined)).name == "Ada"
        assert (ada.user, grace.user) == numbers
        await said
        await ada.say(b"again")
        await until(grace, Said, lambda event: event.data == b"again")
        number = await ada.pose((0.0, 0.0, 0.0), acknowledged=True)
        assert (await until(grace, Posed)).pose.sequence == number
        assert (await until(ada, Settled)).sequence == number
        await asyncio.to_thread(second.close)


async def test_a_user_disconnected_within_a_message_reconnects_visibly(server: Server) -> None:
    async with (
        wire(server.url) as way,
        join(server.url, room="cut", name="Grace") as grace,
        join(way.url, room="cut", name="Ada") as ada,
    ):
        number = ada.user
        assert (await until(grace, Joined)).user == number
        way.left = 100
        await grace.say(bytes(4000))
        end = await until(ada, Ended)
        assert (end.reason, end.returns) == ("gone", True)
        # The server may notice the end before the return, or through it.
        assert (await until(grace, Left)).user == number
        assert (await until(grace, Joined)).user == number
        assert (await until(ada, Joined)).name == "Grace"
        assert ada.user == number
        await grace.say(b"are you there?")
        heard = await until(ada, Said)
        assert heard.data == b"are you there?"


async def test_without_reconnection_the_end_is_the_last_event(server: Server) -> None:
    async with wire(server.url) as way, join(way.url, room="last", reconnect=False) as ada:
        way.cut()
        events = [event async for event in ada]
        assert events == [Ended("gone", "the connection broke off", returns=False)]
        for sent in (ada.pose((0.0, 0.0, 0.0)), ada.say(b"data"), ada.signal(1, b"data")):
            with pytest.raises(RoomError, match=r"\(gone\): the connection broke off"):
                await sent


async def test_a_second_connection_of_a_user_replaces_the_first(server: Server) -> None:
    async with join(server.url, room="twice") as ada:
        other = Connection(Address.build(server.url, "twice", None, None))
        await other.open()
        await other.send(frames.hello(0, "Ada again", ada._ticket))
        events = [event async for event in ada]
        assert isinstance(events[-1], Ended)
        assert (events[-1].reason, events[-1].returns) == ("replaced", False)
        await other.close()


@pytest.mark.parametrize("garbage", GARBAGE, ids=["noise", "a user's frame", "half a frame", "no pose"])
async def test_malformed_frames_end_the_connection_with_a_message(garbage: bytes) -> None:
    async with answers([garbage]) as url, join(url, room="hall") as ada:
        assert ada.user == 1
        (end,) = [event async for event in ada]
        assert isinstance(end, Ended)
        assert (end.reason, end.returns) == ("frame", False)
        assert "expected valid frames from the server" in end.sentence


async def test_a_name_refused_by_the_server_is_reported(server: Server) -> None:
    room = join(server.url, room="hall")
    # It is refused by the client, too, before anything is sent.
    room._name = "a\nb"
    with pytest.raises(RoomError) as refused:
        async with room:
            pass
    assert refused.value.reason == "frame"
    assert refused.value.sentence == "a name has characters that control or format text"


async def test_a_server_that_does_not_answer_is_reported(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(_room, "ENTRY_TIMEOUT", 0.01)
    held: list[asyncio.StreamWriter] = []
    async with await asyncio.start_server(lambda _, writer: held.append(writer), "127.0.0.1", 0) as mute:
        with pytest.raises(RoomError, match="did not admit the user within") as refused:
            async with join(f"http://127.0.0.1:{mute.sockets[0].getsockname()[1]}/", room="hall"):
                pass
        assert refused.value.reason == "silent"
        for writer in held:
            writer.close()


def _pose(sequence: int) -> Pose:
    return Pose(sequence, 0, False, False, Placed(np.zeros(3, np.float32), np.array(REST)))


def test_a_queued_pose_is_replaced_by_a_newer_one() -> None:
    async def script() -> list[Event | None]:
        inbox = Inbox()
        for event in (Posed(1, _pose(1)), Said(1, b"a", "group"), Posed(2, _pose(1)), Posed(1, _pose(2)), Left(2)):
            inbox.add(event)
        inbox.end()
        return [await inbox.take() for _ in range(4)]

    assert run(script()) == [Posed(1, _pose(2)), Said(1, b"a", "group"), Left(2), None]


def test_unread_events_are_dropped_for_newer_ones() -> None:
    inbox = Inbox()
    for number in range(MAX_EVENTS + 3):
        inbox.add(Left(number))
    assert inbox.dropped == 3
    assert run(inbox.take()) == Left(3)
    count = MAX_BYTES // 4096 + 2
    for _ in range(count):
        inbox.add(Said(1, bytes(4096), "room"))
    # All earlier events are dropped, and then two of these.
    assert inbox.dropped == 3 + (MAX_EVENTS - 1) + 2
    assert run(inbox.take()) == Said(1, bytes(4096), "room")


def test_poses_are_acknowledged_with_later_ones() -> None:
    trips = RoundTrips()
    for sequence, now in ((1, 0.5), (3, 1.0), (4, 1.5)):
        trips.send(sequence, now)
    assert trips.settle(3, 2.0) == [Settled(1, 1.5), Settled(3, 1.0)]
    assert trips.settle(3, 2.5) == []
    trips.forget()
    assert trips.settle(9, 3.0) == []
    assert trips.seconds.tolist() == [1.5, 1.0]
