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
CULLS = ("frustum", "discard", "occlusion")
KINDS = (*CULLS, "resolved")
"""Hybrid pictures: bilinear ones by culling mode, and resolved ones."""
STAGES = ("left", "right", "culling", "center", "assembly", "filling")
HEAD = (0.0, 1.7, 0.0)
AHEAD = (0.0, 0.0, 0.0, 1.0)

SCENES: dict[str, Callable[[], nf.Scene]] = {
    "beams": nf.datasets.beams,
    "spheres": lambda: nf.datasets.spheres(detail=4),
    "landscape": nf.datasets.landscape,
    "forest": lambda: nf.datasets.forest(trees=20000, detail=2),
}


def plain(scene: nf.Scene, rig: nf.stereo.HybridRig, **settings: Any) -> list[nf.Frame]:
    """Render both eyes without a plane, between the same depths."""
    clip = rig.clip(HEAD, AHEAD, near=0.1, far=FAR)
    return [nf.render(scene, camera, clip=clip, **settings) for camera in rig.cameras(HEAD, AHEAD)[:2]]


def clock() -> float:
    """Seconds of the adapter's passes, by its own clock; 0 without one."""
    stats = nf.gpu.stats()
    return float(stats.get("raster_seconds", 0.0) + stats.get("resolve_seconds", 0.0))


def seconds(
    jobs: dict[str, Callable[[], Any]], repeat: int, clocks: Callable[[], float]
) -> tuple[dict[str, float], dict[str, float]]:
    """Least wall time of each job, run alternately, and the least time by another clock."""
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
    """SSIM of sRGB codes with windows of 4 × 4 pixels, as in the paper."""
    codes = reference.to_image(), test.to_image()
    return float(nf.ssim(*codes, data_range=255.0, window="uniform", size=4, convention="full"))


def measure(name: str, size: tuple[int, int], repeat: int, backend: str) -> tuple[str, list[dict[str, float]]]:
    """Tables of one scene, and its numbers by plane."""
    scene = SCENES[name]()
    settings: dict[str, Any] = {"channels": ("color",), "backend": backend}
    base = nf.stereo.HybridRig(left=PAPER.left, right=PAPER.right, mono_plane=8.0, size=size)
    truth = plain(scene, base, **settings)
    rows, stages, numbers = [], [], []
    for plane in (*PLANES, FAR):
        rig = base.with_plane(plane)
        kept: dict[str, nf.StereoFrame] = {}

        def draw(name: str, rig: nf.stereo.HybridRig = rig, kept: dict[str, Any] = kept, **how: Any) -> None:
            kept[name] = rig.render(scene, HEAD, AHEAD, far=FAR, **settings, **how)

        jobs: dict[str, Callable[[], Any]] = {"plain": partial(plain, scene, rig, **settings)}
        jobs |= {cull: partial(draw, cull, cull=cull) for cull in CULLS}
        jobs["resolved"] = partial(draw, "resolved", assembly="resolved")
        times, passes = seconds(jobs, repeat, clock if backend == "gpu" else lambda: 0.0)
        found = {"plane": plane, **times, **found_stages(kept["occlusion"])}
        scores = {kind: score(truth, kept[kind]) for kind in ("occlusion", "resolved")}
        found |= {f"ssim_{kind}": value for kind, value in scores.items()}
        numbers.append(found)
        rows.append(
            [
                f"{plane:g}",
                f"{rig.max_error(FAR):.2f}",
                f"{times['plain']:.2f}",
                *(f"{times[kind]:.2f} ({100 * (1 - times[kind] / times['plain']):.0f} %)" for kind in KINDS),
                *([f"{passes['plain']:.2f} / {passes['occlusion']:.2f}"] if backend == "gpu" else []),
                *(f"{value:.4f}" for value in scores.values()),
            ]
        )
        stages.append([f"{plane:g}", *stage_row(rig, scene, kept["occlusion"], found)])
    header = ["m, m", "error, px", "plain, s"]
    header += [f"{kind}, s (saved)" for kind in KINDS]
    header += ["adapter's clock, plain / occlusion, s"] if backend == "gpu" else []
    header += ["SSIM, bilinear", "SSIM, resolved"]
    title = f"{name}: {scene.triangle_count:,} triangles, {size[0]} × {size[1]} pixels an eye"
    parts = [table(title, header, rows), table(f"{name}: stages, cull = occlusion", STAGE_HEADER, stages)]
    return "\n".join(parts), numbers


def score(truth: list[nf.Frame], frame: nf.StereoFrame) -> float:
    """Mean SSIM of both eyes against plain stereo."""
    return float(np.mean([similarity(a, b) for a, b in zip(truth, (frame.left, frame.right), strict=True)]))


def found_stages(frame: nf.StereoFrame) -> dict[str, float]:
    """Seconds of each stage; those of plain stereo are divided equally between both eyes."""
    found = dict(frame.stats["seconds"])
    eyes = found.pop("eyes", 0.0)
    return {stage: found.get(stage, eyes / 2 if stage in ("left", "right") else 0.0) for stage in STAGES}


STAGE_HEADER = [
    *("m, m", "left / right / culling / centre / assembly / filling, s"),
    *("triangles of left / right / centre, thousands", "drawn thrice", "against plain"),
    *("pixels of left / right / centre, thousands", "against plain"),
]


def stage_row(rig: nf.stereo.HybridRig, scene: nf.Scene, frame: nf.StereoFrame, found: dict[str, float]) -> list[str]:
    """Seconds, primitives and fragments of each view, as in Fig. 5."""
    counted = rig.triangles(scene, HEAD, AHEAD, far=FAR)
    views = [counted[view] for view in ("left", "right", "center")]
    whole = 2 * rig.size[0] * rig.size[1]
    pixels = [frame.stats["pixels"].get(view, whole / 2) for view in ("left", "right")]
    pixels.append(frame.stats["pixels"].get("center", 0))
    return [
        " / ".join(f"{found[stage]:.2f}" for stage in STAGES),
        " / ".join(f"{view / 1000:,.0f}" for view in views),
        f"{counted['thrice']:,}",
        f"{sum(views) / max(counted['plain'], 1):.2f}",
        " / ".join(f"{view / 1000:,.0f}" for view in pixels),
        f"{sum(pixels) / whole:.2f}",
    ]


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
        for kind, assembly, marker in (("occlusion", "bilinear", "o"), ("resolved", "resolved", "s")):
            lower.plot(places, [entry[f"ssim_{kind}"] for entry in numbers], marker=marker, label=assembly)
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
    parser.add_argument("--repeat", type=int, default=3, help="times of which the least counts")
    parser.add_argument("--plots", type=Path, help="folder for plots")
    arguments = parser.parse_args()
    width, height = map(int, arguments.size.split("x"))
    size = (168, 189) if arguments.quick else (width, height)
    print(machine(), end="\n\n")
    found = {}
    for name in arguments.scenes.split(","):
        text, found[name] = measure(name, size, 1 if arguments.quick else arguments.repeat, arguments.backend)
        print(text, flush=True)
    if arguments.plots is not None:
        arguments.plots.mkdir(parents=True, exist_ok=True)
        draw(arguments.plots / f"stereo_render_{arguments.backend}.png", found)


if __name__ == "__main__":
    main()
