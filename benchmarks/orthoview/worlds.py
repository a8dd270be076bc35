"""Whole worlds: time, bytes and memory of trees of growing parts, and their extrapolation to larger ones.

    python -m benchmarks.orthoview.worlds tokyo --tiles FOLDER   # squares of up to 16 km, from a folder of tiles
    python -m benchmarks.orthoview.worlds asteroids world         # rocks up to all; a procedural city, in part

Each tree is built in a separate process, whose peak memory is recorded. Slopes are those of a line through the
logarithms; a slope of 1 is proportional.
"""

from __future__ import annotations

import argparse
import json
import resource
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

import nearfar as nf
from benchmarks.harness.timing import machine, table
from nearfar._base import data

Row = dict[str, Any]

SIZE, DIRECTIONS = 256, 9


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("worlds", nargs="*", help=f"of {', '.join(SERIES)}; by default forest")
    parser.add_argument("--tiles", help="folder of tiles of the whole of Tokyo, which nf.write_tiles wrote")
    parser.add_argument("--cell", type=float, help="side of leaves, metres")
    parser.add_argument("--out", type=Path, help="folder for the plots")
    parser.add_argument("--one", help=argparse.SUPPRESS)
    given = parser.parse_args()
    if given.one:
        print(json.dumps(built(json.loads(given.one))))
        return
    print(machine(), "\n")
    for name in given.worlds or ["forest"]:
        rows = [in_process(job) for job in SERIES[name](given)]
        print(report(name, rows))
        if given.out is not None:
            plot(name, rows, given.out)


def tokyo(given: argparse.Namespace) -> Iterator[Row]:
    """Squares around the middle of the city: more of it, the same leaves."""
    cell = given.cell or 500.0
    for side in (500, 1000, 2000, 4000, 8000, 16000):
        yield {"world": "tokyo", "tiles": given.tiles, "side": side, "cell": cell}


def asteroids(given: argparse.Namespace) -> Iterator[Row]:
    """29,264 rocks of 97,000 polygons in a ring: those on one side of it, up to all."""
    for share in (0.03, 0.1, 0.3, 1.0):
        yield {"world": "asteroids", "share": share, "cell": given.cell}


def world(given: argparse.Namespace) -> Iterator[Row]:
    """Squares of a procedural city of 100 km."""
    cell = given.cell or 200.0
    for side in (200, 400, 800, 1600, 3200):
        yield {"world": "world", "side": side, "cell": cell}


def forest(given: argparse.Namespace) -> Iterator[Row]:
    """Squares of a forest, for a run of a minute."""
    for side in (5, 20, 80, 320):
        yield {"world": "forest", "side": side, "cell": given.cell or 20.0}


SERIES = {"tokyo": tokyo, "asteroids": asteroids, "world": world, "forest": forest}


def in_process(job: Row) -> Row:
    """Build in a separate process."""
    command = [sys.executable, "-m", "benchmarks.orthoview.worlds", "--one", json.dumps(job)]
    process = subprocess.run(command, capture_output=True, text=True, check=False)
    if process.returncode:
        raise RuntimeError(process.stderr[-2000:])
    row: Row = json.loads(process.stdout)
    print(row, file=sys.stderr, flush=True)
    return row


def built(job: Row) -> Row:
    """Build a tree and measure it."""
    source, aabb = open_world(job)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    with tempfile.TemporaryDirectory(dir=job.get("folder")) as folder:
        wall, cpu = time.perf_counter(), time.process_time()
        tree = nf.orthoview.build(
            source,
            Path(folder) / "tree.zarr",
            cell=job["cell"],
            aabb=aabb,
            size=SIZE,
            directions=DIRECTIONS,
            geometry=False,
        )
        row: Row = {"seconds": time.perf_counter() - wall, "cpu": time.process_time() - cpu}
    return row | {
        "side": job.get("side", job.get("share")),
        "triangles": source.query(aabb).triangle_count,
        "leaves": tree.held["leaves"],
        "cells": tree.held["cells"],
        "levels": tree.levels,
        "bytes": tree.held["bytes"],
        "chunks": tree.held["chunks"],
        "memory": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024,
        "before": before * 1024,
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
    if job["world"] == "tokyo":
        source: nf.SceneSource = nf.open_source(job["tiles"]) if job["tiles"] else tokyo_core()
    elif job["world"] == "world":
        source = nf.datasets.world(100)
    else:
        source = nf.datasets.forest()
    half = job["side"] / 2
    middle = source.bounds.mean(axis=0) if job["world"] == "tokyo" else np.zeros(3)
    aabb = np.array([middle - half, middle + half])
    aabb[:, 1] = -np.inf, np.inf
    aabb[:, 1] = (source if job["world"] == "tokyo" else source.query(aabb)).bounds[:, 1]
    # A square ends with its last leaf, since its sides belong to leaves.
    aabb[1, (0, 2)] -= 1e-3
    return source, aabb


def tokyo_core() -> nf.Scene:
    path = data.find("city/tokyo23/tokyo_core_lod1.glb")
    if path is None:
        raise FileNotFoundError("city/tokyo23/tokyo_core_lod1.glb")
    return nf.Scene.load(path)


def report(name: str, rows: list[Row]) -> str:
    """Table of the parts, and the slopes of time and bytes."""
    header = ["part", "triangles", "leaves", "levels", "s", "CPU s", "MB", "kB a view", "ms a cell", "memory, MB"]
    lines = [
        [
            f"{row['side']:g}",
            f"{row['triangles']:,}",
            f"{row['leaves']:,}",
            f"{row['levels']}",
            f"{row['seconds']:.1f}",
            f"{row['cpu']:.1f}",
            f"{row['bytes'] / 1e6:.1f}",
            f"{3e-3 * row['bytes'] / max(row['chunks'], 1):.1f}",
            f"{1e3 * row['seconds'] / max(row['cells'], 1):.0f}",
            f"{row['memory'] / 1e6:.0f}",
        ]
        for row in rows
    ]
    slopes = ", ".join(f"{key} {slope(rows, key):.2f}" for key in ("seconds", "cpu", "bytes"))
    return table(name, header, lines) + f"\nSlopes against triangles: {slopes}\n"


def slope(rows: list[Row], key: str) -> float:
    """Slope of the logarithm of a value over that of the triangles."""
    found = np.polyfit(np.log([row["triangles"] for row in rows]), np.log([row[key] for row in rows]), 1)
    return float(found[0])


def plot(name: str, rows: list[Row], folder: Path) -> None:
    """Plot time, bytes and memory against triangles, both axes logarithmic."""
    import matplotlib.pyplot as plt

    folder.mkdir(parents=True, exist_ok=True)
    figure, axes = plt.subplots(1, 3, figsize=(13, 3.8), layout="constrained")
    count = np.array([row["triangles"] for row in rows], float)
    for axis, key, factor, label in zip(
        axes[:2], ("seconds", "bytes"), (1.0, 1e-6), ("seconds, two cores", "megabytes"), strict=True
    ):
        values = factor * np.array([row[key] for row in rows])
        axis.loglog(count, values, "o-", label=f"slope {slope(rows, key):.2f}")
        axis.loglog(count, values[-1] * count / count[-1], "--", color="#999999", label="proportional")
        axis.set(xlabel="triangles", ylabel=label)
        axis.legend()
    axes[2].plot([row["levels"] for row in rows], [row["memory"] / 1e6 for row in rows], "o-")
    axes[2].set(xlabel="levels of the tree", ylabel="greatest memory, MB")
    axes[2].set_ylim(0, None)
    figure.savefig(folder / f"orthoview_{name}.png", dpi=110)
    plt.close(figure)


if __name__ == "__main__":
    main()
