"""Popping: similarity of consecutive pictures of a flight, with and without `Steady`, and the cost of `Steady`.

    python -m benchmarks.orthoview.popping flight swaps speed blends --tiles FOLDER --trees FOLDER --out FOLDER

The flight is measured in parts, whose results are stored in --out. --parts limits how many are measured in this run;
the table contains all stored ones. The tree has 26 directions; see `benchmarks.orthoview.pictures`.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np

import nearfar as nf
from benchmarks.harness.pictures import similarity
from benchmarks.harness.report import folder_or_temporary, save_figure, start, subplots, table
from benchmarks.harness.timing import best
from benchmarks.orthoview._blends import Blend, render_blended
from benchmarks.orthoview._worlds import World, tokyo

SWAP_TIMES = (2.0, 12.0, 22.0)
"""Times of the flight at which cuts are swapped and splats are blended, seconds."""
FADE_PICTURES = 36
"""Number of pictures of a fade that are compared."""
BLEND_SIZE = (160, 120)
BLEND_PICTURES = 8
"""Number of pictures of blended splats at each time."""
Tree = nf.orthoview.OrthoTree

RATE = 72
"""Pictures per second."""
SECONDS = 30.0
SIZE = (320, 240)
FOV = nf.Fov.symmetric(60, 4 / 3)
SAMPLES = 4
"""Samples per pixel of orthoviews; the truth has 16."""
PARTS, FRAMES = 10, 30
"""Number of parts of the flight, and of pictures of each."""
IGNORED = 8
"""Number of ignored pictures at a part's start, where there are no earlier pictures to fade from."""
METHODS = ("truth", "orthoviews", "steady", "steady truth")


def camera_at(world: World, time: float, size: tuple[int, int] = SIZE) -> nf.Camera:
    """Camera on a third of a circle of 420 m, at least 18 m from the houses, at 29 m/s and heights of 65 to 155 m."""
    angle = np.pi - np.radians(4) * time
    height = 110 + 45 * np.cos(2 * np.pi * time / SECONDS)
    middle = world.box[0] + (world.side / 2, 1.0, world.side / 2)
    eye = middle + np.array([420 * np.cos(angle), height, 420 * np.sin(angle)])
    ahead = angle - np.radians(130)
    return nf.Camera.look_at(eye, eye + np.array([np.cos(ahead), -0.3, np.sin(ahead)]), fov=FOV, size=size)


def truth_at(world: World, tree: nf.orthoview.OrthoTree, time: float, size: tuple[int, int] = SIZE) -> nf.Frame:
    """Render the truth with its motion since the previous picture."""
    now, before = (camera_at(world, moment, size) for moment in (time, time - 1 / RATE))
    channels = ("color", "range", "motion")
    return nf.render(world.scene, now, before=before, samples=16, channels=channels, clip=nf.Clip(box=tree.bounds))


Findings = dict[str, list[float]]
"""Measures of a method's pictures: "psnr", "ssim", and "stability", each picture's motion-compensated SSIM with the
previous one."""


def part(world: World, tree: nf.orthoview.OrthoTree, number: int, folder: Path) -> dict[str, Findings]:
    """Measure a part of the flight, unless the folder contains it."""
    path = folder / f"popping-{number}.json"
    if not path.is_file():
        findings_by_method: dict[str, Findings] = {name: {"stability": [], "psnr": [], "ssim": []} for name in METHODS}
        steady, filtered = nf.orthoview.Steady(), nf.orthoview.Steady()
        previous: dict[str, nf.Frame] = {}
        for n in range(FRAMES):
            time = number * SECONDS / PARTS + n / RATE
            truth = truth_at(world, tree, time)
            views = tree.render(camera_at(world, time), samples=SAMPLES)
            drawn = {
                "truth": truth,
                "orthoviews": views,
                "steady": steady.next(views, time),
                # Motion is removed, because the tree's pictures lack it, too.
                "steady truth": filtered.next(replace(truth, motion=None), time),
            }
            # Consecutive pictures are compared where the truth shows the same surface in both.
            now = {name: replace(frame, range=truth.range, motion=truth.motion) for name, frame in drawn.items()}
            if n >= IGNORED:
                for name, findings in findings_by_method.items():
                    findings["stability"].append(float(nf.metrics.motion_ssim(previous[name], now[name])))
                    if name != "truth":
                        psnr, ssim = similarity(truth, now[name])
                        findings["psnr"].append(psnr)
                        findings["ssim"].append(ssim)
            previous = now
        folder.mkdir(parents=True, exist_ok=True)
        path.write_text(json.dumps(findings_by_method))
    return dict(json.loads(path.read_text()))


def fly(world: World, tree: nf.orthoview.OrthoTree, folder: Path, max_measured: int) -> Iterator[dict[str, Findings]]:
    """Yield the stored parts of the flight, and at most `max_measured` new ones."""
    missing = [n for n in range(PARTS) if not (folder / f"popping-{n}.json").is_file()]
    later = set(missing[max_measured:])
    return (part(world, tree, n, folder) for n in range(PARTS) if n not in later)


def plot(parts: list[dict[str, Findings]], path: Path) -> None:
    figure, axis = subplots(figsize=(8, 3.8))
    colors = {"truth": "black", "orthoviews": "tab:red", "steady": "tab:blue"}
    for name, color in colors.items():
        for n, findings_by_method in enumerate(parts):
            # Parts are stretched in time: the 0.3 s of one would be a vertical line.
            stability = findings_by_method[name]["stability"]
            times = (n + 0.9 * np.arange(len(stability)) / len(stability)) * SECONDS / PARTS
            label = {"steady": "orthoviews, steady"}.get(name, name) if n == 0 else None
            axis.plot(times, stability, color=color, linewidth=1.2, label=label)
    axis.set(
        xlabel=f"time, s; each part has {FRAMES - IGNORED} pictures ({(FRAMES - IGNORED) / RATE:.1f} s, drawn wider)",
        ylabel="motion-compensated SSIM",
    )
    axis.grid(alpha=0.3)
    axis.legend(loc="lower left")
    save_figure(figure, path, dpi=90)


def main() -> None:
    options = start(
        __doc__,
        "--tiles",
        "--trees",
        tables={"nargs": "*", "help": f"of {', '.join(TABLES)}; by default all"},
        out=(Path, "folder for findings and the plot; by default a temporary one"),
        parts=PARTS,
    )
    world = tokyo(options.tiles)
    with folder_or_temporary() as folder:
        tree = nf.orthoview.open(world.build(options.trees or folder))
        for name in options.tables or TABLES:
            TABLES[name](world, tree, options.out or folder, options.parts)


def flight(world: World, tree: Tree, out: Path, parts: int) -> None:
    """Table of the similarity of consecutive pictures, and their errors."""
    measured_parts = list(fly(world, tree, out, parts))
    truth = np.concatenate([part["truth"]["stability"] for part in measured_parts])
    rows = []
    for name in METHODS:
        names = ("stability", "psnr", "ssim")
        stability, psnr, ssim = (np.concatenate([part[name][each] for part in measured_parts]) for each in names)
        numbers = [stability.mean(), np.percentile(stability, 1), stability.min(), (stability - truth).min()]
        rows.append([name, *numbers, *([psnr.mean(), ssim.mean()] if len(psnr) else [None, None])])
    header = "pictures | mean {:.4f} | 1st percentile {:.4f} | least {:.4f} | least difference from the truth's {:.4f}"
    print(table(f"Flight, {len(measured_parts)} parts", header + " | PSNR {:.2f} | SSIM {:.4f}", rows))
    plot(measured_parts, out / "orthoview_steady.png")


def swaps(world: World, tree: Tree, out: Path, parts: int) -> None:
    """Table of the least similarity of consecutive pictures of a static camera after its cut was swapped."""
    rows = []
    for time in SWAP_TIMES:
        camera = camera_at(world, time)
        start = tree.render(camera, samples=SAMPLES)
        for name, views, error_px in (("error 2 px", 3, 2.0), ("2 views", 2, 1.0), ("5 views", 5, 1.0)):
            other = tree.render(camera, samples=SAMPLES, views=views, error_px=error_px)
            rows.append([f"{time:g} s", name, *fades(start, other)])
        one, two = (tree.render(side, samples=SAMPLES) for side in bisector(tree, world, time))
        rows.append([f"{time:g} s", "other directions", *fades(one, two)])
    print(table("Swapped cuts", "time | change | without Steady | 72 pictures a second | 30", rows))


def fades(one: nf.Frame, other: nf.Frame) -> Iterator[str]:
    """Yield least SSIM of consecutive pictures without `Steady`, and with it at 72 and at 30 pictures a second."""
    yield f"{nf.ssim(one, other):.4f}"
    for rate in (RATE, 30):
        steady = nf.orthoview.Steady()
        pictures = [steady.next(one, 0.0), *(steady.next(other, n / rate) for n in range(1, FADE_PICTURES))]
        yield f"{min(nf.ssim(a, b) for a, b in pairwise(pictures)):.4f}"


def bisector(tree: Tree, world: World, start: float) -> tuple[nf.Camera, nf.Camera]:
    """Cameras just before and after the next moment of the flight at which a cell's drawn directions change."""

    def directions(time: float) -> set[object]:
        return set(tree.cut(camera_at(world, time)).keys(in_picture=True))

    low, high = start, start + 1 / RATE
    first_directions = directions(low)
    while directions(high) == first_directions:
        low, high = high, high + 1 / RATE
    while high - low > 1e-6:
        middle = (low + high) / 2
        low, high = (middle, high) if directions(middle) == first_directions else (low, middle)
    return camera_at(world, low), camera_at(world, high)


def speed(world: World, tree: Tree, out: Path, parts: int) -> None:
    frames = [tree.render(camera_at(world, 12 + n / RATE, (640, 480))) for n in range(2)]
    steady, count = nf.orthoview.Steady(), iter(range(1000))

    def blend() -> nf.Frame:
        n = next(count)
        return steady.next(frames[n % 2], n / RATE)

    blur = best(lambda: nf.orthoview.motion_blur(frames[1], frames[0].camera), repeat=11)
    times = {"Steady.next": best(blend, repeat=11), "motion_blur, 8 poses": blur}
    rows = [(name, time.ms, time.cpu_ms) for name, time in times.items()]
    print(table("640 × 480 pixels", " | ms {:.1f} | CPU ms {:.1f}", rows))


def blends(world: World, tree: Tree, out: Path, parts: int) -> None:
    """Compare splats that blend where they overlap, without geometry."""
    blends = {
        "nearest splat": Blend(),
        "opacity": Blend(opacity=True),
        "directions": Blend(directions=True),
        "both": Blend(opacity=True, directions=True),
    }
    empty_clip = nf.Clip(box=tree.bounds + 10 * np.ptp(tree.bounds, axis=0))
    rows = []
    for moment in SWAP_TIMES:
        stability: dict[str, list[float]] = {name: [] for name in ("truth", *blends)}
        errors: dict[str, list[tuple[float, float]]] = {name: [] for name in blends}
        previous: dict[str, nf.Frame] = {}
        for n in range(BLEND_PICTURES):
            truth = truth_at(world, tree, moment + n / RATE, BLEND_SIZE)
            sky = nf.render(world.scene, truth.camera, clip=empty_clip, channels=("color",))
            now = {"truth": truth}
            for name, blend in blends.items():
                now[name] = replace(truth, color=render_blended(tree, truth.camera, blend, sky).color)
                errors[name].append(similarity(truth, now[name]))
            for name, frame in previous.items():
                stability[name].append(float(nf.metrics.motion_ssim(frame, now[name])))
            previous = now
        for name, values in stability.items():
            quality = np.mean(errors[name], axis=0) if name in errors else (None, None)
            rows.append([moment, name, np.mean(values), min(values), *quality])
    header = "time, s {:g} | splats | mean {:.4f} | least {:.4f} | PSNR {:.2f} | SSIM {:.4f}"
    print(table("Splats that blend", header, rows))


TABLES = {each.__name__: each for each in (flight, swaps, speed, blends)}

if __name__ == "__main__":
    main()
