"""Similarity of consecutive pictures of a moving camera, compensated for motion."""

from __future__ import annotations

from dataclasses import replace

from nearfar import _core
from nearfar._render.frame import Frame
from nearfar._render.ranged import motion_of, ranged
from nearfar.metrics._similarity import ssim
from nearfar.metrics._window import Similarity


def motion_ssim(earlier: Frame, later: Frame, *, full: bool = False) -> Similarity:
    """Compute the similarity of a picture to the previous one on surfaces that both show: 1 if nothing flickers.

    The earlier picture, of any size, is warped by the later picture's motion. SSIM is computed over the pixels whose
    surface both show, with `full` also around each pixel. Both pictures need colour and range, the later one also the
    motion since the earlier one. ValueError for frames without these images, or without a common surface; TypeError for
    values that are not frames.

    Returns the similarity as `ssim` does for frames. A pixel counts if the earlier picture, interpolated at the pixel's
    earlier position, shows a surface at the same distance from the earlier camera within 2 %. Other pixels count as
    unchanged within windows. To compare several methods, give all pictures the truth's range and motion by
    `dataclasses.replace`.
    """
    past, now, motion = ranged("earlier", earlier), ranged("later", later), motion_of("later", later)
    warped, is_common = _core.blend_past(past, now, fade=(0.0, 0.0), motion=motion)
    if not is_common.any():
        raise ValueError("later: expected a picture that shows some surface of the earlier one, got none")
    return ssim(replace(later, color=warped), later, mask=is_common, full=full)
