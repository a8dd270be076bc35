"""How far a picture is from the truth, and how far it is broken."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _check, _core, _progress
from nearfar._camera import Camera
from nearfar._frame import Frame

WINDOWS = ("gaussian", "uniform", "global")

LUMA = (0.2126, 0.7152, 0.0722)
"""Rec. 709, of sRGB-encoded colour."""


def rmse(reference: ArrayLike | Frame, test: ArrayLike | Frame) -> float:
    """Root of the mean squared difference of two pictures.

    Parameters
    ----------
    reference, test
        Arrays of one shape, of any number type; or two frames, whose sRGB-encoded Rec. 709 luma in 0..1 is compared.

    Returns
    -------
    float
        In the pictures' units; 0 where they are equal. The same bits for any number of threads.

    Raises
    ------
    ValueError
        For other shapes, empty pictures, frames without colour, values that are not finite.
    TypeError
        For values that are not numbers, and for a frame beside an array.
    """
    first, second, _ = _pair(reference, test, None)
    return math.sqrt(_core.mean_squared_error(first.ravel(), second.ravel()))


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
    first, second, extent = _pair(reference, test, data_range)
    peak = _extent(extent)
    error = _core.mean_squared_error(first.ravel(), second.ravel())
    return math.inf if error == 0.0 else 20.0 * math.log10(peak) - 10.0 * math.log10(error)


def ssim(
    reference: ArrayLike | Frame,
    test: ArrayLike | Frame,
    *,
    data_range: float | None = None,
    window: str = "gaussian",
    size: int = 11,
    sigma: float = 1.5,
    k1: float = 0.01,
    k2: float = 0.03,
    mask: ArrayLike | None = None,
    full: bool = False,
) -> Any:
    """Structural similarity of two pictures.

    Parameters
    ----------
    reference, test
        (H, W) or (H, W, C) of one shape; channels are compared one by one and averaged. Or two frames, as in `rmse`.
    data_range
        As in `psnr`.
    window
        "gaussian", "uniform", or "global": one window over the whole picture.
    size
        Pixels across the window. An even one reaches a pixel further up and left.
    sigma
        Of the Gaussian, pixels.
    k1, k2
        Constants that keep the measure defined where means or variances vanish.
    mask
        (H, W), true for pixels whose similarity counts.
    full
        Whether the similarity around each pixel is returned as well.

    Returns
    -------
    float or (float, NDArray)
        The mean over pixels whose window lies within the picture (all pixels where none does), at most 1: 1 exactly for
        equal pictures, and the same in either order. With `full` also the map, (H, W) or (H, W, C) float64, for which
        pictures are mirrored at their borders. Against scikit-image (`use_sample_covariance=False`) the mean
        differs by less than 1e-12.

    Raises
    ------
    ValueError, TypeError
        As in `psnr`, and for windows, sizes and masks out of their domains.

    References
    ----------
    Wang, Bovik, Sheikh, Simoncelli (2004), Eq. 13.
    """
    first, second, extent = _pair(reference, test, data_range)
    if first.ndim not in (2, 3):
        raise ValueError(f"reference: expected shape (H, W) or (H, W, C), got {first.shape}")
    _check.choice("window", window, WINDOWS)
    taps = _check.integer("size", size, 1, 10_001)
    spread = _check.positive("sigma", sigma)
    constants = [(_check.positive(name, k) * _extent(extent)) ** 2 for name, k in (("k1", k1), ("k2", k2))]
    height, width = first.shape[:2]
    channels = first.reshape(height, width, -1)
    others = second.reshape(height, width, -1)
    maps = [
        _core.similarity(
            np.ascontiguousarray(channels[..., c]).ravel(),
            np.ascontiguousarray(others[..., c]).ravel(),
            width=width,
            window=window,
            size=taps,
            sigma=spread,
            constants=(constants[0], constants[1]),
        ).reshape(height, width)
        for c in range(channels.shape[2])
    ]
    counts = _counted((height, width), 1 if window == "global" else taps, mask)
    mean = float(np.mean([one[counts].mean() for one in maps]))
    if not full:
        return mean
    return mean, np.stack(maps, axis=-1).reshape(first.shape)


def discontinuity(
    frame: Frame, truth_camera: Camera | None = None, *, epsilon: float = 17.0, min_distance: float = 1.0
) -> NDArray[np.float32]:
    """How far each pixel's neighbours in the true picture are torn apart in this one.

    A pixel's scene point has a place in the truth. The pixels whose places there are within ε of it are its neighbours,
    and its discontinuity is the mean over them of their distance in this picture over their distance in the truth,
    less 1.

    Parameters
    ----------
    frame
        With `position`: the unmorphed scene point of each pixel. Far pixels of a reduced scene have it where the
        map was baked with range.
    truth_camera
        The view that the truth would be rendered from; by default the frame's own.
    epsilon
        Pixels of the truth, up to 10,000.
    min_distance
        Distances in the truth below this are raised to it: its resolution.

    Returns
    -------
    NDArray
        (H, W) float32: 0 where nothing is torn, 1 where neighbours are twice as far apart, negative where they
        are pushed together. NaN for pixels without a surface, behind the truth's camera, or without neighbours. For
        the truth itself it is 0 up to the rounding of positions.

    Raises
    ------
    ValueError, TypeError
        For frames without positions and arguments out of their domains.

    References
    ----------
    Popescu, Lee, Choi, Fahmy (2022), Eq. 5–6.
    """
    if not isinstance(frame, Frame):
        raise TypeError(f"frame: expected a Frame, got {type(frame).__name__}")
    camera = frame.camera if truth_camera is None else truth_camera
    if not isinstance(camera, Camera):
        raise TypeError(f"truth_camera: expected a Camera, got {type(camera).__name__}")
    position = np.ascontiguousarray(frame.require("position"), np.float32)
    with _progress.bar("measuring discontinuity") as report:
        flat = _core.discontinuity(
            position.reshape(-1, 3),
            origin=frame.origin,
            width=position.shape[1],
            camera=camera._core,
            epsilon=_check.positive("epsilon", epsilon),
            min_distance=_check.positive("min_distance", min_distance),
            report=report,
        )
    return flat.reshape(position.shape[:2])


def boundary(frame: Frame, *, center: ArrayLike, radius: float, width: int = 2) -> NDArray[np.bool_]:
    """Pixels along which the near part of a picture ends.

    Near pixels show points at ρ ≤ `radius` from the axis through the centre. They end at the radius, not at a
    silhouette, where a near pixel within 2 % of the radius has a neighbour that shows something beyond.

    Parameters
    ----------
    frame
        With `position`.
    center
        World position O, metres.
    radius
        Metres: r2 of the reduction.
    width
        Pixels to both sides that count as along it.

    Returns
    -------
    NDArray
        (H, W) bool.

    Raises
    ------
    ValueError, TypeError
        For frames without positions and arguments out of their domains.
    """
    if not isinstance(frame, Frame):
        raise TypeError(f"frame: expected a Frame, got {type(frame).__name__}")
    middle, end = np.array(_check.vector("center", center)), _check.positive("radius", radius)
    reach = _check.integer("width", width, 1, 1000)
    away = frame.require("position").astype(np.float64) + np.array(frame.origin) - middle
    rho = np.hypot(away[..., 0], away[..., 2])
    beyond = rho > end
    edge = np.zeros(beyond.shape, bool)
    for axis in (0, 1):
        first = (slice(None),) * axis + (slice(None, -1),)
        second = (slice(None),) * axis + (slice(1, None),)
        for one, other in ((first, second), (second, first)):
            edge[one] |= (rho[one] <= end) & (rho[one] >= 0.98 * end) & beyond[other]
    for _ in range(reach):
        grown = edge.copy()
        grown[1:] |= edge[:-1]
        grown[:-1] |= edge[1:]
        grown[:, 1:] |= edge[:, :-1]
        grown[:, :-1] |= edge[:, 1:]
        edge = grown
    return edge


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
    reference = _check.array("reference_ids", reference_ids, columns=None, dtype=np.int32)
    test = _check.array("test_ids", test_ids, columns=None, dtype=np.int32)
    if reference.shape != test.shape:
        raise ValueError(f"test_ids: expected shape {reference.shape}, got {test.shape}")
    found = _core.object_completion(reference.ravel(), test.ravel())
    return (math.nan, math.nan) if found is None else found


def _pair(
    reference: ArrayLike | Frame, test: ArrayLike | Frame, data_range: float | None
) -> tuple[NDArray[np.float64], NDArray[np.float64], float | None]:
    """Both pictures as float64 of one shape, and their range where it is known."""
    if isinstance(reference, Frame) and isinstance(test, Frame):
        first, second = _luma(reference), _luma(test)
        data_range = 1.0 if data_range is None else data_range
    elif isinstance(reference, Frame) or isinstance(test, Frame):
        raise TypeError("test: expected two frames or two arrays, got one of each")
    else:
        first, second = (
            _check.array(name, value, columns=None, finite=True).astype(np.float64)
            for name, value in (("reference", reference), ("test", test))
        )
    if first.shape != second.shape or not first.size:
        raise ValueError(f"test: expected shape {first.shape} with at least one value, got {second.shape}")
    return first, second, data_range


def _extent(data_range: float | None) -> float:
    if data_range is None:
        raise ValueError("data_range: expected the range of the pictures' values, such as 255 for 8 bits, got None")
    return _check.positive("data_range", data_range)


def _luma(frame: Frame) -> NDArray[np.float64]:
    """Rec. 709 luma of the sRGB-encoded colour."""
    linear = np.clip(frame.require("color").astype(np.float64), 0.0, 1.0)
    encoded = np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1.0 / 2.4) - 0.055)
    return np.asarray(encoded @ np.array(LUMA))


def _counted(shape: tuple[int, int], size: int, mask: ArrayLike | None) -> NDArray[np.bool_]:
    """Pixels whose similarity counts: their window lies within the picture, and the mask wants them."""
    before, after = size // 2, size - 1 - size // 2
    rows, columns = (slice(before, length - after) for length in shape)
    inside = np.zeros(shape, bool)
    inside[rows, columns] = True
    if not inside.any():
        inside[:] = True
    if mask is None:
        return inside
    wanted = np.asarray(mask)
    if wanted.shape != shape:
        raise ValueError(f"mask: expected shape {shape}, got {wanted.shape}")
    counted: NDArray[np.bool_] = inside & wanted.astype(bool)
    if not counted.any():
        raise ValueError("mask: expected at least one pixel whose window lies within the picture, got none")
    return counted
