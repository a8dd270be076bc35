"""Triangles and time that chosen levels save in scenes built as Liebisch (2021) built them, beside his printed numbers.

python -m benchmarks.lod.tables [--quick] [--views N] [--backend B]
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness.timing import machine, table
from benchmarks.lod._objects import RIFT_S, VIEWS, VIVE_PRO, Crowd, Headset, crowd, measured

SIZES = (10, 15, 20, 30)
"""Radii of the balls, metres."""
COUNTS = (100, 500, 1000)
"""Objects in a ball."""
FRAMES = 2500
"""Frames of a turn."""
THRESHOLDS = ("anchored", "literal", "normalized")
MODES = ("depth", "depth+eccentricity", "fovea")
PRINTED_DEPTH = "91.7 to 99.1"
"""Per cent of triangles that depth saves, as published."""


@dataclass(frozen=True)
class Turn:
    """Triangles of a full turn of the camera in the middle of a scene."""

    off: float
    """Triangles of a mean frame at full detail."""
    drawn: dict[tuple[str, str], float]
    """Triangles of a mean frame by threshold and mode."""

    def saved(self, threshold: str, mode: str, over: str | None = None) -> float:
        """Per cent of triangles that a mode saves beyond another one, or of full detail."""
        before = self.off if over is None else self.drawn[threshold, over]
        return 100 * (1 - self.drawn[threshold, mode] / before)


def turn(models: list[nf.lod.LodModel], scene: Crowd, headset: Headset, frames: int) -> Turn:
    """Choose levels in every frame; objects out of view are not drawn in any mode."""
    counts = np.zeros((len(models), max(map(len, models))))
    for n, model in enumerate(models):
        counts[n, : len(model)] = model.triangles
    drawn = dict.fromkeys(((threshold, mode) for threshold in THRESHOLDS for mode in MODES), 0.0)
    off = 0.0
    for frame in range(frames):
        camera = headset.camera(2 * np.pi * frame / frames)
        for threshold, mode in drawn:
            levels = choose(models, scene, camera, headset, mode, threshold)
            drawn[threshold, mode] += triangles(counts, scene, levels)
        off += triangles(counts, scene, np.minimum(levels, 0))
    return Turn(off / frames, {key: value / frames for key, value in drawn.items()})


def choose(
    models: list[nf.lod.LodModel],
    scene: Crowd,
    camera: nf.Camera,
    headset: Headset,
    mode: str,
    threshold: str,
) -> NDArray[np.int32]:
    """Levels of a frame."""
    return nf.lod.select(
        models,
        scene.model_index,
        scene.centers,
        scene.radii,
        camera=camera,
        lens=headset.lens,
        mode=mode,
        threshold=threshold,
    ).level


def triangles(counts: NDArray[np.float64], scene: Crowd, levels: NDArray[np.int32]) -> float:
    """Triangles in view."""
    seen = levels >= 0
    return float(counts[scene.model_index[seen], levels[seen]].sum())


def times(models: list[nf.lod.LodModel], scene: Crowd, headset: Headset, frames: int, backend: str) -> dict[str, float]:
    """Seconds of a mean frame by mode, colour only, choosing included; the least of two turns."""
    world = nf.lod.place(models, scene.model_index, scene.transforms)
    seconds = {}
    for mode in ("off", *MODES):
        how = nf.lod.Selector(lens=headset.lens, mode=mode)
        turns = []
        for _ in range(2):
            started = time.perf_counter()
            for frame in range(frames):
                camera = headset.camera(2 * np.pi * frame / frames)
                nf.render(world, camera, lod=how, channels=("color",), backend=backend)
            turns.append((time.perf_counter() - started) / frames)
        seconds[mode] = min(turns)
    return seconds


def report(headset: Headset, models: list[nf.lod.LodModel], frames: int, counts: tuple[int, ...]) -> Iterator[str]:
    """Tables for a headset."""
    full = np.mean([model.triangles[0] for model in models])
    rows = []
    for size in SIZES:
        for count in counts:
            drawn = turn(models, crowd(models, size=size, count=count, seed=size * count), headset, frames)
            rows.append(
                [
                    f"{size}",
                    f"{count:,}",
                    f"{drawn.off:,.0f}",
                    *(f"{drawn.saved(threshold, 'depth'):.1f}" for threshold in THRESHOLDS),
                    *(f"{drawn.saved(threshold, MODES[1], 'depth'):.1f}" for threshold in THRESHOLDS),
                    f"{headset.printed[size]:g}",
                    f"{drawn.saved('anchored', 'fovea', MODES[1]):.1f}",
                ]
            )
    titles = ["radius m", "objects", "full detail", *(f"depth, {threshold}" for threshold in THRESHOLDS)]
    titles += [*(f"lens, {threshold}" for threshold in THRESHOLDS), "lens, printed", "fovea"]
    title = f"{headset.name}: {len(models)} objects of {full:,.0f} triangles on average, {frames:,} frames a turn"
    yield table(title, titles, rows)
    yield f"Per cent of triangles saved: by depth of full detail (printed: {PRINTED_DEPTH}), by the lens of what depth"
    yield "left, by the falloff of acuity of what the lens left (threshold anchored).\n"


def timings(
    headset: Headset, models: list[nf.lod.LodModel], frames: int, counts: tuple[int, ...], backend: str
) -> Iterator[str]:
    """Render times for a headset."""
    rows = []
    for size in SIZES:
        for count in counts:
            seconds = times(models, crowd(models, size=size, count=count, seed=size * count), headset, frames, backend)
            saved = [100 * (1 - seconds[mode] / seconds["off"]) for mode in MODES]
            further = 100 * (1 - seconds[MODES[1]] / seconds["depth"])
            milliseconds = [f"{1000 * seconds[mode]:.0f}" for mode in ("off", *MODES)]
            rows.append([f"{size}", f"{count:,}", *milliseconds, f"{saved[0]:.1f}", f"{further:.1f}"])
    width, height = headset.size
    titles = ["radius m", "objects", "off", *MODES, "saved by depth %", "further by lens %"]
    title = f"{headset.name}: milliseconds of a frame of {width} x {height}, colour, backend={backend!r}"
    yield table(title, titles, rows)
    yield "Printed: 90 to 97 % by depth, and from 20 to less than 1.5 % by the lens."


def main() -> None:
    """Print the tables."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="few frames of the smaller scenes")
    parser.add_argument("--views", type=int, default=VIEWS, help="from how many sides objects are measured")
    parser.add_argument("--backend", default="auto", choices=("auto", "cpu", "gpu"))
    options = parser.parse_args()
    counts, frames = ((100,), 50) if options.quick else (COUNTS, FRAMES)
    print(machine())
    for headset in (RIFT_S, VIVE_PRO):
        models = measured(headset, views=options.views)
        print("\n".join(report(headset, models, frames, counts)), flush=True)
        print("\n".join(timings(headset, models, 4, counts, options.backend)), flush=True)


if __name__ == "__main__":
    main()
