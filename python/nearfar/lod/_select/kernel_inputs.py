"""Converts models, cameras and gaze to arguments of the selection kernel."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import check
from nearfar._camera.camera import Camera, Fov
from nearfar._camera.rotation import rotation
from nearfar._lens.lens import RadialLens
from nearfar.lod._measure.fit import Curve4PL
from nearfar.lod._measured_levels import MeasuredLevels
from nearfar.lod._select.size import pixel_area

MIN_SIGHT_LENGTH = 1e-6
"""Least length of the mean of several eyes' unit lines of sight. Below it they look in opposite directions."""

Quad = tuple[float, float, float, float]
Eye = tuple[tuple[float, float, float], Quad, Quad, tuple[float, float, float] | None, float, float]
"""Position, orientation, tangents (left, right, down, up), gaze, and the size of a pixel on the axis: degrees,
tangent."""


def whole_numbers(name: str, value: ArrayLike, dtype: type[np.integer], count: int) -> NDArray[Any]:
    """Check integers (N,), one for each object."""
    numbers = check.array(name, value, columns=None, dtype=dtype)
    if numbers.shape != (count,):
        raise ValueError(f"{name}: expected shape ({count},), got {numbers.shape}")
    return numbers


def models_of(
    models: Sequence[MeasuredLevels] | Mapping[str, MeasuredLevels], model_index: ArrayLike
) -> tuple[Sequence[MeasuredLevels], ArrayLike]:
    """Convert a mapping of models to a list in its order, and names in `model_index` to indices into it.

    Models in a sequence, and indices of other types, are returned unchanged.
    """
    if not isinstance(models, Mapping):
        return models, model_index
    number_of = {name: number for number, name in enumerate(check.mapping("models", models, "LodModels by name"))}
    listed, index = list(models.values()), check.plain("model_index", model_index)
    # Strings of fixed and of variable length, and objects, which may be strings.
    if index.dtype.kind not in "UTO" or not all(isinstance(name, str) for name in index.flat):
        return listed, model_index
    model_names: list[str] = index.ravel().tolist()
    unknown = [name for name in model_names if name not in number_of]
    if unknown:
        known_names = check.shortened(list(number_of))
        raise ValueError(f"model_index: expected names of models, {known_names}, got {check.shortened(unknown[0])}")
    return listed, np.array([number_of[name] for name in model_names], np.int64).reshape(index.shape)


def curves_of(
    models: Sequence[MeasuredLevels], curves: Sequence[Curve4PL]
) -> tuple[NDArray[np.float64], NDArray[np.int64], NDArray[np.float64]]:
    """Return the curves of all models (C, 4), the indices of the models' first curves, and their sizes.

    The indices (M + 1,) end with C. The sizes (M, 3) are the least and greatest measured size, and the pixel or NaN.
    """
    rows = [each.rows for each in curves]
    firsts = np.cumsum([0, *map(len, rows)], dtype=np.int64)
    measured = [(*model.sigma, math.nan if model.pixel is None else model.pixel) for model in models]
    return np.concatenate([np.empty((0, 4)), *rows]), firsts, np.array(measured, np.float64).reshape(-1, 3)


def cameras_of(camera: Camera | Sequence[Camera]) -> tuple[Camera, ...]:
    """Check one camera or several, each with a `Fov`."""
    cameras = (camera,) if isinstance(camera, Camera) else tuple(camera) if isinstance(camera, Sequence) else (camera,)
    if not cameras:
        raise ValueError("camera: expected at least one, got none")
    for each in cameras:
        _fov_of(check.instance("camera", each, Camera, "a Camera or a sequence of them"))
    return cameras


def gaze_of(cameras: tuple[Camera, ...], gaze: ArrayLike | None) -> tuple[float, float, float]:
    """Direction of the gaze; by default the mean of the cameras' lines of sight, since a headset's may be canted."""
    if gaze is None:
        sight = np.sum([rotation(camera.orientation) @ (0.0, 0.0, -1.0) for camera in cameras], axis=0)
        if np.linalg.norm(sight) < MIN_SIGHT_LENGTH * len(cameras):
            raise ValueError("gaze: expected a direction for cameras that look in opposite ones, got None")
        return (float(sight[0]), float(sight[1]), float(sight[2]))
    direction = check.vector("gaze", gaze)
    if not any(direction):
        raise ValueError("gaze: expected a direction, got (0, 0, 0)")
    return direction


def eye_of(camera: Camera, gaze: tuple[float, float, float] | None, panel: tuple[RadialLens, float] | None) -> Eye:
    """Convert a camera to arguments of the kernel. Its pixel is one on the axis, where pixels span the most degrees.

    `panel` is the lens and its tan ω if the camera's pixels are those of the panel behind the lens. A side t of the
    view is then at the tangent tan ω f⁻¹(t / tan ω) of the panel.
    """
    fov = _fov_of(camera)
    pitch = max((fov.right - fov.left) / camera.width, (fov.up - fov.down) / camera.height)
    sides = fov._sides if panel is None else on_panel(fov, *panel)
    pixel = math.sqrt(pixel_area(sides, camera.size))
    return camera.position, camera.orientation, fov._sides, gaze, math.degrees(math.atan(pitch)), pixel


def on_panel(fov: Fov, lens: RadialLens, tan_omega: float) -> Quad:
    """Sides of the part of the panel that shows a view, which ends at the lens's fold."""
    radii = lens.undistort(np.array(fov._sides) / tan_omega, outside="nan")
    left, right, down, up = tan_omega * np.where(np.isnan(radii), np.copysign(lens.r_max, fov._sides), radii)
    return left, right, down, up


def _fov_of(camera: Camera) -> Fov:
    return check.instance("camera", camera.fov, Fov, "one with a Fov")


def weights_for(weight: ArrayLike, count: int) -> dict[str, Any]:
    """Kernel arguments for the weights of `count` objects, as `LodRules` has them."""
    if not isinstance(weight, np.ndarray):
        return {"by_pixels": weight == "pixels", "weight": None}
    if weight.shape != (count,):
        raise ValueError(f"weight: expected shape ({count},), one for each object, got {weight.shape}")
    return {"by_pixels": False, "weight": weight}
