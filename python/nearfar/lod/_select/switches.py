"""Sizes at which levels take over, for engines that know no SSIM."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields
from typing import SupportsFloat

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import check
from nearfar._camera.camera import Camera, Fov
from nearfar.hmd._hmd import Hmd
from nearfar.lod._levels import level_numbers
from nearfar.lod._measured_levels import MeasuredLevels
from nearfar.lod._select.size import half_tangent, pixel_area, reference_solid_angle
from nearfar.lod._select.threshold import LodThreshold, threshold_of

_SAMPLED_SIZES = 1024
"""Sizes in even and in geometric steps, between which a curve may cross the threshold: as a rule both are monotonic."""

_ROUNDING = 1e-9
"""Greatest relative difference of two computations of one size."""

_HALVINGS = 64
"""Halvings of the interval of a crossing: float64 has 53 binary digits."""


@dataclass(frozen=True, eq=False)
class Switches:
    """Sizes of an object's bounding sphere up to which its K levels are good enough, without a lens.

    All are (K,) float64. Level 0 is for all sizes. A level that is good up to a smaller size than a coarser one is
    never shown.
    """

    solid_angle: NDArray[np.float64]
    """Steradians up to which each level is good enough; 0 for one that never is."""
    distance: NDArray[np.float64]
    """The same as the distance to the sphere's middle over its radius: from there on. ∞ for a level that never is."""
    screen_coverage: NDArray[np.float64]
    """The same as the share of the picture's area that the sphere covers, 0..1: π r²/z² over the picture's area."""
    screen_height: NDArray[np.float64]
    """The same as the sphere's diameter over the picture's height, 0..1."""
    is_limit: NDArray[np.bool_]
    """Whether a level is good enough at all sizes that were measured, so that its own end is not known (K,)."""

    @property
    def shown(self) -> NDArray[np.bool_]:
        """Whether a level is ever shown (K,): it is good enough up to a greater size than all coarser ones."""
        coarser = np.maximum.accumulate(self.solid_angle[::-1])[::-1]
        shown = self.solid_angle > np.append(coarser[1:], 0.0)
        shown[0] = True
        return shown

    def of_levels(self, numbers: ArrayLike) -> Switches:
        """The switches of some of the levels, by their ascending numbers (N,), of which the first is 0."""
        chosen = level_numbers("numbers", numbers, len(self.solid_angle))
        return Switches(**{field.name: getattr(self, field.name)[chosen] for field in fields(self)})

    def coverages(self) -> list[float]:
        """`MSFT_screencoverage`: where each level ends and the next begins; 0 for the last, which has no end."""
        return [*np.maximum.accumulate(self.screen_coverage[:0:-1])[::-1].tolist(), 0.0]

    def __str__(self) -> str:
        """Table of the levels and the sizes up to which each is good enough.

        A switch "beyond what was measured" is the greatest size that was measured; the level's own is not known.
        """
        rows = [f"{'level':>5}  {'up to sr':>10}  {'from radii':>10}  {'area':>8}  {'height':>8}"]
        columns = (self.solid_angle, self.distance, self.screen_coverage, self.screen_height)
        for number, (sigma, distance, area, height) in enumerate(zip(*(c.tolist() for c in columns), strict=True)):
            row = f"{number:>5}  {sigma:>10.4g}  {distance:>10.4g}  {area:>8.2%}  {height:>8.2%}"
            rows.append("  ".join([row, *self.remarks(number)]))
        return "\n".join(rows)

    def remarks(self, level: int) -> list[str]:
        """Notes on a level beside its sizes: "never shown", "beyond what was measured"."""
        number = check.integer("level", level, 0, len(self.solid_angle) - 1)
        never, limit = not self.shown[number], self.is_limit[number]
        return (["beyond what was measured"] if limit else []) + (["never shown"] if never else [])


def switches(
    model: MeasuredLevels,
    *,
    view: Hmd | Camera | Fov,
    k: SupportsFloat | None = None,
    d: SupportsFloat | None = None,
    threshold: LodThreshold | str | None = None,
) -> Switches:
    """Work out the sizes at which the levels of a model take over.

    A level is shown up to the greatest size to which it stays good enough: SSIM at least f(σ), as `select` has it, for
    all smaller sizes too. Above σ₁/₁₆, and above the sizes that were measured, only level 0 is shown. Of the levels
    that are good enough the coarsest is shown. Where a curve falls towards small sizes, `select` still shows its level
    at large ones, which engines with one size for each level can't: there `switches` is the more careful of both.

    Parameters
    ----------
    model
        Levels with their curves.
    view
        The headset, or a camera or its `Fov`: a screen's reference size and area follow from it. Of a headset's views
        the left eye's counts, which the right one's mirrors.
    k, d, threshold
        The threshold, as in `select`.

    Returns
    -------
    Switches
        A model that knows its pixels is read in those of the headset or the camera, as `select` does; a `Fov` has none.
        For a sphere of half angle μ, sin μ = r/z: σ = 2π(1 − cos μ), distance 1/sin μ, coverage
        π sin²μ / ((right − left)(up − down)) in tangents, height 2 sin μ/(up − down). So σ(1 − σ/4π) is the area
        at distance 1 of the disc that engines take a sphere for.

    Raises
    ------
    ValueError, TypeError
        For arguments out of their domains.
    """
    check.instance("model", model, MeasuredLevels, "a LodModel")
    fov = _fov(view)
    reference = reference_solid_angle(view)
    area = _relative_pixel_area(model, view)
    sizes = _good_sizes(model, reference, threshold_of(threshold, k, d).line(reference), area)
    is_limit = (sizes * area >= model.sigma[1] * (1 - _ROUNDING)) & (np.arange(len(model)) > 0)
    sine = np.sqrt(np.where(sizes < 2 * math.pi, sizes / (2 * math.pi) * (2 - sizes / (2 * math.pi)), 1.0))
    width, height = fov.right - fov.left, fov.up - fov.down
    with np.errstate(divide="ignore"):
        distance = 1 / sine
    coverage = np.minimum(1.0, math.pi * sine**2 / (width * height))
    coverage[0] = 1.0
    tall = np.minimum(1.0, 2 * sine / height)
    tall[0] = 1.0
    return Switches(sizes, distance, coverage, tall, is_limit)


def _relative_pixel_area(model: MeasuredLevels, view: Hmd | Camera | Fov) -> float:
    """Area of the model's pixels as a multiple of the view's; 1 where one of them is not known."""
    if model.pixel is None or isinstance(view, Fov):
        return 1.0
    fov, size = (view.left.fov, view.render_size) if isinstance(view, Hmd) else (_fov(view), view.size)
    return model.pixel**2 / pixel_area(fov._sides, size)


def _good_sizes(model: MeasuredLevels, reference: float, line: tuple[float, float], area: float) -> NDArray[np.float64]:
    """Solid angle up to which each level is good enough, steradians; 4π for level 0."""
    sizes = np.full(len(model), 4 * math.pi)
    if len(model) == 1:
        return sizes
    least, most = model.sigma[0], min(model.sigma[1] / area, reference)
    start, slope = line

    def is_good(sigma: NDArray[np.float64]) -> NDArray[np.bool_]:
        """(K − 1, M) for M sizes that all share, or for (K − 1, M)."""
        return np.asarray(model.curves(np.maximum(sigma * area, least)) >= slope * sigma + start)

    even, geometric = np.linspace(0, most, _SAMPLED_SIZES), np.geomspace(most * 1e-6, most, _SAMPLED_SIZES)
    samples = np.unique(np.concatenate([even, geometric, [min(least / area, most)]]))
    good = is_good(samples)
    ends = np.where(good.all(axis=1), len(samples), np.argmin(good, axis=1))
    low = samples[np.maximum(ends - 1, 0)]
    high = samples[np.minimum(ends, len(samples) - 1)]
    for _ in range(_HALVINGS):
        middle = (low + high) / 2
        inside = is_good(middle[:, None])[:, 0]
        low, high = np.where(inside, middle, low), np.where(inside, high, middle)
    sizes[1:] = np.where(ends == 0, 0.0, low)
    return sizes


def _fov(view: Hmd | Camera | Fov) -> Fov:
    half_tangent(view)  # raises for anything but a view
    fov = view.left.fov if isinstance(view, Hmd) else view.fov if isinstance(view, Camera) else view
    assert isinstance(fov, Fov)
    return fov
