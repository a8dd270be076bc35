"""The four strategies over a real link, by the page in Chromium, compared with their simulation.

The city and the factory at two centres each, 50 Mbit/s, 20 ms. Seconds since the request of the manifest at which the
complete picture, the first near geometry and everything were received, ready (decoded, on the GPU) and shown. Decoding
and drawing are done in software here, and take longer than the link. Therefore the link is also compared alone: the
same browser requests the same files in the same order without decoding. Its simulation uses the measured round trip of
a short request, which includes the time of browser and server. For requirements see `benchmarks.harness.link.no_link`.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

import nearfar as nf
from benchmarks.harness.link import no_link
from benchmarks.harness.loads import Network, network
from benchmarks.harness.report import folder_or_temporary, start, table
from benchmarks.harness.timing import ahead_of_others
from benchmarks.stream._loaded import Loaded, load, requests, round_trip, simulated_requests
from benchmarks.stream._near import EYE_HEIGHT, Place, places
from nearfar.stream._strategies import Strategy

LINK = nf.stream.Link(50, rtt_ms=20, http=1, handshake=1)
"""Link of files from `nearfar serve`, by HTTP/1.1 without TLS."""
FAST = nf.stream.Link(1000, http=1, handshake=1)
"""Link on which decoding is measured."""
CONTENT = 1448 / 1500
"""Share of payload in a full packet; simulated links count payload only."""
STRATEGIES: tuple[Strategy, ...] = ("clovr", "clovrd", "vis0", "vis1")
STAGES = ("picture", "first_ring", "total")
KINDS = ("received", "ready", "shown")


@dataclass(frozen=True)
class Outcome:
    """A strategy at a place over a link."""

    place: str
    loss: float
    strategy: Strategy
    real: list[dict[str, dict[str, float]]]
    """Seconds until each load's stages were received, ready and shown."""
    simulated: dict[str, float]
    """Seconds until each stage was ready, or received for requests alone."""
    megabytes: float = 0.0
    """Megabytes of loads, with headers."""

    def median(self, stage: str, kind: str) -> float:
        """Median time over the loads at which a stage was received, ready or shown."""
        return float(np.median([load[stage][kind] for load in self.real]))


def all_places(quick: bool) -> list[Place]:
    """The city and the factory at two centres each."""
    *cities, factory = places(quick)
    x, _, z = nf.datasets.factory_view(1)[0]
    return [*cities, factory, replace(factory, name="factory, beside racks", center=(x, EYE_HEIGHT, z))]


def content(link: nf.stream.Link) -> nf.stream.Link:
    """Link for a simulation, whose rate counts payload only."""
    assert link.mbps is not None
    return replace(link, mbps=link.mbps * CONTENT)


def simulate_stages(
    bundle: nf.stream.Bundle, link: nf.stream.Link, strategy: Strategy, seed: int, *, decode_mbs: float
) -> dict[str, float]:
    """Seconds until each stage is ready in a simulation, on an open connection."""
    settings: dict[str, Any] = {"link": content(link), "strategy": strategy, "gzip": True, "seed": seed}
    line = nf.stream.simulate(bundle, **settings, decode_mbs=decode_mbs)
    return {name: float(getattr(line, name)) - link.handshake * link.rtt for name in STAGES}


def fit_decoding(bundle: nf.stream.Bundle, loads: list[Loaded]) -> float:
    """Find the decoding speed, MB/s, at which a simulation over the fast link takes as long as the loads by clovrd."""
    goal = float(np.median([load.total["ready"] for load in loads]))
    low, high = 0.01, 1e4
    for _ in range(30):
        middle = (low * high) ** 0.5
        is_slow = simulate_stages(bundle, FAST, "clovrd", 0, decode_mbs=middle)["total"] > goal
        low, high = (middle, high) if is_slow else (low, middle)
    return float((low * high) ** 0.5)


def median_of_seeds(job: Callable[[int], dict[str, float]], loss: float) -> dict[str, float]:
    """Medians of simulations with several seeds; one is sufficient without losses."""
    runs = [job(seed) for seed in range(15 if loss else 1)]
    return {name: float(np.median([run[name] for run in runs])) for name in runs[0]}


def measure_decoding(bundle: nf.stream.Bundle, repeat: int) -> float:
    """Megabytes per second of decoding, uploads and frames, from loads over the fast link."""
    with open_connection(FAST, bundle) as (connection, chromium, url):
        # The first load of a browser also compiles its shaders.
        loads = [load(connection, chromium, url, bundle, "clovrd") for _ in range(repeat + 1)][1:]
    return fit_decoding(bundle, loads)


@contextmanager
def open_connection(link: nf.stream.Link, bundle: nf.stream.Bundle) -> Iterator[tuple[Network, Any, str]]:
    """Open a link, a browser at its end, and serve a bundle behind it; yield them with the address."""
    with (
        network(link, real=True) as connection,
        connection.serve_bundle(Path(bundle._reader.location)) as url,
        connection.browser(url) as chromium,
    ):
        yield connection, chromium, url


def requests_alone(place: str, bundle: nf.stream.Bundle, loss: float, repeat: int) -> Iterator[Outcome]:
    """Measure the requests of all strategies over a link with losses."""
    link = replace(LINK, loss=loss)
    with ahead_of_others(), open_connection(link, bundle) as (connection, chromium, url):
        trip = round_trip(connection, chromium, url, bundle)
        print(f"{place}: {connection.name}; a round trip of a request takes {trip:.1f} ms")
        simulated_link = replace(content(link), rtt_ms=trip)
        for strategy in STRATEGIES:
            # clovr's requests wait for cross-fades, which need frames; up to the second ring they equal clovrd's.
            if strategy == "clovr":
                continue
            loads = [requests(connection, chromium, url, bundle, strategy) for _ in range(repeat)]
            real = [{name: {"received": seconds} for name, seconds in load.items()} for load in loads]
            simulated = median_of_seeds(partial(simulated_requests, bundle, simulated_link, strategy), loss)
            yield Outcome(place, loss, strategy, real, simulated)
        print(connection.real and connection.real.counts())


def page_loads(place: str, bundle: nf.stream.Bundle, loss: float, repeat: int, mbs: float) -> Iterator[Outcome]:
    """Measure loads of the page by all strategies over a link with losses."""
    link = replace(LINK, loss=loss)
    with open_connection(link, bundle) as (connection, chromium, url):
        print(f"{place}: {connection.name}; decoding, uploads and frames like {mbs:.2f} MB/s")
        load(connection, chromium, url, bundle, "clovrd")
        for strategy in STRATEGIES:
            loads = [load(connection, chromium, url, bundle, strategy) for _ in range(repeat)]
            real = [{name: getattr(each, name) for name in STAGES} for each in loads]
            simulated = median_of_seeds(partial(simulate_stages, bundle, link, strategy, decode_mbs=mbs), loss)
            yield Outcome(
                place, loss, strategy, real, simulated, float(np.median([each.bytes for each in loads])) / 1e6
            )


def link_table(outcomes: list[Outcome]) -> str:
    rows = []
    for outcome in outcomes:
        pairs = [(outcome.median(name, "received"), outcome.simulated[name]) for name in STAGES]
        times = (value for real, simulated in pairs for value in (real, simulated, simulated / real))
        rows.append([outcome.place, outcome.loss, outcome.strategy, *times])
    kinds = (", real {:.3f}", ", sim. {:.3f}", ", ratio {:.2f}")
    stages = (f"{name}{kind}" for name in ("picture", "first ring", "all") for kind in kinds)
    return table("Seconds until the files were there, requests alone", ["", "lost {:.0%}", "", *stages], rows)


def page_table(outcomes: list[Outcome]) -> str:
    rows: list[list[object]] = []
    for outcome in outcomes:
        rows.append([outcome.place, outcome.loss, outcome.strategy, outcome.megabytes])
        for name in STAGES:
            rows[-1].append(tuple(outcome.median(name, kind) for kind in KINDS))
            rows[-1].append((outcome.simulated[name], outcome.simulated[name] / outcome.median(name, "ready")))
    header = " | lost {:.0%} |  | MB {:.2f}"
    for name in ("picture", "first ring", "all"):
        header += f" | {name} {{:.2f}} / {{:.2f}} / {{:.2f}} | sim. {{:.2f}} ({{:.2f}})"
    title = "Seconds until received / ready / shown, and simulated until ready with its ratio to real"
    return table(title, header, rows)


def main() -> None:
    options = start(
        __doc__,
        "--quick",
        repeat=(5, "loads of each; the medians are printed"),
        loss=([0.0, 0.01], "shares of packets that are lost"),
        link_only=(bool, "requests without the page"),
        place=("", "places whose names have this in them, such as factory"),
    )
    if reason := no_link():
        sys.exit(reason)
    alone, page = list[Outcome](), list[Outcome]()
    for place in (place for place in all_places(options.quick) if options.place in place.name):
        with folder_or_temporary() as folder:
            bundle = nf.stream.export(place.make(), folder / "bundle", center=place.center, by_footprint=True)
            for loss in options.loss:
                alone += requests_alone(place.name, bundle, loss, options.repeat)
            if not options.link_only:
                mbs = measure_decoding(bundle, options.repeat)
                for loss in options.loss:
                    page += page_loads(place.name, bundle, loss, options.repeat, mbs)
        print(f"1-minute load of the machine: {os.getloadavg()[0]:.1f}", flush=True)
    print(link_table(alone))
    if page:
        print(page_table(page))


if __name__ == "__main__":
    main()
