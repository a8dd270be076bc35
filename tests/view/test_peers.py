"""Pages of one room exchange files by WebRTC; web/tests/peers_*.test.ts test everything else in memory."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import pytest

import nearfar as nf
from nearfar.serve._limits import Rooms
from nearfar.serve._server import Server
from nearfar.serve._site import Site
from tests.support.browser import wait_until
from tests.support.peer_pages import PeerPage, bytes_of, export, peer_page

pytestmark = pytest.mark.slow

TICKS_ARE_LONG = """() => {
  const later = window.setTimeout;
  window.setTimeout = (action, delay, ...given) => later(action, delay === 250 ? 5000 : delay, ...given);
}"""
"""Pages wait twenty times as long for each other: on a busy machine a slow page is not a silent one."""

CONNECTIONS_ARE_COUNTED = """() => {
  window.connections = 0;
  const Connection = RTCPeerConnection;
  window.RTCPeerConnection = function (...given) {
    window.connections += 1;
    return new Connection(...given);
  };
}"""

GARBAGE = """(user) => {
  const { connection } = window.nearfar.room;
  const text = new TextEncoder().encode('m=application 9 UDP/DTLS/SCTP webrtc-datachannel');
  for (const bytes of [[], [1], [1, 0, 0, 0, 0, 0, ...text], [1, 1, 0, 0, 0, 0, ...text], [2, 0]]) {
    connection.signal(user, Uint8Array.from(bytes));
  }
}"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    made = tmp_path_factory.mktemp("peers") / "bundle"
    export(made)
    return made


@pytest.fixture(scope="module")
def url(folder: Path) -> Iterator[str]:
    with Server({"": Site.of_bundle(folder)}, rooms=Rooms()) as server:
        yield server.url


@pytest.fixture
def pages(chromium: Any) -> Iterator[Any]:
    """A factory of pages, with a script that runs before their own; their output is checked at the end."""
    with ExitStack() as stack:
        made: list[PeerPage] = []

        def make(script: str) -> PeerPage:
            page = stack.enter_context(peer_page(chromium))
            page.page.add_init_script(f"({script})()")
            made.append(page)
            return page

        yield make
        assert [line for page in made for line in page.page.printed] == []


def test_pages_fetch_files_from_other_pages(pages: Any, url: str, folder: Path) -> None:
    size = nf.stream.open(folder).nbytes
    first, *others = (pages(TICKS_ARE_LONG) for _ in range(3))
    first.open(url, "turns")
    alone = first.wait()
    assert (alone["server"]["bytes"], alone["others"]["bytes"]) == (size, 0)
    assert bytes_of(folder, [first]) == size
    first.rest()
    for page in others:
        page.open(url, "turns")
    found = [page.wait() for page in others]
    assert all(each["others"]["bytes"] + each["server"]["bytes"] == size for each in found)
    assert [each["dropped"] for each in found] == [{}, {}]
    assert bytes_of(folder, [first, *others]) < 1.5 * size
    words, card = "from others", others[0].page.locator(".here")
    wait_until(others[0].page, lambda: words in card.text_content() and "0 B from others" not in card.text_content())
    # The channel of a closed page ends.
    first.page.close()
    numbers = [page.facts()["user"] for page in others]
    wait_until(others[0].page, lambda: [page.facts()["open"] for page in others] == [[n] for n in numbers[::-1]])


def test_malformed_signals_end_their_own_connection_and_opting_out_has_none(pages: Any, url: str) -> None:
    rude, page, other, alone = (pages(CONNECTIONS_ARE_COUNTED) for _ in range(4))
    for each in (rude, page, other):
        each.open(url, "signals", "&rings=0")
    alone.open(url, "signals", "&rings=0&peers=off")
    wait_until(page.page, lambda: len((page.facts() or {"open": []})["open"]) == 2)
    rude.page.evaluate(GARBAGE, page.facts()["user"])
    wait_until(page.page, lambda: page.facts()["open"] == [other.facts()["user"]])
    assert alone.wait(0)["refusal"] == "the address of the page switches it off"
    assert page.page.evaluate("() => window.connections") > 0
    assert alone.page.evaluate("() => window.connections") == 0
