"""The published study: its figures against formulas written out here, and a synthetic study with known figures."""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.special import ndtr, ndtri

import nearfar as nf
from benchmarks.lod import study as study_benchmark, user_study
from benchmarks.lod.user_study import TABULATED, Study, synthetic_study
from nearfar._base import random
from tests.support import data

Array = NDArray[np.float64]


@pytest.fixture(scope="module")
def study() -> Study:
    return user_study.load(data(user_study.FILE)).first(TABULATED)


@pytest.fixture(scope="module")
def twin() -> Study:
    return synthetic_study()


@pytest.fixture(params=["study", "twin"])
def either(request: pytest.FixtureRequest) -> Study:
    found: Study = request.getfixturevalue(request.param)
    return found


# formulas of textbooks, written out ----------------------------------------------------------------------------------
def ranks(values: Array) -> Array:
    """Return mid-ranks: the number of lesser values, and half of the equal ones."""
    return np.asarray((values < values[:, None]).sum(axis=1) + ((values == values[:, None]).sum(axis=1) + 1) / 2)


def spearman(one: Array, other: Array) -> float:
    return float(np.corrcoef(ranks(one), ranks(other))[0, 1])


def kendall(one: Array, other: Array) -> tuple[float, float]:
    """Return τ-b by all pairs, and p by the normal approximation with ties (Kendall 1970)."""
    n = len(one)
    upper = np.triu_indices(n, 1)
    signs = [np.sign(values[:, None] - values)[upper] for values in (one, other)]
    s = float((signs[0] * signs[1]).sum())
    tau = s / np.sqrt(float((signs[0] ** 2).sum()) * float((signs[1] ** 2).sum()))
    t, u = (np.unique(values, return_counts=True)[1].astype(float) for values in (one, other))
    variance = (
        (n * (n - 1) * (2 * n + 5) - (t * (t - 1) * (2 * t + 5)).sum() - (u * (u - 1) * (2 * u + 5)).sum()) / 18
        + (t * (t - 1) * (t - 2)).sum() * (u * (u - 1) * (u - 2)).sum() / (9 * n * (n - 1) * (n - 2))
        + (t * (t - 1)).sum() * (u * (u - 1)).sum() / (2 * n * (n - 1))
    )
    return tau, float(2 * ndtr(-abs(s) / np.sqrt(variance)))


def signed_ranks(one: Array, other: Array) -> tuple[float, float, Array]:
    """Return the lesser sum of ranks, p by the normal approximation with ties, and the ranks."""
    apart = np.round(one - other, 9)
    apart = apart[apart != 0]
    n, ranked = len(apart), ranks(np.abs(apart))
    up = float(ranked[apart > 0].sum())
    tied = np.unique(ranked, return_counts=True)[1].astype(float)
    variance = n * (n + 1) * (2 * n + 1) / 24 - (tied**3 - tied).sum() / 48
    p = 2 * ndtr(-abs(up - n * (n + 1) / 4) / np.sqrt(variance))
    return min(up, n * (n + 1) / 2 - up), float(p), ranked


def exact_p(ranked: Array, statistic: float) -> float:
    """Return two-sided p by the sums of ranks under all 2ⁿ choices of signs, counted in halves of a rank."""
    halves = np.round(2 * ranked).astype(int)
    ways = np.zeros(halves.sum() + 1)
    ways[0] = 1
    for half in halves:
        ways[half:] += ways[:-half].copy()
    return float(min(1.0, 2 * ways[: round(2 * statistic) + 1].sum() / ways.sum()))


def royston(values: Array) -> tuple[float, float]:
    """Return W and p of Shapiro–Wilk by Royston's approximation (1995) for 12 values and more."""
    n = len(values)
    m = ndtri((np.arange(1, n + 1) - 0.375) / (n + 0.25))
    u, square = n**-0.5, float(m @ m)
    last = np.polyval([-2.706056, 4.434685, -2.071190, -0.147981, 0.221157, m[-1] / np.sqrt(square)], u)
    second = np.polyval([-3.582633, 5.682633, -1.752461, -0.293762, 0.042981, m[-2] / np.sqrt(square)], u)
    rest = (square - 2 * m[-1] ** 2 - 2 * m[-2] ** 2) / (1 - 2 * last**2 - 2 * second**2)
    a = m / np.sqrt(rest)
    a[[0, 1, -2, -1]] = -last, -second, second, last
    w = float((a @ np.sort(values)) ** 2 / ((values - values.mean()) ** 2).sum())
    ln = np.log(n)
    middle = np.polyval([0.0038915, -0.083751, -0.31082, -1.5861], ln)
    spread = np.exp(np.polyval([0.0030302, -0.082676, -0.4803], ln))
    return w, float(ndtr(-(np.log(1 - w) - middle) / spread))


def farthest(values: Array) -> float:
    """Return Kolmogorov–Smirnov's D from the normal distribution of the same mean and deviation."""
    mean, deviation = values.mean(), np.sqrt(((values - values.mean()) ** 2).sum() / (len(values) - 1))
    apart = 0.0
    for value in values:
        expected = ndtr((value - mean) / deviation)
        for share in ((values <= value).mean(), (values < value).mean()):
            apart = max(apart, abs(share - expected))
    return float(apart)


# each figure against its formula -------------------------------------------------------------------------------------
@pytest.mark.parametrize("column", ["d", "k"])
@pytest.mark.parametrize("hmd", ["rift", "vive"])
def test_moments_equal_the_formulas(either: Study, column: str, hmd: str) -> None:
    values = getattr(either.select(hmd=hmd), column)
    n, found = len(values), user_study.moments(values)
    assert found.n == n == 240
    assert found.mean == pytest.approx(sum(values.tolist()) / n, rel=1e-12)
    away = values - values.mean()
    assert found.deviation == pytest.approx(np.sqrt((away**2).sum() / (n - 1)), rel=1e-12)
    g1 = (away**3).mean() / (away**2).mean() ** 1.5
    g2 = (away**4).mean() / (away**2).mean() ** 2 - 3
    assert found.skewness == pytest.approx(g1, rel=1e-9)
    assert found.kurtosis == pytest.approx(g2, rel=1e-9)
    assert found.adjusted_skewness == pytest.approx(g1 * np.sqrt(n * (n - 1)) / (n - 2), rel=1e-9)
    assert found.adjusted_kurtosis == pytest.approx((n - 1) / ((n - 2) * (n - 3)) * ((n + 1) * g2 + 6), rel=1e-9)


@pytest.mark.parametrize("column", ["d", "k"])
def test_normality_equals_royston(either: Study, column: str) -> None:
    rows = getattr(either.select(hmd="rift"), column)
    for values in (rows, user_study.by_participant(either.select(hmd="vive"), column)):
        w, p = royston(values)
        # Royston's polynomials have six or seven digits, and W's distance from 1 a few fewer.
        found = user_study.shapiro(values)
        assert found[0] == pytest.approx(w, abs=2e-5)
        assert found[1] == pytest.approx(p, rel=5e-3)


@pytest.mark.parametrize("column", ["d", "k"])
@pytest.mark.parametrize("hmd", ["rift", "vive"])
def test_kolmogorov_distance_is_the_maximum_over_all_steps(either: Study, column: str, hmd: str) -> None:
    part = either.select(hmd=hmd)
    for values in (getattr(part, column), user_study.by_participant(part, column)):
        assert user_study.lilliefors(values)[0] == pytest.approx(farthest(values), rel=1e-12)


def test_kolmogorov_distance_of_two_values() -> None:
    """Two values lie 1/√2 deviations from their mean, where the normal has Φ(−1/√2) below it and the step ½."""
    assert user_study.lilliefors(np.array([3.0, 5.0]))[0] == pytest.approx(0.5 - ndtr(-(0.5**0.5)))


@pytest.mark.parametrize("n", [24, 240])
def test_p_of_normal_values_has_its_nominal_rate(n: int) -> None:
    """Tolerates four deviations of 500 samples, and 10 % of the level for the formula's own error."""
    samples = ndtri(random.uniform(7, n, np.arange(500 * n)).reshape(500, n))
    p = np.array([user_study.lilliefors(sample)[1] for sample in samples])
    for level in (0.01, 0.05):
        assert abs((p <= level).mean() - level) < 4 * np.sqrt(level * (1 - level) / 500) + 0.1 * level
    assert p.max() == 0.1


@pytest.mark.parametrize("column", ["d", "k"])
def test_signed_ranks_equal_the_formula(either: Study, column: str) -> None:
    sides = user_study.paired_values(either, column, "hmd", "rift", "vive")
    means = [user_study.by_participant(either.select(hmd=hmd), column) for hmd in ("rift", "vive")]
    for one, other in (sides, means):
        statistic, p, ranked = signed_ranks(one, other)
        found = user_study.wilcoxon(one, other)
        assert found.statistic == statistic
        assert found.p == pytest.approx(p, rel=1e-9)
        assert found.z == pytest.approx(ndtri(p / 2), rel=1e-9)
        assert (found.pairs, found.pairs - found.equal) == (len(one), len(ranked))
    # All signs of two dozen pairs can be counted: the approximation's error is of the order of 1/n.
    assert found.p == pytest.approx(exact_p(ranked, statistic), abs=0.02)


@pytest.mark.parametrize("hmd", ["rift", "vive"])
def test_correlations_equal_sums_over_all_pairs(either: Study, hmd: str) -> None:
    part = either.select(hmd=hmd)
    found = user_study.correlation(part.d, part.k)
    tau, p = kendall(part.d, part.k)
    assert found.tau == pytest.approx(tau, rel=1e-9)
    assert found.tau_p == pytest.approx(p, rel=1e-6)
    assert found.rho == pytest.approx(spearman(part.d, part.k), rel=1e-9)


def test_pairs_have_the_same_participant_and_object(either: Study) -> None:
    turn = np.arange(len(either)) * 7 % len(either)
    mixed = Study(*(getattr(either, name)[turn] for name in Study.__dataclass_fields__))
    for n, side in enumerate(user_study.paired_values(mixed, "level", "hmd", "rift", "vive")):
        hmd = ("rift", "vive")[n]
        expected = [
            int(either.level[(either.participant == who) & (either.object == name) & (either.hmd == hmd)][0])
            for who in range(TABULATED)
            for name in sorted(either.objects)
        ]
        assert side.tolist() == expected
    with pytest.raises(ValueError, match="pairs"):
        user_study.paired_values(either.where(np.arange(len(either)) > 0), "d", "hmd", "rift", "vive")


# the published one ---------------------------------------------------------------------------------------------------
def test_the_recommended_d_and_k_are_the_means(study: Study) -> None:
    d, k = round(float(study.d.mean()), 2), round(float(study.k.mean()), 2)
    assert nf.lod.LodThreshold(k, d) == nf.lod.LodThreshold()
    assert (study.d.mean(), study.k.mean()) == (pytest.approx(0.901099, abs=1e-6), pytest.approx(0.2734375))
    for hmd, means in {"rift": (0.905087, 0.267708), "vive": (0.897112, 0.279167)}.items():
        part = study.select(hmd=hmd)
        assert (part.d.mean(), part.k.mean()) == (pytest.approx(means[0], abs=1e-6), pytest.approx(means[1], abs=1e-6))


def test_the_table_is_complete_and_nearly_consistent(study: Study) -> None:
    assert len(study) == TABULATED * 10 * 2
    assert len({*zip(study.participant.tolist(), study.hmd.tolist(), study.object.tolist(), strict=True)}) == len(study)
    assert np.array_equal(study.k, np.round(study.k * 4) / 4)
    assert ((study.level == 0) == (study.d == 1)).all()
    odd = user_study.contradictory_rows(study)
    where = [(study.participant[row], study.hmd[row], study.object[row], study.level[row]) for row, _ in odd]
    assert where == [(22, "vive", "chair", 4), (22, "vive", "falcon", 3)]
    repaired = user_study.repair_rows(study)
    assert user_study.contradictory_rows(repaired) == []
    # A coarser level of an object is never nearer to it.
    for name in study.objects:
        part = repaired.select(object=name)
        order = np.argsort(part.level, kind="stable")
        assert (np.diff(part.d[order]) <= 0).all()


def test_the_study_has_its_published_results(study: Study) -> None:
    """Headsets don't differ, d and k are not normal, and textured objects were accepted at a lower SSIM."""
    for column in ("d", "k"):
        assert user_study.wilcoxon(*user_study.paired_values(study, column, "hmd", "rift", "vive")).p > 0.5
        assert user_study.shapiro(getattr(study, column))[1] < 1e-8
    for name in ("elephant", "buddha"):
        textured, plain = user_study.paired_values(study, "d", "object", name, f"{name}_plain")
        assert textured.mean() < plain.mean()
        assert user_study.wilcoxon(textured, plain).p < 1e-3
    assert 1.0 < min(user_study.texture(study).values()) < max(user_study.texture(study).values()) < 1.4


# the made-up one -----------------------------------------------------------------------------------------------------
def test_known_moments_are_recovered(twin: Study) -> None:
    """Means of 480 rows lie within four of their deviations, and those of a study a hundred times as large closer."""
    for found, scale in ((twin, 1), (synthetic_study(100 * TABULATED), 10)):
        for values, mean, deviation in ((found.d, 0.9, 0.02 * 10**0.5), (found.k, 0.25, 0.25 * 2**0.5)):
            assert abs(values.mean() - mean) < 4 * deviation / np.sqrt(480) / scale
            assert values.std(ddof=1) == pytest.approx(deviation, rel=0.1 / scale)


def test_an_effect_is_found_where_there_is_one(twin: Study) -> None:
    def p(study: Study) -> float:
        return user_study.wilcoxon(*user_study.paired_values(study, "d", "hmd", "rift", "vive")).p

    assert p(twin) > 0.05
    assert p(synthetic_study(gap=-0.05)) < 1e-8
    assert user_study.wilcoxon(twin.d, twin.d).p == 1.0
    assert abs(user_study.correlation(twin.d, twin.k).tau) < 0.1
    assert user_study.correlation(twin.d, -twin.level.astype(float)).tau == pytest.approx(1.0)


def test_inconsistent_rows_are_found_and_repaired(twin: Study) -> None:
    assert user_study.contradictory_rows(twin) == []
    row = 77
    before = float(twin.d[row])
    wrong = Study(**{name: getattr(twin, name).copy() for name in Study.__dataclass_fields__})
    wrong.d[row] = before - 0.125
    assert user_study.contradictory_rows(wrong) == [(row, before)]
    assert np.array_equal(user_study.repair_rows(wrong).d, twin.d)


def test_intervals_cover_known_values() -> None:
    """Independent rows have the interval of the normal; correlated rows of a participant a wider one."""
    twin = synthetic_study()
    low, high = user_study.bootstrap(twin, "d")
    assert low < twin.d.mean() < high
    assert (high - low) / (2 * 1.96) == pytest.approx(twin.d.std() / np.sqrt(len(twin)), rel=0.3)
    assert user_study.bootstrap(twin, "d") == (low, high)
    fixed: Any = {name: getattr(twin, name) for name in Study.__dataclass_fields__}
    alike = Study(**(fixed | {"d": twin.d + 0.1 * (twin.participant % 2)}))
    low, high = user_study.bootstrap(alike, "d")
    assert (high - low) / (2 * 1.96) == pytest.approx(0.05 / np.sqrt(TABULATED), rel=0.1)
    # Resampling objects as well only widens it.
    wide = user_study.bootstrap(alike, "d", objects=True, draws=2_000)
    assert wide[1] - wide[0] > 0.9 * (high - low)


def test_everything_is_printed_with_and_without_data(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Any
) -> None:
    monkeypatch.setattr(study_benchmark, "spans", partial(study_benchmark.spans, draws=5))
    study_benchmark.main()
    monkeypatch.setenv("NEARFAR_DATA", str(tmp_path))
    study_benchmark.main()
    printed = capsys.readouterr().out
    assert "made up" in printed
    # The thesis' values would be irrelevant for a synthetic study.
    assert "### Beside" not in printed[printed.index("made up") :]
    assert printed.count("### ") >= 10
    assert "nan" not in printed
