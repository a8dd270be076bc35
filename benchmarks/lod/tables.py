"""Triangles and time saved by chosen levels in scenes as in Liebisch (2021), compared with the printed numbers."""

from __future__ import annotations

import functools
import itertools
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness.report import start, table
from benchmarks.harness.timing import best
from benchmarks.lod._objects import RATIOS, RIFT_S, VIVE_PRO, Crowd, Headset, crowd, measured, sources
from benchmarks.lod._printed_turns import COUNTS, SIZES

LEVELS = 10
"""Number of levels of an object, as published: here down to 0.15 % of its triangles."""
DENSE = ("spot", "bunny", "dragon", "armadillo")
"""Objects that are split to only a million triangles, so that measuring them takes minutes, not hours."""
RADII = (0.5, 1.0)
"""Radii of objects, metres; the thesis does not print them."""
TWO_LEVELS = 0.008
"""Share of the triangles in the coarser one of two levels."""
MODES = ("depth", "depth+eccentricity", "fovea")
TIMED = 4
"""Number of drawn frames of a turn."""

Models = Sequence[nf.lod.LodModel]


FRAMES = 250
"""Number of frames of a turn: every tenth of the thesis' 2,500."""
DRAWS = 20
"""Number of balls with different object places."""
RADIUS = 0.5
"""Radius of an object, metres."""


@dataclass(frozen=True)
class Draws:
    """Balls of objects, and the turn of the camera in each."""

    size: float
    """Radius of the ball, metres."""
    count: int
    """Number of objects in the ball."""
    radius: float = RADIUS
    """Radius of an object, metres."""
    draws: int = DRAWS
    frames: int = FRAMES


@dataclass(frozen=True)
class Spread:
    """Mean over draws and its standard error."""

    mean: float
    error: float

    @staticmethod
    def from_values(values: Sequence[float]) -> Spread:
        """Compute the spread of one value for each draw."""
        return Spread(float(np.mean(values)), float(np.std(values, ddof=1) / np.sqrt(len(values))))

    def __str__(self) -> str:
        """Format with one decimal."""
        return f"{self.mean:.1f} ± {self.error:.1f}"


@dataclass(frozen=True)
class Turns:
    """Triangles of a mean frame by draw (D,): at full detail, and by the name of each selection method."""

    off: NDArray[np.float64]
    drawn: dict[str, NDArray[np.float64]]

    def saved(self, way: str, over: str | None = None) -> Spread:
        """Percentage of triangles that a method saves relative to another one, or to full detail."""
        before = self.off if over is None else self.drawn[over]
        return Spread.from_values((100 * (1 - self.drawn[way] / before)).tolist())


def turns(
    models: Sequence[nf.lod.LodModel],
    headset: Headset,
    ways: dict[str, nf.lod.Selector],
    how: Draws,
) -> Turns:
    """Choose levels in every frame of every draw; objects out of view are not drawn."""
    counts = np.zeros((len(models), max(map(len, models))))
    for n, model in enumerate(models):
        counts[n, : len(model)] = model.triangles
    cameras = [headset.camera(2 * np.pi * frame / how.frames) for frame in range(how.frames)]
    scatter = functools.partial(crowd, models, size=how.size, count=how.count, radius=how.radius)
    # Without size and radius in the seed, a ball twice as large of objects twice as large is the same scene.
    balls = [scatter(seed=(draw, round(how.size), round(1000 * how.radius))) for draw in range(how.draws)]
    every = [_turn(models, counts, ball, cameras, ways) for ball in balls]
    return Turns(
        np.array([off for off, _ in every]),
        {name: np.array([drawn[name] for _, drawn in every]) for name in ways},
    )


def _turn(
    models: Sequence[nf.lod.LodModel],
    counts: NDArray[np.float64],
    scene: Crowd,
    cameras: Sequence[nf.Camera],
    ways: dict[str, nf.lod.Selector],
) -> tuple[float, dict[str, float]]:
    """Triangles of a mean frame at full detail, and by each method."""
    off, drawn = 0.0, dict.fromkeys(ways, 0.0)
    for camera in cameras:
        for name, way in ways.items():
            levels = way.select(models, scene.model_index, scene.centers, scene.radii, camera=camera).level
            drawn[name] += _triangles(counts, scene, levels)
        off += _triangles(counts, scene, np.minimum(levels, 0))
    return off / len(cameras), {name: sum_ / len(cameras) for name, sum_ in drawn.items()}


def _triangles(counts: NDArray[np.float64], scene: Crowd, levels: NDArray[np.int32]) -> float:
    """Number of triangles in view."""
    seen = levels >= 0
    return float(counts[scene.model_index[seen], levels[seen]].sum())


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
    shares: list[list[object]] = []
    millions: list[list[object]] = []
    for size, count in itertools.product(SIZES, counts):
        printed, place = headset.printed[size], COUNTS.index(count)
        how = Draws(size=size, count=count, draws=draws, frames=frames)
        every = [turns(models, headset, ways(headset), replace(how, radius=radius)) for radius in RADII]
        depth, lens = ([str(one.saved(*way)) for one in every] for way in (["depth"], ["lens", "depth"]))
        shares.append([size, count, *depth, printed.depth[place], *lens, printed.lens[place]])
        theirs = printed.millions_off, printed.millions_depth, printed.millions_lens
        for radius, one in zip(RADII, every, strict=True):
            drawn = zip((one.off, one.drawn["depth"], one.drawn["lens"]), theirs, strict=True)
            millions.append([size, count, radius, *((mean.mean() / 1e6, each[place]) for mean, each in drawn)])
    full = np.mean([model.triangles[0] for model in models])
    kinds = (*(f", r = {r:g}" for r in RADII), ", printed {:g}")
    titles = [f"{what}{kind}" for what in ("depth", "lens") for kind in kinds]
    title = f"{headset.name}: {len(models)} objects of {full:,.0f} triangles on average, {frames} frames, {draws} draws"
    yield table(title, ["radius m", "objects {:,}", *titles], shares)
    yield "Per cent of triangles that depth saves of full detail, and that the lens saves of what depth left.\n"
    titles = [f"{way} (printed) {{:.3g}} ({{:g}})" for way in ("off", "depth", "lens")]
    header = ["radius m", "objects {:,}", "r {:g}", *titles]
    yield table(f"{headset.name}: millions of triangles of a mean frame", header, millions)


def ablation(headset: Headset, models: Models, sparse: Models, draws: int, frames: int) -> str:
    """Table of the influences on the share saved by the lens, for the greatest number of objects."""
    ten = of_ten(models)
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
    for name, own, radius, settings in cases:
        rows.append([name])
        for size in SIZES:
            how = Draws(size=size, count=COUNTS[-1], radius=radius, draws=draws, frames=frames)
            one = turns(own, headset, ways(headset, **settings), how)
            rows[-1] += [f"{one.saved('depth').mean:.1f}", str(one.saved("lens", "depth"))]
    printed = [headset.printed[size] for size in SIZES]
    rows.append(["printed", *(value for one in printed for value in (one.depth[-1], one.lens[-1]))])
    titles = [f"{size} m, {what} {{:g}}" for size in SIZES for what in ("depth", "lens")]
    return table(f"{headset.name}: per cent saved with {COUNTS[-1]:,} objects", ["", *titles], rows)


def times(models: Models, size: int, count: int, headset: Headset, backend: str) -> dict[str, float]:
    """Seconds of a mean frame by mode, colour only, including selection; the least of two turns."""
    scene = crowd(models, size=size, count=count)
    world = nf.lod.place(models, scene.model_index, scene.transforms)
    cameras = [headset.camera(2 * np.pi * frame / TIMED) for frame in range(TIMED)]

    def turn(mode: str) -> None:
        how = nf.lod.Selector(lens=headset.lens, mode=mode)
        for camera in cameras:
            nf.render(world, camera, lod=how, channels=("color",), backend=backend)

    return {mode: best(partial(turn, mode), repeat=2, warm=False).wall / TIMED for mode in ("off", *MODES)}


def timings(headset: Headset, models: Models, counts: tuple[int, ...], backend: str) -> str:
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
    header = ["radius m", "objects {:,}", *modes, *shares]
    return table(f"{title}, objects of {full:,.0f} triangles", header, rows)


def main() -> None:
    options = start(
        __doc__,
        "--quick",
        times=(bool, "draw frames, too, of the objects as they are"),
        backend={"default": "auto", "choices": ("auto", "cpu", "gpu")},
    )
    counts, draws, frames = (COUNTS[:1], 3, 25) if options.quick else (COUNTS, DRAWS, FRAMES)
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
