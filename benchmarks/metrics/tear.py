"""Readings of `tear` on pictures with a known tear: widths, directions, shear, curvature, overlap.

python -m benchmarks.metrics.tear [--quick] [--plots out/bench]
"""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np

import nearfar as nf
from benchmarks.harness.timing import machine, table
from benchmarks.harness.torn import at_the_line, torn

TEARS = (1.0, 3.0, 10.0, 40.0)
DIRECTIONS = {"upright": 0.0, "slanted": 0.5, "level": np.pi / 2.0}
CASES: tuple[tuple[str, str, float, float], ...] = (
    ("opening", "opening", 0.0, 0.0),
    ("sliding", "sliding", 0.0, 0.0),
    ("opening, shear 0.5", "opening", 0.5, 0.0),
    ("opening, shear 5", "opening", 5.0, 0.0),
    ("sliding, shear 5", "sliding", 5.0, 0.0),
    ("opening, curved", "opening", 0.0, 0.002),
    ("overlap", "overlap", 0.0, 0.0),
)
"""Name, motion of the halves, shear and curvature."""


def measured(kind: str, shear: float, curvature: float, tear: float, direction: float) -> float:
    """Mean tear measured along the line."""
    frame = torn(tear, direction, kind=kind, shear=shear, curvature=curvature)
    return float(at_the_line(nf.metrics.tear(frame), tear, direction, kind=kind).mean())


def main() -> None:
    """Print the table and draw the chart."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="one direction")
    parser.add_argument("--plots", type=Path, help="folder for the chart")
    arguments = parser.parse_args()
    directions = dict(list(DIRECTIONS.items())[:1]) if arguments.quick else DIRECTIONS
    print(machine(), end="\n\n")
    found = {
        name: np.array([[measured(kind, shear, bent, tear, way) for tear in TEARS] for way in directions.values()])
        for name, kind, shear, bent in CASES
    }
    rows = [
        [name, *(f"{low:.3g} to {high:.3g}" for low, high in zip(values.min(axis=0), values.max(axis=0), strict=True))]
        for name, values in found.items()
    ]
    header = ["picture", *(f"tear of {tear:g} px" for tear in TEARS)]
    print(table(f"What tear reads along the line, {', '.join(directions)}", header, rows))
    if arguments.plots is not None:
        arguments.plots.mkdir(parents=True, exist_ok=True)
        draw(found, arguments.plots / "tear.png")


def draw(found: dict[str, np.ndarray[tuple[int, ...], np.dtype[np.float64]]], path: Path) -> None:
    """Draw the ratio of read to true tear, with the band of ± 10 %."""
    import matplotlib as mpl

    mpl.use("agg")
    from matplotlib import pyplot as plt

    figure, axes = plt.subplots(figsize=(7.4, 3.6), layout="constrained")
    axes.axhspan(0.9, 1.1, color="0.92", label="± 10 %")
    for n, (name, values) in enumerate(found.items()):
        at = np.arange(len(TEARS)) + 0.1 * (n - len(found) / 2)
        ratios = values / np.array(TEARS)
        axes.vlines(at, ratios.min(axis=0), ratios.max(axis=0), color=f"C{n}")
        axes.plot(np.tile(at, len(ratios)), ratios.ravel(), "o", markersize=4, color=f"C{n}", label=name)
    axes.set(ylim=(-0.05, 1.2), xlabel="tear, pixels", ylabel="read / true")
    axes.set_xticks(range(len(TEARS)), [f"{tear:g}" for tear in TEARS])
    axes.legend(fontsize=8, loc="center left", bbox_to_anchor=(1.0, 0.5))
    axes.grid(alpha=0.3, axis="y")
    figure.savefig(path, dpi=100)
    plt.close(figure)


if __name__ == "__main__":
    main()
