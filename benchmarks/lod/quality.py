"""Whether chosen levels look as good as was asked for, behind the lens, wherever an object is seen.

python -m benchmarks.lod.quality [--quick]
"""

from __future__ import annotations

import argparse
import itertools
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness.timing import machine, table
from benchmarks.lod._objects import RIFT_S, VIVE_PRO, Headset, measured
from benchmarks.lod._views import Case
from nearfar._camera.rotation import rotation

PERCENTILES = (50.0, 40.0, 30.0, 25.0, 20.0, 15.0, 10.0, 5.0, 2.0, 0.0)
"""Percentiles of the views that curves go through; 25 as published."""
PUBLISHED = 25.0
KEPT = 95.0
"""Per cent of objects that are to look at least as good as their threshold."""
BANDS = (0.0, 15.0, 30.0, 90.0)
"""Degrees from the axis to an object's centre, between which objects are counted apart."""
SCENES = [(size, count) for size in (10, 15, 20, 30) for count in (100, 500, 1000)]
"""Radius of the ball in metres, and number of objects."""
MODES = ("depth", "depth+eccentricity", "panel")


@dataclass(frozen=True)
class Promises:
    """Objects that were scored, and whether each looks at least as good as its threshold."""

    is_kept: NDArray[np.bool_]
    degrees: NDArray[np.float64]
    """From the axis to the centre."""
    triangles: int
    """Of all views."""

    @property
    def kept(self) -> float:
        """Per cent of all."""
        return 100 * float(self.is_kept.mean())

    @property
    def by_band(self) -> list[float]:
        """Per cent of those between `BANDS`."""
        band = np.digitize(self.degrees, BANDS[1:-1])
        return [100 * float(self.is_kept[band == number].mean()) for number in range(len(BANDS) - 1)]


def promises(cases: Sequence[Case], models: Sequence[nf.lod.LodModel], mode: str) -> Promises:
    """Choose levels by some models' curves, and look up the scores of the objects at these levels."""
    kept, degrees, drawn = [], [], 0
    for case in cases:
        how = nf.lod.Selector(lens=case.headset.lens, mode=mode)
        for camera, of_levels in zip(case.cameras, case.scores, strict=True):
            chosen = how.select(models, *case.spheres[1:], camera=camera, full=True)
            reached = of_levels[np.maximum(chosen.level, 0), np.arange(len(chosen))]
            scored = np.isfinite(reached) & (chosen.level >= 0)
            kept.append(reached[scored] >= chosen.threshold[scored])
            way = case.crowd.centers[scored] - camera.position
            ahead = -way @ rotation(camera.orientation)[:, 2] / np.linalg.norm(way, axis=1)
            degrees.append(np.degrees(np.arccos(np.clip(ahead, -1, 1))))
            drawn += case.triangles(chosen.level)
    return Promises(np.concatenate(kept), np.concatenate(degrees), drawn)


def row(label: str, found: Promises, percentile: float) -> list[str]:
    """Cells of a table."""
    shares = found.by_band
    spread = f"{max(shares) - min(shares):.1f}"
    return [
        label,
        f"{percentile:g}",
        f"{found.kept:.1f}",
        *(f"{x:.1f}" for x in shares),
        spread,
        f"{found.triangles:,}",
    ]


def report(headset: Headset, *, quick: bool) -> str:
    """Each mode with curves through the published percentile, and with the greatest one that keeps enough."""
    models = measured(headset)
    cases = [Case.of(models, headset, *scene) for scene in (SCENES[:1] if quick else SCENES)]
    rows = []
    for mode in MODES:
        found = {each: promises(cases, [model.refit(each) for model in models], mode) for each in PERCENTILES}
        rows.append(row(mode, found[PUBLISHED], PUBLISHED))
        enough = [each for each in PERCENTILES if found[each].kept >= KEPT]
        if enough:
            rows.append(row(f"{mode}, {KEPT:g} % kept", found[enough[0]], enough[0]))
    count = len(found[PUBLISHED].is_kept)
    bands = [f"{start:g} to {end:g}°" for start, end in itertools.pairwise(BANDS)]
    title = f"{headset.name}: per cent of {count:,} objects at least as good as their threshold behind the lens"
    return table(title, ["mode", "percentile", "all", *bands, "spread", "triangles"], rows)


def main() -> None:
    """Print the tables."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="the smallest scene and one headset")
    options = parser.parse_args()
    print(machine())
    for headset in (RIFT_S,) if options.quick else (RIFT_S, VIVE_PRO):
        print(report(headset, quick=options.quick), flush=True)


if __name__ == "__main__":
    main()
