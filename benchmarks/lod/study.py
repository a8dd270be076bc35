"""Statistics of the published study of levels of detail, compared with the figures printed in the thesis."""

from __future__ import annotations

from dataclasses import astuple, dataclass, replace

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness.report import table
from benchmarks.lod import user_study as statistics
from benchmarks.lod.user_study import FILE, TABULATED, Study, Wilcoxon
from nearfar._base import data, random

COLUMNS = ("d", "k")

SOURCE = "Liebisch: Level of Detail Selection for Foveated Rendering in Virtual Reality, TU Graz 2021"
"""The thesis whose tables are listed here."""

DECIMALS = 4
"""Number of decimals of d in the data folder."""

DRAWS = 100
"""Number of draws of the decimals missing from d."""
_SEED, _STREAM = 2021, 5


@dataclass(frozen=True)
class Printed:
    """A figure printed in the thesis: its table's number, the statistic, the rows of the study, and the digits."""

    table: str
    statistic: str
    of: str
    text: str

    @property
    def value(self) -> float:
        """The figure as a number."""
        return float(self.text)

    @property
    def decimals(self) -> int:
        """Number of printed decimals."""
        return len(self.text.partition(".")[2])

    def compare_with(self, value: float) -> str:
        """Compare a value with the figure: "same" if it rounds to the figure, otherwise the difference."""
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


def figures_of(study: Study) -> dict[tuple[str, str], float]:
    """The figures of `PRINTED` by statistic and rows.

    Table 5.4: Kolmogorov–Smirnov's D against a normal distribution with the rows' mean and deviation, Shapiro–Wilk's W,
    number of rows. 5.5: standard deviation (n − 1), adjusted skewness and kurtosis. 5.6: Wilcoxon's signed ranks of
    both headsets' rows, paired by participant and object, without equal pairs, corrected for ties but not for
    continuity. 5.8: Kendall's τ-b and Spearman's ρ of both headsets' rows together.
    """
    figures: dict[tuple[str, str], float] = {}
    for column in ("d", "k"):
        for hmd in study.hmds:
            values = getattr(study.select(hmd=hmd), column)
            of, moment = f"{column}, {hmd}", statistics.moments(values)
            figures |= {
                ("D", of): statistics.lilliefors(values)[0],
                ("W", of): statistics.shapiro(values)[0],
                ("df", of): float(moment.n),
            }
            figures |= {("mean", of): moment.mean, ("deviation", of): moment.deviation}
            figures |= {("G₁", of): moment.adjusted_skewness, ("G₂", of): moment.adjusted_kurtosis}
        test = statistics.wilcoxon(*statistics.paired_values(study, column, "hmd", *study.hmds))
        of = f"{column}, {' and '.join(study.hmds)}"
        figures |= {("Z", of): test.z, ("p", of): test.p}
    pooled = statistics.correlation(study.d, study.k)
    return figures | {("τ", "d and k"): pooled.tau, ("ρ", "d and k"): pooled.rho}


def with_decimals(study: Study, draw: int) -> Study:
    """Return the study with random further decimals of d, uniform in the rounding interval.

    Rows of one object, level and d get the same decimals, because they show one mesh. The SSIM of level 0 is exactly 1.
    """
    kinds = [*zip(study.object.tolist(), study.level.tolist(), study.d.tolist(), strict=True)]
    number = {kind: index for index, kind in enumerate(sorted(set(kinds)))}
    index = np.array([number[kind] for kind in kinds]) + draw * len(number)
    missing = (random.uniform(_SEED, _STREAM, index) - 0.5) * 10.0**-DECIMALS
    return replace(study, d=np.where(study.level == 0, study.d, study.d + missing))


def spans(study: Study, draws: int = DRAWS) -> dict[tuple[str, str], tuple[float, float]]:
    """Least and greatest value of each figure over draws of the missing decimals of d."""
    figures_of_draws = [figures_of(with_decimals(study, draw)) for draw in range(draws)]
    return {
        key: (min(one[key] for one in figures_of_draws), max(one[key] for one in figures_of_draws))
        for key in figures_of_draws[0]
    }


def study_or_twin() -> tuple[Study, str]:
    """Return the published study, or the synthetic one without a data folder, and a line that states which."""
    if data.find(FILE):
        study = statistics.load()
        return study, f"published: {len(study)} rows of {len(np.unique(study.participant))} participants"
    study = statistics.synthetic_study(TABULATED + 1)
    return study, "made up, of the same shape, because there is no data folder"


def table_beside_thesis(study: Study) -> str:
    """Table of the figures printed in tables 5.4, 5.5, 5.6 and 5.8, beside those of a study."""
    ours, ranges = figures_of(study), spans(study)
    rows = []
    for printed in PRINTED:
        key = printed.statistic, printed.of
        low, high = ranges[key]
        our_text = f"{ours[key]:.5f}" if printed.decimals else f"{ours[key]:.0f}"
        first = [
            printed.table,
            f"{printed.statistic} of {printed.of}",
            printed.text,
            our_text,
            printed.compare_with(ours[key]),
        ]
        rows.append([*first, (low, high) if low < high else None])
    header = "table |  | printed | ours | difference | range that the rounding of d allows {:.5f} to {:.5f}"
    return table(f"Beside the printed values ({SOURCE})", header, rows)


def table_of_moments(study: Study) -> str:
    """Table 5.5, and the same by object."""
    rows = []
    for column in COLUMNS:
        parts = {"both": study} | {hmd: study.select(hmd=hmd) for hmd in study.hmds}
        parts |= {f"{name}, {hmd}": study.select(hmd=hmd, object=name) for name in study.objects for hmd in study.hmds}
        rows += [
            [f"{column}, {label}", *astuple(statistics.moments(getattr(part, column)))] for label, part in parts.items()
        ]
    names = ("mean", "deviation", "skewness", "kurtosis", "G₁", "G₂")
    header = ["", "n", *(f"{name} {{:.4f}}" for name in names)]
    return table("Moments of d and k (Table 5.5); kurtosis is excess, 0 for the normal", header, rows)


def table_of_normality(study: Study) -> str:
    rows = []
    for column in COLUMNS:
        for hmd in study.hmds:
            part = study.select(hmd=hmd)
            rows.append([f"{column}, {hmd}, rows", *_normal(getattr(part, column))])
            rows.append([f"{column}, {hmd}, means of participants", *_normal(statistics.by_participant(part, column))])
        one, other = statistics.paired_values(study, column, "hmd", *study.hmds)
        rows.append([f"{column}, {' − '.join(study.hmds)}", *_normal(one - other)])
    title = "Normality, Kolmogorov and Smirnov after Lilliefors (p above 0.1 is given as 0.1), Shapiro and Wilk (5.4)"
    return table(title, ["", "n", "D", "p", "W", "p"], rows)


def table_of_headsets(study: Study) -> str:
    """Table 5.6, and textured objects against the same in one colour, if the study has both."""
    rows = []
    one, other = study.hmds
    for column in COLUMNS:
        test = statistics.wilcoxon(*statistics.paired_values(study, column, "hmd", one, other))
        rows.append([f"{column}, {one} and {other}, rows", *_wilcoxon_cells(test)])
        means = (statistics.by_participant(study.select(hmd=hmd), column) for hmd in study.hmds)
        rows.append(
            [f"{column}, {one} and {other}, means of participants", *_wilcoxon_cells(statistics.wilcoxon(*means))]
        )
        for name in study.objects:
            test = statistics.wilcoxon(*statistics.paired_values(study.select(object=name), column, "hmd", one, other))
            rows.append([f"{column}, {one} and {other}, {name}", *_wilcoxon_cells(test)])
        for plain in study.objects:
            textured = plain.removesuffix("_plain")
            if textured != plain and textured in study.objects:
                sides = statistics.paired_values(study, column, "object", textured, plain)
                means_of = f"means {sides[0].mean():.4f} and {sides[1].mean():.4f}"
                rows.append(
                    [f"{column}, {textured} and {plain}, {means_of}", *_wilcoxon_cells(statistics.wilcoxon(*sides))]
                )
    return table("Pairs compared, Wilcoxon's signed ranks (5.6)", ["", "pairs", "equal", "W", "Z", "p"], rows)


def table_of_correlations(study: Study) -> str:
    """Table 5.8."""
    pairs = {f"d and k, {hmd}": (study.select(hmd=hmd).d, study.select(hmd=hmd).k) for hmd in study.hmds}
    pairs["d and k, both headsets"] = (study.d, study.k)
    pairs["d and k, means of participants"] = (
        statistics.by_participant(study, "d"),
        statistics.by_participant(study, "k"),
    )
    for column in COLUMNS:
        pairs[f"{column}, {' and '.join(study.hmds)}"] = statistics.paired_values(study, column, "hmd", *study.hmds)
    rows = []
    for label, (one, other) in pairs.items():
        both = statistics.correlation(one, other)
        rows.append([label, len(one), both.tau, _p(both.tau_p), both.rho, _p(both.rho_p)])
    return table("Correlations, Kendall's τ-b and Spearman's ρ (5.8)", " | n | τ {:.4f} | p | ρ {:.4f} | p", rows)


def table_of_texture(study: Study) -> str:
    rows = [(f"{name}, level {level}", factor) for (name, level), factor in statistics.texture(study).items()]
    return table("1 − SSIM with a texture, times that without", " | factor {:.2f}", rows)


def table_of_readings(study: Study) -> str:
    """Table of means of d and k for other choices of rows, with the threshold by each interpretation of y = kx + d."""
    headset = nf.hmd.RIFT_S
    sigma = nf.lod.reference_solid_angle(headset)
    rows: list[list[object]] = [
        [label, n, d, k, nf.lod.LodThreshold(k, d).line(sigma)[0], d + k * sigma, d - k]
        for label, (d, k, n) in statistics.readings(study).items()
    ]
    first = study.first(TABULATED)
    for label, objects in (("95 % over participants", False), ("95 % over participants and objects", True)):
        intervals = [statistics.bootstrap(first, column, objects=objects) for column in COLUMNS]
        rows.append([label, len(first), *(f"{low:.4f} to {high:.4f}" for low, high in intervals), None, None, None])
    numbers = ("d", "k", "anchored, far away", "literal, at 1/16", "normalized, far away")
    header = ["", "rows", *(f"{name} {{:.4f}}" for name in numbers)]
    return table(f"d and k by choices that could have been made; thresholds for {headset.name}", header, rows)


def _normal(values: NDArray[np.float64]) -> list[str]:
    (d, d_p), (w, w_p) = statistics.lilliefors(values), statistics.shapiro(values)
    return [str(len(values)), f"{d:.4f}", _p(d_p), f"{w:.4f}", _p(w_p)]


def _wilcoxon_cells(test: Wilcoxon) -> list[str]:
    return [str(test.pairs), str(test.equal), f"{test.statistic:g}", f"{test.z:.4f}", _p(test.p)]


def _p(p: float) -> str:
    return f"{p:.4f}" if p >= 1e-4 else f"{p:.1e}"


def main() -> None:
    study, source = study_or_twin()
    first = study.first(TABULATED)
    print(f"The study, {source}; tables use the first {TABULATED} participants.\n")
    print(f"mean d = {first.d.mean():.4f}, mean k = {first.k.mean():.4f}\n")
    for row, usual in statistics.contradictory_rows(study):
        person, hmd, name, level = (getattr(study, field)[row] for field in ("participant", "hmd", "object", "level"))
        print(f"odd: participant {person}, {hmd}, {name}, level {level} has d = {study.d[row]}, elsewhere {usual}\n")
    if data.find(FILE):
        print(table_beside_thesis(first))
    for make_table in (table_of_moments, table_of_normality, table_of_headsets, table_of_correlations):
        print(make_table(first))
    if statistics.texture(first):
        print(table_of_texture(first))
    print(table_of_readings(study))


if __name__ == "__main__":
    main()
