"""The page with a scene whose regions are made on demand: coarse and full maps, walking on, jumps, refusals."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from nearfar._trace import viewpoint
from nearfar.serve._server import Server
from nearfar.serve._site import LoadedScene, Site
from tests.support.browser import open_page, wait_until
from tests.support.page_pictures import continuity
from tests.support.stepped_page import SteppedPage

pytestmark = pytest.mark.slow

SIZE = (360, 240)
SETTINGS: dict[str, Any] = {"grid": 2.0, "radii": (10.0, 22.0, 63.0), "face_size": 768, "samples": 1}
RINGS = len(SETTINGS["radii"])
NEAR_SHARE = 0.7
START = (3.0, 1.75, -2.0)
MESSAGE = "() => document.querySelector('#message').textContent"
PLACE = """() => {
  const lines = [...document.querySelectorAll('dt')];
  return lines.find((line) => line.textContent === 'Place').nextSibling.textContent;
}"""
"""The panel's row about the place."""


@pytest.fixture(scope="module")
def city() -> nf.Scene:
    return nf.datasets.city(blocks=3, detail=1)


@pytest.fixture(scope="module")
def server(city: nf.Scene, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    scene = LoadedScene(lambda: city, title="city", start=lambda _: viewpoint.facing(START, (3, 1.75, -9)), **SETTINGS)
    with Server({"": Site.of_scene(scene, tmp_path_factory.mktemp("regions"))}) as running:
        yield running


def pose(x: float, z: float, yaw: float = 0.3) -> dict[str, Any]:
    return {"position": [x, START[1], z], "yaw": yaw, "pitch": -0.1}


def link(place: dict[str, Any]) -> str:
    return f"#p={','.join(map(str, place['position']))}&yaw={place['yaw']}&pitch={place['pitch']}"


def until(page: SteppedPage, place: dict[str, Any], happened: Callable[[dict[str, Any]], bool]) -> dict[str, Any]:
    """Draw frames until the page's state meets a condition; returns the state."""
    told: dict[str, Any] = {}

    def has_happened() -> bool:
        nonlocal told
        told = page.frame(place, 0.05)
        return happened(told)

    wait_until(page.page, has_happened)
    return told


def is_refined(told: dict[str, Any]) -> bool:
    """Whether all rings are shown, and then the maps of full size."""
    shown = told["shown"]
    return not told["isLoading"] and told["leaving"] is None and shown is not None and shown["fading"] is None


def grown(page: SteppedPage, place: dict[str, Any]) -> tuple[dict[str, Any], NDArray[np.uint8]]:
    """The page's state and its picture when nothing changes any more."""
    until(page, place, is_refined)
    for _ in range(8):
        page.frame(place, 60.0)
    return page.picture(place, 0.0)


@pytest.mark.stress
def test_coarse_maps_are_followed_by_the_picture_of_the_bundle(
    chromium: Any, city: nf.Scene, server: Server, tmp_path: Path
) -> None:
    here = pose(3.4, -2.6)
    asked: list[str] = []
    with open_page(chromium, *SIZE) as shown:
        shown.on("request", lambda request: asked.append(request.url))
        shown.goto(f"{server.url}?aa=0{link(here)}")
        page = SteppedPage(shown)
        told = until(page, here, lambda told: told["shown"] is not None)
        # Complete with ring 0 alone: no pixel is blank.
        assert (told["arrived"], told["shown"]["ring"]) == (0, 0)
        _, coarse = page.picture(here, 0.0)
        assert (coarse.max(axis=-1) > 0).mean() > 0.999
        assert shown.title() == "city – nearfar"
        told, refined = grown(page, here)
        assert told["shown"]["ring"] == told["arrived"] == RINGS + 1
        assert told["shown"]["grown"] == {"radius": SETTINGS["radii"][-1], "strength": 1}
        assert shown.printed == []
    assert [url for url in asked if "/at/" in url] == [f"{server.url}at/4,1.75,-2/parts"]
    nf.stream.export(city, tmp_path / "out", center=(4, 1.75, -2), **{**SETTINGS, "grid": None})
    with Server.of_bundle(tmp_path / "out") as bundle, open_page(chromium, *SIZE) as shown:
        shown.goto(f"{bundle.url}?aa=0{link(here)}")
        told, expected = grown(SteppedPage(shown), here)
        assert told["shown"]["ring"] == RINGS
    off = np.abs(refined.astype(int) - expected).max(axis=-1)
    assert (off <= 2).mean() >= 0.999
    assert np.abs(coarse.astype(int) - expected).max(axis=-1).mean() > 1


def fades_to(told: dict[str, Any], ring: int) -> bool:
    shown = told["shown"]
    return shown is not None and shown["fading"] is not None and shown["fading"]["ring"] == ring


@pytest.mark.stress
def test_full_size_maps_appear_without_a_jump(chromium: Any, server: Server) -> None:
    here = pose(-9.0, 8.0)
    with open_page(chromium, *SIZE) as shown:
        shown.goto(f"{server.url}?aa=0{link(here)}")
        page = SteppedPage(shown)
        told = until(page, here, lambda told: fades_to(told, RINGS + 1))
        assert told["shown"]["fading"]["share"] == 0
        _, before = page.picture(here, 0.0)
        pictures = [before, *(page.picture(here, 1 / 72)[1] for _ in range(40))]
        told = page.frame(here, 0.0)
        assert (told["shown"]["ring"], told["shown"]["fading"]) == (RINGS + 1, None)
    faded = continuity(pictures).min()
    print("continuity, least of the fade:", faded, "without one:", continuity([pictures[0], pictures[-1]])[0])
    assert faded > 0.999
    assert faded > continuity([pictures[0], pictures[-1]])[0]


@pytest.mark.stress
def test_a_jump_requests_a_new_place(chromium: Any, server: Server) -> None:
    here, there = pose(3.0, -2.0), pose(-42.0, 36.0)
    asked: list[str] = []
    with open_page(chromium, *SIZE) as shown:
        shown.on("request", lambda request: asked.append(request.url.removeprefix(server.url)))
        shown.goto(f"{server.url}?aa=0{link(here)}")
        page = SteppedPage(shown)
        grown(page, here)
        shown.evaluate("(target) => window.nearfar.viewer.go(target)", there)
        told = until(page, here, lambda told: told["goal"] is not None)
        before = told["region"]
        # The old picture stays until the new place has one, and then fades.
        told = until(page, there, lambda told: told["region"] != before)
        assert (told["leaving"], told["goal"]) == (before, None)
        told, _ = grown(page, there)
        assert told["shown"]["grown"]["radius"] == SETTINGS["radii"][-1]
        assert len(told["regions"]) == 1
        assert shown.printed == []
    places = [name for name in asked if name.startswith("at/")]
    assert places[1:] == ["at/-42,1.75,36/parts"]
    buffers = [name for name in asked if name.endswith(".bin")]
    assert len(buffers) == len(set(buffers)) > 0


@pytest.mark.stress
def test_walking_on_requests_the_next_place(chromium: Any, server: Server) -> None:
    asked: list[str] = []
    margin = NEAR_SHARE * SETTINGS["radii"][-1]
    with open_page(chromium, *SIZE) as shown:
        shown.on("request", lambda request: asked.append(request.url.removeprefix(server.url)))
        shown.goto(f"{server.url}?aa=0{link(pose(0.0, 0.0))}")
        page = SteppedPage(shown)
        told, _ = grown(page, pose(0.0, 0.0))
        first = told["region"]

        def places() -> list[str]:
            return [name for name in asked if name.startswith("at/")]

        def walk(start: float, end: float) -> dict[str, Any]:
            for z in np.linspace(start, end, 20):
                told = page.frame(pose(0.0, float(z)), 0.1)
            return told

        walk(0.0, 0.45 * margin)
        assert len(places()) == 1
        told = walk(0.45 * margin, 0.6 * margin)
        assert told["region"] == first
        here = pose(0.0, 0.6 * margin)
        # With all its rings and full-size maps it takes over without a visible change.
        told = until(page, here, lambda told: told["region"] != first)
        assert told["leaving"] == first
        assert told["arrived"] == RINGS + 1
        told = page.frame(here, 1.0)
        assert told["shown"]["grown"] == {"radius": SETTINGS["radii"][-1], "strength": 1}
        assert shown.printed == []
    assert len(places()) == 2
    assert places()[1] == "at/0,1.75,22/parts"


class Watched(LoadedScene):
    """Records which places were begun, and which ended before they were complete; `held` begins when released."""

    held = (-42.0, START[1], 36.0)

    def __init__(self, *more: Any, **settings: Any) -> None:
        super().__init__(*more, **settings)
        self.begun: list[tuple[float, ...]] = []
        self.left: list[tuple[float, ...]] = []
        self.released = threading.Event()

    def parts(self, center: list[float]) -> Iterator[Any]:
        self.begun.append(tuple(center))
        if tuple(center) == self.held:
            self.released.wait()
        is_whole = False
        try:
            for part in super().parts(center):
                # The server requests nothing after the last part.
                is_whole = part.next is None
                yield part
        finally:
            if not is_whole:
                self.left.append(tuple(center))


def test_a_cancelled_place_is_not_completed(chromium: Any, city: nf.Scene) -> None:
    scene = Watched(
        lambda: city, start=lambda _: viewpoint.facing(START, (3, 1.75, -9)), **SETTINGS | {"face_size": 64}
    )
    failed: list[str] = []
    with (
        Server({"": Site.of_scene(scene, None)}) as server,
        open_page(chromium, *SIZE) as shown,
        ExitStack() as at_the_end,
    ):
        at_the_end.callback(scene.released.set)
        shown.on("requestfailed", lambda request: failed.append(request.url.removeprefix(server.url)))
        here, there = pose(*START[::2]), pose(*scene.held[::2])
        shown.goto(f"{server.url}?aa=0{link(here)}")
        page = SteppedPage(shown)
        until(page, here, lambda told: told["arrived"] >= RINGS)
        shown.evaluate("(target) => window.nearfar.viewer.go(target)", there)
        until(page, here, lambda _: scene.held in scene.begun)
        shown.evaluate("(target) => window.nearfar.viewer.go(target)", here)
        told = until(page, here, lambda told: told["goal"] is None)
        assert 1 not in told["regions"]
        wait_until(shown, lambda: failed)
        scene.released.set()
        wait_until(shown, lambda: scene.left)
    assert scene.left[0] == scene.held
    assert "at/-42,1.75,36/parts" in failed


def test_a_scene_that_cannot_be_loaded_is_shown_as_an_error(chromium: Any) -> None:
    def load() -> nf.Scene:
        raise ValueError("disk.glb: the disk is gone")

    with (
        Server({"": Site.of_scene(LoadedScene(load, **SETTINGS), None)}) as server,
        open_page(chromium, *SIZE) as shown,
    ):
        shown.goto(server.url)
        wait_until(shown, lambda: shown.evaluate(MESSAGE))
        assert "The server cannot load the scene" in shown.evaluate(MESSAGE)
        assert "disk.glb: the disk is gone" in shown.evaluate(MESSAGE)
        assert shown.evaluate("() => document.querySelectorAll('.wait').length") == 0


def test_a_place_that_cannot_be_made_keeps_the_picture(chromium: Any, city: nf.Scene) -> None:
    # Radii are chosen for each centre, and there are none in empty space.
    settings = {**SETTINGS, "radii": None, "face_size": 64}
    scene = LoadedScene(lambda: city, start=lambda _: viewpoint.facing(START, (3, 1.75, -9)), **settings)
    asked: list[str] = []
    with Server({"": Site.of_scene(scene, None)}) as server, open_page(chromium, *SIZE) as shown:
        shown.goto(f"{server.url}?aa=0")
        shown.wait_for_function("() => window.nearfar?.viewer.facts.shown", timeout=60e3)
        assert np.allclose(shown.evaluate("() => window.nearfar.pose.position"), START)
        shown.on("request", lambda request: asked.append(request.url.removeprefix(server.url)))
        shown.evaluate("(address) => location.assign(address)", link(pose(90_000.0, 0.0)))
        wait_until(shown, lambda: shown.evaluate(MESSAGE))
        assert "center: expected a place with objects around it" in shown.evaluate(MESSAGE)
        wait_until(shown, lambda: shown.evaluate("() => window.nearfar.viewer.facts.goal === null"))
        assert shown.evaluate("() => window.nearfar.viewer.facts.region") == 0
        assert shown.evaluate("() => Boolean(window.nearfar.viewer.facts.shown)")
        # A retry sends a new request, and another place replaces the failed one.
        shown.keyboard.press("r")
        wait_until(shown, lambda: asked.count("at/90000,1.75,0/parts") == 2)
        wait_until(shown, lambda: shown.evaluate(MESSAGE))
        shown.evaluate("(address) => location.assign(address)", link(pose(-42.0, 36.0)))
        wait_until(shown, lambda: shown.evaluate("() => window.nearfar.pose.position[0]") == -42.0)
        wait_until(shown, lambda: not shown.evaluate(MESSAGE))


def test_a_busy_server_is_asked_again(chromium: Any, server: Server) -> None:
    refusals = [429, 503]

    def answer(route: Any) -> None:
        if refusals:
            route.fulfill(status=refusals.pop(0), headers={"retry-after": "2"}, body="later")
        else:
            route.continue_()

    with open_page(chromium, *SIZE) as shown:
        shown.route("**/parts", answer)
        shown.goto(f"{server.url}?aa=0{link(pose(3.0, -2.0))}")
        wait_until(shown, lambda: shown.evaluate("() => Boolean(window.nearfar)"))
        wait_until(shown, lambda: shown.evaluate(PLACE) == "server busy, next try in 2 s")
        assert "server busy" in shown.evaluate("() => document.querySelector('.note').textContent")
        wait_until(shown, lambda: shown.evaluate(PLACE) == "refined")
        assert refusals == []
        assert shown.evaluate(MESSAGE) == ""


def test_strategies_by_footprint_are_refused(chromium: Any, server: Server) -> None:
    with open_page(chromium, *SIZE) as shown:
        shown.goto(f"{server.url}?strategy=vis1")
        wait_until(shown, lambda: shown.evaluate(MESSAGE))
        assert "strategy: expected clovr or clovrd" in shown.evaluate(MESSAGE)


def test_rings_appear_at_once_if_the_address_requests_it(chromium: Any, server: Server) -> None:
    here = pose(3.0, -2.0)
    with open_page(chromium, *SIZE) as shown:
        shown.goto(f"{server.url}?aa=0&strategy=clovrd&rings=1{link(here)}")
        page = SteppedPage(shown)
        told = until(page, here, is_refined)
        assert told["shown"]["grown"] == {"radius": SETTINGS["radii"][0], "strength": 1}
