"""The thesis' window of 10 × 10 pixels against Wang's of 11 × 11, used by `measure`: differences of scores.

The same pictures of four objects' levels, from even directions at six
of the 16 distances of `measure`, are scored with three windows. The thesis states the size of its window, but not its
weights: the likely reading is Wang's Gaussian, σ 1.5, cut to 10 × 10; a uniform one is the other extreme. An even
window extends one pixel further up and left.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness.report import start, table
from benchmarks.lod._objects import BY_MESHOPT, sources
from nearfar.lod._measure import statistic
from nearfar.lod._measure.views import Screen, Stand, turns

Array = NDArray[np.float64]

WINDOWS: dict[str, dict[str, Any]] = {
    "Gaussian, 11 × 11": {},
    "Gaussian, 10 × 10": {"size": 10},
    "uniform, 10 × 10": {"window": "uniform", "size": 10},
}
"""Settings of `nf.ssim_pairs` by name, ours first."""

OBJECTS = ("bunny", "armadillo", "FlightHelmet", "knot")
RATIOS = (0.25, 0.06, 0.015)
DISTANCES = (1, 2, 3, 5, 9, 16)
VIEWS, SAMPLES = 24, 4
LUMA = (0.2126, 0.7152, 0.0722)


def pictures(scene: nf.Scene, cameras: Sequence[nf.Camera], samples: int) -> tuple[Array, NDArray[np.bool_]]:
    """Luma (V, H, W) as compared by `measure`, and whether each pixel's centre shows the object."""
    frames = list(nf.render_path(scene, cameras, channels=("color", "range"), samples=samples, backend="cpu"))
    luma = np.stack([frame.to_image() @ np.array(LUMA) for frame in frames])
    return luma, np.stack([np.isfinite(frame.require("range")) for frame in frames])


def scores(levels: nf.lod.Levels, screen: Screen, distances: Sequence[int], views: int, samples: int) -> Array:
    """Score all levels except the base with each window, at each distance from each side: (W, K − 1, D, V)."""
    center = (float(levels.center[0]), float(levels.center[1]), float(levels.center[2]))
    # Coarse levels may extend beyond the base's sphere.
    stand = Stand(screen, center, levels.radius, 1.05 * levels.radius)
    found = np.empty((len(WINDOWS), len(levels) - 1, len(distances), views))
    for size, number in enumerate(distances):
        cameras = [stand.camera(number, one) for one in turns(views, "even")[0]]
        base, shown = pictures(levels[0].scene, cameras, samples)
        for level in range(1, len(levels)):
            other, also_shown = pictures(levels[level].scene, cameras, samples)
            for window, options in enumerate(WINDOWS.values()):
                found[window, level - 1, size] = nf.ssim_pairs(
                    base, other, data_range=255.0, masks=shown | also_shown, **options
                )
    return found


def rows(name: str, found: Array) -> list[list[Any]]:
    """Make a row for each other window: changes of single scores and of the 25th percentiles of the views."""
    listed: list[list[Any]] = []
    for window, other in list(zip(WINDOWS, found, strict=True))[1:]:
        changes = [other - found[0], statistic.of_views(other, 25.0) - statistic.of_views(found[0], 25.0)]
        listed.append([name, window, *(number for one in changes for number in (one.mean(), np.abs(one).max()))])
    return listed


def main() -> None:
    views = start(__doc__, views=VIEWS).views
    every, screen = sources(), Screen.from_arguments(nf.hmd.RIFT_S, None, None)
    listed, parts = [], []
    for name in (name for name in OBJECTS if name in every):
        method = "meshopt" if name in BY_MESHOPT else "fast"
        levels = nf.lod.simplify(every[name](), RATIOS, method=method, normals="smooth", name=name)
        parts.append(scores(levels, screen, DISTANCES, views, SAMPLES))
        listed += rows(name, parts[-1])
    listed += rows("all", np.concatenate(parts, axis=1))
    header = "object | window | mean change of a view's score {:.4f} | greatest {:.4f}"
    header += " | of the 25th percentile: mean {:.4f} | greatest {:.4f}"
    print(table(f"Scores beside those of the Gaussian window of 11 × 11, {views} views", header, listed))


if __name__ == "__main__":
    main()
