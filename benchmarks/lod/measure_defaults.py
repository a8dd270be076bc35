"""Time of measuring objects with the default settings, and the scores that are not needed.

`python -m benchmarks.lod.measure_defaults`. 144 views, 16 distances, four samples a pixel, the Rift S; the levels are
those of `simplify`. For comparison all scores of all levels are measured (`step=None, saturated=None`): the selected
levels and their curves must be equal up to the tolerance of `saturated`.
"""

from __future__ import annotations

import time
from typing import Any

import numpy as np

import nearfar as nf
from benchmarks.harness.timing import machine, table
from benchmarks.lod._objects import FILES
from benchmarks.lod.measure import RATIOS, sphere
from nearfar._base import data

HEADER = ["object", "triangles", "levels", "kept", "wall s", "CPU s", "scores", "all: wall s", "CPU s", "curves apart"]


def measured(levels: nf.lod.Levels, **settings: Any) -> tuple[nf.lod.LodModel, float, float]:
    """Measure levels; return the model, and wall and CPU seconds."""
    wall, cpu = time.perf_counter(), time.process_time()
    model = nf.lod.measure(levels, hmd=nf.hmd.RIFT_S, backend="cpu", cache=False, **settings)
    return model, time.perf_counter() - wall, time.process_time() - cpu


def row(name: str, levels: nf.lod.Levels) -> list[str]:
    model, *own = measured(levels)
    whole, *every = measured(levels, step=None, saturated=None)
    places = np.geomspace(*model.sigma, 100)
    kept = np.isin(whole.triangles, model.triangles)[1:]
    apart = np.abs(model.curves(places) - whole.curves(places)[kept]).max()
    done = model.measured["scores"] / whole.measured["scores"]
    counts = [f"{levels[0].triangle_count:,}", str(len(levels)), str(len(model))]
    times = [f"{seconds:.0f}" for seconds in own]
    return [name, *counts, *times, f"{done:.0%}", *(f"{seconds:.0f}" for seconds in every), f"{apart:.0e}"]


def main() -> None:
    rows = [row("sphere with bumps", nf.lod.simplify(sphere(159), RATIOS))]
    for name in ("armadillo", "FlightHelmet"):
        path = data.find(FILES[name])
        if path is not None:
            rows.append(row(name, nf.lod.simplify(nf.Scene.load(path))))
    print(machine())
    print(table("Measuring with the default settings", HEADER, rows))


if __name__ == "__main__":
    main()
