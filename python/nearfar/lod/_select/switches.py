"""Sizes at which levels take over, for engines without SSIM curves."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable
from dataclasses import dataclass, fields
from typing import SupportsFloat

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import check
from nearfar._camera.camera import Camera, Fov
from nearfar.hmd._hmd import Hmd
from nearfar.lod._levels import level_numbers
from nearfar.lod._measured_levels import MeasuredLevels
from nearfar.lod._select.size import fov_of, pixel_area, reference_solid_angle, sphere_solid_angle
from nearfar.lod._select.threshold import Kind, LodThreshold, threshold_of

_SAMPLED_SIZES = 1024
"""Number of sizes in linear steps, and in geometric steps, between which threshold crossings are searched."""

_ROUNDING = 1e-9
"""Greatest relative difference between two computations of the same size."""

_HALVINGS = 64
"""Bisection steps for a crossing: float64 has 53 binary digits."""


@dataclass(frozen=True, eq=False)
class Switches:
    """Sizes of an object's bounding sphere up to which its K levels are good enough, without a lens.

    Sizes are (K,) float64. Level 0 is good enough at all sizes. A level that is good enough up to a smaller size than a
    coarser one is never shown.
    """

    solid_angle: NDArray[np.float64]
    """Steradians up to which each level is good enough; 0 for a level that never is."""
    distance: NDArray[np.float64]
    """Least distance to the sphere's centre at which a level is good enough, in radii; ∞ for one that never is."""
    screen_coverage: NDArray[np.float64]
    """Size as the share of the picture's area covered by the sphere, 0..1: π r²/z² over the picture's area."""
    screen_height: NDArray[np.float64]
    """Size as the sphere's diameter over the picture's height, 0..1."""
    is_limit: NDArray[np.bool_]
    """Whether a level is good enough up to the greatest measured size, so that its true limit is unknown (K,)."""
    score: NDArray[np.float64]
    """Score of each level at the greatest measured size (K,), the greatest `quality` with which it is shown up to
    there. NaN without a curve, 1 for level 0."""
    reason: NDArray[np.str_]
    """Reason why a level is never shown (K,), empty for shown ones."""

    @property
    def is_ever_shown(self) -> NDArray[np.bool_]:
        """Whether a level is ever shown (K,): it is good enough up to a greater size than all coarser ones."""
        return np.asarray(self.reason == "")

    def of_levels(self, numbers: ArrayLike) -> Switches:
        """Return the switches of some levels, by ascending numbers (N,) that start with 0."""
        indices = level_numbers("numbers", numbers, len(self.solid_angle))
        return Switches(**{field.name: getattr(self, field.name)[indices] for field in fields(self)})

    def coverages(self) -> list[float]:
        """`MSFT_screencoverage`: coverage at which each level ends and the next begins; 0 for the last level."""
        return [*np.maximum.accumulate(self.screen_coverage[:0:-1])[::-1].tolist(), 0.0]

    def __str__(self) -> str:
        """Table of the levels, the sizes up to which each is good enough, and the scores of all at one large size.

        A switch "beyond what was measured" is at the greatest measured size; the level's true limit is unknown.
        """
        rows = [f"{'level':>5}  {'up to sr':>10}  {'from radii':>10}  {'area':>8}  {'height':>8}  {'quality':>7}"]
        columns = (self.solid_angle, self.distance, self.screen_coverage, self.screen_height, self.score)
        for number, (sigma, distance, area, height, score) in enumerate(
            zip(*(c.tolist() for c in columns), strict=True)
        ):
            row = f"{number:>5}  {sigma:>10.4g}  {distance:>10.4g}  {area:>8.2%}  {height:>8.2%}  {score:>7.3f}"
            rows.append("  ".join([row, *self.remarks(number)]))
        return "\n".join(rows)

    def remarks(self, level: int) -> list[str]:
        """Notes on a level for the table: "never shown" with the reason, "beyond what was measured"."""
        number = check.integer("level", level, 0, len(self.solid_angle) - 1)
        reason = str(self.reason[number])
        limit = ["beyond what was measured"] if self.is_limit[number] else []
        return limit + ([f"never shown: {reason}"] if reason else [])


def switches(
    model: MeasuredLevels,
    *,
    view: Hmd | Camera | Fov,
    k: SupportsFloat | None = None,
    d: SupportsFloat | None = None,
    threshold: LodThreshold | Kind | None = None,
    quality: SupportsFloat | None = None,
    floor: Iterable[SupportsFloat] = (),
) -> Switches:
    """Compute the sizes at which an object switches between the levels of a model.

    At each size the coarsest of the levels that are good enough is shown. A level is good enough up to the greatest
    size to which its SSIM is at least f(σ), as in `select`. Above σ₁/₁₆, and above the measured sizes, only level 0 is
    shown.

    ValueError and TypeError for arguments out of range.

    Parameters
    ----------
    model
        Levels with their curves.
    view
        The headset, or a camera or its `Fov`, which determines the reference size and the picture's area. For a headset
        the left eye's view is used, which the right one mirrors.
    k, d, threshold
        The threshold, as in `select`.
    quality
        Least SSIM at all sizes, 0 to 1, instead of the threshold: a `LodThreshold` of the kind "constant". Levels are
        used up to the greatest measured size, about half of the picture's height. Levels of bumpy objects may never
        reach the threshold there; `Switches.score` is the greatest quality with which they are shown up to there.
    floor
        Heights below which at least level 1, 2, … is shown, whatever its score: shares of the picture's height, above 0
        and at most 1, descending. Engines expect about (0.5, 0.25, 0.1).

    Returns
    -------
    Switches
        If the model has a pixel size, its curves are evaluated for the pixels of the headset or the camera, as in
        `select`; a `Fov` has no pixels. For a sphere of half angle μ, sin μ = r/z: σ = 2π(1 − cos μ), distance 1/sin μ,
        coverage π sin²μ / ((right − left)(up − down)) in tangents, height 2 sin μ/(up − down). σ(1 − σ/4π) is the area
        at distance 1 of the disc by which engines approximate the sphere.
    """
    check.instance("model", model, MeasuredLevels, "a LodModel")
    limit, heights = threshold_of(threshold, k, d, quality), read_floor(floor)
    fov = fov_of(view)
    reference = reference_solid_angle(view)
    area = _relative_pixel_area(model, view)
    line, greatest = limit.line(reference), min(model.sigma[1] / area, limit.limit(reference))
    sizes = _good_sizes(model, greatest, line, area)
    is_limit = (sizes * area >= model.sigma[1] * (1 - _ROUNDING)) & (np.arange(len(model)) > 0)
    width, height = fov.right - fov.left, fov.up - fov.down
    floor_sizes = _floor_sizes(heights, height)[: len(model) - 1]
    floored = slice(1, 1 + len(floor_sizes))
    is_limit[floored] &= sizes[floored] >= floor_sizes
    sizes[floored] = np.maximum(sizes[floored], floor_sizes)
    sine = np.sqrt(np.where(sizes < 2 * math.pi, sizes / (2 * math.pi) * (2 - sizes / (2 * math.pi)), 1.0))
    with np.errstate(divide="ignore"):
        distance = 1 / sine
    coverage = np.minimum(1.0, math.pi * sine**2 / (width * height))
    relative_height = np.minimum(1.0, 2 * sine / height)
    coverage[0] = relative_height[0] = 1.0
    ends = np.array([model.sigma[0], model.sigma[1]]) / area
    scores = np.ones((len(model), 2))
    if len(model) > 1:
        scores[1:] = model.falling_curves(np.maximum(ends * area, model.sigma[0]))
    reasons = np.array(_reasons(sizes, scores[:, 0], line[0] + line[1] * ends[0]))
    return Switches(sizes, distance, coverage, relative_height, is_limit, scores[:, 1], reasons)


def read_floor(floor: Iterable[SupportsFloat]) -> tuple[float, ...]:
    """Return shares of a picture's height; ValueError or TypeError unless they descend from at most 1 to above 0."""
    shares = [
        check.number("floor", share) for share in check.iterable("floor", floor, "shares of the picture's height")
    ]
    if any(not 0 < share <= 1 for share in shares) or any(a <= b for a, b in itertools.pairwise(shares)):
        raise ValueError(f"floor: expected descending numbers above 0 and at most 1, got {check.value_or_type(shares)}")
    return tuple(shares)


def _floor_sizes(shares: tuple[float, ...], height: float) -> NDArray[np.float64]:
    """Return the solid angles in steradians of spheres with these shares of a picture's height."""
    sines = np.minimum(1.0, 0.5 * height * np.array(shares, np.float64))
    return np.array([sphere_solid_angle(sine) for sine in sines.tolist()], np.float64)


def _reasons(sizes: NDArray[np.float64], scores: NDArray[np.float64], needed: float) -> list[str]:
    """Reasons why levels are never shown, from the sizes up to which they are good enough and their greatest scores."""
    reasons = [""]
    for level in range(1, len(sizes)):
        coarser = level + 1 + np.flatnonzero(sizes[level + 1 :] >= sizes[level])
        if sizes[level] == 0 and math.isnan(scores[level]):
            reasons.append("no curve could be fitted to its scores")
        elif sizes[level] == 0:
            reasons.append(f"its score is at most {scores[level]:.3f}, and {needed:.3f} is needed")
        elif len(coarser):
            reasons.append(f"level {coarser[-1]} is good enough up to the same or a greater size")
        else:
            reasons.append("")
    return reasons


def _relative_pixel_area(model: MeasuredLevels, view: Hmd | Camera | Fov) -> float:
    """Area of the model's pixels as a multiple of the view's; 1 if one of them is unknown."""
    if model.pixel is None or isinstance(view, Fov):
        return 1.0
    size = view.render_size if isinstance(view, Hmd) else view.size
    return model.pixel**2 / pixel_area(fov_of(view)._sides, size)


def _good_sizes(model: MeasuredLevels, greatest: float, line: tuple[float, float], area: float) -> NDArray[np.float64]:
    """Solid angle, at most `greatest`, up to which each level is good enough, steradians; 4π for level 0."""
    sizes = np.full(len(model), 4 * math.pi)
    if len(model) == 1:
        return sizes
    least, (start, slope) = model.sigma[0], line

    def is_good(sigma: NDArray[np.float64]) -> NDArray[np.bool_]:
        """Whether levels are good enough (K − 1, M) at sizes (M,) shared by all levels, or at sizes (K − 1, M)."""
        return np.asarray(model.falling_curves(np.maximum(sigma * area, least)) >= slope * sigma + start)

    linear = np.linspace(0, greatest, _SAMPLED_SIZES)
    geometric = np.geomspace(greatest * 1e-6, greatest, _SAMPLED_SIZES)
    samples = np.unique(np.concatenate([linear, geometric, [min(least / area, greatest)]]))
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
