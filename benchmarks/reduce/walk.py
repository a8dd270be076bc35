"""Walks of 200 m through cities: maps, bytes, milliseconds to the next region, jumps at changes, folds, waits."""

from __future__ import annotations

import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness import scenes
from benchmarks.harness.report import save_figure, start, subplots, table
from benchmarks.harness.timing import timed
from benchmarks.harness.views import center_for

LENGTH, SPEED, RATE = 200.0, 1.4, 10.0
"""Length in metres of a walk, speed in metres per second, pictures per second."""
REACH, R2 = 8.0, 50.0
HYSTERESIS = 1.0
FOV, SIZE = nf.Fov.symmetric(90, 16 / 9), (960, 540)
"""Views in which jumps are measured; the focal length is 480 px."""
FOCAL = 480.0

TURNS = np.radians(np.arange(0.0, 360.0, 2.0))
MARGIN = 3.0
"""Least distance of a way from the wall ahead, metres."""

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Case:
    """A scene and a way through it."""

    name: str
    scene: nf.Scene
    path: Array


@dataclass
class WalkLog:
    """Events of a walk."""

    frames: int = 0
    folded: int = 0
    waits: list[float] = field(default_factory=list)
    """Seconds of each wait for a region, without the first one."""
    changes: list[tuple[int, int, Array]] = field(default_factory=list)
    """Region before and after, and the user's place."""
    strip: list[nf.Frame] = field(default_factory=list)


@dataclass(frozen=True)
class Change:
    """A change from one region to the next, and the far points that both show."""

    step: float
    """Metres between the centres."""
    ranges: Array
    """(N,) metres from the old centre to each point."""
    measured: Array
    """(N,) pixels by which the point moves in the new picture."""
    predicted: Array
    """(N,) f·|ΔO⊥|/ρ, the first-order prediction; ρ is the range from the old centre."""
    exact: Array
    """(N,) f·|ΔO⊥|/(ρ − ΔO·d): exact, with the distance from the new centre along the old line of sight d."""


def cases(quick: bool) -> Iterator[Case]:
    """Yield the city, along an avenue and around a corner, and the centre of Tokyo, along free ground."""
    corner = [(0.0, 1.7, 20.0), (0.0, 1.7, -66.0), (114.0, 1.7, -66.0)]
    yield Case("procedural city", scenes.city(quick), np.array(corner[:2] if quick else corner))
    for _, scene in scenes.present(*([] if quick else ["Tokyo core"])):
        yield Case("centre of Tokyo", scene, free_way(scene, center_for(scene, R2)))


def free_way(scene: nf.Scene, place: Sequence[float]) -> Array:
    """Way (N, 3) of `LENGTH` from a place: straight on until a wall, then in the freest direction, not back."""
    path, heading, remaining = [np.array(place, np.float64)], None, LENGTH
    while remaining > 0.1 and len(path) < 20:
        forward = np.column_stack([np.cos(TURNS), np.zeros(len(TURNS)), np.sin(TURNS)])
        side = np.column_stack([-forward[:, 2], forward[:, 1], forward[:, 0]])
        free = np.min(
            [nf.cast_rays(scene, path[-1] + offset * side, forward).t_hit for offset in (-1.0, 0.0, 1.0)], axis=0
        )
        if heading is not None:
            free = np.where(forward @ heading < -0.5, 0.0, free)
        index = int(np.argmax(np.minimum(free, remaining + MARGIN)))
        step = min(float(free[index]) - MARGIN, remaining)
        if step <= 0.0:
            break
        path.append(path[-1] + step * forward[index])
        heading, remaining = forward[index], remaining - step
    return np.array(path)


def at_distance(path: Array, metres: float) -> tuple[Array, Array]:
    """Place on a path after some metres, and the direction of the way there."""
    steps = np.diff(path, axis=0)
    lengths = np.linalg.norm(steps, axis=1)
    starts = np.concatenate([[0.0], np.cumsum(lengths)])
    piece = min(int(np.searchsorted(starts, metres, side="right")) - 1, len(steps) - 1)
    return path[piece] + (metres - starts[piece]) / lengths[piece] * steps[piece], steps[piece] / lengths[piece]


def times_ahead(regions: nf.Regions) -> tuple[float, list[float]]:
    """Milliseconds of the first reduction, which builds the trees, and of each later one in an idle background."""
    reduced, first_timing = timed(regions.reduced, 0)
    times = []
    for center in regions.centers[1:]:
        reduced, spent = timed(lambda before, center: before.recentered(center).result(), reduced, center)
        times.append(spent.ms)
    return first_timing.ms, times


def walk(case: Case, regions: nf.Regions, size: tuple[int, int]) -> WalkLog:
    """Walk in real time: each picture waits for its time, which limits the time for making regions ahead."""
    walker, log = regions.walk(fade=0.5), WalkLog()
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
        log.frames += 1
        log.folded += stats["fold_margin"] <= 0.0
        if current >= 0 and stats["region"] != current:
            log.changes.append((current, stats["region"], position))
            log.waits += [stats["waited"]] * (stats["waited"] > 0.0)
        current = stats["region"]
        is_half = stats["fade"] != 1.0 and 0.3 < stats["fade"] < 0.7 and len(log.strip) % 2 == 1
        if len(log.strip) < 12 and (is_half or (len(log.strip) % 2 == 0 and stats["fade"] == 1.0)):
            log.strip.append(frame)
    return log


def measure(old: nf.ReducedScene, new: nf.ReducedScene, position: Array, stride: int = 30) -> Change:
    """Find far points of the old pictures in the new ones, by their positions in the scene.

    The range of a map defines the scene point of a far pixel. Displacements are converted to pixels of the middle of a
    picture, whose focal length is `FOCAL`: f·tan of the angle between the two directions.
    """
    from scipy.spatial import cKDTree

    step = np.subtract(new.center, old.center)
    rows: list[Array] = []
    for ahead in np.array([(1, 0, 0), (0, 0, 1), (-1, 0, 0), (0, 0, -1)]):
        camera = nf.Camera.look_at(position, position + ahead, fov=FOV, size=SIZE)
        frames = [reduced.render(camera, channels=("position",), method="exact") for reduced in (old, new)]
        old_points, new_points = (frame.require("position").astype(np.float64) + frame.origin for frame in frames)
        rays = camera.rays()[1].reshape(-1, 3)
        points = old_points[stride // 2 :: stride, stride // 2 :: stride].reshape(-1, 3)
        numbers = np.arange(SIZE[0] * SIZE[1]).reshape(SIZE[1], SIZE[0])
        pixels = numbers[stride // 2 :: stride, stride // 2 :: stride].ravel()
        new_points = new_points.reshape(-1, 3)
        surface_pixels = np.flatnonzero(np.isfinite(new_points).all(axis=1))
        # Pixels without a surface are NaN, so the comparison is false.
        is_far = np.all([np.hypot(*(points - each.center)[:, (0, 2)].T) > each.r2 + 1.0 for each in (old, new)], axis=0)
        if not len(surface_pixels) or not is_far.any():
            continue
        errors, nearest = cKDTree(new_points[surface_pixels]).query(points[is_far])
        sight = points[is_far] - old.center
        reach = np.linalg.norm(sight, axis=1)
        # If the nearest point is more than a pixel's width away, the old point is occluded in the new picture.
        is_visible = errors <= reach / FOCAL
        turned = np.linalg.norm(np.cross(rays[pixels[is_far]], rays[surface_pixels[nearest]]), axis=1)
        step_across = np.linalg.norm(np.cross(step, sight / reach[:, None]), axis=1)
        measured = FOCAL * np.tan(np.arcsin(turned))
        nearer = reach - sight @ step / reach
        predicted, exact = FOCAL * step_across / reach, FOCAL * step_across / nearer
        rows.append(np.column_stack([reach, measured, predicted, exact])[is_visible])
    return Change(float(np.linalg.norm(step)), *np.concatenate(rows or [np.empty((0, 4))]).T)


def jumps(case: Case, log: WalkLog, regions: nf.Regions) -> list[Change]:
    """Measure the jump of far points at every change, with maps that have range."""
    radii, reductions = regions.radii, dict[int, nf.ReducedScene]()
    settings: dict[str, Any] = {"r1": radii.r1, "r2": radii.r2, "face_size": 1024, "samples": 1}
    changes = []
    for before, after, position in log.changes:
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
    log = walk(case, regions, (96, 54) if quick else (320, 180))
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
        ["changes", f"{len(log.changes)}"],
        ["waits for a region, and the longest, s", f"{len(log.waits)}, {max(log.waits, default=0.0):.2f}"],
        ["pictures, folded", f"{log.frames}, {log.folded}"],
    ]
    title = f"{case.name}: {SPEED} m/s, {RATE:.0f} pictures a second, maps of 6 × {size}² texels"
    text = table(title, " | ", rows)
    changes = jumps(case, log, regions)
    lines = [_row(number, change) for number, change in enumerate(changes, 1) if len(change.ranges)]
    header = "change | |ΔO|, m {:.2f} | points | ρ, m, median {:.0f} | jump, px, median {:.1f} | predicted {:.1f}"
    header += " | greatest {:.0f} | predicted {:.0f} | ratio {:.2f} | to ρ − ΔO·d {:.2f}"
    text += "\n" + table(f"Jumps of far points at each change, f = {FOCAL:.0f} px", header, lines)
    if plots is not None:
        draw(case.name, case.path, regions, changes, log.strip, plots / f"walk_{case.name.split()[-1]}.jpg")
    return text


def _row(number: int, change: Change) -> list[object]:
    number_of_greatest, clear = int(np.argmax(change.measured)), change.predicted > 5.0
    ratios = (np.median(change.measured[clear] / by[clear]) for by in (change.predicted, change.exact) if clear.any())
    middles = (np.median(values) for values in (change.ranges, change.measured, change.predicted))
    greatest = change.measured[number_of_greatest], change.predicted[number_of_greatest]
    return [number, change.step, len(change.ranges), *middles, *greatest, *(ratios if clear.any() else ["–", "–"])]


def draw(
    name: str, path: Array, regions: nf.Regions, changes: Sequence[Change], frames: Sequence[nf.Frame], file: Path
) -> None:
    """Draw a strip of frames, the centres along the way from above, and measured jumps against predicted ones."""
    figure, empty = subplots(figsize=(13.0, 7.6))
    empty.remove()
    upper, lower = figure.subfigures(2, 1, height_ratios=(1.0, 1.1))
    for axes, frame in zip(upper.subplots(2, 6).flat, frames, strict=False):
        axes.imshow(frame.to_image())
        stats = frame.stats
        fade = "" if stats["fade"] == 1.0 else f", fade {100 * stats['fade']:.0f} %"
        axes.set_title(f"region {stats['region']}{fade}", fontsize=9)
        axes.set(xticks=[], yticks=[])
    left, axes = lower.subplots(1, 2)
    _draw_map(left, path, regions)
    measured, predicted = (np.concatenate([getattr(c, field) for c in changes]) for field in ("measured", "predicted"))
    axes.plot(predicted, measured, ".", markersize=2, color="#c8102e", alpha=0.4, rasterized=True)
    maximum = float(predicted.max(initial=1.0))
    axes.plot([0.0, maximum], [0.0, maximum], color="0.3", linewidth=0.8)
    axes.set(xlabel="predicted jump f·|ΔO⊥|/ρ, px", ylabel="measured jump, px", title="far points at the changes")
    axes.grid(alpha=0.3)
    figure.suptitle(name)
    save_figure(figure, file, dpi=70, pil_kwargs={"quality": 82} if file.suffix == ".jpg" else None)


def _draw_map(axes: Any, path: Array, regions: nf.Regions) -> None:
    """Draw the way, the centres, and how far each region reaches."""
    from matplotlib.patches import Circle

    for number, (x, _, z) in enumerate(regions.centers):
        axes.add_patch(Circle((x, z), regions.reach, facecolor="#2a6f97", alpha=0.12, edgecolor="#2a6f97"))
        axes.annotate(str(number), (x, z), xytext=(3, 3), textcoords="offset points", fontsize=7)
    axes.plot(regions.centers[:, 0], regions.centers[:, 2], "o", color="#2a6f97", markersize=3)
    axes.plot(path[:, 0], path[:, 2], color="#c8102e")
    axes.set(aspect="equal", xlabel="x, m", ylabel="z, m", title="way, centres, and the reach of each region")
    axes.invert_yaxis()
    axes.grid(alpha=0.3)


def main() -> None:
    arguments = start(__doc__, "--quick", "--plots")
    for case in cases(arguments.quick):
        print(report(case, arguments.quick, arguments.plots), flush=True)


if __name__ == "__main__":
    main()
