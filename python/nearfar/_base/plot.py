"""Plots with matplotlib, imported on first use."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base import check

if TYPE_CHECKING:
    from matplotlib.axes import Axes

PUBLISHED = ((30.0, 371), (50.0, 1000))
"""(r2 in metres, triangles) of Popescu et al. (2022), Manhattan with 3.7 million triangles; 1000 is an upper bound."""


def load_curve(
    ax: Axes | None, radii: NDArray[np.float64], counts: NDArray[np.int64], total: int, *, published: bool
) -> Axes:
    """Plot the number of triangles that stay geometry against r2; see `LoadCurve.plot`."""
    axes = _axes(ax)
    axes.plot(radii[counts > 0], counts[counts > 0], label="this scene")
    axes.axhline(total, color="0.7", linewidth=0.8, linestyle="--")
    if published:
        label = "Popescu et al. 2022 (3.7 million triangles)"
        axes.plot(*zip(*PUBLISHED, strict=True), linestyle="none", marker="v", color="C1", label=label)
    axes.set(xscale="log", yscale="log", xlabel="$r_2$ in metres", ylabel="triangles left as geometry")
    axes.legend(loc="upper left", fontsize="small")
    _per_cent(axes, total)
    return axes


def _per_cent(axes: Axes, total: int) -> None:
    """Add a right axis that shows the reduction relative to `total` in per cent."""
    lowest = axes.get_ylim()[0]
    fractions = [10.0**-n for n in range(1, 1 + int(np.log10(total / lowest)))]
    right_axis = axes.secondary_yaxis("right")
    # 1 − 10⁻ⁿ has n − 2 decimals in per cent.
    labels = [f"{100.0 * (1.0 - fraction):.{max(n - 2, 0)}f} %" for n, fraction in enumerate(fractions, start=1)]
    right_axis.set_yticks([total, *(total * fraction for fraction in fractions)], ["0 %", *labels], minor=False)
    right_axis.set_yticks([], minor=True)
    right_axis.set_ylabel("reduction")


def score_curves(
    ax: Axes | None,
    sigma: NDArray[np.float64],
    curves: NDArray[np.float64],
    labels: list[str],
    samples: tuple[NDArray[np.float64], NDArray[np.float64]] | None,
) -> Axes:
    """Plot score curves (K, M) over solid angles (M,) in steradians, and samples (D,), (K, D); see `LodModel.plot`."""
    axes = _axes(ax)
    for number, (curve, label) in enumerate(zip(curves, labels, strict=True)):
        axes.plot(sigma, curve, color=f"C{number % 10}", label=label)
        if samples is not None:
            axes.plot(samples[0], samples[1][number], color=f"C{number % 10}", linestyle="none", marker=".")
    axes.set(xscale="log", xlabel="solid angle in steradians", ylabel="SSIM")
    if labels:
        axes.legend(title="triangles")
    return axes


def over_time(ax: Axes | None, times: NDArray[Any], values: NDArray[Any], name: str, *, steps: bool) -> Axes:
    """Plot values over seconds, as steps if `steps`; see `Timeline.plot`."""
    axes = _axes(ax)
    axes.plot(times, values, drawstyle="steps-post" if steps else "default")
    axes.set(xlabel="seconds", ylabel=name)
    return axes


def _axes(ax: Axes | None) -> Axes:
    """Return the caller's axes, or new ones; TypeError for anything else."""
    if ax is not None:
        from matplotlib.axes import Axes

        return check.instance("ax", ax, Axes, "Axes of matplotlib")
    try:
        from matplotlib import pyplot
    except ImportError:
        raise ImportError("plots need matplotlib: pip install matplotlib") from None
    axes: Axes = pyplot.subplots(layout="constrained")[1]
    return axes
