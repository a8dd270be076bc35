"""How people use the page: keyboard, fingers, gamepads, the panel, links and pictures, on a desktop and a phone."""

from __future__ import annotations

import io
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from nearfar.serve._server import Server
from tests.support.browser import open_page, wait_for_ring, wait_until

pytestmark = pytest.mark.slow

DESKTOP, PHONE = (1000, 640), (390, 844)
FINE = 0.25
"""Picture pixels per layout pixel along one axis: drawing in software takes time."""

PAD = """() => {
  window.axes = [0, 0, 0, 0];
  const pad = () => ({ connected: true, mapping: 'standard', axes: window.axes, buttons: [] });
  navigator.getGamepads = () => [pad()];
}"""
"""A gamepad with two sticks: headless browsers have none."""

IS_AT_REST = """() => {
  const { goal, leaving } = window.nearfar.viewer.facts;
  return goal === null && leaving === null;
}"""


@pytest.fixture(scope="module")
def url(street: Path) -> Iterator[str]:
    with Server.of_bundle(street) as server:
        yield f"{server.url}?aa=0&strategy=clovrd"


@pytest.fixture(scope="module")
def loaded_page(chromium: Any, url: str) -> Iterator[Any]:
    with open_page(chromium, *DESKTOP, device_scale_factor=FINE) as shown:
        shown.add_init_script(f"({PAD})()")
        shown.goto(url)
        assert wait_for_ring(shown, 1) == ""
        yield shown
        assert shown.printed == []


@pytest.fixture
def page(loaded_page: Any) -> Any:
    """The page with nothing focused, at its start, after any jump of the test before and its cross-fade."""
    wait_until(loaded_page, lambda: loaded_page.evaluate(IS_AT_REST))
    loaded_page.evaluate(
        "() => { document.activeElement.blur(); window.nearfar.setPose(window.start ??= window.nearfar.pose); }"
    )
    return loaded_page


def pose(page: Any) -> dict[str, Any]:
    return dict(page.evaluate("() => window.nearfar.pose"))


def has_moved(page: Any, before: dict[str, Any]) -> bool:
    return bool(np.hypot(*np.subtract(pose(page)["position"], before["position"])[[0, 2]]) > 0.05)


def after_frames(page: Any) -> dict[str, Any]:
    """The pose after enough frames for pressed keys to have moved the user."""
    frames = (
        "() => new Promise((done) => { let n = 10; const f = () => (n-- ? requestAnimationFrame(f) : done()); f(); })"
    )
    page.evaluate(frames)
    return pose(page)


def test_tab_visits_everything_in_the_order_of_the_page(page: Any) -> None:
    page.get_by_text("No headset is connected.").wait_for()
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


def test_the_divider_is_moved_and_removed_by_keys(page: Any) -> None:
    page.keyboard.press("c")
    slider = page.get_by_role("slider")
    slider.focus()
    before = pose(page)
    for key, now in (("ArrowLeft", "49"), ("PageUp", "59"), ("Home", "0"), ("End", "100")):
        page.keyboard.press(key)
        assert slider.get_attribute("aria-valuenow") == now
    assert after_frames(page) == before
    page.keyboard.press("Escape")
    assert page.get_by_role("slider").count() == 0
    assert page.get_by_role("button", name="Split").get_attribute("aria-pressed") == "false"


def test_help_and_the_panel_are_opened_and_closed_by_keys(page: Any) -> None:
    figures = page.get_by_role("region", name="Figures")
    assert figures.is_visible()
    page.keyboard.press("?")
    dialog = page.get_by_role("dialog", name="How to move")
    assert dialog.is_visible()
    # The page does not mention headsets if there is none.
    assert not page.get_by_text("enter the headset").is_visible()
    before = pose(page)
    page.keyboard.down("w")
    assert after_frames(page) == before
    page.keyboard.up("w")
    page.keyboard.press("Escape")
    # The next key is processed, although the focus stays in the closed dialog for a moment.
    page.keyboard.press("i")
    assert not dialog.is_visible()
    assert not figures.is_visible()
    page.keyboard.press("i")
    assert figures.is_visible()


def test_keys_gamepads_and_dragging_move(page: Any) -> None:
    before = pose(page)
    page.keyboard.down("w")
    wait_until(page, lambda: has_moved(page, before))
    page.keyboard.up("w")
    page.keyboard.press("Home")
    page.evaluate("() => { window.axes = [0, -1, 1, 0]; }")
    wait_until(page, lambda: has_moved(page, before) and pose(page)["yaw"] < before["yaw"] - 0.1)
    page.evaluate("() => { window.axes = [0, 0, 0, 0]; }")
    page.keyboard.press("2")
    assert page.get_by_role("button", name="Orbit").get_attribute("aria-pressed") == "true"
    before = pose(page)
    page.mouse.move(600, 300)
    page.mouse.down()
    page.mouse.move(660, 300, steps=4)
    page.mouse.up()
    wait_until(page, lambda: has_moved(page, before))
    assert pose(page)["yaw"] != before["yaw"]
    page.keyboard.press("1")


def test_a_saved_picture_equals_the_screen_and_a_link_restores_the_pose(page: Any, url: str) -> None:
    page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    wanted = {"position": [3.5, 1.7, -2.25], "yaw": 0.5, "pitch": -0.1}
    page.evaluate("(pose) => window.nearfar.setPose(pose)", wanted)
    wait_until(page, lambda: pose(page)["yaw"] == wanted["yaw"])
    with page.expect_download() as saved:
        page.keyboard.press("p")
    picture = np.asarray(Image.open(Path(saved.value.path())).convert("RGB"), np.int16)
    assert saved.value.suggested_filename.startswith("nearfar ")
    assert picture.shape == (FINE * DESKTOP[1], FINE * DESKTOP[0], 3)
    page.keyboard.press("l")
    wait_until(page, lambda: "Link copied" in page.locator(".note").inner_text())
    link = page.evaluate("() => navigator.clipboard.readText()")
    assert link.startswith(url)
    page.goto("about:blank")
    page.goto(link)
    assert wait_for_ring(page, 1) == ""
    assert pose(page) == wanted
    page.evaluate("() => { document.querySelector('#ui').hidden = true; }")

    def is_on_the_screen() -> bool:
        screen = np.asarray(Image.open(io.BytesIO(page.screenshot())).convert("RGB"), np.int16)
        return bool((np.abs(picture - screen).max(axis=-1) <= 1).mean() > 0.999)

    wait_until(page, is_on_the_screen)


def test_everything_fits_on_a_phone_and_fingers_walk(chromium: Any, url: str) -> None:
    size = dict(zip(("width", "height"), PHONE, strict=True))
    around = chromium.new_context(viewport=size, has_touch=True, is_mobile=True, device_scale_factor=FINE)
    page = around.new_page()
    page.printed = []
    page.goto(url)
    assert wait_for_ring(page, 1) == ""
    for scheme in ("dark", "light"):
        page.emulate_media(color_scheme=scheme)
        # Nothing extends beyond the screen, no text is small, and a finger hits every button.
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
