"""Builds on a Dask cluster of this machine: one worker against two, each with one thread.

    python -m benchmarks.orthoview.workers [--tiles FOLDER --side METRES]

Processes are started before the clock; sending the source to them is part of the time.
"""

from __future__ import annotations

import argparse
import hashlib
import tempfile
import time
from pathlib import Path

import numpy as np
from distributed import Client, LocalCluster

import nearfar as nf
from benchmarks.harness.timing import machine, table


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--tiles", help="folder of tiles; by default a procedural forest")
    parser.add_argument("--side", type=float, help="side of the square that is built, metres")
    parser.add_argument("--cell", type=float)
    parser.add_argument("--repeat", type=int, default=2)
    given = parser.parse_args()
    print(machine(), "\n")
    source: nf.SceneSource = nf.open_source(given.tiles) if given.tiles else nf.datasets.forest()
    low, high = source.bounds
    if given.side:
        middle = source.bounds.mean(axis=0)
        low, high = np.maximum(low, middle - given.side / 2), np.minimum(high, middle + given.side / 2)
        low[1], high[1] = source.bounds[:, 1]
    cell = given.cell or float((high - low)[[0, 2]].max()) / 32
    rows, first, digests = [], 0.0, set()
    for workers in (1, 2):
        seconds = []
        for _ in range(given.repeat):
            taken, digest, tree = spread(source, np.array([low, high]), cell, workers)
            seconds.append(taken)
            digests.add(digest)
        first = first or min(seconds)
        rows.append([f"{workers}", f"{min(seconds):.1f}", f"{first / min(seconds):.2f}", f"{tree.done}"])
    print(table(f"{tree}", ["workers", "s", "times as fast", "done"], rows))
    print("same bytes" if len(digests) == 1 else "DIFFERENT BYTES")


def spread(
    source: nf.SceneSource, aabb: np.ndarray, cell: float, workers: int
) -> tuple[float, str, nf.orthoview.OrthoTree]:
    """Seconds of a build, and a hash of its shards."""
    settings = {"NEARFAR_NUM_THREADS": "1", "NEARFAR_PROGRESS": "0"}
    with (
        tempfile.TemporaryDirectory() as folder,
        LocalCluster(n_workers=workers, threads_per_worker=1, dashboard_address=":0", env=settings) as cluster,
        Client(cluster) as client,
    ):
        started = time.perf_counter()
        tree = nf.orthoview.build(
            source, Path(folder) / "tree.zarr", cell=cell, aabb=aabb, size=256, directions=9, cluster=client
        )
        taken = time.perf_counter() - started
        digest = hashlib.sha256()
        for path in sorted(path for path in Path(folder).rglob("0") if path.is_file()):
            digest.update(path.read_bytes())
        return taken, digest.hexdigest(), tree


if __name__ == "__main__":
    main()
