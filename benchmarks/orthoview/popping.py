"""Popping: stability of consecutive pictures of a flight, with and without `Steady`, and its cost.

    python -m benchmarks.orthoview.popping flight swaps speed blends --tiles FOLDER --trees FOLDER --out FOLDER

The flight is measured in parts, whose findings are stored in --out: --parts limits the number measured in a run, and
the table contains all available ones. The tree has 26 directions; see `benchmarks.orthoview.pictures`.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import pairwise
from pathlib import Path

import numpy as np

import nearfar as nf
from benchmarks.harness.report import folder_or_temporary, save_figure, start, subplots, table
from benchmarks.harness.timing import best
from benchmarks.orthoview._blends import Blend, render_blended
from benchmarks.orthoview._worlds import World, tokyo

PLACES = (2.0, 12.0, 22.0)
"""Times of the flight at which cuts are swapped, seconds."""
FADE = 36
"""Number of pictures of a fade that are compared."""
SMALL = (160, 120)
BLENDED = 8
"""Number of pictures of splats that blend."""
Tree = nf.orthoview.OrthoTree

RATE = 72
"""Pictures per second."""
SECONDS = 30.0
SIZE = (320, 240)
FOV = nf.Fov.symmetric(60, 4 / 3)
SAMPLES = 4
"""Samples per pixel of orthoviews; the truth has 16."""
PARTS, FRAMES = 10, 30
"""Number of drawn parts of the flight, and of pictures of each."""
FIRST = 8
"""Number of ignored pictures at a part's start: nothing was faded before."""
METHODS = ("truth", "orthoviews", "steady", "steady truth")


def camera_at(world: World, time: float, size: tuple[int, int] = SIZE) -> nf.Camera:
    """Camera on a third of a circle of 420 m, 18 m or more from the houses, at 29 m/s and heights of 65 to 155 m."""
    angle = np.pi - np.radians(4) * time
    height = 110 + 45 * np.cos(2 * np.pi * time / SECONDS)
    middle = world.box[0] + (world.side / 2, 1.0, world.side / 2)
    eye = middle + np.array([420 * np.cos(angle), height, 420 * np.sin(angle)])
    ahead = angle - np.radians(130)
    direction = np.array([np.cos(ahead), -0.3, np.sin(ahead)])
    return nf.Camera.look_at(eye, eye + direction, fov=FOV, size=size)


def truth_at(world: World, tree: nf.orthoview.OrthoTree, time: float, size: tuple[int, int] = SIZE) -> nf.Frame:
    """Render the truth with its motion since the previous picture."""
    now, before = (camera_at(world, moment, size) for moment in (time, time - 1 / RATE))
    channels = ("color", "range", "motion")
    clip = nf.Clip(box=tree.bounds)
    return nf.render(world.scene, now, before=before, samples=16, channels=channels, clip=clip)


@dataclass
class Findings:
    """Findings about a method's pictures."""

    alike: list[float]
    """Motion-compensated SSIM of each picture with the previous one."""
    psnr: list[float]
    ssim: list[float]


def part(world: World, tree: nf.orthoview.OrthoTree, number: int, folder: Path) -> dict[str, Findings]:
    """Measure a part of the flight, unless the folder contains it."""
    path = folder / f"popping-{number}.json"
    if not path.is_file():
        findings_by_method = {name: Findings([], [], []) for name in METHODS}
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
                # Without motion, as for the tree's pictures.
                "steady truth": filtered.next(replace(truth, motion=None), time),
            }
            # All are compared where the truth shows the same surfaces.
            now = {name: replace(frame, range=truth.range, motion=truth.motion) for name, frame in drawn.items()}
            if n >= FIRST:
                for name, findings in findings_by_method.items():
                    findings.alike.append(float(nf.metrics.motion_ssim(previous[name], now[name])))
                    if name != "truth":
                        findings.psnr.append(nf.psnr(truth, now[name]))
                        findings.ssim.append(float(nf.ssim(truth, now[name])))
            previous = now
        folder.mkdir(parents=True, exist_ok=True)
        path.write_text(json.dumps({name: vars(findings) for name, findings in findings_by_method.items()}))
    return {name: Findings(**findings) for name, findings in json.loads(path.read_text()).items()}


def flown(world: World, tree: nf.orthoview.OrthoTree, folder: Path, max_measured: int) -> Iterator[dict[str, Findings]]:
    """Yield the parts of the flight, of which at most `max_measured` are measured now."""
    missing = [n for n in range(PARTS) if not (folder / f"popping-{n}.json").is_file()]
    later = set(missing[max_measured:])
    return (part(world, tree, n, folder) for n in range(PARTS) if n not in later)


def plot(parts: list[dict[str, Findings]], path: Path) -> None:
    """Plot SSIM of consecutive pictures over time."""
    figure, axis = subplots(figsize=(8, 3.8))
    colors = {"truth": "black", "orthoviews": "tab:red", "steady": "tab:blue"}
    for name, color in colors.items():
        for n, findings_by_method in enumerate(parts):
            # Parts are drawn wider than they are: 0.3 s would be a line.
            alike = findings_by_method[name].alike
            times = (n + 0.9 * np.arange(len(alike)) / len(alike)) * SECONDS / PARTS
            label = {"steady": "orthoviews, steady"}.get(name, name) if n == 0 else None
            axis.plot(times, alike, color=color, linewidth=1.2, label=label)
    axis.set(
        xlabel=f"time, s; each part has {FRAMES - FIRST} pictures ({(FRAMES - FIRST) / RATE:.1f} s, drawn wider)",
        ylabel="motion-compensated SSIM",
    )
    axis.grid(alpha=0.3)
    axis.legend(loc="lower left")
    save_figure(figure, path, dpi=90)


def main() -> None:
    given = start(
        __doc__,
        "--tiles",
        "--trees",
        tables={"nargs": "*", "help": f"of {', '.join(TABLES)}; by default all"},
        out=(Path, "folder for findings and the plot; by default a temporary one"),
        parts=PARTS,
    )
    world = tokyo(given.tiles)
    with folder_or_temporary() as folder:
        tree = nf.orthoview.open(world.build(given.trees or folder))
        for name in given.tables or TABLES:
            TABLES[name](world, tree, given.out or folder, given.parts)


def flight(world: World, tree: Tree, out: Path, parts: int) -> None:
    """Table of the similarity of consecutive pictures, and their errors."""
    measured_parts = list(flown(world, tree, out, parts))
    truth = np.concatenate([part["truth"].alike for part in measured_parts])
    rows = []
    for name in METHODS:
        alike, psnr, ssim = (
            np.concatenate([getattr(part[name], what) for part in measured_parts]) for what in ("alike", "psnr", "ssim")
        )
        numbers = [alike.mean(), np.percentile(alike, 1), alike.min(), (alike - truth).min()]
        rows.append([name, *numbers, *([psnr.mean(), ssim.mean()] if len(psnr) else [None, None])])
    header = "pictures | mean {:.4f} | 1st percentile {:.4f} | least {:.4f} | least above the truth's {:.4f}"
    print(table(f"Flight, {len(measured_parts)} parts", header + " | PSNR {:.2f} | SSIM {:.4f}", rows))
    plot(measured_parts, out / "orthoview_steady.png")


def swaps(world: World, tree: Tree, out: Path, parts: int) -> None:
    """Table of the least similarity of consecutive pictures after the cut was swapped for a static camera."""
    rows = []
    for time in PLACES:
        camera = camera_at(world, time)
        start = tree.render(camera, samples=SAMPLES)
        for name, views, error_px in (("error 2 px", 3, 2.0), ("2 views", 2, 1.0), ("5 views", 5, 1.0)):
            other = tree.render(camera, samples=SAMPLES, views=views, error_px=error_px)
            rows.append([f"{time:g} s", name, *fades(start, other)])
        one, two = (tree.render(side, samples=SAMPLES) for side in bisector(tree, world, time))
        rows.append([f"{time:g} s", "other directions", *fades(one, two)])
    print(table("Swapped cuts", "place | change | without | 72 pictures a second | 30", rows))


def fades(one: nf.Frame, other: nf.Frame) -> Iterator[str]:
    """Yield SSIM without and with blending."""
    yield f"{nf.ssim(one, other):.4f}"
    for rate in (RATE, 30):
        steady = nf.orthoview.Steady()
        pictures = [steady.next(one, 0.0), *(steady.next(other, n / rate) for n in range(1, FADE))]
        yield f"{min(nf.ssim(a, b) for a, b in pairwise(pictures)):.4f}"


def bisector(tree: Tree, world: World, start: float) -> tuple[nf.Camera, nf.Camera]:
    """Cameras on both sides of the next place of the flight at which some cell is seen from other directions."""

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
    """Table of the time of a picture of 640 × 480 pixels."""
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
    nowhere = nf.Clip(box=tree.bounds + 10 * np.ptp(tree.bounds, axis=0))
    rows = []
    for moment in PLACES:
        alike: dict[str, list[float]] = {name: [] for name in ("truth", *blends)}
        errors: dict[str, list[tuple[float, float]]] = {name: [] for name in blends}
        previous: dict[str, nf.Frame] = {}
        for n in range(BLENDED):
            truth = truth_at(world, tree, moment + n / RATE, SMALL)
            sky = nf.render(world.scene, truth.camera, clip=nowhere, channels=("color",))
            now = {"truth": truth}
            for name, blend in blends.items():
                now[name] = replace(truth, color=render_blended(tree, truth.camera, blend, sky).color)
                errors[name].append((nf.psnr(truth, now[name]), float(nf.ssim(truth, now[name]))))
            for name, frame in previous.items():
                alike[name].append(float(nf.metrics.motion_ssim(frame, now[name])))
            previous = now
        for name, values in alike.items():
            quality = np.mean(errors[name], axis=0) if name in errors else (None, None)
            rows.append([moment, name, np.mean(values), min(values), *quality])
    header = "place {:g} s | splats | mean {:.4f} | least {:.4f} | PSNR {:.2f} | SSIM {:.4f}"
    print(table("Splats that blend", header, rows))


TABLES = {each.__name__: each for each in (flight, swaps, speed, blends)}

if __name__ == "__main__":
    main()
