"""Popping: stability of consecutive pictures of a flight, with and without `Steady`, and its cost.

    python -m benchmarks.orthoview.popping flight swaps speed blends --tiles FOLDER --trees FOLDER --out FOLDER

The flight is measured in parts, whose findings are stored in --out: --parts limits the number measured in a run, and
the table contains all available ones. The tree has 26 directions; see `benchmarks.orthoview.pictures`.
"""

from __future__ import annotations

import argparse
import tempfile
from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np

import nearfar as nf
from benchmarks.harness.timing import best, machine, table
from benchmarks.orthoview._blends import Blend, render_blended
from benchmarks.orthoview._flight import METHODS, PARTS, RATE, SAMPLES, camera_at, flown, plot, truth_at
from benchmarks.orthoview._worlds import World, tokyo

PLACES = (2.0, 12.0, 22.0)
"""Times of the flight at which cuts are swapped, seconds."""
FADE = 36
"""Number of pictures of a fade that are compared."""
SMALL = (160, 120)
BLENDED = 8
"""Number of pictures of splats that blend."""
Tree = nf.orthoview.OrthoTree


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("tables", nargs="*", help=f"of {', '.join(TABLES)}; by default all")
    parser.add_argument("--tiles", help="folder of tiles of the whole of Tokyo, which nf.write_tiles wrote")
    parser.add_argument("--trees", type=Path, help="folder for the tree; by default one that is removed")
    parser.add_argument("--out", type=Path, help="folder for findings and the plot; by default one that is removed")
    parser.add_argument("--parts", type=int, default=PARTS)
    given = parser.parse_args()
    world = tokyo(given.tiles)
    print(machine(), "\n")
    with tempfile.TemporaryDirectory() as folder:
        tree = nf.orthoview.open(world.build(given.trees or Path(folder)))
        for name in given.tables or TABLES:
            TABLES[name](world, tree, given.out or Path(folder), given.parts)


def flight(world: World, tree: Tree, out: Path, parts: int) -> None:
    """Table of the similarity of consecutive pictures, and their errors."""
    found = list(flown(world, tree, out, parts))
    rows = []
    for name in METHODS:
        alike, psnr, ssim = (
            np.concatenate([getattr(part[name], what) for part in found]) for what in ("alike", "psnr", "ssim")
        )
        truth = np.concatenate([part["truth"].alike for part in found])
        numbers = [alike.mean(), np.percentile(alike, 1), alike.min(), (alike - truth).min()]
        errors = [f"{psnr.mean():.2f}", f"{ssim.mean():.4f}"] if len(psnr) else ["", ""]
        rows.append([name, *(f"{number:.4f}" for number in numbers), *errors])
    header = ["pictures", "mean", "1st percentile", "least", "least above the truth's", "PSNR", "SSIM"]
    print(table(f"Flight, {len(found)} parts", header, rows))
    plot(found, out / "orthoview_steady.png")


def swaps(world: World, tree: Tree, out: Path, parts: int) -> None:
    """Table of the least similarity of consecutive pictures after the cut was swapped for a static camera."""
    del out, parts
    rows = []
    for time in PLACES:
        camera = camera_at(world, time)
        start = tree.render(camera, samples=SAMPLES)
        for name, views, error_px in (("error 2 px", 3, 2.0), ("2 views", 2, 1.0), ("5 views", 5, 1.0)):
            other = tree.render(camera, samples=SAMPLES, views=views, error_px=error_px)
            rows.append([f"{time:g} s", name, *fades(start, other)])
        one, two = (tree.render(side, samples=SAMPLES) for side in bisector(tree, world, time))
        rows.append([f"{time:g} s", "other directions", *fades(one, two)])
    print(table("Swapped cuts", ["place", "change", "without", "72 pictures a second", "30"], rows))


def fades(one: nf.Frame, other: nf.Frame) -> Iterator[str]:
    """Yield SSIM without and with blending."""
    yield f"{nf.ssim(one, other):.4f}"
    for rate in (RATE, 30):
        steady = nf.orthoview.Steady()
        shown = [steady.next(one, 0.0), *(steady.next(other, n / rate) for n in range(1, FADE))]
        yield f"{min(nf.ssim(a, b) for a, b in pairwise(shown)):.4f}"


def bisector(tree: Tree, world: World, start: float) -> tuple[nf.Camera, nf.Camera]:
    """Cameras on both sides of the next place of the flight at which some cell is seen from other directions."""

    def directions(time: float) -> set[object]:
        return set(tree.cut(camera_at(world, time)).keys(in_picture=True))

    low, high = start, start + 1 / RATE
    first = directions(low)
    while directions(high) == first:
        low, high = high, high + 1 / RATE
    while high - low > 1e-6:
        middle = (low + high) / 2
        low, high = (middle, high) if directions(middle) == first else (low, middle)
    return camera_at(world, low), camera_at(world, high)


def speed(world: World, tree: Tree, out: Path, parts: int) -> None:
    """Table of the time of a picture of 640 × 480 pixels."""
    del out, parts
    moments = [12 + n / RATE for n in range(2)]
    frames = [tree.render(camera_at(world, time, (640, 480))) for time in moments]
    steady, count = nf.orthoview.Steady(), iter(range(1000))

    def blend() -> nf.Frame:
        n = next(count)
        return steady.next(frames[n % 2], n / RATE)

    rows = []
    for name, job in (
        ("Steady.next", blend),
        ("motion_blur, 8 poses", lambda: nf.orthoview.motion_blur(frames[1], frames[0].camera)),
    ):
        timing = best(job, repeat=11)
        rows.append([name, f"{timing.wall * 1e3:.1f}", f"{timing.cpu * 1e3:.1f}"])
    print(table("640 × 480 pixels", ["", "ms", "CPU ms"], rows))


def blends(world: World, tree: Tree, out: Path, parts: int) -> None:
    """Compare splats that blend where they overlap, without geometry."""
    del out, parts
    blends = {
        "nearest splat": Blend(),
        "opacity": Blend(opacity=True),
        "directions": Blend(directions=True),
        "both": Blend(opacity=True, directions=True),
    }
    nowhere = nf.Clip(box=tree.bounds + 10 * np.ptp(tree.bounds, axis=0))
    rows = []
    for start in PLACES:
        alike: dict[str, list[float]] = {name: [] for name in ("truth", *blends)}
        errors: dict[str, list[tuple[float, float]]] = {name: [] for name in blends}
        last: dict[str, nf.Frame] = {}
        for n in range(BLENDED):
            truth = truth_at(world, tree, start + n / RATE, SMALL)
            sky = nf.render(world.scene, truth.camera, clip=nowhere, channels=("color",))
            now = {"truth": truth}
            for name, blend in blends.items():
                now[name] = replace(truth, color=render_blended(tree, truth.camera, blend, sky).color)
                errors[name].append((nf.psnr(truth, now[name]), float(nf.ssim(truth, now[name]))))
            for name, frame in last.items():
                alike[name].append(float(nf.metrics.motion_ssim(frame, now[name])))
            last = now
        for name, values in alike.items():
            row = [f"{start:g} s", name, f"{np.mean(values):.4f}", f"{min(values):.4f}"]
            psnr, ssim = np.mean(errors[name], axis=0) if name in errors else (None, None)
            rows.append([*row, *(["", ""] if psnr is None else [f"{psnr:.2f}", f"{ssim:.4f}"])])
    print(table("Splats that blend", ["place", "splats", "mean", "least", "PSNR", "SSIM"], rows))


TABLES: dict[str, Callable[[World, Tree, Path, int], None]] = {
    "flight": flight,
    "swaps": swaps,
    "speed": speed,
    "blends": blends,
}

if __name__ == "__main__":
    main()
