"""Growth of rings: closed forms against the speed of points in the picture, the manifest, and cross-fades."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from tests.support import valid

RADII = (10.0, 14.0, 22.0, 32.0)
CENTER = np.array([3.0, 1.7, -2.0])
STEP = 1.0 / 72.0


def directions(growth: nf.stream.Growth, ring: int, time: float, points: Any, user: Any) -> Any:
    """Displayed directions of points for a ring's morph at a time, as unit vectors from the user."""
    radius = growth.radius(ring, time)
    place: dict[str, Any] = {
        "r1": 0.7 * radius,
        "r2": radius,
        "kind": "cylinder",
        "strength": growth.strength(ring, time),
    }
    shown = nf.morph(points, user=user, center=CENTER, **place) - user
    return shown / np.linalg.norm(shown, axis=1, keepdims=True)


def ring_of_points(rho: float) -> Any:
    """Points at the eye's height, at one distance from the axis."""
    turn = np.linspace(0.0, 2.0 * np.pi, 361)
    return CENTER + rho * np.stack([np.cos(turn), 0.0 * turn, np.sin(turn)], axis=1)


@pytest.mark.parametrize("ring", [2, 3, 4])
@pytest.mark.parametrize("reach", [0.5, 1.0])
def test_a_growing_radius_rotates_points_at_its_speed(ring: int, reach: float) -> None:
    growth = nf.stream.Growth(RADII, speed=0.6, reach=reach)
    user = CENTER + np.array([reach, 0.0, 0.0])
    seconds = growth.seconds(ring)
    speeds = []
    for time in np.linspace(growth.fade, seconds - STEP, 7):
        # Half way between the radii, where the weight falls.
        points = ring_of_points(0.85 * growth.radius(ring, time + STEP / 2))
        one, next_one = (directions(growth, ring, at, points, user) for at in (time, time + STEP))
        speeds.append(np.degrees(np.linalg.norm(next_one - one, axis=1)).max() / STEP)
    # The formula is for a user much nearer than the points: 1 m against at least 8.5 m.
    np.testing.assert_allclose(speeds, 0.6, rtol=0.16)
    assert max(speeds) / min(speeds) < 1.2


def test_the_first_ring_rotates_points_at_seven_tenths_of_its_radius_at_the_speed() -> None:
    growth = nf.stream.Growth(RADII, speed=0.6)
    user, points = CENTER + np.array([1.0, 0.0, 0.0]), ring_of_points(7.0)
    times = np.linspace(growth.fade, growth.seconds(1), 50)
    shown = np.array([directions(growth, 1, time, points, user) for time in times])
    speeds = np.degrees(np.linalg.norm(np.diff(shown, axis=0), axis=-1)) / np.diff(times)[:, None]
    # The speed of each point is constant; from U the nearest points are only 6 m away.
    assert speeds.max() == pytest.approx(0.6, rel=0.2)
    assert (speeds.max(axis=0) <= 1.2 * speeds.min(axis=0) + 1e-6).all()
    assert {growth.radius(1, time) for time in times} == {10.0}


def test_growth_begins_at_the_previous_radius_and_ends_at_its_own() -> None:
    growth = nf.stream.Growth(RADII, fade=0.25)
    assert growth.radii == RADII
    assert (growth.seconds(0), growth.radius(0, 9.0), growth.strength(0, 9.0)) == (0.0, 0.0, 1.0)
    for ring in (1, 2, 3, 4):
        end = growth.seconds(ring)
        times = np.linspace(0.0, end, 101)
        grown = [growth.radius(ring, time) * growth.strength(ring, time) for time in times]
        assert (np.diff(grown) >= 0).all()
        assert grown[0] == growth.radius(ring, 0.25) * growth.strength(ring, 0.25)
        assert grown[0] == (0.0 if ring == 1 else pytest.approx(RADII[ring - 2], rel=1e-12))
        assert grown[-1] == pytest.approx(RADII[ring - 1], rel=1e-12)
        assert growth.radius(ring, end + 1.0) == RADII[ring - 1]
        assert growth.strength(ring, end + 1.0) == 1.0
    assert [growth.share(time) for time in (0.0, 0.125, 0.25, 9.0)] == [0.0, 0.5, 1.0, 1.0]
    assert nf.stream.Growth(RADII, fade=0.0).share(0.0) == 1.0


def test_speeds_are_proportional() -> None:
    slow, fast = nf.stream.Growth(RADII, speed=0.5, fade=0.0), nf.stream.Growth(RADII, speed=2.0, fade=0.0)
    far = nf.stream.Growth(RADII, speed=0.5, reach=2.0, fade=0.0)
    for ring in (1, 2, 3, 4):
        assert slow.seconds(ring) == pytest.approx(4.0 * fast.seconds(ring))
        assert far.seconds(ring) == pytest.approx(2.0 * slow.seconds(ring))
    assert slow.pixels(320.0) == pytest.approx(math.radians(0.5) * 320.0)


def test_a_bundle_states_its_growth(tmp_path: Path) -> None:
    scene = nf.datasets.city(blocks=1, detail=0)
    given: dict[str, Any] = {"center": CENTER, "radii": RADII[:2], "face_size": 64, "samples": 1}
    bundle = nf.stream.export(scene, tmp_path / "city", **given)
    assert bundle.growth == nf.stream.Growth(RADII[:2])
    path = tmp_path / "city" / "manifest.json"
    document = json.loads(path.read_text())
    assert document["growth"] == {"first": "strength", "speed": 0.7, "reach": 1.0, "fade": 0.5}
    assert valid(document, "bundle")
    slow = nf.stream.export(scene, tmp_path / "slow", speed=0.1, **given)
    assert slow.growth == nf.stream.Growth(RADII[:2], speed=0.1)
    for damage in ({"speed": 0.0}, {"first": "radius"}, {"fade": None}, {"reach": "far"}):
        path.write_text(json.dumps({**document, "growth": {**document["growth"], **damage}}))
        with pytest.raises(nf.FormatError, match=r"manifest\.json"):
            nf.stream.open(tmp_path / "city")


def frame(value: float, size: tuple[int, int] = (4, 3), **images: Any) -> nf.Frame:
    color = np.full((size[1], size[0], 3), value, np.float32)
    return nf.Frame(nf.Camera((0, 0, 0), fov=nf.Fov.symmetric(90, 1), size=size), color=color, **images)


def test_pictures_are_mixed_by_weight() -> None:
    marks = np.full((3, 4), 7, np.int32)
    old, new = frame(0.2), frame(0.6, object_id=marks)
    for share, expected in ((0.0, 0.2), (0.25, 0.3), (1.0, 0.6)):
        mixed = nf.stream.blend(old, new, share)
        np.testing.assert_allclose(mixed.require("color"), expected, rtol=1e-6)
        np.testing.assert_array_equal(mixed.require("object_id"), marks)


def test_pictures_that_do_not_match_are_refused() -> None:
    with pytest.raises(ValueError, match="new: expected a frame of the old one's shape"):
        nf.stream.blend(frame(0.2), frame(0.2, (5, 3)), 0.5)
