"""Numbers of the study of Fink et al. (2019) that are computed from printed shares."""

from __future__ import annotations

import math

import pytest

from benchmarks.stereo import study


def test_order_of_scenes_matters() -> None:
    # 1,362 valid decisions of 47 subjects, and the printed shares of 40, 37 and 29 %, as whole decisions.
    decisions, hybrid = (464, 435, 464), (186, 161, 135)
    assert decisions == tuple(round(1362 * subjects / 47) for subjects in (16, 15, 16))
    assert hybrid == tuple(round(share * n) for share, n in zip((0.40, 0.37, 0.29), decisions, strict=True))
    share = sum(hybrid) / sum(decisions)
    # Shares are printed to a percent, and agree with the 484 of 1,362 decisions of all scenes.
    assert share == pytest.approx(484 / 1362, abs=0.005)
    expected = sum(
        (count - share * n) ** 2 / (share * n) + (count - share * n) ** 2 / ((1 - share) * n)
        for count, n in zip(hybrid, decisions, strict=True)
    )
    chi, p = study.order_effect()
    assert chi == pytest.approx(expected) == pytest.approx(13.02, abs=0.005)
    # With two degrees of freedom, p = exp(−χ²/2).
    assert p == pytest.approx(math.exp(-chi / 2)) == pytest.approx(0.0015, abs=5e-5)
    # Shares of half a percent more or less are printed alike.
    low, high = study.order_range()
    assert low < chi < high
    assert (round(low, 1), round(high, 1)) == (10.6, 15.9)
