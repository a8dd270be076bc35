"""Seconds from a request for a new centre until its rings are available, for one client and for two at once."""

from __future__ import annotations

import json
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from urllib.request import urlopen

import numpy as np

import nearfar as nf
from benchmarks.harness import scenes, tokyo
from benchmarks.harness.report import start, table
from benchmarks.harness.timing import resident, timed
from nearfar.serve._server import Server
from nearfar.serve._site import LoadedScene, Site
from nearfar.stream._radii import PUBLISHED

HEADER = " | ring 0, coarse {:.2f} | last ring, coarse {:.2f} | ring 0 {:.2f} | last ring {:.2f} | kB, coarse {:,.0f}"
HEADER += " | kB after it {:,.0f}"

Place = tuple[float, float, float]

STREETS: tuple[Place, ...] = (
    (0.0, 1.75, 0.0),
    (-42.0, 1.75, -64.0),
    (30.0, 1.75, 2.0),
    (60.0, 1.75, -60.0),
    (2.0, 1.75, 40.0),
    (-60.0, 1.75, 0.0),
    (90.0, 1.75, 60.0),
    (-20.0, 1.75, 62.0),
)
"""Places in the procedural city."""

WARDS: tuple[Place, ...] = (
    (-28.0, 1.75, -8.0),
    (-6010.0, 1.75, -1078.0),
    (-10214.0, 1.75, -6254.0),
    (-218.0, 50.5, 1110.0),
    (-5918.0, 1.75, 2574.0),
    (916.0, 1.75, -3610.0),
    (2654.0, 1.75, -3720.0),
    (-10288.0, 1.75, 3866.0),
)
"""Open places in Tokyo, metres from its station: beside the station, in streets of Shinjuku and Nerima, on a roof in
Ginza; in streets of Shibuya, Ueno, Asakusa and Setagaya."""

Times = tuple[float, ...]
"""Seconds until the coarse ring 0, the last coarse ring, the ring 0 and the last ring of full size."""


def ask(url: str, place: Place) -> tuple[Times, tuple[int, int]]:
    """Request a place, and fetch each file as soon as its part lists it; return seconds, and bytes of both stages."""
    start = time.perf_counter()
    arrivals: dict[tuple[int, int], float] = {}
    sizes = [0, 0]
    with urlopen(url + "at/{},{},{}/parts".format(*place)) as response:
        for line in response:
            part = json.loads(line)
            for name in part.get("files", ()):
                with urlopen(url + name) as file:
                    sizes[part["stage"]] += len(file.read())
            if part["event"] == "ring":
                arrivals[part["stage"], part["ring"]] = time.perf_counter() - start
    last = len(PUBLISHED)
    return tuple(arrivals[key] for key in ((0, 0), (0, last), (1, 0), (1, last))), (sizes[0], sizes[1])


def row(name: str, results: list[tuple[Times, tuple[int, int]]]) -> list[object]:
    """Medians over requests: seconds, and kilobytes."""
    times, sizes = (np.median(values, axis=0) for values in zip(*results, strict=True))
    return [name, *times, *sizes / 1e3]


def measure(name: str, load: Callable[[], nf.Scene], places: tuple[Place, ...]) -> list[list[object]]:
    """Rows of a scene: one client after the other, then two at once; no place is requested twice."""
    regions = LoadedScene(load, radii=PUBLISHED)
    scene, loading = timed(regions.wait)
    _, tree = timed(nf.cast_rays, scene, np.array([[0.0, 1.7, 0.0]]), np.array([[0.0, -1.0, 0.0]]))
    name = f"{name}, {scene.triangle_count / 1e6:.1f} M triangles"
    with Server({"": Site.of_scene(regions, None)}) as server, ThreadPoolExecutor(2) as pool:
        request, middle = partial(ask, server.url), len(places) // 2
        single = [*map(request, places[:middle])]
        pairs = zip(places[middle::2], places[middle + 1 :: 2], strict=True)
        double = [result for pair in pairs for result in pool.map(request, pair)]
    print(f"{name}: loaded with its search trees after {loading.wall + tree.wall:.1f} s")
    print(f"{resident() / 1e9:.1f} GB at the end, {resident('VmHWM') / 1e9:.1f} GB at most so far")
    for place, (times, _) in zip(places, single + double, strict=True):
        print(f"  {place}: {', '.join(f'{value:.2f}' for value in times)} s", flush=True)
    return [row(name, single), row(f"{name}, two clients at once", double)]


def whole_of_tokyo() -> nf.Scene:
    """Load Tokyo with each building as an object; SystemExit without the data."""
    scene = tokyo.scene_of_buildings()
    if scene is None:
        raise SystemExit("--tokyo: expected NEARFAR_DATA to name a folder of data beside tools/tokyo.py")
    return scene


def main() -> None:
    options = start(__doc__, "--quick", tokyo=(bool, "the whole of Tokyo alone, 29.8 million triangles"))
    if options.tokyo:
        rows = measure("whole of Tokyo", whole_of_tokyo, WARDS)
    elif options.quick:
        rows = measure("city, small", lambda: scenes.city(quick=True), STREETS[:4])
    else:
        rows = measure("city", lambda: nf.datasets.city(blocks=12, detail=2), STREETS)
        rows += measure("city", lambda: nf.datasets.city(blocks=9, detail=3), STREETS)
    print(table("seconds from the request, maps of 6 × 1024², 4 samples", HEADER, rows))


if __name__ == "__main__":
    main()
