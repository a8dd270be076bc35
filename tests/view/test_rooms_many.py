"""Eight pages in a room: each sees the pointers of the others end at their targets, 16 to 36 m away."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import ExitStack
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from nearfar.serve._limits import Rooms
from nearfar.serve._server import Server
from nearfar.serve._site import Site
from tests.support.browser import open_page, wait_for_ring, wait_until
from tests.support.room_pages import RoomPage, ends, has_changed

pytestmark = [pytest.mark.slow, pytest.mark.stress]

SIZE = (240, 160)
CENTER = np.array([3.0, 1.7, -2.0])
RADII = (10.0, 30.0)
NEAR_SHARE = 0.7
RINGS = (2, 2, 2, 2, 2, 2, 1, 1)
"""The last ring of each page: the last two pages show all targets on their maps."""

DISTANCES = {"near": (16.0, 20.5), "morph": (21.5, 28.0), "map": (30.5, 36.0)}
"""Distances from the centre, metres: within 21 m nothing is morphed, beyond 30 m the map shows it."""

PIXEL = 2 * np.tan(np.radians(37.5)) / SIZE[1]
POINTERS_ALONE = """() => {
  const { viewer, room } = window.nearfar;
  const isPointer = ({ material }) => 'end' in material.uniforms;
  viewer.setGuests({
    get meshes() { return room.avatars.meshes.filter(isPointer); },
    place: room.avatars.place,
  });
}"""
"""Heads and names hide geometry behind them."""

MAX = 0.1
"""Distance from the surface in metres within which pointers end, besides a pixel."""


def zones_of(page: int) -> tuple[float, float]:
    """Both radii of a page's morph."""
    last = RADII[RINGS[page] - 1]
    return NEAR_SHARE * last, last


def position_of(page: int) -> NDArray[np.float64]:
    """Eight users around the centre."""
    angle, away = page * np.pi / 4, (1.2, 1.8)[page % 2]
    return CENTER + away * np.array([np.sin(angle), 0, -np.cos(angle)])


@pytest.fixture(scope="module")
def pages(chromium: Any, city: nf.Scene, tmp_path_factory: pytest.TempPathFactory) -> Iterator[list[RoomPage]]:
    folder = tmp_path_factory.mktemp("many") / "bundle"
    nf.stream.export(city, folder, center=tuple(CENTER), radii=RADII, face_size=256)
    with ExitStack() as stack:
        server = stack.enter_context(Server({"": Site.of_bundle(folder)}, rooms=Rooms()))
        made: list[RoomPage] = []
        for number, rings in enumerate(RINGS):
            shown = stack.enter_context(open_page(chromium, *SIZE))
            shown.goto(f"{server.url}?aa=0&strategy=clovrd&room=many&name=User{number}&rings={rings}")
            assert wait_for_ring(shown, rings) == ""
            shown.evaluate("() => document.querySelector('#ui').style.setProperty('display', 'none')")
            shown.wait_for_function("() => window.nearfar.room")
            shown.evaluate(POINTERS_ALONE)
            made.append(RoomPage(shown, {"position": position_of(number).tolist(), "yaw": 0.0, "pitch": 0.0}))
        wait_until(made[0].page, lambda: all(len(each.step()["seen"]) == len(RINGS) - 1 for each in made))
        yield made
        for each in made:
            assert each.page.printed == []


def targets(scene: nf.Scene, least: float, most: float) -> NDArray[np.float64]:
    """A point of a wall for each user that all of them see, at a distance from the centre."""
    rng = np.random.default_rng(7)
    yaw, pitch = rng.uniform(-np.pi, np.pi, 20_000), rng.uniform(-0.03, 0.15, 20_000)
    found = cast(scene, CENTER, np.stack([-np.sin(yaw), np.tan(pitch), -np.cos(yaw)], axis=1))
    rho = np.hypot(*(found - CENTER)[:, [0, 2]].T)
    found = found[(rho > least) & (rho < most) & (found[:, 1] > 0.6)]
    for eye in map(position_of, range(len(RINGS))):
        # With the pixels around it, on a wall that is not at a grazing angle.
        for up, aside in ((0, 0), (2, 0), (-2, 0), (0, 2), (0, -2)):
            ways = found - eye
            away = np.linalg.norm(ways, axis=1, keepdims=True)
            right = np.cross(ways, (0, 1, 0)) / away
            hits = cast(scene, eye, ways + PIXEL * away * (np.multiply(up, (0, 1, 0)) + aside * right))
            reach = 0.02 + 2 * PIXEL * np.hypot(up, aside) * away[:, 0]
            found = found[np.linalg.norm(hits - found, axis=1) < reach]
    angle = np.arctan2(found[:, 0] - CENTER[0], found[:, 2] - CENTER[2])
    # All around: one from each eighth of the candidates.
    order = found[np.argsort(angle)]
    return np.stack([order[(2 * n + 1) * len(order) // 16] for n in range(len(RINGS))])


def cast(scene: nf.Scene, eye: NDArray[np.float64], ways: NDArray[np.float64]) -> NDArray[np.float64]:
    """The points that rays hit; far away for misses."""
    units = ways / np.linalg.norm(ways, axis=1, keepdims=True)
    length = nf.cast_rays(scene, np.broadcast_to(eye, units.shape), units).t_hit
    return np.asarray(eye + np.minimum(length, 1e3)[:, None] * units, np.float64)


def turn_to(pages: list[RoomPage], number: int, target: NDArray[np.float64]) -> None:
    """Turn a user to where its picture shows a point."""
    inner, radius = zones_of(number)
    eye = position_of(number)
    x, y, z = nf.morph([target], user=eye, center=CENTER, r1=inner, r2=radius)[0] - eye
    pages[number].pose |= {"yaw": float(np.arctan2(-x, -z)), "pitch": float(np.arctan2(y, np.hypot(x, z)))}


def pointed(pages: list[RoomPage], number: int, target: NDArray[np.float64]) -> NDArray[np.float64]:
    """The end of the pointer of a user who points at a point of the world."""
    turn_to(pages, number, target)
    pages[number].step()
    column, row = np.floor(pages[number].pixel_of([target], CENTER, zones_of(number))[0]).astype(int)
    end = ends(pages[number].point_at(int(column), int(row))["own"])[1]
    shown = pages[number].pixel_of([end], CENTER, zones_of(number))[0]
    assert np.hypot(*(shown - (column + 0.5, row + 0.5))) < 1.0
    return end


def seen_end(viewer: RoomPage, name: str) -> NDArray[np.float64] | None:
    """The end of a user's pointer as a viewer sees it."""
    body = next(each for each in viewer.step()["seen"] if each["name"] == name)
    return ends(body)[1] if body["pointer"] else None


def check_picture(pages: list[RoomPage], viewer: int, name: str, end: NDArray[np.float64]) -> None:
    """Check that the picture of a viewer shows the end of a pointer at its position."""
    one = pages[viewer]
    before = dict(one.pose)
    turn_to(pages, viewer, end)
    guest = next(each["number"] for each in one.step()["seen"] if each["name"] == name)
    found = one.picture()
    mute = "([number, isMuted]) => window.nearfar.room.presence.mute(number, isMuted)"
    one.page.evaluate(mute, [guest, True])
    without = one.picture()
    one.page.evaluate(mute, [guest, False])
    mask = np.abs(found - without).max(axis=-1) > 12
    assert has_changed(mask, np.multiply(SIZE, 0.5), 1.5), (viewer, name)
    one.pose = before


@pytest.mark.parametrize("zone", DISTANCES)
def test_eight_users_see_where_the_others_point(pages: list[RoomPage], city: nf.Scene, zone: str) -> None:
    wanted = targets(city, *DISTANCES[zone])
    assert np.linalg.norm([b - a for a, b in pairwise(wanted)], axis=1).min() > 0.3
    misses: list[float] = []
    for number, one in enumerate(pages):
        end, name = pointed(pages, number, wanted[number]), f"User{number}"
        others = [each for each in range(len(pages)) if each != number]

        def has_come(end: Any = end, name: str = name, one: RoomPage = one, others: Any = tuple(others)) -> bool:
            one.step()
            seen = [seen_end(pages[other], name) for other in others]
            return all(each is not None and np.linalg.norm(each - end) < 0.05 for each in seen)

        wait_until(one.page, has_come)
        pixel = PIXEL * np.linalg.norm(end - position_of(number))
        for other in others:
            seen = seen_end(pages[other], name)
            assert seen is not None
            misses.append(float(nf.nearest_points(city, [seen]).distance[0]))
            assert misses[-1] < MAX + pixel, (number, other)
        # Each pair in one of the zones.
        for other in others:
            if (number + other) % len(DISTANCES) == list(DISTANCES).index(zone):
                check_picture(pages, other, name, end)
        one.page.keyboard.up("e")
        one.step()
    print(f"{zone}: metres to the surface, median {np.median(misses):.4f}, most {max(misses):.4f}, of {len(misses)}")
