"""Controllers and hands in the page's immersive mode, in an emulated headset."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from nearfar.serve._server import Server
from tests.support import need
from tests.support.browser import wait_until
from tests.support.headset import (
    HEADSETS,
    Floor,
    Vector,
    about,
    enter,
    floor_of,
    floor_under,
    frames,
    look,
    point,
    push,
    rest,
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
"""Distance from the centre in metres at which the picture of a radius of 10 m folds."""
HEAD: Vector = (0.2, 1.6, -0.1)
FIRST: Vector = (0.0, 1.6, 0.0)
STRAIGHT = (0.0, 0.0, 0.0, 1.0)


@pytest.fixture(scope="module")
def page(chromium: Any, street: Path) -> Iterator[Any]:
    """A page that every test enters again, at the same place."""
    need("web")
    place = ",".join(map(str, START))
    with Server.of_bundle(street) as server:
        url = f"{server.url}?strategy=clovrd#p={place}&yaw={YAW}&pitch=-0.2"
        with worn(chromium, url, "quest3", (80, 100), 1) as shown:
            yield shown
            assert shown.printed == []


@pytest.fixture
def entered(page: Any) -> tuple[Any, Floor]:
    """The page in the headset, and the floor of its user, whose head is at HEAD."""
    for hand in ("left", "right"):
        push(page, hand, 0, 0)
        squeeze(page, hand, 0)
    page.evaluate(
        "([place, yaw]) => { window.emulated.device.primaryInputMode = 'controller';"
        " const { viewer } = window.nearfar; viewer.go({ position: place, yaw, pitch: 0 }); }",
        [START, YAW],
    )
    look(page, FIRST, STRAIGHT)
    frames(page, 4)
    look(page, HEAD, STRAIGHT)
    return page, at_rest(page)


def at_rest(page: Any) -> Floor:
    """The floor once it has stopped and no jump is in progress."""
    rest(page)
    return floor_of(page, CENTER)


def head_of(floor: Floor, head: Vector = HEAD) -> NDArray[np.float64]:
    return floor.eye(head, STRAIGHT, 0)[0]


def away(place: NDArray[np.float64]) -> float:
    return float(np.hypot(place[0] - CENTER[0], place[2] - CENTER[2]))


def test_sticks_walk_in_the_heads_direction_and_turn_in_steps_about_it(entered: tuple[Any, Floor]) -> None:
    page, before = entered
    # The head stands at the page's position.
    expected = floor_under(START, YAW, FIRST)
    assert np.allclose(before.position, expected.position, atol=1e-5)
    assert before.yaw == pytest.approx(expected.yaw)
    for push_to, turned in ((1.0, -30), (1.0, -30), (0.0, -30), (-1.0, 0), (0.0, 0), (-0.9, 30)):
        push(page, "right", push_to, 0.0)
        frames(page, 3)
        after = floor_of(page, CENTER)
        assert np.degrees(after.yaw - before.yaw) == pytest.approx(turned, abs=1e-6)
        assert np.allclose(head_of(after), head_of(before), atol=1e-6)
    look(page, HEAD, times(about((0, 1, 0), 0.4), about((1, 0, 0), -0.5)))
    push(page, "left", 0.0, -1.0)
    frames(page, 6)
    push(page, "left", 0.0, 0.0)
    step = at_rest(page).position - after.position
    assert step[1] == pytest.approx(0, abs=1e-9)
    assert np.hypot(step[0], step[2]) > 0.1
    assert np.arctan2(-step[0], -step[2]) == pytest.approx(YAW + np.radians(30) + 0.4, abs=1e-4)


def test_steps_jumps_and_the_body_stay_within_the_margin(entered: tuple[Any, Floor]) -> None:
    page, before = entered
    push(page, "left", 0.0, -1.0, pressed=True)
    farthest = away(head_of(at_rest(page)))
    push(page, "left", 0.0, 0.0)
    half = HEADSETS["quest3"] / 2
    assert 0.9 * LIMIT < farthest < LIMIT - half
    # Upwards at 40° it would lead some seven metres farther.
    point(page, "right", (0.2, 1.2, -0.2), about((1, 0, 0), 0.7))
    frames(page, 3)
    squeeze(page, "right", 1)
    frames(page, 3)
    squeeze(page, "right", 0)
    floor = at_rest(page)
    place, aside = head_of(floor), floor.eye(HEAD, STRAIGHT, half)[0]
    assert 0.95 * LIMIT < away(place) < LIMIT
    assert away(aside) <= LIMIT
    # A body that walks out moves the floor along.
    for metres in (2.0, 6.0, 9.0):
        head: Vector = (HEAD[0], HEAD[1], HEAD[2] - metres)
        look(page, head, STRAIGHT)
        frames(page, 3)
        floor = floor_of(page, CENTER)
        for aside_by in (-half, half):
            assert away(floor.eye(head, STRAIGHT, aside_by)[0]) <= LIMIT
    assert not np.allclose(floor.position, before.position, atol=1)
    # A step back takes effect at once.
    back: Vector = (head[0], head[1], head[2] + 0.5)
    look(page, back, STRAIGHT)
    frames(page, 3)
    assert np.allclose(floor_of(page, CENTER).position, floor.position, atol=1e-9)


@pytest.mark.parametrize(("kind", "hand"), [("controllers", "left"), ("hands", "right")])
def test_a_jump_lands_at_its_target(entered: tuple[Any, Floor], kind: str, hand: str) -> None:
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
    # The ring lies on the floor where the arc comes down.
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
    """A point of the headset's space relative to the floor's origin, in world directions."""
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


DRAWN = """() => { const found = { joints: 0, bodies: 0 };
  window.nearfar.viewer.rig.traverse((one) => {
    if (!one.visible) return;
    if (one.isInstancedMesh) found.joints += one.count;
    else if (one.geometry?.type === 'CapsuleGeometry') found.bodies += 1;
  });
  return found; }"""


def test_hands_system_menus_and_new_origins_are_handled(entered: tuple[Any, Floor]) -> None:
    page, before = entered
    assert page.evaluate(DRAWN) == {"joints": 0, "bodies": 2}
    page.evaluate("() => { window.emulated.device.primaryInputMode = 'hand'; }")
    frames(page, 3)
    assert page.evaluate(DRAWN) == {"joints": 50, "bodies": 0}
    # A system menu hides the hands.
    page.evaluate("() => { window.emulated.device.primaryInputMode = 'controller'; }")
    page.evaluate("() => window.emulated.device.updateVisibilityState('visible-blurred')")
    push(page, "left", 0.0, -1.0)
    frames(page, 5)
    assert np.allclose(floor_of(page, CENTER).position, before.position)
    push(page, "left", 0.0, 0.0)
    page.evaluate("() => window.emulated.device.updateVisibilityState('visible')")
    frames(page, 4)
    # Recentring keeps the head's position.
    place = head_of(before)
    page.evaluate("() => window.emulated.device.recenter()")
    frames(page, 4)
    found = page.evaluate(
        "() => window.nearfar.viewer.camera.getWorldPosition(window.nearfar.viewer.rig.position.clone()).toArray()"
    )
    assert np.hypot(*(np.add(found, CENTER) - place)[[0, 2]]) < 0.05


def test_leaving_the_headset_keeps_the_heads_pose(page: Any) -> None:
    look(page, (0.5, 1.2, -0.5), STRAIGHT)
    floor = at_rest(page)
    place = head_of(floor, (0.5, 1.2, -0.5))
    page.evaluate("() => document.querySelector('.tool-main').click()")
    presents = "() => window.nearfar.viewer.renderer.xr.isPresenting"
    wait_until(page, lambda: not page.evaluate(presents))
    expected = (place[0], floor.position[1] + 1.7, place[2])
    wait_until(page, lambda: np.allclose(floor_of(page, CENTER).position, expected, atol=1e-4))
    assert floor_of(page, CENTER).yaw == 0
    # The headset then begins where the screen stopped.
    look(page, FIRST, STRAIGHT)
    enter(page)
    wait_until(page, lambda: page.evaluate(presents))
    frames(page, 3)
    again = floor_of(page, CENTER)
    assert np.allclose(again.position, (place[0], floor.position[1], place[2]), atol=1e-4)
    assert again.yaw == pytest.approx(floor.yaw)
