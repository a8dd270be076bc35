"""The page that flies trees, in a browser: its pictures of views beside Python's, and what missing parts leave."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial
from http.server import ThreadingHTTPServer
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar.serve._server import Server
from tests.support.browser import opened, wait_until
from tests.support.flown_page import SIZE, Pose, facts, flown, holes, likeness, link, picture, problems, rendered, seen
from tests.support.range_server import RangeHandler

pytestmark = pytest.mark.slow

AIR: Pose = {"position": [0.0, 45.0, 110.0], "yaw": 0.0, "pitch": -0.4}
STREET = {"position": [20.0, 3.0, 22.0], "yaw": 0.7, "pitch": 0.0}
FAR = {"position": [0.0, 300.0, 900.0], "yaw": 0.0, "pitch": -0.3}
CORNER = {"position": [-55.0, 30.0, -55.0], "yaw": -2.4, "pitch": -0.5}


@pytest.mark.parametrize(
    ("pose", "least", "samples"), [(AIR, 0.99, 1), (STREET, 0.9, 1), (CORNER, 0.95, 1), (AIR, 0.99, 4)]
)
def test_pictures_are_those_of_render(
    chromium: Any, city: nf.orthoview.OrthoTree, pose: Pose, least: float, samples: int
) -> None:
    with Server.of_bundle(city.path) as server, opened(chromium, *SIZE) as page:
        told = flown(page, f"{server.url}?geometry=0&samples={samples}{link(pose)}")
        found = picture(page)
        assert page.printed == []
    frame = rendered(city, pose, samples)
    assert (told["views"], told["standIns"], told["holes"]) == (frame.stats["views"], 0, 0)
    assert likeness(found, frame) > least
    assert holes(found, frame) < 0.001


def test_colours_as_webp_are_drawn(chromium: Any, world: nf.Scene, tmp_path: Path) -> None:
    # Without geometry, which would hide the colours of near views.
    trees = {
        color: nf.orthoview.build(world, tmp_path / color, cell=40, size=32, directions=5, color=color, geometry=False)
        for color in ("zstd", "webp")
    }
    pictures = []
    for tree in trees.values():
        low, high = tree.bounds
        pose = {"position": [*(low[:2] + high[:2]) / 2, high[2] + 50], "yaw": 0.0, "pitch": 0.0}
        with Server.of_bundle(tree.path) as server, opened(chromium, *SIZE) as page:
            flown(page, f"{server.url}{link(pose)}")
            pictures.append(picture(page))
    np.testing.assert_array_equal(pictures[0], pictures[1])
    assert len(np.unique(pictures[0].reshape(-1, 3), axis=0)) > 50


# Servers that fail ---------------------------------------------------------------------------------------------------
@dataclass
class Host:
    """A server of files that can be told to fail."""

    url: str
    stop: Any
    status: int = 0
    """Answer to requests for shards; 0 for their content."""


@contextmanager
def hosted(folder: Path) -> Iterator[Host]:
    class Handler(RangeHandler):
        def do_GET(self) -> None:  # noqa: N802 - the base class's name
            if host.status and "/c/" in self.path:
                self.send_error(host.status)
            else:
                super().do_GET()

    with ThreadingHTTPServer(("127.0.0.1", 0), partial(Handler, directory=str(folder))) as server:
        thread = threading.Thread(target=server.serve_forever, args=(0.01,))

        def stop() -> None:
            server.shutdown()
            server.server_close()

        host = Host(f"http://127.0.0.1:{server.server_port}/{folder.name}/", stop)
        server.RequestHandlerClass = partial(Handler, directory=str(folder.parent))
        thread.start()
        try:
            yield host
        finally:
            stop()
            thread.join()


def go(page: Any, pose: Pose) -> None:
    page.evaluate("(pose) => window.orthoview.setPose(pose)", pose)


@pytest.mark.parametrize("failure", ["away", 500])
def test_the_old_picture_stays_when_the_server_fails(
    chromium: Any, city: nf.orthoview.OrthoTree, copied_city: Path, failure: str | int
) -> None:
    with hosted(copied_city) as host, opened(chromium, *SIZE) as page:
        flown(page, f"{host.url}?geometry=0{link(FAR)}")
        if failure == "away":
            host.stop()
        else:
            host.status = 500
        go(page, AIR)
        wait_until(page, lambda: problems(page))
        page.wait_for_timeout(1500)  # while it asks again
        assert len(problems(page)) == 1
        assert ("does not answer" if failure == "away" else "answers 500") in problems(page)[0]
        now = facts(page)
        assert now["standIns"] > 0
        assert now["waiting"] > 0
        assert now["holes"] == 0
        if failure == 500:
            host.status = 0
            wait_until(page, lambda: facts(page)["isComplete"] and not facts(page)["standIns"])
            wait_until(page, lambda: problems(page) == [])
        found = picture(page)
    frame = rendered(city, AIR)
    assert holes(found, frame) < 0.02
    assert (likeness(found, frame) > 0.98) == (failure == 500)


@pytest.mark.parametrize("damage", ["altered", "missing"])
def test_damage_is_told_once_and_a_coarser_picture_stays(
    chromium: Any, city: nf.orthoview.OrthoTree, copied_city: Path, damage: str
) -> None:
    own = nf.orthoview.open(copied_city)
    level, place, direction = next(
        key for key in own.cut(seen(AIR), geometry=False).keys(in_picture=True) if key[0] == 0
    )
    array = own._layout.array(level, direction, "depth")
    (chunk,) = own._chunks._found([(level, place, array)])
    assert chunk is not None
    shard = copied_city / chunk.file
    if damage == "missing":
        shard.unlink()
    else:
        content = bytearray(shard.read_bytes())
        content[chunk.first + chunk.length - 2] ^= 1  # in the frame's checksum
        shard.write_bytes(content)
    with hosted(copied_city) as host, opened(chromium, *SIZE) as page:
        told = flown(page, f"{host.url}?geometry=0{link(AIR)}")
        listed = problems(page)
        page.wait_for_timeout(1000)
        assert problems(page) == listed
        found = picture(page)
    assert len(listed) == 1
    assert listed[0].startswith(array if damage == "altered" else chunk.file)
    assert ("checksum" if damage == "altered" else "gone") in listed[0]
    assert told["standIns"] > 0
    assert told["holes"] == told["waiting"] == 0
    frame = rendered(city, AIR)
    # The shard has all leaves, the chunk one of them.
    assert likeness(found, frame) > (0.9 if damage == "altered" else 0.5)
    assert holes(found, frame) < 0.02


@pytest.mark.parametrize(
    ("file", "title"),
    [("zarr.json", "There is no tree"), ("nearfar/records.json", "There is no tree"), ("", "The tree is damaged")],
)
def test_what_cannot_be_shown_is_told(chromium: Any, copied_city: Path, file: str, title: str) -> None:
    if file:
        (copied_city / file).unlink()
    else:
        (copied_city / "zarr.json").write_text("{")
    with hosted(copied_city) as host, opened(chromium, *SIZE) as page:
        page.goto(host.url)
        wait_until(page, lambda: page.locator("#message h1").count())
        assert title in page.locator("#message h1").inner_text()


# Habits --------------------------------------------------------------------------------------------------------------
def test_keys_fly_and_the_address_leads_back(chromium: Any, city: nf.orthoview.OrthoTree) -> None:
    def pose(page: Any) -> Pose:
        return dict(page.evaluate("() => window.orthoview.pose"))

    def has_gone(page: Any, before: list[float], axis: int, sign: int) -> bool:
        return bool(sign * (pose(page)["position"][axis] - before[axis]) > 1)

    with Server.of_bundle(city.path) as server, opened(chromium, 800, 600) as page:
        flown(page, f"{server.url}?geometry=0&error=8{link(AIR)}")
        assert pose(page)["position"] == AIR["position"]
        for key, axis, sign in (("w", 2, -1), ("e", 1, 1), ("d", 0, 1)):
            before = pose(page)["position"]
            page.keyboard.down(key)
            wait_until(page, partial(has_gone, page, before, axis, sign))
            page.keyboard.up(key)
        before = pose(page)
        page.mouse.move(400, 200)
        page.mouse.down()
        page.mouse.move(600, 200, steps=3)
        page.mouse.up()
        assert pose(page)["yaw"] > before["yaw"] + 0.2
        wait_until(page, lambda: f"yaw={pose(page)['yaw']:.3f}" in page.evaluate("() => location.hash"))
        there = pose(page)
        page.reload()
        wait_until(page, lambda: facts(page)["isComplete"])
        np.testing.assert_allclose(pose(page)["position"], there["position"], atol=1e-3)
        page.get_by_role("button", name="Home").click()
        assert pose(page)["position"] != there["position"]


@pytest.mark.parametrize("size", [(1280, 800), (390, 844)])
def test_nothing_reaches_beyond_the_screen(chromium: Any, city: nf.orthoview.OrthoTree, size: tuple[int, int]) -> None:
    with Server.of_bundle(city.path) as server, opened(chromium, *size) as page:
        flown(page, f"{server.url}?geometry=0&error=16")
        if size[0] < 600:
            page.get_by_role("button", name="Figures").click()
        page.get_by_role("button", name="Help").click()
        boxes = page.evaluate("""() => [...document.querySelectorAll('.card, .tools, button, canvas')]
          .map((each) => each.getBoundingClientRect()).filter(({ width }) => width > 0)
          .map(({ left, top, right, bottom }) => [left, top, right, bottom])""")
        inner = page.evaluate("() => [document.documentElement.scrollWidth, document.documentElement.scrollHeight]")
        values = page.locator(".figures dd").all_inner_texts()
    assert tuple(inner) == size
    assert len(boxes) >= 6
    assert min(min(left, top) for left, top, _, _ in boxes) >= 0
    assert max(right for _, _, right, _ in boxes) <= size[0]
    assert max(bottom for _, _, _, bottom in boxes) <= size[1]
    assert len(values) == 7
    assert all(text and text != "–" for text in values)
