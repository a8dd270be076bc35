"""Cross-fade of two pictures."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from nearfar._base import check
from nearfar._render.frame import Frame


def blend(old: Frame, new: Frame, share: float) -> Frame:
    """Cross-fade two frames of one camera: the newer one with the linear mixture of both colours.

    `share` is that of the newer frame, 0 to 1. ValueError for frames without colour or of different sizes.
    """
    old_color = check.instance("old", old, Frame).require("color")
    new_color = check.instance("new", new, Frame).require("color")
    weight = np.float32(check.in_range("share", share, 0.0, 1.0))
    if old_color.shape != new_color.shape:
        sizes = f"the old one's shape {old_color.shape[:2]}, got {new_color.shape[:2]}"
        raise ValueError(f"new: expected a frame of {sizes}")
    return replace(new, color=old_color + weight * (new_color - old_color))
