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
from contextlib import closing, contextmanager
from typing import Any
from urllib.parse import urlsplit

from benchmarks.harness import scenes
from benchmarks.harness.report import start, table
from nearfar.serve._server import Server
from nearfar.serve._site import LoadedScene, Site

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
    for client in [f"127.0.3.{address + 1}" for address in range(ADDRESSES) for _ in range(CLIENTS)]:
        threading.Thread(target=_ask_forever, args=(url, client, places, refused, accepted)).start()


def _ask_forever(url: str, address: str, places: Iterator[int], refused: Any, accepted: Any) -> None:
    for number in places:
        with ask(url, f"/at/{2 * (number % 97) - 96},1.75,{2 * (number % 79) - 78}/parts", address) as response:
            count = accepted if response.status == 200 else refused
            with count.get_lock():
                count.value += 1
            if response.status != 200:
                time.sleep(0.02)
            response.read()


@contextmanager
def ask(url: str, path: str, address: str = "127.0.0.1") -> Iterator[http.client.HTTPResponse]:
    """Request a path over a new connection from a local address; yield the response."""
    with closing(http.client.HTTPConnection(urlsplit(url).netloc, timeout=300, source_address=(address, 0))) as server:
        server.request("GET", path)
        with server.getresponse() as response:
            yield response


def file_ms(url: str) -> float:
    """Milliseconds of a request for a file of the page over a new connection."""
    start = time.perf_counter()
    with ask(url, "/page.css") as response:
        response.read()
    return 1e3 * (time.perf_counter() - start)


def first_ring_seconds(url: str, number: int) -> float:
    """Seconds until a new client is notified of the coarse ring 0."""
    start = time.perf_counter()
    with ask(url, f"/at/{8 * number - 31},3.75,5/parts", f"127.0.4.{number + 1}") as response:
        while json.loads(response.readline())["event"] != "ring":
            pass
        return time.perf_counter() - start


def measure(url: str, first: int) -> list[float]:
    """Cells of a row: times of a file, and of five new clients."""
    rings = [first_ring_seconds(url, number) for number in range(first, first + 5)]
    times = [file_ms(url) for _ in range(300)]
    return [statistics.median(times), statistics.quantiles(times, n=100)[98], statistics.median(rings)]


def main() -> None:
    scene, rows = scenes.city(start(__doc__, "--quick").quick), []
    with Server({"": Site.of_scene(LoadedScene(lambda: scene), None)}) as server:
        rows.append(["alone", *measure(server.url, 0), 0, 0])
        with flood(server.url) as (refused, accepted):
            rows.append(["beside the flood", *measure(server.url, 5), refused.value, accepted.value])
    print(table(f"{ADDRESSES} addresses with {CLIENTS} requests each at once", HEADER, rows))


if __name__ == "__main__":
    main()
