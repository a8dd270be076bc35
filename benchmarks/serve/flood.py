"""Latency for other clients during a flood of region requests: of a file, and of a new client's first ring."""

from __future__ import annotations

import http.client
import itertools
import json
import multiprocessing
import statistics
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any
from urllib.parse import urlsplit

from benchmarks.harness import scenes
from benchmarks.harness.report import start, table
from benchmarks.harness.timing import timed
from nearfar.serve._server import Server
from nearfar.serve._site import Site
from nearfar.stream._on_demand import OnDemand

ADDRESSES, CLIENTS = 8, 6
"""Number of addresses of the flood, and of concurrent requests per address: more than the four allowed to wait."""
HEADER = (
    " | file, median ms {:.1f} | file, 99th percentile ms {:.1f} | first ring, median s {:.2f} | refused | accepted"
)


@contextmanager
def flood(url: str) -> Iterator[tuple[Any, Any]]:
    """Request new places from another process meanwhile; yield counts of refused and accepted requests."""
    context = multiprocessing.get_context("spawn")
    refused, accepted = context.Value("i", 0), context.Value("i", 0)
    process = context.Process(target=_flood, args=(url, refused, accepted))
    process.start()
    try:
        # Wait until all places in the queues of the addresses are taken.
        while not refused.value:
            time.sleep(0.05)
        yield refused, accepted
    finally:
        process.kill()
        process.join()


def _flood(url: str, refused: Any, accepted: Any) -> None:
    places = itertools.count()
    clients = [f"127.0.3.{address + 1}" for address in range(ADDRESSES) for _ in range(CLIENTS)]
    threads = [threading.Thread(target=_ask, args=(url, client, places, refused, accepted)) for client in clients]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()


def _ask(url: str, address: str, places: Iterator[int], refused: Any, accepted: Any) -> None:
    while True:
        number = next(places)
        line = http.client.HTTPConnection(urlsplit(url).netloc, timeout=300, source_address=(address, 0))
        line.request("GET", f"/at/{2 * (number % 97) - 96},1.75,{2 * (number % 79) - 78}/parts")
        answer = line.getresponse()
        with (accepted if answer.status == 200 else refused).get_lock():
            (accepted if answer.status == 200 else refused).value += 1
        if answer.status != 200:
            time.sleep(0.02)
        answer.read()
        line.close()


def file_time(url: str) -> float:
    """Milliseconds of a request for a file of the page over a new connection."""

    def ask() -> None:
        line = http.client.HTTPConnection(urlsplit(url).netloc, timeout=300)
        line.request("GET", "/page.css")
        line.getresponse().read()
        line.close()

    return timed(ask)[1].ms


def first_ring(url: str, number: int) -> float:
    """Seconds until a new client is notified of the coarse ring 0."""
    start = time.perf_counter()
    line = http.client.HTTPConnection(urlsplit(url).netloc, timeout=300, source_address=(f"127.0.4.{number + 1}", 0))
    line.request("GET", f"/at/{8 * number - 31},3.75,5/parts")
    answer = line.getresponse()
    while json.loads(answer.readline())["event"] != "ring":
        pass
    taken = time.perf_counter() - start
    answer.close()
    line.close()
    return taken


def measure(url: str, first: int) -> list[float]:
    """Cells of a row: times of a file, and of five new clients."""
    rings = [first_ring(url, number) for number in range(first, first + 5)]
    times = [file_time(url) for _ in range(300)]
    return [statistics.median(times), statistics.quantiles(times, n=100)[98], statistics.median(rings)]


def main() -> None:
    scene, rows = scenes.city(start(__doc__, "--quick").quick), []
    with Server({"": Site.of_scene(OnDemand(scene), None)}) as server:
        rows.append(["alone", *measure(server.url, 0), 0, 0])
        with flood(server.url) as (refused, accepted):
            rows.append(["beside the flood", *measure(server.url, 5), refused.value, accepted.value])
    print(table(f"{ADDRESSES} addresses with {CLIENTS} requests each at once", HEADER, rows))


if __name__ == "__main__":
    main()
