"""Selects a level of detail for each object of a picture."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any, Unpack

import numpy as np
from numpy.typing import ArrayLike

from nearfar import _core
from nearfar._base import check
from nearfar._base.settings import gather, set_fields
from nearfar._camera.camera import Camera
from nearfar.lod._measured_levels import MeasuredLevels
from nearfar.lod._select import kernel_inputs as inputs
from nearfar.lod._select.rules import LodKeywords, LodOptions, LodRules
from nearfar.lod._select.selection import COLUMNS, Selection, Spent
from nearfar.lod._select.size import checked_lens, reference_solid_angle, widest

_COUNTS = ("culled", "one_level", "settled", "large", "asked", "lens", "table", "formula")
"""Keys of `Selection.counts`, in the kernel's order."""


@dataclass(frozen=True, init=False)
class Selector:
    """Chooses levels by the same rules over many frames: `rules`, whose fields are replaced by `keywords`.

    Errors as in `LodRules`.
    """

    rules: LodRules

    def __init__(self, rules: LodRules | None = None, **keywords: Unpack[LodKeywords]) -> None:
        set_fields(self, rules=gather(LodRules, rules, keywords, argument="rules"))

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
        draws: ArrayLike | None = None,
        gaze: ArrayLike | None = None,
        full: bool = False,
    ) -> Selection:
        """Choose a level for each object; arguments, results and errors are those of `nearfar.lod.select`."""
        rules = self.rules
        models, model_index = inputs.models_of(models, model_index)
        if rules.budget is None and price is not None:
            raise ValueError(f"price: expected None without a budget, got {check.value_or_type(price)}")
        models = check.items("models", models, MeasuredLevels, "a sequence of LodModel")
        is_budget = rules.budget is not None
        curves = [model.mean_curves[0] if is_budget else model.falling_curves for model in models]
        sphere_centers, sphere_radii = check.spheres(centers, radii)
        whole_numbers = partial(inputs.whole_numbers, count=len(sphere_radii))
        index = whole_numbers("model_index", model_index, np.int64)
        previous_levels = None if previous is None else whole_numbers("previous", previous, np.int32)
        draw_counts = None if draws is None else whole_numbers("draws", check.counts("draws", draws), np.uint8)
        cameras = inputs.cameras_of(camera)
        reference = reference_solid_angle(widest(cameras)) if rules.reference is None else rules.reference
        shared: dict[str, Any] = {
            **_view_arguments(rules, cameras, gaze),
            "models": inputs.curves_of(models, curves),
            "model_index": index,
            "centers": sphere_centers,
            "radii": sphere_radii,
            "previous": previous_levels,
            "line": rules.score_threshold.line(reference),
            "cull": rules.cull,
            "hysteresis": rules.hysteresis,
            "full": check.flag("full", full),
        }
        spent = None
        if not is_budget:
            level, columns, counts = _core.select_levels(
                shared,
                reference=rules.score_threshold.limit(reference),
                limits_seen=rules.limit == "seen",
                off=rules.mode == "off",
                fade=rules.fade,
            )
        else:
            triangles = np.concatenate([np.empty(0, np.int64), *(model.triangles for model in models)])
            rises = np.concatenate([np.empty((0, 4)), *(model.mean_curves[1] for model in models)])
            budget: dict[str, Any] = {
                "budget": rules.budget,
                "floor": rules.floor,
                "price": None if price is None else check.at_least_zero("price", price),
                "draws": draw_counts,
                **inputs.weights_for(rules.weight, len(sphere_radii)),
            }
            level, columns, counts, paid = _core.spend_triangles(shared, triangles, rises, budget)
            spent = Spent(*paid)
        return Selection(
            level=level,
            counts=dict(zip(_COUNTS, counts, strict=True)),
            columns=dict(zip(COLUMNS, columns, strict=True)) if full else {},
            spent=spent,
        )


def select(
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
    **options: Unpack[LodOptions],
) -> Selection:
    """Choose a level of detail for each object: the coarsest whose score reaches the threshold for its size.

    An object of solid angle σ needs a score of f(σ). Its apparent size is σ′, at which level i has the score M_i(σ′):
    the level is the coarsest i with f(σ) ≤ M_i(σ′), or 0. It is always 0 if the eye is inside the sphere, if σ′ is
    above σ₁/₁₆ (`limit`, not for the threshold "constant"), or above the largest size at which the model was measured.
    Below the smallest measured size, curves are constant. M_i is the least score at a size and all smaller ones: of a
    curve that rises with size the least score is used, so that no object gets a finer level as it shrinks, if k ≥ 0.
    If the model has a pixel size, curves are evaluated at σ′ times (the model's pixel / the camera's pixel)²: smaller
    pixels show more of the same object.

    The selection can be used like an int32 array (N,) of its levels: 0 for the finest, −1 out of view. It does not
    depend on the number of threads. ValueError and TypeError for wrong shapes, numbers that are not finite, radii below
    0, invalid indices of models and levels, weights below 0, or budgets below the coarsest levels of all objects in
    view, whose triangle count the error states. Sources: Liebisch (2021), Sec. 4.3–4.5; Guenter, Finch, Drucker, Tan,
    Snyder (2012) for "fovea".

    Parameters
    ----------
    models
        One for each kind of object, in a sequence or by name.
    model_index
        Model of each object (N,): indices; for models by name, names or indices in the mapping's order.
    centers
        Centres of the objects' bounding spheres (N, 3), world metres.
    radii
        Radii (N,) or one for all, metres, at least 0, with the objects' scales applied.
    camera
        The eye, with a `Fov` of any shape and orientation; or several, such as a headset's two. Then an object gets the
        finest level that any of them needs, and only objects that no eye sees are out of view.
    previous
        Levels (N,) of the previous frame, −1 for none.
    price
        For a budget: λ of the previous frame, `Selection.spent.price`. It is kept, so that levels do not change, if it
        spends at most the budget and at least 1 − hysteresis of it. The remaining triangles go to the levels in
        `previous` as far as they fit, or without `previous` to smaller steps. With `previous`, an object loses its
        level only if other levels gain a score per triangle that is higher by the share `hysteresis`, or if the level
        no longer fits.
    gaze
        World direction of the gaze (3,), any length, for "fovea"; by default the line of sight, for several cameras the
        mean of theirs.
    full
        Whether to fill the selection's columns: sizes, thresholds, scores and fades.
    options
        `rules`, as `LodRules`; and its fields, which replace those of `rules`: `k`, `d`, `threshold`, `mode`, `size`,
        `limit`, `lens`, `lens_radius`, `reference`, `cull`, `hysteresis`, `fade`, `acuity_slope`, `acuity_limit_deg`,
        `inverse`, `budget`, `weight`, `floor`.
    """
    return Selector(**options).select(
        models, model_index, centers, radii, camera=camera, previous=previous, price=price,
        gaze=gaze, full=full,
    )  # fmt: skip


def _view_arguments(rules: LodRules, cameras: tuple[Camera, ...], gaze: ArrayLike | None) -> dict[str, Any]:
    """Arguments of the kernel that determine apparent sizes: eyes, lens and acuity."""
    tan_omega = 1.0 if rules.lens is None else checked_lens(rules.lens, widest(cameras), rules.lens_radius)
    lens = rules.lens if rules.lens is not None and rules.mode != "depth" and any(rules.lens.k) else None
    is_fovea, is_panel = rules.mode == "fovea", rules.mode == "panel"
    panel = (lens, tan_omega) if is_panel and lens is not None else None
    direction = inputs.gaze_of(cameras, gaze) if is_fovea or gaze is not None else None
    return {
        "eyes": [inputs.eye_of(each, direction, panel) for each in cameras],
        "apparent": "panel" if is_panel else rules.size,
        "lens": None if lens is None else lens._core,
        "tan_omega": tan_omega,
        "exact": rules.inverse == "newton",
        "acuity": (rules.acuity_slope, rules.acuity_limit_deg) if is_fovea else None,
    }
