"""Pages collect a sphere together: they start, aim, miss and see both scores."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from contextlib import ExitStack
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar.serve._limits import Rooms
from nearfar.serve._server import Server
from nearfar.serve._site import Site
from tests.support.browser import open_page, wait_for_ring, wait_until
from tests.support.room_pages import RoomPage, has_changed

pytestmark = pytest.mark.slow

SIZE = (240, 160)
DESKTOP, PHONE = (1280, 800), (390, 844)
CENTER = (3.0, 1.7, -2.0)
RADII = (10.0, 22.0)
ZONES = (0.7 * RADII[-1], RADII[-1])
START = {"position": list(CENTER), "yaw": 0.0, "pitch": 0.0}

TASK = """() => {
  const { task } = window.nearfar.room.activity;
  const { user, conductor, needed, seat, aims, misses, count, sphere, trial } = task ?? {};
  const place = task?.place(performance.now() / 1000) ?? null;
  return { user, conductor, needed, seat, aims, misses, count, level: sphere?.level, place, over: trial?.over };
}"""


@pytest.fixture(scope="module")
def url(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    folder = tmp_path_factory.mktemp("collect") / "bundle"
    nf.stream.export(nf.datasets.city(blocks=2, detail=0), folder, center=CENTER, radii=RADII, face_size=64)
    with Server({"": Site.of_bundle(folder)}, rooms=Rooms()) as server:
        yield f"{server.url}?aa=0&strategy=clovrd&task=collect"


class Player(RoomPage):
    """A page whose user looks at the sphere, or away from it."""

    def task(self) -> dict[str, Any]:
        """Draw a frame; returns the state of the task."""
        self.step()
        return dict(self.page.evaluate(TASK))

    def look(self, away: float = 0.0) -> None:
        """Turn to the sphere, or some radians away from it."""
        found = self.task()
        eye = found["seat"]
        x, y, z = np.subtract(found["place"], eye)
        yaw, pitch = float(np.arctan2(-x, -z)) + away, float(np.arctan2(y, np.hypot(x, z)))
        self.pose = {"position": eye, "yaw": yaw, "pitch": pitch}


def task_states(players: Sequence[Player], name: str) -> list[Any]:
    """The state of each page's task, after a frame of each: the conductor needs the others' poses."""
    return [player.task()[name] for player in players]


def join_room(chromium: Any, stack: ExitStack, url: str, name: str) -> Player:
    """A page in a room, with all of its rings loaded."""
    page = stack.enter_context(open_page(chromium, *SIZE))
    page.goto(f"{url}&name={name}")
    assert wait_for_ring(page, len(RADII)) == ""
    wait_until(page, lambda: page.evaluate("() => Boolean(window.nearfar?.room?.activity)"))
    return Player(page, dict(START))


def start_trial(chromium: Any, stack: ExitStack, url: str, names: tuple[str, ...]) -> list[Player]:
    """Pages of one group, the conductor first, whose first trial has begun."""
    players = [join_room(chromium, stack, url, name) for name in names]
    first = players[0].page
    wait_until(first, lambda: None not in task_states(players, "user"))
    players.sort(key=lambda player: player.task()["user"])
    button = players[0].page.get_by_role("button", name="Start")
    wait_until(first, lambda: players[0].step() and button.is_visible())
    for player in players[1:]:
        player.step()
        assert player.page.get_by_role("button", name="Start").is_hidden()
    button.click()
    wait_until(first, lambda: None not in task_states(players, "place"))
    return players


def test_two_pages_collect_a_sphere(chromium: Any, url: str) -> None:
    with ExitStack() as stack:
        other = join_room(chromium, stack, f"{url}&room=two&group=2", "Eve")
        ada, bob = start_trial(
            chromium, stack, f"{url}&room=two&group=1&hold=0.2&pause=0&duration=3000", ("Ada", "Bob")
        )
        state = ada.task()
        assert (state["level"], state["needed"], state["aims"]) == ("easy", 2, [])
        for player in (ada, bob):
            assert np.all(np.abs(np.subtract(player.task()["seat"], CENTER)) <= (2.5, 1e-6, 1.0))
        ada.look()
        # Away from the sphere at first, whose radius is 0.3 m at about 8 m.
        bob.look(away=0.1)
        both = (ada, bob)
        wait_until(ada.page, lambda: task_states(both, "aims") == 2 * [[state["user"]]])
        mask = np.abs(ada.picture() - without_guests(ada)).max(axis=-1) > 20
        assert has_changed(mask, ada.pixel_of(state["place"], CENTER, ZONES)[0], 1.5)
        assert ada.task()["count"] == 0
        ada.look(away=-0.1)
        wait_until(ada.page, lambda: task_states(both, "misses") == [1, 1])
        for player in both:
            player.look()
        wait_until(ada.page, lambda: task_states(both, "count") == [1, 1])
        pages = [player.page for player in both]
        wait_until(
            ada.page, lambda: task_states(both, "count") and {figure(page, "Spheres") for page in pages} == {"1"}
        )
        card = other.page.locator(".collect")
        wait_until(other.page, lambda: other.step() and "Group 1: 1 spheres, 1 misses" in card.inner_text())
        assert ada.task()["level"] == "hard"
        # The user with the next lowest number takes over as conductor.
        ada.page.close()
        wait_until(bob.page, lambda: bob.task()["conductor"] == bob.task()["user"])
        assert bob.task()["count"] == 1
        assert ada.page.printed + bob.page.printed + other.page.printed == []


def without_guests(player: Player) -> Any:
    player.page.evaluate("() => window.nearfar.viewer.setGuests(null)")
    picture = player.picture()
    player.page.evaluate("() => window.nearfar.room.begin(window.nearfar.room.activity)")
    return picture


def figure(page: Any, name: str) -> str:
    """A figure of the card."""
    return str(page.locator(f".collect-figures div:has(dt:text-is('{name}')) dd").inner_text())


def test_the_card_fits_and_ends_with_the_trial_s_figures(chromium: Any, url: str) -> None:
    with open_page(chromium, *DESKTOP, device_scale_factor=0.25) as page:
        alone = f"{url}&users=1&trials=1&hold=0&radius=100&pause=0&rings=1"
        page.goto(f"{alone}&room=long&duration=3000")
        page.get_by_role("button", name="Start").click()
        card = page.get_by_role("region", name="Sphere collection")
        card.get_by_text("Left").wait_for()
        assert re.match(r"\d\d:\d\d", figure(page, "Left"))
        for size in (DESKTOP, PHONE):
            check_inside(card, page, size)
        page.goto(f"{alone}&room=short&duration=1")
        page.get_by_role("button", name="Start").click()
        card.get_by_role("table").wait_for()
        for size in (PHONE, DESKTOP):
            check_inside(card, page, size)
        rows = card.get_by_role("row").all_inner_texts()
        assert [row.split()[0].lower() for row in rows] == ["level", "easy", "intermediate", "hard"]
        assert re.search(r"[\d.]+ frames a second", card.inner_text())
        assert card.get_by_role("button", name="Start").is_visible()
        assert page.printed == []


def check_inside(card: Any, page: Any, size: tuple[int, int]) -> None:
    """Check that the card lies on a page of a size, above its tools."""
    page.set_viewport_size(dict(zip(("width", "height"), size, strict=True)))
    wait_until(page, lambda: page.evaluate("() => [innerWidth, innerHeight]") == list(size))
    box, tools = card.bounding_box(), page.locator(".tools").bounding_box()
    assert box["x"] >= 0
    assert box["y"] >= 0
    assert box["x"] + box["width"] <= size[0]
    assert box["y"] + box["height"] <= tools["y"]
