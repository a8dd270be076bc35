"""Controllers and hands in the page's immersive mode, in an emulated headset."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from nearfar.serve._server import Server
from tests.support import need
from tests.support.browser import started
from tests.support.headset import (
    HEADSETS,
    Floor,
    Vector,
    about,
    floor_of,
    floor_under,
    folder_of,
    frames,
    look,
    point,
    push,
    squeeze,
    thrown,
    times,
    worn,
)

pytestmark = pytest.mark.slow

CENTER: Vector = (3.0, 1.7, -2.0)
START: Vector = (3.4, 1.7, -2.3)
YAW = 0.6
LIMIT = 7.0
"""Metres from the centre at which the picture of a radius of 10 m folds."""
HEAD: Vector = (0.2, 1.6, -0.1)
FIRST: Vector = (0.0, 1.6, 0.0)
STRAIGHT = (0.0, 0.0, 0.0, 1.0)


@pytest.fixture(scope="module")
def bundle(tmp_path_factory: pytest.TempPathFactory) -> nf.stream.Bundle:
    folder = tmp_path_factory.mktemp("hands") / "bundle"
    scene = nf.datasets.city(blocks=2, detail=1)
    settings: dict[str, Any] = {"face_size": 64, "quality": None, "pixels_per_degree": None}
    return nf.stream.export(scene, folder, center=CENTER, radii=(10.0,), **settings)


@pytest.fixture(scope="module")
def page(bundle: nf.stream.Bundle) -> Iterator[Any]:
    """A page that all tests enter anew, at the same place."""
    need("browser")
    need("web")
    place = ",".join(map(str, START))
    with started() as program, Server.of_bundle(folder_of(bundle)) as server:
        url = f"{server.url}?strategy=clovrd#p={place}&yaw={YAW}&pitch=-0.2"
        with worn(program, url, "quest3", (120, 120), 1) as shown:
            yield shown
            assert shown.printed == []


@pytest.fixture
def entered(page: Any) -> Iterator[tuple[Any, Floor]]:
    """The page in the headset, and the floor of its user, whose head is at HEAD."""
    page.evaluate(
        "([place, yaw]) => { window.emulated.device.primaryInputMode = 'controller';"
        " const { viewer } = window.nearfar; viewer.go({ position: place, yaw, pitch: 0 }); }",
        [START, YAW],
    )
    look(page, FIRST, STRAIGHT)
    frames(page, 4)
    look(page, HEAD, STRAIGHT)
    yield page, at_rest(page)
    for hand in ("left", "right"):
        push(page, hand, 0, 0)
        squeeze(page, hand, 0)
    at_rest(page)


def at_rest(page: Any) -> Floor:
    """The floor when it has stopped and no jump is on its way."""
    frames(page, 3)
    for _ in range(100):
        before = floor_of(page, CENTER)
        page.wait_for_timeout(300)
        frames(page, 3)
        if np.allclose(before.position, floor_of(page, CENTER).position, rtol=0, atol=1e-7):
            return before
    raise AssertionError("the user does not come to rest")


def head_of(floor: Floor, head: Vector = HEAD) -> NDArray[np.float64]:
    return floor.eye(head, STRAIGHT, 0)[0]


def away(place: NDArray[np.float64]) -> float:
    return float(np.hypot(place[0] - CENTER[0], place[2] - CENTER[2]))


def test_the_head_stands_where_the_page_was(entered: tuple[Any, Floor]) -> None:
    _, floor = entered
    expected = floor_under(START, YAW, FIRST)
    assert np.allclose(floor.position, expected.position, atol=1e-5)
    assert floor.yaw == pytest.approx(expected.yaw)


def test_the_left_stick_walks_the_way_the_head_looks(entered: tuple[Any, Floor]) -> None:
    page, before = entered
    look(page, HEAD, times(about((0, 1, 0), 0.4), about((1, 0, 0), -0.5)))
    push(page, "left", 0.0, -1.0)
    frames(page, 6)
    push(page, "left", 0.0, 0.0)
    after = at_rest(page)
    step = after.position - before.position
    yaw = YAW + 0.4
    assert after.yaw == pytest.approx(before.yaw)
    assert step[1] == pytest.approx(0, abs=1e-9)
    assert np.hypot(step[0], step[2]) > 0.1
    assert np.arctan2(-step[0], -step[2]) == pytest.approx(yaw, abs=1e-4)


def test_the_right_stick_turns_in_steps_around_the_head(entered: tuple[Any, Floor]) -> None:
    page, before = entered
    for push_to, turned in ((1.0, -30), (1.0, -30), (0.0, -30), (-1.0, 0), (0.0, 0), (-0.9, 30)):
        push(page, "right", push_to, 0.0)
        frames(page, 3)
        after = floor_of(page, CENTER)
        assert np.degrees(after.yaw - before.yaw) == pytest.approx(turned, abs=1e-6)
        assert np.allclose(head_of(after), head_of(before), atol=1e-6)


def test_walking_never_leads_beyond_the_margin(entered: tuple[Any, Floor]) -> None:
    page, _ = entered
    push(page, "left", 0.0, -1.0, pressed=True)
    farthest = 0.0
    for _ in range(12):
        page.wait_for_timeout(300)
        frames(page, 2)
        farthest = max(farthest, away(head_of(floor_of(page, CENTER))))
    push(page, "left", 0.0, 0.0)
    half = HEADSETS["quest3"] / 2
    assert 0.9 * LIMIT < farthest < LIMIT - half


@pytest.mark.parametrize("kind", ["controllers", "hands"])
@pytest.mark.parametrize("hand", ["left", "right"])
def test_a_jump_lands_where_it_was_aimed(entered: tuple[Any, Floor], kind: str, hand: str) -> None:
    page, before = entered
    if kind == "hands":
        page.evaluate("() => { window.emulated.device.primaryInputMode = 'hand'; }")
        frames(page, 3)
    place: Vector = (0.3, 1.2, -0.3)
    turn = times(about((0, 1, 0), 0.5), about((1, 0, 0), -0.7))
    point(page, hand, place, turn, kind)
    frames(page, 3)
    ray, aimed = target_of(page, hand)
    assert aimed is None
    squeeze(page, hand, 1, kind)
    frames(page, 3)
    ray, aimed = target_of(page, hand)
    goal = thrown(before, *ray)
    assert away(goal) < LIMIT - 0.1
    # The ring lies where the arc comes down, on the floor.
    assert aimed is not None
    world = before.position + np.array(floor_turned(before, aimed))
    assert np.allclose(world, goal, atol=1e-3)
    assert np.allclose(floor_of(page, CENTER).position, before.position)
    squeeze(page, hand, 0, kind)
    after = at_rest(page)
    assert target_of(page, hand)[1] is None
    assert np.allclose(head_of(after)[[0, 2]], goal[[0, 2]], atol=1e-3)
    assert after.yaw == pytest.approx(before.yaw)
    assert after.position[1] == pytest.approx(before.position[1])


def floor_turned(floor: Floor, local: Vector) -> list[float]:
    """A point of the headset's space relative to the floor's origin, in the directions of the world."""
    cos, sin = np.cos(floor.yaw), np.sin(floor.yaw)
    return [cos * local[0] + sin * local[2], local[1], -sin * local[0] + cos * local[2]]


def target_of(page: Any, hand: str) -> tuple[tuple[Vector, Any], Vector | None]:
    """The pose of a hand's ray, which the emulator derives from that of the hand, and the ring on the floor."""
    ray, ring = page.evaluate(
        """(hand) => new Promise((done) => {
          const { renderer, rig } = window.nearfar.viewer;
          const session = renderer.xr.getSession();
          session.requestAnimationFrame((_, frame) => {
            const source = [...session.inputSources].find(({ handedness }) => handedness === hand);
            const { transform } = frame.getPose(source.targetRaySpace, renderer.xr.getReferenceSpace());
            const { position: p, orientation: q } = transform;
            let ring = null;
            rig.traverse((one) => { if (one.geometry?.type === 'RingGeometry') ring = one; });
            done([[[p.x, p.y, p.z], [q.x, q.y, q.z, q.w]], ring.visible ? ring.position.toArray() : null]);
          });
        })""",
        hand,
    )
    return (tuple(ray[0]), tuple(ray[1])), ring and tuple(ring)


def test_no_jump_leads_beyond_the_margin(entered: tuple[Any, Floor]) -> None:
    page, _ = entered
    # Upwards at 40° it would lead some seven metres on.
    point(page, "right", (0.2, 1.2, -0.2), about((1, 0, 0), 0.7))
    for _ in range(2):
        squeeze(page, "right", 1)
        frames(page, 3)
        squeeze(page, "right", 0)
        floor = at_rest(page)
        place, aside = head_of(floor), floor.eye(HEAD, STRAIGHT, HEADSETS["quest3"] / 2)[0]
        assert 0.95 * LIMIT < away(place) < LIMIT
        assert away(aside) <= LIMIT


def test_a_body_that_walks_out_takes_the_floor_along(entered: tuple[Any, Floor]) -> None:
    page, before = entered
    for metres in (2.0, 6.0, 9.0, 12.0):
        head: Vector = (HEAD[0], HEAD[1], HEAD[2] - metres)
        look(page, head, STRAIGHT)
        frames(page, 3)
        floor = floor_of(page, CENTER)
        for aside in (-HEADSETS["quest3"] / 2, HEADSETS["quest3"] / 2):
            assert away(floor.eye(head, STRAIGHT, aside)[0]) <= LIMIT
    assert not np.allclose(floor.position, before.position, atol=1)
    # A step back is a step back at once.
    back: Vector = (head[0], head[1], head[2] + 0.5)
    look(page, back, STRAIGHT)
    frames(page, 3)
    assert np.allclose(floor_of(page, CENTER).position, floor.position, atol=1e-9)


def test_hands_are_drawn_by_their_joints(entered: tuple[Any, Floor]) -> None:
    page, _ = entered
    counts = """() => { const found = { joints: 0, bodies: 0 };
      window.nearfar.viewer.rig.traverse((one) => {
        if (!one.visible) return;
        if (one.isInstancedMesh) found.joints += one.count;
        else if (one.geometry?.type === 'CapsuleGeometry') found.bodies += 1;
      });
      return found; }"""
    assert page.evaluate(counts) == {"joints": 0, "bodies": 2}
    page.evaluate("() => { window.emulated.device.primaryInputMode = 'hand'; }")
    frames(page, 3)
    assert page.evaluate(counts) == {"joints": 50, "bodies": 0}


def test_a_menu_of_the_system_takes_the_hands_away(entered: tuple[Any, Floor]) -> None:
    page, before = entered
    page.evaluate("() => window.emulated.device.updateVisibilityState('visible-blurred')")
    push(page, "left", 0.0, -1.0)
    frames(page, 5)
    assert np.allclose(floor_of(page, CENTER).position, before.position)
    push(page, "left", 0.0, 0.0)
    page.evaluate("() => window.emulated.device.updateVisibilityState('visible')")
    frames(page, 4)


def test_recentring_leaves_the_head_where_it_is(entered: tuple[Any, Floor]) -> None:
    page, before = entered
    place = head_of(before)
    page.evaluate("() => window.emulated.device.recenter()")
    frames(page, 4)
    found = page.evaluate(
        "() => window.nearfar.viewer.camera.getWorldPosition(window.nearfar.viewer.rig.position.clone()).toArray()"
    )
    assert np.hypot(*(np.add(found, CENTER) - place)[[0, 2]]) < 0.05


def test_leaving_goes_on_where_the_head_was(page: Any) -> None:
    look(page, (0.5, 1.2, -0.5), STRAIGHT)
    frames(page, 3)
    floor = floor_of(page, CENTER)
    place = head_of(floor, (0.5, 1.2, -0.5))
    page.evaluate("() => document.querySelector('.tool-main').click()")
    page.wait_for_function("() => !window.nearfar.viewer.renderer.xr.isPresenting")
    page.wait_for_timeout(500)
    found = floor_of(page, CENTER)
    assert np.allclose(found.position, (place[0], floor.position[1] + 1.7, place[2]), atol=1e-4)
    assert found.yaw == 0
    # And the headset begins where the screen has stopped.
    look(page, FIRST, STRAIGHT)
    page.get_by_role("button", name="Enter VR").click()
    page.wait_for_function("() => window.nearfar.viewer.renderer.xr.isPresenting")
    frames(page, 3)
    again = floor_of(page, CENTER)
    assert np.allclose(again.position, (place[0], floor.position[1], place[2]), atol=1e-4)
    assert again.yaw == pytest.approx(floor.yaw)
