"""Floods of requests for regions, full disks and kills: bounded, fair, and no partial file is served."""

from __future__ import annotations

import hashlib
import http.client
import json
import signal
from contextlib import ExitStack
from functools import partial
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import httpx
import pytest

from nearfar.serve._limits import Limits
from nearfar.serve._server import Server
from tests.support.asking import HANGS, get
from tests.support.made_regions import BYTES, FILES, Kitchen, files_of, serving
from tests.support.waiting import wait_until

KILLS = 2


def request_region(stack: ExitStack, server: Server, place: str, source: str) -> http.client.HTTPResponse:
    """The response to a request for a region whose header has arrived; the client is closed with the stack."""
    line = http.client.HTTPConnection(urlsplit(server.url).netloc, timeout=300, source_address=(source, 0))
    stack.callback(line.close)
    line.request("GET", f"/at/{place}/parts")
    answer = line.getresponse()
    stack.callback(answer.close)
    return answer


def count_waiting(server: Server) -> int:
    lines = get(server.url + "metrics").text.splitlines()
    return sum(int(line.rsplit(" ", 1)[1]) for line in lines if line.startswith("nearfar_regions_waiting"))


def last_event(answer: http.client.HTTPResponse) -> dict[str, Any]:
    event: dict[str, Any] = json.loads(answer.read().splitlines()[-1])
    return event


def test_a_flood_is_bounded_and_other_clients_are_next() -> None:
    kitchen = Kitchen()
    with Server({"": kitchen.site()}, limits=Limits(threads=1)) as server, ExitStack() as stack:
        flood = [request_region(stack, server, f"{10 * number},0,0", "127.0.0.1") for number in range(60)]
        assert [answer.status for answer in flood] == [200] * 4 + [429] * 56
        wait_until(lambda: len(kitchen.begun) == 1)
        other = request_region(stack, server, "-50,0,0", "127.0.0.2")
        assert get(server.url + "files/other").content == b"another file"
        # The running request ends, and then the other client's turn precedes the flood's.
        kitchen.let(2)
        assert last_event(other) == {"event": "end", "center": [-50.0, 0.0, 0.0]}
        assert kitchen.begun[1] == [-50.0, 0.0, 0.0]
        stack.close()
        wait_until(lambda: count_waiting(server) == 0)


def test_a_flood_from_many_addresses_is_bounded_and_leaves_nothing_behind() -> None:
    kitchen = Kitchen()
    limits = Limits(regions=16, regions_per_client=2)
    with Server({"": kitchen.site()}, limits=limits) as server, ExitStack() as stack:
        flood = [
            request_region(stack, server, f"{10 * (3 * client + number)},0,0", f"127.0.1.{client}")
            for client in range(1, 21)
            for number in range(3)
        ]
        statuses = [answer.status for answer in flood]
        assert statuses.count(200) == 16
        assert set(statuses) == {200, 429, 503}
        assert all(answer.headers["retry-after"] for answer in flood if answer.status != 200)
        assert count_waiting(server) == 16
        assert get(server.url + "files/other").content == b"another file"
        stack.close()
        wait_until(lambda: count_waiting(server) == 0)
        kitchen.let(1)
        assert last_event(request_region(stack, server, "-50,0,0", "127.0.0.2"))["event"] == "end"


def check(url: str, place: str = "0,0,0") -> None:
    """Check that the region of a place is complete, with the right content of its files."""
    assert get(f"{url}at/{place}/parts").status_code == 200
    manifest: dict[str, Any] = get(f"{url}at/{place}/manifest.json").json()
    assert len(manifest["files"]) == FILES
    expected = files_of(manifest["center"])
    for name, described in manifest["files"].items():
        content = get(url + name).content
        assert content == expected[name]
        assert hashlib.sha256(content).hexdigest() == described["sha256"]


def has_more(folder: Path, count: int) -> bool:
    return len(list(folder.iterdir())) > count


@pytest.mark.slow
def test_a_kill_while_a_region_is_written_leaves_no_partial_file(tmp_path: Path) -> None:
    cache = tmp_path / "cache"
    for number in range(KILLS):
        with serving(cache) as (running, url):
            files = cache / "files"
            before = len(list(files.iterdir()))
            place = f"{10 * number},0,0"
            line = http.client.HTTPConnection(urlsplit(url).netloc, timeout=300)
            line.request("GET", f"/at/{place}/parts")
            # Some of its files exist, complete or partial by chance, when the server is killed.
            wait_until(partial(has_more, files, before))
            running.send_signal(signal.SIGKILL)
            running.wait()
            line.close()
        with serving(cache) as (_, url):
            assert not list(cache.rglob("*.part"))
            for earlier in range(number + 1):
                check(url, f"{10 * earlier},0,0")


@pytest.mark.slow
def test_clients_notice_a_kill_while_files_are_sent(tmp_path: Path) -> None:
    cache = tmp_path / "cache"
    with serving(cache) as (running, url):
        check(url)
        name = next(iter(files_of([0.0, 0.0, 0.0])))
        with httpx.stream("GET", url + name, timeout=HANGS) as answer:
            pieces = answer.iter_raw(1000)
            next(pieces)
            running.send_signal(signal.SIGKILL)
            running.wait()
            try:
                taken = 1000 + sum(len(piece) for piece in pieces)
            except httpx.TransportError:
                taken = 0
            # All of it was in transit, or the client knows that some is missing.
            assert taken in (0, BYTES)
    path = cache / name
    path.write_bytes(path.read_bytes()[:-1] + b"x")
    with serving(cache) as (_, url):
        assert get(url + name).status_code == 404
        check(url)
        assert path.read_bytes() == files_of([0.0, 0.0, 0.0])[name]


@pytest.mark.slow
@pytest.mark.parametrize("damage", ["a file is gone", "a file is shorter", "the manifest is gone", "a file is a link"])
def test_files_damaged_while_the_server_runs_are_made_again(tmp_path: Path, damage: str) -> None:
    cache = tmp_path / "cache"
    with serving(cache) as (_, url):
        check(url)
        path = cache / next(iter(files_of([0.0, 0.0, 0.0])))
        match damage:
            case "a file is gone":
                path.unlink()
            case "a file is shorter":
                path.write_bytes(path.read_bytes()[:-1])
            case "the manifest is gone":
                next((cache / "at").iterdir()).unlink()
            case _:
                path.rename(tmp_path / "elsewhere")
                path.symlink_to(tmp_path / "elsewhere")
        check(url)
        assert path.stat(follow_symlinks=False).st_size == BYTES


@pytest.mark.slow
def test_with_a_full_disk_regions_are_served_from_memory(tmp_path: Path) -> None:
    cache = tmp_path / "cache"
    with serving(cache, most=BYTES // 2) as (_, url):
        for _ in range(2):
            check(url)
        assert not list((cache / "at").iterdir())
        assert not list(cache.rglob("*.part"))
    # With space again it is stored.
    with serving(cache) as (_, url):
        check(url)
        assert len(list((cache / "at").iterdir())) == 1
