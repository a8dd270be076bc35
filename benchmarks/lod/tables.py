"""Triangles and time saved by chosen levels in scenes as in Liebisch (2021), compared with the printed numbers."""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness.report import start, table
from benchmarks.harness.timing import best
from benchmarks.lod._objects import RATIOS, RIFT_S, VIVE_PRO, Crowd, Headset, crowd, measure_objects, sources
from benchmarks.lod._printed_turns import COUNTS, SIZES
from nearfar._render.backend import Backend

LEVELS = 10
"""Number of levels of an object, as published: here down to 0.15 % of its triangles."""
DENSE = ("spot", "bunny", "dragon", "armadillo")
"""Objects refined to about a million triangles; the thesis' had more, but measuring those would take hours."""
RADII = (0.5, 1.0)
"""Radii of objects, metres; the thesis does not print them."""
TWO_LEVELS = 0.008
"""Share of the triangles in the coarser one of two levels."""
MODES: tuple[Any, ...] = ("depth", "depth+eccentricity", "fovea")
TIMED = 4
"""Number of drawn frames of a turn."""

Models = Sequence[nf.lod.LodModel]

FRAMES = 250
"""Number of frames of a turn: every tenth of the thesis' 2,500."""
TRIALS = 20
"""Number of balls with different object places."""
RADIUS = 0.5
"""Radius of an object, metres."""


def mean_and_error(values: NDArray[np.float64]) -> str:
    """Format the mean over trials with its standard error."""
    return f"{values.mean():.1f} ± {values.std(ddof=1) / np.sqrt(len(values)):.1f}"


@dataclass(frozen=True)
class Turns:
    """Triangles of a mean frame by trial (T,): at full detail, and by the name of each selection method."""

    full: NDArray[np.float64]
    drawn: dict[str, NDArray[np.float64]]

    def saved(self, method: str, over: str | None = None) -> NDArray[np.float64]:
        """Percentage of triangles (T,) that a method saves relative to another one, or to full detail."""
        return 100 * (1 - self.drawn[method] / (self.full if over is None else self.drawn[over]))


def turns(
    models: Models,
    headset: Headset,
    selectors: dict[str, nf.lod.Selector],
    *,
    size: float,
    count: int,
    radius: float,
    trials: int,
    frames: int,
) -> Turns:
    """Choose levels in every frame of a turn in each of several balls; objects out of view are not drawn.

    A ball of radius `size` holds `count` objects of the given radius, metres.
    """
    counts = np.zeros((len(models), max(map(len, models))))
    for n, model in enumerate(models):
        counts[n, : len(model)] = model.triangles
    cameras = [headset.camera(2 * np.pi * frame / frames) for frame in range(frames)]
    full, drawn = np.zeros(trials), {name: np.zeros(trials) for name in selectors}
    for trial in range(trials):
        # With equal seeds, a ball and objects of twice the size would be the same scene.
        scene = crowd(models, size=size, count=count, radius=radius, seed=(trial, round(size), round(1000 * radius)))
        for camera in cameras:
            for name, selector in selectors.items():
                levels = selector.select(models, scene.model_index, scene.centers, scene.radii, camera=camera).level
                drawn[name][trial] += _triangles(counts, scene, levels)
            full[trial] += _triangles(counts, scene, np.minimum(levels, 0))
    return Turns(full / len(cameras), {name: triangles / len(cameras) for name, triangles in drawn.items()})


def _triangles(counts: NDArray[np.float64], scene: Crowd, levels: NDArray[np.int32]) -> float:
    in_view = levels >= 0
    return float(counts[scene.model_index[in_view], levels[in_view]].sum())


def limit_levels(models: Models) -> Models:
    """Return models with the finest `LEVELS` levels, or all if simplification stopped earlier."""
    return [model.of_levels(range(min(LEVELS, len(model)))) for model in models]


def selectors(headset: Headset, **settings: Any) -> dict[str, nf.lod.Selector]:
    return {"depth": nf.lod.Selector(mode="depth", **settings), "lens": nf.lod.Selector(lens=headset.lens, **settings)}


def saved(headset: Headset, models: Models, counts: tuple[int, ...], trials: int, frames: int) -> Iterator[str]:
    """Tables 5.12 to 5.15: percentages of triangles saved, and millions of triangles drawn."""
    shares: list[list[object]] = []
    millions: list[list[object]] = []
    for size, count in itertools.product(SIZES, counts):
        printed, column = headset.printed[size], COUNTS.index(count)
        scatter = partial(turns, models, headset, selectors(headset), size=size, count=count)
        radius_turns = [scatter(radius=radius, trials=trials, frames=frames) for radius in RADII]
        depth = [mean_and_error(turn.saved("depth")) for turn in radius_turns]
        lens = [mean_and_error(turn.saved("lens", "depth")) for turn in radius_turns]
        shares.append([size, count, *depth, printed.depth[column], *lens, printed.lens[column]])
        published = printed.millions_off, printed.millions_depth, printed.millions_lens
        for radius, turn in zip(RADII, radius_turns, strict=True):
            drawn = zip((turn.full, turn.drawn["depth"], turn.drawn["lens"]), published, strict=True)
            millions.append([size, count, radius, *((mean.mean() / 1e6, row[column]) for mean, row in drawn)])
    full = np.mean([model.triangles[0] for model in models])
    kinds = (*(f", r = {r:g}" for r in RADII), ", printed {:g}")
    titles = [f"{what}{kind}" for what in ("depth", "lens") for kind in kinds]
    title = f"{headset.name}: {len(models)} objects of {full:,.0f} triangles (mean), {frames} frames, {trials} trials"
    yield table(title, ["radius m", "objects {:,}", *titles], shares)
    yield "Per cent of triangles that depth saves of full detail, and that the lens saves of what depth left.\n"
    titles = [f"{method} (printed) {{:.3g}} ({{:g}})" for method in ("off", "depth", "lens")]
    header = ["radius m", "objects {:,}", "r {:g}", *titles]
    yield table(f"{headset.name}: millions of triangles of a mean frame", header, millions)


def ablation(headset: Headset, models: Models, sparse: Models, trials: int, frames: int) -> str:
    """Table of influences on the share of triangles saved by the lens, for the greatest number of objects."""
    ten = limit_levels(models)
    curve = nf.lod.Curve4PL([1.0], [1.0], [1e-3], [1.0])
    both = [np.array([1.0, TWO_LEVELS]) * model.triangles[0] for model in models]
    two = [
        nf.lod.LodModel(triangles=counts.astype(np.int64), curves=curve, sigma=model.sigma, pixel=model.pixel)
        for model, counts in zip(models, both, strict=True)
    ]
    own_size = "limit on the object's own size"
    cases: list[tuple[str, Models, float, dict[str, Any]]] = [
        ("ten levels", ten, RADIUS, {}),
        ("ten levels, r = 1", ten, 1.0, {}),
        (own_size, ten, RADIUS, {"limit": "own"}),
        (f"{own_size}, r = 1", ten, 1.0, {"limit": "own"}),
        (f"twelve levels, down to {100 * RATIOS[-1]:g} %", models, RADIUS, {}),
        ("a tenth as many triangles", sparse, RADIUS, {}),
        (f"two levels, the coarser {100 * TWO_LEVELS:g} %, r = 0.9", two, 0.9, {}),
        ("literal threshold", ten, RADIUS, {"threshold": "literal"}),
        ("normalized threshold", ten, RADIUS, {"threshold": "normalized"}),
    ]
    rows: list[list[object]] = []
    for name, case_models, radius, settings in cases:
        rows.append([name])
        for size in SIZES:
            scatter = partial(turns, case_models, headset, selectors(headset, **settings), size=size, count=COUNTS[-1])
            turn = scatter(radius=radius, trials=trials, frames=frames)
            rows[-1] += [f"{turn.saved('depth').mean():.1f}", mean_and_error(turn.saved("lens", "depth"))]
    printed = [headset.printed[size] for size in SIZES]
    rows.append(["printed", *(value for turn in printed for value in (turn.depth[-1], turn.lens[-1]))])
    titles = [f"{size} m, {what} {{:g}}" for size in SIZES for what in ("depth", "lens")]
    return table(f"{headset.name}: per cent saved with {COUNTS[-1]:,} objects", ["", *titles], rows)


def times(models: Models, size: int, count: int, headset: Headset, backend: Backend) -> dict[str, float]:
    """Seconds of a mean frame by mode, colour only, including selection; the least of two turns."""
    scene = crowd(models, size=size, count=count)
    world = nf.lod.place(models, scene.model_index, scene.transforms)
    cameras = [headset.camera(2 * np.pi * frame / TIMED) for frame in range(TIMED)]

    def turn(mode: Any) -> None:
        selector = nf.lod.Selector(lens=headset.lens, mode=mode)
        for camera in cameras:
            nf.render(world, camera, lod=selector, channels=("color",), backend=backend)

    return {mode: best(partial(turn, mode), repeat=2, warm=False).wall / TIMED for mode in ("off", *MODES)}


def timings(headset: Headset, models: Models, counts: tuple[int, ...], backend: Backend) -> str:
    """Tables 5.16 and 5.17: render times."""
    rows = []
    for size, count in itertools.product(SIZES, counts):
        seconds, printed = times(models, size, count, headset, backend), headset.printed[size]
        place, milliseconds = COUNTS.index(count), [1e3 * seconds[mode] for mode in ("off", *MODES)]
        by_depth = 100 * (1 - seconds["depth"] / seconds["off"]), printed.time_depth[place]
        theirs = printed.time_lens[place] if printed.time_lens else "< 1.5"
        by_lens = 100 * (1 - seconds[MODES[1]] / seconds["depth"]), theirs
        rows.append([size, count, *milliseconds, by_depth, by_lens])
    width, height = headset.size
    modes = (f"{mode} {{:.0f}}" for mode in ("off", *MODES))
    shares = (f"{what} % (printed) {{:.1f}} ({{}})" for what in ("saved by depth", "further by lens"))
    full = np.mean([model.triangles[0] for model in models])
    title = f"{headset.name}: milliseconds of a frame of {width} x {height}, colour, backend={backend!r}"
    return table(f"{title}, objects of {full:,.0f} triangles", ["radius m", "objects {:,}", *modes, *shares], rows)


def main() -> None:
    options = start(
        __doc__,
        "--quick",
        times=(bool, "also time the rendering of frames, with the original objects"),
        backend={"default": "auto", "choices": ("auto", "cpu", "gpu")},
    )
    counts, trials, frames = (COUNTS[:1], 3, 25) if options.quick else (COUNTS, TRIALS, FRAMES)
    for headset in (RIFT_S, VIVE_PRO):
        names = [name for name in DENSE if name in sources()] or list(sources())
        sparse = measure_objects(headset, names, step=None)
        exact: dict[str, Any] = {"views": 144, "directions": "published", "step": None}
        dense = sparse if options.quick else measure_objects(headset, names, dense=True, **exact)
        print("\n".join(saved(headset, limit_levels(dense), counts, trials, frames)), flush=True)
        print(ablation(headset, dense, sparse, trials, frames), flush=True)
        if options.times:
            print(timings(headset, measure_objects(headset), counts, options.backend), flush=True)


if __name__ == "__main__":
    main()
