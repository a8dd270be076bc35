"""Times of one load of the page: from its own marks, and from the browser's resource timing."""

from __future__ import annotations

import time
from dataclasses import dataclass
from typing import Any

import nearfar as nf
from benchmarks.harness.loads import Network
from nearfar.stream._strategies import Plan, Strategy, plan_of
from tests.support.reader_cases import SECONDS

SIZE = (320, 200)
"""Size of the picture in pixels: small, because it is drawn in software."""

# Browsers store the times of 250 files by default.
BEFORE = "performance.setResourceTimingBufferSize(100000)"

DONE = """(last) => {
  const problem = document.querySelector('#message').textContent;
  const marks = performance.getEntriesByName('nearfar:shown').map((mark) => mark.detail.ring);
  return problem || (Math.max(-1, ...marks) >= last ? 'done' : '');
}"""

TOLD = """() => ({
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


def plan(bundle: nf.stream.Bundle, strategy: Strategy) -> Plan:
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
    while (found := page.evaluate(DONE, last)) != "done":
        if found or time.monotonic() > deadline:
            raise RuntimeError(f"{strategy}: {found or 'the last ring does not come'}")
        time.sleep(0.25)


def load(way: Network, chromium: Any, url: str, bundle: nf.stream.Bundle, strategy: Strategy) -> Loaded:
    """Open the page by a strategy and wait until all is shown."""
    steps = plan(bundle, strategy)
    last = len(steps.radii)
    with way.page(chromium, SIZE) as page:
        page.add_init_script(BEFORE)
        show(page, url, strategy, last)
        told = page.evaluate(TOLD)
    return _loaded(told, steps, strategy, last)


def _loaded(told: dict[str, Any], steps: Plan, strategy: Strategy, last: int) -> Loaded:
    files = {file["url"].partition("?")[0]: file for file in told["files"]}
    manifest = next(file for url, file in files.items() if url.endswith("/manifest.json"))
    start = manifest["begin"]
    base = manifest["url"].removesuffix("manifest.json")

    def received(ring: int) -> float:
        return max(float(files[base + name]["end"]) for name in files_until(steps, ring))

    def first(event: str, ring: int) -> float:
        return min(float(mark["time"]) for mark in told["marks"] if mark["event"] == event and mark["ring"] >= ring)

    times = {
        name: {
            kind: (at - start) / 1e3
            for kind, at in (
                ("received", received(ring)),
                ("ready", first("arrived", ring)),
                ("shown", first("shown", ring)),
            )
        }
        for name, ring in stages(strategy, last).items()
    }
    own = [file for file in told["files"] if file["begin"] >= start]
    return Loaded(**times, bytes=sum(file["bytes"] for file in own), protocol=manifest["protocol"], page=start / 1e3)
