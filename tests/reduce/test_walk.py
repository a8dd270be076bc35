"""Tests of the pictures of a walk: the right region, cross-fades and cuts, waiting, and no folds on the path."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from tests.support.impostor_cases import CENTER, misplaced, view as impostor_view, yard
from tests.support.reduce_cases import FOV, Array, place, street

SMALL: dict[str, Any] = {"face_size": 32, "samples": 1, "backend": "cpu"}
START, END = np.array([-20.0, 1.7, 5.0]), np.array([30.0, 1.7, 5.0])
SIZE = (48, 27)


@pytest.fixture(scope="module")
def scene() -> nf.Scene:
    return street()


@pytest.fixture(scope="module")
def regions(scene: nf.Scene) -> nf.Regions:
    return nf.regions(scene, [START, END], r2=50.0, keep=10, **SMALL)


def view(position: Array, toward: tuple[float, float, float] = (0.4, -0.05, 1.0)) -> nf.Camera:
    return nf.Camera.look_at(position, position + np.array(toward), fov=FOV, size=SIZE)


def on_the_way(metres: float) -> Array:
    return np.asarray(START + (END - START) * (metres / np.linalg.norm(END - START)))


def render_region(regions: nf.Regions, number: int, camera: nf.Camera, **options: Any) -> nf.Frame:
    return regions.reduced(number).render(camera, **options)


def until_change(regions: nf.Regions, walk: nf.Walk, step: float = 0.5) -> tuple[float, nf.Frame]:
    """Walk at 1 m/s until the first picture of another region; returns the seconds and that picture."""
    seconds, first = 0.0, walk.render(view(START), 0.0).stats["region"]
    while True:
        seconds += step
        frame = walk.render(view(on_the_way(seconds)), seconds)
        if frame.stats["region"] != first:
            return seconds, frame


def test_a_cut_shows_the_users_region(regions: nf.Regions) -> None:
    walk = regions.walk(transition="cut")
    current: int | None = None
    assert walk.region is None
    changes = []
    for seconds in range(0, 45, 2):
        position = on_the_way(seconds)
        before, current = current, regions.index(position, current)
        frame = walk.render(view(position), seconds)
        np.testing.assert_array_equal(frame.color, render_region(regions, current, view(position)).color)
        assert [frame.stats["region"], frame.stats["fade"], walk.region] == [current, 1.0, current]
        if before is None or before == current:
            assert frame.stats["jump"] == 0.0
        else:
            changes.append(frame.stats["jump"])
            assert changes[-1] == regions.jump(before, current, view(position))
    assert len(changes) >= 3
    assert min(changes) > 1.0


def test_a_fade_blends_both_regions_pictures(regions: nf.Regions) -> None:
    walk = regions.walk(fade=2.0)
    seconds, frame = until_change(regions, walk)
    old, new = 0, frame.stats["region"]
    for later, share in ((0.0, 0.0), (0.5, 0.25), (1.5, 0.75), (2.0, 1.0), (2.5, 1.0)):
        camera = view(on_the_way(seconds + later))
        frame = walk.render(camera, seconds + later)
        one, two = (render_region(regions, number, camera).require("color") for number in (old, new))
        np.testing.assert_allclose(frame.require("color"), (1.0 - share) * one + share * two, atol=1e-6)
        assert (frame.stats["region"], frame.stats["fade"]) == (new, share)
        assert frame.stats["jump"] == (regions.jump(old, new, camera) if share < 1.0 else 0.0)
        # Statistics of the newer picture are kept besides those of the walk.
        assert frame.stats["tolerance_held"] == render_region(regions, new, camera).stats["tolerance_held"]
    np.testing.assert_array_equal(frame.color, render_region(regions, new, camera).color)


def test_other_channels_come_from_the_newer_region(scene: nf.Scene) -> None:
    regions = nf.regions(scene, [START, END], r2=50.0, **{**SMALL, "channels": ("color", "range")})
    walk = regions.walk(fade=10.0)
    seconds, frame = until_change(regions, walk)
    new, camera = frame.stats["region"], view(on_the_way(seconds + 1.0))
    frame = walk.render(camera, seconds + 1.0, channels=("range", "color"), samples=2, method="exact")
    both = [render_region(regions, n, camera, channels=("color", "range"), samples=2, method="exact") for n in (0, new)]
    np.testing.assert_array_equal(frame.range, both[1].range)
    np.testing.assert_allclose(
        frame.require("color"), 0.9 * both[0].require("color") + 0.1 * both[1].require("color"), atol=1e-6
    )
    frame = walk.render(camera, seconds + 1.0, channels=("range",))
    assert frame.channels == ("range",)
    np.testing.assert_array_equal(frame.range, render_region(regions, new, camera, channels=("range",)).range)


def test_a_fade_of_zero_duration_is_a_cut(regions: nf.Regions) -> None:
    walks = [regions.walk(fade=0.0), regions.walk(transition="cut")]
    for seconds in range(0, 40, 2):
        frames = [walk.render(view(on_the_way(seconds)), seconds) for walk in walks]
        np.testing.assert_array_equal(frames[0].color, frames[1].color)
        assert {**frames[0].stats, "waited": 0} == {**frames[1].stats, "waited": 0}


@pytest.mark.slow
def test_no_picture_folds_during_fades_beyond_the_reach(scene: nf.Scene) -> None:
    """With the least r2 for the reach, a region's picture folds at the region's end: its fade has to end there."""
    regions = nf.regions(scene, [START, END], r2=16.5, hysteresis=0.5, **SMALL)
    walk, radii = regions.walk(fade=4.0), regions.radii
    ended_early = 0
    started = -math.inf
    for seconds in np.arange(0.0, 14.0, 0.5).tolist():
        position = on_the_way(1.6 * seconds)
        before = walk.region
        frame = walk.render(view(position), seconds)
        started = seconds if before not in (None, frame.stats["region"]) else started
        margin = nf.fold_margin(position, center=regions.centers[frame.stats["region"]], r1=radii.r1, r2=radii.r2)
        assert 0.0 < frame.stats["fold_margin"] <= margin + 1e-3
        ended_early += seconds - started < 4.0 and frame.stats["fade"] == 1.0
    assert ended_early > 0


def test_a_walk_waits_only_for_unfinished_regions(scene: nf.Scene) -> None:
    alone = nf.regions(scene, [START, END], r2=50.0, **SMALL)
    walk = alone.walk(ahead=False)
    assert walk.render(view(START), 0.0).stats["waited"] > 0.0
    assert walk.render(view(on_the_way(1.0)), 1.0).stats["waited"] == 0.0
    assert not alone.ready(1)
    _, frame = until_change(alone, alone.walk(ahead=False))
    assert frame.stats["waited"] > 0.0
    _, frame = until_change(alone, alone.walk(ahead=False))
    assert frame.stats["waited"] == 0.0


def test_the_next_region_is_started_ahead(monkeypatch: pytest.MonkeyPatch, regions: nf.Regions) -> None:
    asked: list[tuple[tuple[float, float, float], tuple[float, float, float], int]] = []
    monkeypatch.setattr(regions, "prefetch", lambda *arguments: asked.append(arguments))
    walk = regions.walk()
    for seconds in (0.0, 0.5, 0.5, 1.5):
        walk.render(view(on_the_way(2.0 * seconds)), seconds)
    velocities = [velocity for _, velocity, _ in asked]
    np.testing.assert_allclose(velocities, [(0, 0, 0), (2, 0, 0), (2, 0, 0), (2, 0, 0)])
    assert [tuple(position) for position, _, _ in asked] == [tuple(on_the_way(x)) for x in (0.0, 1.0, 1.0, 3.0)]
    assert {number for *_, number in asked} == {0}
    # Nearly equal times give no information on the velocity.
    walk.render(view(on_the_way(9.0)), np.nextafter(1.5, 2.0) * (1 + 1e-300))
    assert np.isfinite(asked[-1][1]).all()
    regions.walk(ahead=False).render(view(START), 0.0)
    assert len(asked) == 5


def test_both_eyes_at_one_time_use_one_region(regions: nf.Regions) -> None:
    walk = regions.walk(fade=1.0)
    for seconds in np.arange(0.0, 20.0, 0.5):
        head = on_the_way(seconds)
        eyes = [np.add(head, [x, 0.0, 0.0]) for x in (-0.03, 0.03)]
        left, right = (walk.render(view(eye), float(seconds), user=head) for eye in eyes)
        assert (left.stats["region"], left.stats["fade"]) == (right.stats["region"], right.stats["fade"])
        if left.stats["fade"] == 1.0:
            afresh = render_region(regions, left.stats["region"], view(eyes[0]), user=head)
            np.testing.assert_array_equal(left.color, afresh.color)


def test_moving_objects_are_posed_in_all_regions() -> None:
    scene = street(dynamic=True)
    regions = nf.regions(scene, [START, END], r2=50.0, **SMALL)
    walk = regions.walk(transition="cut")
    for seconds in (0.0, 12.0):
        position, pose = on_the_way(seconds), {"car": place(*np.add(on_the_way(seconds), [2.0, -0.95, 9.0]))}
        frame = walk.render(view(position), seconds, at=pose)
        without = walk.render(view(position), seconds)
        assert (frame.require("color") != without.require("color")).any(axis=-1).mean() > 0.01
        np.testing.assert_array_equal(
            frame.color, render_region(regions, frame.stats["region"], view(position), at=pose).color
        )


def test_the_measured_jump_of_a_far_tower_equals_the_prediction(scene: nf.Scene) -> None:
    settings: dict[str, Any] = {"face_size": 512, "samples": 1, "channels": ("color", "object_id"), "backend": "cpu"}
    regions = nf.regions(scene, [START, END], r2=50.0, **settings)
    tower = scene.object_names.index("tower")
    position = 0.5 * (regions.centers[0] + regions.centers[1])
    target = np.array([110.0, 20.0, 70.0])
    camera = nf.Camera.look_at(position, target, fov=nf.Fov.symmetric(60, 16 / 9), size=(480, 270))
    middles = []
    for number in (0, 1):
        seen = render_region(regions, number, camera, channels=("object_id",)).require("object_id") == tower
        rows = seen[:, :].any(axis=1)
        # Rows that the tower fills from side to side, without its top and its foot.
        middles.append(np.mean([np.flatnonzero(row).mean() for row in seen[rows][20:-20]]))
    predicted = regions.jump(0, 1, camera, float(np.linalg.norm(target - regions.centers[0])))
    assert predicted > 15.0
    assert abs(middles[1] - middles[0]) == pytest.approx(predicted, rel=0.1)


def test_a_walk_starts_without_a_region(regions: nf.Regions) -> None:
    assert "region None" in repr(regions.walk())


def test_impostors_of_neighbouring_regions_show_the_same_picture_within_their_error() -> None:
    scene = yard()
    start, end = np.add(CENTER, (-2.5, 0.0, 0.0)), np.add(CENTER, (2.5, 0.6, 0.0))
    baking = nf.ImpostorSettings(face_size=128, centers=7)
    regions = nf.regions(scene, [start, end], far="impostors", reach=2.0, hysteresis=0.2, r2=12.0, settings=baking)
    assert len(regions) >= 2
    camera = impostor_view(0.5 * (regions.centers[0] + regions.centers[1]), 0.7)
    pictures = [nf.render(regions.reduced(n), camera, samples=4, channels=("color",)) for n in (0, 1)]
    truth = nf.render(scene, camera, samples=4, channels=("color",))
    maps = nf.regions(scene, [start, end], reach=2.0, hysteresis=0.2, r2=12.0, morph="none", face_size=128)
    mapped = [nf.render(maps.reduced(n), camera, samples=4, channels=("color",)) for n in (0, 1)]
    assert nf.psnr(*pictures) > nf.psnr(*mapped) + 6.0
    # The second region uses quads of the first one, also if nobody was there.
    alone: Any = nf.regions(scene, [start, end], far="impostors", reach=2.0, hysteresis=0.2, r2=12.0, settings=baking)
    shared: Any = regions.reduced(1)
    assert 0 < shared.stats["shared_quads"] < shared.stats["quads"]
    for name in ("vertices", "faces", "atlas"):
        np.testing.assert_array_equal(getattr(shared._quads, name), getattr(alone.reduced(1)._quads, name))
    assert (alone.bytes[[0, 1]] > 0).all()
    limited = nf.ImpostorSettings(face_size=128, centers=7, triangles=shared.triangle_count)
    cut: Any = nf.regions(
        scene, [start, end], far="impostors", reach=2.0, hysteresis=0.2, r2=12.0, settings=limited
    ).reduced(1)
    assert cut.stats["shared_quads"] == cut.stats["dropped_quads"] == 0
    # Both regions are within two pixels of 1/20 degree of the truth.
    assert isinstance(camera.fov, nf.Fov)
    focal = camera.width / (camera.fov.right - camera.fov.left)
    assert regions.jump(0, 1, camera) == pytest.approx(2 * 2 * focal * np.radians(1 / 20), rel=1e-4)
    assert misplaced(truth, pictures[0], 2) + misplaced(truth, pictures[1], 2) < 0.01
    walk = regions.walk(fade=1.0)
    stats = [walk.render(impostor_view(start + share * (end - start)), 9.0 * share).stats for share in (0.0, 0.5, 1.0)]
    assert all(entry["fold_margin"] == math.inf for entry in stats)
    assert stats[-1]["region"] != stats[0]["region"]
    assert (regions.bytes[[0, 1]] > 0).all()
    # The path climbs, so that the sphere of the region is larger than its circle on the ground.
    reduced: Any = regions.reduced(0)
    assert 2.0 < reduced.reach < 2.2
    for wrong in ({"morph": "none"}, {"samples": 4}):
        with pytest.raises((ValueError, TypeError), match=next(iter(wrong))):
            nf.regions(scene, [start, end], far="impostors", **wrong)
