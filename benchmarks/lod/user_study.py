"""The published study of levels of detail: its table, a synthetic study of the same shape, and their statistics."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy import stats

from nearfar._base import data, random

FILE = "study/lod_thresholds.csv"
"""Path below the data folder."""

TABULATED = 24
"""Number of participants in the thesis' tables: the first 24 of 25."""

Array = NDArray[np.float64]
_SEED, _RESAMPLE = 2021, 1
"""Seed of the random numbers, and the first stream of the bootstrap."""


@dataclass(frozen=True, eq=False)
class Study:
    """Table by participant, headset and object: the coarsest accepted level, its SSIM d, the slope k."""

    participant: NDArray[np.int64]
    hmd: NDArray[np.str_]
    object: NDArray[np.str_]
    level: NDArray[np.int64]
    d: Array
    k: Array

    def __len__(self) -> int:
        """Number of rows."""
        return len(self.d)

    def where(self, mask: NDArray[np.bool_]) -> Study:
        """Select rows by a mask."""
        return Study(*(getattr(self, field.name)[mask] for field in fields(self)))

    def select(self, *, hmd: str | None = None, object: str | None = None) -> Study:  # noqa: A002
        """Select the rows of a headset, of an object, or of both."""
        every = np.ones(len(self), bool)
        return self.where(
            (every if hmd is None else self.hmd == hmd) & (every if object is None else self.object == object)
        )

    def first(self, participants: int) -> Study:
        """Select the rows of the first participants."""
        return self.where(self.participant < participants)

    @property
    def hmds(self) -> list[str]:
        """Headsets in alphabetical order."""
        return sorted(set(self.hmd.tolist()))

    @property
    def objects(self) -> list[str]:
        """Objects in the order of their first rows, which is that of the study."""
        return list(dict.fromkeys(self.object.tolist()))


def load(path: Path | None = None) -> Study:
    """Read the table; FileNotFoundError without a data folder."""
    table = np.genfromtxt(path or data.require(FILE), delimiter=",", names=True, dtype=None, encoding="utf-8")
    return Study(*(table[field.name] for field in fields(Study)))


def synthetic_study(participants: int = TABULATED, objects: int = 10, *, gap: float = 0.0) -> Study:
    """Make a study with known statistics: levels are uniform from 0 to 10, d is 1 − 0.02 level, k uniform from −¼ to ¾.

    So d has the mean 0.9 and the deviation 0.02 √10, and k the mean 0.25 and the deviation 0.25 √2. `gap` is added to d
    for the headset "vive"; with 0 the headsets do not differ.
    """
    index = np.arange(participants * objects * 2)
    hmd = np.where(index % 2 == 0, "rift", "vive")
    level = random.integers(_SEED, 2, index, 0, 11)
    return Study(
        index // (2 * objects),
        hmd,
        np.array([f"object_{number}" for number in index // 2 % objects]),
        level,
        np.asarray(1 - 0.02 * level + gap * (hmd == "vive"), np.float64),
        np.asarray(0.25 * random.integers(_SEED, 3, index, -1, 4), np.float64),
    )


# contradictory rows ---------------------------------------------------------------------------------------------------
def contradictory_rows(study: Study) -> list[tuple[int, float]]:
    """Find rows whose d differs from that of most rows of their object and level; return numbers and the majority's d.

    A level is one mesh, whose SSIM at 1/16 of the screen is the same for all participants.
    """
    odd = []
    for name in study.objects:
        for level in np.unique(study.level[study.object == name]).tolist():
            rows = np.flatnonzero((study.object == name) & (study.level == level))
            (usual, _), *others = Counter(study.d[rows].tolist()).most_common()
            if others:
                odd += [(int(row), float(usual)) for row in rows if study.d[row] != usual]
    return odd


def repair_rows(study: Study) -> Study:
    """Replace d in contradictory rows by that of the majority."""
    d = study.d.copy()
    for row, usual in contradictory_rows(study):
        d[row] = usual
    return replace(study, d=d)


# statistics -----------------------------------------------------------------------------------------------------------
@dataclass(frozen=True)
class Moments:
    """Mean, deviation (of n − 1), skewness and excess kurtosis: plain (g₁, g₂) and adjusted (G₁, G₂), as in SPSS."""

    n: int
    mean: float
    deviation: float
    skewness: float
    kurtosis: float
    adjusted_skewness: float
    adjusted_kurtosis: float


def moments(values: Array) -> Moments:
    return Moments(
        len(values),
        float(values.mean()),
        float(values.std(ddof=1)),
        *(float(of(values, bias=bias)) for bias in (True, False) for of in (stats.skew, stats.kurtosis)),
    )


def shapiro(values: Array) -> tuple[float, float]:
    """W and p of the Shapiro–Wilk test: a small p means that values are not normal."""
    test = stats.shapiro(values)
    return float(test.statistic), float(test.pvalue)


def lilliefors(values: Array) -> tuple[float, float]:
    """D of Kolmogorov–Smirnov for the normal with the values' own mean and deviation (of n − 1), and its p.

    Lilliefors (1967): p is greater for a given normal than for a fitted one. The formula of Dallal and Wilkinson (1986)
    holds up to 0.1; for greater p this returns 0.1.
    """
    n = len(values)
    distance = float(stats.kstest(values, "norm", args=(values.mean(), values.std(ddof=1))).statistic)
    # For more than 100 values, Dallal and Wilkinson scale D to its value for 100.
    clipped_n, scaled = min(n, 100), distance * max(n / 100, 1.0) ** 0.49
    root = np.sqrt(clipped_n + 2.78019)
    constant = -0.122119 + 0.974598 / np.sqrt(clipped_n) + 1.67997 / clipped_n
    return distance, min(0.1, float(np.exp(-7.01256 * (scaled * root) ** 2 + 2.99587 * scaled * root + constant)))


def paired_values(study: Study, column: str, by: str, one: str, other: str) -> tuple[Array, Array]:
    """Return a column's values for two headsets, or two objects if `by` is "object", in the same order of rows."""
    other_column = "object" if by == "hmd" else "hmd"
    sides = []
    for value in (one, other):
        rows = study.where(getattr(study, by) == value)
        order = np.lexsort((getattr(rows, other_column), rows.participant))
        sides.append((rows.participant[order], getattr(rows, other_column)[order], getattr(rows, column)[order]))
    if not all(np.array_equal(sides[0][n], sides[1][n]) for n in (0, 1)):
        raise ValueError(f"study: expected rows in pairs for {one} and {other}")
    return np.asarray(sides[0][2]), np.asarray(sides[1][2])


def by_participant(study: Study, column: str) -> Array:
    return np.array([getattr(study, column)[study.participant == who].mean() for who in np.unique(study.participant)])


@dataclass(frozen=True)
class Wilcoxon:
    """Signed-rank test: lesser sum of ranks, Z, two-sided p, number of pairs, and number of ignored equal pairs."""

    statistic: float
    z: float
    p: float
    pairs: int
    equal: int


def wilcoxon(one: Array, other: Array) -> Wilcoxon:
    """Compute the test by the normal approximation with ties, without continuity correction, as in SPSS."""
    # Without rounding, equal decimal differences would differ in their last bits and not count as ties.
    differences = np.round(one - other, 9)
    equal = int((differences == 0).sum())
    if equal == len(differences):
        return Wilcoxon(0.0, 0.0, 1.0, len(differences), equal)
    test = stats.wilcoxon(differences, zero_method="wilcox", correction=False, method="asymptotic")
    return Wilcoxon(float(test.statistic), float(test.zstatistic), float(test.pvalue), len(differences), equal)


@dataclass(frozen=True)
class Correlation:
    """Kendall's τ-b and Spearman's ρ with their p."""

    tau: float
    tau_p: float
    rho: float
    rho_p: float


def correlation(one: Array, other: Array) -> Correlation:
    """Correlate two columns; p of τ by the normal approximation, because there are ties."""
    tau, rho = stats.kendalltau(one, other, method="asymptotic"), stats.spearmanr(one, other)
    return Correlation(float(tau.statistic), float(tau.pvalue), float(rho.statistic), float(rho.pvalue))


def texture(study: Study) -> dict[tuple[str, int], float]:
    """Ratio of 1 − SSIM with a texture to that in one colour, of the two objects that have both, by level."""
    factors = {}
    for plain in study.objects:
        name = plain.removesuffix("_plain")
        if name == plain or name not in study.objects:
            continue
        textured, untextured = (study.select(object=which) for which in (name, plain))
        for level in sorted({*textured.level.tolist()} & {*untextured.level.tolist()} - {0}):
            dissimilarities = [1 - np.median(part.d[part.level == level]) for part in (textured, untextured)]
            factors[name, int(level)] = float(dissimilarities[0] / dissimilarities[1])
    return factors


# uncertainty of d and k -----------------------------------------------------------------------------------------------
def bootstrap(study: Study, column: str, *, objects: bool = False, draws: int = 10_000) -> tuple[float, float]:
    """95 % interval of a column's mean, resampling participants with all of their rows, and optionally objects.

    Rows of one participant, and of one object, are similar: resampling single rows would give intervals that are too
    short.
    """
    people, things = np.unique(study.participant), study.objects
    values = np.array(
        [
            [getattr(study, column)[(study.participant == who) & (study.object == name)].mean() for name in things]
            for who in people
        ]
    )
    index = np.arange(draws * len(people)).reshape(draws, -1)
    rows = random.integers(_SEED, _RESAMPLE, index, 0, len(people))
    if objects:
        index = np.arange(draws * len(things)).reshape(draws, -1)
        columns = random.integers(_SEED, _RESAMPLE + 3, index, 0, len(things))
        means = np.array([values[np.ix_(row, column)].mean() for row, column in zip(rows, columns, strict=True)])
    else:
        means = values.mean(axis=1)[rows].mean(axis=1)
    low, high = np.percentile(means, [2.5, 97.5])
    return float(low), float(high)


def readings(study: Study) -> dict[str, tuple[float, float, int]]:
    """d, k and number of rows for other choices of rows and averages; `study` has all participants."""
    first = study.first(TABULATED)
    people = np.unique(first.participant)
    without = [first.where(first.participant != who) for who in people]

    def mean(part: Study) -> tuple[float, float, int]:
        return float(part.d.mean()), float(part.k.mean()), len(part)

    def average(function: Any) -> tuple[float, float, int]:
        return float(function(first.d)), float(function(first.k)), len(first)

    means = {f"the first {len(people)} participants": mean(first), "all participants": mean(study)}
    means |= {f"{hmd} only": mean(first.select(hmd=hmd)) for hmd in first.hmds}
    means["odd rows mended"] = mean(repair_rows(first))
    means["without the one whose d matters most"] = max(map(mean, without), key=lambda it: abs(it[0] - first.d.mean()))
    means["without the one whose k matters most"] = max(map(mean, without), key=lambda it: abs(it[1] - first.k.mean()))
    means["medians"] = average(np.median)
    means["means of the middle 80 %"] = average(lambda values: stats.trim_mean(values, 0.1))
    means["without refusals of any level (level 0)"] = mean(first.where(first.level > 0))
    means["without k below 0"] = mean(first.where(first.k >= 0))
    return means
