"""Walks of 200 m through cities: maps, bytes, milliseconds to the next region, jumps at changes, folds, waits."""

from __future__ import annotations

import time
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

import nearfar as nf
from benchmarks.harness import scenes
from benchmarks.harness.report import start, table
from benchmarks.harness.timing import timed
from benchmarks.harness.views import center_for
from benchmarks.reduce._walk import FOCAL, FOV, Array, Change, at_distance, draw, free_way, measure

LENGTH, SPEED, RATE = 200.0, 1.4, 10.0
"""Length in metres of a walk, speed in metres per second, pictures per second."""
REACH, R2 = 8.0, 50.0
HYSTERESIS = 1.0


@dataclass(frozen=True)
class Case:
    """A scene and a way through it."""

    name: str
    scene: nf.Scene
    path: Array


@dataclass
class Walked:
    """Events of a walk."""

    frames: int = 0
    folded: int = 0
    waits: list[float] = field(default_factory=list)
    """Seconds of each wait for a region, without the first one."""
    changes: list[tuple[int, int, Array]] = field(default_factory=list)
    """Region before and after, and the user's place."""
    strip: list[nf.Frame] = field(default_factory=list)


def cases(quick: bool) -> Iterator[Case]:
    """Yield the city, along an avenue and around a corner, and the centre of Tokyo, along free ground."""
    corner = [(0.0, 1.7, 20.0), (0.0, 1.7, -66.0), (114.0, 1.7, -66.0)]
    yield Case("procedural city", scenes.city(quick), np.array(corner[:2] if quick else corner))
    for _, scene in scenes.present(*([] if quick else ["Tokyo core"])):
        yield Case("centre of Tokyo", scene, free_way(scene, center_for(scene, R2), LENGTH))


def times_ahead(regions: nf.Regions) -> tuple[float, list[float]]:
    """Milliseconds of the first reduction, which builds the trees, and of each further one in the background, alone."""
    reduced, first_timing = timed(regions.reduced, 0)
    times = []
    for center in regions.centers[1:]:
        reduced, spent = timed(lambda before, center: before.recentered(center).result(), reduced, center)
        times.append(spent.ms)
    return first_timing.ms, times


def walk(case: Case, regions: nf.Regions, size: tuple[int, int]) -> Walked:
    """Walk in real time: no picture is shown before its time, which limits the time for making regions ahead."""
    walker, walked = regions.walk(fade=0.5), Walked()
    length = float(np.linalg.norm(np.diff(case.path, axis=0), axis=1).sum())
    count = int(length / SPEED * RATE)
    started, current = time.perf_counter(), -1
    for number in range(count):
        seconds = number / RATE
        time.sleep(max(0.0, started + seconds - time.perf_counter()))
        position, direction = at_distance(case.path, seconds * SPEED)
        view_direction = np.array([direction[0] - 0.6 * direction[2], 0.05, direction[2] + 0.6 * direction[0]])
        frame = walker.render(nf.Camera.look_at(position, position + view_direction, fov=FOV, size=size), seconds)
        stats = frame.stats
        walked.frames += 1
        walked.folded += stats["fold_margin"] <= 0.0
        if current >= 0 and stats["region"] != current:
            walked.changes.append((current, stats["region"], position))
            walked.waits += [stats["waited"]] * (stats["waited"] > 0.0)
        current = stats["region"]
        is_half = stats["fade"] != 1.0 and 0.3 < stats["fade"] < 0.7 and len(walked.strip) % 2 == 1
        if len(walked.strip) < 12 and (is_half or (len(walked.strip) % 2 == 0 and stats["fade"] == 1.0)):
            walked.strip.append(frame)
    return walked


def jumps(case: Case, walked: Walked, regions: nf.Regions) -> list[Change]:
    """Measure the jump of far points at every change, with maps that have range."""
    radii, reductions = regions.radii, dict[int, nf.ReducedScene]()
    settings: dict[str, Any] = {"r1": radii.r1, "r2": radii.r2, "face_size": 1024, "samples": 1}
    changes = []
    for before, after, position in walked.changes:
        for number in (before, after):
            if number not in reductions:
                center = regions.centers[number]
                reductions[number] = nf.reduce(case.scene, center=center, channels=("color", "range"), **settings)
        changes.append(measure(reductions[before], reductions[after], position))
        reductions = {after: reductions[after]}
    return changes


def report(case: Case, quick: bool, plots: Path | None) -> str:
    size = 128 if quick else 1024
    settings: dict[str, Any] = {"reach": REACH, "hysteresis": HYSTERESIS, "r2": R2, "face_size": size}
    regions, planning = timed(nf.regions, case.scene, case.path, **settings)
    first_ms, times = times_ahead(regions)
    walked = walk(case, regions, (96, 54) if quick else (320, 180))
    bytes_made = regions.bytes[regions.bytes > 0] / 1e6
    rows = [
        ["way, m", f"{np.linalg.norm(np.diff(case.path, axis=0), axis=1).sum():.0f}"],
        ["centres, and metres between neighbours", f"{len(regions)}, {regions.spacing:.2f}"],
        ["r1, r2, m", f"{regions.radii.r1:.1f}, {regions.radii.r2:.0f}"],
        ["planned in, ms", f"{planning.ms:.0f}"],
        ["first region, with the scene's trees, ms", f"{first_ms:.0f}"],
        ["next region, mean and greatest, ms", f"{np.mean(times):.0f}, {np.max(times):.0f}"],
        ["maps made on the walk", f"{len(bytes_made)}"],
        ["a region, mean and greatest, MB", f"{bytes_made.mean():.1f}, {bytes_made.max():.1f}"],
        ["kept at the end, MB", f"{regions.memory / 1e6:.1f}"],
        ["changes", f"{len(walked.changes)}"],
        ["waits for a region, and the longest, s", f"{len(walked.waits)}, {max(walked.waits, default=0.0):.2f}"],
        ["pictures, folded", f"{walked.frames}, {walked.folded}"],
    ]
    title = f"{case.name}: {SPEED} m/s, {RATE:.0f} pictures a second, maps of 6 × {size}² texels"
    text = table(title, " | ", rows)
    changes = jumps(case, walked, regions)
    lines = [_row(number, change) for number, change in enumerate(changes, 1) if len(change.ranges)]
    header = "change | |ΔO|, m {:.2f} | points | ρ, m, median {:.0f} | jump, px, median {:.1f} | predicted {:.1f}"
    header += " | greatest {:.0f} | predicted {:.0f} | ratio {:.2f} | to ρ − ΔO·d {:.2f}"
    text += "\n" + table(f"Jumps of far points at each change, f = {FOCAL:.0f} px", header, lines)
    if plots is not None:
        draw(case.name, case.path, regions, changes, walked.strip, plots / f"walk_{case.name.split()[-1]}.jpg")
    return text


def _row(number: int, change: Change) -> list[object]:
    number_of_greatest, clear = int(np.argmax(change.measured)), change.predicted > 5.0
    ratios = (np.median(change.measured[clear] / by[clear]) for by in (change.predicted, change.exact) if clear.any())
    middles = (np.median(values) for values in (change.ranges, change.measured, change.predicted))
    greatest = change.measured[number_of_greatest], change.predicted[number_of_greatest]
    return [number, change.step, len(change.ranges), *middles, *greatest, *(ratios if clear.any() else ["–", "–"])]


def main() -> None:
    arguments = start(__doc__, "--quick", "--plots")
    for case in cases(arguments.quick):
        print(report(case, arguments.quick, arguments.plots), flush=True)


if __name__ == "__main__":
    main()
