"""Long use of a room: the page keeps nothing of former users, and compiles nothing again."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from nearfar.serve._limits import Rooms
from nearfar.serve._server import Server
from nearfar.serve._site import Site
from tests.support import need
from tests.support.browser import open_page, wait_for_ring
from tests.support.room_pages import HEAR, RoomPage
from tests.support.stepped_page import count_objects, linked, objects
from tests.support.used_room import use, used

pytestmark = pytest.mark.slow

SECONDS = 300.0
WARM, MAX_GROWTH = 4, 300_000
"""Tenths of the time in which the browser still compiles code into the heap; bytes of growth allowed after that."""


@pytest.fixture(scope="module")
def url(street: Path) -> Iterator[str]:
    with Server({"": Site.of_bundle(street)}, rooms=Rooms()) as server:
        yield f"{server.url}?aa=0&strategy=clovrd"


@pytest.mark.stress
def test_memory_of_a_page_does_not_grow_with_time(chromium: Any, url: str) -> None:
    need("web")
    with used(chromium, f"{url}&room=long&name=Ada&datagrams=off", 1) as page:
        parts = list(use(page, SECONDS))
        assert page.printed == []
    assert parts[-1].poses > 0.9 * 8 * 72 * SECONDS
    assert max(each.heap for each in parts[WARM:]) < parts[WARM].heap + MAX_GROWTH
    first = parts[0]
    for each in parts[1:]:
        assert each.objects["Program"] == each.objects["programs"] == first.objects["programs"]
        for kind in ("geometries", "Buffer", "VertexArray", "Framebuffer"):
            assert each.objects[kind] == first.objects[kind], kind
        # Names of users, one of whom may just be joining.
        assert abs(each.objects["textures"] - first.objects["textures"]) <= 2


BODY = {
    "head": {"position": [3.0, 1.7, -5.0], "rotation": [0, 0, 0, 1]},
    "left": None,
    "right": {"position": [3.2, 1.4, -5.3], "rotation": [0, 0, 0, 1]},
    "pointer": {"begin": "right", "length": 3.0},
}


def test_depth_queries_and_changing_users_compile_nothing(chromium: Any, url: str) -> None:
    with open_page(chromium, 240, 160) as page:
        count_objects(page)
        page.goto(f"{url}&room=programs")
        assert wait_for_ring(page, 1) == ""
        ada = RoomPage(page, {"position": [3.0, 1.7, -2.0], "yaw": 0.0, "pitch": -0.1})

        def visit(users: range) -> None:
            for user in users:
                page.evaluate(HEAR, [user, BODY])
            ada.step()
            ada.point_at(120, 100)
            page.evaluate("([x, y]) => window.nearfar.viewer.along([3, 1.7, -2], [x, y, -1])", [0.1, -0.1])
            ada.step()
            page.keyboard.up("e")
            ada.step()
            for user in users:
                page.evaluate("(user) => window.nearfar.room.presence.hear({ kind: 'left', user }, 0)", user)
            ada.step()

        visit(range(1, 3))
        before, were = objects(page), linked(page)
        for first in range(10, 60, 5):
            visit(range(first, first + 5))
        after = objects(page)
        assert linked(page) == were
        assert after["programs"] == before["programs"]
        # No object of the depth queries remains, and spare avatars are few.
        assert after["Framebuffer"] == before["Framebuffer"]
        assert after["Texture"] - before["Texture"] <= 16
        assert page.printed == []
