"""How far a picture is from the truth: by its values, and by the objects that it shows."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check
from nearfar._metrics import inputs
from nearfar._render.frame import Frame


def rmse(reference: ArrayLike | Frame, test: ArrayLike | Frame) -> float:
    """Root of the mean squared difference of two pictures.

    Parameters
    ----------
    reference, test
        Arrays of one shape, of any number type (uint8, uint16, float32 and float64 are read as they lie in memory); or
        two frames, whose sRGB-encoded Rec. 709 luma in 0..1 is compared.

    Returns
    -------
    float
        In the pictures' units; 0 where they are equal. Summed in float64, without rounding for whole numbers of up to
        16 bits. The same bits for any number of threads.

    Raises
    ------
    ValueError
        For other shapes, empty pictures, frames without colour, values that are not finite or beyond 1e150.
    TypeError
        For values that are not numbers, and for a frame beside an array.
    """
    return math.sqrt(_mean_squared_error(inputs.pair(reference, test)))


def psnr(reference: ArrayLike | Frame, test: ArrayLike | Frame, *, data_range: float | None = None) -> float:
    """Peak signal-to-noise ratio of two pictures, in decibels.

    Parameters
    ----------
    reference, test
        As in `rmse`.
    data_range
        Difference of the greatest and least value that pictures may have: 255 for 8 bits. It is never guessed, and
        is 1 for frames.

    Returns
    -------
    float
        20 log₁₀(data_range / rmse); infinite where the pictures are equal.

    Raises
    ------
    ValueError, TypeError
        As in `rmse`, and without a positive `data_range` for arrays.
    """
    pair = inputs.pair(reference, test, data_range)
    peak = pair.extent()
    error = _mean_squared_error(pair)
    return math.inf if error == 0.0 else 20.0 * math.log10(peak) - 10.0 * math.log10(error)


def object_completion(reference_ids: ArrayLike, test_ids: ArrayLike) -> tuple[float, float]:
    """How many of the true picture's objects a picture shows, and how much of each.

    Parameters
    ----------
    reference_ids, test_ids
        Object numbers of one shape, such as `Frame.object_id`; negative ones are none.

    Returns
    -------
    (float, float)
        OVC, the share of the reference's objects that are visible at all, and OFC, the mean over them of
        min(pixels here, pixels there) / pixels there; NaN where the reference shows none.

    Raises
    ------
    ValueError, TypeError
        For other shapes, and for what is no 32-bit object number.

    References
    ----------
    CloVR (2024), Eq. 1–2.
    """
    reference = check.array("reference_ids", reference_ids, columns=None, dtype=np.int32)
    test = check.array("test_ids", test_ids, columns=None, dtype=np.int32)
    if reference.shape != test.shape:
        raise ValueError(f"test_ids: expected shape {reference.shape}, got {test.shape}")
    found = _core.object_completion(reference.ravel(), test.ravel())
    return (math.nan, math.nan) if found is None else found


def _mean_squared_error(pair: inputs.Pair) -> float:
    rows = [_rows(picture) for picture in (pair.reference, pair.test)]
    error = _core.mean_squared_errors(*rows)[0]
    if not math.isfinite(error):
        raise pair.refuse()
    return error


def _rows(picture: NDArray[Any]) -> NDArray[Any]:
    """A picture of any shape as one of rows, without a copy where its values lie in order."""
    if picture.ndim == 2:
        return picture
    plain = np.ascontiguousarray(picture)
    return plain.reshape(plain.shape[0], -1) if plain.ndim > 2 else plain.reshape(1, -1)
