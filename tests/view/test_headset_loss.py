"""Graphics that the browser takes away while somebody wears a headset."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest

import nearfar as nf
from nearfar.serve._server import Server
from tests.support import need
from tests.support.browser import canvas, started, wait_for_ring, wait_until
from tests.support.headset import folder_of, frames, worn

pytestmark = pytest.mark.slow

SIZE = (160, 160)
CENTER = (3.0, 1.7, -2.0)

LOSE = """() => {
  const { renderer } = window.nearfar.viewer;
  window.loss = renderer.getContext().getExtension('WEBGL_lose_context');
  window.loss.loseContext();
}"""
EMULATOR = "Cannot read properties of null (reading '0')"
"""The emulator asks a lost context for its colour of clearing, in the frame after the loss."""
PRESENTS = "() => window.nearfar.viewer.renderer.xr.isPresenting"


@pytest.fixture(scope="module")
def bundle(tmp_path_factory: pytest.TempPathFactory) -> nf.stream.Bundle:
    folder = tmp_path_factory.mktemp("loss") / "bundle"
    scene = nf.datasets.city(blocks=2, detail=1)
    return nf.stream.export(scene, folder, center=CENTER, radii=(10.0,), face_size=64, samples=1)


@pytest.fixture
def page(bundle: nf.stream.Bundle) -> Iterator[Any]:
    need("browser")
    need("web")
    with (
        started() as program,
        Server.of_bundle(folder_of(bundle)) as server,
        worn(program, f"{server.url}?aa=0&strategy=clovrd", "quest3", SIZE, 1) as shown,
    ):
        yield shown


def test_a_loss_leads_out_of_the_headset_and_back(page: Any) -> None:
    page.evaluate(LOSE)
    # Nobody stays in the dark: the page with its message is seen again.
    wait_until(page, lambda: not page.evaluate(PRESENTS))
    wait_until(page, lambda: "graphics" in page.locator("#message").inner_text())
    page.evaluate("() => window.loss.restoreContext()")
    wait_until(page, lambda: page.locator("#message").inner_text() == "")
    assert wait_for_ring(page, 1) == ""
    wait_until(page, lambda: canvas(page).std() > 10)
    # The headset can be entered again, and shows pictures.
    page.get_by_role("button", name="Enter VR").click()
    page.wait_for_function(PRESENTS)
    frames(page, 3)
    shown = page.evaluate("() => window.emulated.capture((shown) => shown.ring === 1)")
    assert len(shown["eyes"]) >= 2
    assert [text for text in page.printed if "Context" not in text and text != EMULATOR] == []
