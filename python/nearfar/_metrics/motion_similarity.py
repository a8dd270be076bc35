"""Similarity of consecutive pictures of a moving camera, with the motion taken out."""

from __future__ import annotations

from dataclasses import replace

from nearfar import _core
from nearfar._metrics.result import Similarity
from nearfar._metrics.similarity import ssim
from nearfar._render.frame import Frame
from nearfar._render.ranged import motion_of, ranged


def motion_ssim(earlier: Frame, later: Frame, *, full: bool = False) -> Similarity:
    """Compute how similar a picture is to the one before where both show the same surfaces: 1 if nothing flickers.

    The earlier picture is warped to the later one by the later one's motion; then SSIM is taken over the pixels whose
    surface both see.

    Parameters
    ----------
    earlier
        The picture before, with colour and range.
    later
        The picture, of any size, with colour, range and the motion since the picture before.
    full
        Whether to compute the similarity around each pixel, too.

    Returns
    -------
    Similarity
        As `ssim` of frames. A pixel counts if the earlier picture, looked up between its pixels, shows a surface at the
        same distance from the earlier camera within 2 %; windows that see other pixels see them unchanged. Pictures of
        several methods are compared alike if they are given the truth's range and motion, by `dataclasses.replace`.

    Raises
    ------
    ValueError
        For frames without these images, and where no pixel shows the same surface in both.
    TypeError
        For something that is no frame.
    """
    past, now, motion = ranged("earlier", earlier), ranged("later", later), motion_of("later", later)
    warped, seen = _core.blend_past(past, now, fade=(0.0, 0.0), motion=motion)
    if not seen.any():
        raise ValueError("later: expected a picture that shows some surface of the earlier one, got none")
    return ssim(replace(later, color=warped), later, mask=seen, full=full)
