"""Selection by the same rules over many frames: the kernel call."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Unpack

import numpy as np
from numpy.typing import ArrayLike

from nearfar import _core
from nearfar._base import check
from nearfar._base.settings import gather
from nearfar._camera.camera import Camera
from nearfar.lod._measured_levels import MeasuredLevels
from nearfar.lod._select.budget import Spent, triangles_of, weights_for
from nearfar.lod._select.kernel_inputs import cameras_of, curves_of, eye_of, gaze_of, models_of, whole_numbers
from nearfar.lod._select.rules import LodKeywords, LodRules
from nearfar.lod._select.selection import COLUMNS, Selection
from nearfar.lod._select.size import checked_lens, reference_solid_angle, widest

_COUNTS = ("culled", "one_level", "settled", "large", "asked", "lens", "table", "formula")
"""Keys of `Selection.counts`, in the kernel's order."""


@dataclass(frozen=True, init=False)
class Selector:
    """Chooses levels by the same rules over many frames.

    Parameters
    ----------
    rules
        The rules, as `LodRules`.
    keywords
        Fields of `rules`, which they replace.

    Raises
    ------
    ValueError, TypeError
        As in `LodRules`.
    """

    rules: LodRules

    def __init__(self, rules: LodRules | None = None, **keywords: Unpack[LodKeywords]) -> None:
        object.__setattr__(self, "rules", gather(LodRules, rules, keywords, argument="rules"))

    @property
    def fade(self) -> float:
        """Share of a transition over which levels blend, of the rules."""
        return self.rules.fade

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
        rules = self.rules
        models, model_index = models_of(models, model_index)
        if rules.budget is None and price is not None:
            raise ValueError(f"price: expected None without a budget, got {check.value_or_type(price)}")
        if rules.budget is not None:
            models = [
                model.of_mean for model in check.items("models", models, MeasuredLevels, "a sequence of LodModel")
            ]
        curves = curves_of(models)
        places, sizes = check.spheres(centers, radii)
        index = whole_numbers("model_index", model_index, np.int64, len(places))
        before = None if previous is None else whole_numbers("previous", previous, np.int32, len(places))
        cameras = cameras_of(camera)
        reference = reference_solid_angle(widest(cameras)) if rules.reference is None else rules.reference
        shared: dict[str, Any] = {
            **_view_arguments(rules, cameras, gaze),
            "previous": before,
            "line": rules.score_threshold.line(reference),
            "cull": rules.cull,
            "hysteresis": rules.hysteresis,
            "full": check.flag("full", full),
        }
        spent = None
        if rules.budget is None:
            level, columns, counts = _core.select_levels(
                curves,
                index,
                places,
                sizes,
                reference=reference,
                limits_seen=rules.limit == "seen",
                off=rules.mode == "off",
                fade=rules.fade,
                **shared,
            )
        else:
            level, columns, counts, paid = _core.spend_triangles(
                curves,
                triangles_of(models),
                index,
                places,
                sizes,
                budget=rules.budget,
                floor=rules.floor,
                price=None if price is None else check.at_least_zero("price", price),
                **weights_for(rules.weight, len(places)),
                **shared,
            )
            spent = Spent(*paid)
        return Selection(
            level=level,
            counts=dict(zip(_COUNTS, counts, strict=True)),
            columns=dict(zip(COLUMNS, columns, strict=True)) if full else {},
            spent=spent,
        )


def _view_arguments(rules: LodRules, cameras: tuple[Camera, ...], gaze: ArrayLike | None) -> dict[str, Any]:
    """Kernel arguments that determine apparent sizes: eyes, lens and acuity."""
    tan_omega = 1.0 if rules.lens is None else checked_lens(rules.lens, widest(cameras), rules.lens_radius)
    lens = rules.lens if rules.lens is not None and rules.mode != "depth" and any(rules.lens.k) else None
    is_fovea, is_panel = rules.mode == "fovea", rules.mode == "panel"
    panel = (lens, tan_omega) if is_panel and lens is not None else None
    direction = gaze_of(cameras, gaze) if is_fovea or gaze is not None else None
    return {
        "eyes": [eye_of(one, direction, panel) for one in cameras],
        "apparent": "panel" if is_panel else rules.size,
        "lens": None if lens is None else lens._core,
        "tan_omega": tan_omega,
        "exact": rules.inverse == "newton",
        "acuity": (rules.acuity_slope, rules.acuity_limit_deg) if is_fovea else None,
    }
