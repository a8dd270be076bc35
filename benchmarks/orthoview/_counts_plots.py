"""Plots of the counts of splats."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from numpy.typing import NDArray

from benchmarks.harness.report import save_figure, subplots

NAMES = ("in memory: the cut all around", "in the picture", "seen: not hidden")


def save_counts(
    counts: NDArray[Any],
    within: tuple[NDArray[Any], NDArray[Any]],
    flat: tuple[Sequence[int], Sequence[int]],
    path: Path,
) -> None:
    """Plot the three counts of each frame, and cells against distance and against the world's size."""
    figure, (left, right) = subplots(1, 2, figsize=(10, 3.8), width_ratios=(3, 2))
    for name, column in zip(NAMES, counts.T, strict=True):
        left.plot(column, label=name)
    left.set(yscale="log", ylim=(counts.min() / 2, counts.max() * 8), xlabel="frame of the walk", ylabel="splats")
    left.legend(loc="upper right")
    distance, cells = within
    right.step(distance[distance > 0] / 1e3, cells[distance > 0], where="post", label="Tokyo: within this distance, km")
    right.plot(*flat, "o-", label="flat worlds of this width, leaves")
    right.set(xscale="log", xlabel="distance or width", ylabel="cells of the cut")
    right.legend(loc="upper left")
    finish(figure, (left, right), path)


def save_changes(errors: NDArray[Any], lines: Mapping[str, NDArray[Any]], path: Path) -> None:
    """Plot changes from picture to picture against the error."""
    figure, axis = subplots(figsize=(7, 3.4))
    for name, changes in lines.items():
        axis.plot(errors, changes, "o-", markersize=3, label=name)
    axis.set(xlabel="error_px of a camera that does not move", ylabel="RMS change, codes of 255")
    figure.legend(loc="outside upper center", ncols=2)
    finish(figure, (axis,), path)


def finish(figure: Any, axes: Sequence[Any], path: Path) -> None:
    for axis in axes:
        axis.grid(alpha=0.3)
    save_figure(figure, path, dpi=90)
