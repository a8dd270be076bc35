"""A factor by material on 1 − SSIM, fitted to scores of levels, and its validity for objects left out of the fit."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy import stats

from benchmarks.lod._material import NEUTRAL, Material

Array = NDArray[np.float64]

MIN, MAX = 0.005, 0.4
"""Least and greatest 1 − SSIM, in the neutral material, of the samples that count. Below it differences are invisible,
and their logarithms are noise. Above it no interpretation of the published threshold accepts the level, and factors
saturate, because the pictures have nothing in common."""

NAMES = (
    "metallic",
    "gloss²",
    "metallic × gloss",
    "metallic × gloss²",
    *(f"contrast{octaves}, {kind}" for kind in ("solid", "mapped") for octaves in ("", " × octaves")),
)
"""Names of `features`. Gloss is 1 − roughness; octaves are log₂(frequency / 4 cycles across the object)."""


MIXED = "finish and pattern"
KINDS: dict[str, Callable[[Material], bool]] = {
    "finish": lambda one: one.contrast == 0,
    "solid pattern": lambda one: one.contrast > 0 and one.dull and not one.mapped,
    "mapped pattern": lambda one: one.contrast > 0 and one.dull and one.mapped,
    MIXED: lambda one: one.contrast > 0 and not one.dull,
}
"""Materials by their difference from the neutral one. Mixed ones are predicted from both parts, and never fitted."""


@dataclass(frozen=True, eq=False)
class Samples:
    """Samples of objects, levels, sizes and materials whose 1 − SSIM in the neutral material is `MIN` to `MAX`."""

    object: NDArray[np.int64]
    material: NDArray[np.int64]
    neutral: Array
    """1 − SSIM in the neutral material."""
    dissimilarity: Array
    """1 − SSIM in the sample's material."""
    objects: tuple[str, ...]
    materials: tuple[Material, ...]

    @property
    def logarithm(self) -> Array:
        """Logarithm of the factor."""
        return np.log(self.dissimilarity / self.neutral)

    def is_kind(self, kind: str) -> NDArray[np.bool_]:
        """Whether each sample is of a kind of `KINDS`."""
        return np.array([KINDS[kind](one) for one in self.materials])[self.material]

    def where(self, mask: NDArray[np.bool_]) -> Samples:
        return replace(
            self, **{name: getattr(self, name)[mask] for name in ("object", "material", "neutral", "dissimilarity")}
        )


def collect(scores: Mapping[str, Array], materials: Sequence[Material]) -> Samples:
    """Collect samples from scores (L, S, M) by object name."""
    neutral = materials.index(NEUTRAL)
    other_materials = [n for n, material in enumerate(materials) if material != NEUTRAL]
    rows = []
    for number, of_object in enumerate(scores.values()):
        dissimilarities = 1 - of_object.reshape(-1, len(materials))
        for row in dissimilarities[
            (dissimilarities[:, neutral] >= MIN)
            & (dissimilarities[:, neutral] <= MAX)
            & (dissimilarities[:, other_materials] > 0).all(axis=1)
        ]:
            rows += [(number, n, row[neutral], row[n]) for n in other_materials]
    if not rows:
        raise ValueError(f"scores: expected some from {1 - MAX} to {1 - MIN} in the neutral material, got none")
    table = np.array(rows)
    numbers = table[:, :2].astype(np.int64)
    return Samples(numbers[:, 0], numbers[:, 1], table[:, 2], table[:, 3], tuple(scores), tuple(materials))


def features(materials: Sequence[Material]) -> Array:
    """Features (M, 8) by `NAMES`, in which the factor's logarithm is linear: all 0 for the neutral material."""
    rows = []
    for one in materials:
        gloss = 1 - one.roughness
        pattern = (one.contrast, one.contrast * np.log2(one.frequency / 4)) if one.contrast else (0.0, 0.0)
        kinds = ((0.0, 0.0), pattern) if one.mapped else (pattern, (0.0, 0.0))
        finish = (one.metallic, gloss**2, one.metallic * gloss, one.metallic * gloss**2)
        rows.append((*finish, *kinds[0], *kinds[1]))
    return np.array(rows)


def fit(samples: Samples) -> Array:
    """Fit coefficients by least squares to samples that are not mixed, with equal weights for all objects."""
    fitted = samples.where(~samples.is_kind(MIXED))
    weight = np.sqrt(1 / np.bincount(fitted.object)[fitted.object])
    rows = features(fitted.materials)[fitted.material]
    return np.asarray(np.linalg.lstsq(rows * weight[:, None], fitted.logarithm * weight, rcond=None)[0])


def factor(coefficients: Array, material: Material) -> float:
    """Ratio of a level's 1 − SSIM in a material to that in the neutral material."""
    return float(np.exp(features([material]) @ coefficients)[0])


def intervals(samples: Samples) -> tuple[Array, Array, Array]:
    """Coefficients and the ends of their 95 % intervals, by leaving out each object in turn.

    Samples of one object are similar, so that only objects count as independent.
    """
    count = len(samples.objects)
    coefficients = fit(samples)
    without = np.array([fit(samples.where(samples.object != number)) for number in range(count)])
    error = np.sqrt((count - 1) / count * ((without - without.mean(axis=0)) ** 2).sum(axis=0))
    half_width = stats.t.ppf(0.975, count - 1) * error
    return coefficients, coefficients - half_width, coefficients + half_width


# validity for other objects -------------------------------------------------------------------------------------------
@dataclass(frozen=True)
class Validity:
    """Errors of predictions for an object that was left out of the fit."""

    log: float
    """Root mean square of the logarithm's error."""
    ssim: float
    """Root mean square of SSIM's error."""
    explained: float
    """Share of the squared logarithms explained by predictions: 0 without a correction, below 0 if worse."""


def by_coefficients(train: Samples, test: Samples) -> Array:
    return np.asarray(features(test.materials)[test.material] @ fit(train))


def by_material(train: Samples, test: Samples) -> Array:
    """Predict logarithms by one number for each material, the best that any formula of the material can do.

    A mixed material gets the sum of the numbers of its finish and of its pattern.
    """
    means = {NEUTRAL: 0.0}
    for number, material in enumerate(train.materials):
        rows = train.material == number
        if rows.any():
            counts = np.bincount(train.object[rows], minlength=len(train.objects))
            weight = 1 / counts[train.object[rows]]
            means[material] = float(np.average(train.logarithm[rows], weights=weight))
    numbers = []
    for material in test.materials:
        finish = Material(material.metallic, material.roughness)
        numbers.append(means.get(finish, np.nan) + means.get(replace(material, metallic=0.0, roughness=1.0), np.nan))
    return np.array(numbers)[test.material]


MODELS: dict[str, Callable[[Samples, Samples], Array]] = {
    "no correction": lambda _, test: np.zeros(len(test.dissimilarity)),
    "coefficients": by_coefficients,
    "a number for each material": by_material,
}
"""Functions that predict the logarithms of samples from a fit to other samples."""


def cross_validate(samples: Samples, name: str) -> Array:
    """Predict the logarithm of each sample by the fit to all other objects."""
    predicted = np.empty(len(samples.dissimilarity))
    for number in range(len(samples.objects)):
        inside = samples.object == number
        predicted[inside] = MODELS[name](samples.where(~inside), samples.where(inside))
    return predicted


def validity(samples: Samples, predicted: Array) -> Validity:
    error = samples.logarithm - predicted
    # 1 − SSIM is at most 1, for pictures that have nothing in common.
    ssim = samples.dissimilarity - np.minimum(samples.neutral * np.exp(predicted), 1.0)
    explained = 1 - float((error**2).sum() / (samples.logarithm**2).sum())
    return Validity(float(np.sqrt((error**2).mean())), float(np.sqrt((ssim**2).mean())), explained)
