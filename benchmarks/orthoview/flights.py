"""Flights over links: stalls and bytes with and without prefetching, against a client of 3D Tiles; bytes per metre.

    python -m benchmarks.orthoview.flights stalls TREE             # speeds and links, on a virtual clock
    python -m benchmarks.orthoview.flights speed TREE              # growing speeds: adapted errors, and stalls
    python -m benchmarks.orthoview.flights growth TREE --out FOLDER  # bytes a metre in worlds of growing extent
    python -m benchmarks.orthoview.flights measured TREE           # first pictures over a local server, and simulated

TREE is a store of Tokyo with geometry. In its 3D Tiles only leaves have content, so the client of 3D Tiles refines all
tiles down to the leaves.
"""

from __future__ import annotations

import itertools
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np

import nearfar as nf
from benchmarks.harness.report import save_figure, start, subplots, table
from benchmarks.orthoview._link_server import serve_over
from nearfar.orthoview._cut import GEOMETRY, Cutter, Part, Settings
from nearfar.orthoview._flight import THREADS
from nearfar.orthoview._meter import LinkTotals
from nearfar.orthoview._pilot import Plan
from nearfar.orthoview._requests import FlightRequests, Request
from nearfar.orthoview._simulate import Client, fly_through
from nearfar.stream._transport import Transport

RATE, SECONDS = 72, 60
FOV, PICTURE = nf.Fov.symmetric(60, 4 / 3), (640, 480)
START = (-8000.0, -3000.0)
"""x and z of the start of flights, in metres of the dataset."""
TRAVELS = {"walk": (1.5, 2.0), "drive": (14.0, 30.0), "helicopter": (50.0, 120.0), "aeroplane": (150.0, 400.0)}
"""Speed in metres per second and height in metres by means of travel."""
LINKS = (20.0, 50.0, 100.0)
"""Rates in megabits per second."""
RTT_MS = 30.0
FINEST = 1e-6
"""Error at which all visible leaves are geometry, as with 3D Tiles, which refines all tiles within 30 km here."""
PLAN_INTERVAL = 8
"""Frames between plans of the client of 3D Tiles: a plan takes long to compute here."""


def main() -> None:
    options = start(__doc__, "--out", what={"choices": TABLES}, tree={"help": "store of Tokyo"})
    print(TABLES[options.what](nf.orthoview.open(options.tree), options.out))


def flight(speed: float, height: float, seconds: float = SECONDS) -> list[nf.Camera]:
    """Frames of a flight in long curves, looking slightly downwards."""
    position, angle, cameras = np.array([START[0], height, START[1]]), 0.3, []
    for frame in range(int(seconds * RATE)):
        angle += 0.4 * np.sin(0.8 * frame / RATE) / RATE
        ahead = np.array([np.cos(angle), 0.0, np.sin(angle)])
        position = position + ahead * (speed / RATE)
        cameras.append(nf.Camera.look_at(position, position + ahead - [0.0, 0.15, 0.0], fov=FOV, size=PICTURE))
    return cameras


class Tiles:
    """Plans of a client of 3D Tiles: all leaves in the picture, the nearest first."""

    def __init__(self, cutter: Cutter) -> None:
        self._cutter = cutter
        self._frames = 0
        self._plan = Plan({}, [], FINEST)

    def __call__(
        self, camera: nf.Camera, time: float, received: LinkTotals, busy: bool, held: Callable[[Part], bool]
    ) -> Plan:
        """Plan the tiles in the picture."""
        if self._frames % PLAN_INTERVAL == 0:
            cut = self._cutter.complete_cut(camera, Settings(error_px=FINEST))
            parts_by_leaf = {(0, place): [(0, place, GEOMETRY)] for place in cut.leaf_places(in_picture=True)}
            self._plan = Plan(parts_by_leaf, list(itertools.chain(*parts_by_leaf.values())), FINEST)
        self._frames += 1
        return self._plan


def tiles(tree: nf.orthoview.OrthoTree, cameras: list[nf.Camera], link: nf.stream.Link) -> nf.orthoview.FlightLog:
    requests = FlightRequests(tree)
    transport = Transport(replace(link, http=1), at_once=THREADS)
    client = Client(Tiles(requests.opened.viewer.cutter), requests, transport, THREADS, 1 << 40)
    return fly_through(client, cameras, RATE)


def stalls(tree: nf.orthoview.OrthoTree, out: Path | None) -> str:
    rows = []
    for (travel, (speed, height)), mbps in itertools.product(TRAVELS.items(), LINKS):
        cameras, link = flight(speed, height), nf.stream.Link(mbps=mbps, rtt_ms=RTT_MS)
        on_demand = nf.orthoview.simulate(tree, cameras, link=link, prefetch=False, adapt=False)
        prefetched = nf.orthoview.simulate(tree, cameras, link=link, adapt=False)
        for name, log in (("on demand", on_demand), ("prefetch", prefetched), ("3D Tiles", tiles(tree, cameras, link))):
            first = int(np.argmin(log.stalled)) if not log.stalled.all() else len(log.time)
            later = 100 * log.stalled[first:].mean() if first < len(log.time) else np.nan
            shares = first / RATE, 100 * log.stalled.mean(), later
            asked = log.requests, log.asked / 1e6, log.asked / on_demand.asked
            rows.append([f"{travel}, {speed:g} m/s", mbps, name, *shares, *asked])
            print(rows[-1], flush=True)
    header = "travel | Mb/s {:g} | client | first picture, s {:.1f} | stalled, % {:.1f} | later, % {:.1f}"
    return table("Stalls", header + " | requests {} | MB {:.1f} | bytes, × {:.2f}", rows)


def speed(tree: nf.orthoview.OrthoTree, out: Path | None) -> str:
    """Increase the speed at one height, over a link that is too slow for the last speeds."""
    rows, link = [], nf.stream.Link(mbps=20.0, rtt_ms=RTT_MS)
    for metres_per_second in (50.0, 100.0, 200.0, 400.0):
        cameras = flight(metres_per_second, 120.0, 30)
        for name, adapt in (("fixed error", False), ("adapted error", True)):
            log = nf.orthoview.simulate(tree, cameras, link=link, adapt=adapt)
            later = log.time >= 10.0
            error = log.error_px[later]
            stalled = 100 * log.stalled[later].mean()
            rows.append([metres_per_second, name, stalled, error.mean(), error.max(), log.asked / 1e6])
    header = "m/s {:g} | picture | stalled after 10 s, % {:.1f} | mean error, px {:.2f} | greatest {:.2f} | MB {:.1f}"
    return table("Growing speeds", header, rows)


def growth(tree: nf.orthoview.OrthoTree, out: Path | None) -> str:
    """Table of bytes that come into the picture per metre, by the world's extent.

    Smaller worlds are squares: the cuts are those of the whole world, without the cells outside the square.
    """
    rows: list[list[float]] = []
    world_side = float((tree.bounds[1] - tree.bounds[0]).max())
    parts_by_travel = {name: _parts_per_metre(tree, TRAVELS[name][1]) for name in ("walk", "helicopter")}
    for side in (1000.0, 2000.0, 4000.0, 8000.0, 16000.0, world_side):
        rows.append([side / 1e3])
        for metres in parts_by_travel.values():
            half_side = side / 2
            in_square = [{part: size for part, (size, far) in parts.items() if far <= half_side} for parts in metres]
            received = dict(in_square[0])
            first_bytes = sum(received.values())
            for parts in in_square[1:]:
                received |= parts
            bytes_per_metre = (sum(received.values()) - first_bytes) / (len(metres) - 1)
            rows[-1] += [float(np.mean([len(parts) for parts in in_square])), first_bytes / 1e6, bytes_per_metre / 1e3]
    if out is not None:
        _plot(rows, out)
    each = {"parts": "{:.0f}", "first picture, MB": "{:.2f}", "kB a metre": "{:.2f}"}
    columns = (f"{name}{place} {form}" for place in ("", ", 120 m") for name, form in each.items())
    return table("A walk of 400 m", ["side, km {:g}", *columns], rows)


def _parts_per_metre(tree: nf.orthoview.OrthoTree, height: float) -> list[dict[Part, tuple[int, float]]]:
    """Parts of the picture at each of 400 metres, with their bytes and their cells' distance from the path's middle."""
    requests = FlightRequests(tree)
    cutter, grid, metres = requests.opened.viewer.cutter, requests.opened.grid, 400
    facts: dict[Part, tuple[int, float]] = {}
    textures: set[Request] = set()
    parts_by_metre = []
    for metre in range(metres + 1):
        eye = np.array([START[0] - metres / 2 + metre, height, START[1]])
        camera = nf.Camera.look_at(eye, np.add(eye, [1.0, -0.15, 0.0]), fov=FOV, size=PICTURE)
        cut = cutter.complete_cut(camera, Settings())
        leaves = cutter.with_guests(cut.leaf_places(in_picture=True))
        parts: list[Part] = [*((0, place, GEOMETRY) for place in leaves), *cut.keys(in_picture=True)]
        for part in (part for part in parts if part not in facts):
            new_requests = {*requests.list_requests(part)} - textures
            textures |= {request for request in new_requests if request.is_texture}
            size = sum(request.bytes for request in new_requests)
            middle = grid.box(part[0], part[1]).mean(axis=0) - [START[0], 0.0, START[1]]
            facts[part] = size, float(np.abs(middle[[0, 2]]).max())
        parts_by_metre.append({part: facts[part] for part in parts})
    return parts_by_metre


def measured(tree: nf.orthoview.OrthoTree, out: Path | None) -> str:
    """Compare the time until nothing is missing over a local server with the simulated time, for a standing viewer."""
    camera, folder, rows = flight(0.0, TRAVELS["helicopter"][1], 1)[0], Path(tree.path), []
    for rtt_ms, mbps, threads in itertools.product((30.0, 100.0), (20.0, 100.0), (2, THREADS)):
        link = nf.stream.Link(mbps=mbps, rtt_ms=rtt_ms, handshake=1.0)
        with serve_over(link, folder.parent) as (url, line):
            remote = nf.orthoview.open(f"{url}/{folder.name}")
            opening = line.requests
            with remote.fly(threads=threads, prefetch=False, adapt=False) as own:
                begin = time.monotonic()
                for number in itertools.count(1):
                    own.look(camera)
                    plan = own._pilot.plan(own._has)
                    if not plan.unknown[0] and all(map(own._has, plan.order)):
                        break
                    time.sleep(max(begin + number / RATE - time.monotonic(), 0.0))
                seconds, requests = time.monotonic() - begin, line.requests - opening
                read = own._received()
        still = [camera] * 60 * RATE
        log = nf.orthoview.simulate(tree, still, link=link, threads=threads, prefetch=False, adapt=False)
        first = int(np.argmax(log.received)) / RATE
        rows.append([rtt_ms, mbps, threads, read.views, read.leaves, requests, log.requests, seconds, first])
        print(rows[-1], flush=True)
    header = "round trip, ms {:g} | Mb/s {:g} | threads | views | leaves | requests | simulated | s {:.2f}"
    return table("First pictures over a local server", header + " | simulated, s {:.2f}", rows)


def _plot(rows: list[list[float]], out: Path) -> None:
    sides = [row[0] for row in rows]
    figure, (left, right) = subplots(1, 2, figsize=(9, 3.4))
    for axes, column, label in ((left, 1, "views and leaves of a picture"), (right, 3, "kB for each metre")):
        for offset, name in ((0, "walker"), (3, "120 m above")):
            axes.plot(sides, [row[column + offset] for row in rows], marker="o", label=name)
        axes.set(xscale="log", xlabel="side of the world, km", ylabel=label)
        axes.set_ylim(bottom=0)
    left.legend(fontsize="small")
    save_figure(figure, out / "orthoview_growth.png", dpi=110)


TABLES = {each.__name__: each for each in (stalls, speed, growth, measured)}

if __name__ == "__main__":
    main()
