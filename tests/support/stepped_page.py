"""The page on a clock that the test steps: frames for given poses and times, independent of the browser's rate."""

from __future__ import annotations

import base64
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tests.support.browser import LOOKS, wait_until

STOP = "() => window.nearfar.viewer.renderer.setAnimationLoop(null)"

FRAME = """([pose, seconds, isRead]) => {
  const { viewer } = window.nearfar;
  viewer.frame(pose, seconds);
  const { renderer, facts } = viewer;
  const { regions, region, leaving, goal, isLoading, arrived, shown, kept, shared } = facts;
  const told = { regions, region, leaving, goal, isLoading, arrived, shown, kept, shared };
  if (!isRead) return [told, null];
  const gl = renderer.getContext();
  const [width, height] = [gl.drawingBufferWidth, gl.drawingBufferHeight];
  const pixels = new Uint8Array(4 * width * height);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  let text = '';
  for (let n = 0; n < pixels.length; n += 32768) text += String.fromCharCode(...pixels.subarray(n, n + 32768));
  return [told, btoa(text)];
}"""


PAUSE = 50
"""Milliseconds between frames while something loads."""


class SteppedPage:
    """A page that draws frames on the test's request."""

    def __init__(self, page: Any) -> None:
        self.page = page
        wait_until(page, lambda: page.evaluate("() => Boolean(window.nearfar)"))
        page.evaluate(STOP)

    def frame(self, pose: dict[str, Any], seconds: float) -> dict[str, Any]:
        """Draw a frame some seconds after the previous one; returns the page's state."""
        return dict(self.page.evaluate(FRAME, [pose, seconds, False])[0])

    def picture(self, pose: dict[str, Any], seconds: float) -> tuple[dict[str, Any], NDArray[np.uint8]]:
        """Draw a frame; returns the state and its pixels (H, W, 3), sRGB."""
        told, data = self.page.evaluate(FRAME, [pose, seconds, True])
        size = self.page.viewport_size
        pixels = np.frombuffer(base64.b64decode(data), np.uint8).reshape(size["height"], size["width"], 4)
        return told, pixels[::-1, :, :3].copy()

    def load(self, pose: dict[str, Any], seconds: float) -> dict[str, Any]:
        """Draw frames of some seconds each until nothing loads; returns the page's state then."""
        for _ in range(LOOKS):
            told = self.frame(pose, seconds)
            if not told["isLoading"]:
                assert self.page.evaluate("() => document.querySelector('#message').textContent") == ""
                return told
            # Drawing in software takes cores from the workers that decode.
            self.page.wait_for_timeout(PAUSE)
        raise AssertionError(f"loading does not end: {self.page.printed}")


COUNT = """() => {
  const live = {};
  const kinds = WebGL2RenderingContext.prototype;
  for (const kind of ['Texture', 'Buffer', 'VertexArray', 'Program', 'Framebuffer']) {
    const [make, drop] = [kinds[`create${kind}`], kinds[`delete${kind}`]];
    live[kind] = 0;
    kinds[`create${kind}`] = function (...more) {
      live[kind] += 1;
      return make.apply(this, more);
    };
    kinds[`delete${kind}`] = function (object) {
      if (object) live[kind] -= 1;
      return drop.call(this, object);
    };
  }
  const { linkProgram } = kinds;
  window.linkedPrograms = 0;
  kinds.linkProgram = function (program) {
    window.linkedPrograms += 1;
    linkProgram.call(this, program);
  };
  window.liveObjects = live;
}"""


def count_objects(page: Any) -> None:
    """Count the page's WebGL objects and programs; must be called before it is opened."""
    page.add_init_script(f"({COUNT})()")


def objects(page: Any) -> dict[str, int]:
    """WebGL objects that are not deleted, and the counts reported by three.js."""
    return dict(
        page.evaluate("""() => {
          const { memory, programs } = window.nearfar.viewer.renderer.info;
          return { ...window.liveObjects, ...memory, programs: programs.length };
        }""")
    )


def linked(page: Any) -> int:
    """Programs that the page has linked, deleted or not."""
    return int(page.evaluate("() => window.linkedPrograms"))


def heap(page: Any) -> int:
    """Bytes of the page's own objects and arrays after a collection."""
    session = page.context.new_cdp_session(page)
    try:
        for _ in range(3):
            session.send("HeapProfiler.collectGarbage")
        usage = session.send("Runtime.getHeapUsage")
    finally:
        session.detach()
    return int(usage["usedSize"] + usage.get("backingStorageSize", 0))
