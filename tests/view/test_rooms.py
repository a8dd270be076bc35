"""Pages in one room see each other's heads and pointers at the right positions, in front of and behind far geometry."""

from __future__ import annotations

import re
import urllib.request
from collections.abc import Iterator
from contextlib import ExitStack
from functools import partial
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar.serve._limits import Rooms
from nearfar.serve._server import Server
from nearfar.serve._site import Site
from tests.support.browser import SMALL, open_page, wait_for_ring, wait_until
from tests.support.room_pages import AIMS, HEAR, RoomPage, ends, has_changed, reach_beyond

pytestmark = pytest.mark.slow

SIZE = (480, 320)
DESKTOP, PHONE = (1280, 800), (390, 844)
CENTER = (3.0, 1.7, -2.0)
RADII = (10.0, 22.0)
ZONES = (0.7 * RADII[-1], RADII[-1])
POSES = {
    "Ada": {"position": [3.0, 1.7, 1.0], "yaw": 0.0, "pitch": 0.0},
    "Bob": {"position": [2.2, 1.7, -3.5], "yaw": 0.0, "pitch": 0.0},
}
TARGETS = ((240, 178), (330, 150), (380, 175), (150, 178))
"""Pixels that Bob points at: the road, and a house in the zone of the morph and beyond, which Ada sees, too."""


@pytest.fixture(scope="module")
def server(city: nf.Scene, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    folder = tmp_path_factory.mktemp("rooms") / "bundle"
    nf.stream.export(city, folder, center=CENTER, radii=RADII, face_size=256)
    with Server({"": Site.of_bundle(folder)}, rooms=Rooms()) as running:
        yield running


@pytest.fixture(scope="module")
def url(server: Server) -> str:
    return f"{server.url}?aa=0&strategy=clovrd"


@pytest.fixture(scope="module")
def pair(chromium: Any, url: str) -> Iterator[tuple[RoomPage, RoomPage]]:
    """Ada and Bob, who know each other's positions."""
    with ExitStack() as stack:
        pages = []
        for name, pose in POSES.items():
            shown = stack.enter_context(open_page(chromium, *SIZE))
            shown.goto(f"{url}&room=pair&name={name}")
            assert wait_for_ring(shown, len(RADII)) == ""
            # The figures cover a part of the picture that is pointed at.
            shown.evaluate("() => document.querySelector('#ui').style.setProperty('display', 'none')")
            pages.append(RoomPage(shown, pose))
        # Each sends its position by a small step.
        wait_until(pages[0].page, lambda: sum(len(each.step()["seen"]) for each in pages) == len(pages))
        yield pages[0], pages[1]
        for each in pages:
            assert each.page.printed == []


def test_heads_have_the_position_and_direction_of_their_users(pair: tuple[RoomPage, RoomPage]) -> None:
    for one, other in (pair, pair[::-1]):
        (seen,) = one.step()["seen"]
        np.testing.assert_allclose(seen["head"]["position"], other.pose["position"], atol=1e-6)
        half = 0.5 * other.pose["yaw"]
        np.testing.assert_allclose(seen["head"]["rotation"], [0, np.sin(half), 0, np.cos(half)], atol=1e-4)
    ada, bob = pair
    found = ada.picture()
    ada.page.evaluate("() => window.nearfar.viewer.setGuests(null)")
    without = ada.picture()
    mask = np.abs(found - without).max(axis=-1) > 20
    head = np.add(bob.pose["position"], [[0, 0, 0.06], [0, 0.1, 0.06], [0, -0.1, 0.06], [0, 0.25, 0]])
    for at in ada.pixel_of(head, CENTER, ZONES):
        assert has_changed(mask, at, 1.5)
    # Nothing else has changed: a head and a name at 4.5 m.
    rows, columns = np.nonzero(mask)
    middle = ada.pixel_of(head[:1], CENTER, ZONES)[0]
    assert np.hypot(columns - middle[0], rows - middle[1]).max() < 40


def test_a_pointer_ends_at_its_target_for_every_viewer(pair: tuple[RoomPage, RoomPage], city: nf.Scene) -> None:
    for pixel in TARGETS:
        check_pointer(*pair, city, pixel)


def check_pointer(ada: RoomPage, bob: RoomPage, city: nf.Scene, pixel: tuple[int, int]) -> None:
    """Bob points at a pixel; check where Ada sees the pointer end."""
    bob.page.keyboard.up("e")
    bob.step()
    end = ends(bob.point_at(*pixel)["own"])[1]
    rho = float(np.hypot(*np.subtract(end, CENTER)[[0, 2]]))
    # It is a point of the scene, which Bob's picture shows in that pixel; on the map the error is a texel.
    near = rho < RADII[-1]
    assert nf.nearest_points(city, [end]).distance[0] < (0.1 if near else 0.02 * rho)
    shown = bob.pixel_of([end], CENTER, ZONES)[0]
    assert np.hypot(*(shown - np.add(pixel, 0.5))) < (0.6 if near else 1.0)

    wait_until(ada.page, lambda: bob.step() and sees(ada, end, max(0.02, 1e-3 * rho)))
    seen = ada.step()["seen"][0]
    assert np.linalg.norm(ends(seen)[1] - end) < 0.1
    mask = pointer_mask(ada, seen["number"])
    begin = ends(seen)[0]
    for share in (0.2, 0.5, 0.8):
        at = ada.pixel_of([begin + share * (end - begin)], CENTER, ZONES)[0]
        assert has_changed(mask, at, 1.5), f"the ray is not seen at {share}"
    places = ada.pixel_of([begin + 0.9 * (end - begin), end], CENTER, ZONES)
    assert has_changed(mask, places[1], 1.5)
    # The pointer does not continue behind the spot.
    assert reach_beyond(mask, *places) < 4
    bob.page.keyboard.up("e")
    wait_until(ada.page, lambda: bob.step() and ada.step()["seen"][0]["pointer"] is None)


def test_left_of_the_divider_pointers_match_the_scene_there(pair: tuple[RoomPage, RoomPage], city: nf.Scene) -> None:
    ada, bob = pair
    divide = "(share) => window.nearfar.viewer.setDivider(share)"
    pixel, unmorphed = (150, 178), (1e5, 2e5)
    morphed = ends(bob.point_at(*pixel)["own"])[1]
    bob.page.keyboard.up("e")
    bob.step()
    try:
        for each in pair:
            each.page.evaluate(divide, 0.5)
        end = ends(bob.point_at(*pixel)["own"])[1]
        # Another point of the scene, which the conventional picture shows in that pixel.
        assert np.linalg.norm(end - morphed) > 0.3
        assert nf.nearest_points(city, [end]).distance[0] < 0.1
        assert np.hypot(*(bob.pixel_of([end], CENTER, unmorphed)[0] - np.add(pixel, 0.5))) < 0.6
        wait_until(ada.page, lambda: bob.step() and sees(ada, end, 0.02))
        place = ada.pixel_of([end], CENTER, unmorphed)[0]
        assert place[0] < 0.5 * SIZE[0] - 4
        assert has_changed(pointer_mask(ada, ada.step()["seen"][0]["number"]), place, 1.5)
    finally:
        for each in pair:
            each.page.evaluate(divide, None)
        bob.page.keyboard.up("e")
        bob.step()


def sees(viewer: RoomPage, end: Any, most: float) -> bool:
    """Whether a viewer sees the other user's pointer end within some metres of a point."""
    seen = viewer.step()["seen"][0]
    return bool(seen["pointer"]) and bool(np.linalg.norm(ends(seen)[1] - end) < most)


def test_the_middle_button_and_the_touch_button_point(pair: tuple[RoomPage, RoomPage]) -> None:
    _, bob = pair
    bob.page.mouse.move(380.5, 175.5)
    assert bob.step()["own"]["pointer"] is None
    bob.page.mouse.down(button="middle")
    bob.page.wait_for_timeout(AIMS)
    at = bob.pixel_of([ends(bob.step()["own"])[1]], CENTER, ZONES)[0]
    assert np.hypot(*(at - (380.5, 175.5))) < 0.6
    bob.page.mouse.up(button="middle")
    assert bob.step()["own"]["pointer"] is None
    bob.page.wait_for_timeout(AIMS)
    press = "([name]) => document.querySelector('[aria-keyshortcuts=E]').dispatchEvent(new PointerEvent(name))"
    bob.page.evaluate("() => { Element.prototype.setPointerCapture = () => undefined; }")
    bob.page.evaluate(press, ["pointerdown"])
    at = bob.pixel_of([ends(bob.step()["own"])[1]], CENTER, ZONES)[0]
    assert np.hypot(*(at - np.multiply(SIZE, 0.5))) < 1.2
    bob.page.evaluate(press, ["pointerup"])
    assert bob.step()["own"]["pointer"] is None


def pointer_mask(viewer: RoomPage, number: int) -> Any:
    """Pixels (H, W) that change when a user's pointer is muted."""
    mute = "([number, isMuted]) => window.nearfar.room.presence.mute(number, isMuted)"
    viewer.page.evaluate("() => window.nearfar.viewer.setGuests(window.nearfar.room.avatars)")
    found = viewer.picture()
    viewer.page.evaluate(mute, [number, True])
    without = viewer.picture()
    viewer.page.evaluate(mute, [number, False])
    return np.abs(found - without).max(axis=-1) > 12


def test_far_users_are_in_front_of_or_behind_the_map(pair: tuple[RoomPage, RoomPage], city: nf.Scene) -> None:
    ada, _ = pair
    ada.page.evaluate("() => window.nearfar.viewer.setGuests(window.nearfar.room.avatars)")
    yaw, away = far_wall(city)
    ada.pose, before = {"position": list(CENTER), "yaw": yaw, "pitch": 0.0}, ada.pose
    try:
        ahead = np.array([-np.sin(yaw), 0, -np.cos(yaw)])
        empty = ada.picture()
        for share, is_seen in ((0.7, True), (1.3, False)):
            head = {"position": (CENTER + share * away * ahead).tolist(), "rotation": [0, 0, 0, 1]}
            ada.page.evaluate(HEAR, [999, {"head": head, "left": None, "right": None, "pointer": None}])
            mask = np.abs(ada.picture() - empty).max(axis=-1) > 12
            assert has_changed(mask, np.multiply(SIZE, 0.5), 3) == is_seen
    finally:
        ada.page.evaluate("() => window.nearfar.room.presence.hear({ kind: 'left', user: 999 }, 0)")
        ada.pose = before


def far_wall(city: nf.Scene) -> tuple[float, float]:
    """A direction, as yaw, in which the centre sees a wall beyond the last ring, and its distance."""
    yaws = np.linspace(-np.pi, np.pi, 720, endpoint=False)
    aheads = np.stack([-np.sin(yaws), np.zeros_like(yaws), -np.cos(yaws)], axis=1)
    aways = nf.cast_rays(city, np.broadcast_to(CENTER, aheads.shape), aheads).t_hit
    spread = np.stack([np.roll(aways, shift) for shift in range(-3, 4)])
    is_wall = (spread.min(axis=0) > 35) & (spread.max(axis=0) < 1.1 * spread.min(axis=0)) & (aways < 120)
    number = int(np.argmax(is_wall))
    assert is_wall[number]
    return float(yaws[number]), float(aways[number])


HIDE = """(isHidden) => {
  Object.defineProperty(document, 'hidden', { configurable: true, value: isHidden });
  document.dispatchEvent(new Event('visibilitychange'));
}"""


def test_a_hidden_page_releases_its_pointer_for_others(pair: tuple[RoomPage, RoomPage]) -> None:
    ada, bob = pair
    bob.point_at(240, 178)
    wait_until(ada.page, lambda: bob.step() and ada.step()["seen"][0]["pointer"] is not None)
    # A hidden page draws no frames.
    bob.page.evaluate(HIDE, True)
    wait_until(ada.page, lambda: ada.step()["seen"][0]["pointer"] is None)
    bob.page.evaluate(HIDE, False)
    wait_until(ada.page, lambda: bob.step() and ada.step()["seen"][0]["pointer"] is not None)
    bob.page.keyboard.up("e")


def fits(page: Any, size: tuple[int, int]) -> bool:
    """Whether the card lies on the page, above its tools."""
    boxes = [page.locator(name).bounding_box() for name in (".here-chip", ".here", ".tools")]
    for box in boxes:
        assert box["x"] >= 0
        assert box["y"] >= 0
        assert box["x"] + box["width"] <= size[0]
        assert box["y"] + box["height"] <= size[1]
    return bool(boxes[1]["y"] + boxes[1]["height"] <= boxes[2]["y"])


def count(server: Server, name: str) -> int:
    """The value of a server metric."""
    with urllib.request.urlopen(f"{server.url}metrics") as answer:
        found = re.findall(rf"^{re.escape(name)} (\d+)$", answer.read().decode(), re.MULTILINE)
    return int(found[0]) if found else 0


BYES = 'nearfar_room_closes_total{reason="bye"}'


def test_the_card_lists_users_and_leaves_the_room(chromium: Any, server: Server, url: str) -> None:
    ended = count(server, BYES)
    with open_page(chromium, *DESKTOP, device_scale_factor=0.25) as page, open_page(chromium, *SMALL) as other:
        for shown, name, group in ((page, "Ada", 0), (other, "Grace Hopper", 1)):
            shown.goto(f"{url}&rings=0&room=card&name={name}&group={group}&token=mine")
        page.get_by_role("button", name="2 here").click()
        card = page.get_by_role("region", name="Here")
        you, guest = card.get_by_role("listitem").all_inner_texts()
        assert you == "Ada (you)"
        assert re.fullmatch(r"Grace Hopper #\d+ \(other group\)", guest)
        card.get_by_role("button", name="Mute the pointer of Grace Hopper").click()
        page.get_by_role("button", name="Show the pointer of Grace Hopper").wait_for()
        assert page.evaluate("() => window.nearfar.room.presence.guests.map(({ isMuted }) => isMuted)") == [True]
        link = page.evaluate("""() => new Promise((done) => {
          navigator.clipboard.writeText = async (text) => done(text);
          [...document.querySelectorAll('.here button')].find((button) => button.textContent === 'Copy link').click();
        })""")
        assert "room=card&group=0" in link
        assert "mine" not in link
        assert "Ada" not in link
        assert fits(page, DESKTOP)
        page.set_viewport_size(dict(zip(("width", "height"), PHONE, strict=True)))
        wait_until(page, lambda: page.evaluate("() => innerWidth") == PHONE[0])
        assert fits(page, PHONE)
        other.goto("about:blank")
        page.get_by_role("button", name="1 here").wait_for()
        assert count(server, BYES) == ended + 1
        page.keyboard.press("?")
        page.get_by_role("dialog").get_by_text("point at the cursor").wait_for()
        page.keyboard.press("Escape")
        card.get_by_role("button", name="Leave").click()
        card.get_by_text("You have left the room.").wait_for()
        assert not card.get_by_role("button", name="Leave").is_visible()
        wait_until(page, lambda: count(server, BYES) == ended + 2)
        card.get_by_role("button", name="Join again").click()
        page.get_by_role("button", name="1 here").wait_for()
        assert page.printed == []


def test_impossible_rooms_and_rules_are_reported(chromium: Any, url: str) -> None:
    with open_page(chromium, *SIZE) as page:
        page.goto(f"{url}&rings=0&room=a/b")
        assert "expected a name" in page.get_by_role("region", name="Here").inner_text()
        page.goto(f"{url}&rings=0&room=wrong&task=collect&users=0")
        page.get_by_text("users: expected a whole number from 1 to 64").first.wait_for()
        assert page.evaluate("() => window.nearfar.room.activity") is None
        assert page.printed == []


USER = "() => window.nearfar?.room?.connection.state.user ?? null"


def has_user(page: Any) -> bool:
    """Whether the page is in its room."""
    return page.evaluate(USER) is not None


def test_users_by_datagrams_and_by_sockets_meet_and_keep_their_numbers(chromium: Any, server: Server) -> None:
    seen = "() => (window.nearfar?.room?.seen ?? []).map(({ name }) => name)"
    measured = "() => window.nearfar.room.connection.roundTrips.median !== null"
    sockets: list[Any] = []
    with open_page(chromium, *SMALL) as one, open_page(chromium, *SMALL) as other:
        for page, name, way in ((one, "Ada", "on"), (other, "Bob", "off")):
            page.on("websocket", lambda _, page=page: sockets.append(page))
            page.goto(f"{server.url}?rings=0&room=ways&name={name}&datagrams={way}")
        wait_until(one, lambda: one.evaluate(seen) == ["Bob"])
        wait_until(other, lambda: other.evaluate(seen) == ["Ada"])
        # A page that sees others without a WebSocket uses WebTransport.
        assert sockets == [other]
        for page in (one, other):
            # Queued poses for each are acknowledged, though nobody moves.
            wait_until(page, partial(page.evaluate, measured))
        for page in (one, other):
            number = page.evaluate(USER)
            # A duplicated tab would copy the ticket.
            assert page.evaluate("() => sessionStorage.length") == 0
            page.reload()
            wait_until(page, partial(has_user, page))
            assert page.evaluate(USER) == number
            assert page.printed == []
