"""Milliseconds per frame of the page's main thread for decoding and uploads while a bundle loads.

The times of a frame are between marks in Chromium's trace around its uploads and around the responses of workers since
the previous frame. Drawing is not included. Wall time includes the share of other programs on the same cores, such as
Chromium's GPU process.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness.loads import network
from benchmarks.harness.report import folder_or_temporary, start, table
from tests.support.browser import open_page, started, wait_for_ring, wait_until

LINK = nf.stream.Link(50, rtt_ms=20)
CENTER = (0.0, 1.3, 0.0)
MAX = 4.0
"""Maximum milliseconds per frame for decoding and uploads."""

MARKS = """(() => {
  const { get, set } = Object.getOwnPropertyDescriptor(Worker.prototype, 'onmessage');
  Object.defineProperty(Worker.prototype, 'onmessage', { get, set(work) { set.call(this, (event) => {
    performance.mark('answer>');
    work.call(this, event);
    // Code that waits for the answer goes on in microtasks, which this outlasts.
    let left = 20;
    const last = () => (left-- > 0 ? queueMicrotask(last) : performance.mark('answer<'));
    last();
  }); } });
  let known;
  Object.defineProperty(window, 'nearfar', { configurable: true, get: () => known, set(found) {
    known = found;
    const { uploads } = found.viewer;
    const { run } = uploads;
    uploads.run = (milliseconds) => {
      performance.mark('frame>');
      const taken = run(milliseconds);
      performance.mark('frame<');
      return taken;
    };
  } });
})()"""

TRACED = {"recordMode": "recordContinuously", "includedCategories": ["blink.user_timing"], "excludedCategories": ["*"]}


def trace(url: str, last: int) -> list[dict[str, Any]]:
    """Marks of a load until the last ring is loaded, in order."""
    with started() as program, open_page(program, 640, 400) as page:
        session = program.new_browser_cdp_session()
        events: list[dict[str, Any]] = []
        ended: list[Any] = []
        session.on("Tracing.dataCollected", lambda told: events.extend(told["value"]))
        session.on("Tracing.tracingComplete", lambda told: ended.append(told))
        session.send("Tracing.start", {"transferMode": "ReportEvents", "traceConfig": TRACED})
        page.add_init_script(MARKS)
        page.goto(url)
        problem = wait_for_ring(page, last)
        session.send("Tracing.end")
        wait_until(page, lambda: ended)
        if problem or page.printed:
            raise RuntimeError(f"the page does not load: {problem or page.printed}")
    return sorted((event for event in events if event["name"][-1] in "<>"), key=lambda event: event["ts"])


def frames(marks: list[dict[str, Any]]) -> NDArray[np.float64]:
    """Wall and CPU milliseconds (N, 2) of frames with work, including the responses before each frame."""
    work_frames, starts, sums = [], {}, np.zeros(2)
    for mark in marks:
        name, end = mark["name"][:-1], mark["name"][-1]
        now = np.array([mark["ts"], mark["tts"]]) / 1e3
        if end == ">":
            starts[name] = now
            continue
        sums += now - starts.pop(name)
        if name == "frame":
            work_frames.append(sums)
            sums = np.zeros(2)
    rows = np.array(work_frames)
    # A frame without work takes some microseconds.
    return np.asarray(rows[rows[:, 0] > 0.1])


def row(name: str, values: NDArray[np.float64]) -> list[object]:
    """Count, median, 99th percentile, maximum, and number above `MAX`."""
    return [name, len(values), *np.percentile(values, (50, 99, 100)), int((values > MAX).sum())]


def main() -> None:
    scene_of = (Path, "another scene, seen from 1 m beside its middle")
    options = start(__doc__, "--quick", scene=scene_of, repeat=(3, "loads"))
    if options.scene:
        scene = nf.Scene.load(options.scene)
        x, y, z = scene.bounds.mean(axis=0)
        center = (x + 1.0, y, z)
    else:
        scene, center = nf.datasets.city(blocks=2 if options.quick else 3, detail=0 if options.quick else 2), CENTER
    with folder_or_temporary() as folder, network(LINK, real=False) as connection:
        bundle = nf.stream.export(scene, folder / "bundle", center=center)
        nf.view.write_page(folder / "bundle")
        with connection.serve_files(folder) as url:
            loads = [frames(trace(f"{url}bundle/", bundle.count)) for _ in range(options.repeat)]
    wall, cpu = np.concatenate(loads).T
    header = f" | frames | median {{:.2f}} | 99 % {{:.2f}} | most {{:.2f}} | above {MAX:g} ms"
    title = f"ms a frame for decoding and uploads, {options.repeat} loads"
    print(table(title, header, [row("wall", wall), row("CPU of the main thread", cpu)]))


if __name__ == "__main__":
    main()
