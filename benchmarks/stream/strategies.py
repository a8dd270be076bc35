"""The four strategies of CloVR (2024) simulated: times, visible objects, and tests of the differences."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any

import nearfar as nf
from benchmarks.harness.report import folder_or_temporary, start, table
from benchmarks.harness.timing import timed
from benchmarks.stream import _comparison, _strategy_plots as plots
from benchmarks.stream._near import EYE_HEIGHT, Place, places
from nearfar.stream._client_pictures import Pictures, SceneParts
from nearfar.stream._radii import PUBLISHED
from nearfar.stream._strategies import STRATEGIES, HeadPath, Strategy

MBPS, RTT = 50.0, 20.0
"""Rate in megabits per second, as in CloVR, and round trip in milliseconds."""
TRIANGLES_PER_SECOND, DISPLAY = 181e6, 72.0
"""Speed of a device that draws 35.6 million triangles 5.09 times per second, as CloVR prints for its unreduced City, if
it has that many; and frames per second of its display."""

PARTS = ("times", "seen", "comparison")


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
    """Export a place's bundle; without instances also without compression."""
    scene = place.make(instanced=instanced)
    bundle = write_bundle(scene, place, folder, PUBLISHED, quick, "meshopt" if instanced else None)
    return Case(replace(place, name=place.name if instanced else f"{place.name}, copies, plain"), scene, bundle)


def write_bundle(
    scene: nf.Scene, place: Place, folder: Path, radii: Sequence[float], quick: bool, compression: Any = "meshopt"
) -> nf.stream.Bundle:
    settings: dict[str, Any] = {"face_size": 128 if quick else 1024, "by_footprint": True, "compression": compression}
    return nf.stream.export(scene, folder, center=place.center, radii=radii, **settings)


def lines_of(case: Case, link: nf.stream.Link, gzip: bool) -> plots.Lines:
    settings: dict[str, Any] = {"link": link, "gzip": gzip, "triangles_per_second": TRIANGLES_PER_SECOND}
    return {name: nf.stream.simulate(case.bundle, strategy=name, **settings) for name in STRATEGIES}


def by_radius(case: Case, link: nf.stream.Link, gzip: bool, quick: bool) -> dict[str, list[float]]:
    """Seconds of vis0 and vis1 until everything is loaded, by the last radius, with a separate bundle for each."""
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
        lines, took = timed(lines_of, case, link, gzip)
        for name, line in lines.items():
            ends = line.picture, line.first_ring, line.total, line.grown
            rows.append([case.place.name, name, line.received[-1, 1] / 1e6, *ends, None])
        rows[-1][-1] = took.wall
    columns = ("MB", "picture, s", "near geometry", "all", "grown", "real s of the four")
    header = ["place", "strategy", *(f"{name} {{:.2f}}" for name in columns)]
    packed = ", compressed" if gzip else ""
    print(table(f"{MBPS:g} Mb/s, {link.rtt_ms:g} ms, loss {link.loss:g}{packed}", header, rows))


def print_seen(cases: list[Case], lines: dict[str, plots.Lines], size: int, every: float) -> dict[str, plots.Lines]:
    """Print OVC, OFC and continuity for a user 1 m to the left of the centre, in all directions."""
    measured, rows = {}, []
    for case in cases:
        x, y, z = case.bundle.center
        eye = (x - 1.0, y, z)
        parts = SceneParts.bake(case.scene, case.bundle, None, size)
        measure = partial(_comparison.measure_pictures, parts=parts, path=HeadPath.parse(eye, (x, y, z)), every=every)
        place_lines = {name: replace(line, pictures=measure(line)) for name, line in lines[case.place.name].items()}
        measured[case.place.name] = place_lines
        pictures = Pictures(parts, by_footprint=False)
        limit = nf.metrics.object_completion(
            pictures.picture(None, eye).objects, pictures.picture(None, (x, y, z)).objects
        )
        rows.append([case.place.name, "truth at the centre", *limit, None, None, None])
        for name, line in place_lines.items():
            # Since the first picture.
            later = line.pictures["continuity"][line.pictures["time"] > line.picture + 0.1]
            shares = (line.pictures[kind][index] for index in (1, -1) for kind in ("ovc", "ofc"))
            rows.append([case.place.name, name, *shares, min(later, default=math.nan)])
    header = "place | strategy | first OVC {:.3f} | OFC {:.3f} | last OVC {:.3f} | OFC {:.3f}"
    header += " | least continuity after the picture {:.5f}"
    print(table("a user 1 m to the left of the centre", header, rows))
    return measured


def print_comparison(cases: list[Case], link: nf.stream.Link, size: tuple[int, int]) -> None:
    """Print experiment 1."""
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
        lines = {case.place.name: lines_of(case, link, gzip) for case in cases}
        if "times" in parts:
            for time_link in (nf.stream.Link(MBPS), link, nf.stream.Link(MBPS, rtt_ms=RTT, loss=0.001)):
                print_times(cases, time_link, gzip)
            if options.place in (None, 2):
                print_times([export(places(quick)[2], folder / "plain", quick, instanced=False)], link, gzip)
            if plots_to:
                vis_seconds = {case.place.name: by_radius(case, link, gzip, quick) for case in cases}
                plots.times(plots_to / "strategies_times.png", lines, vis_seconds)
                plots.rates(plots_to / "strategies_rates.png", lines, DISPLAY)
        if "seen" in parts:
            measured = print_seen(cases, lines, 32 if quick else 96, 20.0 if quick else 10.0)
            if plots_to:
                plots.quality(plots_to / "strategies_seen.png", measured)
        if "comparison" in parts:
            print_comparison(cases, link, (80, 50) if quick else (160, 100))


if __name__ == "__main__":
    main()
