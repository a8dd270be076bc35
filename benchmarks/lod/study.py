"""Statistics of the published study of levels of detail: moments, normality, headsets, correlations, uncertainty."""

from __future__ import annotations

from dataclasses import astuple

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness.report import table
from benchmarks.lod import user_study as statistics
from benchmarks.lod._printed import PRINTED, SOURCE, computed, spans
from benchmarks.lod.user_study import FILE, TABULATED, Study, Wilcoxon
from nearfar._base import data

COLUMNS = ("d", "k")


def study_or_twin() -> tuple[Study, str]:
    """Return the published study, or the synthetic one without a data folder, and a line that states which."""
    if data.find(FILE):
        study = statistics.load()
        return study, f"published: {len(study)} rows of {len(np.unique(study.participant))} participants"
    study = statistics.made_up(TABULATED + 1)
    return study, "made up, of the same shape, because there is no data folder"


def table_beside_thesis(study: Study) -> str:
    """Table of the printed tables 5.4, 5.5, 5.6 and 5.8, and the same figures of a study."""
    ours, ranges = computed(study), spans(study)
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
            printed.beside(ours[key]),
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
        one, other = statistics.paired(study, column, "hmd", *study.hmds)
        rows.append([f"{column}, {' − '.join(study.hmds)}", *_normal(one - other)])
    title = "Normality, Kolmogorov and Smirnov after Lilliefors (p above 0.1 is given as 0.1), Shapiro and Wilk (5.4)"
    return table(title, ["", "n", "D", "p", "W", "p"], rows)


def table_of_headsets(study: Study) -> str:
    """Table 5.6, and textured objects against the same in one colour, if the study has both."""
    rows = []
    one, other = study.hmds
    for column in COLUMNS:
        test = statistics.wilcoxon(*statistics.paired(study, column, "hmd", one, other))
        rows.append([f"{column}, {one} and {other}, rows", *_signed(test)])
        means = (statistics.by_participant(study.select(hmd=hmd), column) for hmd in study.hmds)
        rows.append([f"{column}, {one} and {other}, means of participants", *_signed(statistics.wilcoxon(*means))])
        for name in study.objects:
            test = statistics.wilcoxon(*statistics.paired(study.select(object=name), column, "hmd", one, other))
            rows.append([f"{column}, {one} and {other}, {name}", *_signed(test)])
        for plain in study.objects:
            textured = plain.removesuffix("_plain")
            if textured != plain and textured in study.objects:
                sides = statistics.paired(study, column, "object", textured, plain)
                means_of = f"means {sides[0].mean():.4f} and {sides[1].mean():.4f}"
                rows.append([f"{column}, {textured} and {plain}, {means_of}", *_signed(statistics.wilcoxon(*sides))])
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
        pairs[f"{column}, {' and '.join(study.hmds)}"] = statistics.paired(study, column, "hmd", *study.hmds)
    rows = []
    for label, (one, other) in pairs.items():
        both = statistics.correlation(one, other)
        rows.append([label, len(one), both.tau, _p(both.tau_p), both.rho, _p(both.rho_p)])
    return table("Correlations, Kendall's τ-b and Spearman's ρ (5.8)", " | n | τ {:.4f} | p | ρ {:.4f} | p", rows)


def table_of_texture(study: Study) -> str:
    rows = [(f"{name}, level {level}", factor) for (name, level), factor in statistics.texture(study).items()]
    return table("1 − SSIM with a texture, times that without", " | factor {:.2f}", rows)


def table_of_readings(study: Study) -> str:
    """Table of means of d and k for other choices, and the thresholds that follow from each reading of y = kx + d."""
    headset = nf.hmd.RIFT_S
    sigma = nf.lod.reference_solid_angle(headset)
    rows: list[list[object]] = [
        [label, n, d, k, nf.lod.LodThreshold(k, d).line(sigma)[0], d + k * sigma, d - k]
        for label, (d, k, n) in statistics.readings(study).items()
    ]
    first = study.first(TABULATED)
    for label, objects in (("95 % over participants", False), ("95 % over participants and objects", True)):
        spans = [statistics.bootstrap(first, column, objects=objects) for column in COLUMNS]
        rows.append([label, len(first), *(f"{low:.4f} to {high:.4f}" for low, high in spans), None, None, None])
    numbers = ("d", "k", "anchored, far away", "literal, at 1/16", "normalized, far away")
    header = ["", "rows", *(f"{name} {{:.4f}}" for name in numbers)]
    return table(f"d and k by choices that could have been made; thresholds for {headset.name}", header, rows)


def _normal(values: NDArray[np.float64]) -> list[str]:
    (d, d_p), (w, w_p) = statistics.lilliefors(values), statistics.shapiro(values)
    return [str(len(values)), f"{d:.4f}", _p(d_p), f"{w:.4f}", _p(w_p)]


def _signed(test: Wilcoxon) -> list[str]:
    return [str(test.pairs), str(test.equal), f"{test.statistic:g}", f"{test.z:.4f}", _p(test.p)]


def _p(p: float) -> str:
    return f"{p:.4f}" if p >= 1e-4 else f"{p:.1e}"


def main() -> None:
    study, source = study_or_twin()
    first = study.first(TABULATED)
    print(f"The study, {source}; tables use the first {TABULATED} participants.\n")
    print(f"mean d = {first.d.mean():.4f}, mean k = {first.k.mean():.4f}\n")
    for row, usual in statistics.odd_rows(study):
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
