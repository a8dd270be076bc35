"""Plot of the sphere collection: times and misses by level."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Protocol

import numpy as np

from benchmarks.harness.report import save_figure, subplots

COLORS = ("0.35", "C0", "C1", "C2")


class Row(Protocol):
    """Figures of some trials."""

    @property
    def name(self) -> str:
        """Name of the row."""

    @property
    def seconds(self) -> tuple[tuple[float, float], ...]:
        """Means and standard deviations by level."""

    @property
    def misses(self) -> tuple[float, ...]:
        """Mean misses per sphere by level."""


def levels(path: Path, names: Sequence[str], rows: Sequence[Row]) -> None:
    """Seconds with their deviations, and misses, by level; the first row is the paper's."""
    figure, (left, right) = subplots(1, 2, figsize=(9, 3.6))
    width = 0.8 / len(rows)
    for number, (row, color) in enumerate(zip(rows, COLORS, strict=False)):
        at = np.arange(len(names)) + (number - 0.5 * (len(rows) - 1)) * width
        means, deviations = zip(*row.seconds, strict=True)
        # Bars of deviations end at 0, as times do.
        below = np.minimum(deviations, means)
        left.bar(at, means, width, yerr=(below, deviations), color=color, capsize=3, label=row.name)
        right.bar(at, row.misses, width, color=color)
    for axes, label in ((left, "seconds of a sphere, ± one deviation"), (right, "misses of a sphere")):
        axes.set_xticks(range(len(names)), names)
        axes.set(ylabel=label)
    right.set(title="of a sphere or a trial: the paper does not say", ylim=(0.0, None))
    right.title.set_fontsize("small")
    left.set(ylim=(0.0, None))
    left.legend(fontsize="small", loc="upper left")
    save_figure(figure, path, dpi=70)
