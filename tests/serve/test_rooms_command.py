"""`nearfar serve --rooms` and `nearfar invite`."""

from __future__ import annotations

import asyncio
import signal
import stat
from pathlib import Path
from urllib.parse import parse_qs, urlsplit

import pytest
from typer.testing import CliRunner

from nearfar.cli._app import app, run as command
from nearfar.stream.client import Ended, Joined, join
from tests.support import need
from tests.support.room_cases import run, until, wire
from tests.support.serving import rest_of, serving

need("aiohttp")


@pytest.fixture(autouse=True)
def _cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("NEARFAR_CACHE", str(tmp_path / "cache"))


def test_users_keep_their_numbers_over_a_restart(place: Path, tmp_path: Path) -> None:
    async def script() -> None:
        with serving(place, "--rooms", "--most-users", "2", "--log", "off") as (first, url):
            assert first.stdout is not None
            assert any("see each other, 2 in each of 64 rooms at most." in told for told in first.stdout)
            async with (
                wire(url) as way,
                join(way.url, room="hall", name="Ada") as ada,
                join(way.url, room="hall", name="Grace") as grace,
            ):
                numbers = (ada.user, grace.user)
                way.lead_to(None)
                first.send_signal(signal.SIGTERM)
                assert (await until(ada, Ended)).reason == "ending"
                await asyncio.to_thread(first.wait)
                with serving(place, "--rooms", "--log", "off") as (_, again):
                    way.lead_to(again)
                    await asyncio.gather(until(ada, Joined), until(grace, Joined, lambda event: event.name == "Ada"))
                    assert (ada.user, grace.user) == numbers

    run(script())
    assert stat.S_IMODE((tmp_path / "cache" / "rooms" / "key").stat().st_mode) == 0o600


def test_an_invitation_lets_a_user_in(place: Path, tmp_path: Path) -> None:
    key = tmp_path / "key"

    async def script(url: str) -> None:
        made = CliRunner().invoke(app, ["invite", "Saal 1", "--rooms-key", str(key)]).stdout.strip()
        async with join(url, room="Saal 1", token=made) as ada:
            link = CliRunner().invoke(app, ["invite", "Saal 1", "--rooms-key", str(key), "--url", url]).stdout.strip()
            asked = parse_qs(urlsplit(link).query)
            assert asked["room"] == ["Saal 1"]
            assert link.startswith(f"{url}?room=Saal%201&token=")
            async with join(url, room=asked["room"][0], token=asked["token"][0]) as grace:
                assert list(grace.users) == [ada.user]

    with serving(place, "--rooms", "--rooms-key", key, "--log", "off") as (running, url):
        run(script(url))
        running.terminate()
        told, _ = rest_of(running)
    assert f"`nearfar invite NAME --rooms-key {key} --url {url}`" in told
    assert stat.S_IMODE(key.stat().st_mode) == 0o600


@pytest.mark.parametrize(
    ("arguments", "reason"),
    [
        (("serve", "PLACE", "--rooms-key", "k", "--check"), "--rooms-key: expected --rooms beside it"),
        (("serve", "PLACE", "--most-users", "3", "--check"), "--most-users: expected --rooms beside it"),
        (("serve", "PLACE", "--no-peers", "--check"), "--no-peers: expected --rooms beside it"),
        (("serve", "PLACE", "--no-datagrams", "--check"), "--no-datagrams: expected --rooms beside it"),
        (("serve", "PLACE", "--rooms", "--rooms-key", "short", "--check"), "short: expected a key of 16 bytes or more"),
        (("serve", "a=PLACE", "b=PLACE", "--rooms", "--check"), "--rooms: expected one source, got 2"),
        (("invite", "hall", "--rooms-key", "nothing"), "nothing"),
        (("invite", "a/b", "--rooms-key", "long"), "room: expected"),
        (("invite", "hall", "--rooms-key", "long", "--url", "http://here/?a=b"), "url: expected"),
    ],
)
def test_unusable_room_arguments_are_named(
    place: Path,
    tmp_path: Path,
    arguments: tuple[str, ...],
    reason: str,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("short").write_bytes(bytes(5))
    Path("long").write_bytes(bytes(32))
    given = [argument.replace("PLACE", str(place)) for argument in arguments]
    port = ["--port", "0"] if given[0] == "serve" else []
    assert command([*given, *port]) == 1
    assert reason in capsys.readouterr().err
