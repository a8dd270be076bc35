"""Latency for other clients during a flood of region requests: of a file, and of a new client's first ring.

python -m benchmarks.serve.flood [--quick]
"""

from __future__ import annotations

import argparse
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

import nearfar as nf
from benchmarks.harness.timing import machine, table
from nearfar.serve._server import Server
from nearfar.serve._site import Site
from nearfar.stream._on_demand import OnDemand

ADDRESSES, CLIENTS = 8, 6
"""Number of addresses of the flood, and of concurrent requests per address: more than the four allowed to wait."""
HEADER = ["", "file, median ms", "file, 99th percentile ms", "first ring, median s", "refused", "accepted"]


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


def file_times(url: str, count: int) -> list[float]:
    """Milliseconds of requests for a file of the page, each over a new connection."""
    found = []
    for _ in range(count):
        start = time.perf_counter()
        line = http.client.HTTPConnection(urlsplit(url).netloc, timeout=300)
        line.request("GET", "/page.css")
        line.getresponse().read()
        line.close()
        found.append(1000 * (time.perf_counter() - start))
    return found


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


def measured(url: str, first: int) -> list[str]:
    """Cells of a row: times of a file, and of five new clients."""
    rings = [first_ring(url, number) for number in range(first, first + 5)]
    times = file_times(url, 300)
    high = statistics.quantiles(times, n=100)[98]
    return [f"{statistics.median(times):.1f}", f"{high:.1f}", f"{statistics.median(rings):.2f}"]


def main() -> None:
    """Parse the arguments and run."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="a small city")
    arguments = parser.parse_args()
    scene = nf.datasets.city(blocks=3, detail=0) if arguments.quick else nf.datasets.city()
    print(machine())
    rows = []
    with Server({"": Site.of_scene(OnDemand(scene), None)}) as server:
        rows.append(["alone", *measured(server.url, 0), "0", "0"])
        with flood(server.url) as (refused, accepted):
            rows.append(["beside the flood", *measured(server.url, 5), str(refused.value), str(accepted.value)])
    print(table(f"{ADDRESSES} addresses with {CLIENTS} requests each at once", HEADER, rows))


if __name__ == "__main__":
    main()
