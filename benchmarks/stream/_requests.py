"""The page's requests without its decoding and drawing: the same files in the same order, by the same browser."""

from __future__ import annotations

from typing import Any

import numpy as np

import nearfar as nf
from benchmarks.harness.loads import Network
from benchmarks.stream._loaded import SIZE, files_until, plan, stages
from nearfar.stream._strategies import Strategy

# Six at a time, with the next step's requested ahead, as in web/src/show/loader.ts.
REPLAY = """async (steps) => {
  const begin = performance.now();
  const times = {};
  const waiting = [];
  let open = 0;
  const next = () => {
    while (open < 6 && waiting.length) {
      open++;
      waiting.shift()();
    }
  };
  const fetched = async (name) => {
    await new Promise((done) => { waiting.push(done); next(); });
    const answer = await fetch(name);
    if (!answer.ok) throw new Error(`${name}: ${answer.status}`);
    await answer.arrayBuffer();
    times[name] = (performance.now() - begin) / 1000;
    open--;
    next();
  };
  const asked = new Map();
  const get = (name) => {
    if (!asked.has(name)) asked.set(name, fetched(name));
    return asked.get(name);
  };
  await get('manifest.json');
  for (const [place, step] of steps.entries()) {
    const own = step.asked.map(get);
    const after = steps[place + 1];
    if (after?.isAhead) after.files.forEach(get);
    await Promise.all(own);
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


def round_trip(way: Network, chromium: Any, url: str, bundle: nf.stream.Bundle) -> float:
    """Milliseconds from a request to its short response on the idle link, including browser and server."""
    files = bundle._manifest["files"]
    least = min(files, key=lambda name: int(files[name]["bytes"]))
    with way.page(chromium, SIZE) as page:
        page.goto(f"{url}NOTHING")
        return float(np.median(page.evaluate(TRIPS, least)))


def requests(way: Network, chromium: Any, url: str, bundle: nf.stream.Bundle, strategy: Strategy) -> dict[str, float]:
    """Seconds from the request of the manifest until the files of each stage had arrived."""
    steps = plan(bundle, strategy)
    given = [{"asked": step.requests, "files": step.files, "isAhead": step.is_ahead} for step in steps.steps]
    with way.page(chromium, SIZE) as page:
        # An address of the server without scripts; the connection stays open.
        page.goto(f"{url}NOTHING")
        times = page.evaluate(REPLAY, given)
    return {
        name: max(times[file] for file in files_until(steps, ring))
        for name, ring in stages(strategy, len(steps.radii)).items()
    }


def simulated_requests(
    bundle: nf.stream.Bundle, link: nf.stream.Link, strategy: Strategy, seed: int
) -> dict[str, float]:
    """The same for a simulated load from `nearfar serve`, without decoding."""
    line = nf.stream.simulate(bundle, link=link, strategy=strategy, gzip=True, seed=seed)
    # The first connection is already open.
    times = dict(zip(line.files, (line.file_times - link.handshake * link.rtt).tolist(), strict=True))
    steps = plan(bundle, strategy)
    return {
        name: max(times[file] for file in files_until(steps, ring))
        for name, ring in stages(strategy, len(steps.radii)).items()
    }
