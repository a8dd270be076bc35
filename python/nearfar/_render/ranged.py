"""Converts frames to arguments of kernels that look up surfaces: camera, colours, ranges."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import check
from nearfar._render.frame import Frame

Ranged = tuple[_core.Camera, NDArray[np.float32], NDArray[np.float32]]
"""Camera, linear colours (H, W, 3), ranges (H, W) in metres."""


def ranged(name: str, frame: Frame) -> Ranged:
    """Return camera, colours and ranges of a frame; ValueError with the argument's name if an image is missing."""
    check.instance(name, frame, Frame)
    color, distance = (_image(name, frame, channel) for channel in ("color", "range"))
    return frame.camera._core, color, distance


def motion_of(name: str, frame: Frame) -> NDArray[np.float32]:
    """Return the motion (H, W, 2) of a frame; ValueError with the argument's name if it is missing."""
    return _image(name, frame, "motion")


def _image(name: str, frame: Frame, channel: str) -> NDArray[np.float32]:
    try:
        image = frame.require(channel)
    except ValueError as error:
        raise ValueError(f"{name}: {error}") from None
    return check.array(f"{name}.{channel}", image, columns=None, dtype=np.float32)
