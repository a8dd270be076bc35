"""Differences between pictures pixel by pixel: RMSE, PSNR, and the completeness of visible objects."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import background, check
from nearfar._render.frame import Frame
from nearfar.metrics import _inputs as inputs


def rmse(reference: ArrayLike | Frame, test: ArrayLike | Frame) -> float:
    """Compute the root mean square error between two pictures.

    Returns the error in the pictures' units; 0 for equal pictures. It is summed in float64, exactly for whole numbers
    of up to 16 bits, and its bits are the same for any number of threads. ValueError for different shapes, empty
    pictures, frames without colour, values that are not finite or beyond 1e150, and arrays that seem to include alpha
    (three or more axes, the last of length 2 or 4), which would count; TypeError for values that are not numbers, and a
    frame together with an array.

    Parameters
    ----------
    reference, test
        Arrays of one shape, of any number type (uint8, uint16, float32 and float64 are read without a copy); Pillow
        images, grey or RGB; or two frames, whose sRGB-encoded Rec. 709 luma in 0..1 is compared.
    """
    return math.sqrt(_mean_squared_error(inputs.pair(reference, test), ranges=False)[0])


def psnr(reference: ArrayLike | Frame, test: ArrayLike | Frame, *, data_range: float | None = None) -> float:
    """Compute the peak signal-to-noise ratio of two pictures in decibels.

    The ratio is 20 log₁₀(data_range / rmse), infinite for equal pictures. Raises as `rmse`; also ValueError for arrays
    without a positive `data_range` or with values that differ by more than it, and for frames if it is given.

    Parameters
    ----------
    reference, test
        As in `rmse`.
    data_range
        Difference between the greatest and the least possible value, such as 255 for 8 bits. Arrays need it, because it
        is never guessed. Their values may not differ by more (floats by a millionth more, for rounding). Frames need
        none: theirs is 1.
    """
    pair = inputs.pair(reference, test, data_range)
    peak = pair.extent()
    error, least, greatest = _mean_squared_error(pair, ranges=pair.may_exceed)
    pair.check_values(least, greatest)
    return math.inf if error == 0.0 else 20.0 * math.log10(peak) - 10.0 * math.log10(error)


def object_completion(reference_ids: ArrayLike, test_ids: ArrayLike) -> tuple[float, float]:
    """Measure how many of a reference picture's objects a test picture shows, and how much of each.

    Both have object numbers in arrays of one shape, such as `Frame.object_id`; negative numbers mean no object. Returns
    OVC, the share of the reference's objects that the test shows at all, and OFC, the mean over the reference's objects
    of min(test pixels, reference pixels) / reference pixels. Both are NaN if the reference shows no object. ValueError
    and TypeError for different shapes, and values that are not 32-bit integers. Source: CloVR (2024), Eq. 1–2.
    """
    reference = check.array("reference_ids", reference_ids, columns=None, dtype=np.int32)
    test = check.array("test_ids", test_ids, columns=None, dtype=np.int32)
    if reference.shape != test.shape:
        raise ValueError(f"test_ids: expected shape {reference.shape}, got {test.shape}")
    completion = background.run(lambda: _core.object_completion(reference.ravel(), test.ravel()))
    return (math.nan, math.nan) if completion is None else completion


def _mean_squared_error(pair: inputs.Pair, *, ranges: bool) -> tuple[float, float, float]:
    """Return the mean of the squared differences, and with `ranges` the least and greatest value of both pictures."""
    inputs.refuse_alpha(pair.reference.shape, "give numbers that are no colours as two axes")
    result = _core.mean_squared_errors(_rows(pair.reference), _rows(pair.test), ranges=ranges)[0]
    if not math.isfinite(result[0]):
        raise pair.non_finite_error()
    return result


def _rows(picture: NDArray[Any]) -> NDArray[Any]:
    """Reshape a picture of any shape to rows, without a copy if its values are contiguous."""
    if picture.ndim == 2:
        return picture
    plain = np.ascontiguousarray(picture)
    return plain.reshape(plain.shape[0], -1) if plain.ndim > 2 else plain.reshape(1, -1)
