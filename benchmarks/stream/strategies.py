"""The four strategies of CloVR (2024) simulated: times, visible objects, and tests of the differences.

`clovr` fades in ring after ring, and each then grows; `clovrd` shows the same rings at once. `vis0` shows nothing until
the near objects visible from the centre and the last map have arrived, `vis1` shows these objects as they arrive
(docs/strategies.md). Measured are object completion by count (OVC) and by pixels (OFC), and visual continuity.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

import nearfar as nf
from benchmarks.harness.report import folder_or_temporary, save_figure, start, subplots, table
from benchmarks.harness.timing import timed
from benchmarks.stream import _comparison
from benchmarks.stream._near import EYE_HEIGHT, Place, places
from nearfar.stream._client_pictures import Pictures, SceneParts
from nearfar.stream._radii import PUBLISHED
from nearfar.stream._strategies import STRATEGIES, HeadPath, Strategy

MBPS, RTT = 50.0, 20.0
"""Rate in megabits per second, as in CloVR, and round trip in milliseconds."""
TRIANGLES_PER_SECOND, DISPLAY = 181e6, 72.0
"""Triangles per second of a device, and frames per second of its display. CloVR prints 5.09 frames per second for its
unreduced City, which is assumed to have 35.6 million triangles."""

PARTS = ("times", "seen", "comparison")
COLORS = {"vis0": "C3", "vis1": "C1", "clovr": "C0", "clovrd": "C2"}

Timelines = dict[str, nf.stream.Timeline]
"""Timelines by strategy."""


@dataclass
class Case:
    """A bundle about a centre of a scene."""

    place: Place
    scene: nf.Scene
    bundle: nf.stream.Bundle


def export_places(quick: bool, number: int | None, folder: Path) -> list[Case]:
    """Export four places, or one of them; the second centre of the factory is 30 m along the hall."""
    all_places = places(quick)
    x, _, z = all_places[-1].center
    all_places.append(replace(all_places[-1], name="factory, 30 m on", center=(x + 30.0, EYE_HEIGHT, z)))
    indices = range(len(all_places)) if number is None else [number]
    return [export(all_places[index], folder / str(index), quick) for index in indices]


def export(place: Place, folder: Path, quick: bool, *, instanced: bool = True) -> Case:
    """Export a place's bundle. If not `instanced`, instances are copied and the files are not compressed."""
    scene = place.make(instanced=instanced)
    bundle = write_bundle(scene, place, folder, PUBLISHED, quick, "meshopt" if instanced else None)
    return Case(replace(place, name=place.name if instanced else f"{place.name}, copies, plain"), scene, bundle)


def write_bundle(
    scene: nf.Scene, place: Place, folder: Path, radii: Sequence[float], quick: bool, compression: Any = "meshopt"
) -> nf.stream.Bundle:
    settings: dict[str, Any] = {"face_size": 128 if quick else 1024, "by_footprint": True, "compression": compression}
    return nf.stream.export(scene, folder, center=place.center, radii=radii, **settings)


def timelines_of(case: Case, link: nf.stream.Link, gzip: bool) -> Timelines:
    settings: dict[str, Any] = {"link": link, "gzip": gzip, "triangles_per_second": TRIANGLES_PER_SECOND}
    return {name: nf.stream.simulate(case.bundle, strategy=name, **settings) for name in STRATEGIES}


def by_radius(case: Case, link: nf.stream.Link, gzip: bool, quick: bool) -> dict[str, list[float]]:
    """For vis0 and vis1: seconds until all is loaded, by the outermost radius; each radius has its own bundle."""
    strategies: tuple[Strategy, ...] = ("vis0", "vis1")
    totals: dict[str, list[float]] = {name: [] for name in strategies}
    for count in range(1, len(PUBLISHED) + 1):
        with folder_or_temporary() as folder:
            bundle = write_bundle(case.scene, case.place, folder / "bundle", PUBLISHED[:count], quick)
            for name in strategies:
                totals[name].append(nf.stream.simulate(bundle, link=link, strategy=name, gzip=gzip).total)
    return totals


def print_times(cases: list[Case], link: nf.stream.Link, gzip: bool) -> None:
    rows = []
    for case in cases:
        timelines, took = timed(timelines_of, case, link, gzip)
        for name, timeline in timelines.items():
            ends = timeline.picture, timeline.first_ring, timeline.total, timeline.grown
            rows.append([case.place.name, name, timeline.received[-1, 1] / 1e6, *ends, None])
        rows[-1][-1] = took.wall
    columns = ("MB", "picture, s", "near geometry, s", "all files, s", "last growth, s", "simulation took, s")
    header = ["place", "strategy", *(f"{name} {{:.2f}}" for name in columns)]
    packed = ", compressed" if gzip else ""
    print(table(f"{MBPS:g} Mb/s, {link.rtt_ms:g} ms, loss {link.loss:g}{packed}", header, rows))


def print_seen(cases: list[Case], timelines: dict[str, Timelines], size: int, every: float) -> dict[str, Timelines]:
    """Print OVC, OFC and continuity for a user 1 m to the left of the centre, in all directions."""
    measured, rows = {}, []
    for case in cases:
        x, y, z = case.bundle.center
        eye = (x - 1.0, y, z)
        parts = SceneParts.bake(case.scene, case.bundle, None, size)
        measure = partial(_comparison.measure_pictures, parts=parts, path=HeadPath.parse(eye, (x, y, z)), every=every)
        place_timelines = {
            name: replace(timeline, pictures=measure(timeline)) for name, timeline in timelines[case.place.name].items()
        }
        measured[case.place.name] = place_timelines
        pictures = Pictures(parts, by_footprint=False)
        # The picture of ring None is the truth. More than what is visible from the centre cannot be shown.
        truth_at_center = pictures.picture(None, (x, y, z)).objects
        limit = nf.metrics.object_completion(pictures.picture(None, eye).objects, truth_at_center)
        rows.append([case.place.name, "truth at the centre", *limit, None, None, None])
        for name, timeline in place_timelines.items():
            # Since the first picture.
            later = timeline.pictures["continuity"][timeline.pictures["time"] > timeline.picture + 0.1]
            shares = (timeline.pictures[kind][index] for index in (1, -1) for kind in ("ovc", "ofc"))
            rows.append([case.place.name, name, *shares, min(later, default=math.nan)])
    header = "place | strategy | first OVC {:.3f} | OFC {:.3f} | last OVC {:.3f} | OFC {:.3f}"
    header += " | least continuity after the picture {:.5f}"
    print(table("a user 1 m to the left of the centre", header, rows))
    return measured


def print_comparison(cases: list[Case], link: nf.stream.Link, size: tuple[int, int]) -> None:
    """Print the comparison of the strategies by 20 users, CloVR's experiment 1."""
    rows, tests = [], []
    for case in cases:
        parts = SceneParts.bake(case.scene, case.bundle, _comparison.camera_of(case.bundle.center, 0.0, size), 16)
        for kind, values in _comparison.quality(case.bundle, parts, link, size).items():
            means = zip(values.mean(0), values.std(0, ddof=1), strict=True)
            chi, p, pairs = _comparison.significance(values)
            rows.append([case.place.name, kind.upper(), *means, chi, p])
            for pair in pairs:
                sure = "yes" if pair.p < _comparison.ALPHA else "no"
                tests.append([case.place.name, kind.upper(), " – ".join(pair.names), pair.z, pair.p, sure])
    means_of = (f"{name} {{:.3f}} ± {{:.3f}}" for name in STRATEGIES)
    header = ["place", "", *means_of, "Friedman χ²(3) {:.1f}", "p {:.1e}"]
    print(table("means while loading, 20 users 2 m off", header, rows))
    print(table("Wilcoxon", f"place |  | pair | Z {{:.2f}} | p {{:.5f}} | p < {_comparison.ALPHA:.5f}", tests))


# plots in the form of CloVR's figures ---------------------------------------------------------------------------------
def draw_quality(path: Path, places: dict[str, Timelines]) -> None:
    """Fig. 4: OVC, OFC and continuity by the share of loaded geometry."""
    figure, grid = subplots(3, len(places), figsize=(3.6 * len(places), 7), sharex=True, sharey="row", squeeze=False)
    for column, (place, timelines) in zip(grid.T, places.items(), strict=True):
        for name, timeline in timelines.items():
            pictures = timeline.pictures
            share = np.interp(pictures["time"], timeline.frames["time"], timeline.geometry_share)
            for axes, kind in zip(column, ("ovc", "ofc"), strict=False):
                axes.plot(share, pictures[kind], color=COLORS[name], marker=".", ms=4, lw=1, label=name,
                          drawstyle="steps-post")  # fmt: skip
            column[2].plot(share, 1.0 - pictures["continuity"], color=COLORS[name], marker=".", ms=4, lw=0, label=name)
        column[0].set(title=place)
        column[2].set(xlabel="share of geometry loaded", yscale="log", ylim=(1e-6, 2.0))
    for axes, label in zip(grid[:, 0], ("OVC", "OFC", "1 − continuity"), strict=True):
        axes.set(ylabel=label)
    grid[0, 0].legend(fontsize="small")
    save_figure(figure, path, dpi=70)


def draw_times(path: Path, places: dict[str, Timelines], vis_seconds: dict[str, dict[str, list[float]]]) -> None:
    """Fig. 6: seconds until the picture is complete and until everything is loaded. Fig. 7: seconds until each radius.

    `vis_seconds` has those of vis0 and vis1 by place.
    """
    figure, grid = subplots(1, 1 + len(places), figsize=(3.6 + 2.7 * len(places), 3.8))
    left = grid[0]
    width = 0.8 / len(COLORS)
    for number, name in enumerate(COLORS):
        x = np.arange(len(places)) + (number - 1.5) * width
        place_timelines = [timelines[name] for timelines in places.values()]
        left.bar(x, [timeline.total for timeline in place_timelines], width, color=COLORS[name], alpha=0.45)
        left.bar(x, [timeline.picture for timeline in place_timelines], width, color=COLORS[name], label=name)
    left.set_xticks(range(len(places)), [place.replace(", ", ",\n") for place in places], fontsize="x-small")
    left.set(ylabel="seconds: complete picture, and all (pale)", xlabel=" ", ylim=(0.0, 1.25 * left.get_ylim()[1]))
    left.legend(fontsize="small", ncols=4, loc="upper center", columnspacing=0.8, handlelength=1.0)
    for axes, (place, timelines) in zip(grid[1:], places.items(), strict=True):
        for name in COLORS:
            seconds = vis_seconds[place].get(name, timelines[name].ring_times[1:])
            # The lines of vis1 and vis0 coincide: both end with the same files.
            style = "--" if name == "vis1" else "-"
            axes.plot(timelines["clovrd"].radii, seconds, style, color=COLORS[name], marker=".", label=name)
        axes.set(title=place, xlabel="R in metres", ylim=(0.0, None))
    grid[1].set(ylabel="seconds until all within R is there")
    grid[1].legend(fontsize="small")
    save_figure(figure, path, dpi=70)


def draw_rates(path: Path, places: dict[str, Timelines], limit: float) -> None:
    """Fig. 8: estimated frames per second while loading."""
    figure, grid = subplots(1, len(places), figsize=(3.4 * len(places), 3), sharey=True, squeeze=False)
    for axes, (place, timelines) in zip(grid[0], places.items(), strict=True):
        end = max(timelines[name].total for name in timelines) + 1.0
        for name, timeline in timelines.items():
            fps = np.minimum(limit, 1.0 / np.maximum(timeline.frames["seconds"], 1e-9))
            axes.step([*timeline.frames["time"], end], [*fps, fps[-1]], where="post", color=COLORS[name], label=name)
        axes.set(title=place, xlabel="seconds", xlim=(0.0, end))
    grid[0, 0].set(ylabel="frames a second, estimated", ylim=(0.0, limit * 1.05))
    grid[0, 0].legend(fontsize="small")
    save_figure(figure, path, dpi=70)


def main() -> None:
    options = start(
        __doc__,
        "--quick",
        "--plots",
        place={"type": int, "choices": range(4), "help": "one of the four places"},
        part={"default": None, "choices": PARTS, "help": "one part of the tables"},
        gzip=(bool, "from a server that compresses, as nearfar's does"),
    )
    quick, plots_to, gzip = options.quick, options.plots, options.gzip
    parts = PARTS if options.part is None else (options.part,)
    link = nf.stream.Link(MBPS, rtt_ms=RTT)
    with folder_or_temporary() as folder:
        cases = export_places(quick, options.place, folder)
        timelines = {case.place.name: timelines_of(case, link, gzip) for case in cases}
        if "times" in parts:
            for time_link in (nf.stream.Link(MBPS), link, nf.stream.Link(MBPS, rtt_ms=RTT, loss=0.001)):
                print_times(cases, time_link, gzip)
            if options.place in (None, 2):
                print_times([export(places(quick)[2], folder / "plain", quick, instanced=False)], link, gzip)
            if plots_to:
                vis_seconds = {case.place.name: by_radius(case, link, gzip, quick) for case in cases}
                draw_times(plots_to / "strategies_times.png", timelines, vis_seconds)
                draw_rates(plots_to / "strategies_rates.png", timelines, DISPLAY)
        if "seen" in parts:
            measured = print_seen(cases, timelines, 32 if quick else 96, 20.0 if quick else 10.0)
            if plots_to:
                draw_quality(plots_to / "strategies_seen.png", measured)
        if "comparison" in parts:
            print_comparison(cases, link, (80, 50) if quick else (160, 100))


if __name__ == "__main__":
    main()
