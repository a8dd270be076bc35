"""Updates of a tree: seconds and computed cells of squares of 200, 400 and 800 m.

    python -m benchmarks.orthoview.updates TREE --tiles FOLDER

The squares lie around the middle of the tree. The world is unchanged, so that all views stay equal and only work is
measured. Chaudhuri et al. report 20.8, 24.0 and 42.5 s.
"""

from __future__ import annotations

import argparse
import shutil
import tempfile
import time
from pathlib import Path

import numpy as np

import nearfar as nf
from benchmarks.harness.timing import machine, table


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("tree", type=Path, help="store that nf.orthoview.build wrote")
    parser.add_argument("--tiles", required=True, help="the world that it was built from")
    parser.add_argument("--repeat", type=int, default=3)
    given = parser.parse_args()
    print(machine(), "\n")
    source = nf.open_source(given.tiles)
    rows = []
    with tempfile.TemporaryDirectory(dir=given.tree.parent) as folder:
        tree = nf.orthoview.open(given.tree).compact(Path(folder) / "tree.zarr")
        print(tree, "\n")
        middle = source.bounds.mean(axis=0)
        for side in (200.0, 400.0, 800.0):
            box = np.array([middle - side / 2, middle + side / 2])
            box[:, 1] = -np.inf, np.inf
            seconds = []
            for _ in range(given.repeat):
                started = time.perf_counter()
                tree = tree.update(box, source)
                seconds.append(time.perf_counter() - started)
            done = tree.done
            computed = done.get("drawn", 0) + done.get("empty", 0) + done["composed"]
            rows.append([f"{side:g}", f"{min(seconds):.2f}", f"{max(seconds):.2f}", f"{computed}", f"{done}"])
        shutil.rmtree(tree.path)
    print(table("Updates", ["square, m", "s, least", "s, greatest", "cells computed", "of which"], rows))


if __name__ == "__main__":
    main()
