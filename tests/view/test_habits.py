"""How people use the page: keys alone, fingers, gamepads, the panel, links and pictures, on a desktop and a phone."""

from __future__ import annotations

import io
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

import nearfar as nf
from nearfar.serve._server import Server
from tests.support.browser import opened, wait_for_ring, wait_until

pytestmark = pytest.mark.slow

CENTER = (3.0, 1.7, -2.0)
DESKTOP, PHONE = (1000, 640), (390, 844)

PAD = """() => {
  window.axes = [0, 0, 0, 0];
  const pad = () => ({ connected: true, mapping: 'standard', axes: window.axes, buttons: [] });
  navigator.getGamepads = () => [pad()];
}"""
"""A gamepad with two sticks: headless browsers have none."""


@pytest.fixture(scope="module")
def url(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    folder = tmp_path_factory.mktemp("habits") / "bundle"
    scene = nf.datasets.city(blocks=2, detail=1)
    nf.stream.export(scene, folder, center=CENTER, radii=(10.0,), face_size=64, samples=1)
    with Server.of_bundle(Path(folder)) as server:
        yield f"{server.url}?aa=0&strategy=clovrd"


@pytest.fixture
def page(chromium: Any, url: str) -> Iterator[Any]:
    with opened(chromium, *DESKTOP) as shown:
        shown.add_init_script(f"({PAD})()")
        shown.goto(url)
        assert wait_for_ring(shown, 1) == ""
        yield shown
        assert shown.printed == []


def pose(page: Any) -> dict[str, Any]:
    return dict(page.evaluate("() => window.nearfar.pose"))


def has_moved(page: Any, before: dict[str, Any]) -> bool:
    return bool(np.hypot(*np.subtract(pose(page)["position"], before["position"])[[0, 2]]) > 0.05)


def test_tab_leads_through_everything_in_the_order_of_the_page(page: Any) -> None:
    names = []
    for _ in range(10):
        page.keyboard.press("Tab")
        found = page.evaluate("""() => {
          const { activeElement: on } = document;
          const { outlineStyle, outlineWidth } = getComputedStyle(on);
          return [on.getAttribute('aria-label') ?? on.innerText, outlineStyle, parseFloat(outlineWidth)];
        }""")
        names.append(found[0].split(".")[0])
        assert found[1] == "solid", f"focus is not seen on {found[0]}"
        assert found[2] >= 2
    buttons = ["Walk", "Orbit", "Split", "Home", "Photo", "Link", "Info", "Help"]
    assert names == ["The scene", "Hide the figures", *buttons]


def test_the_divider_is_moved_and_taken_away_by_keys(page: Any) -> None:
    page.keyboard.press("c")
    slider = page.get_by_role("slider")
    slider.focus()
    before = pose(page)
    for key, now in (("ArrowLeft", "49"), ("PageUp", "59"), ("Home", "0"), ("End", "100")):
        page.keyboard.press(key)
        assert slider.get_attribute("aria-valuenow") == now
    page.wait_for_timeout(200)
    assert pose(page) == before
    page.keyboard.press("Escape")
    assert page.get_by_role("slider").count() == 0
    assert page.get_by_role("button", name="Split").get_attribute("aria-pressed") == "false"


def test_a_key_hides_the_panel_and_shows_it(page: Any) -> None:
    figures = page.get_by_role("region", name="Figures")
    assert figures.is_visible()
    page.keyboard.press("i")
    assert not figures.is_visible()
    page.keyboard.press("i")
    assert figures.is_visible()


def test_help_is_opened_and_closed_by_keys(page: Any) -> None:
    page.keyboard.press("?")
    dialog = page.get_by_role("dialog", name="How to move")
    assert dialog.is_visible()
    before = pose(page)
    page.keyboard.down("w")
    page.wait_for_timeout(200)
    page.keyboard.up("w")
    assert pose(page) == before
    page.keyboard.press("Escape")
    # The next key is heard, although the focus stays in the closed dialog for a moment.
    page.keyboard.press("i")
    assert not dialog.is_visible()
    assert not page.get_by_role("region", name="Figures").is_visible()


def test_keys_and_gamepads_walk_and_turn(page: Any) -> None:
    before = pose(page)
    page.keyboard.down("w")
    wait_until(page, lambda: has_moved(page, before))
    page.keyboard.up("w")
    page.keyboard.press("Home")
    page.evaluate("() => { window.axes = [0, -1, 1, 0]; }")
    wait_until(page, lambda: has_moved(page, before) and pose(page)["yaw"] < before["yaw"] - 0.1)
    page.evaluate("() => { window.axes = [0, 0, 0, 0]; }")


def test_dragging_goes_around_a_point_in_orbit(page: Any) -> None:
    page.keyboard.press("2")
    assert page.get_by_role("button", name="Orbit").get_attribute("aria-pressed") == "true"
    before = pose(page)
    page.mouse.move(600, 300)
    page.mouse.down()
    page.mouse.move(660, 300, steps=4)
    page.mouse.up()
    wait_until(page, lambda: has_moved(page, before))
    assert pose(page)["yaw"] != before["yaw"]


def test_a_saved_picture_is_the_one_on_the_screen_and_a_link_keeps_the_pose(page: Any, url: str) -> None:
    page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    wanted = {"position": [3.5, 1.7, -2.25], "yaw": 0.5, "pitch": -0.1}
    page.evaluate("(pose) => window.nearfar.setPose(pose)", wanted)
    wait_until(page, lambda: pose(page)["yaw"] == wanted["yaw"])
    page.wait_for_timeout(200)
    with page.expect_download() as saved:
        page.keyboard.press("p")
    picture = np.asarray(Image.open(Path(saved.value.path())).convert("RGB"), np.int16)
    assert saved.value.suggested_filename.startswith("nearfar ")
    assert picture.shape == (DESKTOP[1], DESKTOP[0], 3)
    page.keyboard.press("l")
    wait_until(page, lambda: "Link copied" in page.locator(".note").inner_text())
    link = page.evaluate("() => navigator.clipboard.readText()")
    assert link.startswith(url)
    page.goto("about:blank")
    page.goto(link)
    assert wait_for_ring(page, 1) == ""
    assert pose(page) == wanted
    page.evaluate("() => { document.querySelector('#ui').hidden = true; }")
    page.wait_for_timeout(500)
    screen = np.asarray(Image.open(io.BytesIO(page.screenshot())).convert("RGB"), np.int16)
    assert (np.abs(picture - screen).max(axis=-1) <= 1).mean() > 0.999


@pytest.mark.parametrize("scheme", ["dark", "light"])
def test_a_phone_has_room_for_everything_and_fingers_walk(chromium: Any, url: str, scheme: str) -> None:
    around = chromium.new_context(
        viewport=dict(zip(("width", "height"), PHONE, strict=True)), has_touch=True, is_mobile=True, color_scheme=scheme
    )
    page = around.new_page()
    page.printed = []
    page.goto(url)
    assert wait_for_ring(page, 1) == ""
    # Nothing reaches beyond the screen, no text is small, and a finger hits every button.
    boxes = page.evaluate("""() => {
      const seen = [...document.querySelectorAll('button')].filter((one) => one.offsetParent);
      return seen.map((one) => {
        const { left, right, top, bottom } = one.getBoundingClientRect();
        return [left, innerWidth - right, top, innerHeight - bottom, right - left, bottom - top];
      });
    }""")
    assert len(boxes) >= 8
    assert np.min(np.array(boxes)[:, :4]) >= 0
    assert np.min(np.array(boxes)[:, 4:]) >= 44
    sizes = page.evaluate("""() => [...document.querySelectorAll('#ui *')].filter((one) => one.offsetParent)
      .map((one) => parseFloat(getComputedStyle(one).fontSize))""")
    assert min(sizes) >= 12
    before = pose(page)
    finger = around.new_cdp_session(page)
    finger.send("Input.dispatchTouchEvent", {"type": "touchStart", "touchPoints": [{"x": 90, "y": 500}]})
    finger.send("Input.dispatchTouchEvent", {"type": "touchMove", "touchPoints": [{"x": 90, "y": 440}]})
    wait_until(page, lambda: has_moved(page, before))
    finger.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})
    around.close()


@pytest.mark.parametrize(
    ("asked", "expected"), [("strategy=fast", "expected clovr"), ("rings=two", "number of a ring")]
)
def test_an_address_that_asks_for_what_is_not_there_is_told(chromium: Any, url: str, asked: str, expected: str) -> None:
    with opened(chromium, *PHONE) as page:
        page.goto(f"{url.partition('?')[0]}?{asked}")
        told = wait_for_ring(page, 0)
        assert "The address asks" in told
        assert expected in told
