"""Users of rooms in Python, with the real server."""

from __future__ import annotations

import asyncio
import pickle
import re
import socket
from pathlib import Path

import numpy as np
import pytest

import nearfar as nf
from nearfar._base.errors import Error
from nearfar.serve._server import Certificate, Server
from nearfar.serve._site import Site
from nearfar.stream.client import (
    Ended,
    Joined,
    Left,
    Placed,
    Pointer,
    Posed,
    RoomError,
    Said,
    Settled,
    Signalled,
    User,
    join,
)
from tests.support import need
from tests.support.room_cases import REST, run, server as served, some, until

need("aiohttp")

CHECKOUT = Path(__file__).resolve().parents[2]


async def test_users_see_present_users(server: Server) -> None:
    async with join(server.url, room="who", name="Ada é", group=3) as ada:
        assert ada.users == {}
        async with join(server.url, room="who", name="Grace") as grace:
            assert grace.users == {ada.user: User(ada.user, "Ada é", 3)}
            assert await anext(grace) == Joined(ada.user, "Ada é", 3)
            assert await anext(ada) == Joined(grace.user, "Grace", 0)
            assert ada.users == {grace.user: User(grace.user, "Grace", 0)}
            assert ada.user != grace.user
        assert await anext(ada) == Left(grace.user)
        assert ada.users == {}
        with pytest.raises(RoomError, match=r"\(bye\)"):
            await grace.pose((0.0, 1.7, 0.0))
        assert [type(event) async for event in grace] == [Ended]


async def test_rooms_and_groups_are_separate(server: Server) -> None:
    async with (
        join(server.url, room="hall", group=1) as one,
        join(server.url, room="hall", group=1) as two,
        join(server.url, room="hall", group=2) as three,
        join(server.url, room="yard", group=1) as four,
    ):
        assert (len(one.users), len(four.users)) == (2, 0)
        await one.pose((1.0, 2.0, 3.0))
        await one.say(b"to the group")
        await one.say(b"to the room", to="room")
        assert (await until(two, Posed)).user == one.user
        heard: list[object] = [await anext(three)]
        while not isinstance(heard[-1], Said):
            heard.append(await anext(three))
        assert not [event for event in heard if isinstance(event, Posed)]
        assert heard[-1] == Said(one.user, b"to the room", "room")
        await four.say(b"in another room", to="room")
        await two.say(b"end", to="room")
        assert (await until(three, Said)).data == b"end"


async def test_poses_arrive_unchanged(server: Server) -> None:
    rng = np.random.default_rng(5)
    turns = rng.normal(size=(3, 4))
    turns /= np.linalg.norm(turns, axis=1)[:, None]
    places = rng.uniform(-1e6, 1e6, (3, 3)).astype(np.float32)

    def is_same(found: Placed | None, number: int) -> None:
        assert found is not None
        np.testing.assert_array_equal(found.position, places[number])
        # Half a step, and the rounding of float64.
        np.testing.assert_allclose(found.rotation, turns[number], rtol=0, atol=0.5 / 32767 + 1e-12)

    async with join(server.url, room="poses") as one, join(server.url, room="poses") as two:
        left, right = (places[1], turns[1]), (places[2].tolist(), tuple(turns[2]))
        for pointer in (None, ("head", 20.0), ("left", 0.0), ("right", 3.3)):
            number = await one.pose(places[0], turns[0], left=left, right=right, pointer=pointer, stops=True)
            event = await until(two, Posed)
            assert (event.user, event.pose.sequence) == (one.user, number)
            for place, expected in ((event.pose.head, 0), (event.pose.left, 1), (event.pose.right, 2)):
                is_same(place, expected)
            shown = None if pointer is None else Pointer(pointer[0], float(np.float32(pointer[1])))
            assert event.pose.pointer == shown
            assert event.pose.stops
            assert not event.pose.is_acknowledged
        first = event.pose
        await one.pose(places[0])
        event = await until(two, Posed)
        assert (event.pose.left, event.pose.right, event.pose.pointer) == (None, None, None)
        assert event.pose.head.rotation.tolist() == list(REST)
        assert (event.pose.sequence, event.pose.clock > first.clock) == (first.sequence + 1, True)


async def test_all_users_receive_messages_in_the_same_order(server: Server) -> None:
    async with (
        join(server.url, room="talk") as one,
        join(server.url, room="talk") as two,
        join(server.url, room="talk") as three,
        join(server.url, room="talk") as four,
    ):

        async def speak(room: nf.stream.client.Room) -> None:
            for number in range(40):
                await room.say(bytes([number]), to="room")

        await asyncio.gather(speak(one), speak(two))
        heard = await some(three, Said, 80)
        assert heard == await some(four, Said, 80)
        for user in (one.user, two.user):
            assert [event.data[0] for event in heard if event.user == user] == list(range(40))
        assert {event.to for event in heard} == {"room"}
        await one.say(bytes(4096))
        assert await until(two, Said, lambda event: event.to == "group") == Said(one.user, bytes(4096), "group")


async def test_signals_reach_one_user(server: Server) -> None:
    async with (
        join(server.url, room="signals", group=1) as one,
        join(server.url, room="signals", group=2) as two,
        join(server.url, room="signals", group=2) as three,
    ):
        await one.signal(two.user, memoryview(bytes(16000)))
        assert await until(two, Signalled) == Signalled(one.user, bytes(16000))
        await one.signal(12345 if one.user != 12345 else 1, b"to nobody")
        await one.say(b"end", to="room")
        events = [await anext(three)]
        while not isinstance(events[-1], Said):
            events.append(await anext(three))
        assert not [event for event in events if isinstance(event, Signalled)]


async def test_round_trips_end_when_the_whole_group_has_acknowledged(server: Server) -> None:
    async with join(server.url, room="trips", group=1) as one:
        # No user is present to acknowledge it.
        await one.pose((0.0, 0.0, 0.0), acknowledged=True)
        async with join(server.url, room="trips", group=1), join(server.url, room="trips", group=2):
            await until(one, Joined)
            for count in range(1, 4):
                await one.pose((0.0, 0.0, 0.0))
                number = await one.pose((0.0, 0.0, 0.0), acknowledged=True)
                settled = await until(one, Settled)
                assert settled.sequence == number
                assert one.round_trips.shape == (count,)
                assert one.round_trips[-1] == settled.seconds >= 0.0


def test_a_self_signed_certificate_is_trusted_if_specified(tmp_path_factory: pytest.TempPathFactory) -> None:
    used = Certificate.self_signed(tmp_path_factory.mktemp("certificate"), ["localhost", "127.0.0.1"])

    async def script(url: str) -> None:
        async with (
            join(url, room="hall", certificate=used.certificate) as one,
            join(url.replace("https", "wss"), room="hall", certificate=used.certificate) as two,
        ):
            assert list(two.users) == [one.user]
        with pytest.raises(RoomError, match="certificate= takes") as refused:
            async with join(url, room="hall"):
                pass
        assert refused.value.reason == "unreached"

    with served(certificate=used) as encrypted:
        run(script(encrypted.url))


def test_missing_servers_and_servers_without_rooms_are_reported() -> None:
    async def script(url: str) -> RoomError:
        with pytest.raises(RoomError) as refused:
            async with join(url, room="hall"):
                pass
        return refused.value

    with Server({"": Site({"a.txt": b"a"}, has_page=False)}) as without:
        assert "it has no rooms" in run(script(without.url)).sentence
    # A port on which nothing listens, reserved for this test.
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        error = run(script(f"http://127.0.0.1:{taken.getsockname()[1]}/"))
    assert (error.reason, "cannot be reached" in str(error)) == ("gone", True)
    assert isinstance(error, Error)
    again = pickle.loads(pickle.dumps(error))
    assert (str(again), again.reason, again.sentence) == (str(error), error.reason, error.sentence)


def test_payloads_have_a_maximum_length() -> None:
    room = join("http://127.0.0.1:8080/", room="hall")
    with pytest.raises(ValueError, match="data: expected at most 4,096 bytes"):
        run(room.say(bytes(4097)))
    with pytest.raises(ValueError, match="data: expected at most 16,384 bytes"):
        run(room.signal(1, bytes(16385)))
    with pytest.raises(RoomError, match="expected a user who has joined"):
        _ = room.user


def test_the_documented_script_joins_and_receives(server: Server, capsys: pytest.CaptureFixture[str]) -> None:
    page = (CHECKOUT / "docs" / "rooms.md").read_text(encoding="utf-8")
    (script,) = re.findall(r"```python\n(.*?)```", page, re.DOTALL)
    assert sum(bool(line) for line in script.splitlines()) <= 12

    async def grace() -> None:
        async with join(server.url, room="hall", name="Grace") as room:
            running = asyncio.create_task(
                asyncio.to_thread(exec, script.replace("http://127.0.0.1:8080/", server.url), {})
            )
            joined = await until(room, Joined)
            assert joined.name == "Ada"
            heard = [await anext(room), await anext(room)]
            assert Said(joined.user, b"hello", "room") in heard
            (seen,) = (event for event in heard if isinstance(event, Posed))
            assert seen.pose.pointer == Pointer("head", 20.0)
            await room.say(b"hello Ada")
            await running
            assert await anext(room) == Left(joined.user)

    run(grace())
    told = capsys.readouterr().out
    assert "Joined(user=" in told
    assert "data=b'hello Ada', to='group')" in told


def test_using_a_room_outside_its_block_is_an_error() -> None:
    room = join("http://127.0.0.1:1/", room="hall")
    for used in (room.say(b"x"), room.signal(1, b"x"), room.pose((0.0, 0.0, 0.0)), anext(room)):
        with pytest.raises(RoomError, match="async with"):
            run(used)
