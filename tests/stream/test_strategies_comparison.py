"""The statistics of the benchmark of strategies: users, and tests of signed ranks."""

from __future__ import annotations

import math

import numpy as np
import pytest

from benchmarks.stream import _comparison


def test_users_are_seeded_and_two_metres_off() -> None:
    center = (1.0, 1.3, -2.0)
    found = _comparison.users(center)
    assert found == _comparison.users(center) != _comparison.users(center, seed=2)
    assert len(found) == 20
    for (x, y, z), _ in found:
        assert math.hypot(x - 1.0, z + 2.0) == pytest.approx(2.0)
        assert y == 1.3


def test_the_greatest_z_of_twenty_pairs_is_3_92() -> None:
    dice = np.random.default_rng(2)
    base = dice.uniform(0.0, 0.1, 20)
    # Each strategy has more than the previous one, by different amounts; the last two differ at random.
    noise = dice.normal(0.0, 0.01, (20, 4))
    values = base[:, None] + np.array([0.0, 0.2, 0.5, 0.5]) + noise
    chi, p, pairs = _comparison.significance(values)
    assert chi > 50.0
    assert p < 1e-10
    for pair in pairs[:-1]:
        assert pair.z == pytest.approx(-3.92, abs=0.01)
        assert pair.p == pytest.approx(8.9e-5, abs=1e-6)
    assert abs(pairs[-1].z) < 2.64
    assert pairs[-1].p > _comparison.ALPHA


def test_the_level_is_corrected_for_six_comparisons() -> None:
    assert pytest.approx(0.008333, abs=1e-6) == _comparison.ALPHA


def test_means_weight_values_by_duration() -> None:
    times, values = np.array([0.0, 1.0, 3.0]), np.array([0.0, 1.0, 0.5])
    assert _comparison.mean_over_time(times, values, 4.0) == pytest.approx(2.5 / 4.0)
    assert _comparison.mean_over_time(times, values, 2.0) == pytest.approx(0.5)
