"""Figures that the thesis prints of its study, and the same figures of the rows in the data folder."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from benchmarks.lod.user_study import Study, correlation, lilliefors, moments, paired, shapiro, wilcoxon
from nearfar._base import random

SOURCE = "Liebisch: Level of Detail Selection for Foveated Rendering in Virtual Reality, TU Graz 2021"
"""The thesis whose tables are listed here."""

DECIMALS = 4
"""Decimals of d in the data folder."""

DRAWS = 100
_SEED, _LOST = 2021, 5
"""Number of draws of the decimals missing from d, and the seed and stream of their random numbers."""


@dataclass(frozen=True)
class Printed:
    """A figure of the thesis: number of its table, statistic, rows that it describes, and its digits."""

    table: str
    statistic: str
    of: str
    text: str

    @property
    def value(self) -> float:
        return float(self.text)

    @property
    def decimals(self) -> int:
        return len(self.text.partition(".")[2])

    def beside(self, value: float) -> str:
        """Compare a value with it: "same" if it is rounded alike, or the difference."""
        return "same" if round(value, self.decimals) == self.value else f"{value - self.value:+.5f}"


_PARTS = ("d, rift", "d, vive", "k, rift", "k, vive")
_PAIRS = ("d, rift and vive", "k, rift and vive")

PRINTED = tuple(
    Printed(table, statistic, of, text)
    for table, statistic, parts, texts in (
        ("5.4", "D", _PARTS, ".135 .142 .201 .167"),
        ("5.4", "W", _PARTS, ".885 .842 .913 .936"),
        ("5.4", "df", _PARTS, "240 240 240 240"),
        ("5.5", "mean", _PARTS, ".9050 .8971 .2677 .2792"),
        ("5.5", "deviation", _PARTS, ".08365 .0958 .39139 .42130"),
        ("5.5", "G₁", _PARTS, "-1.201 -1.783 .852 .619"),
        ("5.5", "G₂", _PARTS, "1.474 4.384 .597 -.006"),
        ("5.6", "Z", _PAIRS, "-.567 -.341"),
        ("5.6", "p", _PAIRS, ".571 .733"),
        ("5.8", "τ", ("d and k",), "-.164"),
        ("5.8", "ρ", ("d and k",), "-.220"),
    )
    for of, text in zip(parts, texts.split(), strict=True)
)
"""Tables 5.4, 5.5, 5.6 and 5.8 of `SOURCE`."""


def computed(study: Study) -> dict[tuple[str, str], float]:
    """The figures of `PRINTED` by statistic and rows.

    5.4: D of Kolmogorov and Smirnov from the normal with the rows' mean and deviation, W of Shapiro and Wilk, and rows.
    5.5: deviation of n − 1, adjusted skewness and kurtosis. 5.6: signed ranks of rows in pairs of one participant and
    object, equal pairs left out, ties corrected, no correction for continuity. 5.8: τ-b, and ρ of mean ranks, of both
    headsets' rows pooled.
    """
    figures: dict[tuple[str, str], float] = {}
    for column in ("d", "k"):
        for hmd in study.hmds:
            values = getattr(study.select(hmd=hmd), column)
            of, its = f"{column}, {hmd}", moments(values)
            figures |= {("D", of): lilliefors(values)[0], ("W", of): shapiro(values)[0], ("df", of): float(its.n)}
            figures |= {("mean", of): its.mean, ("deviation", of): its.deviation}
            figures |= {("G₁", of): its.adjusted_skewness, ("G₂", of): its.adjusted_kurtosis}
        test, of = wilcoxon(*paired(study, column, "hmd", *study.hmds)), f"{column}, {' and '.join(study.hmds)}"
        figures |= {("Z", of): test.z, ("p", of): test.p}
    pooled = correlation(study.d, study.k)
    return figures | {("τ", "d and k"): pooled.tau, ("ρ", "d and k"): pooled.rho}


def with_decimals(study: Study, draw: int) -> Study:
    """The study with further decimals of d, drawn uniformly from the rounding interval.

    Rows of one object, level and d get the same decimals, because they are one mesh. The SSIM of level 0 is exactly 1.
    """
    kinds = [*zip(study.object.tolist(), study.level.tolist(), study.d.tolist(), strict=True)]
    number = {kind: index for index, kind in enumerate(sorted(set(kinds)))}
    index = np.array([number[kind] for kind in kinds]) + draw * len(number)
    lost = (random.uniform(_SEED, _LOST, index) - 0.5) * 10.0**-DECIMALS
    return replace(study, d=np.where(study.level == 0, study.d, study.d + lost))


def spans(study: Study, draws: int = DRAWS) -> dict[tuple[str, str], tuple[float, float]]:
    """Least and greatest value of each figure over draws of the missing decimals of d."""
    figures_of_draws = [computed(with_decimals(study, draw)) for draw in range(draws)]
    return {
        key: (min(one[key] for one in figures_of_draws), max(one[key] for one in figures_of_draws))
        for key in figures_of_draws[0]
    }
