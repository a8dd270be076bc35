"""Flights over links: stalls and bytes with and without prefetching, against a client of 3D Tiles; bytes per metre.

    python -m benchmarks.orthoview.flights stalls TREE             # speeds and links, on a virtual clock
    python -m benchmarks.orthoview.flights speed TREE              # ever faster: pictures that adapt, and stalls
    python -m benchmarks.orthoview.flights growth TREE --out FOLDER  # bytes a metre in worlds of growing extent

TREE is a store of the whole of Tokyo with geometry. The client of 3D Tiles selects the same leaves by screen-space
error: only leaves have content, and each is refined down to them.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable
from itertools import chain
from pathlib import Path

import numpy as np

import nearfar as nf
from benchmarks.harness.timing import machine, table
from nearfar.orthoview._client import Client
from nearfar.orthoview._cut import Cutter, Settings
from nearfar.orthoview._meter import Received
from nearfar.orthoview._parts import GEOMETRY, Part
from nearfar.orthoview._pilot import Plan
from nearfar.orthoview._simulate import flown

RATE, SECONDS = 72, 60
FOV, PICTURE = nf.Fov.symmetric(60, 4 / 3), (640, 480)
START = (-8000.0, -3000.0)
"""Starting point of flights, in Tokyo's metres."""
WAYS = {"walk": (1.5, 2.0), "drive": (14.0, 30.0), "helicopter": (50.0, 120.0), "aeroplane": (150.0, 400.0)}
"""Speeds in metres per second, and heights in metres."""
LINKS = (20.0, 50.0, 100.0)
"""Rates in megabits per second."""
RTT = 30.0
FINEST = 1e-6
"""Error at which all visible leaves are geometry: with this tileset's errors 3D Tiles refines all within 30 km."""
LOOKS = 8
"""Frames between updates of the client of 3D Tiles, since each takes long here."""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("what", choices=WHAT)
    parser.add_argument("tree", help="store of the whole of Tokyo")
    parser.add_argument("--out", type=Path, help="folder for the plots")
    given = parser.parse_args()
    print(machine(), "\n")
    WHAT[given.what](given)


def flight(speed: float, height: float, seconds: float = SECONDS) -> list[nf.Camera]:
    """Frames of a flight in long curves, looking slightly downwards."""
    place, angle, cameras = np.array([START[0], height, START[1]]), 0.3, []
    for frame in range(int(seconds * RATE)):
        angle += 0.4 * np.sin(0.8 * frame / RATE) / RATE
        ahead = np.array([np.cos(angle), 0.0, np.sin(angle)])
        place = place + ahead * (speed / RATE)
        cameras.append(nf.Camera.look_at(place, place + ahead - [0.0, 0.15, 0.0], fov=FOV, size=PICTURE))
    return cameras


class Tiles:
    """Plans of a client of 3D Tiles: all leaves in the picture, the nearest first."""

    def __init__(self, cutter: Cutter) -> None:
        self._cutter = cutter
        self._frames = 0
        self._plan = Plan({}, [], FINEST)

    def __call__(
        self, camera: nf.Camera, time: float, received: Received, busy: bool, held: Callable[[Part], bool]
    ) -> Plan:
        """Plan the tiles in the picture."""
        self._frames += 1
        if self._frames % LOOKS == 1:
            self._plan = self._look(camera)
        return self._plan

    def _look(self, camera: nf.Camera) -> Plan:
        cut = self._cutter.whole(camera, Settings(error_px=FINEST))
        wanted = {(0, place): [(0, place, GEOMETRY)] for place in cut.leaf_places(in_picture=True)}
        return Plan(wanted, list(chain(*wanted.values())), FINEST)


def tiles(tree: nf.orthoview.OrthoTree, cameras: list[nf.Camera], link: nf.stream.Link) -> nf.orthoview.FlightLog:
    opened = tree._open_store()
    return flown(Client(Tiles(opened.viewer.cutter), opened.sizes, link, 1 << 40, 0), cameras, RATE)


def stalls(given: argparse.Namespace) -> None:
    tree, rows = nf.orthoview.open(given.tree), []
    for way, (speed, height) in WAYS.items():
        cameras = flight(speed, height)
        for mbps in LINKS:
            link = nf.stream.Link(mbps=mbps, rtt_ms=RTT)
            bare = nf.orthoview.simulate(tree, cameras, link=link, prefetch=False, adapt=False)
            ahead = nf.orthoview.simulate(tree, cameras, link=link, adapt=False)
            for name, log in (("on demand", bare), ("prefetch", ahead), ("3D Tiles", tiles(tree, cameras, link))):
                rows.append([f"{way}, {speed:g} m/s", f"{mbps:g}", name, *_row(log, bare)])
                print(rows[-1], flush=True)
    print(
        table("Stalls", ["way", "Mb/s", "client", "first, s", "stalled, %", "after first, %", "MB", "bytes, ×"], rows)
    )


def _row(log: nf.orthoview.FlightLog, bare: nf.orthoview.FlightLog) -> list[str]:
    first = int(np.argmin(log.stalled)) if not log.stalled.all() else len(log.time)
    later = 100 * log.stalled[first:].mean() if first < len(log.time) else np.nan
    share = f"{100 * log.stalled.mean():.1f}"
    return [f"{first / RATE:.1f}", share, f"{later:.1f}", f"{log.asked / 1e6:.1f}", f"{log.asked / bare.asked:.2f}"]


def speed(given: argparse.Namespace) -> None:
    """Increase the speed at one height, over a link that is too slow for the last speeds."""
    tree, rows, link = nf.orthoview.open(given.tree), [], nf.stream.Link(mbps=20.0, rtt_ms=RTT)
    for metres in (50.0, 100.0, 200.0, 400.0):
        cameras = flight(metres, 120.0, 30)
        for name, adapt in (("wanted error", False), ("adapts", True)):
            log = nf.orthoview.simulate(tree, cameras, link=link, adapt=adapt)
            later = log.time >= 10.0
            error = log.error_px[later]
            numbers = [f"{100 * log.stalled[later].mean():.1f}", f"{error.mean():.2f}", f"{error.max():.2f}"]
            rows.append([f"{metres:g}", name, *numbers, f"{log.asked / 1e6:.1f}"])
    print(table("Ever faster", ["m/s", "picture", "stalled after 10 s, %", "mean error, px", "greatest", "MB"], rows))


def growth(given: argparse.Namespace) -> None:
    """Table of bytes that come into the picture per metre, by the world's extent.

    A world that ends at a square's sides has the cells within it: cuts of the whole one without cells outside.
    """
    tree, rows = nf.orthoview.open(given.tree), []
    whole = float((tree.bounds[1] - tree.bounds[0]).max())
    asked = {name: _parts_per_metre(tree, WAYS[name][1]) for name in ("walk", "helicopter")}
    for side in (1000.0, 2000.0, 4000.0, 8000.0, 16000.0, whole):
        row = [f"{side / 1e3:g}"]
        for metres in asked.values():
            within = [{part: size for part, (size, away) in parts.items() if away <= side / 2} for parts in metres]
            seen = dict(within[0])
            first = sum(seen.values())
            for parts in within[1:]:
                seen |= parts
            later = (sum(seen.values()) - first) / (len(metres) - 1)
            row += [f"{np.mean([len(parts) for parts in within]):.0f}", f"{first / 1e6:.2f}", f"{later / 1e3:.2f}"]
        rows.append(row)
    each = ["parts", "first picture, MB", "kB a metre"]
    print(table("A walk of 400 m", ["side, km", *each, *(f"{name}, 120 m" for name in each)], rows))
    if given.out is not None:
        _plot(rows, given.out)


def _parts_per_metre(tree: nf.orthoview.OrthoTree, height: float) -> list[dict[Part, tuple[int, float]]]:
    """Parts of the picture on each of 400 metres, with bytes and the distance of their cells from the way's middle."""
    opened = tree._open_store()
    cutter, grid, metres = opened.viewer.cutter, opened.grid, 400
    facts: dict[Part, tuple[int, float]] = {}
    found = []
    for metre in range(metres + 1):
        eye = np.array([START[0] - metres / 2 + metre, height, START[1]])
        camera = nf.Camera.look_at(eye, np.add(eye, [1.0, -0.15, 0.0]), fov=FOV, size=PICTURE)
        cut = cutter.whole(camera, Settings())
        leaves = cutter.with_guests(cut.leaf_places(in_picture=True))
        parts: list[Part] = [*((0, place, GEOMETRY) for place in leaves), *cut.keys(in_picture=True)]
        new = [part for part in parts if part not in facts]
        for part, size in zip(new, opened.sizes(new), strict=True):
            middle = grid.box(part[0], part[1]).mean(axis=0) - [START[0], 0.0, START[1]]
            facts[part] = size, float(np.abs(middle[[0, 2]]).max())
        found.append({part: facts[part] for part in parts})
    return found


def _plot(rows: list[list[str]], out: Path) -> None:
    import matplotlib.pyplot as plt

    sides = [float(row[0]) for row in rows]
    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.4), layout="constrained")
    for axes, column, label in ((left, 1, "views and leaves of a picture"), (right, 3, "kB for each metre")):
        for offset, name in ((0, "walker"), (3, "120 m above")):
            axes.plot(sides, [float(row[column + offset]) for row in rows], marker="o", label=name)
        axes.set(xscale="log", xlabel="side of the world, km", ylabel=label)
        axes.set_ylim(bottom=0)
    left.legend(fontsize="small")
    figure.savefig(out / "orthoview_growth.png", dpi=110)


WHAT = {"stalls": stalls, "speed": speed, "growth": growth}

if __name__ == "__main__":
    main()
