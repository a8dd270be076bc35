"""The page's other strategies, vis0 and vis1: what is on the screen while their files come, and in the end."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from nearfar._scene.srgb import to_srgb
from nearfar.serve._server import Server
from tests.support.browser import canvas, opened, wait_for_ring, wait_until
from tests.support.bundled_scenes import bundled_scenes

pytestmark = pytest.mark.slow

SIZE, ANGLE = (300, 200), 75.0
CENTER = (3.0, 1.7, -2.0)
RADII = (10.0, 40.0)


@pytest.fixture(scope="module")
def bundle(tmp_path_factory: pytest.TempPathFactory) -> nf.stream.Bundle:
    folder = tmp_path_factory.mktemp("strategies") / "bundle"
    settings: dict[str, Any] = {"face_size": 256, "quality": None, "by_footprint": True}
    return nf.stream.export(bundled_scenes()["city"], folder, center=CENTER, radii=RADII, **settings)


@pytest.fixture(scope="module")
def url(bundle: nf.stream.Bundle) -> Iterator[str]:
    with Server.of_bundle(bundle._reader.place) as server:
        yield server.url


@pytest.fixture
def page(chromium: Any) -> Iterator[Any]:
    with opened(chromium, *SIZE) as shown:
        yield shown


def picture(page: Any) -> NDArray[np.uint8]:
    """The canvas without what lies over it."""
    page.evaluate("() => { document.querySelector('#ui').hidden = true; }")
    page.wait_for_timeout(200)
    return canvas(page)


def share_equal(a: NDArray[Any], b: NDArray[Any]) -> float:
    """Part of the pixels that differ by at most 3 of 255."""
    return float((np.abs(a.astype(int) - b.astype(int)).max(axis=-1) <= 3).mean())


def parts(bundle: nf.stream.Bundle) -> tuple[int, str]:
    """Number of the ring that stands for the map, and the name of one of its files."""
    entry = bundle._manifest["regions"][0]["by_footprint"]
    return len(entry["portions"]) + 1, entry["map"]["color"][3]


def truth(bundle: nf.stream.Bundle) -> NDArray[Any]:
    """The last ring as its centre sees it, where objects without a footprint are hidden."""
    width, height = SIZE
    across = np.degrees(2 * np.arctan(np.tan(np.radians(ANGLE) / 2) * width / height))
    fov = nf.Fov.symmetric(float(across), aspect=width / height)
    view = nf.Camera.look_at(CENTER, np.add(CENTER, (0, 0, -1)), fov=fov, size=SIZE)
    frame = bundle.at(bundle.count).render(view, channels=("color",))
    return np.rint(to_srgb(np.clip(frame.require("color"), 0, 1)) * 255)


def test_vis1_shows_objects_as_they_come_and_the_map_last(page: Any, url: str, bundle: nf.stream.Bundle) -> None:
    last, name = parts(bundle)
    held: list[Any] = []
    page.route(f"**/{name}", lambda route: held.append(route))
    page.goto(f"{url}?strategy=vis1&aa=0")
    assert wait_for_ring(page, 1) == ""
    wait_until(page, lambda: page.evaluate("() => window.nearfar.viewer.facts.arrived") == last - 1)
    partly = picture(page)
    # Where nothing near is, nothing is shown.
    is_black = (partly == 0).all(axis=-1)
    assert 0.05 < is_black.mean() < 0.9
    held[0].continue_()
    assert wait_for_ring(page, last) == ""
    whole = picture(page)
    assert (whole == 0).all(axis=-1).mean() < 0.01
    assert share_equal(whole, truth(bundle)) > 0.97
    assert page.printed == []


def test_vis0_shows_nothing_before_all_is_there(page: Any, url: str, bundle: nf.stream.Bundle) -> None:
    last, name = parts(bundle)
    held: list[Any] = []
    page.route(f"**/{name}", lambda route: held.append(route))
    page.goto(f"{url}?strategy=vis0&aa=0")
    wait_until(page, lambda: page.evaluate("() => window.nearfar?.viewer.facts.arrived ?? 0") == last - 1)
    assert page.evaluate("() => window.nearfar.viewer.facts.shown") is None
    assert picture(page).reshape(-1, 3).std(axis=0).max() == 0
    held[0].continue_()
    assert wait_for_ring(page, last) == ""
    assert share_equal(picture(page), truth(bundle)) > 0.97
    assert page.printed == []


def test_rings_load_nothing_of_it(page: Any, url: str, bundle: nf.stream.Bundle) -> None:
    asked: list[str] = []
    page.on("request", lambda request: asked.append(request.url))
    page.goto(url)
    assert wait_for_ring(page, bundle.count) == ""
    entry = bundle._manifest["regions"][0]["by_footprint"]
    own = {portion["geometry"] for portion in entry["portions"]} | {*entry["map"]["color"]}
    assert not any(name in url for name in own for url in asked)


def test_a_bundle_without_it_says_so(page: Any, tmp_path_factory: pytest.TempPathFactory) -> None:
    folder = tmp_path_factory.mktemp("plain") / "bundle"
    scene = bundled_scenes()["city"]
    nf.stream.export(scene, folder, center=CENTER, radii=RADII, face_size=64, samples=1)
    with Server.of_bundle(folder) as server:
        page.goto(f"{server.url}?strategy=vis1")
        assert "by_footprint=True" in wait_for_ring(page, 0)
        page.goto(f"{server.url}?strategy=best")
        assert "expected clovr, clovrd, vis0, vis1, got best" in wait_for_ring(page, 0)
