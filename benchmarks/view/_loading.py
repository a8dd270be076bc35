"""Frames of the page while a bundle loads."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from benchmarks.harness.loads import Network
from benchmarks.stream._loaded import Bundle, plan, show
from nearfar.stream._strategies import Strategy

WINDOW = 0.5
"""Length of the window of a rate, seconds."""

# The head turns by 15 degrees per second. A frame is its start time and the ring shown, -1 for none.
WATCH = """(() => {
  const frames = [];
  window.loadFrames = frames;
  const watch = (now) => {
    const { nearfar } = window;
    if (nearfar) {
      frames.push([now, nearfar.viewer.facts.shown?.ring ?? -1]);
      nearfar.setPose({ ...nearfar.pose, yaw: ((now - frames[0][0]) / 1000) * Math.PI / 12, pitch: 0 });
    }
    requestAnimationFrame(watch);
  };
  requestAnimationFrame(watch);
})()"""


@dataclass(frozen=True)
class Loading:
    """A load, from the first frame until the last ring is shown."""

    seconds: float
    picture: float
    """Seconds until the first picture."""
    rates: list[float]
    """Frames per second in each window."""
    longest_ms: float
    """Duration of the longest frame."""


def rates(begins: Sequence[float]) -> list[float]:
    """Frames per second in windows, from the start times of frames, seconds; the last window is complete."""
    times = np.array(begins) - begins[0]
    counts = np.bincount((times / WINDOW).astype(int))[: max(int(times[-1] / WINDOW), 1)]
    return [*map(float, counts / WINDOW)]


def loading(connection: Network, chromium: Any, url: str, bundle: Bundle, strategy: Strategy, size: Any) -> Loading:
    """Open a bundle's page by a strategy, and watch until everything is shown."""
    last = len(plan(bundle, strategy).radii)
    with connection.page(chromium, size) as page:
        page.add_init_script(WATCH)
        show(page, url, strategy, last)
        frames = page.evaluate("() => window.loadFrames")
    times = [now / 1e3 for now, _ in frames]
    first = next(now / 1e3 for now, ring in frames if ring >= 0)
    # The last frame may be the one that shows the last ring.
    end = next((index for index, (_, ring) in enumerate(frames) if ring >= last), len(frames) - 1)
    times = times[: end + 1]
    return Loading(times[-1] - times[0], first - times[0], rates(times), float(np.diff(times).max(initial=0.0)) * 1e3)
