"""A page in headless Chromium, driven by Playwright."""

from __future__ import annotations

import asyncio
import io
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack, contextmanager
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from tests.support.reader_cases import BROWSER_FLAGS, SECONDS, browser

STATE = """() => ({
  problem: document.querySelector('#message').textContent,
  arrived: window.nearfar ? window.nearfar.viewer.facts.arrived : -1,
})"""

STILL = """([picture, pose, width, height, rests]) => {
  const viewer = window.nearfar.viewer;
  if (rests) viewer.renderer.setAnimationLoop(null);
  viewer.still(picture, pose);
  const gl = viewer.renderer.getContext();
  const pixels = new Uint8Array(4 * width * height);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  return btoa(Array.from(pixels, (byte) => String.fromCharCode(byte)).join(''));
}"""


WEBGPU = ("--enable-unsafe-webgpu", "--enable-features=Vulkan", "--use-vulkan=swiftshader")
"""Flags that give Chromium WebGPU in software: it draws on canvases, but does not present them or request frames."""

FRAMES = "window.requestAnimationFrame = (frame) => setTimeout(() => frame(performance.now()), 16)"
"""Requests frames in its place."""

NO_WEBGPU = "No available adapters."
"""Message of Chromium when a page requests WebGPU and none is available."""

SMALL = (160, 100)
"""Size of a page that is drawn very quickly; one of less than about 128 pixels gets two frames a second."""

LOOKS = 6000
"""Number of checks before a page counts as hung: five minutes of pauses, plus the answering time of a busy machine."""


_players: list[Any] = []
"""The running Playwright: there can be one in a thread."""

programs: list[Any] = []
"""Running browsers."""


@contextmanager
def started(path: str | None = None, flags: Sequence[str] = ()) -> Iterator[Any]:
    """Start Chromium, the one at a path if given, with further flags."""
    from playwright.sync_api import sync_playwright

    with ExitStack() as stack:
        if not _players:
            _players.append(stack.enter_context(sync_playwright()))
            stack.callback(_players.clear)
        _show_loop()
        program = _players[0].chromium.launch(
            executable_path=path or browser(), args=[*BROWSER_FLAGS, *flags], timeout=SECONDS * 1e3
        )
        stack.callback(program.close)
        programs.append(program)
        stack.callback(programs.remove, program)
        yield program


@contextmanager
def hidden_loop() -> Iterator[None]:
    """Hide Playwright's asyncio loop, so that other code can run one: it counts as running while there is a browser."""
    asyncio._set_running_loop(None)
    try:
        yield
    finally:
        _show_loop()


def _show_loop() -> None:
    if _players:
        asyncio._set_running_loop(_players[0]._loop)


@contextmanager
def open_page(program: Any, width: int, height: int, **settings: Any) -> Iterator[Any]:
    """A new page, with Playwright's settings; its output is in its list `printed`, except for missing WebGPU."""
    page = program.new_page(viewport={"width": width, "height": height}, **settings)
    page.printed = []
    page.on("console", lambda message: message.text == NO_WEBGPU or page.printed.append(message.text))
    page.on("pageerror", lambda error: page.printed.append(str(error)))
    try:
        yield page
    finally:
        page.close()


def wait_for_ring(page: Any, ring: int) -> str:
    """Wait until a ring is shown or the page reports a problem; returns the page's state."""
    problems: list[str] = []

    def has_come() -> bool:
        state = page.evaluate(STATE)
        problems.append(str(state["problem"]))
        return bool(state["problem"]) or state["arrived"] >= ring

    wait_until(page, has_come)
    return problems[-1]


def still(page: Any, picture: dict[str, Any], pose: dict[str, Any], *, rests: bool = True) -> NDArray[np.uint8]:
    """The page's picture (H, W, 3) of a ring, radius and strength, sRGB; it draws nothing more if it rests."""
    import base64

    size = page.viewport_size
    data = base64.b64decode(page.evaluate(STILL, [picture, pose, size["width"], size["height"], rests]))
    pixels = np.frombuffer(data, np.uint8).reshape(size["height"], size["width"], 4)
    return pixels[::-1, :, :3]


def wait_until(page: Any, happened: Callable[[], object]) -> None:
    """Wait until an event has happened; after the maximum number of checks, raise with the page's output."""
    for _ in range(LOOKS):
        if happened():
            return
        # Playwright calls handlers of requests only while it waits itself.
        page.wait_for_timeout(50)
    raise AssertionError(f"it does not happen: {page.printed}")


def canvas(page: Any) -> NDArray[np.uint8]:
    """The picture on the page, sRGB (H, W, 3)."""
    picture = Image.open(io.BytesIO(page.locator("canvas").screenshot()))
    return np.asarray(picture.convert("RGB"))
