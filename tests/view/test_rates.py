"""Tests of the frame rate benchmark: evaluation of frame times, and drawing flags of browsers."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import numpy as np

from benchmarks.view import _turns, rates

CHECKOUT = Path(__file__).resolve().parents[2]


def test_each_sector_of_a_turn_has_its_own_rate() -> None:
    # Half of a turn at 100 frames a second, the other half at 25.
    times = np.concatenate([np.arange(60) * 10.0, 600.0 + np.arange(61) * 40.0])
    angles = np.linspace(0.0, 2.0 * np.pi, 121)
    found = _turns.rates([*zip(angles, times, strict=True)])
    np.testing.assert_allclose(found, [100.0] * 6 + [25.0] * 6)


def test_a_sector_that_a_long_frame_skips_has_no_rate() -> None:
    found = _turns.rates([(0.0, 0.0), (3.2, 1000.0), (2.0 * np.pi, 1500.0)])
    np.testing.assert_allclose(found, [1.0, 2.0])


def test_rates_while_loading_are_measured_over_whole_windows() -> None:
    begins = [*np.arange(0.0, 0.5, 0.02), *np.arange(0.5, 1.0, 0.1), 1.05, 1.1]
    assert rates.rates(begins) == [50.0, 10.0]
    # A load shorter than a window counts as one window.
    assert rates.rates([5.0, 5.1, 5.2]) == [6.0]


def test_browsers_use_the_named_drawing_flags() -> None:
    code = "from tests.support.reader_cases import BROWSER_FLAGS; print(*BROWSER_FLAGS)"
    environment = {**os.environ, "NEARFAR_BROWSER_DRAWING": "--use-angle=vulkan --one"}
    done = subprocess.run([sys.executable, "-c", code], cwd=CHECKOUT, env=environment, capture_output=True, text=True)
    flags = done.stdout.split()
    assert flags[-2:] == ["--use-angle=vulkan", "--one"], done.stderr
    assert not any("swiftshader" in flag for flag in flags)
