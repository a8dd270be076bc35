"""Plots in the form of CloVR's (2024) figures 4, 6, 7 and 8."""

from __future__ import annotations

from pathlib import Path

import numpy as np

import nearfar as nf
from benchmarks.harness.report import save_figure, subplots

COLORS = {"vis0": "C3", "vis1": "C1", "clovr": "C0", "clovrd": "C2"}
Lines = dict[str, nf.stream.Timeline]


def quality(path: Path, places: dict[str, Lines]) -> None:
    """Fig. 4: OVC, OFC and continuity by the share of loaded geometry."""
    figure, grid = subplots(3, len(places), figsize=(3.6 * len(places), 7), sharex=True, sharey="row", squeeze=False)
    for column, (place, lines) in zip(grid.T, places.items(), strict=True):
        for name, line in lines.items():
            pictures = line.pictures
            share = np.interp(pictures["time"], line.frames["time"], line.geometry_share)
            for axes, kind in zip(column, ("ovc", "ofc"), strict=False):
                axes.plot(share, pictures[kind], color=COLORS[name], marker=".", ms=4, lw=1, label=name,
                          drawstyle="steps-post")  # fmt: skip
            column[2].plot(share, 1.0 - pictures["continuity"], color=COLORS[name], marker=".", ms=4, lw=0, label=name)
        column[0].set(title=place)
        column[2].set(xlabel="share of geometry loaded", yscale="log", ylim=(1e-6, 2.0))
    for axes, label in zip(grid[:, 0], ("OVC", "OFC", "1 − continuity"), strict=True):
        axes.set(ylabel=label)
    grid[0, 0].legend(fontsize="small")
    save_figure(figure, path, dpi=70)


def times(path: Path, places: dict[str, Lines], vis_seconds: dict[str, dict[str, list[float]]]) -> None:
    """Fig. 6: seconds until the picture is complete and until everything is loaded. Fig. 7: seconds until each radius.

    `vis_seconds` has those of vis0 and vis1 by place.
    """
    figure, grid = subplots(1, 1 + len(places), figsize=(3.6 + 2.7 * len(places), 3.8))
    left = grid[0]
    width = 0.8 / len(COLORS)
    for number, name in enumerate(COLORS):
        x = np.arange(len(places)) + (number - 1.5) * width
        place_lines = [lines[name] for lines in places.values()]
        left.bar(x, [line.total for line in place_lines], width, color=COLORS[name], alpha=0.45)
        left.bar(x, [line.picture for line in place_lines], width, color=COLORS[name], label=name)
    left.set_xticks(range(len(places)), [place.replace(", ", ",\n") for place in places], fontsize="x-small")
    left.set(ylabel="seconds: complete picture, and all (pale)", xlabel=" ", ylim=(0.0, 1.25 * left.get_ylim()[1]))
    left.legend(fontsize="small", ncols=4, loc="upper center", columnspacing=0.8, handlelength=1.0)
    for axes, (place, lines) in zip(grid[1:], places.items(), strict=True):
        for name in COLORS:
            seconds = vis_seconds[place].get(name, lines[name].ring_times[1:])
            # The lines of vis1 and vis0 coincide: both end with the same files.
            axes.plot(lines["clovrd"].radii, seconds, "--" if name == "vis1" else "-", color=COLORS[name], marker=".",
                      label=name)  # fmt: skip
        axes.set(title=place, xlabel="R in metres", ylim=(0.0, None))
    grid[1].set(ylabel="seconds until all within R is there")
    grid[1].legend(fontsize="small")
    save_figure(figure, path, dpi=70)


def rates(path: Path, places: dict[str, Lines], limit: float) -> None:
    """Fig. 8: estimated frames per second while loading."""
    figure, grid = subplots(1, len(places), figsize=(3.4 * len(places), 3), sharey=True, squeeze=False)
    for axes, (place, lines) in zip(grid[0], places.items(), strict=True):
        end = max(lines[name].total for name in lines) + 1.0
        for name, line in lines.items():
            fps = np.minimum(limit, 1.0 / np.maximum(line.frames["seconds"], 1e-9))
            axes.step([*line.frames["time"], end], [*fps, fps[-1]], where="post", color=COLORS[name], label=name)
        axes.set(title=place, xlabel="seconds", xlim=(0.0, end))
    grid[0, 0].set(ylabel="frames a second, estimated", ylim=(0.0, limit * 1.05))
    grid[0, 0].legend(fontsize="small")
    save_figure(figure, path, dpi=70)
