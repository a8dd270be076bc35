"""Tests of flights: pictures of loaded parts, and background reading."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar._camera.shot import Shot
from nearfar.orthoview._cut import GEOMETRY, RECORD
from tests.support.flight_cases import CHANNELS, LONG, Gate, camera_at, images_of, is_same, readers, there, whole
from tests.support.waiting import wait_until

Tree = nf.orthoview.OrthoTree


@pytest.fixture
def flight(few_tree: Tree) -> Iterator[nf.orthoview.Flight]:
    with nf.orthoview.open(few_tree.path).fly() as flight:
        yield flight


@pytest.mark.parametrize(
    "settings", [{}, {"geometry": False}, {"views": 1, "error_px": 2.5}, {"views": 1, "lift_deg": 50.0}]
)
def test_after_a_wait_pictures_equal_the_tree(few_tree: Tree, settings: dict[str, Any]) -> None:
    """From near and far, after any earlier pictures."""
    leaves = 0
    with few_tree.fly(**settings, adapt=False) as flight:
        places = [(25, 0.3), (500, 4.0), (40, 0.4)]
        for number, (distance, angle) in enumerate(places):
            camera = camera_at(few_tree, distance, angle)
            frame = whole(flight, lambda: flight.render(camera, time=number, channels=CHANNELS))  # noqa: B023
            right = few_tree.render(camera, **settings, channels=CHANNELS)
            assert is_same(frame, right)
            counts = {"missing": 0, "empty": 0, "error_px": settings.get("error_px", 1.0)}
            assert frame.stats == {**right.stats, **counts}
            assert there(frame).any()
            leaves += frame.stats["leaves"]
        assert flight.errors == ()
        assert flight.bytes_read > 0
        np.testing.assert_array_equal(flight.origin, few_tree.origin)
    assert (leaves > 0) == settings.get("geometry", True)


def test_all_render_functions_accept_flights(few_tree: Tree, flight: nf.orthoview.Flight) -> None:
    camera = camera_at(few_tree, 90)
    assert (flight.default_channels, flight.backends) == (few_tree.default_channels, few_tree.backends)
    assert is_same(whole(flight, lambda: nf.render(flight, camera)), few_tree.render(camera))
    cameras = [camera, camera_at(few_tree, 91)]
    for frame, own in zip(whole(flight, lambda: list(nf.render_path(flight, cameras))), cameras, strict=True):
        assert there(frame).sum() > 0.95 * there(few_tree.render(own)).sum()
    samples = flight.render(camera_at(few_tree, 91), samples=4)
    assert is_same(samples, few_tree.render(camera_at(few_tree, 91), samples=4))


def test_parts_of_both_eyes_are_read(few_tree: Tree) -> None:
    """Their pictures extend to opposite sides beyond the first one's margin."""
    hmd, camera = nf.hmd.QUEST_2, camera_at(few_tree, 60)
    eyes: dict[str, Any] = {"orientation": camera.orientation, "size": (48, 48)}
    wide = hmd.with_ipd(0.08)
    right = nf.render_eyes(few_tree, wide, camera.position, **eyes)
    with few_tree.fly(margin_deg=0.0) as flight:
        found = whole(flight, lambda: nf.render_eyes(flight, wide, camera.position, **eyes))
        for one, other in ((found.left, right.left), (found.right, right.right)):
            assert one.stats["missing"] == 0
            assert is_same(one, other)


def test_hybrid_stereo_accepts_flights(few_tree: Tree, flight: nf.orthoview.Flight) -> None:
    camera, hmd = camera_at(few_tree, 90), nf.hmd.QUEST_2
    rig = nf.stereo.HybridRig.of(hmd, mono_plane=60.0, size=(48, 48))
    right = rig.render(few_tree, camera.position, camera.orientation)
    for _ in range(4):
        found = whole(flight, lambda: rig.render(flight, camera.position, camera.orientation))
    for one, other in ((found.left, right.left), (found.right, right.right)):
        assert is_same(one, other)


def test_the_first_picture_is_empty(few_tree: Tree, flight: nf.orthoview.Flight, gate: Gate) -> None:
    gate.close()
    camera = camera_at(few_tree, 60)
    channels = ("color", "coverage", "range")
    for _ in range(3):
        frame = flight.render(camera, channels=channels)
        assert not there(frame).any()
        assert frame.require("coverage").max() == 0
        # Subtrees that are not read yet are missing, too; the cells above them are drawn instead.
        assert 0 < frame.stats["empty"] <= frame.stats["missing"]
        assert not flight.wait(0.0)
    sky = few_tree.render(camera, t_max=0.1, channels=channels)
    assert not there(sky).any()
    np.testing.assert_array_equal(frame.require("color"), sky.require("color"))
    gate.open()
    assert is_same(whole(flight, lambda: flight.render(camera)), few_tree.render(camera))


def test_pictures_have_no_holes_while_views_arrive(tree: Tree, gate: Gate) -> None:
    """Once the coarsest views are loaded, each pixel that they and the tree cover is covered."""
    gate.close()
    camera = camera_at(tree, 75)
    right = tree.render(camera)
    both = there(tree.render(camera, error_px=1e30, geometry=False)) & there(right)
    assert both.sum() > 100
    with tree.fly(threads=1, prefetch=False) as flight:
        wait_until(lambda: flight.render(camera).stats["missing"] > 20)
        missing = []
        coarsest = flight._pilot._coarsest
        while flight.waiting:
            gate.pass_some(min(12, flight.waiting))
            frame = flight.render(camera)
            if set(coarsest) <= set(gate.views):
                assert set(gate.views[: len(coarsest)]) == set(coarsest)
                missing.append(frame.stats["missing"])
                assert frame.stats["empty"] == 0
                assert (both & ~there(frame)).sum() <= 0.01 * both.sum()
        assert missing == sorted(missing, reverse=True)
        assert missing[0] > 20
        assert missing[-1] == 0
        assert is_same(frame, right)


def test_pictures_keep_parts_until_replacements_arrive(tree: Tree, gate: Gate) -> None:
    """Cells are wanted from another direction or level while nothing is read; forward and back."""
    camera = camera_at(tree, 60)
    with nf.orthoview.open(tree.path).fly() as flight:
        first = whole(flight, lambda: flight.render(camera, time=0.0, channels=CHANNELS))
        held = flight._previous[0].parts()
        gate.close()
        for time, (distance, angle) in enumerate([(60, 0.9), (75, 0.3), (90, 0.3), (200, 0.3)], 1):
            moved = camera_at(tree, distance, angle)
            frame = flight.render(moved, time=time, channels=CHANNELS)
            right = tree.render(moved, channels=CHANNELS)
            assert frame.stats["missing"] > 0 == frame.stats["empty"]
            assert len(flight._previous[0].parts() & held) > len(held) / 4
            assert (there(right) & ~there(frame)).sum() <= 0.08 * there(right).sum()
            both = there(right) & there(frame)
            off = np.abs(frame.require("range")[both] - right.require("range")[both])
            assert np.median(off) < tree.cell / 2
        assert is_same(flight.render(camera, time=9.0, channels=CHANNELS), first)
        gate.open()


def test_each_part_of_a_flight_is_read_once(few_tree: Tree, flight: nf.orthoview.Flight, gate: Gate) -> None:
    for time, distance in enumerate([60, 90, 60, 30]):
        whole(flight, lambda: flight.render(camera_at(few_tree, distance), time=100.0 * time))  # noqa: B023
    assert len(set(gate.views)) == len(gate.views) > 100
    assert len(set(gate.leaves)) == len(gate.leaves) > 0
    read = flight.bytes_read
    flight.render(camera_at(few_tree, 60), time=900.0)
    assert flight.wait(LONG)
    assert flight.bytes_read == read


def test_looks_read_the_parts_of_pictures(few_tree: Tree, flight: nf.orthoview.Flight, gate: Gate) -> None:
    camera = camera_at(few_tree, 60)
    flight.look(camera)
    assert flight.wait(LONG)
    gate.close()
    assert is_same(flight.render(camera), few_tree.render(camera))
    cut = few_tree.cut(camera)
    assert set(cut.keys(in_picture=True)) <= set(gate.views)
    with few_tree.fly(prefetch=False) as bare:
        bare.look(camera)
        before = len(gate.views)
        gate.open()
        assert bare.wait(LONG)
        read = gate.views[before:]
        coarsest = few_tree.cut(camera, error_px=1e30, geometry=False, around=True).keys()
        beside = set(read) - set(cut.keys(in_picture=True))
        assert len(beside) <= len(coarsest)
        assert set(cut.keys(in_picture=True)) <= set(read)
        assert set(gate.leaves) >= set(cut.leaf_places(in_picture=True))


def test_memory_keeps_needed_views_and_little_else(few_tree: Tree) -> None:
    """The first picture needs more than the cache has, the others less."""
    cache_bytes = 90_000
    with nf.orthoview.open(few_tree.path, cache_bytes=cache_bytes).fly(adapt=False, error_px=2) as flight:
        views, sizes = flight._viewer.views.cache, []
        for time, angle in enumerate([0.0, 1.5, 3.0]):
            camera = camera_at(few_tree, 60, angle)
            whole(flight, lambda: flight.render(camera, time=time))  # noqa: B023
            assert flight.wait(LONG)
            flight.render(camera, time=time + 0.3)
            plan = flight._pilot.plan(flight._has)
            needed = {part for part in plan.order if part[2] not in (GEOMETRY, RECORD)}
            assert needed <= set(views.values)
            sizes.append(sum(layer.bytes for key in needed for layer in views.values[key]))
            assert views.size == sum(layer.bytes for layers in views.values.values() for layer in layers)
            assert views.size <= max(cache_bytes, sizes[-1])
        assert min(sizes) < cache_bytes < max(sizes)
        assert views.reads > len(views.values), "views are dropped"


def test_only_needed_leaves_exceed_the_cache(tree: Tree, gate: Gate) -> None:
    with nf.orthoview.open(tree.path, cache_bytes=1).fly(adapt=False) as flight:
        for time, angle in enumerate([0.0, 3.0, 0.0]):
            camera = camera_at(tree, 25, angle)
            frame = whole(flight, lambda: flight.render(camera, time=100.0 * time))  # noqa: B023
            assert frame.stats["leaves"] > 3
            assert is_same(frame, tree.render(camera))
            near = {place for _, place, direction in flight._pilot.plan(flight._has).order if direction == GEOMETRY}
            assert near <= set(flight._viewer.near.cache.values)
            assert near >= {leaf for leaf, scene in flight._viewer.near.cache.values.items() if scene is not None}
            count = len(gate.leaves)
            flight.render(camera, time=100.0 * time + 50)
            assert flight.wait(LONG)
            assert len(gate.leaves) == count
        assert len(set(gate.leaves)) < len(gate.leaves)


def test_pictures_become_finer_when_the_viewer_stops(few_tree: Tree, flight: nf.orthoview.Flight) -> None:
    """Above the speed limit of the link, pictures are coarser; at rest they have the requested detail."""
    flight._pilot.meter.note(1.0, flight._received(), had_requests=True)
    for step in range(30):
        camera = camera_at(few_tree, 120 - 2 * step)
        frame = flight.render(camera, time=2 + step / 100)
        flight.wait(LONG)
        flight._pilot.meter._bytes = 10.0 * flight._pilot.meter._weight
    assert frame.stats["error_px"] > 1
    assert 0 < flight.speed_limit < 200
    assert is_same(frame, few_tree.render(camera, error_px=frame.stats["error_px"]))
    flight.render(camera, time=100.0)
    frame = whole(flight, lambda: flight.render(camera, time=101.0))
    assert is_same(frame, few_tree.render(camera))
    assert frame.stats["error_px"] == 1


def test_reader_threads_end_with_the_flight(few_tree: Tree) -> None:
    camera, others = camera_at(few_tree, 60), readers()
    with few_tree.fly(threads=3) as flight:
        assert not readers() - others
        first = whole(flight, lambda: flight.render(camera))
        assert len(readers() - others) == 3
    assert not readers() - others
    assert is_same(flight.render(camera), first)
    flight.render(camera_at(few_tree, 200, 4.0))
    assert flight.waiting == 0
    assert not flight.wait(LONG)
    flight.close()


def test_flights_apply_limits_and_masks(few_tree: Tree, flight: nf.orthoview.Flight) -> None:
    camera = camera_at(few_tree, 60)
    mask = np.random.default_rng(0).random((48, 64)) < 0.5
    shot = Shot(cameras=(camera,), channels=("color", "range"), mask=mask, t_max=70.0)
    (masked,) = whole(flight, lambda: flight.trace(shot))
    (right,) = few_tree.trace(shot)
    for name in ("color", "range"):
        np.testing.assert_array_equal(masked[name], right[name])
    assert images_of(flight.render(camera)).keys() == {"color", "range"}
