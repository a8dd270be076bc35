"""Hybrid stereo against plain stereo by mono plane: time of each stage, pixels, triangles and SSIM, as Fig. 5 and 6."""

from __future__ import annotations

import time
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

import nearfar as nf
from benchmarks.harness.report import save_figure, start, subplots, table
from benchmarks.harness.timing import best_in_turns
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


def measure(name: str, size: tuple[int, int], repeat: int, backend: str) -> tuple[str, list[dict[str, float]]]:
    """Tables of one scene, and its numbers by plane."""
    scene, is_on_adapter = SCENES[name](), backend == "gpu"
    settings: dict[str, Any] = {"channels": ("color",), "backend": backend}
    base = nf.stereo.HybridRig(left=PAPER.left, right=PAPER.right, mono_plane=8.0, size=size)
    truth = plain(scene, base, **settings)
    rows, stages, numbers = [], [], []
    for plane in (*PLANES, FAR):
        rig = base.with_plane(plane)
        frames: dict[str, nf.StereoFrame] = {}

        def draw(name: str, rig: nf.stereo.HybridRig = rig, frames: dict[str, Any] = frames, **how: Any) -> None:
            frames[name] = rig.render(scene, HEAD, AHEAD, far=FAR, **settings, **how)

        jobs: dict[str, Callable[[], Any]] = {"plain": partial(plain, scene, rig, **settings)}
        jobs |= {cull: partial(draw, cull, cull=cull) for cull in CULLS}
        jobs["resolved"] = partial(draw, "resolved", assembly="resolved")
        timings = best_in_turns(jobs, repeat, clock if is_on_adapter else time.process_time)
        times = {kind: timing.wall for kind, timing in timings.items()}
        scores = {kind: score(truth, frames[kind]) for kind in ("occlusion", "resolved")}
        numbers_at_plane = {"plane": plane, **times, **stage_seconds(frames["occlusion"])}
        numbers_at_plane |= {f"ssim_{kind}": value for kind, value in scores.items()}
        numbers.append(numbers_at_plane)
        saved = [(times[kind], 100 * (1 - times[kind] / times["plain"])) for kind in KINDS]
        passes = [(timings["plain"].cpu, timings["occlusion"].cpu)] if is_on_adapter else []
        rows.append([plane, rig.max_error(FAR), times["plain"], *saved, *passes, *scores.values()])
        stages.append([plane, *stage_row(rig, scene, frames["occlusion"], numbers_at_plane)])
    header = ["m, m {:g}", "error, px {:.2f}", "plain, s {:.2f}"]
    header += [f"{kind}, s (saved) {{:.2f}} ({{:.0f}} %)" for kind in KINDS]
    header += ["adapter's clock, plain / occlusion, s {:.2f} / {:.2f}"] if is_on_adapter else []
    header += ["SSIM, bilinear {:.4f}", "SSIM, resolved {:.4f}"]
    title = f"{name}: {scene.triangle_count:,} triangles, {size[0]} × {size[1]} pixels an eye"
    parts = [table(title, header, rows), table(f"{name}: stages, cull = occlusion", STAGE_HEADER, stages)]
    return "\n".join(parts), numbers


def score(truth: list[nf.Frame], frame: nf.StereoFrame) -> float:
    """Mean SSIM of both eyes against plain stereo, of sRGB codes with windows of 4 × 4 pixels, as in the paper."""
    eyes = [[each.to_image() for each in pair] for pair in zip(truth, (frame.left, frame.right), strict=True)]
    settings: dict[str, Any] = {"data_range": 255.0, "window": "uniform", "size": 4, "convention": "full"}
    return float(np.mean([nf.ssim(*pair, **settings) for pair in eyes]))


def stage_seconds(frame: nf.StereoFrame) -> dict[str, float]:
    """Seconds of each stage; those of plain stereo are divided equally between both eyes."""
    seconds_of = dict(frame.stats["seconds"])
    eyes = seconds_of.pop("eyes", 0.0)
    return {stage: seconds_of.get(stage, eyes / 2 if stage in ("left", "right") else 0.0) for stage in STAGES}


STAGE_HEADER = [
    *("m, m {:g}", "left / right / culling / centre / assembly / filling, s"),
    *("triangles of left / right / centre, thousands", "drawn thrice {:,}", "against plain {:.2f}"),
    *("pixels of left / right / centre, thousands", "against plain {:.2f}"),
]


def stage_row(
    rig: nf.stereo.HybridRig, scene: nf.Scene, frame: nf.StereoFrame, seconds_of: dict[str, float]
) -> list[object]:
    """Seconds, primitives and fragments of each view, as in Fig. 5."""
    counted = rig.triangles(scene, HEAD, AHEAD, far=FAR)
    views = [counted[view] for view in ("left", "right", "center")]
    pixel_count = 2 * rig.size[0] * rig.size[1]
    pixels = [frame.stats["pixels"].get(view, pixel_count / 2) for view in ("left", "right")]
    pixels.append(frame.stats["pixels"].get("center", 0))
    seconds = " / ".join(f"{seconds_of[stage]:.2f}" for stage in STAGES)
    triangles, pixel_counts = (" / ".join(f"{view / 1000:,.0f}" for view in counts) for counts in (views, pixels))
    shares = sum(views) / max(counted["plain"], 1), sum(pixels) / pixel_count
    return [seconds, triangles, counted["thrice"], shares[0], pixel_counts, shares[1]]


def draw(path: Path, numbers_of: dict[str, list[dict[str, float]]]) -> None:
    """Draw time by stage and SSIM by plane, one column for each scene."""
    figure, grid = subplots(2, len(numbers_of), figsize=(4.2 * len(numbers_of), 7), squeeze=False)
    for column, (name, numbers) in enumerate(numbers_of.items()):
        upper, lower = grid[:, column]
        positions, bottom = np.arange(len(numbers)), np.zeros(len(numbers))
        for stage in STAGES:
            values = np.array([entry[stage] for entry in numbers])
            upper.bar(positions, values, bottom=bottom, label=stage)
            bottom += values
        upper.plot(positions, [entry["plain"] for entry in numbers], "k_", markersize=22, label="plain stereo")
        upper.set(title=name, xticks=positions, ylabel="seconds" if not column else "")
        upper.set_xticklabels([f"{entry['plane']:g} m" for entry in numbers])
        for kind, assembly, marker in (("occlusion", "bilinear", "o"), ("resolved", "resolved", "s")):
            lower.plot(positions, [entry[f"ssim_{kind}"] for entry in numbers], marker=marker, label=assembly)
        lower.set(xticks=positions, xlabel="mono plane", ylabel="SSIM against plain stereo" if not column else "")
        lower.set_xticklabels([f"{entry['plane']:g} m" for entry in numbers])
    figure.legend(*grid[0, 0].get_legend_handles_labels(), loc="outside upper center", ncols=6, fontsize="small")
    grid[1, 0].legend(fontsize="small")
    save_figure(figure, path, dpi=90)


def main() -> None:
    arguments = start(
        __doc__,
        "--quick",
        "--plots",
        scenes=(",".join(SCENES), "names, separated by commas"),
        backend=("cpu", "cpu or gpu"),
        size=("x".join(map(str, PAPER.size)), "pixels of an eye"),
        repeat=(3, "times of which the least counts"),
    )
    width, height = map(int, arguments.size.split("x"))
    size = (168, 189) if arguments.quick else (width, height)
    numbers_of = {}
    for name in arguments.scenes.split(","):
        text, numbers_of[name] = measure(name, size, 1 if arguments.quick else arguments.repeat, arguments.backend)
        print(text, flush=True)
    if arguments.plots is not None:
        draw(arguments.plots / f"stereo_render_{arguments.backend}.png", numbers_of)


if __name__ == "__main__":
    main()
