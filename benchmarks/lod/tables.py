"""Triangles and time saved by chosen levels in scenes as in Liebisch (2021), compared with the printed numbers.

python -m benchmarks.lod.tables [--quick] [--times] [--backend B]
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

import nearfar as nf
from benchmarks.harness.timing import machine, table
from benchmarks.lod._objects import RATIOS, RIFT_S, VIVE_PRO, Headset, crowd, measured, sources
from benchmarks.lod._printed_turns import COUNTS, SIZES
from benchmarks.lod._turns import DRAWS, FRAMES, RADIUS, Draws, turns
from nearfar.lod._select.rules import Mode

LEVELS = 10
"""Number of levels of an object, as published: here down to 0.15 % of its triangles."""
DENSE = ("spot", "bunny", "dragon", "armadillo")
"""Objects that are split to only a million triangles, so that measuring them takes minutes, not hours."""
RADII = (0.5, 1.0)
"""Radii of objects, metres; the thesis does not print them."""
TWO_LEVELS = 0.008
"""Share of the triangles in the coarser one of two levels."""
MODES: tuple[Mode, ...] = ("depth", "depth+eccentricity", "fovea")
TIMED_MODES: tuple[Mode, ...] = ("off", *MODES)
TIMED = 4
"""Number of drawn frames of a turn."""

Models = Sequence[nf.lod.LodModel]


def present(names: Sequence[str]) -> list[str]:
    """Return the available ones among named objects, or all available ones if none is."""
    at_hand = sources()
    return [name for name in names if name in at_hand] or list(at_hand)


def of_ten(models: Models) -> Models:
    """Return models with the finest `LEVELS` levels, or all if simplification stopped earlier."""
    return [model.of_levels(range(min(LEVELS, len(model)))) for model in models]


def ways(headset: Headset, **settings: Any) -> dict[str, nf.lod.Selector]:
    """Return selectors by size only, and through the lens."""
    depth = nf.lod.Selector(mode="depth", **settings)
    return {"depth": depth, "lens": nf.lod.Selector(lens=headset.lens, **settings)}


def saved(headset: Headset, models: Models, counts: tuple[int, ...], draws: int, frames: int) -> Iterator[str]:
    """Tables 5.12 to 5.15: percentage of triangles saved, and millions drawn."""
    shares, millions = [], []
    for size in SIZES:
        for count in counts:
            printed, place, row = headset.printed[size], COUNTS.index(count), [f"{size}", f"{count:,}"]
            how = Draws(size=size, count=count, draws=draws, frames=frames)
            every = [turns(models, headset, ways(headset), replace(how, radius=radius)) for radius in RADII]
            depth, lens = ([str(one.saved(*way)) for one in every] for way in (["depth"], ["lens", "depth"]))
            shares.append([*row, *depth, f"{printed.depth[place]:g}", *lens, f"{printed.lens[place]:g}"])
            for radius, one in zip(RADII, every, strict=True):
                drawn = (one.off, one.drawn["depth"], one.drawn["lens"])
                theirs = (printed.millions_off, printed.millions_depth, printed.millions_lens)
                beside = [
                    f"{mean.mean() / 1e6:.3g} ({each[place]:g})" for mean, each in zip(drawn, theirs, strict=True)
                ]
                millions.append([*row, f"{radius:g}", *beside])
    full = np.mean([model.triangles[0] for model in models])
    titles = [
        f"{what}{column}" for what in ("depth", "lens") for column in (*(f", r = {r:g}" for r in RADII), ", printed")
    ]
    title = f"{headset.name}: {len(models)} objects of {full:,.0f} triangles on average, {frames} frames, {draws} draws"
    yield table(title, ["radius m", "objects", *titles], shares)
    yield "Per cent of triangles that depth saves of full detail, and that the lens saves of what depth left.\n"
    titles = ["radius m", "objects", "r", "off (printed)", "depth (printed)", "lens (printed)"]
    yield table(f"{headset.name}: millions of triangles of a mean frame", titles, millions)


def ablation(headset: Headset, models: Models, sparse: Models, draws: int, frames: int) -> str:
    """Table of the influences on the share saved by the lens, for the greatest number of objects."""
    ten = of_ten(models)
    curve = nf.lod.Curve4PL([1.0], [1.0], [1e-3], [1.0])
    two = [
        nf.lod.LodModel(
            triangles=np.array([model.triangles[0], TWO_LEVELS * model.triangles[0]], np.int64),
            curves=curve,
            sigma=model.sigma,
            pixel=model.pixel,
        )
        for model in models
    ]
    cases: list[tuple[str, Models, float, dict[str, Any]]] = [
        ("ten levels", ten, RADIUS, {}),
        ("ten levels, r = 1", ten, 1.0, {}),
        ("limit on the object's own size", ten, RADIUS, {"limit": "own"}),
        ("limit on the object's own size, r = 1", ten, 1.0, {"limit": "own"}),
        (f"twelve levels, down to {100 * RATIOS[-1]:g} %", models, RADIUS, {}),
        ("a tenth as many triangles", sparse, RADIUS, {}),
        (f"two levels, the coarser {100 * TWO_LEVELS:g} %, r = 0.9", two, 0.9, {}),
        ("literal threshold", ten, RADIUS, {"threshold": "literal"}),
        ("normalized threshold", ten, RADIUS, {"threshold": "normalized"}),
    ]
    rows = []
    for name, own, radius, settings in cases:
        row = [name]
        for size in SIZES:
            how = Draws(size=size, count=COUNTS[-1], radius=radius, draws=draws, frames=frames)
            one = turns(own, headset, ways(headset, **settings), how)
            row += [f"{one.saved('depth').mean:.1f}", str(one.saved("lens", "depth"))]
        rows.append(row)
    printed = [headset.printed[size] for size in SIZES]
    rows.append(["printed", *(f"{value:g}" for one in printed for value in (one.depth[-1], one.lens[-1]))])
    titles = [f"{size} m, {what}" for size in SIZES for what in ("depth", "lens")]
    return table(f"{headset.name}: per cent saved with {COUNTS[-1]:,} objects", ["", *titles], rows)


def times(models: Models, size: int, count: int, headset: Headset, backend: str) -> dict[str, float]:
    """Seconds of a mean frame by mode, colour only, including selection; the least of two turns."""
    scene = crowd(models, size=size, count=count)
    world = nf.lod.place(models, scene.model_index, scene.transforms)
    seconds: dict[str, float] = {}
    for mode in TIMED_MODES:
        how = nf.lod.Selector(lens=headset.lens, mode=mode)
        turned = []
        for _ in range(2):
            started = time.perf_counter()
            for frame in range(TIMED):
                camera = headset.camera(2 * np.pi * frame / TIMED)
                nf.render(world, camera, lod=how, channels=("color",), backend=backend)
            turned.append((time.perf_counter() - started) / TIMED)
        seconds[mode] = min(turned)
    return seconds


def timings(headset: Headset, models: Models, counts: tuple[int, ...], backend: str) -> str:
    """Tables 5.16 and 5.17: render times."""
    rows = []
    for size in SIZES:
        for count in counts:
            seconds, printed = times(models, size, count, headset, backend), headset.printed[size]
            by_depth = 100 * (1 - seconds["depth"] / seconds["off"])
            by_lens = 100 * (1 - seconds[MODES[1]] / seconds["depth"])
            place, milliseconds = COUNTS.index(count), [f"{1000 * seconds[mode]:.0f}" for mode in TIMED_MODES]
            theirs = [printed.time_depth[place], printed.time_lens[place] if printed.time_lens else "< 1.5"]
            shares = [f"{by_depth:.1f} ({theirs[0]})", f"{by_lens:.1f} ({theirs[1]})"]
            rows.append([f"{size}", f"{count:,}", *milliseconds, *shares])
    width, height = headset.size
    titles = ["radius m", "objects", *TIMED_MODES, "saved by depth % (printed)", "further by lens % (printed)"]
    full = np.mean([model.triangles[0] for model in models])
    title = f"{headset.name}: milliseconds of a frame of {width} x {height}, colour, backend={backend!r}"
    return table(f"{title}, objects of {full:,.0f} triangles", titles, rows)


def main() -> None:
    """Print the tables."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="the objects as they are, and fewer scenes and frames")
    parser.add_argument("--times", action="store_true", help="draw frames, too, of the objects as they are")
    parser.add_argument("--backend", default="auto", choices=("auto", "cpu", "gpu"))
    options = parser.parse_args()
    counts, draws, frames = (COUNTS[:1], 3, 25) if options.quick else (COUNTS, DRAWS, FRAMES)
    print(machine())
    for headset in (RIFT_S, VIVE_PRO):
        names = present(DENSE)
        sparse = measured(headset, names, step=None)
        exact: dict[str, Any] = {"views": 144, "directions": "published", "step": None}
        dense = sparse if options.quick else measured(headset, names, dense=True, **exact)
        print("\n".join(saved(headset, of_ten(dense), counts, draws, frames)), flush=True)
        print(ablation(headset, dense, sparse, draws, frames), flush=True)
        if options.times:
            print(timings(headset, measured(headset), counts, options.backend), flush=True)


if __name__ == "__main__":
    main()
