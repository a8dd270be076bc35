"""Valid calls of what is made of consecutive pictures."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from tests.support.valid_objects import SIZE, Valid


def steady(valid: Valid) -> dict[str, dict[str, Any]]:
    """Return valid keywords by the names of callables."""
    frame, motion = valid.frame, np.zeros((*SIZE[::-1], 2), np.float32)
    return {
        "nearfar.motion_ssim": {"earlier": frame, "later": replace(frame, motion=motion)},
        "nearfar.orthoview.Steady": {},
        "nearfar.orthoview.Steady.next": {"frame": frame, "time": 1.0},
        "nearfar.orthoview.Steady.restart": {},
        "nearfar.orthoview.motion_blur": {"frame": frame, "before": valid.camera},
    }
