"""The decisions printed in Fink et al. (2019) between hybrid and plain stereo, with binomial tests."""

from __future__ import annotations

import itertools
from collections.abc import Sequence

import numpy as np
from scipy import stats

from benchmarks.harness.report import table

DECISIONS = {"SPHERES": (175, 277), "LANDSCAPE": (162, 297), "BEAMS": (147, 304)}
"""How often users took hybrid stereo, and how often plain stereo, for plain stereo, by scene."""
SUBJECTS, INVALID, PAIRS = 47, 48, 1410

ORDERS = {"SPHERES": (16, 0.40), "LANDSCAPE": (15, 0.37), "BEAMS": (16, 0.29)}
"""Number of subjects, and share of their decisions for hybrid stereo, by the group's order of scenes."""


def order_effect(shift: Sequence[float] = (0.0, 0.0, 0.0)) -> tuple[float, float]:
    """χ² and p of the orders' shares, whose counts are not printed; `shift` is added to the shares.

    The valid decisions are spread evenly over subjects; counts are rounded to whole decisions.
    """
    subjects, shares = np.array([*ORDERS.values()]).T
    decisions = np.rint(subjects / SUBJECTS * (PAIRS - INVALID))
    hybrid = np.rint((shares + shift) * decisions)
    chi, p, _, _ = stats.chi2_contingency([hybrid, decisions - hybrid])
    return float(chi), float(p)


def order_range() -> tuple[float, float]:
    """Least and greatest χ² of shares that are printed alike: half a percent more or less."""
    found = [order_effect(shift)[0] for shift in itertools.product((-0.005, 0.005), repeat=len(ORDERS))]
    return min(found), max(found)


def main() -> None:
    decisions = np.array([*DECISIONS.values()])
    assert decisions.sum() == PAIRS - INVALID
    rows = []
    for name, (hybrid, stereo) in zip((*DECISIONS, "all"), [*decisions, decisions.sum(axis=0)], strict=True):
        test = stats.binomtest(hybrid, hybrid + stereo)
        interval = test.proportion_ci(method="wilson")
        shares = 100 * test.statistic, (100 * interval.low, 100 * interval.high)
        rows.append([name, hybrid, stereo, *shares, test.pvalue])
    header = "scene | hybrid | stereo | share of hybrid {:.1f} % | 95 % {:.1f} to {:.1f} %"
    header += " | p if both were equally likely {:.1e}"
    print(table(f"Decisions of {SUBJECTS} subjects", header, rows))
    chi, p, _, _ = stats.chi2_contingency(decisions)
    print(f"Scene and decision: χ² = {chi:.2f}, p = {p:.2f}, φ = {np.sqrt(chi / decisions.sum()):.3f}")
    chi, p = order_effect()
    low, high = order_range()
    print(f"Order of scenes and decision: χ² = {chi:.1f}, p = {p:.4f}; {low:.1f} to {high:.1f} by the shares' rounding")


if __name__ == "__main__":
    main()
