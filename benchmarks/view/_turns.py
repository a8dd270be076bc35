"""A head that turns once in a page, and the times of its frames."""

from __future__ import annotations

import base64
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tests.support.browser import open_page, wait_until

SECTORS = 12
"""Number of sectors of a turn; each has a separate rate."""

# The page's viewer with the interface of `_full.mjs`.
ADAPT_PAGE = """([position]) => {
  const { nearfar } = window;
  const { viewer } = nearfar;
  const { info } = viewer.renderer;
  const { frame } = viewer;
  const rates = {
    gl: viewer.renderer.getContext(),
    script: [],
    triangles: [],
    look: (yaw) => nearfar.setPose({ position, yaw, pitch: 0 }),
    draw: (yaw) => viewer.frame({ position, yaw, pitch: 0 }, 0.01),
  };
  info.autoReset = false;
  viewer.frame = (pose, seconds) => {
    info.reset();
    const start = performance.now();
    frame(pose, seconds);
    rates.script.push(performance.now() - start);
    rates.triangles.push(info.render.triangles);
  };
  window.rates = rates;
}"""

COMPLETE = """() => {
  const { shown, entry } = window.nearfar?.viewer.facts ?? {};
  return Boolean(shown) && shown.ring === entry.rings.length - 1 && !shown.fading && shown.grown.strength === 1;
}"""

TURN = """async ([seconds, isWaitedFor]) => {
  const { gl, look, draw, script, triangles } = window.rates;
  script.length = triangles.length = 0;
  const fullTurn = 2 * Math.PI;
  const frames = [];
  const begin = performance.now();
  const next = () => {
    const now = performance.now();
    const yaw = (fullTurn * (now - begin)) / 1000 / seconds;
    frames.push([yaw, now]);
    return yaw;
  };
  if (isWaitedFor) {
    const pixel = new Uint8Array(4);
    for (let yaw = next(); yaw < fullTurn; yaw = next()) {
      draw(yaw);
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    }
  } else {
    await new Promise((done) => {
      const step = () => {
        const yaw = next();
        if (yaw >= fullTurn) return done();
        look(yaw);
        requestAnimationFrame(step);
      };
      requestAnimationFrame(step);
    });
  }
  const mean = (values) => values.reduce((sum, each) => sum + each, 0) / values.length;
  return { frames, script: mean(script), triangles: mean(triangles) };
}"""

PHOTO = """() => {
  const { gl, draw } = window.rates;
  draw(0);
  return gl.canvas.toDataURL('image/jpeg', 0.85).split(',')[1];
}"""

RENDERER = """() => {
  const { gl } = window.rates;
  const known = gl.getExtension('WEBGL_debug_renderer_info');
  return gl.getParameter(known ? known.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
}"""


@dataclass(frozen=True)
class Turn:
    """A turn of the head."""

    shown: list[float]
    """Frames per second of each sector, as displayed by the browser."""
    waited: list[float]
    """The same with each frame drawn and waited for, but not displayed."""
    script: float
    """Milliseconds per frame of the page's script."""
    triangles: float
    """Mean number of triangles drawn per frame."""


def rates(frames: Sequence[tuple[float, float]]) -> NDArray[np.float64]:
    """Frames per second in each sector of a turn, from the angle and the start time in milliseconds of each frame."""
    yaw, time = np.array(frames).T
    sector = (yaw[:-1] / (2.0 * np.pi) * SECTORS).astype(int)
    counts = np.bincount(sector, minlength=SECTORS)
    seconds = np.bincount(sector, np.diff(time) / 1e3, SECTORS)
    return np.asarray(counts[counts > 0] / seconds[counts > 0])


def measure_turn(page: Any, seconds: float) -> Turn:
    """Turn the head twice: frames are displayed, then, in half the time, waited for."""
    shown, waited = page.evaluate(TURN, [seconds, False]), page.evaluate(TURN, [seconds / 2.0, True])
    return Turn(
        [*map(float, rates(shown["frames"]))],
        [*map(float, rates(waited["frames"]))],
        shown["script"],
        shown["triangles"],
    )


def renderer(page: Any) -> str:
    return str(page.evaluate(RENDERER))


def photo(page: Any, path: Path) -> None:
    path.write_bytes(base64.b64decode(page.evaluate(PHOTO)))


@contextmanager
def open_bundle(chromium: Any, url: str, size: tuple[int, int], eye: Sequence[float]) -> Iterator[Any]:
    """Open a bundle's page, completely loaded, for a user at a place."""
    with open_page(chromium, *size) as page:
        # Growth would take a while.
        page.goto(f"{url}?strategy=clovrd")
        wait_until(page, lambda: page.evaluate(COMPLETE))
        page.evaluate(ADAPT_PAGE, [list(eye)])
        yield page


@contextmanager
def open_full_scene(chromium: Any, url: str, size: tuple[int, int]) -> Iterator[Any]:
    with open_page(chromium, *size) as page:
        page.goto(url)
        wait_until(page, lambda: page.evaluate("() => Boolean(window.rates)"))
        yield page
