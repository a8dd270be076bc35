"""Builds on a Dask cluster of this machine: one worker against two, each with one thread.

Processes are started before the timing, which includes sending the source to them.
"""

from __future__ import annotations

import hashlib
from typing import Any

import numpy as np
from distributed import Client, LocalCluster

import nearfar as nf
from benchmarks.harness.report import folder_or_temporary, start, table
from benchmarks.harness.timing import timed


def main() -> None:
    options = start(
        __doc__,
        tiles=(str, "folder of tiles; by default a procedural forest"),
        side=(float, "side of the square that is built, metres"),
        cell=float,
        repeat=2,
    )
    source: nf.SceneSource = nf.open_source(options.tiles) if options.tiles else nf.datasets.forest()
    low, high = source.bounds
    if options.side:
        middle = source.bounds.mean(axis=0)
        low, high = np.maximum(low, middle - options.side / 2), np.minimum(high, middle + options.side / 2)
        low[1], high[1] = source.bounds[:, 1]
    cell = options.cell or float((high - low)[[0, 2]].max()) / 32
    rows, one_worker_seconds, digests = [], 0.0, set()
    for workers in (1, 2):
        seconds = []
        for _ in range(options.repeat):
            build_seconds, digest, tree = spread(source, np.array([low, high]), cell, workers)
            seconds.append(build_seconds)
            digests.add(digest)
        one_worker_seconds = one_worker_seconds or min(seconds)
        rows.append([workers, min(seconds), one_worker_seconds / min(seconds), f"{tree.done}"])
    print(table(f"{tree}", "workers | s {:.1f} | times as fast {:.2f} | done", rows))
    print("same bytes" if len(digests) == 1 else "DIFFERENT BYTES")


def spread(
    source: nf.SceneSource, aabb: np.ndarray, cell: float, workers: int
) -> tuple[float, str, nf.orthoview.OrthoTree]:
    """Seconds of a build, and a hash of its shards."""
    env = {"NEARFAR_NUM_THREADS": "1", "NEARFAR_PROGRESS": "0"}
    settings: dict[str, Any] = {"cell": cell, "aabb": aabb, "size": 256, "directions": 9}
    with (
        folder_or_temporary() as folder,
        LocalCluster(n_workers=workers, threads_per_worker=1, dashboard_address=":0", env=env) as cluster,
        Client(cluster) as client,
    ):
        tree, timing = timed(nf.orthoview.build, source, folder / "tree.zarr", **settings, cluster=client)
        digest = hashlib.sha256()
        for path in sorted(path for path in folder.rglob("0") if path.is_file()):
            digest.update(path.read_bytes())
        return timing.wall, digest.hexdigest(), tree


if __name__ == "__main__":
    main()
