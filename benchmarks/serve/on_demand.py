"""Seconds from a request for a new centre until its rings are there, for one client and for two at once.

python -m benchmarks.serve.on_demand [--quick]
"""

from __future__ import annotations

import argparse
import http.client
import json
import statistics
import time
from concurrent.futures import ThreadPoolExecutor
from urllib.parse import urlsplit

import numpy as np

import nearfar as nf
from benchmarks.harness.timing import machine, table
from nearfar.serve._server import Server
from nearfar.serve._site import Site
from nearfar.stream._on_demand import OnDemand
from nearfar.stream._radii import PUBLISHED

HEADER = ["", "ring 0, coarse", "last ring, coarse", "ring 0", "last ring", "kB, coarse", "kB after it"]

Times = tuple[float, ...]
"""Seconds until the coarse ring 0, the last coarse ring, the ring 0 and the last ring of full size."""


def ask(url: str, place: tuple[float, float]) -> tuple[Times, tuple[int, int]]:
    """Ask for a place, and fetch each file as soon as its part tells of it; seconds, and bytes of both stages."""
    connection = http.client.HTTPConnection(urlsplit(url).netloc)
    start = time.perf_counter()
    connection.request("GET", f"/at/{place[0]},1.75,{place[1]}/parts")
    answer = connection.getresponse()
    came: dict[tuple[int, int], float] = {}
    sizes = [0, 0]
    while line := answer.readline():
        told = json.loads(line)
        for name in told.get("files", ()):
            sizes[told["stage"]] += len(fetched(url, name))
        if told["event"] == "ring":
            came[told["stage"], told["ring"]] = time.perf_counter() - start
    last = len(PUBLISHED)
    return tuple(came[key] for key in ((0, 0), (0, last), (1, 0), (1, last))), (sizes[0], sizes[1])


def fetched(url: str, name: str) -> bytes:
    """Content of a file, over a connection of its own: the server closes those that are idle."""
    files = http.client.HTTPConnection(urlsplit(url).netloc)
    files.request("GET", f"/{name}")
    content = files.getresponse().read()
    files.close()
    return content


def row(name: str, found: list[tuple[Times, tuple[int, int]]]) -> list[str]:
    """Medians over requests."""
    seconds = [statistics.median(values) for values in zip(*(times for times, _ in found), strict=True)]
    sizes = [statistics.median(values) / 1e3 for values in zip(*(bytes_ for _, bytes_ in found), strict=True)]
    return [name, *(f"{value:.2f}" for value in seconds), *(f"{value:,.0f}" for value in sizes)]


def measured(name: str, scene: nf.Scene, places: list[tuple[float, float]]) -> list[list[str]]:
    """Rows of a scene: one client after the other, then two at once; no place is asked for twice."""
    nf.cast_rays(scene, np.array([[0.0, 1.7, 0.0]]), np.array([[0.0, -1.0, 0.0]]))
    with Server({"": Site.of_scene(OnDemand(scene, radii=PUBLISHED), None)}) as server, ThreadPoolExecutor(2) as pool:
        half = len(places) // 2
        alone = [ask(server.url, place) for place in places[:half]]
        pairs = zip(places[half::2], places[half + 1 :: 2], strict=True)
        both = [found for pair in pairs for found in pool.map(lambda place: ask(server.url, place), pair)]
    return [row(name, alone), row(f"{name}, two clients at once", both)]


def main() -> None:
    """Print the table."""
    parse = argparse.ArgumentParser(description=__doc__)
    parse.add_argument("--quick", action="store_true", help="a small city alone")
    quick = parse.parse_args().quick
    places = [
        (0.0, 0.0),
        (-42.0, -64.0),
        (30.0, 2.0),
        (60.0, -60.0),
        (2.0, 40.0),
        (-60.0, 0.0),
        (90.0, 60.0),
        (-20.0, 62.0),
    ]
    print(machine(), flush=True)
    rows = []
    for name, blocks, detail in [("city, small", 3, 0)] if quick else [("city", 12, 2), ("city", 9, 3)]:
        scene = nf.datasets.city(blocks=blocks, detail=detail)
        rows += measured(
            f"{name}, {scene.triangle_count / 1e6:.1f} M triangles", scene, places[:4] if quick else places
        )
    print(table("seconds from the request, maps of 6 × 1024², 4 samples", HEADER, rows))


if __name__ == "__main__":
    main()
