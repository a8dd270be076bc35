"""Kernels on the graphics device: of frames that it holds, and of arrays that are sent to it."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check, progress
from nearfar._camera.camera import Camera
from nearfar._metrics.result import Similarity
from nearfar._morph import KINDS, radii_of
from nearfar._render import backend as backends
from nearfar.gpu._frames import DeviceFrame

WINDOWS = ("gaussian", "uniform")

LARGEST = 17
"""Pixels across a window: what fits into the memory of a group of shaders."""

FILTERS = ("nearest", "min", "max")


def ssim(
    reference: DeviceFrame,
    test: DeviceFrame,
    *,
    window: str = "gaussian",
    size: int = 11,
    sigma: float = 1.5,
    full: bool = False,
) -> Similarity:
    """Structural similarity of two frames on one device: as `nearfar.ssim` of the same frames read back.

    Parameters
    ----------
    reference, test
        With `color`, of one size. Rec. 709 luma of the sRGB-encoded colour is compared, with a range of 1.
    window
        "gaussian" or "uniform".
    size
        Pixels across the window, 1 to 17. An even one reaches a pixel further up and left.
    sigma
        Of the Gaussian, pixels.
    full
        Whether the similarity around each pixel is returned as well.

    Returns
    -------
    Similarity
        The mean, a float of at most 1: 1 exactly for equal pictures, and the same bits whenever it is taken on one
        device. Where no window lies within the picture, all count. With `full` its `map`, (H, W) float32. Both are
        computed in float32 about local means; the mean differs from float64's by less than 1e-6, the map by less than
        2e-5.

    Raises
    ------
    ValueError, TypeError
        For frames without colour, of two sizes or on two devices, and for windows out of their domains.
    DeviceError
        Where the device was lost or has no memory left.

    References
    ----------
    Wang, Bovik, Sheikh, Simoncelli (2004), Eq. 13.
    """
    check.choice("window", window, WINDOWS)
    taps, deviation = check.integer("size", size, 1, LARGEST), check.positive("sigma", sigma)
    for name, frame in (("reference", reference), ("test", test)):
        _frame(name, frame).require("color")
    settings: dict[str, Any] = {"window": window, "size": taps, "sigma": deviation}
    mean, flat = _core.gpu_similarity(reference._core, test._core, **settings, full=bool(full))
    width, height = reference.camera.size
    return Similarity(mean, None if flat is None else flat.reshape(height, width))


def discontinuity(
    frame: DeviceFrame,
    truth_camera: Camera | None = None,
    *,
    epsilon: float = 17.0,
    min_distance: float = 1.0,
) -> NDArray[np.float32]:
    """How far each pixel's neighbours in the true picture are torn apart: as `nearfar.discontinuity`, on the device.

    Parameters
    ----------
    frame
        With `position`.
    truth_camera, epsilon, min_distance
        As in `nearfar.discontinuity`.

    Returns
    -------
    NDArray
        (H, W) float32, NaN where `nearfar.discontinuity` gives it. Places in the truth are computed in float32, whose
        rounding is some 1e-7 of the picture's width, and pairs whose distance is ε but for that may count or not:
        values differ by less than 1e-3 (1 + |δ|) from those of `nearfar.discontinuity` where points have hundreds of
        neighbours, and more where they have few. Places more than 10⁵ pixels beside the picture are rounded to pixels.

    Raises
    ------
    ValueError, TypeError
        For frames without positions and arguments out of their domains.
    DeviceError
        Where the device was lost or has no memory left.

    References
    ----------
    Popescu, Lee, Choi, Fahmy (2022), Eq. 5–6.
    """
    _frame("frame", frame).require("position")
    camera = frame.camera if truth_camera is None else truth_camera
    if not isinstance(camera, Camera):
        raise TypeError(f"truth_camera: expected a Camera, got {type(camera).__name__}")
    with progress.bar("measuring discontinuity") as report:
        flat = _core.gpu_discontinuity(
            frame._core,
            camera=camera._core,
            epsilon=check.positive("epsilon", epsilon),
            min_distance=check.positive("min_distance", min_distance),
            report=report,
        )
    width, height = frame.camera.size
    return flat.reshape(height, width)


def morph(
    points: ArrayLike, *, user: ArrayLike, center: ArrayLike, r1: float, r2: float, kind: str = "blend"
) -> NDArray[np.float32]:
    """Show points where a continuous near–far partition shows them: as `nearfar.morph`, on the device.

    Parameters
    ----------
    points
        (N, 3) float32, metres. A point with NaN gives NaN.
    user, center, r1, r2, kind
        As in `nearfar.morph`.

    Returns
    -------
    NDArray
        (N, 3) float32. A "blend" coordinate is off by a float32 step of the result and
        2⁻²⁴ (16 + 8 r2/(r2−r1)) |U−O| at most, where U is within half of r1 from the axis; a "cylinder" one by
        2⁻²⁴ · 32 (|P−O| + |U−O|) ρ/(ρ−|U−O|) besides. Directions count as opposed a little earlier than there.

    Raises
    ------
    ValueError, TypeError
        As `nearfar.morph`, and TypeError for numbers other than float32.
    DeviceError
        Where the device was lost or has no memory left.

    References
    ----------
    Popescu, Lee, Choi, Fahmy (2022), Eq. 1–3; CloVR (2024), Alg. 1.
    """
    check.choice("kind", kind, KINDS)
    near, far = radii_of(r1, r2, kind)
    given = _single("points", points, "nearfar.morph")
    rows = check.array("points", given)
    shown = np.empty_like(rows)
    place = {"user": check.vector("user", user), "center": check.vector("center", center)}
    _core.gpu_morph(backends.opened(), rows, shown, **place, r1=near, r2=far, kind=kind)
    return shown


def cube_lookup(
    faces: ArrayLike,
    directions: ArrayLike,
    *,
    filter: str = "nearest",  # noqa: A002
) -> NDArray[np.float32]:
    """Values of a cube map along directions: as `nearfar.cube_lookup`, on the device.

    Parameters
    ----------
    faces
        (6, S, S) or (6, S, S, C) float32, as there.
    directions
        (..., 3) float32, of any length.
    filter
        "nearest", "min" or "max", as there. Directions are placed in float32: within 4e-7 of a face's width from the
        border between two texels, or between two sets of texels, the other one may be taken.

    Returns
    -------
    NDArray
        (...) or (..., C) float32.

    Raises
    ------
    ValueError, TypeError
        As `nearfar.cube_lookup`, and TypeError for numbers other than float32.
    DeviceError
        For faces that are too large to be read at a time, and where the device was lost or has no memory left.
    """
    check.choice("filter", filter, FILTERS)
    maps = np.require(_single("faces", faces, "nearfar.cube_lookup"), None, ["C", "A"])
    if maps.ndim not in (3, 4) or maps.shape[0] != 6 or maps.shape[1] != maps.shape[2] or maps.shape[1] == 0:
        raise ValueError(f"faces: expected shape (6, S, S) or (6, S, S, C), got {maps.shape}")
    along = np.require(_single("directions", directions, "nearfar.cube_lookup"), None, ["C", "A"])
    if along.ndim == 0 or along.shape[-1] != 3:
        raise ValueError(f"directions: expected shape (..., 3), got {along.shape}")
    rows, deep = along.reshape(-1, 3), maps.reshape(*maps.shape[:3], -1) if maps.ndim == 4 else maps[..., None]
    values = np.empty((len(rows), deep.shape[3]), np.float32)
    _core.gpu_cube_lookup(backends.opened(), (np.ascontiguousarray(deep), values), rows, filter)
    return values.reshape(along.shape[:-1] + maps.shape[3:])


def _frame(name: str, frame: DeviceFrame) -> DeviceFrame:
    if not isinstance(frame, DeviceFrame):
        raise TypeError(f"{name}: expected a DeviceFrame, got {type(frame).__name__}")
    return frame


def _single(name: str, values: ArrayLike, other: str) -> NDArray[Any]:
    """An array of float32 in native byte order; others would lose digits or take twice the way."""
    given = check.plain(name, values)
    if given.dtype.newbyteorder("=") != np.float32:
        raise TypeError(f"{name}: expected float32, got {given.dtype}; {other} takes other numbers")
    return given.astype(np.float32, copy=False)
