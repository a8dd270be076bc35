"""Times of deriving scenes from tokyo_core_lod1, and of making the whole of Tokyo against a copy of its arrays."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness import scenes
from benchmarks.harness.report import start, table
from benchmarks.harness.timing import best, forget_peak, resident
from benchmarks.harness.tokyo import with_buildings


def main() -> None:
    start(__doc__)
    changing()
    if (city := with_buildings()) is not None:
        whole_city(*city)


def changing() -> None:
    scene = scenes.load("Tokyo core")
    if scene is None:
        return
    names = scene.object_names
    moving = scene.with_dynamic(names[:10])
    poses = {name: np.eye(4) for name in names[:10]}
    mask = np.arange(scene.triangle_count) % 2 == 0
    jobs = {
        "with_dynamic, 10 objects": lambda: scene.with_dynamic(names[:10]),
        "at, 10 objects": lambda: moving.at(poses),
        "subset, half of the objects": lambda: scene.subset(objects=names[::2]),
        "subset, half of the triangles": lambda: scene.subset(triangles=mask),
        "bounds": lambda: scene._core.bounds(),
        "triangles()": scene.triangles,
    }
    rows = [(label, best(job).ms) for label, job in jobs.items()]
    print(table("tokyo_core_lod1, 232,986 triangles: milliseconds", "step | ms {:.3f}", rows))


def whole_city(*arrays: NDArray[Any]) -> None:
    """Time and memory for 29.8 M triangles, compared with a copy."""
    size = sum(array.nbytes for array in arrays)
    forget_peak()
    before = resident()
    nf.Scene.from_arrays(*arrays)
    extra = resident("VmHWM") - before
    ours = best(lambda: nf.Scene.from_arrays(*arrays), repeat=3).wall
    copying = best(lambda: [array.copy() for array in arrays], repeat=3).wall
    wide = (arrays[0].astype(np.float64), arrays[1].astype(np.int64), arrays[2])
    converted = best(lambda: nf.Scene.from_arrays(*wide), repeat=1).wall
    rows = [
        ["from_arrays", ours, ours / copying, 1 + extra / size],
        ["from_arrays of float64 and int64", converted, converted / copying, None],
        ["copying the arrays", copying, "1", "2"],
    ]
    title = f"Whole of Tokyo, {len(arrays[1]):,} triangles, {size / 1e6:.0f} MB"
    print(table(title, "step | seconds {:.2f} | ratio to copying {:.2f} | peak memory / arrays {:.2f}", rows))


if __name__ == "__main__":
    main()
