"""Conversion between sRGB and linear light."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray


def to_linear(srgb: NDArray[Any]) -> NDArray[np.float64]:
    """Decode sRGB in 0..1 (IEC 61966-2-1)."""
    linear_segment = srgb / 12.92
    power_segment = ((np.maximum(srgb, 0.04045) + 0.055) / 1.055) ** 2.4
    return np.where(srgb <= 0.04045, linear_segment, power_segment)


def to_srgb(linear: NDArray[Any]) -> NDArray[np.float64]:
    """Encode linear light in 0..1 as sRGB (IEC 61966-2-1)."""
    linear_segment = linear * 12.92
    power_segment = 1.055 * np.maximum(linear, 0.0031308) ** (1 / 2.4) - 0.055
    return np.where(linear <= 0.0031308, linear_segment, power_segment)
