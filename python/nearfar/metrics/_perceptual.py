"""Perceived differences by other projects' metrics: FLIP and ColorVideoVDP."""

from __future__ import annotations

from typing import SupportsFloat

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import check
from nearfar._render.frame import Frame
from nearfar.metrics import _inputs as inputs
from nearfar.metrics._window import Similarity

PIXELS_PER_DEGREE = 67.0
"""FLIP's default: a 4K monitor 0.7 m wide at a distance of 0.7 m."""

LUMINANCE, CONTRAST = 100.0, 1000.0
"""Luminance of white in cd/m² and contrast of ColorVideoVDP's headset, "standard_hmd"."""


def flip(
    reference: ArrayLike | Frame,
    test: ArrayLike | Frame,
    *,
    data_range: float | None = None,
    pixels_per_degree: SupportsFloat = PIXELS_PER_DEGREE,
    full: bool = False,
) -> Similarity:
    """Compute FLIP, the difference that a viewer perceives who flips between two pictures.

    Needs the package flip-evaluator: ``pip install "nearfar[flip]"``. Returns the mean error, a float from 0 (equal) to
    1; with `full` its `map` is (H, W) float32. ValueError and TypeError for pictures of different shapes, values
    outside 0 to `data_range`, and arguments out of range; ImportError if flip-evaluator is not installed. Source:
    Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström, Fairchild (2020): FLIP: A Difference Evaluator for
    Alternating Images.

    Parameters
    ----------
    reference, test
        (H, W), (H, W, 1) or (H, W, 3) of one shape, sRGB-encoded, from 0 to `data_range`; or two frames with `color`.
    data_range
        Value of white, such as 255 or 1; none for frames.
    pixels_per_degree
        Pixels of the picture per degree of the viewer's visual angle, 1 to 500; a headset has 15 to 35.
    full
        Whether to return the error of each pixel as well.
    """
    try:
        import flip_evaluator
    except ImportError:
        raise ImportError('FLIP needs the Python package flip-evaluator: pip install "nearfar[flip]"') from None
    density, full = check.in_range("pixels_per_degree", pixels_per_degree, 1.0, 500.0), check.flag("full", full)
    pictures = _unit_pictures(reference, test, data_range)
    errors, mean, _ = flip_evaluator.evaluate(*pictures, "LDR", applyMagma=False, parameters={"ppd": density})
    return Similarity(float(mean), errors[..., 0] if full else None)


def jod(
    reference: ArrayLike | Frame,
    test: ArrayLike | Frame,
    *,
    pixels_per_degree: SupportsFloat,
    luminance: SupportsFloat = LUMINANCE,
    data_range: float | None = None,
) -> float:
    """Compute ColorVideoVDP's quality of a picture, in just-objectionable differences (JOD), on the CPU.

    Needs the package cvvdp, which needs PyTorch: ``pip install "nearfar[jod]"``. Returns 10 for equal pictures and less
    for worse ones. If two pictures differ by one JOD, 75 % of viewers prefer the better one. The display has a contrast
    of 1000 and reflects no light. ValueError and TypeError for pictures of different shapes or below 2 × 2 pixels,
    values outside 0 to `data_range`, and arguments out of range; ImportError if cvvdp is not installed. Source:
    Mantiuk, Hanji, Ashraf, Asano, Chapiro (2024): ColorVideoVDP.

    Parameters
    ----------
    reference, test
        (H, W), (H, W, 1) or (H, W, 3) of one shape, sRGB-encoded, from 0 to `data_range`; or two frames with `color`.
    pixels_per_degree
        Pixels of the picture per degree of the viewer's visual angle, 1 to 500; a headset has 15 to 35.
    luminance
        Luminance of white on the display, 1 to 10,000 cd/m².
    data_range
        Value of white, such as 255 or 1; none for frames.
    """
    try:
        import pycvvdp
        import torch
    except ImportError:
        raise ImportError('JOD needs the Python package cvvdp: pip install "nearfar[jod]"') from None
    density = check.in_range("pixels_per_degree", pixels_per_degree, 1.0, 500.0)
    white = check.in_range("luminance", luminance, 1.0, 1e4)
    first, second = _unit_pictures(reference, test, data_range)
    height, width = first.shape[:2]
    if min(height, width) < 2:
        raise ValueError(f"reference: expected at least 2 × 2 pixels, got {width} × {height}")
    metric = pycvvdp.cvvdp(
        display_photometry=pycvvdp.vvdp_display_photo_eotf(white, contrast=CONTRAST, source_colorspace="sRGB"),
        display_geometry=pycvvdp.vvdp_display_geometry((width, height), ppd=density),
        quiet=True,
        device=torch.device("cpu"),
    )
    quality, _ = metric.predict(second, first, dim_order="HWC")
    return float(quality)


def _unit_pictures(
    reference: ArrayLike | Frame, test: ArrayLike | Frame, data_range: float | None
) -> list[NDArray[np.float32]]:
    """Return both pictures (H, W, 3), sRGB-encoded, scaled to 0..1."""
    if isinstance(reference, Frame) and isinstance(test, Frame):
        first, second, white = inputs.srgb_color(reference), inputs.srgb_color(test), inputs.frame_extent(data_range)
        if first.shape != second.shape:
            raise ValueError(f"test: expected shape {first.shape}, got {second.shape}")
    else:
        pair = inputs.pair(reference, test, data_range)
        inputs.channel_axis(pair, None)
        first, second, white = pair.reference, pair.test, pair.extent()
    return [_in_unit_range(name, values, white) for name, values in (("reference", first), ("test", second))]


def _in_unit_range(name: str, values: NDArray[np.generic], white: float) -> NDArray[np.float32]:
    """Convert a picture to three float32 channels, 0 to 1."""
    rows = np.asarray(values, np.float64)
    if flaw := check.not_finite(name, rows):
        raise flaw
    least, greatest = rows.min(), rows.max()
    # Values may exceed white by the rounding of weights and filters.
    if least < -1e-6 * white or greatest > (1 + 1e-6) * white:
        raise ValueError(f"{name}: expected values from 0 to {white:g}, got {least:g} to {greatest:g}")
    rows = (rows if rows.ndim == 3 else rows[..., None]).clip(0.0, white) / white
    return np.ascontiguousarray(np.broadcast_to(rows, (*rows.shape[:2], 3)), np.float32)
