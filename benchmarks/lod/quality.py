"""Whether chosen levels look as good as was asked for, behind the lens, and how many triangles other rules need for it.

python -m benchmarks.lod.quality [--quick]
"""

from __future__ import annotations

import argparse
import functools
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness.timing import machine, table
from benchmarks.lod._objects import RIFT_S, VIVE_PRO, Crowd, Headset, crowd, measured

LUMA = np.array([0.2126, 0.7152, 0.0722])
"""Rec. 709 weights of red, green and blue."""
LEAST_PIXELS = 16
"""Pixels of an object below which it is not scored: a mean over fewer pixels than two rows of a window is noise."""
PERCENTILES = (25.0, 5.0)
"""Percentiles of the views that a curve goes through: as published, and a more careful one."""

PIXELS = (0.5, 1.0, 2.0, 4.0, 8.0, 16.0)
"""Screen-space error that tile viewers allow, pixels; 16 is the default of most."""

Levels = NDArray[np.int32]
Rule = Callable[["Case", nf.Camera], Levels]

SCENES = [(size, (100, 500, 1000)) for size in (10, 15, 20, 30)]
"""Radius of the ball in metres, and numbers of objects."""
VIEWS = 2
"""Directions of the camera in a scene."""
MODES = ("depth", "depth+eccentricity")


@dataclass(frozen=True)
class Case:
    """A scene, a headset, and the views that are compared."""

    models: list[nf.lod.LodModel]
    crowd: Crowd
    headset: Headset
    cameras: list[nf.Camera]

    @classmethod
    def of(cls, models: list[nf.lod.LodModel], headset: Headset, size: int, count: int) -> Case:
        """As in the thesis, seen from the middle."""
        cameras = [headset.camera(2 * np.pi * n / VIEWS) for n in range(VIEWS)]
        return cls(models, crowd(models, size=size, count=count, seed=size * count), headset, cameras)

    @functools.cached_property
    def scene(self) -> nf.Scene:
        """With all levels."""
        return nf.lod.place(self.models, self.crowd.model_index, self.crowd.transforms)

    @functools.cached_property
    def truths(self) -> list[View]:
        """Pictures at full detail."""
        return [View.of(self, camera, self.in_full(camera)) for camera in self.cameras]

    @functools.cached_property
    def scores(self) -> list[NDArray[np.float64]]:
        """Score of each object at each level, for each view (K, N): all objects are drawn at that level at once."""
        most, last = max(map(len, self.models)), np.array([len(model) - 1 for model in self.models])
        of_views = []
        for camera, truth in zip(self.cameras, self.truths, strict=True):
            full, rows = self.in_full(camera), [np.ones(len(self.crowd.radii))]
            for level in range(1, most):
                levels = np.where(full < 0, full, np.minimum(level, last[self.crowd.model_index])).astype(np.int32)
                rows.append(scores(truth, View.of(self, camera, levels), len(levels)))
            rows[0] = np.where(np.isfinite(rows[1]), rows[0], np.nan)
            of_views.append(np.array(rows))
        return of_views

    @property
    def spheres(self) -> tuple[list[nf.lod.LodModel], NDArray[np.int64], NDArray[np.float64], NDArray[np.float64]]:
        """Arguments of `select`."""
        return self.models, self.crowd.model_index, self.crowd.centers, self.crowd.radii

    def by_ours(self, camera: nf.Camera, d: float) -> Levels:
        """By our rule for a least score at the largest size that was measured."""
        greatest = self.models[0].sigma[1]
        return nf.lod.select(*self.spheres, camera=camera, lens=self.headset.lens, d=d, reference=greatest).level

    def in_full(self, camera: nf.Camera) -> Levels:
        """Level 0 of all that is in view."""
        return np.minimum(self.by_ours(camera, 0.0), 0)

    def by_screen_error(self, camera: nf.Camera, pixels: float) -> Levels:
        """The coarsest level whose geometric error, at the sphere's nearest point, covers no more than some pixels."""
        full = self.in_full(camera)
        distance = np.linalg.norm(self.crowd.centers - camera.position, axis=1) - self.crowd.radii
        scale = self.headset.size[1] / (self.headset.fov.up - self.headset.fov.down) / np.maximum(distance, 1e-6)
        levels = np.zeros_like(full)
        for number, model in enumerate(self.models):
            mine = self.crowd.model_index == number
            errors = np.asarray(model.errors)[:, None] * (self.crowd.radii[mine] / model.radius * scale[mine])
            levels[mine] = len(model) - 1 - np.argmax((errors <= pixels)[::-1], axis=0)
        return np.where(full < 0, full, levels).astype(np.int32)

    def triangles(self, levels: Levels) -> int:
        """Triangles in view."""
        return sum(
            int(self.models[m].triangles[n]) for m, n in zip(self.crowd.model_index, levels, strict=True) if n >= 0
        )


@dataclass(frozen=True)
class View:
    """Picture on the panel of a headset."""

    luma: NDArray[np.float64]
    """8-bit steps."""
    objects: NDArray[np.int32]

    @staticmethod
    def of(case: Case, camera: nf.Camera, levels: Levels) -> View:
        """Draw and warp a view, so that the lens puts it right."""
        frame = nf.render(case.scene, camera, lod=levels, samples=4, channels=("color", "object_id"))
        luma, numbers = frame.to_image()[..., :3] @ LUMA, np.asarray(frame.object_id)
        warp = functools.partial(case.headset.lens.warp, inverse=True, fov=case.headset.fov)
        height, width = luma.shape
        rows, columns = np.mgrid[:height, :width].astype(np.float64)
        places = warp(np.stack([rows, columns], axis=-1), fill=-1.0)
        inside = np.all(places >= 0, axis=-1)
        at = np.rint(np.where(inside[..., None], places, 0)).astype(np.int64)
        objects = np.where(inside, numbers[at[..., 0], at[..., 1]], -1)
        return View(np.where(inside, warp(luma), 0.0), objects.astype(np.int32))


def scores(truth: View, test: View, count: int) -> NDArray[np.float64]:
    """Masked SSIM of each object (N,): over all pixels that show it in either view; NaN for few."""
    _, local = nf.ssim(truth.luma, test.luma, data_range=255, full=True)
    sums, pixels = np.zeros(count), np.zeros(count)
    either = [
        (truth.objects, truth.objects >= 0),
        (test.objects, (test.objects >= 0) & (test.objects != truth.objects)),
    ]
    for objects, chosen in either:
        sums += np.bincount(objects[chosen], local[chosen], minlength=count)
        pixels += np.bincount(objects[chosen], minlength=count)
    means: NDArray[np.float64] = np.divide(sums, pixels, out=np.full(count, np.nan), where=pixels >= LEAST_PIXELS)
    return means


@dataclass(frozen=True)
class Outcome:
    """Triangles and scores of a rule in all views of some cases."""

    triangles: int
    """Of all views."""
    scores: NDArray[np.float64]
    """Of all objects in all views that show enough of them."""

    @staticmethod
    def of(cases: list[Case], rule: Rule) -> Outcome:
        """Look up the score of each object at the level that a rule gives it."""
        drawn, parts = 0, []
        for case in cases:
            for camera, of_levels in zip(case.cameras, case.scores, strict=True):
                levels = rule(case, camera)
                drawn += case.triangles(levels)
                parts.append(of_levels[np.maximum(levels, 0), np.arange(len(levels))][levels >= 0])
        every = np.concatenate(parts)
        return Outcome(drawn, every[np.isfinite(every)])


STATISTICS: dict[str, Callable[[NDArray[np.float64]], float]] = {
    "mean": lambda scores: float(scores.mean()),
    "5th percentile": lambda scores: float(np.percentile(scores, 5)),
}


def kept_promises(case: Case, mode: str) -> tuple[int, int, int]:
    """Objects that look at least as good as their threshold, objects that were scored, and triangles."""
    good = count = drawn = 0
    how = nf.lod.Selector(lens=case.headset.lens, mode=mode)
    for camera, truth in zip(case.cameras, case.truths, strict=True):
        chosen = how.select(*case.spheres, camera=camera, full=True)
        reached = scores(truth, View.of(case, camera, chosen.level), len(chosen))
        # Level 0 is as good as full detail by definition, where no threshold was asked.
        scored = np.isfinite(reached) & (chosen >= 0)
        good += int((reached[scored] >= np.nan_to_num(chosen.threshold[scored])).sum())
        count += int(scored.sum())
        drawn += case.triangles(chosen.level)
    return good, count, drawn


def promises(headset: Headset, *, quick: bool) -> str:
    """How many objects look as good as was asked for, for curves through two percentiles of the views."""
    rows = []
    for percentile in PERCENTILES:
        models = measured(headset, percentile=percentile)
        every = []
        for size, counts in [(10, (100,))] if quick else SCENES:
            counted = np.array(
                [[kept_promises(Case.of(models, headset, size, n), mode) for mode in MODES] for n in counts]
            )
            every.append(counted.sum(axis=0))
            rows.append([f"{percentile:g}", f"{size} m", *columns(every[-1])])
        rows.append([f"{percentile:g}", "all", *columns(np.sum(every, axis=0))])
    title = f"{headset.name}: objects in view, and per cent at least as good as their threshold behind the lens"
    titles = [f"{mode}{unit}" for mode in MODES for unit in (" %", " triangles")]
    return table(title, ["percentile", "ball", "objects", *titles], rows)


def columns(counted: NDArray[np.int64]) -> list[str]:
    """Counts of `kept_promises` in each mode (M, 3) as cells."""
    shares = [(f"{100 * good / count:.1f}", f"{drawn:,}") for good, count, drawn in counted]
    return [f"{counted[0, 1]:,}", *(column for pair in shares for column in pair)]


def rules(headset: Headset, *, quick: bool) -> str:
    """Triangles of other rules: both choose from all levels, and ours has curves from a quarter of the screen on."""
    models = measured(headset, step=None, wider=2)
    chosen = [(10, 100)] if quick else [(10, 100), (15, 500), (20, 500), (30, 1000)]
    cases = [Case.of(models, headset, size, count) for size, count in chosen]
    ours = [
        (d, Outcome.of(cases, functools.partial(Case.by_ours, d=d)))
        for d in np.arange(0.0, 1.4, 0.1 if quick else 0.01).tolist()
    ]
    rows = []
    for pixels in PIXELS[1::2] if quick else PIXELS:
        rule = Outcome.of(cases, functools.partial(Case.by_screen_error, pixels=pixels))
        row = [f"{pixels:g}", f"{rule.triangles:,}"]
        for statistic in STATISTICS.values():
            wanted = statistic(rule.scores)
            d, least = next((d, outcome) for d, outcome in ours if statistic(outcome.scores) >= wanted)
            fewer = 100 * (1 - least.triangles / rule.triangles)
            row += [f"{wanted:.3f}", f"{d:.2f}", f"{least.triangles:,}", f"{fewer:.0f}"]
        rows.append(row)
    title = f"{headset.name}: triangles at equal SSIM, beside rules of so many pixels of screen-space error"
    titles = [f"{label} {column}" for label in STATISTICS for column in ("SSIM", "our d", "ours", "fewer %")]
    return table(title, ["pixels", "triangles", *titles], rows)


def main() -> None:
    """Print the tables."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="the smallest scene and one headset")
    options = parser.parse_args()
    print(machine())
    for headset in (RIFT_S,) if options.quick else (RIFT_S, VIVE_PRO):
        print(promises(headset, quick=options.quick), flush=True)
    print(rules(RIFT_S, quick=options.quick), flush=True)


if __name__ == "__main__":
    main()
