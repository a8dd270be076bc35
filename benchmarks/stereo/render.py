"""Hybrid stereo against plain stereo by mono plane: time of each stage, pixels, triangles and SSIM, as Fig. 5 and 6.

python -m benchmarks.stereo.render [--quick] [--scenes beams,forest] [--backend gpu] [--plots out/bench]
"""

from __future__ import annotations

import argparse
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

import nearfar as nf
from benchmarks.harness.timing import machine, table
from benchmarks.stereo.rig import PAPER

PLANES = (3.0, 8.0, 16.0, 31.0)
FAR = 1000.0
"""The far plane of the paper, metres; a mono plane there leaves nothing to share."""
STAGES = ("left", "right", "culling", "center", "assembly")
HEAD = (0.0, 1.7, 0.0)
AHEAD = (0.0, 0.0, 0.0, 1.0)

SCENES: dict[str, Callable[[], nf.Scene]] = {
    "beams": nf.datasets.beams,
    "spheres": lambda: nf.datasets.spheres(detail=4),
    "landscape": nf.datasets.landscape,
    "forest": lambda: nf.datasets.forest(trees=20000, detail=2),
}


def plain(scene: nf.Scene, rig: nf.stereo.HybridRig, **settings: Any) -> list[nf.Frame]:
    """Both eyes without a plane, between the same depths."""
    clip = rig.clip(HEAD, AHEAD, near=0.1, far=FAR)
    return [nf.render(scene, camera, clip=clip, **settings) for camera in rig.cameras(HEAD, AHEAD)[:2]]


def clock() -> float:
    """Seconds that the adapter has worked on passes, by its own clock; 0 without one."""
    stats = nf.gpu.stats()
    return float(stats.get("raster_seconds", 0.0) + stats.get("resolve_seconds", 0.0))


def seconds(
    jobs: dict[str, Callable[[], Any]], repeat: int, clocks: Callable[[], float]
) -> tuple[dict[str, float], dict[str, float]]:
    """Least wall time of each job, in turns, and the least time by another clock."""
    import time

    best, other = dict.fromkeys(jobs, float("inf")), dict.fromkeys(jobs, float("inf"))
    for _ in range(repeat):
        for name, job in jobs.items():
            start, before = time.perf_counter(), clocks()
            job()
            best[name] = min(best[name], time.perf_counter() - start)
            other[name] = min(other[name], clocks() - before)
    return best, other


def similarity(reference: nf.Frame, test: nf.Frame) -> float:
    """SSIM of sRGB codes with windows of 4 × 4 pixels, as the paper."""
    codes = reference.to_image(), test.to_image()
    return float(nf.ssim(*codes, data_range=255.0, window="uniform", size=4, convention="full"))


def measure(name: str, size: tuple[int, int], repeat: int, backend: str) -> tuple[str, list[dict[str, float]]]:
    """Table of one scene, and its numbers by plane."""
    scene = SCENES[name]()
    settings: dict[str, Any] = {"channels": ("color",), "backend": backend}
    assemblies = ("bilinear", "resolved")
    base = nf.stereo.HybridRig(left=PAPER.left, right=PAPER.right, mono_plane=8.0, size=size)
    truth = plain(scene, base, **settings)
    rows, numbers = [], []
    for plane in (*PLANES, FAR):
        rig = base.with_plane(plane)
        kept: dict[str, nf.StereoFrame] = {}

        def draw(assembly: str, rig: nf.stereo.HybridRig = rig, kept: dict[str, Any] = kept) -> None:
            kept[assembly] = rig.render(scene, HEAD, AHEAD, assembly=assembly, far=FAR, **settings)

        jobs: dict[str, Callable[[], Any]] = {"plain": partial(plain, scene, rig, **settings)}
        jobs |= {assembly: partial(draw, assembly) for assembly in assemblies}
        times, passes = seconds(jobs, repeat, clock if backend == "gpu" else lambda: 0.0)
        counted = rig.triangles(scene, HEAD, AHEAD, far=FAR)
        frame = kept["bilinear"]
        stages, pixels = frame.stats["seconds"], frame.stats["pixels"]
        total = np.prod(rig.center_size)
        scores = {
            assembly: float(np.mean([similarity(a, b) for a, b in zip(truth, (one.left, one.right), strict=True)]))
            for assembly, one in kept.items()
        }
        found = {"plane": plane, **times, **{stage: stages.get(stage, 0.0) for stage in STAGES}}
        found |= {f"ssim_{assembly}": score for assembly, score in scores.items()}
        numbers.append(found)
        primitives = counted["left"] + counted["right"] + counted["center"]
        rows.append(
            [
                f"{plane:g}",
                f"{rig.max_error(FAR):.2f}",
                f"{times['plain']:.2f}",
                *(f"{times[a]:.2f} ({100 * (1 - times[a] / times['plain']):.0f} %)" for a in assemblies),
                f"{passes['plain']:.2f} / {passes['bilinear']:.2f}",
                " / ".join(f"{found[stage]:.2f}" for stage in STAGES),
                f"{100 * pixels.get('center', 0) / total:.0f} %",
                f"{primitives / max(counted['plain'], 1):.2f}",
                *(f"{scores[assembly]:.4f}" for assembly in assemblies),
            ]
        )
    header = [
        *("m, m", "error, px", "plain, s", *(f"{assembly}, s (saved)" for assembly in assemblies)),
        "adapter's clock, plain / bilinear, s",
        *("left / right / culling / centre / assembly, s", "shared pixels drawn", "triangles against plain"),
        *(f"SSIM, {assembly}" for assembly in assemblies),
    ]
    title = f"{name}: {scene.triangle_count:,} triangles, {size[0]} × {size[1]} pixels an eye"
    return table(title, header, rows), numbers


def draw(path: Path, found: dict[str, list[dict[str, float]]]) -> None:
    """Draw time by stage and SSIM by plane, one column for each scene."""
    import matplotlib as mpl

    mpl.use("agg")
    from matplotlib import pyplot as plt

    figure, grid = plt.subplots(2, len(found), figsize=(4.2 * len(found), 7), layout="constrained", squeeze=False)
    for column, (name, numbers) in enumerate(found.items()):
        upper, lower = grid[:, column]
        places, bottom = np.arange(len(numbers)), np.zeros(len(numbers))
        for stage in STAGES:
            values = np.array([entry[stage] for entry in numbers])
            upper.bar(places, values, bottom=bottom, label=stage)
            bottom += values
        upper.plot(places, [entry["plain"] for entry in numbers], "k_", markersize=22, label="plain stereo")
        upper.set(title=name, xticks=places, ylabel="seconds" if not column else "")
        upper.set_xticklabels([f"{entry['plane']:g} m" for entry in numbers])
        for assembly, marker in (("bilinear", "o"), ("resolved", "s")):
            if f"ssim_{assembly}" in numbers[0]:
                lower.plot(places, [entry[f"ssim_{assembly}"] for entry in numbers], marker=marker, label=assembly)
        lower.set(xticks=places, xlabel="mono plane", ylabel="SSIM against plain stereo" if not column else "")
        lower.set_xticklabels([f"{entry['plane']:g} m" for entry in numbers])
    figure.legend(*grid[0, 0].get_legend_handles_labels(), loc="outside upper center", ncols=6, fontsize="small")
    grid[1, 0].legend(fontsize="small")
    figure.savefig(path, dpi=90)
    plt.close(figure)


def main() -> None:
    """Print the tables and draw the plot."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="small pictures, once")
    parser.add_argument("--scenes", default=",".join(SCENES), help="names, separated by commas")
    parser.add_argument("--backend", default="cpu", help="cpu or gpu")
    parser.add_argument("--size", default="x".join(map(str, PAPER.size)), help="pixels of an eye")
    parser.add_argument("--plots", type=Path, help="folder for plots")
    arguments = parser.parse_args()
    width, height = map(int, arguments.size.split("x"))
    size = (168, 189) if arguments.quick else (width, height)
    print(machine(), end="\n\n")
    found = {}
    for name in arguments.scenes.split(","):
        text, found[name] = measure(name, size, 1 if arguments.quick else 3, arguments.backend)
        print(text, flush=True)
    if arguments.plots is not None:
        arguments.plots.mkdir(parents=True, exist_ok=True)
        draw(arguments.plots / f"stereo_render_{arguments.backend}.png", found)


if __name__ == "__main__":
    main()
