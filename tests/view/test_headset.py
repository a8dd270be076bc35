"""Both eyes of the page's immersive mode, in emulated headsets, beside the pictures of `nearfar.render`."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar.serve._server import Server
from tests.support import need
from tests.support.browser import opened, wait_for_ring
from tests.support.headset import (
    HEADSETS,
    Captured,
    Quaternion,
    Vector,
    about,
    alike,
    capture,
    empty_hands,
    expected,
    eyes,
    floor_of,
    floor_under,
    folder_of,
    frames,
    look,
    point,
    share_alike,
    squeeze,
    times,
    worn,
)

pytestmark = pytest.mark.slow

SIZE = (240, 240)
CENTER = (3.0, 1.7, -2.0)
RADII = (10.0, 22.0, 63.0)
START: Vector = (3.4, 1.7, -2.3)
YAW = 0.6
HEADS: tuple[tuple[Vector, Quaternion], ...] = (
    ((0.0, 1.6, 0.0), (0.0, 0.0, 0.0, 1.0)),
    ((0.3, 1.35, -0.25), times(about((0, 1, 0), 2.0), about((1, 0, 0), -0.3))),
    ((-0.4, 1.8, 0.2), times(about((0, 1, 0), -1.3), about((0, 0, 1), 0.25))),
)
FIRST: Vector = (0.0, 1.6, 0.0)


@pytest.fixture(scope="module")
def bundle(tmp_path_factory: pytest.TempPathFactory) -> nf.stream.Bundle:
    folder = tmp_path_factory.mktemp("headset") / "bundle"
    scene = nf.datasets.city(blocks=3, detail=1)
    settings: dict[str, Any] = {"face_size": 256, "quality": None, "pixels_per_degree": None}
    return nf.stream.export(scene, folder, center=CENTER, radii=RADII, **settings)


@pytest.fixture(scope="module")
def server(bundle: nf.stream.Bundle) -> Iterator[str]:
    need("web")
    with Server.of_bundle(folder_of(bundle)) as running:
        yield running.url


def address(server: str, query: str) -> str:
    place = ",".join(map(str, START))
    return f"{server}?aa=0&{query}#p={place}&yaw={YAW}&pitch=-0.2"


def eyes_of(head: tuple[Vector, Quaternion], kind: str) -> dict[str, nf.Camera]:
    return eyes(floor_under(START, YAW, FIRST), head, HEADSETS[kind], SIZE)


@pytest.mark.parametrize("kind", HEADSETS)
@pytest.mark.parametrize("ring", [3, *(pytest.param(ring, marks=pytest.mark.stress) for ring in (1, 2))])
def test_each_eye_is_shown_the_picture_of_its_own_position(
    chromium: Any, server: str, bundle: nf.stream.Bundle, kind: str, ring: int
) -> None:
    with worn(chromium, address(server, f"rings={ring}&strategy=clovrd"), kind, SIZE, ring) as page:
        empty_hands(page)
        for head in HEADS:
            look(page, *head)
            found: Captured = capture(page, f"shown.ring === {ring}")
            assert found.shown["grown"] == {"radius": RADII[ring - 1], "strength": 1}
            picture = {"ring": ring, "radius": RADII[ring - 1], "strength": 1.0}
            cameras = eyes_of(head, kind)
            for side, pixels in (("left", found.left), ("right", found.right)):
                codes, inner = expected(bundle, picture, cameras[side])
                assert inner.mean() > 0.4
                assert share_alike(pixels, codes, inner) >= 0.99
            # Shaders were told both eyes' positions from the centre, and no other one.
            places = np.array([np.subtract(cameras[side].position, CENTER) for side in ("left", "right")])
            assert found.eyes.shape == (2, 3)
            assert np.abs(found.eyes[np.argsort(found.eyes[:, 0])] - places[np.argsort(places[:, 0])]).max() < 1e-5
        assert page.printed == []


def test_one_position_for_both_eyes_would_be_seen(chromium: Any, tmp_path: Path) -> None:
    """Pictures are those of the eyes' own positions, not of the head between them: in a room that is seen."""
    settings: dict[str, Any] = {"face_size": 256, "quality": None, "pixels_per_degree": None}
    place: Vector = (0.6, 1.6, 0.5)
    head = HEADS[1]
    bundle = nf.stream.export(nf.datasets.room(), tmp_path / "room", center=(0.5, 1.6, 0.4), radii=(8.0,), **settings)
    picture = {"ring": 1, "radius": 8.0, "strength": 1.0}
    with (
        Server.of_bundle(folder_of(bundle)) as running,
        worn(chromium, f"{running.url}?aa=0&strategy=clovrd#p=0.6,1.6,0.5&yaw={YAW}", "quest2", SIZE, 1) as page,
    ):
        empty_hands(page)
        look(page, *head)
        found = capture(page, "shown.ring === 1")
    floor = floor_under(place, YAW, FIRST)
    own, between = (eyes(floor, head, ipd, SIZE) for ipd in (HEADSETS["quest2"], 0.0))
    for side, pixels in (("left", found.left), ("right", found.right)):
        off = [
            int((np.abs(pixels - expected(bundle, picture, cameras[side])[0]).max(axis=-1) > 8).sum())
            for cameras in (own, between)
        ]
        assert off[1] > 2000
        assert off[0] < 0.2 * off[1], off


def test_a_ring_fades_in_for_both_eyes(chromium: Any, server: str, bundle: nf.stream.Bundle) -> None:
    held = bundle._manifest["regions"][0]["rings"][2]["geometry"]
    with worn(chromium, address(server, "rings=2"), "quest2", SIZE, 1, held=held) as page:
        empty_hands(page)
        look(page, *HEADS[1])
        found = capture(page, "shown.ring === 1 && shown.grown.strength === 1")
        assert found.shown["fading"] is None
        page.let_go()
        found = capture(page, "shown.fading && shown.fading.ring === 2 && Math.abs(shown.fading.share - 0.5) < 0.35")
        grown, share = found.shown["grown"], found.shown["fading"]["share"]
        cameras = eyes_of(HEADS[1], "quest2")
        for side, pixels in (("left", found.left), ("right", found.right)):
            before, inner = expected(bundle, {"ring": 1, **grown}, cameras[side])
            after, inner_after = expected(bundle, {"ring": 2, **grown}, cameras[side])
            blended = (1 - share) * np.rint(before) + share * np.rint(after)
            assert np.abs(after - before).max() > 30
            assert share_alike(pixels, blended, inner & inner_after) >= 0.98


def test_no_layer_shows_the_map_where_something_moves(chromium: Any, server: str, bundle: nf.stream.Bundle) -> None:
    assert bundle._manifest["dynamic"]
    with worn(chromium, address(server, "rings=1&strategy=clovrd"), "quest3", SIZE, 1, layers=True) as page:
        capture(page, "shown.ring === 1")
        assert page.evaluate("() => window.emulated.layers.cube") is None


def test_walking_on_leads_to_the_next_region(chromium: Any, tmp_path: Path) -> None:
    """Jumps lead over the border between two centres, where the next one's picture takes over for both eyes."""
    centers = [CENTER, (CENTER[0], CENTER[1], CENTER[2] - 8.0)]
    settings: dict[str, Any] = {"face_size": 256, "quality": None, "pixels_per_degree": None}
    scene = nf.datasets.city(blocks=2, detail=1)
    bundle = nf.stream.export(scene, tmp_path / "regions", center=centers, radii=(10.0,), **settings)
    head: Vector = FIRST
    level: Quaternion = (0.0, 0.0, 0.0, 1.0)
    place = ",".join(map(str, CENTER))
    with (
        Server.of_bundle(folder_of(bundle)) as running,
        worn(chromium, f"{running.url}?aa=0&strategy=clovrd#p={place}&yaw=0", "quest3", SIZE, 1) as page,
    ):
        look(page, head, level)
        # Level from a height of 1.5 m: four metres ahead.
        point(page, "right", (0.0, 1.5, 0.0), level)
        point(page, "left", (0.0, -90.0, 0.0), level)
        for _ in range(3):
            frames(page, 3)
            squeeze(page, "right", 1)
            frames(page, 3)
            squeeze(page, "right", 0)
            page.wait_for_timeout(1000)
        page.wait_for_function("() => window.nearfar.viewer.facts.region === 1")
        empty_hands(page)
        page.wait_for_function("() => window.nearfar.viewer.facts.leaving === null")
        found = capture(page, "shown.ring === 1 && window.nearfar.viewer.facts.region === 1")
        floor = floor_of(page, centers[1])
        assert np.hypot(*(floor.position - centers[1])[[0, 2]]) < 7
        region, grown = bundle.region(1), found.shown["grown"]
        cameras = eyes(floor, (head, level), HEADSETS["quest3"], SIZE)
        assert alike(region, {"ring": 1, **grown}, found, cameras) >= 0.98


def test_a_browser_without_a_headset_says_so(chromium: Any, server: str) -> None:
    with opened(chromium, 900, 700) as page:
        page.goto(server)
        assert wait_for_ring(page, 0) == ""
        page.get_by_text("No headset is connected.").wait_for()
        assert not page.locator(".tool-main").is_visible()
        # Its key does nothing, and the help does not speak of it.
        page.keyboard.press("v")
        page.keyboard.press("?")
        assert not page.get_by_text("enter the headset").is_visible()
        assert page.printed == []
