"""The page walks from region to region: pictures at a crossing, fetched files, and memory."""

from __future__ import annotations

import json
from collections import Counter
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from nearfar._scene.srgb import to_srgb
from nearfar.serve._server import Server
from tests.support import gallery
from tests.support.browser import open_page
from tests.support.page_pictures import continuity
from tests.support.stepped_page import SteppedPage, count_objects, heap, objects

pytestmark = pytest.mark.slow

SIZE = (360, 240)
ANGLE, PITCH = 75.0, -0.1
RATE, WALK = 72.0, 1.4
"""Pictures per second; speed of a walking user, metres per second."""
CENTERS = ((3.0, 1.7, -2.0), (9.0, 1.7, -2.0))
RADII = (10.0, 22.0, 63.0)
NEAR_SHARE = 0.7
MAX_LOSS = 0.003
"""Mean loss of continuity that a crossing may have compared with a walk in the full scene."""
PLACES = 50
MAX_GROWTH = 0.15
"""Relative growth of the heap allowed from region 10 to region 44: compiled functions take slightly more and more."""


@pytest.fixture(scope="module")
def city() -> nf.Scene:
    return nf.datasets.city(blocks=3, detail=1)


@pytest.fixture(scope="module")
def two(city: nf.Scene, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Two regions of a street, 6 m apart."""
    folder = tmp_path_factory.mktemp("regions") / "two"
    nf.stream.export(city, folder, center=CENTERS, radii=RADII, face_size=512)
    return folder


@pytest.fixture(scope="module")
def hall(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("regions") / "hall"
    gallery.export(PLACES, folder)
    return folder


def pose(x: float, yaw: float) -> dict[str, Any]:
    return {"position": [x, 1.7, -2.0], "yaw": yaw, "pitch": PITCH}


def camera(x: float, yaw: float) -> nf.Camera:
    ahead = np.array([-np.sin(yaw) * np.cos(PITCH), np.sin(PITCH), -np.cos(yaw) * np.cos(PITCH)])
    width, height = SIZE
    across = np.degrees(2 * np.arctan(np.tan(np.radians(ANGLE) / 2) * width / height))
    eye = np.array((x, 1.7, -2.0))
    fov = nf.Fov.symmetric(float(across), aspect=width / height)
    return nf.Camera.look_at(eye, eye + ahead, fov=fov, size=SIZE)


def truth(scene: nf.Scene, x: float, yaw: float) -> NDArray[np.float64]:
    color = nf.render(scene, camera(x, yaw), channels=("color",)).require("color")
    return np.rint(to_srgb(np.clip(color, 0, 1)) * 255)


def at_the_border(page: Any, url: str, yaw: float) -> SteppedPage:
    """The page with both regions loaded, shown from the first one, and the user a step before the border."""
    page.goto(f"{url}?aa=0")
    stepped = SteppedPage(page)
    start, border = pose(CENTERS[0][0], yaw), pose(5.9, yaw)
    stepped.load(start, 0.1)
    for _ in range(8):
        stepped.frame(start, 60.0)
    stepped.frame(border, 0.0)
    told = stepped.load(border, 0.0)
    assert (told["regions"], told["region"]) == ([0, 1], 0)
    assert told["shown"]["grown"] == {"radius": RADII[-1], "strength": 1}
    return stepped


@pytest.mark.stress
@pytest.mark.parametrize("yaw", [-np.pi / 2, 2.0])
def test_a_crossing_changes_less_than_a_step(chromium: Any, city: nf.Scene, two: Path, yaw: float) -> None:
    xs = [5.9 + WALK / RATE * step for step in range(90)]
    with Server.of_bundle(two) as server, open_page(chromium, *SIZE) as shown:
        stepped = at_the_border(shown, server.url, yaw)
        told, pictures = zip(*(stepped.picture(pose(x, yaw), 1 / RATE) for x in xs), strict=True)
        assert shown.printed == []
    leaving = np.array([one["leaving"] is not None for one in told])
    # Half a second, beyond the border, and then the second region alone.
    assert leaving.sum() in (36, 37)
    entered = xs[int(np.argmax(leaving))]
    assert 6.0 < entered < 6.7
    assert (told[-1]["region"], told[-1]["shown"]["grown"]["radius"]) == (1, RADII[-1])
    scores, walked = continuity(list(pictures)), continuity([truth(city, x, yaw) for x in xs])
    crossing = scores[leaving[1:]]
    # The page's edges are not antialiased, and flicker.
    assert crossing.min() >= min(walked.min(), scores[~leaving[1:]].min())
    assert crossing.mean() >= walked.mean() - MAX_LOSS


@pytest.mark.stress
def test_without_a_fade_the_same_crossing_jumps(chromium: Any, city: nf.Scene, two: Path) -> None:
    yaw = 2.0
    manifest = json.loads((two / "manifest.json").read_text())
    manifest["growth"]["fade"] = 0
    xs = [5.9 + WALK / RATE * step for step in range(40)]
    with Server.of_bundle(two) as server, open_page(chromium, *SIZE) as shown:
        shown.route("**/manifest.json", lambda route: route.fulfill(body=json.dumps(manifest)))
        stepped = at_the_border(shown, server.url, yaw)
        pictures = [stepped.picture(pose(x, yaw), 1 / RATE)[1] for x in xs]
    walked = continuity([truth(city, x, yaw) for x in xs])
    assert continuity(pictures).min() < walked.min() - 0.02


@pytest.mark.stress
def test_near_geometry_stays_in_place(chromium: Any, city: nf.Scene, two: Path) -> None:
    x, yaw = 6.4, 0.3
    frame = nf.render(city, camera(x, yaw), channels=("position", "face_id"))
    points = frame.require("position")
    near = np.isfinite(points).all(axis=-1)
    for center in CENTERS:
        near &= np.hypot(points[..., 0] - center[0], points[..., 2] - center[2]) < NEAR_SHARE * RADII[-1]
    assert near.mean() > 0.3
    with Server.of_bundle(two) as server, open_page(chromium, *SIZE) as shown:
        stepped = at_the_border(shown, server.url, yaw)
        told, before = stepped.picture(pose(x, yaw), 0.0)
        assert (told["region"], told["leaving"]) == (1, 0)
        _, during = stepped.picture(pose(x, yaw), 0.25)
        told, after = stepped.picture(pose(x, yaw), 1.0)
        assert (told["region"], told["leaving"]) == (1, None)
    for picture in (during, after):
        off = np.abs(picture.astype(int) - before).max(axis=-1)
        assert (off[near] <= 2).mean() > 0.99
    # The far part is seen from another centre.
    assert (np.abs(after.astype(int) - before).max(axis=-1)[~near] > 2).mean() > 0.1


@pytest.mark.stress
def test_memory_stays_flat_over_fifty_regions(chromium: Any, hall: Path) -> None:
    manifest = json.loads((hall / "manifest.json").read_text())
    requests: list[str] = []
    with Server.of_bundle(hall) as server, open_page(chromium, 160, 120) as shown:
        count_objects(shown)
        shown.on("request", lambda request: requests.append(request.url.rsplit("/", 1)[-1]))
        shown.goto(f"{server.url}?aa=0")
        stepped = SteppedPage(shown)

        def stand(x: float) -> dict[str, Any]:
            return {"position": [x, gallery.EYE, 0.0], "yaw": 0.3, "pitch": PITCH}

        def arrive(place: int) -> dict[str, Any]:
            here = stand(gallery.center(place)[0])
            stepped.load(here, 0.1)
            for _ in range(4):
                told = stepped.frame(here, 200.0)
            assert told["shown"]["grown"] == {"radius": gallery.RADII[-1], "strength": 1}
            assert told["region"] == place
            assert len(told["regions"]) <= 2
            return {**objects(shown), "kept": told["kept"], "shared": told["shared"], "heap": heap(shown)}

        walked = []
        for place in range(PLACES):
            for step in range(1, 5) if place else ():
                stepped.frame(stand(gallery.center(place - 1)[0] + gallery.STEP * step / 4), 0.5)
            walked.append(arrive(place))
        # Files shared by regions are cached; faces of maps that are equal by chance are fetched again.
        asked = Counter(requests)
        parts = {name for region in manifest["regions"] for ring in region["rings"] for name in ring["parts"]}
        parts |= {manifest["dynamic"]["geometry"], *manifest["dynamic"]["parts"]}
        assert len(parts) > 2 * PLACES
        assert {asked[Path(name).name] for name in parts} == {1}
        jumped = []
        for place in range(PLACES - 6, 4, -8):
            jump(stepped, stand(gallery.center(place)[0]))
            jumped.append(arrive(place))
        assert shown.printed == []
    # Away from the ends of the hall: regions 10 to 44.
    walked = walked[10:-5]
    heaps = [row.pop("heap") for row in walked]
    assert max(heaps) < (1 + MAX_GROWTH) * heaps[0]
    assert max(row.pop("heap") for row in jumped) < (1 + MAX_GROWTH) * heaps[0]
    sizes = [row["kept"][0].pop("bytes") for row in walked]
    assert max(sizes) < 1.01 * min(sizes)
    # After a jump the old region is freed while some of the new one's buffers exist, more or less of them by chance.
    assert all(row.pop("kept")[0]["bytes"] < 2 * min(sizes) for row in jumped)
    # Objects of the GPU, and memory of workers, one by one.
    for rows in (walked, jumped):
        assert all(row == rows[0] for row in rows), rows


def jump(stepped: SteppedPage, target: dict[str, Any]) -> None:
    """Jump to a place like users do, and draw frames until the page is there."""
    stepped.page.evaluate("(target) => window.nearfar.viewer.go(target)", target)
    for _ in range(2000):
        told = stepped.frame(target, 0.05)
        if told["goal"] is None and told["leaving"] is None:
            return
    raise AssertionError(f"the page does not go there: {told}")


ROOMY = (600, 500)
"""Size of a page whose tools leave most of the picture free."""
PLACE = "window.nearfar.pose.position"


def floor_at(x: int, y: int) -> NDArray[np.float64]:
    """The floor position at the centre of a pixel, from the first centre, looking down by 0.4 along −z."""
    width, height = ROOMY
    tangent = np.tan(np.radians(ANGLE) / 2)
    right = (2 * (x + 0.5) / width - 1) * tangent * width / height
    up = (1 - 2 * (y + 0.5) / height) * tangent
    ray = np.array([right, np.sin(-0.4) + up * np.cos(0.4), -np.cos(0.4) + up * np.sin(-0.4)])
    return np.asarray(np.array([0, gallery.EYE, 0]) + ray * gallery.EYE / -ray[1])


def test_clicks_and_keys_lead_to_other_places(chromium: Any, hall: Path) -> None:
    with Server.of_bundle(hall) as server, open_page(chromium, *ROOMY) as shown:
        # All rings at once, so that the limit is that of the last one.
        shown.goto(f"{server.url}?aa=0&strategy=clovrd#p=0,{gallery.EYE},0&yaw=0&pitch=-0.4")
        shown.wait_for_function("() => window.nearfar?.viewer.facts.shown?.ring === 2", timeout=60e3)
        x, y = 300, 360
        # The point that a pixel shows is the scene's; between two pictures there is none.
        found = shown.evaluate(f"() => window.nearfar.viewer.pointAt({x / ROOMY[0]}, {y / ROOMY[1]})")
        assert np.allclose(found, floor_at(x, y), atol=2e-3)
        assert shown.evaluate("() => window.nearfar.viewer.pointAt(0.142, 0.02)") is None
        shown.mouse.dblclick(x, y)
        shown.wait_for_function(f"() => Math.abs({PLACE}[2] - {found[2]}) < 0.02", timeout=60e3)
        shown.keyboard.press("n")
        shown.wait_for_function(f"() => Math.hypot({PLACE}[0] - {gallery.STEP}, {PLACE}[2]) < 0.02", timeout=60e3)
        shown.wait_for_function("() => window.nearfar.viewer.facts.region === 1", timeout=60e3)
        assert shown.evaluate("() => document.querySelector('.note').textContent") == f"Place 2 of {PLACES}"
        assert shown.printed == []


def test_a_region_that_fails_to_load_keeps_the_old_picture(chromium: Any, hall: Path) -> None:
    manifest = json.loads((hall / "manifest.json").read_text())
    name = manifest["regions"][1]["rings"][1]["geometry"]
    with Server.of_bundle(hall) as server, open_page(chromium, *SIZE) as shown:
        shown.route(f"**/{name}", lambda route: route.fulfill(status=404))
        shown.goto(f"{server.url}?aa=0&strategy=clovrd")
        shown.wait_for_function("() => window.nearfar?.viewer.facts.shown?.ring === 2", timeout=60e3)
        beyond = {"position": [0.9 * gallery.STEP, gallery.EYE, 0.0], "yaw": 0.3, "pitch": PITCH}
        shown.evaluate("(pose) => window.nearfar.setPose(pose)", beyond)
        shown.wait_for_function("() => document.querySelector('#message').textContent !== ''", timeout=60e3)
        assert name in shown.evaluate("() => document.querySelector('#message').textContent")
        assert shown.evaluate("() => window.nearfar.viewer.facts.region") == 0
        assert shown.evaluate("() => window.nearfar.viewer.facts.shown.grown.radius") == gallery.RADII[-1]
        shown.unroute(f"**/{name}")
        shown.keyboard.press("r")
        shown.wait_for_function("() => window.nearfar.viewer.facts.region === 1", timeout=60e3)


def test_files_of_the_next_ring_are_fetched_while_a_ring_is_built(chromium: Any, two: Path) -> None:
    rings = json.loads((two / "manifest.json").read_text())["regions"][0]["rings"]
    names = [Path(ring["geometry"] or "none").name for ring in rings]
    asked: list[str] = []
    with Server.of_bundle(two) as server, open_page(chromium, 160, 120) as shown:
        shown.on("request", lambda request: asked.append(request.url.rsplit("/", 1)[-1]))
        shown.goto(f"{server.url}?aa=0")
        stepped = SteppedPage(shown)
        for _ in range(2000):
            if names[1] in asked:
                break
            stepped.frame(pose(CENTERS[0][0], 0.3), 0.0)
            shown.wait_for_timeout(10)
        # Without frames nothing is uploaded, so ring 1 cannot be shown.
        shown.wait_for_timeout(2000)
        assert shown.evaluate("() => window.nearfar.viewer.facts.arrived") == 0
        assert names[2] in asked
        assert names[3] not in asked
