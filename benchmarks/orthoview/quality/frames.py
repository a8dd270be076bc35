"""Time of the first frame, with loading, and of later frames of geometry and of a tree, by the extent of the world.

TREE is a store of the whole of Tokyo with geometry, and --tiles names the folder of its tiles. Smaller worlds are the
squares around the eye of `benchmarks.orthoview.flights growth`. Each world is drawn by each method in a separate
process.
"""

from __future__ import annotations

import itertools
import json
import resource
import sys
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

import nearfar as nf
from benchmarks.harness.process import run_module
from benchmarks.harness.report import save_figure, start, subplots, table
from benchmarks.harness.timing import best
from benchmarks.orthoview.flights import FOV, PICTURE, START
from nearfar._camera.shot import Shot
from nearfar._render.backend import Backend
from nearfar.orthoview._cut import Settings
from nearfar.orthoview._viewer import Parts

SIDES = (1.0, 2.0, 4.0, 8.0, 16.0, 32.0)
"""Sides of worlds, kilometres."""
WHOLE_SIDE = 60.0
"""Side of a square around the eye that contains the whole of Tokyo, kilometres; it replaces the last of `SIDES`."""
EYES = {"walker": 2.0, "120 m above": 120.0}
"""Heights of the eyes, metres."""
WAYS = ("rays", "rasters", "orthoviews")
LIMIT = 540
"""Timeout of a process, seconds."""
REPEAT = 3

Row = dict[str, Any]


def main() -> None:
    options = start(
        __doc__,
        "tree",
        "--out",
        tiles={"type": str, "required": True, "help": "folder of its tiles, which nf.write_tiles wrote"},
        sides=(list(SIDES), "kilometres"),
        ways=(list(WAYS), f"of {', '.join(WAYS)}"),
        one=str,
    )
    if options.one:
        print(json.dumps(measure(options.tree, options.tiles, json.loads(options.one))))
        return
    rows: list[Row] = []
    for side, method in itertools.product(options.sides, options.ways):
        job = {"side": side, "way": method}
        arguments = options.tree, "--tiles", options.tiles, "--one", json.dumps(job)
        try:
            rows.append(job | run_module("benchmarks.orthoview.quality.frames", *arguments, seconds=LIMIT))
        except RuntimeError as error:
            rows.append(job | {"failed": str(error)})
        print(rows[-1], file=sys.stderr, flush=True)
    print(report(rows))
    if options.out is not None:
        plot(rows, options.out)


def measure(tree: str, tiles: str, job: Row) -> Row:
    """Seconds of the first frame, and of the next ones."""
    half_side = 500.0 * (WHOLE_SIDE if job["side"] == SIDES[-1] else job["side"])
    wall_start, cpu_start = time.perf_counter(), time.process_time()
    draw, row = orthoviews(tree, half_side) if job["way"] == "orthoviews" else geometry(tiles, half_side, job["way"])
    for name, height in EYES.items():
        camera = eye(height)
        draw(camera)
        if "first" not in row:
            row["first"] = [time.perf_counter() - wall_start, time.process_time() - cpu_start]
        timing = best(partial(draw, camera), repeat=REPEAT)
        row[name] = [timing.wall, timing.cpu]
    return row | {"memory": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024}


def eye(height: float) -> nf.Camera:
    """Camera in the middle of the walk of `flights growth`."""
    position = np.array([START[0], height, START[1]])
    return nf.Camera.look_at(position, np.add(position, [1.0, -0.15, 0.0]), fov=FOV, size=PICTURE)


def geometry(tiles: str, half_side: float, method: str) -> tuple[Callable[[nf.Camera], Any], Row]:
    """Load all triangles of the square; return the function that draws them, and their number."""
    source = nf.open_source(tiles)
    low, high = source.bounds
    box = [(START[0] - half_side, low[1], START[1] - half_side), (START[0] + half_side, high[1], START[1] + half_side)]
    scene = source.query(box)
    backend: Backend = "cpu" if method == "rays" else "gpu"
    return partial(nf.render, scene, channels=("color",), backend=backend), {"triangles": scene.triangle_count}


def orthoviews(path: str, half_side: float) -> tuple[Callable[[nf.Camera], Any], Row]:
    """Return the function that draws a cut's cells and leaves whose middles lie in the square."""
    tree = nf.orthoview.open(path)
    opened = tree._open_store()
    viewer, grid = opened.viewer, opened.grid

    def is_in_square(level: int, place: tuple[int, int, int]) -> bool:
        middle = grid.box(level, place).mean(axis=0) - [START[0], 0.0, START[1]]
        return float(np.abs(middle[[0, 2]]).max()) <= half_side

    def draw(camera: nf.Camera) -> Any:
        cut = viewer.cutter.complete_cut(camera, Settings())
        views = cut.keys()
        keys = [key for key in views if is_in_square(*key[:2])]
        leaves = viewer.cutter.with_guests([leaf for leaf in cut.leaf_places() if is_in_square(0, leaf)])
        parts = Parts(viewer.views.get(keys), viewer.near.scene(leaves), None, {})
        return viewer.picture(camera, Shot(cameras=(camera,), channels=("color",)), parts)

    return draw, {}


def report(rows: list[Row]) -> str:
    lines = []
    for row in rows:
        key = row["side"], row["way"]
        if "failed" in row:
            lines.append([*key, None, row["failed"], None, *(None for _ in EYES)])
            continue
        later_frames = [(1e3 * row[name][0], 1e3 * row[name][1]) for name in EYES]
        lines.append([*key, row.get("triangles"), tuple(row["first"]), row["memory"] / 1e9, *later_frames])
    eyes = (f"{name}, ms (CPU) {{:.0f}} ({{:.0f}})" for name in EYES)
    header = ["side, km {:g}", "method", "triangles {:,}", "first frame, s (CPU) {:.1f} ({:.1f})", "memory, GB {:.2f}"]
    return table("Frames", [*header, *eyes], lines)


def plot(rows: list[Row], out: Path) -> None:
    figure, (left, right) = subplots(1, 2, figsize=(9, 3.6))
    labels = dict(zip(WAYS, ("geometry, rays", "geometry, rasters (software)", "orthoviews"), strict=True))
    for method, label in labels.items():
        rows_of_way = [row for row in rows if row["way"] == method and "failed" not in row]
        sides = [row["side"] for row in rows_of_way]
        left.plot(sides, [row["first"][1] for row in rows_of_way], "o-", label=label)
        right.plot(sides, [1e3 * row["120 m above"][1] for row in rows_of_way], "o-", label=label)
    for axes, title in ((left, "until the first frame, CPU seconds"), (right, "each frame after it, CPU ms")):
        axes.set(xscale="log", yscale="log", xlabel="side of the world, km", ylabel=title)
        axes.set_xticks(SIDES, [f"{side:g}" for side in SIDES])
        axes.minorticks_off()
        axes.grid(alpha=0.3)
    left.legend(fontsize="small")
    save_figure(figure, out / "orthoview_frames.png", dpi=110)


if __name__ == "__main__":
    main()
