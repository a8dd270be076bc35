"""How scores differ between Wang's window of 11 × 11 pixels, which `measure` uses, and the thesis' of 10 × 10.

Pictures of four objects' levels, from evenly spread directions at six of the 16 distances of `measure`, are scored with
three windows. The thesis states the size of its window, but not its weights: probably they are Wang's Gaussian, σ 1.5,
cut to 10 × 10; uniform weights are the other extreme. A window of 10 pixels extends one pixel further up and left.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness.report import start, table
from benchmarks.lod._objects import BY_MESHOPT, sources
from nearfar.lod._measure import statistic
from nearfar.lod._measure.scores import pictures
from nearfar.lod._measure.views import Orbit, Screen, turns
from nearfar.lod._simplify.simplify import Method

Array = NDArray[np.float64]

WINDOWS: dict[str, dict[str, Any]] = {
    "Gaussian, 11 × 11": {},
    "Gaussian, 10 × 10": {"size": 10},
    "uniform, 10 × 10": {"window": "uniform", "size": 10},
}
"""Settings of `nf.metrics.ssim_pairs` by name, ours first."""

OBJECTS = ("bunny", "armadillo", "FlightHelmet", "knot")
RATIOS = (0.25, 0.06, 0.015)
DISTANCES = (1, 2, 3, 5, 9, 16)
VIEWS, SAMPLES = 24, 4


def scores(levels: nf.lod.Levels, screen: Screen, distances: Sequence[int], views: int, samples: int) -> Array:
    """Scores of all levels except the base (W, K − 1, D, V): by window, level, distance and view."""
    orbit = Orbit.of_levels(levels, screen, screen.sines("published", max(distances)))
    scored = np.empty((len(WINDOWS), len(levels) - 1, len(distances), views))
    for n, distance in enumerate(distances):
        cameras = [orbit.camera(distance, turn) for turn in turns(views, "even")[0]]
        base, *coarser = (pictures(level.scene, cameras, samples, "cpu") for level in levels)
        for level, test in enumerate(coarser):
            masks = base.is_object | test.is_object
            for window, options in enumerate(WINDOWS.values()):
                similarity = nf.metrics.ssim_pairs(base.luma, test.luma, data_range=255.0, masks=masks, **options)
                scored[window, level, n] = similarity
    return scored


def rows(name: str, scored: Array) -> list[list[Any]]:
    """Make a row for each window but the first: changes of single scores and of the 25th percentiles of the views."""
    table_rows: list[list[Any]] = []
    for window, test in list(zip(WINDOWS, scored, strict=True))[1:]:
        changes = [test - scored[0], statistic.of_views(test, 25.0) - statistic.of_views(scored[0], 25.0)]
        numbers = (number for change in changes for number in (change.mean(), np.abs(change).max()))
        table_rows.append([name, window, *numbers])
    return table_rows


def main() -> None:
    views = start(__doc__, views=VIEWS).views
    loaders, screen = sources(), Screen.from_arguments(nf.hmd.RIFT_S, None, None)
    table_rows, parts = [], []
    for name in (name for name in OBJECTS if name in loaders):
        method: Method = "meshopt" if name in BY_MESHOPT else "fast"
        levels = nf.lod.simplify(loaders[name](), RATIOS, method=method, normals="smooth", name=name)
        parts.append(scores(levels, screen, DISTANCES, views, SAMPLES))
        table_rows += rows(name, parts[-1])
    table_rows += rows("all", np.concatenate(parts, axis=1))
    header = "object | window | mean change of a view's score {:.4f} | greatest {:.4f}"
    header += " | of the 25th percentile: mean {:.4f} | greatest {:.4f}"
    print(table(f"Scores beside those of the Gaussian window of 11 × 11, {views} views", header, table_rows))


if __name__ == "__main__":
    main()
