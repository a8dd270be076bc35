"""Time of measuring objects with the default settings, and the share of all scores that is computed.

16 distances, four samples a pixel, the Rift S; the levels are those of `simplify`. The main thread's CPU seconds are
those that are not parallel. For comparison all levels are measured from all 144 views (`MeasureSettings.full`); curves
differ by the standard error of the defaults.
"""

from __future__ import annotations

import time
from functools import partial

import numpy as np

import nearfar as nf
from benchmarks.harness import scenes
from benchmarks.harness.report import start, table
from benchmarks.harness.timing import timed
from benchmarks.lod.measure import RATIOS
from tests.support import lod_cases

HEADER = "object | triangles {:,} | levels | kept | wall s {:.0f} | CPU s {:.0f} | main thread s {:.1f}"
HEADER += " | scores {:.0%} | all: wall s {:.0f} | CPU s {:.0f} | curves apart {:.0e}"


def row(name: str, levels: nf.lod.Levels) -> list[object]:
    measure = partial(nf.lod.measure, levels, hmd=nf.hmd.RIFT_S, backend="cpu", cache=False)
    main_thread = time.thread_time()
    model, model_time = timed(measure)
    main_thread = time.thread_time() - main_thread
    full_model, full_time = timed(measure, settings=nf.lod.MeasureSettings.full(hmd=nf.hmd.RIFT_S))
    sigma = np.geomspace(*model.sigma, 100)
    is_kept = np.isin(full_model.triangles, model.triangles)[1:]
    difference = np.abs(model.curves(sigma) - full_model.curves(sigma)[is_kept]).max()
    fraction = model.measured["scores"] / full_model.measured["scores"]
    counts = levels[0].triangle_count, len(levels), len(model)
    times = model_time.wall, model_time.cpu, main_thread
    return [name, *counts, *times, fraction, full_time.wall, full_time.cpu, difference]


def main() -> None:
    start(__doc__)
    rows = [row("sphere with bumps", nf.lod.simplify(lod_cases.scene(159), RATIOS))]
    rows += [row(name, nf.lod.simplify(scene)) for name, scene in scenes.present("armadillo", "FlightHelmet")]
    print(table("Measuring with the default settings", HEADER, rows))


if __name__ == "__main__":
    main()
