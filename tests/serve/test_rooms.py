"""Rooms of a server: admission by token, and limits."""

from __future__ import annotations

import stat
import time
from pathlib import Path

import pytest

from nearfar import _core
from nearfar.serve._limits import Rooms, ensure_key, read_key, token
from nearfar.serve._server import Server
from nearfar.serve._site import Site
from nearfar.stream.client import join
from tests.support import need
from tests.support.room_cases import KEY, is_refused, run, server as served

need("aiohttp")

NEEDS_TOKEN = Rooms(key=KEY, needs_token=True)


def test_entering_requires_a_valid_token() -> None:
    later = int(time.time()) + 3600
    made_for_this_room = "expected a token that was made for this room"

    async def script(server: Server) -> None:
        for given, sentence in [
            (None, made_for_this_room),
            ("", made_for_this_room),
            ("1.2&token=3", made_for_this_room),
            (token("yard", KEY), made_for_this_room),
            (token("hall", bytes(16)), made_for_this_room),
            (_core.room_token("hall", 1000, bytes(16), KEY), "expected a token that has not expired"),
        ]:
            error = await is_refused(server, token=given)
            assert (error.reason, error.sentence) == ("token", sentence)
        given = _core.room_token("hall", later, bytes(16), KEY)
        async with join(server.url, room="hall", token=given) as user:
            error = await is_refused(server, token=given)
            assert error.sentence == "expected a token that no other connection uses"
            async with join(server.url, room="hall", token=token("hall", KEY, hours=0.1)) as other:
                assert list(other.users) == [user.user]
        async with join(server.url, room="hall", token=given):
            pass

    with served(NEEDS_TOKEN) as server:
        run(script(server))


def test_room_names_in_any_script_have_tokens() -> None:
    name, decomposed = "Saal \u00e9?&=%2F#", "Saal e\u0301?&=%2F#"

    async def script(server: Server) -> None:
        async with join(server.url, room=name, token=token(name, KEY)) as one:
            assert one.users == {}
            async with join(server.url, room=decomposed, token=token(decomposed, KEY)) as two:
                assert list(two.users) == [one.user]

    with served(NEEDS_TOKEN) as server:
        run(script(server))


def test_full_rooms_and_servers_are_reported() -> None:
    async def script(server: Server) -> None:
        async with join(server.url, room="hall") as one:
            error = await is_refused(server)
            assert (error.reason, error.sentence) == ("full", "expected a room with fewer than 1 users")
            error = await is_refused(server, room="yard")
            assert (error.reason, error.sentence) == ("full", "expected a server with fewer than 1 rooms")
            await one.say(b"still there")

    with served(Rooms(rooms=1, users=1)) as server:
        run(script(server))


def test_a_site_does_not_hide_rooms() -> None:
    sites = {"rooms": Site({"a.txt": b"a"}, has_page=False)}
    with pytest.raises(ValueError, match=r"sites: expected names without a slash, but not .*rooms"):
        Server(sites, rooms=Rooms())
    with Server(sites) as server:
        assert server.port


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"rooms": 0}, "rooms: expected"),
        ({"users": 65535}, "users: expected"),
        ({"message_bytes": 10}, "message_bytes: expected"),
        ({"bytes_per_second": float("inf")}, "bytes_per_second: expected"),
        ({"poses_per_second": 0.0}, "poses_per_second: expected"),
        ({"hello_seconds": 0.0}, "hello_seconds: expected"),
        ({"key": bytes(15)}, "key: expected a key of 16 bytes or more, got 15"),
        ({"key": "secret" * 5}, "key: expected bytes, got str"),
        ({"peers": 1}, "peers: expected"),
        ({"datagrams": None}, "datagrams: expected"),
        ({"needs_token": True}, "needs_token: expected a key as well, got none"),
    ],
)
def test_unusable_limits_are_named(given: dict[str, object], message: str) -> None:
    with pytest.raises((ValueError, TypeError), match=message):
        Rooms(**given)  # type: ignore[arg-type]


def test_tokens_of_empty_rooms_are_refused() -> None:
    for room, hours, message in [("a/b", 1.0, "room: "), ("hall", 0.0, "hours: "), ("hall", 1e6, "hours: ")]:
        with pytest.raises(ValueError, match=message):
            token(room, KEY, hours=hours)
    assert token("hall", KEY) != token("hall", KEY)
    assert "secret" not in repr(Rooms(key=b"a secret of 20 bytes"))


def test_a_key_file_is_readable_by_its_owner_only(tmp_path: Path) -> None:
    place = tmp_path / "folder" / "key"
    made = ensure_key(place)
    assert (len(made), ensure_key(place), read_key(place)) == (32, made, made)
    assert stat.S_IMODE(place.stat().st_mode) == 0o600
    place.write_bytes(b"short")
    with pytest.raises(ValueError, match="key: expected a key of 16 bytes or more, got 5"):
        ensure_key(place)
    with pytest.raises(FileNotFoundError):
        read_key(tmp_path / "nothing")
