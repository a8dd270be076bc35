"""Faults while the page loads, in a browser: each is reported or overcome, and the last good picture stays."""

from __future__ import annotations

import json
from collections.abc import Iterator
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar.serve._server import Server
from tests.support.browser import SMALL, canvas, open_page, still, wait_for_ring, wait_until
from tests.support.bundled_scenes import bundled_scenes

pytestmark = pytest.mark.slow

CENTER = (3.0, 1.7, -2.0)
RADII = (10.0, 22.0)
HOSTILE = "<img src=x onerror='window.ran=1'>\"'><script>window.ran=1</script>"


@pytest.fixture(scope="module")
def place(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("faults") / "bundle"
    nf.stream.export(bundled_scenes()["city"], folder, center=CENTER, radii=RADII, face_size=64, samples=1)
    return folder


@pytest.fixture(scope="module")
def url(place: Path) -> Iterator[str]:
    with Server.of_bundle(place) as server:
        yield f"{server.url}?aa=0"


@pytest.fixture
def page(chromium: Any) -> Iterator[Any]:
    with open_page(chromium, *SMALL) as shown:
        yield shown


HIDING = """
  const [ask, waiting] = [window.requestAnimationFrame.bind(window), []];
  let [state, away] = ['visible', 0];
  Object.defineProperty(document, 'visibilityState', { get: () => state });
  Object.defineProperty(document, 'hidden', { get: () => state === 'hidden' });
  window.requestAnimationFrame = (draw) => {
    const later = (now) => draw(now + away);
    return state === 'hidden' ? waiting.push(later) : ask(later);
  };
  window.hide = (seconds) => {
    state = 'hidden';
    document.dispatchEvent(new Event('visibilitychange'));
    return new Promise((done) => setTimeout(() => {
      [state, away] = ['visible', away + 1000 * seconds];
      document.dispatchEvent(new Event('visibilitychange'));
      waiting.splice(0).forEach(ask);
      done();
    }, 100));
  };
"""
"""Browsers give hidden tabs no frames. A headless one hides nothing, so the page is told so here."""

GROWTH = """() => {
  window.states = [];
  const look = () => {
    const { shown } = window.nearfar.viewer.facts;
    if (shown) window.states.push(shown.grown.strength);
    requestAnimationFrame(look);
  };
  requestAnimationFrame(look);
}"""


def test_a_hidden_tab_continues_where_it_was(page: Any, url: str) -> None:
    page.add_init_script(HIDING)
    page.goto(url)
    assert wait_for_ring(page, 1) == ""
    page.evaluate(GROWTH)
    states = partial(page.evaluate, "() => window.states")
    wait_until(page, lambda: len(states()) > 3 and states()[-1] > 0)
    page.evaluate("() => hide(60)")
    before = len(states())
    wait_until(page, lambda: len(states()) > before + 3)
    steps = np.diff(states())
    # The whole growth of ring 1 takes more than ten seconds, and no frame advances by more than a tenth of one.
    assert (steps >= 0).all()
    assert steps.max() <= 0.1 / 10
    assert page.printed == []


def test_names_are_always_shown_as_text(page: Any, tmp_path: Path) -> None:
    builder = nf.SceneBuilder()
    corners, faces = np.array([[-5.0, 0, -5], [5, 0, -5], [0, 0, 5]]), [[0, 2, 1]]
    builder.instance(builder.mesh(corners, faces), name=f"floor {HOSTILE}")
    builder.instance(builder.mesh(corners * 0.1 + np.array([0, 1, -3]), faces), name=f"car {HOSTILE}")
    scene = builder.build(dynamic=[f"car {HOSTILE}"])
    bundle = nf.stream.export(scene, tmp_path / "b", center=(0, 1.7, 0), radii=[8.0], face_size=64, samples=1)
    place = Path(bundle._reader.location)
    manifest = json.loads((place / "manifest.json").read_text())
    manifest["notes"] = [HOSTILE]
    manifest["regions"][0]["findings"] = [HOSTILE]
    with Server.of_bundle(place) as server:
        page.route("**/manifest.json", lambda route: route.fulfill(body=json.dumps(manifest)))
        page.goto(f"{server.url}#{HOSTILE}")
        assert wait_for_ring(page, 1) == ""
        assert page.evaluate("() => [window.ran ?? 0, document.images.length, document.scripts.length]") == [0, 0, 1]
        assert page.printed == []
        # In errors, too.
        manifest["regions"][0]["rings"][1]["geometry"] = HOSTILE
        page.reload()
        told = wait_for_ring(page, 1)
        assert "<img" in told
        assert page.evaluate("() => [window.ran ?? 0, document.images.length, document.scripts.length]") == [0, 0, 1]
        assert page.printed == []


LOSE = """() => {
  const { renderer } = window.nearfar.viewer;
  window.loss = renderer.getContext().getExtension('WEBGL_lose_context');
  window.loss.loseContext();
}"""


def test_a_restored_context_shows_the_picture(page: Any, url: str) -> None:
    state, pose = {"ring": 2, "radius": 15.0, "strength": 1.0}, {"position": CENTER, "yaw": 0.7, "pitch": 0.0}
    page.goto(f"{url}&strategy=clovrd")
    assert wait_for_ring(page, len(RADII)) == ""
    before = still(page, state, pose, rests=False)
    page.evaluate(LOSE)
    wait_until(page, lambda: "graphics" in page.locator("#message").inner_text())
    page.evaluate("() => window.loss.restoreContext()")
    wait_until(page, lambda: page.locator("#message").inner_text() == "")
    assert wait_for_ring(page, len(RADII)) == ""
    assert np.array_equal(still(page, state, pose, rests=False), before)
    assert before.std() > 10
    assert [text for text in page.printed if "Context" not in text] == []
    # If the context is not restored, the page reloads at the user's position.
    place = [CENTER[0] + 0.5, CENTER[1], CENTER[2] - 0.25]
    page.evaluate("(position) => window.nearfar.setPose({ position, yaw: 0.5, pitch: 0 })", place)
    wait_until(page, lambda: page.evaluate("() => window.nearfar.pose.yaw") == 0.5)
    page.evaluate(LOSE)
    page.get_by_role("button", name="Try again").click()
    wait_until(page, lambda: page.evaluate("() => !('loss' in window) && window.nearfar !== undefined"))
    assert wait_for_ring(page, 1) == ""
    assert page.evaluate("() => window.nearfar.pose") == {"position": place, "yaw": 0.5, "pitch": 0}


def test_a_damaged_file_keeps_the_last_picture_and_is_fetched_again_on_retry(page: Any, url: str, place: Path) -> None:
    """The browser may cache the damaged copy, which the server's headers mark as immutable."""
    manifest = json.loads((place / "manifest.json").read_text())
    name = manifest["regions"][0]["rings"][2]["geometry"]
    content = (place / name).read_bytes()
    answers = [content, content[:-5] + b"12345"]
    page.route(f"**/{name}", lambda route: route.fulfill(body=answers.pop()))
    page.add_init_script(
        """window.asked = [];
        const ask = window.fetch;
        window.fetch = (url, how) => { window.asked.push([String(url), how?.cache]); return ask(url, how); };"""
    )
    page.goto(f"{url}&strategy=clovrd")
    assert name in wait_for_ring(page, len(RADII))
    facts = "() => [window.nearfar.viewer.facts.arrived, window.nearfar.viewer.facts.shown?.ring]"
    wait_until(page, lambda: page.evaluate(facts) == [1, 1])
    show = "(isShown) => { document.querySelector('#ui').hidden = !isShown; }"
    page.evaluate(show, False)
    assert canvas(page).std() > 10
    page.evaluate(show, True)
    page.get_by_role("button", name="Try again").click()
    wait_until(page, lambda: page.evaluate(facts) == [2, 2])
    asked = [how for address, how in page.evaluate("() => window.asked") if name in address]
    assert asked == ["default", "reload"]
    assert page.locator("#message").inner_text() == ""


def test_missing_webgl_and_a_missing_scene_are_reported(page: Any, url: str) -> None:
    page.route("**/manifest.json", lambda route: route.fulfill(status=404))
    page.goto(url)
    assert "cannot be reached" in wait_for_ring(page, 0)
    page.unroute("**/manifest.json")
    page.add_init_script("HTMLCanvasElement.prototype.getContext = () => null;")
    page.goto(url)
    assert "WebGL 2" in wait_for_ring(page, 0)
