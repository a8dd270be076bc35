"""Settings of selection, checked once, and the kernel call."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check
from nearfar._camera.camera import Camera, Fov
from nearfar._lens.lens import RadialLens
from nearfar.lod._measured_levels import MeasuredLevels
from nearfar.lod._select.budget import MAX_TRIANGLES, Spent, check_budget, triangles_of, weight_of, weights_for
from nearfar.lod._select.kernel_inputs import cameras_of, curves_of, eye_of, gaze_of, models_of, whole_numbers
from nearfar.lod._select.selection import COLUMNS, Selection
from nearfar.lod._select.size import ACUITY_LIMIT_DEG, ACUITY_SLOPE, checked_lens, reference_solid_angle, widest
from nearfar.lod._select.threshold import LodThreshold, threshold_of

MODES = ("off", "depth", "depth+eccentricity", "fovea", "panel")
SIZES = ("axis", "area")
LIMITS = ("seen", "own")
INVERSES = ("lut", "newton")

_COUNTS = ("culled", "one_level", "settled", "large", "asked", "lens", "table", "formula")
"""Keys of `Selection.counts`, in the kernel's order."""


@dataclass(frozen=True, kw_only=True, init=False, eq=False)
class Selector:
    """Settings of `select`, which documents them, for use over many frames.

    k and d are stored in `threshold`, a `LodThreshold`.

    Raises
    ------
    ValueError, TypeError
        Invalid settings.
    """

    threshold: LodThreshold
    mode: str
    size: str
    limit: str
    lens: RadialLens | None
    lens_radius: float | None
    reference: float | None
    cull: bool
    hysteresis: float
    fade: float
    acuity_slope: float
    acuity_limit_deg: float
    inverse: str
    budget: int | None
    weight: str | NDArray[np.float64]
    floor: float | None

    def __init__(
        self,
        *,
        k: float | None = None,
        d: float | None = None,
        threshold: LodThreshold | str | None = None,
        mode: str = "depth+eccentricity",
        size: str = "axis",
        limit: str = "seen",
        lens: RadialLens | None = None,
        lens_radius: float | None = None,
        reference: float | None = None,
        cull: bool = True,
        hysteresis: float = 0.0,
        fade: float = 0.0,
        acuity_slope: float = ACUITY_SLOPE,
        acuity_limit_deg: float = ACUITY_LIMIT_DEG,
        inverse: str = "lut",
        budget: int | None = None,
        weight: str | ArrayLike = "object",
        floor: float | None = None,
    ) -> None:
        if lens is not None:
            checked_lens(lens, Fov(-1, 1, -1, 1), lens_radius)
        checked: dict[str, Any] = {
            "threshold": threshold_of(threshold, k, d),
            "mode": check.choice("mode", mode, MODES),
            "size": check.choice("size", size, SIZES),
            "limit": check.choice("limit", limit, LIMITS),
            "lens": lens,
            "lens_radius": None if lens_radius is None else check.positive("lens_radius", lens_radius),
            "reference": None if reference is None else check.positive("reference", reference),
            "cull": check.flag("cull", cull),
            "hysteresis": check.in_range("hysteresis", hysteresis, 0.0, 1.0),
            "fade": check.in_range("fade", fade, 0.0, 1.0),
            "acuity_slope": check.at_least_zero("acuity_slope", acuity_slope),
            "acuity_limit_deg": check.positive("acuity_limit_deg", acuity_limit_deg),
            "inverse": check.choice("inverse", inverse, INVERSES),
            "budget": None if budget is None else check.integer("budget", budget, 0, MAX_TRIANGLES),
            "weight": weight_of(weight),
            "floor": None if floor is None else check.at_least_zero("floor", floor),
        }
        check_budget(budget, checked["weight"], checked["floor"], mode=mode, fade=checked["fade"])
        for name, value in checked.items():
            object.__setattr__(self, name, value)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Selector) and self._content == other._content

    def __hash__(self) -> int:
        return hash(self._content)

    @property
    def _content(self) -> tuple[Any, ...]:
        """Values of all fields, arrays of weights as bytes."""
        values = (getattr(self, field.name) for field in fields(self))
        return tuple(value.tobytes() if isinstance(value, np.ndarray) else value for value in values)

    @property
    def k(self) -> float:
        """Rise of the threshold."""
        return self.threshold.k

    @property
    def d(self) -> float:
        """Start of the threshold."""
        return self.threshold.d

    def select(
        self,
        models: Sequence[MeasuredLevels] | Mapping[str, MeasuredLevels],
        model_index: ArrayLike,
        centers: ArrayLike,
        radii: ArrayLike,
        *,
        camera: Camera | Sequence[Camera],
        previous: ArrayLike | None = None,
        price: float | None = None,
        gaze: ArrayLike | None = None,
        full: bool = False,
    ) -> Selection:
        """Choose a level for each object; arguments, results and errors are those of `nearfar.lod.select`."""
        models, model_index = models_of(models, model_index)
        if self.budget is None and price is not None:
            raise ValueError(f"price: expected None without a budget, got {check.value_or_type(price)}")
        if self.budget is not None:
            models = [
                model.of_mean for model in check.items("models", models, MeasuredLevels, "a sequence of LodModel")
            ]
        curves = curves_of(models)
        places, sizes = check.spheres(centers, radii)
        index = whole_numbers("model_index", model_index, np.int64, len(places))
        before = None if previous is None else whole_numbers("previous", previous, np.int32, len(places))
        cameras = cameras_of(camera)
        wide = widest(cameras)
        reference = reference_solid_angle(wide) if self.reference is None else self.reference
        tan_omega = 1.0 if self.lens is None else checked_lens(self.lens, wide, self.lens_radius)
        lens = self.lens if self.lens is not None and self.mode != "depth" and any(self.lens.k) else None
        is_fovea, is_panel = self.mode == "fovea", self.mode == "panel"
        panel = (lens, tan_omega) if is_panel and lens is not None else None
        direction = gaze_of(cameras, gaze) if is_fovea or gaze is not None else None
        seen: dict[str, Any] = {
            "previous": before,
            "eyes": [eye_of(one, direction, panel) for one in cameras],
            "line": self.threshold.line(reference),
            "cull": self.cull,
            "apparent": "panel" if is_panel else self.size,
            "lens": None if lens is None else lens._core,
            "tan_omega": tan_omega,
            "exact": self.inverse == "newton",
            "acuity": (self.acuity_slope, self.acuity_limit_deg) if is_fovea else None,
            "hysteresis": self.hysteresis,
            "full": check.flag("full", full),
        }
        spent = None
        if self.budget is None:
            level, columns, counts = _core.select_levels(
                curves,
                index,
                places,
                sizes,
                reference=reference,
                limits_seen=self.limit == "seen",
                off=self.mode == "off",
                fade=self.fade,
                **seen,
            )
        else:
            level, columns, counts, paid = _core.spend_triangles(
                curves,
                triangles_of(models),
                index,
                places,
                sizes,
                budget=self.budget,
                floor=self.floor,
                price=None if price is None else check.at_least_zero("price", price),
                **weights_for(self.weight, len(places)),
                **seen,
            )
            spent = Spent(*paid)
        return Selection(
            level=level,
            counts=dict(zip(_COUNTS, counts, strict=True)),
            columns=dict(zip(COLUMNS, columns, strict=True)) if full else {},
            spent=spent,
        )
