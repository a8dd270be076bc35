"""Kernels on the graphics device: metrics of frames in its memory; morph and cube-map look-up of uploaded arrays."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check, progress
from nearfar._camera.camera import Camera
from nearfar._cubemap.lookup import channel_rows, directions_of
from nearfar._morph import kernel_arguments
from nearfar._render import backend as backends
from nearfar.gpu._frames import DeviceFrame
from nearfar.metrics._discontinuity import EPSILON, truth_view
from nearfar.metrics._window import Similarity

WINDOWS = ("gaussian", "uniform")
"""Windows of `ssim` on the device."""

LARGEST = 17
"""Maximum width of a window in pixels, limited by the memory of a shader workgroup."""

FILTERS = ("nearest", "min", "max")
"""Filters of `cube_lookup` on the device."""


def ssim(
    reference: DeviceFrame,
    test: DeviceFrame,
    *,
    window: str = "gaussian",
    size: int = 11,
    sigma: float = 1.5,
    full: bool = False,
) -> Similarity:
    """Compute the structural similarity of two frames on one device, as `nearfar.ssim` does for frames read back.

    ValueError and TypeError for frames without colour, of different sizes or on different devices, and windows out of
    range; DeviceError if the device was lost or has no memory left. Source: Wang, Bovik, Sheikh, Simoncelli (2004),
    Eq. 13.

    Parameters
    ----------
    reference, test
        Frames of one size with `color`. Rec. 709 luma of the sRGB-encoded colour is compared, with a data range of 1.
    window
        "gaussian" or "uniform".
    size
        Width and height of the window in pixels, 1 to 17. An even window extends one pixel further up and left.
    sigma
        Standard deviation of the Gaussian, pixels.
    full
        Whether to return the similarity around each pixel as well.

    Returns
    -------
    Similarity
        The mean, a float of at most 1; exactly 1 for equal pictures, and the same bits in every run on one device. With
        `full` its `map`, (H, W) float32. Both are computed in float32 about local means; they differ from float64's
        results by less than 1e-6 (mean) and 2e-5 (map).
    """
    check.choice("window", window, WINDOWS)
    taps, deviation = check.integer("size", size, 1, LARGEST), check.positive("sigma", sigma)
    for name, frame in (("reference", reference), ("test", test)):
        check.instance(name, frame, DeviceFrame).require("color")
    full = check.flag("full", full)
    cores = reference._core, test._core
    mean, values = _core.gpu_similarity(*cores, window=window, size=taps, sigma=deviation, full=full)
    width, height = reference.camera.size
    return Similarity(mean, None if values is None else values.reshape(height, width))


def discontinuity(
    frame: DeviceFrame, truth_camera: Camera | None = None, *, epsilon: float = EPSILON, min_distance: float = 1.0
) -> NDArray[np.float32]:
    """Measure the discontinuity of a frame on the device as `nearfar.metrics.discontinuity` does for a frame in memory.

    ValueError and TypeError for frames without positions, a `truth_camera` of another size, and arguments out of range;
    DeviceError if the device was lost or has no memory left. Source: Popescu, Lee, Choi, Fahmy (2022), Eq. 5–6.

    The arguments are those of `nearfar.metrics.discontinuity`; the frame has `position`. Returns the discontinuity δ,
    (H, W) float32, with NaN at the same pixels. Positions in the truth are rounded to float32, about 1e-7 of the
    picture's width, so that a pair whose distance is close to ε may count or not. For points with hundreds of
    neighbours, δ differs from the result in memory by less than 1e-3 (1 + |δ|); for points with few neighbours by more.
    Positions more than 10⁵ pixels outside the picture are rounded to whole pixels.
    """
    check.instance("frame", frame, DeviceFrame).require("position")
    camera = truth_view(frame.camera, truth_camera)
    with progress.bar("measuring discontinuity") as report:
        values = _core.gpu_discontinuity(
            frame._core,
            camera=camera._core,
            epsilon=check.positive("epsilon", epsilon),
            min_distance=check.positive("min_distance", min_distance),
            report=report,
        )
    width, height = frame.camera.size
    return values.reshape(height, width)


def morph(
    points: ArrayLike,
    *,
    user: ArrayLike,
    center: ArrayLike,
    r1: float,
    r2: float,
    kind: str = "blend",
    strength: float = 1.0,
) -> NDArray[np.float32]:
    """Move points P (N, 3) float32, metres, on the device; all other arguments are those of `nearfar.morph`.

    A point with NaN gives NaN. Errors as in `nearfar.morph`; TypeError for numbers other than float32, DeviceError if
    the device was lost or has no memory left. Sources: Popescu, Lee, Choi, Fahmy (2022), Eq. 1–3; CloVR (2024), Alg. 1.

    Returns
    -------
    NDArray
        (N, 3) float32. If U is within r1/2 of the axis, the error of a "blend" coordinate is at most one float32 step
        of the result plus 2⁻²⁴ (16 + 8 r2/(r2−r1)) |U−O|. A "cylinder" coordinate has the additional error
        2⁻²⁴ · 32 (|P−O| + |U−O|) ρ/(ρ−|U−O|), where ρ is the distance of P from the axis. Directions count as opposite
        slightly earlier than in `nearfar.morph`. Below full strength these bounds hold for points at least |U−O| away
        from U and O.
    """
    arguments = kernel_arguments(user, center, r1, r2, kind, strength)
    rows = check.array("points", _single("points", points, "nearfar.morph"))
    morphed = np.empty_like(rows)
    _core.gpu_morph(backends.open_device(), rows, morphed, arguments)
    return morphed


def cube_lookup(faces: ArrayLike, directions: ArrayLike, *, filter: str = "nearest") -> NDArray[np.float32]:  # noqa: A002
    """Look up values of a cube map along directions, as `nearfar.cube_lookup` does, on the device.

    Arguments, results and errors are those of `nearfar.cube_lookup`, but all arrays are float32, and `filter` is
    "nearest", "min" or "max". Positions on a face are computed in float32, so that within 4e-7 of a face's width from
    the border between texels the neighbouring texel (or set of texels) may be used. TypeError for numbers other than
    float32, DeviceError for faces larger than a kernel can read at a time, and if the device was lost or has no memory
    left.
    """
    check.choice("filter", filter, FILTERS)
    maps = _single("faces", faces, "nearfar.cube_lookup")
    texels = channel_rows(maps)
    rows, shape = directions_of(_single("directions", directions, "nearfar.cube_lookup"))
    values = np.empty((len(rows), texels.shape[3]), np.float32)
    _core.gpu_cube_lookup(backends.open_device(), (texels, values), rows, filter)
    return values.reshape(shape + maps.shape[3:])


def _single(name: str, values: ArrayLike, alternative: str) -> NDArray[Any]:
    """Return a float32 array in native byte order; TypeError for other types, because conversion could lose digits."""
    array = check.plain(name, values)
    if array.dtype.newbyteorder("=") != np.float32:
        raise TypeError(f"{name}: expected float32, got {array.dtype}; {alternative} takes other numbers")
    return array.astype(np.float32, copy=False)
