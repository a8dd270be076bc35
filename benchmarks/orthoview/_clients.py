"""Viewers in one Chromium that fly the same route: the page of trees, 3d-tiles-renderer and Spark."""

from __future__ import annotations

import base64
import json
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.orthoview._gate import Gate
from benchmarks.orthoview.export import cells_of
from nearfar.orthoview import _spz
from nearfar.orthoview._grid import Place
from nearfar.view._tree import tree_page
from tests.support.page_pictures import camera
from tests.support.reader_cases import FOLDER

PEERS = Path(__file__).parent / "peers"
LIGHT = Path(__file__).resolve().parents[2] / "web" / "src" / "shaders" / "light.ts"
SIZE = (640, 480)
ANGLE = 60.0
"""Vertical field of view, degrees: that of the page."""
CLIENTS = {"nearfar": "&geometry=1", "nearfar, splats": "&geometry=0", "3d-tiles-renderer": "tiles", "Spark": "spark"}
"""Query of each viewer's address: the page with near leaves as geometry or all as splats, and the other viewers."""
QUIET = 5.0
"""Seconds without a received byte or a change after which a client counts as finished."""

FLY = """async ([poses, cuts, step, seconds]) => {
  const gl = document.querySelector('canvas').getContext('webgl2');
  const frames = [];
  const begin = performance.now();
  for (;;) {
    const at = (performance.now() - begin) / 1000;
    if (at >= seconds) return frames;
    const number = Math.min(Math.floor(at / step), poses.length - 2);
    const [one, other, share] = [poses[number], poses[number + 1], at / step - number];
    const mix = (a, b) => a + share * (b - a);
    const position = one.position.map((value, axis) => mix(value, other.position[axis]));
    const pose = { position, yaw: mix(one.yaw, other.yaw), pitch: one.pitch };
    client.see(pose, cuts[number]);
    const start = await new Promise(requestAnimationFrame);
    await client.draw();
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
    frames.push([at, performance.now() - start, client.missing]);
  }
}"""

STAND = """async ([pose, cut]) => {
  client.see(pose, cut);
  await new Promise(requestAnimationFrame);
  await client.draw();
  return JSON.stringify([client.missing, client.facts]);
}"""

STILL = """async ([width, height]) => {
  const gl = document.querySelector('canvas').getContext('webgl2');
  await client.draw();
  // Read in the same task: when it ends, the browser clears the canvas.
  await client.paint?.();
  const pixels = new Uint8Array(4 * width * height);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  let text = '';
  for (let at = 0; at < pixels.length; at += 8192) text += String.fromCharCode(...pixels.subarray(at, at + 8192));
  return btoa(text);
}"""


@dataclass(frozen=True)
class Route:
    """A flight forward with slow turns; its poses are `step` seconds apart."""

    tree: nf.orthoview.OrthoTree
    height: float
    speed: float
    seconds: float
    error: float
    """Greatest width of a pixel of a drawn view, in pixels of the picture."""
    splat_error: float
    """The same for the cells that Spark draws."""
    step: float = 1.0

    @cached_property
    def poses(self) -> list[dict[str, Any]]:
        """Poses in the page's format."""
        low, high = self.tree.bounds
        position = low + np.array([0.33, 0.0, 0.39]) * (high - low) + [0.0, self.height, 0.0]
        poses = []
        for number in range(int(self.seconds / self.step) + 1):
            yaw = -1.87 + 0.15 * np.sin(2 * np.pi * number * self.step / self.seconds)
            poses.append({"position": position.tolist(), "yaw": float(yaw), "pitch": -0.15})
            position = position + self.speed * self.step * np.array([-np.sin(yaw), 0.0, -np.cos(yaw)])
        return poses

    def camera(self, number: int) -> nf.Camera:
        pose = self.poses[number]
        return camera(pose["position"], pose["yaw"], pose["pitch"], SIZE, ANGLE)

    @cached_property
    def cuts(self) -> list[dict[str, Any]]:
        """Cuts for Spark: names of a cut's cells and their ancestors, the coarsest first, and their hierarchy."""
        return [self._cut(number) for number in range(len(self.poses))]

    def _cut(self, number: int) -> dict[str, Any]:
        cut = self.tree.cut(self.camera(number), error_px=self.splat_error, geometry=False)
        distances: dict[tuple[int, Place], float] = {}
        children: dict[tuple[int, Place], set[tuple[int, Place]]] = {}
        top = self.tree._layout.grid.levels - 1
        rows = zip(cut.level.tolist(), cut.place.tolist(), cut.distance.tolist(), cut.in_picture, strict=True)
        for level, place, distance, is_in_picture in rows:
            if not is_in_picture:
                continue
            key: tuple[int, Place] = (level, tuple(place))
            children.setdefault(key, set())
            distances[key] = min(distance, distances.get(key, np.inf))
            while key[0] < top:
                x, y, z = key[1]
                parent: tuple[int, Place] = (key[0] + 1, (x >> 1, y >> 1, z >> 1))
                children.setdefault(parent, set()).add(key)
                distances[parent] = min(distance, distances.get(parent, np.inf))
                key = parent
        order = sorted(distances, key=lambda each: (-each[0], distances[each]))

        def subtree_of(key: tuple[int, Place]) -> dict[str, Any]:
            return {"name": name_of(*key), "below": [subtree_of(child) for child in sorted(children[key])]}

        return {"wanted": [name_of(*key) for key in order], "root": subtree_of((top, (0, 0, 0)))}


def name_of(level: int, place: Place) -> str:
    return "-".join(map(str, (level, *place)))


def prepare(route: Route, folder: Path) -> dict[str, Path]:
    """Write the files that the viewers read; return the folders to serve."""
    page, splats, job = (folder / name for name in ("page", "splats", "job"))
    for each in (page, splats, job):
        each.mkdir(exist_ok=True)
    for name, content in tree_page().items():
        (page / name).write_bytes(content)
    cells = cells_of(route.tree)
    centers: dict[str, list[float]] = {}
    for name in sorted({name for cut in route.cuts for name in cut["wanted"]}):
        level, *place = map(int, name.split("-"))
        key = (level, (place[0], place[1], place[2]))
        centers[name] = route.tree.box(*key).mean(axis=0).tolist()
        if not (splats / f"{name}.spz").is_file():
            (splats / f"{name}.spz").write_bytes(_spz.encode(cells.read(*key).gaussians))
    settings = {
        "size": SIZE,
        "angle": ANGLE,
        "tileset": "/store/geometry/tileset.json",
        "cells": centers,
        "irradiance": LIGHT.read_text().split("/* glsl */ `")[1].split("`")[0],
    }
    (job / "job.json").write_text(json.dumps(settings))
    store, packages = Path(route.tree.path), FOLDER / "node_modules"
    return {"page": page, "splats": splats, "job": job, "store": store, "packages": packages, "peers": PEERS}


class Client:
    """A viewer in a page."""

    def __init__(self, page: Any, route: Route, gate: Gate) -> None:
        self._page, self._route, self._gate = page, route, gate

    def wait_at(self, number: int, timeout: float) -> dict[str, Any]:
        """Stay at a pose until nothing arrives or changes; return the number of missing parts and figures."""
        begin = time.monotonic()
        last_state, last_change = None, begin
        pose, cut = self._route.poses[number], self._route.cuts[number]
        while True:
            state = self._page.evaluate(STAND, [pose, cut]), self._gate.sent
            now = time.monotonic()
            if state != last_state:
                last_state, last_change = state, now
            missing, facts = json.loads(state[0])
            quiet_seconds = 1.0 if missing == 0 else QUIET
            if now - last_change > quiet_seconds or now - begin > timeout:
                return {"missing": missing, **facts}
            self._page.wait_for_timeout(200)

    def picture(self) -> NDArray[np.uint8]:
        """Return the picture (H, W, 4)."""
        data = base64.b64decode(self._page.evaluate(STILL, list(SIZE)))
        return np.frombuffer(data, np.uint8).reshape(SIZE[1], SIZE[0], 4)[::-1]

    def fly(self, pace: float) -> NDArray[np.float64]:
        """Fly the route at `pace` times its speed; return each frame's time, milliseconds and missing parts."""
        route = self._route
        frames = self._page.evaluate(FLY, [route.poses, route.cuts, route.step / pace, route.seconds])
        return np.array(frames, np.float64).reshape(-1, 3)


@contextmanager
def open_client(chromium: Any, url: str, name: str, route: Route, gate: Gate) -> Iterator[Client]:
    """Open a viewer without a cache, at the beginning of the route."""
    context = chromium.new_context(viewport={"width": SIZE[0], "height": SIZE[1]})
    page = context.new_page()
    page.on("pageerror", lambda error: print(f"{name}: {error}"))
    try:
        if name.startswith("nearfar"):
            pose = route.poses[0]
            link = f"#p={','.join(map(str, pose['position']))}&yaw={pose['yaw']}&pitch={pose['pitch']}"
            page.goto(f"{url}page/?store=/store/&error={route.error:g}&megabytes=2048{CLIENTS[name]}{link}")
            page.add_script_tag(path=str(PEERS / "page.mjs"))
        else:
            page.goto(f"{url}peers/?{CLIENTS[name]}")
        page.wait_for_function("() => window.client")
        yield Client(page, route, gate)
    finally:
        context.close()
