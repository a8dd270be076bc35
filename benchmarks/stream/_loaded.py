"""Times of one load of the page, by its own marks and the browser's resource timing, and of its requests alone.

Requests alone fetch the same files in the same order in the same browser, without decoding and drawing.
"""

from __future__ import annotations

import time
from dataclasses import dataclass
from typing import Any

import numpy as np

import nearfar as nf
from benchmarks.harness.loads import Network
from nearfar.stream._strategies import Plan, Strategy, plan_of
from tests.support.reader_cases import SECONDS

Bundle = nf.stream.Bundle

SIZE = (320, 200)
"""Size of the picture in pixels: small, because it is drawn in software."""

# Browsers store the times of 250 files by default.
BEFORE = "performance.setResourceTimingBufferSize(100000)"

DONE = """(last) => {
  const problem = document.querySelector('#message').textContent;
  const marks = performance.getEntriesByName('nearfar:shown').map((mark) => mark.detail.ring);
  return problem || (Math.max(-1, ...marks) >= last ? 'done' : '');
}"""

REPORT = """() => ({
  marks: performance.getEntriesByType('mark').filter(({ name }) => name.startsWith('nearfar:'))
    .map(({ name, startTime, detail }) => ({ event: name.slice(8), time: startTime, ring: detail.ring })),
  files: performance.getEntriesByType('resource').map((entry) => ({
    url: entry.name, begin: entry.fetchStart, end: entry.responseEnd,
    bytes: entry.transferSize, protocol: entry.nextHopProtocol,
  })),
})"""


@dataclass(frozen=True)
class Loaded:
    """A load; all times are in seconds since the request of the manifest."""

    picture: dict[str, float]
    """First complete picture: when the last of its bytes had arrived (`received`), when all was decoded and on the GPU
    (`ready`), and when the frame that showed it began (`shown`)."""
    first_ring: dict[str, float]
    """The same for the first near geometry."""
    total: dict[str, float]
    """The same for everything."""
    bytes: int
    """Bytes of all files since the manifest, with headers."""
    protocol: str
    """HTTP protocol, as named by browsers."""
    page: float
    """Seconds from navigation to the request of the manifest, spent on the page itself."""


def stages(strategy: Strategy, last: int) -> dict[str, int]:
    """Numbers of the rings that complete the picture, the first near geometry and everything."""
    picture = 0 if strategy.startswith("clovr") else last
    return {"picture": picture, "first_ring": last if strategy == "vis0" else 1, "total": last}


def plan(bundle: Bundle, strategy: Strategy) -> Plan:
    return plan_of(strategy, bundle._region, bundle.number, bundle._manifest["dynamic"])


def files_until(steps: Plan, ring: int) -> set[str]:
    """Files that the page has requested and needs for a ring."""
    names = set[str]()
    for step in steps.steps:
        if step.ring is not None and step.ring > ring:
            break
        # Dynamic objects follow ring 0, which does not wait for them.
        if step.ring is not None or ring > 0:
            names |= set(step.files)
    return names


def show(page: Any, url: str, strategy: Strategy, last: int) -> None:
    """Open a bundle's page by a strategy, and wait until the last ring is shown."""
    page.goto(f"{url}?strategy={strategy}")
    deadline = time.monotonic() + SECONDS
    while (state := page.evaluate(DONE, last)) != "done":
        if state or time.monotonic() > deadline:
            raise RuntimeError(f"{strategy}: {state or 'the last ring does not come'}")
        time.sleep(0.25)


def load(network: Network, chromium: Any, url: str, bundle: Bundle, strategy: Strategy) -> Loaded:
    """Open the page by a strategy and wait until all is shown."""
    steps = plan(bundle, strategy)
    last = len(steps.radii)
    with network.page(chromium, SIZE) as page:
        page.add_init_script(BEFORE)
        show(page, url, strategy, last)
        report = page.evaluate(REPORT)
    return _loaded(report, steps, strategy, last)


def _loaded(report: dict[str, Any], steps: Plan, strategy: Strategy, last: int) -> Loaded:
    files = {file["url"].partition("?")[0]: file for file in report["files"]}
    manifest = next(file for url, file in files.items() if url.endswith("/manifest.json"))
    start = manifest["begin"]
    base = manifest["url"].removesuffix("manifest.json")

    def received(ring: int) -> float:
        return max(float(files[base + name]["end"]) for name in files_until(steps, ring))

    def first(event: str, ring: int) -> float:
        return min(float(mark["time"]) for mark in report["marks"] if mark["event"] == event and mark["ring"] >= ring)

    times = {}
    for name, ring in stages(strategy, last).items():
        moments = {"received": received(ring), "ready": first("arrived", ring), "shown": first("shown", ring)}
        times[name] = {kind: (moment - start) / 1e3 for kind, moment in moments.items()}
    size = sum(file["bytes"] for file in report["files"] if file["begin"] >= start)
    return Loaded(**times, bytes=size, protocol=manifest["protocol"], page=start / 1e3)


# requests alone -------------------------------------------------------------------------------------------------------
# Six at a time, with the next step's requested ahead, as in web/src/show/loader.ts.
REPLAY = """async (steps) => {
  const begin = performance.now();
  const times = {};
  const waiting = [];
  let open = 0;
  const startWaiting = () => {
    while (open < 6 && waiting.length) {
      open++;
      waiting.shift()();
    }
  };
  const load = async (name) => {
    await new Promise((done) => { waiting.push(done); startWaiting(); });
    const response = await fetch(name);
    if (!response.ok) throw new Error(`${name}: ${response.status}`);
    await response.arrayBuffer();
    times[name] = (performance.now() - begin) / 1000;
    open--;
    startWaiting();
  };
  const loads = new Map();
  const get = (name) => {
    if (!loads.has(name)) loads.set(name, load(name));
    return loads.get(name);
  };
  await get('manifest.json');
  for (const [number, step] of steps.entries()) {
    const loading = step.requests.map(get);
    const next = steps[number + 1];
    if (next?.isAhead) next.files.forEach(get);
    await Promise.all(loading);
  }
  return times;
}"""


# A file that fits into a packet, fetched repeatedly.
TRIPS = """async (name) => {
  const times = [];
  for (let trip = 0; trip < 21; trip++) {
    const begin = performance.now();
    await (await fetch(name, { cache: 'no-store' })).arrayBuffer();
    times.push(performance.now() - begin);
  }
  return times;
}"""


def by_stage(times: dict[str, float], steps: Plan, strategy: Strategy) -> dict[str, float]:
    """Time of the last file of each stage."""
    rings = stages(strategy, len(steps.radii))
    return {name: max(times[file] for file in files_until(steps, ring)) for name, ring in rings.items()}


def round_trip(network: Network, chromium: Any, url: str, bundle: Bundle) -> float:
    """Milliseconds from a request to its short response on the idle link, including browser and server."""
    files = bundle._manifest["files"]
    smallest = min(files, key=lambda name: int(files[name]["bytes"]))
    with network.page(chromium, SIZE) as page:
        page.goto(f"{url}NOTHING")
        return float(np.median(page.evaluate(TRIPS, smallest)))


def requests(network: Network, chromium: Any, url: str, bundle: Bundle, strategy: Strategy) -> dict[str, float]:
    """Seconds from the request of the manifest until the files of each stage had arrived."""
    steps = plan(bundle, strategy)
    replayed = [
        {"requests": step.requests, "files": step.files, "isAhead": step.may_be_prefetched} for step in steps.steps
    ]
    with network.page(chromium, SIZE) as page:
        # An address of the server without scripts; the connection stays open.
        page.goto(f"{url}NOTHING")
        return by_stage(page.evaluate(REPLAY, replayed), steps, strategy)


def simulated_requests(bundle: Bundle, link: nf.stream.Link, strategy: Strategy, seed: int) -> dict[str, float]:
    """The same for a simulated load from `nearfar serve`, without decoding."""
    line = nf.stream.simulate(bundle, link=link, strategy=strategy, gzip=True, seed=seed)
    # The first connection is already open.
    times = dict(zip(line.files, (line.file_times - link.handshake * link.rtt).tolist(), strict=True))
    return by_stage(times, plan(bundle, strategy), strategy)
