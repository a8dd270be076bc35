"""Cross-fade of two pictures."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from nearfar._base import check
from nearfar._render.frame import Frame


def blend(old: Frame, new: Frame, share: float) -> Frame:
    """Cross-fade two frames of one camera: mix their colours, which are linear.

    Parameters
    ----------
    old, new
        Frames of one size, both with colour.
    share
        Share of the newer frame, 0 to 1.

    Returns
    -------
    Frame
        The newer frame with the mixed colour; its other images are unchanged.

    Raises
    ------
    ValueError
        Shares out of range, frames without colour, or frames of different sizes.
    TypeError
        Values that are not frames or a number.
    """
    before = check.instance("old", old, Frame).require("color")
    after = check.instance("new", new, Frame).require("color")
    part = np.float32(check.in_range("share", share, 0.0, 1.0))
    if before.shape != after.shape:
        raise ValueError(f"new: expected a frame of the old one's shape {before.shape[:2]}, got {after.shape[:2]}")
    return replace(new, color=before + part * (after - before))
