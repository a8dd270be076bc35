"""The four strategies over a real link, by the page in Chromium, compared with their simulation.

The city and the factory at two centres each, 50 Mbit/s, 20 ms. For each load: when the complete picture, the first near
geometry and everything had been received, were ready (decoded, on the GPU) and were shown, since the request of the
manifest. Decoding and drawing are done in software here, and take longer than the link. The link is therefore also
compared alone: the same requests in the same order by the same browser, without decoding; simulated with the measured
round trip of a short request, which exceeds the link's own by the time of browser and server. For requirements see
`benchmarks.harness.link.no_link`.
"""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import asdict, dataclass, replace
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
        return float(np.median([one[stage][kind] for one in self.real]))


def all_places(quick: bool) -> list[Place]:
    """The city and the factory at two centres each."""
    found = places(quick)
    x, _, z = nf.datasets.factory_view(1)[0]
    return [*found, replace(found[-1], name="factory, beside racks", center=(x, EYE_HEIGHT, z))]


def content(link: nf.stream.Link) -> nf.stream.Link:
    """Link for a simulation, whose rate counts payload only."""
    assert link.mbps is not None
    return replace(link, mbps=link.mbps * CONTENT)


def simulate_stages(
    bundle: nf.stream.Bundle, link: nf.stream.Link, strategy: Strategy, seed: int, *, decode_mbs: float
) -> dict[str, float]:
    """Seconds until each stage is ready in a simulation, on an open connection."""
    line = nf.stream.simulate(
        bundle, link=content(link), strategy=strategy, gzip=True, seed=seed, decode_mbs=decode_mbs
    )
    return {name: float(getattr(line, name)) - link.handshake * link.rtt for name in STAGES}


def fit_decoding(bundle: nf.stream.Bundle, loads: list[Loaded]) -> float:
    """Megabytes per second with which a simulation over the fast link takes as long as the loads by clovrd."""
    goal = float(np.median([one.total["ready"] for one in loads]))
    low, high = 0.01, 1e4
    for _ in range(30):
        middle = (low * high) ** 0.5
        slow = simulate_stages(bundle, FAST, "clovrd", 0, decode_mbs=middle)["total"] > goal
        low, high = (middle, high) if slow else (low, middle)
    return float((low * high) ** 0.5)


def median_of_seeds(job: Callable[[int], dict[str, float]], loss: float) -> dict[str, float]:
    """Medians of simulations with several seeds; one is sufficient without losses."""
    runs = [job(seed) for seed in range(15 if loss else 1)]
    return {name: float(np.median([run[name] for run in runs])) for name in runs[0]}


def measure_decoding(bundle: nf.stream.Bundle, repeat: int) -> float:
    """Megabytes per second of decoding, uploads and frames, from loads over the fast link."""
    with open_connection(FAST, bundle) as (way, chromium, url):
        # The first load of a browser also compiles its shaders.
        loads = [load(way, chromium, url, bundle, "clovrd") for _ in range(repeat + 1)][1:]
    return fit_decoding(bundle, loads)


@contextmanager
def open_connection(link: nf.stream.Link, bundle: nf.stream.Bundle) -> Iterator[tuple[Network, Any, str]]:
    """Open a link, a browser at its end, and serve a bundle behind it; yield them with the address."""
    with (
        network(link, real=True) as way,
        way.serve_bundle(Path(bundle._reader.place)) as url,
        way.browser(url) as chromium,
    ):
        yield way, chromium, url


def requests_alone(place: str, bundle: nf.stream.Bundle, loss: float, repeat: int) -> Iterator[Outcome]:
    """Measure the requests of all strategies over a link with losses."""
    link = replace(LINK, loss=loss)
    with ahead_of_others(), open_connection(link, bundle) as (way, chromium, url):
        trip = round_trip(way, chromium, url, bundle)
        print(f"{place}: {way.name}; a round trip of a request takes {trip:.1f} ms")
        ours = replace(content(link), rtt_ms=trip)
        for strategy in STRATEGIES:
            # Requests of clovr wait for cross-fades, which need frames; until the second ring they equal those of
            # clovrd.
            if strategy == "clovr":
                continue
            alone = [requests(way, chromium, url, bundle, strategy) for _ in range(repeat)]
            yield Outcome(
                place,
                loss,
                strategy,
                real=[{name: {"received": seconds} for name, seconds in one.items()} for one in alone],
                simulated=median_of_seeds(partial(simulated_requests, bundle, ours, strategy), loss),
            )
        print(way.real and way.real.counts())


def loads(place: str, bundle: nf.stream.Bundle, loss: float, repeat: int, mbs: float) -> Iterator[Outcome]:
    """Measure loads of the page by all strategies over a link with losses."""
    link = replace(LINK, loss=loss)
    with open_connection(link, bundle) as (way, chromium, url):
        print(f"{place}: {way.name}; decoding, uploads and frames like {mbs:.2f} MB/s")
        load(way, chromium, url, bundle, "clovrd")
        for strategy in STRATEGIES:
            found = [load(way, chromium, url, bundle, strategy) for _ in range(repeat)]
            yield Outcome(
                place,
                loss,
                strategy,
                real=[{name: getattr(one, name) for name in STAGES} for one in found],
                simulated=median_of_seeds(partial(simulate_stages, bundle, link, strategy, decode_mbs=mbs), loss),
                megabytes=float(np.median([one.bytes for one in found])) / 1e6,
            )


def link_table(found: list[Outcome]) -> str:
    """Table of the link alone."""
    rows = []
    for one in found:
        pairs = [(one.median(name, "received"), one.simulated[name]) for name in STAGES]
        times = (value for real, ours in pairs for value in (real, ours, ours / real))
        rows.append([one.place, one.loss, one.strategy, *times])
    kinds = (", real {:.3f}", ", sim. {:.3f}", ", ratio {:.2f}")
    stages = (f"{name}{kind}" for name in ("picture", "first ring", "all") for kind in kinds)
    return table("Seconds until the files were there, requests alone", ["", "lost {:.0%}", "", *stages], rows)


def page_table(found: list[Outcome]) -> str:
    """Table of the page."""
    rows: list[list[object]] = []
    for one in found:
        rows.append([one.place, one.loss, one.strategy, one.megabytes])
        for name in STAGES:
            rows[-1].append(tuple(one.median(name, kind) for kind in KINDS))
            rows[-1].append((one.simulated[name], one.simulated[name] / one.median(name, "ready")))
    header = " | lost {:.0%} |  | MB {:.2f}"
    for name in ("picture", "first ring", "all"):
        header += f" | {name} {{:.2f}} / {{:.2f}} / {{:.2f}} | sim. {{:.2f}} ({{:.2f}})"
    title = "Seconds until received / ready / shown, and simulated until ready with its ratio to real"
    return table(title, header, rows)


def main() -> None:
    given = start(
        __doc__,
        "--quick",
        repeat=(5, "loads of each; the medians are printed"),
        loss=([0.0, 0.01], "shares of packets that are lost"),
        link_only=(bool, "requests without the page"),
        place=("", "places whose names have this in them, such as factory"),
        json=(Path, "file for all figures"),
    )
    if reason := no_link():
        sys.exit(reason)
    alone, whole = list[Outcome](), list[Outcome]()
    for place in (place for place in all_places(given.quick) if given.place in place.name):
        with folder_or_temporary() as folder:
            bundle = nf.stream.export(place.make(), folder / "bundle", center=place.center, by_footprint=True)
            for loss in given.loss:
                alone += requests_alone(place.name, bundle, loss, given.repeat)
            if not given.link_only:
                mbs = measure_decoding(bundle, given.repeat)
                for loss in given.loss:
                    whole += loads(place.name, bundle, loss, given.repeat, mbs)
        print(f"1-minute load of the machine: {os.getloadavg()[0]:.1f}", flush=True)
        if given.json:
            figures = {"requests": [asdict(one) for one in alone], "page": [asdict(one) for one in whole]}
            given.json.write_text(json.dumps(figures, indent=1) + "\n")
    print(link_table(alone))
    if whole:
        print(page_table(whole))


if __name__ == "__main__":
    main()
