"""Whether chosen levels look as good as requested, behind the lens, wherever an object is seen."""

from __future__ import annotations

import bisect
import functools
import itertools
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness.report import start, table
from benchmarks.lod._objects import RIFT_S, VIEWS, VIVE_PRO, Headset, measure_objects
from benchmarks.lod._views import Case
from nearfar._camera.rotation import rotation
from nearfar.lod._select.rules import Mode

PUBLISHED = 25
"""Percentile of the views for the published curves."""
KEPT = 95.0
"""Percentage of objects that should look at least as good as their threshold."""
BANDS = (0.0, 15.0, 30.0, 90.0)
"""Bands of the angle in degrees between the axis and an object's centre, counted separately."""
SCENES = [(size, 1000) for size in (10, 15, 20, 30)]
"""Radius of the ball in metres, and number of objects."""
TURNS = 12
"""Number of camera directions in each scene: an object on the axis in one is at the edge in another."""
HALVES = 200
"""Number of random halves of the objects for a standard error."""
ALL_VIEWS = 144
"""Number of sides from which objects are measured, for fine steps of percentiles."""
MODES: tuple[Mode, ...] = ("depth", "depth+eccentricity", "panel")


@dataclass(frozen=True)
class Appearances:
    """Appearances of scored objects (S,), and whether each looks at least as good as its threshold."""

    is_good: NDArray[np.bool_]
    degrees: NDArray[np.float64]
    """Angle from the axis to the centre, degrees."""
    objects: NDArray[np.int64]
    """A number for each object of each scene."""
    triangles: int
    """Number of triangles of all views."""

    @property
    def percent_good(self) -> float:
        """Percentage of all appearances that are good enough."""
        return 100 * float(self.is_good.mean())

    @functools.cached_property
    def in_bands(self) -> list[NDArray[np.bool_]]:
        """Masks (S,) of the appearances in each of `BANDS`, only of objects that appear in all of them."""
        band = np.digitize(self.degrees, BANDS[1:-1])
        objects_of_band = [self.objects[band == number] for number in range(len(BANDS) - 1)]
        everywhere = np.isin(self.objects, functools.reduce(np.intersect1d, objects_of_band))
        return [everywhere & (band == number) for number in range(len(BANDS) - 1)]

    @property
    def by_band(self) -> list[float]:
        """Percentage in each of `BANDS` that is good enough."""
        return [100 * float(self.is_good[band].mean()) for band in self.in_bands]

    @property
    def error(self) -> float:
        """Standard error, in percentage points, of the differences between bands, from random halves of the objects."""
        names = np.unique(self.objects[self.in_bands[0]])
        random, spreads = np.random.default_rng(0), []
        for _ in range(HALVES):
            is_drawn = np.isin(self.objects, random.permutation(names)[: len(names) // 2])
            shares = np.array([100 * self.is_good[band & is_drawn].mean() for band in self.in_bands])
            spreads.append(shares - np.roll(shares, 1))
        # The deviation of random halves from the whole equals the standard error of the whole.
        return float(np.std(spreads, axis=0).max())


def appearances(cases: Sequence[Case], models: Sequence[nf.lod.LodModel], mode: Mode) -> Appearances:
    """Choose levels by the curves of models, and score the objects in the pictures with these levels."""
    is_kept, degrees, objects, drawn = [], [], [], 0
    for place, case in enumerate(cases):
        selector = nf.lod.Selector(lens=case.headset.lens, mode=mode)
        for number, camera in enumerate(case.cameras):
            camera_of_mode = case.with_pixels_of(camera, mode)
            selection = selector.select(models, *case.index_and_spheres, camera=camera_of_mode, full=True)
            object_scores = case.scores(number, selection.level)
            is_scored = np.isfinite(object_scores) & (selection.level >= 0)
            # Objects limited to level 0 have no known threshold.
            is_kept.append(
                (object_scores[is_scored] >= selection.threshold[is_scored]) | (selection.level[is_scored] == 0)
            )
            directions = case.crowd.centers[is_scored] - camera.position
            ahead = -directions @ rotation(camera.orientation)[:, 2] / np.linalg.norm(directions, axis=1)
            degrees.append(np.degrees(np.arccos(np.clip(ahead, -1, 1))))
            objects.append(place * len(is_scored) + np.flatnonzero(is_scored))
            drawn += case.triangles(selection.level)
    return Appearances(np.concatenate(is_kept), np.concatenate(degrees), np.concatenate(objects), drawn)


def report(headset: Headset, *, quick: bool) -> str:
    """Table of each mode, with curves of the published percentile and of the greatest percentile that keeps `KEPT`."""
    models = measure_objects(headset, views=VIEWS if quick else ALL_VIEWS)
    scenes, turns = (SCENES[:1], 4) if quick else (SCENES, TURNS)
    cases = [Case.in_sphere(models, headset, *scene, turns=turns) for scene in scenes]
    rows = []
    for mode in MODES:
        trial = functools.cache(lambda each, mode=mode: appearances(cases, [one.refit(each) for one in models], mode))
        first_failing = bisect.bisect_left(range(PUBLISHED), True, key=lambda each: trial(each).percent_good < KEPT)
        enough = f"{mode}, {KEPT:g} % kept" if first_failing else f"{mode}, least"
        for label, percentile in ((mode, PUBLISHED), (enough, max(first_failing - 1, 0))):
            result, shares = trial(percentile), trial(percentile).by_band
            spread = max(shares) - min(shares), result.error
            rows.append([label, percentile, result.percent_good, *shares, spread, result.triangles])
    first = trial(PUBLISHED)
    bands = [f"{start:g} to {end:g}° {{:.1f}}" for start, end in itertools.pairwise(BANDS)]
    everywhere = len(np.unique(first.objects[first.in_bands[0]]))
    title = (
        f"{headset.name}: per cent of {len(first.is_good):,} appearances that are at least as good as their threshold"
    )
    header = ["mode", "percentile", "all {:.1f}", *bands, "spread {:.1f} ± {:.1f}", "triangles {:,}"]
    return table(f"{title} behind the lens, by angle for {everywhere:,} objects", header, rows)


def main() -> None:
    options = start(__doc__, "--quick")
    for headset in (RIFT_S,) if options.quick else (RIFT_S, VIVE_PRO):
        print(report(headset, quick=options.quick), flush=True)


if __name__ == "__main__":
    main()
