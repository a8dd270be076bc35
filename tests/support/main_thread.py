"""Counts work on a page's main thread for arriving rings, frame by frame, besides drawing."""

from __future__ import annotations

from typing import Any

COUNT = """() => {
  const counts = { frames: [], posts: 0, messages: 0, bytes: 0, mostBytes: 0, longTasks: [] };
  window.mainThread = counts;
  const post = Worker.prototype.postMessage;
  Worker.prototype.postMessage = function (...more) {
    const start = performance.now();
    post.apply(this, more);
    counts.posts += performance.now() - start;
  };
  const { get, set } = Object.getOwnPropertyDescriptor(Worker.prototype, 'onmessage');
  Object.defineProperty(Worker.prototype, 'onmessage', {
    get,
    set(work) {
      set.call(this, (event) => {
        const start = performance.now();
        work.call(this, event);
        // Code that waits for the answer goes on in microtasks, which this outlasts.
        let left = 20;
        const last = () => (left-- > 0 ? queueMicrotask(last) : (counts.messages += performance.now() - start));
        last();
      });
    },
  });
  const kinds = WebGL2RenderingContext.prototype;
  for (const [name, sizeOf] of [
    ['bufferData', (more) => more[1]?.byteLength ?? 0],
    ['bufferSubData', (more) => more[2]?.byteLength ?? 0],
    ['texSubImage2D', ([...more]) => {
      const data = more.at(-1);
      return data instanceof ImageBitmap ? 4 * data.width * data.height : (data?.byteLength ?? 0);
    }],
  ]) {
    const call = kinds[name];
    kinds[name] = function (...more) {
      counts.bytes += sizeOf(more);
      counts.mostBytes = Math.max(counts.mostBytes, sizeOf(more));
      return call.apply(this, more);
    };
  }
  new PerformanceObserver((list) => {
    for (const { duration } of list.getEntries()) counts.longTasks.push(duration);
  }).observe({ type: 'longtask' });
}"""

START = """(pose) => {
  const { viewer } = window.nearfar;
  const counts = window.mainThread;
  let before = { posts: counts.posts, messages: counts.messages };
  let bytes = counts.bytes;
  viewer.renderer.setAnimationLoop(() => {
    const isFirst = viewer.facts.arrived < 0;
    const programs = viewer.renderer.info.programs.length;
    bytes = counts.bytes;
    viewer.frame(pose, 1 / 72);
    const { upload, arrived } = viewer.facts;
    const waited = counts.posts - before.posts + counts.messages - before.messages;
    before = { posts: counts.posts, messages: counts.messages };
    const compiled = viewer.renderer.info.programs.length - programs;
    counts.frames.push({ upload, waited, bytes: counts.bytes - bytes, arrived, isFirst, compiled });
  });
}"""


def count(page: Any) -> None:
    """Start counting; must be called before the page is opened."""
    page.add_init_script(f"({COUNT})()")


def drive(page: Any, pose: dict[str, Any]) -> None:
    """Draw frames for a pose as fast as the page can, 1/72 s each on its clock."""
    page.evaluate(START, pose)


def read_counters(page: Any) -> dict[str, Any]:
    """All frames since `drive`: milliseconds of uploads and of messages, and bytes that went to the GPU."""
    return dict(page.evaluate("() => window.mainThread"))
