"""Loss of the graphics context while the user wears a headset."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from nearfar.serve._server import Server
from tests.support import need
from tests.support.browser import canvas, wait_for_ring, wait_until
from tests.support.headset import enter, frames, worn

pytestmark = pytest.mark.slow

SIZE = (80, 100)

LOSE = """() => {
  const { renderer } = window.nearfar.viewer;
  window.loss = renderer.getContext().getExtension('WEBGL_lose_context');
  window.loss.loseContext();
}"""
EMULATOR = "Cannot read properties of null (reading '0')"
"""The emulator reads the clear colour of a lost context, in the frame after the loss."""
PRESENTS = "() => window.nearfar.viewer.renderer.xr.isPresenting"


@pytest.fixture
def page(chromium: Any, street: Path) -> Iterator[Any]:
    need("web")
    with (
        Server.of_bundle(street) as server,
        worn(chromium, f"{server.url}?aa=0&strategy=clovrd", "quest3", SIZE, 1) as shown,
    ):
        yield shown


def test_a_context_loss_leaves_the_headset_which_can_be_entered_again(page: Any) -> None:
    page.evaluate(LOSE)
    # The user does not stay in the dark: the page with its message is visible again.
    wait_until(page, lambda: not page.evaluate(PRESENTS))
    wait_until(page, lambda: "graphics" in page.locator("#message").inner_text())
    page.evaluate("() => window.loss.restoreContext()")
    wait_until(page, lambda: page.locator("#message").inner_text() == "")
    assert wait_for_ring(page, 1) == ""
    wait_until(page, lambda: canvas(page).std() > 10)
    # The headset can be entered again, and shows pictures.
    enter(page)
    page.wait_for_function(PRESENTS)
    frames(page, 3)
    shown = page.evaluate("() => window.emulated.capture((shown) => shown.ring === 1)")
    assert len(shown["eyes"]) >= 2
    assert [text for text in page.printed if "Context" not in text and text != EMULATOR] == []
