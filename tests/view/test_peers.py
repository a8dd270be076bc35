"""Pages in one room take files from each other: the server's bytes, and pages that send wrong files or none."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import pytest

import nearfar as nf
from nearfar.serve._rooms import Rooms
from nearfar.serve._server import Server
from nearfar.serve._site import Site
from tests.support.browser import wait_until
from tests.support.peer_pages import RADII, PeerPage, bytes_of, export, peer_page

pytestmark = pytest.mark.slow

CLIENTS = 8

PARTS_ARE_WRONG = """() => {
  const send = RTCDataChannel.prototype.send;
  RTCDataChannel.prototype.send = function (data) {
    if (data[0] === 3) data[data.length - 1] ^= 1;
    return send.call(this, data);
  };
}"""

PARTS_END = """() => {
  const send = RTCDataChannel.prototype.send;
  let parts = 0;
  RTCDataChannel.prototype.send = function (data) {
    if (data[0] !== 3 || ++parts <= 5) send.call(this, data);
  };
}"""

CHANNELS_ARE_KEPT = """() => {
  window.channels = [];
  const create = RTCPeerConnection.prototype.createDataChannel;
  RTCPeerConnection.prototype.createDataChannel = function (...given) {
    const channel = create.apply(this, given);
    window.channels.push(channel);
    return channel;
  };
}"""

TICKS_ARE_LONG = """() => {
  const later = window.setTimeout;
  window.setTimeout = (action, delay, ...given) => later(action, delay === 250 ? 5000 : delay, ...given);
}"""
"""Pages wait twenty times as long for each other: on a busy machine one that is slow is no silent one."""

CONNECTIONS_ARE_COUNTED = """() => {
  window.connections = 0;
  const Connection = RTCPeerConnection;
  window.RTCPeerConnection = function (...given) {
    window.connections += 1;
    return new Connection(...given);
  };
}"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    made = tmp_path_factory.mktemp("peers") / "bundle"
    assert export(made).nbytes > 3_000_000
    return made


@pytest.fixture(scope="module")
def size(folder: Path) -> int:
    """Bytes of the files that one page alone takes."""
    return nf.stream.open(folder).nbytes


@pytest.fixture(scope="module")
def url(folder: Path) -> Iterator[str]:
    with Server({"": Site.of_bundle(folder)}, rooms=Rooms()) as server:
        yield server.url


@pytest.fixture
def pages(chromium: Any) -> Iterator[Any]:
    """Makes pages, which a script may change before their own; what they print is looked at in the end."""
    with ExitStack() as stack:
        made: list[PeerPage] = []

        def make(script: str | None = None) -> PeerPage:
            page = stack.enter_context(peer_page(chromium))
            if script is not None:
                page.page.add_init_script(f"({script})()")
            made.append(page)
            return page

        yield make
        assert [line for page in made for line in page.page.printed] == []


def test_eight_pages_that_start_together_take_little_more_than_one(
    pages: Any, url: str, folder: Path, size: int
) -> None:
    all_pages = [pages(TICKS_ARE_LONG) for _ in range(CLIENTS)]
    for page in all_pages:
        page.open(url, "together")
    found = [page.wait() for page in all_pages]
    assert [each["dropped"] for each in found] == [{}] * CLIENTS
    assert all(each["others"]["bytes"] + each["server"]["bytes"] == size for each in found)
    assert bytes_of(folder, all_pages) <= 2 * size


def test_eight_pages_one_after_the_other_take_little_more_than_one(
    pages: Any, url: str, folder: Path, size: int
) -> None:
    all_pages = []
    for _ in range(CLIENTS):
        all_pages.append(pages(TICKS_ARE_LONG))
        all_pages[-1].open(url, "turns")
        all_pages[-1].wait()
        all_pages[-1].rest()
    assert bytes_of(folder, all_pages[:1]) == size
    assert bytes_of(folder, all_pages) <= 2 * size


def test_a_wrong_file_is_refused_and_its_sender_dropped(pages: Any, url: str, size: int) -> None:
    wrong = pages(PARTS_ARE_WRONG)
    wrong.open(url, "wrong")
    user = wrong.wait()["user"]
    page = pages()
    page.open(url, "wrong")
    found = page.wait()
    # The decoder checks each file, too: what is shown is right.
    assert found["dropped"] == {str(user): "a file is another one than was asked for"}
    assert found["server"]["bytes"] == size
    assert found["open"] == []
    # Others serve it as before.
    third = pages()
    third.open(url, "wrong")
    assert third.wait()["others"]["bytes"] > 0


def test_a_page_that_becomes_silent_in_the_middle_of_a_file_is_not_waited_for(pages: Any, url: str, size: int) -> None:
    silent = pages(PARTS_END)
    silent.open(url, "silent")
    silent.wait()
    page = pages()
    page.open(url, "silent")
    found = page.wait()
    assert found["dropped"] == {}
    assert found["server"]["bytes"] + found["others"]["bytes"] == size
    assert found["others"]["bytes"] < 0.1 * size


def test_a_page_that_goes_in_the_middle_of_a_file_is_not_waited_for(pages: Any, url: str, size: int) -> None:
    leaving = pages(PARTS_END)
    leaving.open(url, "vanish")
    leaving.wait()
    page = pages()
    page.open(url, "vanish")
    wait_until(page.page, lambda: ((page.told() or {}).get("others") or {"bytes": 0})["bytes"] > 0)
    leaving.page.close()
    found = page.wait()
    assert found["server"]["bytes"] + found["others"]["bytes"] == size
    assert found["open"] == []


@pytest.mark.parametrize(
    ("script", "reason"),
    [
        ("(channel) => channel.send('text')", "a message is a text"),
        ("(channel) => channel.send(Uint8Array.from([9, 9]))", "a message is of no kind that there is"),
        ("(channel) => channel.send(new Uint8Array(100_000))", "a message is too long"),
        (
            "(channel) => channel.send(Uint8Array.from([3, 7, 0, 0, 0, 1]))",
            "a message answers nothing that was asked for",
        ),
        (
            "(channel) => { for (let n = 0; n < 3000; n++) channel.send(Uint8Array.from([6, 1, 0, 0, 0])); }",
            "it sends more than it may",
        ),
    ],
)
def test_garbage_and_floods_drop_their_sender_alone(pages: Any, url: str, script: str, reason: str) -> None:
    rude, page = pages(CHANNELS_ARE_KEPT), pages()
    for each in (rude, page):
        each.open(url, reason, "&rings=0")
    wait_until(page.page, lambda: len((page.told() or {"open": []})["open"]) == 1)
    wait_until(rude.page, lambda: len((rude.told() or {"open": []})["open"]) == 1)
    rude.page.evaluate(f"() => window.channels.filter(({{ readyState }}) => readyState === 'open').forEach({script})")
    wait_until(page.page, lambda: page.told()["dropped"])
    found = page.wait(0)
    assert found["dropped"] == {str(rude.told()["user"]): reason}
    assert found["open"] == []


def test_garbage_signals_end_nothing_but_their_own_connection(pages: Any, url: str) -> None:
    rude, page, other = (pages() for _ in range(3))
    for each in (rude, page, other):
        each.open(url, "signals", "&rings=0")
    wait_until(page.page, lambda: len((page.told() or {"open": []})["open"]) == 2)
    send = """(user) => {
      const { connection } = window.nearfar.room;
      const text = new TextEncoder().encode('m=application 9 UDP/DTLS/SCTP webrtc-datachannel');
      for (const bytes of [[], [1], [1, 0, 0, 0, 0, 0, ...text], [1, 1, 0, 0, 0, 0, ...text], [2, 0]]) {
        connection.signal(user, Uint8Array.from(bytes));
      }
    }"""
    rude.page.evaluate(send, page.told()["user"])
    wait_until(page.page, lambda: len(page.told()["open"]) == 1)
    found = page.wait(0)
    assert found["open"] == [other.told()["user"]]
    assert found["user"] is not None


def test_a_user_who_does_not_want_it_takes_all_from_the_server(pages: Any, url: str, folder: Path, size: int) -> None:
    page, alone = pages(), pages(CONNECTIONS_ARE_COUNTED)
    page.open(url, "off")
    page.wait()
    alone.open(url, "off", "&peers=off")
    found = alone.wait()
    assert found["refusal"] == "the address of the page says so"
    assert alone.page.evaluate("() => window.connections") == 0
    assert bytes_of(folder, [alone]) == size
    assert page.told()["open"] == []


@pytest.mark.parametrize("peers", [True, False])
def test_the_server_says_whether_pages_may(pages: Any, folder: Path, peers: bool) -> None:
    with Server({"": Site.of_bundle(folder)}, rooms=Rooms(peers=peers)) as server:
        both = [pages(CONNECTIONS_ARE_COUNTED) for _ in range(2)]
        for page in both:
            page.open(server.url, "told", "&rings=1")
            page.wait(1)
        wait_until(both[0].page, lambda: both[0].told()["refusal"] != "unknown")
        assert both[0].told()["refusal"] == (None if peers else "the server does not want it")
        if peers:
            wait_until(both[0].page, lambda: both[0].told()["open"])
        assert (both[0].page.evaluate("() => window.connections") > 0) == peers


def test_the_card_tells_where_files_came_from(pages: Any, url: str) -> None:
    page = pages()
    page.open(url, "card")
    page.wait(len(RADII))
    words, card = "0 B from others, 3.7 MB from the server", page.page.locator(".here")
    wait_until(page.page, lambda: words in card.text_content().replace("\xa0", " "))
