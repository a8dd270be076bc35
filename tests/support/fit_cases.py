"""The logistic formula, and noisy curves of it, for tests of fits."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
SIZES = np.geomspace(1e-4, 3, 30)
"""Solid angles in steradians."""


def formula(x: Any, a: Any, b: Any, c: Any, d: Any) -> Any:
    """The definition as written, in extended precision if x has it."""
    return d + (a - d) / (1 + (x / c) ** b)


def noisy(seed: int, count: int, samples: int, noise: float) -> Iterator[tuple[Array, Array]]:
    """Curves of any slope and middle, with normal noise as a share of their height."""
    random = np.random.default_rng(seed)
    x = np.geomspace(1e-4, 3, samples)
    for _ in range(count):
        a, d = random.uniform(-1, 1, 2)
        y = formula(x, a, np.exp(random.uniform(-1.2, 2.0)), np.exp(random.uniform(-8.0, 0.5)), d)
        yield x, y + noise * abs(a - d) * random.normal(size=samples)
