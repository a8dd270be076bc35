"""Whole worlds: time, bytes and memory of trees of growing parts, and their extrapolation to larger ones.

    python -m benchmarks.orthoview.worlds tokyo --tiles FOLDER   # squares of up to 16 km, from a folder of tiles
    python -m benchmarks.orthoview.worlds asteroids              # parts of a ring of rocks

Each tree is built in a separate process, whose peak memory is recorded. Slopes are those of a line fitted to the
logarithms; 1 means proportional.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

import nearfar as nf
from benchmarks.harness import scenes
from benchmarks.harness.process import run_module
from benchmarks.harness.report import folder_or_temporary, save_figure, start, subplots, table
from benchmarks.harness.timing import resident, timed
from nearfar._base import data

Row = dict[str, Any]

SIZE, DIRECTIONS = 256, 9


def main() -> None:
    options = start(
        __doc__,
        "--tiles",
        "--out",
        worlds={"nargs": "*", "help": f"of {', '.join(SERIES)}; by default forest"},
        cell=(float, "side of leaves, metres"),
        one=str,
    )
    if options.one:
        print(json.dumps(build(json.loads(options.one))))
        return
    for name in options.worlds or ["forest"]:
        rows = []
        for job in SERIES[name](options):
            rows.append(run_module("benchmarks.orthoview.worlds", "--one", json.dumps(job)))
            print(rows[-1], file=sys.stderr, flush=True)
        print(report(name, rows))
        if options.out is not None:
            plot(name, rows, options.out)


def tokyo(options: argparse.Namespace) -> Iterator[Row]:
    """Growing squares around the middle of the city, with leaves of the same side."""
    cell = options.cell or 500.0
    for side in (500, 1000, 2000, 4000, 8000, 16000):
        yield {"world": "tokyo", "tiles": options.tiles, "side": side, "cell": cell}


def asteroids(options: argparse.Namespace) -> Iterator[Row]:
    """29,264 rocks of 97,000 polygons in a ring: the rocks on one side of a moving plane, up to all of them."""
    for fraction in (0.03, 0.1, 0.3, 1.0):
        yield {"world": "asteroids", "share": fraction, "cell": options.cell}


def forest(options: argparse.Namespace) -> Iterator[Row]:
    """Squares of a forest, for a run of a minute."""
    for side in (5, 20, 80, 320):
        yield {"world": "forest", "side": side, "cell": options.cell or 20.0}


SERIES = {each.__name__: each for each in (tokyo, asteroids, forest)}


def build(job: Row) -> Row:
    source, aabb = open_world(job)
    memory_before = resident("VmHWM")
    with folder_or_temporary() as folder:
        settings: dict[str, Any] = {"cell": job["cell"], "aabb": aabb, "size": SIZE, "directions": DIRECTIONS}
        tree, timing = timed(nf.orthoview.build, source, folder / "tree.zarr", **settings, geometry=False)
    return {name: tree.held[name] for name in ("leaves", "cells", "bytes", "chunks")} | {
        "seconds": timing.wall,
        "cpu": timing.cpu,
        "side": job.get("side", job.get("share")),
        "triangles": source.query(aabb).triangle_count,
        "levels": tree.levels,
        "memory": resident("VmHWM"),
        "before": memory_before,
        "done": tree.done,
    }


def open_world(job: Row) -> tuple[nf.SceneSource, np.ndarray]:
    """Open a world, and return it with the part to build."""
    if job["world"] == "asteroids":
        rocks = nf.datasets.asteroids()
        low, high = rocks.bounds
        job["cell"] = job["cell"] or float((high - low).max()) / 16
        low[0] = high[0] - (high[0] - low[0]) * job["share"]
        return rocks, np.array([low, high])
    is_city = job["world"] == "tokyo"
    source: nf.SceneSource = open_tokyo(job["tiles"]) if is_city else nf.datasets.forest()
    half_side = job["side"] / 2
    middle = source.bounds.mean(axis=0) if is_city else np.zeros(3)
    aabb = np.array([middle - half_side, middle + half_side])
    aabb[:, 1] = -np.inf, np.inf
    aabb[:, 1] = (source if is_city else source.query(aabb)).bounds[:, 1]
    # A box that ended on a leaf's border would touch the next leaf, too.
    aabb[1, (0, 2)] -= 1e-3
    return source, aabb


def open_tokyo(tiles: str | None) -> nf.SceneSource:
    return nf.open_source(tiles) if tiles else nf.Scene.load(data.require(scenes.FILES["Tokyo core"]))


def report(name: str, rows: list[Row]) -> str:
    header = (
        "part {:g} | triangles {:,} | leaves {:,} | levels | s {:.1f} | CPU s {:.1f} | MB {:.1f} | kB a view {:.1f}"
    )
    lines = []
    for row in rows:
        counts = (row[key] for key in ("side", "triangles", "leaves", "levels", "seconds", "cpu"))
        sizes = row["bytes"] / 1e6, 3e-3 * row["bytes"] / max(row["chunks"], 1)
        lines.append([*counts, *sizes, 1e3 * row["seconds"] / max(row["cells"], 1), row["memory"] / 1e6])
    slopes = ", ".join(f"{key} {slope(rows, key):.2f}" for key in ("seconds", "cpu", "bytes"))
    text = table(name, header + " | ms a cell {:.0f} | memory, MB {:.0f}", lines)
    return f"{text}\nSlopes against triangles: {slopes}\n"


def slope(rows: list[Row], key: str) -> float:
    """Slope of the logarithm of a value over that of the triangles."""
    return float(np.polyfit(np.log([row["triangles"] for row in rows]), np.log([row[key] for row in rows]), 1)[0])


def plot(name: str, rows: list[Row], folder: Path) -> None:
    figure, axes = subplots(1, 3, figsize=(13, 3.8))
    count = np.array([row["triangles"] for row in rows], float)
    panels = {"seconds": (1.0, "seconds, two cores"), "bytes": (1e-6, "megabytes")}
    for axis, (key, (factor, label)) in zip(axes[:2], panels.items(), strict=True):
        values = factor * np.array([row[key] for row in rows])
        axis.loglog(count, values, "o-", label=f"slope {slope(rows, key):.2f}")
        axis.loglog(count, values[-1] * count / count[-1], "--", color="#999999", label="proportional")
        axis.set(xlabel="triangles", ylabel=label)
        axis.legend()
    axes[2].plot([row["levels"] for row in rows], [row["memory"] / 1e6 for row in rows], "o-")
    axes[2].set(xlabel="levels of the tree", ylabel="greatest memory, MB")
    axes[2].set_ylim(0, None)
    save_figure(figure, folder / f"orthoview_{name}.png", dpi=110)


if __name__ == "__main__":
    main()
