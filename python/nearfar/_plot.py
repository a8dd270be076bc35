"""Drawings with matplotlib, which is imported at the first one."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from nearfar._load_curve import LoadCurve

PUBLISHED = ((30.0, 371), (50.0, 1000))
"""Popescu et al. (2022), a Manhattan of 3.7 million triangles: (r2 in metres, triangles); the second is a bound."""

SAMPLES = 512


def load_curve(curve: LoadCurve, ax: Axes | None, *, published: bool) -> Axes:
    """Draw triangles left against r2, both logarithmic; see `LoadCurve.plot`."""
    if curve.triangle_count == curve.moving_count:
        raise ValueError("load curve: expected a scene with standing triangles, got none")
    axes = _pyplot().subplots(layout="constrained")[1] if ax is None else ax
    farthest = _farthest(curve)
    radii = np.geomspace(min(1.0, farthest / 2.0), 1.1 * farthest, SAMPLES)
    counts = np.asarray(curve.count(radii))
    axes.plot(radii[counts > 0], counts[counts > 0], label="this scene")
    axes.axhline(curve.triangle_count, color="0.7", linewidth=0.8, linestyle="--")
    if published:
        label = "Popescu et al. 2022 (3.7 million triangles)"
        axes.plot(*zip(*PUBLISHED, strict=True), linestyle="none", marker="v", color="C1", label=label)
    axes.set(xscale="log", yscale="log", xlabel="$r_2$ in metres", ylabel="triangles left as geometry")
    axes.legend()
    return axes


def _farthest(curve: LoadCurve) -> float:
    """Distance of the farthest triangle; 1 m where all of them lie on the axis."""
    if curve.count(0.0) == curve.triangle_count:
        return 1.0
    return float(curve.radius(curve.triangle_count - 1))


def _pyplot() -> Any:
    try:
        from matplotlib import pyplot
    except ImportError:
        raise ImportError("plots need matplotlib: pip install matplotlib, or nearfar[notebook]") from None
    return pyplot
