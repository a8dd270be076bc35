"""How levels are chosen: settings, checked once, and the call of the kernel."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check
from nearfar._camera.camera import Camera, Fov
from nearfar._lens.lens import RadialLens
from nearfar.hmd._eye import rotation
from nearfar.lod._measured_levels import MeasuredLevels
from nearfar.lod._select.selection import COLUMNS, Selection
from nearfar.lod._select.size import (
    ACUITY_LIMIT_DEG,
    ACUITY_SLOPE,
    at_least_zero,
    checked_lens,
    reference_solid_angle,
    widest,
)

MODES = ("off", "depth", "depth+eccentricity", "fovea")
THRESHOLDS = ("anchored", "literal", "normalized")
INVERSES = ("lut", "newton")
_COUNTS = ("culled", "one_level", "settled", "large", "asked", "lens", "table", "formula")

_ROWS: WeakKeyDictionary[MeasuredLevels, NDArray[np.float64]] = WeakKeyDictionary()
"""Parameters of each model's curves, so that a frame does not collect them again."""


@dataclass(frozen=True, kw_only=True)
class Selector:
    """How levels are chosen: the settings of `select`, which says what each is, for use in frame after frame.

    Raises
    ------
    ValueError, TypeError
        For settings that are out of order.
    """

    k: float = 0.27
    d: float = 0.90
    threshold: str = "anchored"
    mode: str = "depth+eccentricity"
    lens: RadialLens | None = None
    lens_radius: float | None = None
    reference: float | None = None
    cull: bool = True
    hysteresis: float = 0.0
    fade: float = 0.0
    acuity_slope: float = ACUITY_SLOPE
    acuity_limit_deg: float = ACUITY_LIMIT_DEG
    inverse: str = "lut"

    def __post_init__(self) -> None:
        for name in ("k", "d"):
            object.__setattr__(self, name, check.number(name, getattr(self, name)))
        check.choice("threshold", self.threshold, THRESHOLDS)
        check.choice("mode", self.mode, MODES)
        check.choice("inverse", self.inverse, INVERSES)
        if self.lens is not None:
            checked_lens(self.lens, Fov(-1, 1, -1, 1), self.lens_radius)
        for name in ("lens_radius", "reference"):
            if getattr(self, name) is not None:
                object.__setattr__(self, name, check.positive(name, getattr(self, name)))
        for name in ("hysteresis", "fade"):
            share = check.number(name, getattr(self, name))
            if not 0 <= share <= 1:
                raise ValueError(f"{name}: expected a number from 0 to 1, got {share}")
            object.__setattr__(self, name, share)
        object.__setattr__(self, "cull", bool(self.cull))
        object.__setattr__(self, "acuity_slope", at_least_zero("acuity_slope", self.acuity_slope))
        limit = check.positive("acuity_limit_deg", self.acuity_limit_deg)
        object.__setattr__(self, "acuity_limit_deg", limit)

    def select(
        self,
        models: Sequence[MeasuredLevels],
        model_index: ArrayLike,
        centers: ArrayLike,
        radii: ArrayLike,
        *,
        camera: Camera | Sequence[Camera],
        previous: ArrayLike | None = None,
        gaze: ArrayLike | None = None,
        full: bool = False,
    ) -> Selection:
        """Choose a level for each object; arguments, results and errors are those of `nearfar.lod.select`."""
        curves, firsts, ranges = _collected(models)
        places, sizes = check.spheres(centers, radii)
        index = _column("model_index", model_index, np.int64, len(places))
        before = None if previous is None else _column("previous", previous, np.int32, len(places))
        eyes = _eyes(camera)
        wide = widest(eyes)
        reference = reference_solid_angle(wide) if self.reference is None else self.reference
        line = (self.d, self.k)
        if self.threshold != "literal":
            slope = self.k / reference if self.threshold == "normalized" else self.k
            line = (self.d - slope * reference, slope)
        is_lens_used = self.mode in ("depth+eccentricity", "fovea") and self.lens is not None and any(self.lens.k)
        tan_omega = 1.0 if self.lens is None else checked_lens(self.lens, wide, self.lens_radius)
        is_fovea = self.mode == "fovea"
        look = _gaze(eyes, gaze) if is_fovea or gaze is not None else None
        level, columns, counts = _core.select_levels(
            (curves, firsts, ranges),
            index,
            places,
            sizes,
            previous=before,
            eyes=[_eye(eye, look) for eye in eyes],
            line=line,
            reference=reference,
            off=self.mode == "off",
            cull=self.cull,
            lens=self.lens._core if self.lens is not None and is_lens_used else None,
            tan_omega=tan_omega,
            exact=self.inverse == "newton",
            acuity=(self.acuity_slope, self.acuity_limit_deg) if is_fovea else None,
            hysteresis=self.hysteresis,
            fade=self.fade,
            full=bool(full),
        )
        return Selection(
            level=level,
            counts=dict(zip(_COUNTS, counts, strict=True)),
            columns=dict(zip(COLUMNS, columns, strict=True)) if full else {},
        )


def _column(name: str, value: ArrayLike, dtype: type[np.integer], count: int) -> NDArray[Any]:
    """(N,) whole numbers."""
    numbers = check.array(name, value, columns=None, dtype=dtype)
    if numbers.shape != (count,):
        raise ValueError(f"{name}: expected shape ({count},), got {numbers.shape}")
    return numbers


def _rows(model: MeasuredLevels) -> NDArray[np.float64]:
    """a, b, c and d of each level's curve but level 0's, (K − 1, 4); NaN where there is none."""
    rows = _ROWS.get(model)
    if rows is None:
        count = len(model) - 1
        rows = np.empty((0, 4))
        if count > 0:
            rows = np.column_stack([np.atleast_1d(np.asarray(part, np.float64)) for part in model.curves])
        if len(rows) != max(count, 0):
            raise ValueError(f"models: expected {count} curves in {model.name!r}, got {len(rows)}")
        _ROWS[model] = rows
    return rows


def _collected(
    models: Sequence[MeasuredLevels],
) -> tuple[NDArray[np.float64], NDArray[np.int64], NDArray[np.float64]]:
    """Curves of all models, where each model's start, and the sizes between which they were measured."""
    if isinstance(models, MeasuredLevels) or not isinstance(models, Sequence):
        raise TypeError(f"models: expected a sequence of LodModel, got {type(models).__name__}")
    for number, model in enumerate(models):
        if not isinstance(model, MeasuredLevels):
            raise TypeError(f"models: expected a LodModel at index {number}, got {type(model).__name__}")
    rows = [_rows(model) for model in models]
    firsts = np.zeros(len(rows) + 1, np.int64)
    np.cumsum([len(part) for part in rows], out=firsts[1:])
    ranges = np.array([model.sigma for model in models], np.float64).reshape(-1, 2)
    return np.concatenate([np.empty((0, 4)), *rows]), firsts, ranges


def _eyes(camera: Camera | Sequence[Camera]) -> tuple[Camera, ...]:
    eyes = (camera,) if isinstance(camera, Camera) else tuple(camera) if isinstance(camera, Sequence) else (camera,)
    if not eyes:
        raise ValueError("camera: expected at least one, got none")
    for eye in eyes:
        if not isinstance(eye, Camera):
            raise TypeError(f"camera: expected a Camera or a sequence of them, got {type(eye).__name__}")
        if not isinstance(eye.fov, Fov):
            raise TypeError(f"camera: expected one with a Fov, got {type(eye.fov).__name__}")
    return eyes


_Eye = tuple[
    tuple[float, float, float],
    tuple[float, float, float, float],
    tuple[float, float, float, float],
    tuple[float, float, float] | None,
    float,
]


def _gaze(eyes: tuple[Camera, ...], gaze: ArrayLike | None) -> tuple[float, float, float]:
    """What is looked at: the mean of the eyes' lines of sight where nobody says, because eyes may be canted."""
    if gaze is None:
        way = np.sum([rotation(eye.orientation) @ (0.0, 0.0, -1.0) for eye in eyes], axis=0)
        if np.linalg.norm(way) < 1e-6 * len(eyes):
            raise ValueError("gaze: expected a direction for cameras that look in opposite ones, got None")
        return (float(way[0]), float(way[1]), float(way[2]))
    look = check.vector("gaze", gaze)
    if not any(look):
        raise ValueError("gaze: expected a direction, got (0, 0, 0)")
    return look


def _eye(camera: Camera, look: tuple[float, float, float] | None) -> _Eye:
    """Position, orientation, tangents, gaze, and degrees of a pixel on the axis, where they are largest."""
    fov = camera.fov
    if not isinstance(fov, Fov):
        raise TypeError(f"camera: expected one with a Fov, got {type(fov).__name__}")
    pitch = max((fov.right - fov.left) / camera.width, (fov.up - fov.down) / camera.height)
    bounds = (fov.left, fov.right, fov.down, fov.up)
    return camera.position, camera.orientation, bounds, look, math.degrees(math.atan(pitch))
