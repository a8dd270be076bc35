"""Pictures and plots of what the benchmarks measure."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

import nearfar as nf

Points = Sequence[tuple[float, float, float]]
"""Where, PSNR and SSIM."""


def draw_torn(truth: nf.Frame, frames: Mapping[str, nf.Frame], title: str, path: Path) -> None:
    """Draw the truth and each method's picture, and below these their discontinuity on one scale."""
    plt = _pyplot()
    figure, axes = plt.subplots(2, 1 + len(frames), figsize=(4.4 * (1 + len(frames)), 5.4), layout="constrained")
    axes[0, 0].imshow(truth.to_image())
    axes[0, 0].set_title("truth")
    axes[1, 0].remove()
    shown: Any = None
    for column, (name, frame) in enumerate(frames.items(), start=1):
        axes[0, column].imshow(frame.to_image())
        axes[0, column].set_title(name)
        torn = np.abs(nf.discontinuity(frame))
        shown = axes[1, column].imshow(np.clip(torn, 0.0, 4.0), cmap="inferno", vmin=0.0, vmax=4.0)
        axes[1, column].set_title(f"its discontinuity, mean {np.nanmean(torn):.2f}")
    figure.colorbar(shown, ax=axes[1, :].tolist()[1:], shrink=0.8, label="|δ|")
    for axis in axes.flat:
        axis.set(xticks=[], yticks=[])
    figure.suptitle(title)
    figure.savefig(path, dpi=90)
    plt.close(figure)


def draw_errors(by_size: Points, by_distance: Points, title: str, path: Path) -> None:
    """Draw the error of maps by size and that of parallax by distance side by side, on one scale."""
    plt = _pyplot()
    figure, axes = plt.subplots(1, 2, figsize=(8.0, 3.6), sharey=True, layout="constrained")
    for axis, points, label in (
        (axes[0], by_size, "texels across a face of the map"),
        (axes[1], by_distance, "metres from the centre"),
    ):
        at, psnr, _ = zip(*points, strict=True)
        axis.plot(at, psnr, marker="o")
        axis.set_xscale("log", base=2)
        axis.set_xticks(at, [f"{value:g}" for value in at])
        axis.minorticks_off()
        axis.set_xlabel(label)
        axis.grid(visible=True, alpha=0.3)
    axes[0].set(ylabel="PSNR, dB", title="the map, against no map")
    axes[1].set_title("parallax, against the truth")
    figure.suptitle(title)
    figure.savefig(path, dpi=100)
    plt.close(figure)


def _pyplot() -> Any:
    import matplotlib as mpl

    mpl.use("agg")
    from matplotlib import pyplot

    return pyplot
