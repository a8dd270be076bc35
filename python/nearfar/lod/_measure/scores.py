"""Scores the similarity of levels to their base from many sides."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._camera.camera import Camera
from nearfar._render.backend import Backend
from nearfar._render.sequence import render_path
from nearfar._scene.scene import Scene
from nearfar.lod._measure.views import PADDING
from nearfar.metrics._inputs import LUMA
from nearfar.metrics._similarity import ssim_pairs


class Compared(NamedTuple):
    """A level, and the cameras for comparing it with its base."""

    level: Scene
    indices: NDArray[np.intp]
    """Indices of the cameras."""


class Pictures(NamedTuple):
    """Pictures of one object from V sides."""

    luma: NDArray[np.float64]
    """Luma (V, H, W), Rec. 709 of 8-bit sRGB, 0 to 255, not rounded."""
    is_object: NDArray[np.bool_]
    """Whether the pixel's centre shows the object (V, H, W)."""


def scores(
    base: Scene, levels: Sequence[Compared], cameras: Sequence[Camera], samples: int, backend: Backend | None
) -> Iterator[NDArray[np.float64]]:
    """Yield the scores of each level from its cameras; the base's pictures are made once for all levels.

    A score is the SSIM over the pixels at which either picture shows the object; 1 if neither shows it, since both show
    the same sky. All cameras have the same picture size.
    """
    if backend == "gpu":
        base_pictures = pictures(base, cameras, samples, backend)
        for level, indices in levels:
            test = pictures(level, [cameras[number] for number in indices], samples, backend)
            truth = Pictures(*(_select_pictures(part, indices) for part in base_pictures))
            yield _similarity(truth.luma, test.luma, truth.is_object | test.is_object)
        return
    # Only pixels in the SSIM windows of object pixels are traced: others do not affect the score.
    views = [camera._core for camera in cameras]
    needed = _core.silhouettes(base._core, views)
    views_of = [[views[number] for number in indices] for _, indices in levels]
    masks = [
        _core.silhouettes(level._core, level_views) | _select_pictures(needed, indices)
        for (level, indices), level_views in zip(levels, views_of, strict=True)
    ]
    for (_, indices), mask in zip(levels, masks, strict=True):
        needed[indices] |= mask
    luma_near = partial(_core.luma_near, samples=samples, weights=LUMA, reach=PADDING)
    base_luma = luma_near(base._core, views, needed)
    for (level, indices), level_views, mask in zip(levels, views_of, masks, strict=True):
        yield _similarity(_select_pictures(base_luma, indices), luma_near(level._core, level_views, mask), mask)


def pictures(scene: Scene, cameras: Sequence[Camera], samples: int, backend: Backend | None) -> Pictures:
    """Render an object in front of the sky."""
    width, height = cameras[0].size
    luma = np.empty((len(cameras), height, width))
    is_object = np.empty(luma.shape, bool)
    frames = render_path(scene, cameras, channels=("color", "range"), samples=samples, backend=backend)
    for number, frame in enumerate(frames):
        luma[number] = frame.to_image() @ np.array(LUMA)
        is_object[number] = np.isfinite(frame.require("range"))
    return Pictures(luma, is_object)


def _select_pictures(values: NDArray[Any], indices: NDArray[np.intp]) -> NDArray[Any]:
    """Select the pictures of some cameras; no copy if all are selected."""
    return values if len(indices) == len(values) else values[indices]


def _similarity(truth: NDArray[np.float64], test: NDArray[np.float64], mask: NDArray[np.bool_]) -> NDArray[np.float64]:
    return np.where(mask.any(axis=(1, 2)), ssim_pairs(truth, test, data_range=255.0, masks=mask), 1.0)
