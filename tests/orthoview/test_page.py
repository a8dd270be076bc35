"""The page that flies trees, in a browser: its pictures of views beside Python's, and its handling of missing parts."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar.serve._server import Server
from nearfar.view._tree import tree_page
from tests.support.browser import open_page, wait_until
from tests.support.flown_page import (
    SIZE,
    Pose,
    facts,
    grabbed,
    holes,
    likeness,
    link,
    open_flight,
    page_camera,
    problems,
    rendered,
)
from tests.support.range_server import RangeHandler, running, serve_folder

pytestmark = pytest.mark.slow

AIR: Pose = {"position": [0.0, 45.0, 110.0], "yaw": 0.0, "pitch": -0.4}
STREET: Pose = {"position": [20.0, 3.0, 22.0], "yaw": 0.7, "pitch": 0.0}
FAR: Pose = {"position": [0.0, 300.0, 900.0], "yaw": 0.0, "pitch": -0.3}


@pytest.mark.parametrize(("pose", "least", "samples"), [(STREET, 0.9, 1), (AIR, 0.99, 4)])
def test_pictures_equal_render(
    chromium: Any, city: nf.orthoview.OrthoTree, pose: Pose, least: float, samples: int
) -> None:
    with Server.of_bundle(city.path) as server, open_page(chromium, *SIZE) as page:
        told = open_flight(page, f"{server.url}?geometry=0&samples={samples}{link(pose)}")
        found = grabbed(page)
        assert page.printed == []
    frame = rendered(city, pose, samples)
    assert told["graphics"] == "webgl"
    assert (told["views"], told["standIns"], told["holes"]) == (frame.stats["views"], 0, 0)
    assert (told["leaves"], told["triangles"]) == (0, 0)
    assert likeness(found, frame) > least
    assert holes(found, frame) < 0.001


def test_webp_colours_are_drawn(chromium: Any, few: nf.Scene, tmp_path: Path) -> None:
    # Without geometry, which would hide the colours of near views.
    trees = {
        color: nf.orthoview.build(few, tmp_path / color, cell=40, size=32, directions=5, color=color, geometry=False)
        for color in ("zstd", "webp")
    }
    pictures = []
    for tree in trees.values():
        low, high = tree.bounds
        pose = {"position": [*(low[:2] + high[:2]) / 2, high[2] + 50], "yaw": 0.0, "pitch": 0.0}
        with Server.of_bundle(tree.path) as server, open_page(chromium, *SIZE) as page:
            open_flight(page, f"{server.url}{link(pose)}")
            pictures.append(grabbed(page))
    np.testing.assert_array_equal(pictures[0], pictures[1])
    assert len(np.unique(pictures[0].reshape(-1, 3), axis=0)) > 50


# Failing servers: Node tests messages about files and repeated requests -----------------------------------------------
@dataclass
class Host:
    """A file server with failures controlled by the test."""

    url: str
    status: int = 0
    """Status for requests for shards; 0 for their content."""


@contextmanager
def hosted(folder: Path) -> Iterator[Host]:
    class Handler(RangeHandler):
        def do_GET(self) -> None:  # noqa: N802 - the base class's name
            if host.status and "/c/" in self.path:
                self.send_error(host.status)
            else:
                super().do_GET()

    with running(partial(Handler, directory=str(folder.parent))) as url:
        host = Host(f"{url}{folder.name}/")
        yield host


def test_the_old_picture_stays_when_the_server_fails(
    chromium: Any, city: nf.orthoview.OrthoTree, copied_city: Path
) -> None:
    frame = rendered(city, AIR)
    with hosted(copied_city) as host, open_page(chromium, *SIZE) as page:
        open_flight(page, f"{host.url}?geometry=0{link(FAR)}")
        host.status = 500
        page.evaluate("(pose) => window.orthoview.setPose(pose)", AIR)
        wait_until(page, lambda: problems(page))
        assert len(problems(page)) == 1
        assert "answers 500" in problems(page)[0]
        wait_until(page, lambda: facts(page)["standIns"] > 0)
        assert (facts(page)["waiting"] > 0, facts(page)["holes"]) == (True, 0)
        host.status = 0
        wait_until(page, lambda: facts(page)["isComplete"] and not facts(page)["standIns"])
        wait_until(page, lambda: problems(page) == [])
        found = grabbed(page)
    assert holes(found, frame) < 0.02
    assert likeness(found, frame) > 0.98


def test_damage_is_reported_once_and_a_coarser_picture_stays(
    chromium: Any, city: nf.orthoview.OrthoTree, copied_city: Path
) -> None:
    own = nf.orthoview.open(copied_city)
    view = next(key for key in own.cut(page_camera(AIR), geometry=False).keys(in_picture=True) if key[0] == 0)
    (chunk,) = own._chunks.locate([key := own._layout.key(view)])
    assert chunk is not None
    content = bytearray((copied_city / chunk.file).read_bytes())
    content[chunk.first + chunk.length - 2] ^= 1  # In the frame's checksum.
    (copied_city / chunk.file).write_bytes(content)
    with hosted(copied_city) as host, open_page(chromium, *SIZE) as page:
        told = open_flight(page, f"{host.url}?geometry=0{link(AIR)}")
        (listed,) = problems(page)
        found = grabbed(page)
    assert listed.startswith(key[2])
    assert "checksum" in listed
    assert told["standIns"] > 0
    assert told["holes"] == told["waiting"] == 0
    frame = rendered(city, AIR)
    assert likeness(found, frame) > 0.9
    assert holes(found, frame) < 0.02


def test_stores_that_cannot_be_shown_are_reported(chromium: Any, tmp_path: Path) -> None:
    (tmp_path / "tree").mkdir()
    for name, content in tree_page().items():
        (tmp_path / "tree" / name).write_bytes(content)
    with hosted(tmp_path / "tree") as host, open_page(chromium, *SIZE) as page:
        for text, title in (("", "There is no tree"), ("{", "The tree is damaged")):
            if text:
                (tmp_path / "tree" / "zarr.json").write_text(text)
            page.goto(host.url)
            wait_until(page, lambda: page.locator("#message h1").count())
            assert title in page.locator("#message h1").inner_text()


# Controls -------------------------------------------------------------------------------------------------------------
def pose_of(page: Any) -> Pose:
    return dict(page.evaluate("() => window.orthoview.pose"))


def linked_yaw(page: Any) -> float:
    return float(page.evaluate("() => new URLSearchParams(location.hash.slice(1)).get('yaw')"))


def test_keys_fly_and_the_address_restores_the_pose(chromium: Any, city: nf.orthoview.OrthoTree) -> None:
    def has_gone(page: Any, before: list[float], axis: int, sign: int) -> bool:
        return bool(sign * (pose_of(page)["position"][axis] - before[axis]) > 1)

    with Server.of_bundle(city.path) as server, open_page(chromium, 640, 400) as page:
        open_flight(page, f"{server.url}?geometry=0&error=16{link(AIR)}")
        assert pose_of(page)["position"] == AIR["position"]
        for key, axis, sign in (("w", 2, -1), ("e", 1, 1), ("d", 0, 1)):
            before = pose_of(page)["position"]
            page.keyboard.down(key)
            wait_until(page, partial(has_gone, page, before, axis, sign))
            page.keyboard.up(key)
        turned = pose_of(page)["yaw"]
        page.mouse.move(320, 150)
        page.mouse.down()
        page.mouse.move(520, 150, steps=3)
        page.mouse.up()
        wait_until(page, lambda: pose_of(page)["yaw"] > turned + 0.1)
        wait_until(page, lambda: linked_yaw(page) == pytest.approx(pose_of(page)["yaw"], abs=1e-3))
        there = pose_of(page)
        page.reload()
        wait_until(page, lambda: facts(page)["isComplete"])
        np.testing.assert_allclose(pose_of(page)["position"], there["position"], atol=1e-3)


def test_nothing_extends_beyond_the_screen(chromium: Any, city: nf.orthoview.OrthoTree) -> None:
    for size in ((1280, 800), (390, 844)):
        with Server.of_bundle(city.path) as server, open_page(chromium, *size) as page:
            open_flight(page, f"{server.url}?geometry=0&error=64")
            home = pose_of(page)
            if size[0] < 600:
                page.get_by_role("button", name="Figures").click()
            page.get_by_role("button", name="Help").click()
            boxes = page.evaluate("""() => [...document.querySelectorAll('.card, .tools, button, canvas')]
              .map((each) => each.getBoundingClientRect()).filter(({ width }) => width > 0)
              .map(({ left, top, right, bottom }) => [left, top, right, bottom])""")
            inner = page.evaluate("() => [document.documentElement.scrollWidth, document.documentElement.scrollHeight]")
            values = page.locator(".figures dd").all_inner_texts()
            page.evaluate("(pose) => window.orthoview.setPose(pose)", AIR)
            page.get_by_role("button", name="Home").click()
            assert pose_of(page) == home
        assert tuple(inner) == size
        assert len(boxes) >= 6
        assert min(min(left, top) for left, top, _, _ in boxes) >= 0
        assert max(right for _, _, right, _ in boxes) <= size[0]
        assert max(bottom for _, _, _, bottom in boxes) <= size[1]
        assert len(values) == 7
        assert all(text and text != "–" for text in values)


# Near leaves as geometry ----------------------------------------------------------------------------------------------
NEAR: Pose = {"position": [3.0, 14.0, 34.0], "yaw": 0.5, "pitch": -0.2}
UPWARD: Pose = {"position": [20.0, 3.0, 22.0], "yaw": 0.7, "pitch": 0.25}
WALL: Pose = {"position": [0.0, 3.0, 9.0], "yaw": 0.2, "pitch": -0.1}


@pytest.mark.parametrize(("pose", "least", "samples"), [(UPWARD, 0.99, 1), (NEAR, 0.99, 4)])
def test_pictures_equal_render_with_geometry(
    chromium: Any, city: nf.orthoview.OrthoTree, pose: Pose, least: float, samples: int
) -> None:
    with Server.of_bundle(city.path) as server, open_page(chromium, *SIZE) as page:
        told = open_flight(page, f"{server.url}?samples={samples}{link(pose)}")
        found = grabbed(page)
        assert page.printed == []
        assert problems(page) == []
    frame = rendered(city, pose, samples, geometry=True)
    assert told["views"] == frame.stats["views"]
    assert told["leaves"] >= frame.stats["leaves"] > 0
    assert told["triangles"] > 0
    assert told["standIns"] == told["holes"] == 0
    assert likeness(found, frame) > least
    assert likeness(found, frame) > likeness(found, rendered(city, pose, samples)) + 0.02
    assert holes(found, frame) < 0.001


def test_textures_and_colours_are_drawn(chromium: Any, textured: nf.orthoview.OrthoTree) -> None:
    with serve_folder(Path(textured.path)) as server, open_page(chromium, *SIZE) as page:
        told = open_flight(page, f"{server.url}index.html{link(WALL)}")
        found = grabbed(page)
        assert problems(page) == []
    # Leaves share it, and the server sends no cache headers.
    assert told["leaves"] >= 2
    assert [count for (_, name, _), count in server.answers.items() if "images/" in name] == [1]
    frame = rendered(textured, WALL, geometry=True)
    assert frame.stats["views"] == 0
    off = np.abs(frame.to_image().astype(int) - found).max(axis=-1)
    assert (off <= 3).mean() > 0.97
    assert len(np.unique(found.reshape(-1, 3), axis=0)) > 500


def test_damaged_geometry_is_reported_and_replaced_by_views(
    chromium: Any, city: nf.orthoview.OrthoTree, copied_city: Path
) -> None:
    place = city.cut(page_camera(NEAR)).leaf_places(in_picture=True)[0]
    (file,) = copied_city.glob(f"geometry/content/*/{'/'.join(map(str, place))}.glb")
    with Server.of_bundle(copied_city) as server, open_page(chromium, *SIZE) as page:
        file.write_bytes(file.read_bytes()[:-3] + b"abc")
        told = open_flight(page, f"{server.url}{link(NEAR)}")
        (listed,) = problems(page)
        found = grabbed(page)
    assert file.name in listed
    assert "record" in listed
    assert told["leaves"] > 0
    assert told["views"] > city.render(page_camera(NEAR)).stats["views"]
    assert told["holes"] == told["waiting"] == 0
    assert holes(found, rendered(city, NEAR)) < 0.02
