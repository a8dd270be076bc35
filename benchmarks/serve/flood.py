"""What others notice of a flood of requests for regions: time of a file and of a new client's first ring.

python -m benchmarks.serve.flood [--quick]
"""

from __future__ import annotations

import argparse
import http.client
import itertools
import json
import statistics
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from urllib.parse import urlsplit

import nearfar as nf
from benchmarks.harness.timing import machine, table
from nearfar.serve._server import Server
from nearfar.serve._site import Site
from nearfar.stream._on_demand import OnDemand

ADDRESSES, CLIENTS = 8, 6
"""Addresses of the flood, and how many requests each sends at once: more than the four that one may wait for."""
HEADER = ["", "file, median ms", "file, 99th percentile ms", "first ring, median s", "refused", "accepted"]


class Flood:
    """Clients that ask for one new place after the other."""

    def __init__(self, url: str) -> None:
        self.refused = self.accepted = 0
        self._url, self._ends = url, threading.Event()
        self._places = itertools.count(1000)
        self._threads = [
            threading.Thread(target=self._ask, args=(f"127.0.3.{address + 1}",))
            for address in range(ADDRESSES)
            for _ in range(CLIENTS)
        ]

    @contextmanager
    def going(self) -> Iterator[None]:
        """Flood meanwhile."""
        for thread in self._threads:
            thread.start()
        yield
        self._ends.set()
        for thread in self._threads:
            thread.join()

    def _ask(self, address: str) -> None:
        while not self._ends.is_set():
            place = f"{next(self._places) % 200 - 100},1.75,{next(self._places) % 160 - 80}"
            line = http.client.HTTPConnection(urlsplit(self._url).netloc, timeout=300, source_address=(address, 0))
            line.request("GET", f"/at/{place}/parts")
            answer = line.getresponse()
            if answer.status == 200:
                self.accepted += 1
                while not self._ends.is_set() and answer.readline():
                    pass
            else:
                self.refused += 1
                time.sleep(0.02)
            answer.close()
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
    """Seconds until a new client is told of the coarse ring 0."""
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


def main() -> None:
    """Parse the arguments and run."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="a small city")
    arguments = parser.parse_args()
    scene = nf.datasets.city(blocks=3, detail=0) if arguments.quick else nf.datasets.city()
    print(machine())
    rows = []
    with Server({"": Site.of_scene(OnDemand(scene), None)}) as server:
        flood = Flood(server.url)
        for name in ("alone", "beside the flood"):
            with flood.going() if name != "alone" else threading.Lock():
                if name != "alone":
                    time.sleep(1)
                offset = 0 if name == "alone" else 5
                rings = [first_ring(server.url, number + offset) for number in range(5)]
                times = file_times(server.url, 300)
            high = statistics.quantiles(times, n=100)[98]
            numbers = [f"{statistics.median(times):.1f}", f"{high:.1f}", f"{statistics.median(rings):.2f}"]
            rows.append([name, *numbers, str(flood.refused), str(flood.accepted)])
    print(table(f"{ADDRESSES} addresses with {CLIENTS} requests each at once", HEADER, rows))


if __name__ == "__main__":
    main()
