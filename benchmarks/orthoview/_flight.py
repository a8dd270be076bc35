"""A flight over Tokyo, and the temporal stability of its pictures."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

import nearfar as nf
from benchmarks.orthoview._worlds import World

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
    way = np.array([np.cos(ahead), -0.3, np.sin(ahead)])
    return nf.Camera.look_at(eye, eye + way, fov=FOV, size=size)


def truth_at(world: World, tree: nf.orthoview.OrthoTree, time: float, size: tuple[int, int] = SIZE) -> nf.Frame:
    """Render the truth with its motion since the previous picture."""
    now, before = (camera_at(world, at, size) for at in (time, time - 1 / RATE))
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
        found = {name: Findings([], [], []) for name in METHODS}
        steady, filtered = nf.orthoview.Steady(), nf.orthoview.Steady()
        last: dict[str, nf.Frame] = {}
        for n in range(FRAMES):
            time = number * SECONDS / PARTS + n / RATE
            truth = truth_at(world, tree, time)
            views = tree.render(camera_at(world, time), samples=SAMPLES)
            shown = {
                "truth": truth,
                "orthoviews": views,
                "steady": steady.next(views, time),
                # Without motion, as for the tree's pictures.
                "steady truth": filtered.next(replace(truth, motion=None), time),
            }
            # All are compared where the truth shows the same surfaces.
            now = {name: replace(frame, range=truth.range, motion=truth.motion) for name, frame in shown.items()}
            if n >= FIRST:
                for name, findings in found.items():
                    findings.alike.append(float(nf.metrics.motion_ssim(last[name], now[name])))
                    if name != "truth":
                        findings.psnr.append(nf.psnr(truth, now[name]))
                        findings.ssim.append(float(nf.ssim(truth, now[name])))
            last = now
        folder.mkdir(parents=True, exist_ok=True)
        path.write_text(json.dumps({name: vars(findings) for name, findings in found.items()}))
    return {name: Findings(**findings) for name, findings in json.loads(path.read_text()).items()}


def flown(world: World, tree: nf.orthoview.OrthoTree, folder: Path, most: int) -> Iterator[dict[str, Findings]]:
    """Yield the parts of the flight, of which at most `most` are measured now."""
    missing = [n for n in range(PARTS) if not (folder / f"popping-{n}.json").is_file()]
    later = set(missing[most:])
    return (part(world, tree, n, folder) for n in range(PARTS) if n not in later)


def plot(parts: list[dict[str, Findings]], path: Path) -> None:
    """Plot SSIM of consecutive pictures over time."""
    import matplotlib as mpl

    mpl.use("agg")
    from matplotlib import pyplot as plt

    figure, axis = plt.subplots(figsize=(8, 3.8), layout="constrained")
    colors = {"truth": "black", "orthoviews": "tab:red", "steady": "tab:blue"}
    for name, color in colors.items():
        for n, found in enumerate(parts):
            # Parts are drawn wider than they are: 0.3 s would be a line.
            times = (n + 0.9 * np.arange(len(found[name].alike)) / len(found[name].alike)) * SECONDS / PARTS
            label = {"steady": "orthoviews, steady"}.get(name, name) if n == 0 else None
            axis.plot(times, found[name].alike, color=color, linewidth=1.2, label=label)
    axis.set(
        xlabel=f"time, s; each part has {FRAMES - FIRST} pictures ({(FRAMES - FIRST) / RATE:.1f} s, drawn wider)",
        ylabel="motion-compensated SSIM",
    )
    axis.grid(alpha=0.3)
    axis.legend(loc="lower left")
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path, dpi=90)
    plt.close(figure)
