"""Pictures as sRGB codes, and their similarity."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from nearfar import _core

Picture = NDArray[np.uint8]


def similarity(reference: Any, picture: Any) -> tuple[float, float]:
    """PSNR in decibels and SSIM of two frames, or of two arrays of codes or of values from 0 to 1."""
    if isinstance(reference, nf.Frame):
        return nf.psnr(reference, picture), float(nf.ssim(reference, picture))
    data_range = 255.0 if reference.dtype == np.uint8 else 1.0
    return nf.psnr(reference, picture, data_range=data_range), float(nf.ssim(reference, picture, data_range=data_range))


def encode(linear: NDArray[Any]) -> Picture:
    """Encode linear light as sRGB codes."""
    return _core.encode_srgb(np.ascontiguousarray(linear, np.float32).ravel()).reshape(linear.shape)


def average(samples: NDArray[Any], grid: int) -> Picture:
    """Average linear samples (grid · H, grid · W, 3) over each pixel; sRGB codes (H, W, 3)."""
    return encode(blocks(samples, grid).mean(axis=(1, 3)))


def blocks(samples: NDArray[Any], grid: int) -> NDArray[Any]:
    """Group samples (grid · H, grid · W, …) by pixel: (H, grid, W, grid, …)."""
    height, width = samples.shape[:2]
    return samples.reshape(height // grid, grid, width // grid, grid, *samples.shape[2:])
