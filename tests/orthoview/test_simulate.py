"""Tests of flights over a link on a virtual clock."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from types import SimpleNamespace
from typing import Any, cast

import numpy as np
import pytest

import nearfar as nf
from nearfar.orthoview._cut import GEOMETRY, Part
from nearfar.orthoview._pilot import Pilot, Plan, PrefetchSettings
from nearfar.orthoview._requests import FlightRequests, Request
from nearfar.orthoview._simulate import Client, Value, fly_through
from nearfar.stream._transport import Transport
from tests.support import need
from tests.support.flight_cases import FOV, LONG
from tests.support.orthoview_cases import CORNER
from tests.support.range_server import serve_folder

Tree = nf.orthoview.OrthoTree

Link = nf.stream.Link

MIDDLE = CORNER + 40.0
FAST = Link(1e6)
"""A link whose frame carries all parts of a picture."""


def path(count: int, start: Any = (-30, 5, 30), step: Any = (0.5, 0, 0)) -> list[nf.Camera]:
    """A straight path through the world."""
    places = MIDDLE + np.array(start) + np.arange(count)[:, None] * np.array(step)
    return [nf.Camera(tuple(place.tolist()), fov=FOV, size=(64, 48)) for place in places]


def still(count: int) -> list[nf.Camera]:
    return path(count, step=(0, 0, 0))


def sizes(tree: Tree, parts: set[Part]) -> int:
    """Bytes of all requests for some parts, without records."""
    requests = FlightRequests(tree)
    return sum(
        request.bytes for part in sorted(parts) for request in requests.list_requests(part) if not is_record(request)
    )


def is_record(request: Request) -> bool:
    return request.file.startswith("nearfar/")


def flown(tree: Tree, cameras: Sequence[nf.Camera], threads: int, **prefetch: Any) -> list[Request]:
    """Requests of a simulated flight over a fast link; each frame comes when all is read."""
    requests = FlightRequests(tree)
    pilot = Pilot(
        requests.opened.viewer.cutter, nf.orthoview.FlightSettings().cut, PrefetchSettings(adapt=False, **prefetch)
    )

    def plan(camera: nf.Camera, time: float, _received: Any, _busy: bool, is_read: Any) -> Plan:
        pilot.look(camera, time)
        return pilot.plan(is_read)

    client = Client(plan, requests, Transport(FAST, at_once=threads), threads, 1 << 30)
    fly_through(client, cameras, 1.0)
    return client.requested


def same(one: nf.orthoview.FlightLog, other: nf.orthoview.FlightLog) -> bool:
    names = ("time", "missing", "wanted", "error_px", "received")
    return one.asked == other.asked and all(np.array_equal(getattr(one, name), getattr(other, name)) for name in names)


@pytest.mark.parametrize("threads", [1, 16])
def test_flights_over_http_make_the_simulated_requests(few_tree: Tree, threads: int) -> None:
    """Each view is one request, as is each file of a leaf and each record; one thread makes them in the same order."""
    need("fsspec")
    need("aiohttp")
    cameras, folder = path(2, step=(4.0, 0, 0)), Path(few_tree.path)
    simulated = flown(few_tree, [each for camera in cameras for each in [camera] * 4], threads)
    with serve_folder(folder.parent) as server:
        remote = nf.orthoview.open(server.url + folder.name)
        opening = len(server.sent)
        with remote.fly(threads=threads, adapt=False) as flight:
            for number, camera in enumerate(cameras):
                for repeat in range(4):
                    flight.look(camera, 4 * number + repeat)
                    assert flight._loader.wait(LONG)
            read = flight._received()
            records = len(flight._viewer.cutter._known)
        found = [Request(name.removeprefix(f"{folder.name}/"), size) for name, size in server.sent[opening:]]
    assert sorted(found) == sorted(simulated)
    assert threads > 1 or found == simulated
    files = sum(request.file.startswith("geometry/") for request in found)
    # Besides views and leaves' files: a record for each subtree, and the list of records.
    assert len(found) <= read.views + files + records + 1
    assert read.views > 50
    assert files > 10
    assert opening == 1


def test_leaves_are_requested_as_decoding_reads_them(city: Tree, textured: Tree) -> None:
    """Static and moving triangles, and a texture that leaves share."""
    for name, tree in (("moving/", city), ("images/", textured)):
        requests, found = FlightRequests(tree), False
        near = requests.opened.viewer.near
        requests.list_requests((0, (0, 0, 0), -1))  # with the records
        for place in np.ndindex(*tree.cells(0)):
            listed = requests.list_requests((0, place, -1))
            near.load([place])
            near.images.trim((), 0)
            assert listed == requests._files.requests
            found |= any(name in request.file for request in listed)
        assert found


def test_simulated_threads_have_one_request_each(few_tree: Tree) -> None:
    """Without rate limit and handshake, n requests of t threads that begin at once take n/t round trips."""
    link = Link(1e6, rtt_ms=1000.0, handshake=0.0)
    for threads in (1, 4, 64):
        log = nf.orthoview.simulate(few_tree, still(2), link=link, rate=1.0, threads=threads, prefetch=False)
        assert log.requests <= 2 * threads
    settled = nf.orthoview.simulate(few_tree, still(150), link=link, rate=1.0, threads=8, prefetch=False)
    arrivals = np.flatnonzero(np.diff(settled.received))
    assert len(arrivals) >= settled.requests / 8


def test_leaves_wait_for_a_texture_that_another_one_has_requested() -> None:
    """Responses take a second. Two threads want the texture after one; without a cache each reads it."""
    wall = Request("geometry/images/ab.webp", 10)
    first, second = (0, (0, 0, 0), GEOMETRY), (0, (1, 0, 0), GEOMETRY)
    requests = {first: [Request("geometry/a.glb", 1), wall], second: [Request("geometry/b.glb", 2), wall]}
    plan = Plan({(0, part[1]): [part] for part in requests}, list(requests), 1.0)
    link = Link(1e6, rtt_ms=1000.0, handshake=0.0)
    received = {}
    for threads, max_bytes in ((2, 10), (2, 0), (1, 10)):
        reads = SimpleNamespace(near=SimpleNamespace(max_bytes=max_bytes))
        store = SimpleNamespace(
            list_requests=requests.__getitem__, receive=lambda part: None, opened=SimpleNamespace(viewer=reads)
        )
        client = Client(
            lambda *_: plan, cast(FlightRequests, store), Transport(link, at_once=threads), threads, 1 << 30
        )
        received[threads, max_bytes] = fly_through(client, path(5), 0.9).received.tolist()
        assert len(client.requested) == (4 if max_bytes == 0 else 3)
    # Frames come every 1.1 s. One thread needs three responses one after the other.
    assert received == {(2, 10): [0, 0, 13, 13, 13], (2, 0): [0, 0, 11, 23, 23], (1, 10): [0, 0, 11, 13, 13]}


def test_simulations_are_deterministic(few_tree: Tree) -> None:
    cameras = path(20)
    lossy = Link(5.0, rtt_ms=20.0, loss=0.05)
    first, second = (nf.orthoview.simulate(few_tree, cameras, link=lossy, seed=3) for _ in range(2))
    assert same(first, second)
    assert not same(first, nf.orthoview.simulate(few_tree, cameras, link=lossy, seed=4))
    np.testing.assert_allclose(first.time, np.arange(20) / 72)
    slow = nf.orthoview.simulate(few_tree, cameras, link=lossy, seed=3, rate=10)
    np.testing.assert_allclose(slow.time, np.arange(20) / 10)


def test_frames_count_the_parts_of_their_cuts(few_tree: Tree) -> None:
    """The first frame lacks all parts; at rest everything arrives, and nothing is missing afterwards."""
    cameras = still(60)
    log = nf.orthoview.simulate(few_tree, cameras, link=Link(20.0), views=2)
    cut = few_tree.cut(cameras[0], views=2)
    leaves = cut.leaf_places(in_picture=True)
    # Files of guests count for each leaf that has them.
    files = sum(len(few_tree._viewer.cutter.with_guests([leaf])) for leaf in leaves)
    # At first only the record of the root is wanted.
    assert log.missing[0] == log.wanted[0] == 1
    assert log.wanted[-1] == len(cut.keys(in_picture=True)) + files >= log.missing.max()
    assert (np.diff(log.missing[log.missing.argmax() :]) <= 0).all()
    assert log.missing[-1] == 0
    np.testing.assert_array_equal(log.stalled, log.missing > 0)
    assert 1 < log.stalled.sum() < 60
    assert set(log.error_px) == {1.0}
    assert not log.coarser.any()


def test_all_needed_parts_are_requested_once(tree: Tree) -> None:
    cameras = still(60)
    log = nf.orthoview.simulate(tree, cameras, link=Link(100.0), rate=20.0, margin_deg=None)
    queue = tree.prefetch_queue(cameras[0].position, camera=cameras[0])
    coarsest = set(tree.cut(cameras[0], error_px=1e30, geometry=False, around=True).keys())
    # Cells above subtrees whose records have not arrived stand in for these.
    level = tree._layout.subtree
    above = {(level, place, n) for place in np.ndindex(*tree.cells(level)) for n in range(len(tree.directions))}
    instead = coarsest | {key for key in above if tree.view(*key) is not None}
    needed = {*queue.needed, *queue.soon}
    records = sum(request.bytes for request in flown(tree, cameras[:3], 1, margin=None) if is_record(request))
    assert sizes(tree, needed) + records <= log.asked == log.received[-1] <= sizes(tree, instead | needed) + records
    bare = nf.orthoview.simulate(tree, cameras, link=Link(100.0), rate=20.0, prefetch=False)
    cut = tree.cut(cameras[0])
    shown = {(0, place, -1) for place in tree._viewer.cutter.with_guests(cut.leaf_places(in_picture=True))}
    needed = shown | set(cut.keys(in_picture=True))
    assert sizes(tree, needed) <= bare.asked == bare.received[-1] <= sizes(tree, instead | needed) + records
    assert bare.asked < log.asked
    # There are few coarsest views.
    assert sizes(tree, coarsest) < 0.5 * sizes(tree, needed)


@pytest.mark.parametrize("mbps", [1.0, 10.0])
def test_a_link_delivers_at_most_its_rate(few_tree: Tree, mbps: float) -> None:
    """Only complete files count: at most 16 of them are in transit."""
    log = nf.orthoview.simulate(few_tree, still(72), link=Link(mbps))
    sent = log.time * mbps * 1e6 / 8
    assert (np.diff(log.received) >= 0).all()
    assert (log.received <= sent + 1e-6).all()
    busy = log.received < log.asked
    assert busy.any()
    largest = max(sizes(few_tree, {part}) for part in few_tree.prefetch_queue(MIDDLE).needed[::20])
    # Records come first, one after the other, in slow start and with pauses until the next frame.
    assert (np.diff(log.received[busy]) <= np.diff(sent).max() + 16 * max(largest, 20_000)).all()
    assert log.received[-1] > 0.5 * min(sent[-1], log.asked)


def test_a_round_trip_delays_every_part(few_tree: Tree) -> None:
    log = nf.orthoview.simulate(few_tree, still(72), link=Link(1e6, rtt_ms=100.0))
    # Two round trips of the handshake, one for the list of records, and one for the first record.
    assert (log.received[log.time < 0.4] == 0).all()
    assert log.received[-1] > 0


def test_with_a_fast_link_only_the_first_frames_stall(few_tree: Tree) -> None:
    """New parts of a frame are requested then, and present in the next one; each tier of records takes a frame."""
    tiers = few_tree._layout.tiers
    log = nf.orthoview.simulate(few_tree, path(30), link=FAST, adapt=False)
    assert log.stalled[: tiers + 1].all()
    assert not log.stalled[tiers + 1 :].any()
    bare = nf.orthoview.simulate(few_tree, path(30), link=FAST, adapt=False, prefetch=False)
    assert bare.stalled[tiers + 1 :].any()


@pytest.mark.parametrize("mbps", [4.0, 30.0])
def test_prefetching_saves_stalls(few_tree: Tree, mbps: float) -> None:
    cameras = [*still(60), *path(60, step=(0.4, 0, 0))]
    logs = [
        nf.orthoview.simulate(few_tree, cameras, link=Link(mbps, rtt_ms=20.0), adapt=False, prefetch=prefetch)
        for prefetch in (True, False)
    ]
    # Starting when the viewer begins to move.
    ahead, bare = (log.missing[60:] for log in logs)
    assert (ahead > 0).sum() <= (bare > 0).sum()
    assert ahead.sum() < bare.sum()


def test_a_small_cache_requests_parts_again(few_tree: Tree) -> None:
    """Flies forward and back; needed parts are always kept."""
    cameras = [*path(20, step=(3.0, 0, 0)), *path(20, step=(3.0, 0, 0))[::-1]]
    large, small = (
        nf.orthoview.simulate(few_tree, cameras, link=FAST, adapt=False, prefetch=False, cache_bytes=count)
        for count in (1 << 30, 0)
    )
    assert small.asked > 1.2 * large.asked
    assert small.stalled.sum() >= large.stalled.sum()
    coarsest = set(few_tree.cut(cameras[0], error_px=1e30, geometry=False, around=True).keys())
    distinct: set[Part] = set()
    for camera in cameras[:20]:
        cut = few_tree.cut(camera)
        leaves = few_tree._viewer.cutter.with_guests(cut.leaf_places(in_picture=True))
        distinct |= {*cut.keys(in_picture=True), *((0, place, -1) for place in leaves)}
    records = sum(request.bytes for request in flown(few_tree, cameras[:20], 1) if is_record(request))
    assert sizes(few_tree, distinct) <= large.asked <= sizes(few_tree, distinct | coarsest) + records
    resting = nf.orthoview.simulate(few_tree, still(60), link=FAST, cache_bytes=0)
    kept = nf.orthoview.simulate(few_tree, still(60), link=FAST)
    assert resting.asked == kept.asked
    assert not resting.stalled[4:].any()


def test_pictures_are_coarser_on_a_slow_link(tree: Tree) -> None:
    cameras = [*path(40, step=(1.5, 0, 0)), *[path(40, step=(1.5, 0, 0))[-1]] * 80]
    log = nf.orthoview.simulate(tree, cameras, link=Link(5.0), rate=20.0)
    fixed = nf.orthoview.simulate(tree, cameras[:60], link=Link(5.0), rate=20.0, adapt=False)
    assert log.error_px[0] == log.error_px[-1] == log.error_px.min() == 1.0
    assert log.coarser.any()
    assert not log.coarser[-1]
    assert not log.stalled[-1]
    assert not fixed.coarser.any()
    steps = np.log2(log.error_px) * 2
    np.testing.assert_allclose(steps, np.round(steps), atol=1e-9)


def test_logs_describe_themselves() -> None:
    log = nf.orthoview.FlightLog(
        np.arange(4) / 10, np.array([5, 2, 0, 0]), np.array([5, 5, 6, 6]), np.array([1.0, 1.0, 2.0, 1.0]),
        np.array([0, 10, 2000, 2000]), 4321, 17,
    )  # fmt: skip
    assert repr(log) == "FlightLog(4 frames, 50.0% stalled, 25.0% coarser, 17 requests, 4,321 bytes)"
    assert log.stalled.tolist() == [True, True, False, False]
    assert log.coarser.tolist() == [False, False, True, False]


def test_logs_are_plotted(few_tree: Tree, monkeypatch: pytest.MonkeyPatch) -> None:
    need("matplotlib")
    monkeypatch.setenv("MPLBACKEND", "agg")
    from matplotlib import pyplot

    log = nf.orthoview.simulate(few_tree, still(10), link=Link(20.0))
    rows: dict[Value, Any] = {"bytes": log.received, "missing": log.missing, "error_px": log.error_px}
    for value, row in rows.items():
        ax = log.plot(value=value)
        points = [np.asarray(line.get_ydata()) for line in ax.get_lines()]
        assert set(np.concatenate(points)) == set(row.astype(float))
    _, own = pyplot.subplots()
    assert log.plot(own) is own
    pyplot.close("all")


def test_a_flight_needs_cameras(few_tree: Tree) -> None:
    with pytest.raises(ValueError, match="cameras: expected at least one, got none"):
        nf.orthoview.simulate(few_tree, [], link=FAST)
