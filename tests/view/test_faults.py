"""Faults on the way to the page, in a browser: each is told or overcome, and the last good picture stays."""

from __future__ import annotations

import json
import threading
import time
from collections.abc import Iterator
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar.serve._server import Server
from tests.support.browser import canvas, opened, still, wait_for_ring, wait_until
from tests.support.bundled_scenes import bundled_scenes

pytestmark = pytest.mark.slow

SIZE = (240, 160)
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
    with opened(chromium, *SIZE) as shown:
        yield shown


def ring_file(place: Path, ring: int, *, map_: bool = False) -> str:
    """The name of a file that one ring alone needs: its geometry, or the picture of its map."""
    manifest = json.loads((place / "manifest.json").read_text())
    entry = manifest["regions"][0]["rings"][ring]
    return str(entry["map"]["color"] if map_ else entry["geometry"])


def arrived(page: Any) -> int:
    return int(page.evaluate("() => window.nearfar?.viewer.facts.arrived ?? -1"))


def shown_ring(page: Any) -> int:
    return int(page.evaluate("() => window.nearfar.viewer.facts.shown?.ring ?? -1"))


@pytest.mark.parametrize("map_", [False, True])
def test_a_late_ring_is_waited_for(page: Any, url: str, place: Path, map_: bool) -> None:
    held: list[Any] = []
    page.route(f"**/{ring_file(place, 1, map_=map_)}", lambda route: held.append(route))
    page.goto(url)
    assert wait_for_ring(page, 0) == ""
    wait_until(page, lambda: len(held) > 0)
    # Files of the ring after it may be there; it is not shown before.
    page.wait_for_timeout(500)
    assert (arrived(page), shown_ring(page)) == (0, 0)
    assert canvas(page).std() > 10
    held[0].continue_()
    assert wait_for_ring(page, len(RADII)) == ""
    assert page.printed == []


def test_files_that_come_in_the_wrong_order_are_shown_in_the_right_one(page: Any, url: str, place: Path) -> None:
    """Every file of ring 1 comes only when no other file is asked for any more."""
    manifest = json.loads((place / "manifest.json").read_text())
    first, second = manifest["regions"][0]["rings"][1:]
    own = {*first["parts"], first["geometry"], first["map"]["color"], *first["map"]["range"]}
    own -= {*second["parts"]}
    held: list[Any] = []
    for name in own:
        page.route(f"**/{name}", lambda route: held.append(route))
    page.goto(url)
    assert wait_for_ring(page, 0) == ""
    wait_until(page, lambda: len(held) > 0)
    page.wait_for_timeout(300)
    rings: list[int] = []
    while arrived(page) < len(RADII):
        while held:
            held.pop().continue_()
        rings.append(arrived(page))
        page.wait_for_timeout(50)
    assert rings == sorted(rings)
    assert wait_for_ring(page, len(RADII)) == ""


class _Stalling(SimpleHTTPRequestHandler):
    """Sends half of one file and then nothing, the first time that it is asked for."""

    stalls: str
    asked: list[str]
    over: threading.Event

    def do_GET(self) -> None:
        name = self.path.partition("?")[0].lstrip("/")
        self.asked.append(name)
        if name != self.stalls or self.asked.count(name) > 1:
            super().do_GET()
            return
        content = Path(self.translate_path(self.path)).read_bytes()
        self.send_response(200)
        self.send_header("Content-Length", str(len(content)))
        self.end_headers()
        self.wfile.write(content[: len(content) // 2])
        self.wfile.flush()
        self.over.wait()

    def log_message(self, *_: Any) -> None:
        """Print nothing."""


def test_a_server_that_stalls_is_asked_again(page: Any, place: Path, tmp_path: Path) -> None:
    copy = tmp_path / "copy"
    copy.mkdir()
    for name in ("files", "manifest.json", "tileset.json"):
        (copy / name).symlink_to(place / name)
    nf.view.write_page(copy)
    asked, stalls, over = list[str](), ring_file(place, 1), threading.Event()
    kind = type("Handler", (_Stalling,), {"stalls": stalls, "asked": asked, "over": over})
    handler = partial(kind, directory=str(copy))
    with ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        try:
            page.goto(f"http://127.0.0.1:{server.server_port}/?aa=0")
            assert wait_for_ring(page, len(RADII)) == ""
        finally:
            over.set()
            server.shutdown()
    assert asked.count(stalls) == 2


HIDING = """
  const [ask, waiting] = [window.requestAnimationFrame.bind(window), []];
  let state = 'visible';
  Object.defineProperty(document, 'visibilityState', { get: () => state });
  Object.defineProperty(document, 'hidden', { get: () => state === 'hidden' });
  window.requestAnimationFrame = (draw) => (state === 'hidden' ? waiting.push(draw) : ask(draw));
  window.setVisibility = (to) => {
    state = to;
    document.dispatchEvent(new Event('visibilitychange'));
    if (to === 'visible') waiting.splice(0).forEach(ask);
  };
"""
"""Browsers give hidden tabs no frames. One without a screen hides nothing, so the page is told so here."""

GROWTH = """() => {
  window.states = [];
  const look = () => {
    const { shown } = window.nearfar.viewer.facts;
    if (shown) window.states.push(shown.grown.strength);
    requestAnimationFrame(look);
  };
  requestAnimationFrame(look);
}"""


def test_a_tab_that_was_hidden_goes_on_where_it_was(page: Any, url: str) -> None:
    page.add_init_script(HIDING)
    page.goto(url)
    assert wait_for_ring(page, 1) == ""
    page.evaluate(GROWTH)
    states = partial(page.evaluate, "() => window.states")
    wait_until(page, lambda: len(states()) > 3 and states()[-1] > 0)
    page.evaluate("() => setVisibility('hidden')")
    hidden = len(states())
    time.sleep(3)
    assert len(states()) <= hidden + 1
    page.evaluate("() => setVisibility('visible')")
    wait_until(page, lambda: len(states()) > hidden + 3)
    steps = np.diff(states())
    # The whole growth of ring 1 takes more than ten seconds, and no frame goes on by more than a tenth of one.
    assert (steps >= 0).all()
    assert steps.max() <= 0.1 / 10
    assert page.printed == []


def test_names_are_only_ever_text(chromium: Any, tmp_path: Path) -> None:
    builder = nf.SceneBuilder()
    corners, faces = np.array([[-5.0, 0, -5], [5, 0, -5], [0, 0, 5]]), [[0, 2, 1]]
    builder.instance(builder.mesh(corners, faces), name=f"floor {HOSTILE}")
    builder.instance(builder.mesh(corners * 0.1 + np.array([0, 1, -3]), faces), name=f"car {HOSTILE}")
    scene = builder.build(dynamic=[f"car {HOSTILE}"])
    bundle = nf.stream.export(scene, tmp_path / "b", center=(0, 1.7, 0), radii=[8.0], face_size=64, samples=1)
    place = Path(bundle._reader.place)
    manifest = json.loads((place / "manifest.json").read_text())
    manifest["notes"] = [HOSTILE]
    manifest["regions"][0]["findings"] = [HOSTILE]
    with Server.of_bundle(place) as server, opened(chromium, *SIZE) as page:
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


def test_lost_graphics_come_back_with_the_picture(page: Any, url: str) -> None:
    page.goto(url)
    assert wait_for_ring(page, len(RADII)) == ""
    state, pose = {"ring": 2, "radius": 15.0, "strength": 1.0}, {"position": CENTER, "yaw": 0.7, "pitch": 0.0}
    page.evaluate(LOSE)
    wait_until(page, lambda: "graphics" in page.locator("#message").inner_text())
    page.wait_for_timeout(300)
    page.evaluate("() => window.loss.restoreContext()")
    wait_until(page, lambda: page.locator("#message").inner_text() == "")
    assert wait_for_ring(page, len(RADII)) == ""
    after = still(page, state, pose)
    assert [text for text in page.printed if "Context" not in text] == []
    page.reload()
    assert wait_for_ring(page, len(RADII)) == ""
    assert np.array_equal(after, still(page, state, pose))
    assert after.std() > 10


def test_a_page_that_gets_no_graphics_back_begins_anew_where_the_user_was(page: Any, url: str) -> None:
    page.goto(url)
    assert wait_for_ring(page, 1) == ""
    place = [CENTER[0] + 0.5, CENTER[1], CENTER[2] - 0.25]
    page.evaluate("(position) => window.nearfar.setPose({ position, yaw: 0.5, pitch: 0 })", place)
    wait_until(page, lambda: page.evaluate("() => window.nearfar.pose.yaw") == 0.5)
    page.evaluate(LOSE)
    page.get_by_role("button", name="Try again").click()
    wait_until(page, lambda: page.evaluate("() => !('loss' in window) && window.nearfar !== undefined"))
    assert wait_for_ring(page, 1) == ""
    assert page.evaluate("() => window.nearfar.pose") == {"position": place, "yaw": 0.5, "pitch": 0}


def test_a_damaged_file_comes_anew_when_the_user_tries_again(page: Any, url: str, place: Path) -> None:
    """The browser may keep the damaged copy, which the server calls good for ever."""
    name = ring_file(place, 1)
    content = (place / name).read_bytes()
    answers = [content, content[:-5] + b"12345"]
    page.route(f"**/{name}", lambda route: route.fulfill(body=answers.pop()))
    page.add_init_script(
        """window.asked = [];
        const ask = window.fetch;
        window.fetch = (url, how) => { window.asked.push([String(url), how?.cache]); return ask(url, how); };"""
    )
    page.goto(url)
    assert name in wait_for_ring(page, len(RADII))
    page.get_by_role("button", name="Try again").click()
    wait_until(page, lambda: page.evaluate("() => window.nearfar.viewer.facts.arrived") == len(RADII))
    asked = [how for address, how in page.evaluate("() => window.asked") if name in address]
    assert asked == ["default", "reload"]
    assert page.locator("#message").inner_text() == ""


def test_a_lost_network_leaves_the_last_picture(page: Any, url: str, place: Path) -> None:
    """All trials of a file fail; when the network is back the user goes on where the page was."""
    name = f"**/{ring_file(place, 2)}"
    page.route(name, lambda route: route.abort("internetdisconnected"))
    page.goto(f"{url}&strategy=clovrd")
    assert "does not come" in wait_for_ring(page, len(RADII))
    assert (arrived(page), shown_ring(page)) == (1, 1)
    assert canvas(page).std() > 10
    page.unroute(name)
    page.get_by_role("button", name="Try again").click()
    wait_until(page, lambda: shown_ring(page) == len(RADII))
    assert page.locator("#message").inner_text() == ""


def test_a_server_that_does_not_answer_is_told(page: Any, url: str) -> None:
    page.route("**/manifest.json", lambda route: route.abort("connectionrefused"))
    page.goto(url)
    assert "cannot be reached" in wait_for_ring(page, 0)


def test_a_browser_without_webgl_is_told(page: Any, url: str) -> None:
    page.add_init_script("HTMLCanvasElement.prototype.getContext = () => null;")
    page.goto(url)
    assert "WebGL 2" in wait_for_ring(page, 0)
