"""Updates of a tree: seconds and computed cells of squares of 200, 400 and 800 m.

The squares lie around the middle of the tree. The world is unchanged, so all views stay equal; only
the time counts. Chaudhuri et al. report 20.8, 24.0 and 42.5 s.
"""

from __future__ import annotations

import shutil
import tempfile
from pathlib import Path

import numpy as np

import nearfar as nf
from benchmarks.harness.report import start, table
from benchmarks.harness.timing import timed


def main() -> None:
    options = start(__doc__, "tree", "--tiles", repeat=3)
    source = nf.open_source(options.tiles)
    rows = []
    with tempfile.TemporaryDirectory(dir=options.tree.parent) as folder:
        tree = nf.orthoview.open(options.tree).compact(Path(folder) / "tree.zarr")
        print(tree, "\n")
        middle = source.bounds.mean(axis=0)
        for side in (200.0, 400.0, 800.0):
            box = np.array([middle - side / 2, middle + side / 2])
            box[:, 1] = -np.inf, np.inf
            seconds = []
            for _ in range(options.repeat):
                tree, timing = timed(tree.update, box, source)
                seconds.append(timing.wall)
            counts = tree.done
            computed = counts.get("drawn", 0) + counts.get("empty", 0) + counts["composed"]
            rows.append([side, min(seconds), max(seconds), computed, f"{counts}"])
        shutil.rmtree(tree.path)
    print(table("Updates", "square, m {:g} | s, least {:.2f} | s, greatest {:.2f} | cells computed | of which", rows))


if __name__ == "__main__":
    main()
