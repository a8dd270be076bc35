"""Numbers of the study of Fink et al. (2019) that are computed from printed shares."""

from __future__ import annotations

import math

import pytest

from benchmarks.stereo import study


def test_order_of_scenes_matters() -> None:
    decisions = [1362 * subjects / 47 for subjects in (16, 15, 16)]
    hybrid = [share * count for share, count in zip((0.40, 0.37, 0.29), decisions, strict=True)]
    share = sum(hybrid) / 1362
    # Shares are printed to a percent, and agree with the 484 of 1,362 decisions of all scenes.
    assert share == pytest.approx(484 / 1362, abs=0.005)
    expected = sum(
        (count - share * n) ** 2 / (share * n) + (count - share * n) ** 2 / ((1 - share) * n)
        for count, n in zip(hybrid, decisions, strict=True)
    )
    chi, p = study.order_effect()
    assert chi == pytest.approx(expected) == pytest.approx(13.09, abs=0.01)
    # With two degrees of freedom, p = exp(−χ²/2).
    assert p == pytest.approx(math.exp(-chi / 2)) == pytest.approx(0.0014, abs=5e-5)
