"""Pictures of an object from many sides, and the similarity of a level's to the base's."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from nearfar._camera.camera import Camera
from nearfar._metrics.inputs import LUMA
from nearfar._metrics.similarity import ssim_pairs
from nearfar._render.sequence import render_path
from nearfar._scene.scene import Scene


class Pictures(NamedTuple):
    """Pictures of one object from V sides."""

    luma: NDArray[np.float64]
    """(V, H, W), Rec. 709 of 8-bit sRGB, 0 to 255, not rounded."""
    shown: NDArray[np.bool_]
    """(V, H, W), whether the object is at the pixel's centre."""


def pictures(scene: Scene, cameras: Sequence[Camera], samples: int, backend: str | None) -> Pictures:
    """Render an object before the sky. Cameras have pictures of one size."""
    width, height = cameras[0].size
    luma = np.empty((len(cameras), height, width))
    shown = np.empty(luma.shape, bool)
    frames = render_path(scene, cameras, channels=("color", "range"), samples=samples, backend=backend)
    for number, frame in enumerate(frames):
        luma[number] = frame.to_image() @ np.array(LUMA)
        shown[number] = np.isfinite(frame.require("range"))
    return Pictures(luma, shown)


def scores(base: Pictures, level: Pictures) -> NDArray[np.float64]:
    """SSIM (V,) over the pixels where either shows the object; 1 where neither does, because both show the same."""
    either = base.shown | level.shown
    similarity = ssim_pairs(base.luma, level.luma, data_range=255.0, masks=either)
    return np.where(either.any(axis=(1, 2)), similarity, 1.0)
