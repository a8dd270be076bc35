"""Pages that come to a room, go, hide and come back; nothing of it is compiled again."""

from __future__ import annotations

import re
import urllib.request
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar.serve._certificate import Certificate
from nearfar.serve._rooms import Rooms, token
from nearfar.serve._server import Server
from nearfar.serve._site import Site
from tests.support.browser import opened, wait_until
from tests.support.lost_link import lost_link
from tests.support.room_pages import RoomPage

pytestmark = pytest.mark.slow

SIZE = (240, 160)
CENTER = (3.0, 1.7, -2.0)
KEY = bytes(32)
STATE = "() => window.nearfar?.room?.connection.state ?? {}"
GUESTS = "() => window.nearfar?.room?.presence.guests.length"


@pytest.fixture(scope="module")
def bundle(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("comings") / "bundle"
    nf.stream.export(nf.datasets.city(blocks=2, detail=1), folder, center=CENTER, radii=(10.0,), face_size=64)
    return folder


@pytest.fixture
def server(bundle: Path) -> Iterator[Server]:
    with Server({"": Site.of_bundle(bundle)}, rooms=Rooms()) as running:
        yield running


def is_here(page: Any) -> bool:
    return bool(page.evaluate(STATE).get("kind") == "here")


def closes(server: Server, reason: str) -> int:
    """Connections of rooms that the server counts as ended for a reason."""
    with urllib.request.urlopen(f"{server.url}metrics") as answer:
        counts = re.findall(rf'nearfar_room_closes_total{{reason="{reason}"}} (\d+)', answer.read().decode())
    return int(counts[0]) if counts else 0


def test_who_loads_again_with_a_token_is_back_at_once(chromium: Any, bundle: Path) -> None:
    rooms = Rooms(key=KEY, needs_token=True)
    with Server({"": Site.of_bundle(bundle)}, rooms=rooms) as server, lost_link(server.port) as link:
        url = f"http://127.0.0.1:{link.port}/?rings=0&room=hall&datagrams=off&token={token('hall', KEY)}"
        with opened(chromium, *SIZE) as page, opened(chromium, *SIZE) as other:
            page.goto(url)
            wait_until(page, lambda: is_here(page))
            user = page.evaluate(STATE)["user"]
            # A tab that is doubled would take the ticket along.
            assert page.evaluate("() => sessionStorage.length") == 0
            link.lose()
            # The server still has the connection, and its token.
            other.goto(url)
            wait_until(other, lambda: other.evaluate(STATE).get("kind") == "ended")
            page.reload()
            wait_until(page, lambda: is_here(page))
            assert page.evaluate(STATE)["user"] == user
            assert page.evaluate("() => sessionStorage.length") == 0
            assert closes(server, "replaced") == 1
            assert page.printed == []


def test_who_goes_says_so_and_others_see_it(chromium: Any, server: Server) -> None:
    url = f"{server.url}?rings=0&room=bye"
    with opened(chromium, *SIZE) as page, opened(chromium, *SIZE) as other:
        for each in (page, other):
            each.goto(url)
        wait_until(page, lambda: page.evaluate(GUESTS) == 1)
        other.goto("about:blank")
        wait_until(page, lambda: page.evaluate(GUESTS) == 0)
        assert closes(server, "bye") == 1
        assert page.printed == []


def test_a_page_that_the_browser_kept_joins_again(chromium: Any, server: Server) -> None:
    with opened(chromium, *SIZE) as page:
        page.goto(f"{server.url}?rings=0&room=kept")
        wait_until(page, lambda: is_here(page))
        user = page.evaluate(STATE)["user"]
        page.evaluate("() => window.dispatchEvent(new PageTransitionEvent('pagehide', { persisted: true }))")
        assert page.evaluate(STATE)["kind"] == "ended"
        page.evaluate("() => window.dispatchEvent(new PageTransitionEvent('pageshow', { persisted: true }))")
        wait_until(page, lambda: is_here(page))
        assert page.evaluate(STATE)["user"] == user
        assert page.evaluate("() => sessionStorage.length") == 0


def test_who_leaves_by_the_card_stays_away_until_asked(chromium: Any, server: Server) -> None:
    with opened(chromium, 800, 600) as page:
        page.goto(f"{server.url}?rings=0&room=left")
        page.get_by_role("button", name="1 here").click()
        card = page.get_by_role("region", name="Here")
        card.get_by_role("button", name="Leave").click()
        card.get_by_text("You have left the room.").wait_for()
        assert not card.get_by_role("button", name="Leave").is_visible()
        assert closes(server, "bye") == 1
        card.get_by_role("button", name="Join again").click()
        page.get_by_role("button", name="1 here").wait_for()
        assert page.printed == []


def test_a_page_over_tls_joins_over_tls(chromium: Any, bundle: Path, tmp_path: Path) -> None:
    certificate = Certificate.self_signed(tmp_path / "tls", ["localhost", "127.0.0.1"])
    with Server({"": Site.of_bundle(bundle)}, certificate=certificate, rooms=Rooms()) as server, ExitStack() as stack:
        pages = [stack.enter_context(opened(chromium, *SIZE, ignore_https_errors=True)) for _ in range(2)]
        sockets: list[str] = []
        pages[0].on("websocket", lambda socket: sockets.append(socket.url))
        for page in pages:
            page.goto(f"{server.url}?rings=0&room=safe&datagrams=off")
        for page in pages:
            page.wait_for_function("() => window.nearfar?.room?.presence.guests.length === 1")
            assert page.printed == []
        assert [url.split("://")[0] for url in sockets] == ["wss"]


def test_a_hidden_page_rests_and_returns(chromium: Any, server: Server) -> None:
    pose = {"position": [3.0, 1.7, -1.0], "yaw": 0.0, "pitch": -0.2}
    with opened(chromium, *SIZE) as first, opened(chromium, *SIZE) as second:
        for each in (first, second):
            each.goto(f"{server.url}?room=hidden&strategy=clovrd")
        ada, bob = RoomPage(first, pose), RoomPage(second, dict(pose))
        bob.point_at(120, 100)

        def seen(is_pointing: bool, x: float) -> bool:
            found = ada.step()["seen"]
            head = found[0]["head"]["position"] if found else (np.inf,)
            return bool(found) and (found[0]["pointer"] is not None) == is_pointing and abs(head[0] - x) < 1e-3

        wait_until(first, lambda: bob.step() and seen(True, 3.0))
        hide = """(isHidden) => {
          Object.defineProperty(document, 'hidden', { configurable: true, value: isHidden });
          document.dispatchEvent(new Event('visibilitychange'));
        }"""
        second.evaluate(hide, True)
        # No frame comes, and who is held has let go of the pointer for others.
        wait_until(first, lambda: seen(False, 3.0))
        # Who comes meanwhile is told where the page rests.
        with opened(chromium, *SIZE) as third:
            third.goto(f"{server.url}?rings=0&room=hidden")
            wait_until(third, lambda: ada.step() and third.evaluate("() => window.nearfar?.room?.seen.length") == 2)
        second.evaluate(hide, False)
        bob.pose["position"] = [4.0, 1.7, -1.0]
        wait_until(first, lambda: bob.step() and seen(True, 4.0))
        assert first.printed == second.printed == []
