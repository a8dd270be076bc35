"""A page used in a room for a long simulated time, and its memory after each part of that time."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

from tests.support.browser import SMALL, open_page, wait_for_ring, wait_until
from tests.support.stepped_page import count_objects, heap, objects
from tests.support.web_cases import bundled

PARTS = 10
STEP = 6.0
"""Seconds of use after which the page gets real time to work."""


@dataclass(frozen=True)
class Held:
    """Bytes of the page's own objects, number of WebGL objects, and received poses of others."""

    heap: int
    objects: dict[str, int]
    poses: int


@contextmanager
def used(program: Any, url: str, rings: int) -> Iterator[Any]:
    """A page in a room whose server is in the page, all rings loaded."""
    with open_page(program, *SMALL) as page:
        count_objects(page)
        page.add_init_script(bundled("tests/rooms/used.ts"))
        page.goto(url)
        assert wait_for_ring(page, rings) == ""
        wait_until(page, lambda: page.evaluate("() => window.nearfar.room?.connection.state.kind") == "here")
        page.evaluate("() => window.used.take()")
        yield page


def use(page: Any, seconds: float) -> Iterator[Held]:
    """Use the page; returns its memory after each tenth of the time."""
    for part in range(PARTS):
        done, ends = part * seconds / PARTS, (part + 1) * seconds / PARTS
        while done < ends - 1e-6:
            now = min(STEP, ends - done)
            poses = page.evaluate("(seconds) => window.used.run(seconds)", now)
            done += now
        yield Held(heap(page), objects(page), poses)
