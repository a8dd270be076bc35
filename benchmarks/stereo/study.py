"""The decisions printed in Fink et al. (2019) between hybrid and plain stereo, with binomial tests."""

from __future__ import annotations

import math

from benchmarks.harness.report import table

DECISIONS = {"SPHERES": (175, 277), "LANDSCAPE": (162, 297), "BEAMS": (147, 304)}
"""Number of times that hybrid and plain stereo were taken for plain stereo, by scene."""
SUBJECTS, INVALID, PAIRS = 47, 48, 1410


def binomial(successes: int, count: int) -> float:
    """Two-sided p of a number of successes that is at least as unlikely, if both outcomes were equally likely."""
    less = min(successes, count - successes)
    return min(1.0, float(2 * sum(math.comb(count, k) for k in range(less + 1)) / 2**count))


def interval(successes: int, count: int) -> tuple[float, float]:
    """Interval of the share by Wilson (1927), 95 %."""
    z, share = 1.959964, successes / count
    middle = share + z * z / (2 * count)
    reach = z * math.sqrt(share * (1 - share) / count + z * z / (4 * count * count))
    return (middle - reach) / (1 + z * z / count), (middle + reach) / (1 + z * z / count)


def association() -> tuple[float, float]:
    """χ² of scene and decision, two degrees of freedom, and φ = √(χ²/N)."""
    total = sum(map(sum, DECISIONS.values()))
    share = sum(hybrid for hybrid, _ in DECISIONS.values()) / total
    chi = sum((h - (h + s) * share) ** 2 / ((h + s) * share * (1 - share)) for h, s in DECISIONS.values())
    return chi, math.sqrt(chi / total)


def main() -> None:
    totals = tuple(map(sum, zip(*DECISIONS.values(), strict=True)))
    assert sum(totals) == PAIRS - INVALID
    rows = []
    for name, (hybrid, stereo) in {**DECISIONS, "all": (totals[0], totals[1])}.items():
        count = hybrid + stereo
        low, high = interval(hybrid, count)
        shares = 100 * hybrid / count, (100 * low, 100 * high)
        rows.append([name, hybrid, stereo, *shares, binomial(hybrid, count)])
    header = "scene | hybrid | stereo | share of hybrid {:.1f} % | 95 % {:.1f} to {:.1f} %"
    header += " | p if both were equally likely {:.1e}"
    print(table(f"Decisions of {SUBJECTS} subjects", header, rows))
    chi, phi = association()
    print(f"Scene and decision: χ² = {chi:.2f}, p = {math.exp(-chi / 2):.2f}, φ = {phi:.3f}")


if __name__ == "__main__":
    main()
