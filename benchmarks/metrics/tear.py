"""Readings of `tear` on pictures with a known tear: widths, directions, shear, curvature, overlap."""

from __future__ import annotations

from pathlib import Path

import numpy as np

import nearfar as nf
from benchmarks.harness.report import save_figure, start, subplots, table
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


def measure(kind: str, shear: float, curvature: float, tear: float, direction: float) -> float:
    frame = torn(tear, direction, kind=kind, shear=shear, curvature=curvature)
    return float(at_the_line(nf.metrics.tear(frame), tear, direction, kind=kind).mean())


def main() -> None:
    arguments = start(__doc__, "--quick", "--plots")
    directions = dict(list(DIRECTIONS.items())[:1]) if arguments.quick else DIRECTIONS
    readings = {
        name: np.array([[measure(kind, shear, bent, tear, angle) for tear in TEARS] for angle in directions.values()])
        for name, kind, shear, bent in CASES
    }
    rows = [[name, *zip(values.min(axis=0), values.max(axis=0), strict=True)] for name, values in readings.items()]
    header = ["picture", *(f"tear of {tear:g} px {{:.3g}} to {{:.3g}}" for tear in TEARS)]
    print(table(f"What tear reads along the line, {', '.join(directions)}", header, rows))
    if arguments.plots is not None:
        draw(readings, arguments.plots / "tear.png")


def draw(readings: dict[str, np.ndarray[tuple[int, ...], np.dtype[np.float64]]], path: Path) -> None:
    """Draw the ratio of read to true tear, with the band of ± 10 %."""
    figure, axes = subplots(figsize=(7.4, 3.6))
    axes.axhspan(0.9, 1.1, color="0.92", label="± 10 %")
    for n, (name, values) in enumerate(readings.items()):
        x = np.arange(len(TEARS)) + 0.1 * (n - len(readings) / 2)
        ratios = values / np.array(TEARS)
        axes.vlines(x, ratios.min(axis=0), ratios.max(axis=0), color=f"C{n}")
        axes.plot(np.tile(x, len(ratios)), ratios.ravel(), "o", markersize=4, color=f"C{n}", label=name)
    axes.set(ylim=(-0.05, 1.2), xlabel="tear, pixels", ylabel="read / true")
    axes.set_xticks(range(len(TEARS)), [f"{tear:g}" for tear in TEARS])
    axes.legend(fontsize=8, loc="center left", bbox_to_anchor=(1.0, 0.5))
    axes.grid(alpha=0.3, axis="y")
    save_figure(figure, path)


if __name__ == "__main__":
    main()
