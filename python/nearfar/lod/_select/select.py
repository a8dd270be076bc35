"""Selects levels by size, lens and gaze."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from numpy.typing import ArrayLike

from nearfar._camera.camera import Camera
from nearfar._lens.lens import RadialLens
from nearfar.lod._model import LodModel
from nearfar.lod._select.selection import Selection
from nearfar.lod._select.selector import Selector
from nearfar.lod._select.size import ACUITY_LIMIT_DEG, ACUITY_SLOPE
from nearfar.lod._select.threshold import LodThreshold


def select(
    models: Sequence[LodModel] | Mapping[str, LodModel],
    model_index: ArrayLike,
    centers: ArrayLike,
    radii: ArrayLike,
    *,
    camera: Camera | Sequence[Camera],
    lens: RadialLens | None = None,
    lens_radius: float | None = None,
    k: float | None = None,
    d: float | None = None,
    threshold: LodThreshold | str | None = None,
    mode: str = "depth+eccentricity",
    size: str = "axis",
    limit: str = "seen",
    reference: float | None = None,
    cull: bool = True,
    previous: ArrayLike | None = None,
    hysteresis: float = 0.0,
    fade: float = 0.0,
    gaze: ArrayLike | None = None,
    acuity_slope: float = ACUITY_SLOPE,
    acuity_limit_deg: float = ACUITY_LIMIT_DEG,
    inverse: str = "lut",
    budget: int | None = None,
    weight: str | ArrayLike = "object",
    floor: float | None = None,
    price: float | None = None,
    full: bool = False,
) -> Selection:
    """Choose a level of detail for each object: the coarsest whose score reaches the threshold for its size.

    An object of solid angle σ needs a score of f(σ). Its apparent size is σ′, at which level i has the score M_i(σ′):
    the level is the coarsest i with f(σ) ≤ M_i(σ′), or 0. It is always 0 if the eye is inside the sphere, if σ′ is
    above σ₁/₁₆ (`limit`), or above the largest size at which the model was measured. Below the smallest measured size,
    curves keep their value. If a model knows its pixel size, curves are evaluated at σ′ times (its pixel / the
    camera's)²: the same object in smaller pixels shows more.

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
        The eye, with a `Fov` of any shape and orientation; or several, such as a headset's two: then the finer of their
        levels is used, and only objects that no eye sees are out of view.
    lens
        A lens without tangential terms, for all eyes; None leaves sizes unchanged. Its axis is the eye's line of sight.
    lens_radius
        tan ω of the lens, the tangent at which r = 1, such as `Hmd.tan_half_angle`. By default the greatest tangent to
        the left or right of any eye.
    k, d, threshold
        f: a `LodThreshold` as `threshold`, or else its k and d, and its kind as `threshold`.
    mode
        "off": level 0 for all, without culling. "depth": σ′ = σ. "depth+eccentricity": σ′ is the solid angle behind the
        lens (`corrected_solid_angle`), without a lens as for "depth". "fovea": that solid angle times the squared
        `acuity` at its angle from the gaze. "panel": σ′ = σ D(α) counts pixels of the panel, as a multiple of those
        that the same object covers on the axis: `panel_magnification` at the angle α of the sphere's centre, at most
        that of the view's corner. The camera's pixels must then be those of the panel: a headset's
        `camera(…, size=hmd.panel_size)`.
    size
        Size through a lens: "axis", the published product σ (α⁺ − α⁻)/2μ, in which the lens shrinks one axis, or
        "area", that times sin α′/sin α of the centre, in which it shrinks both.
    limit
        "seen": level 0 if σ′ is above σ₁/₁₆. "own": if σ is, so that near objects lose no detail through the lens.
    reference
        σ₁/₁₆, steradians; by default `reference_solid_angle` of the eye with the widest view to a side.
    cull
        Whether objects out of view get −1 instead of a level. A sphere that is partly in view never does; one beside a
        corner of the view may keep a level.
    previous
        Levels (N,) of the previous frame, −1 for none.
    hysteresis
        In units of the score, 0 to 1: a level coarser than the previous one needs f + hysteresis. Finer levels are
        taken at once, so the threshold always holds. From level 0 a coarser one also needs sizes that are smaller than
        the limits by this share.
    fade
        0 to 1: share of the transition from one level to the next over which they are blended; see `Selection.shown`.
        With level i chosen the transition is t = (M_i − f) / (M_i − M), M the best score of a coarser level, or M_i −
        0.05 if there is none, and the next finer level that is good enough has the weight 1 − t/fade. Over the last
        quarter of the sizes for which curves are evaluated, times `fade`, levels go to 0. `shown` is continuous except
        where the curve of a finer level crosses both that of a coarser one and f, and where hysteresis holds levels.
    gaze
        World direction of the gaze (3,), any length, for "fovea"; by default the line of sight, for several cameras the
        mean of theirs.
    acuity_slope, acuity_limit_deg
        The eye's least visible angle, as in `acuity`; pixels are the camera's. The sphere's edge nearest to the gaze
        counts.
    inverse
        Inverse of the lens: "lut", with a relative error of σ′ within 10⁻⁸, or "newton", within rounding.
    budget
        Maximum number of triangles of all objects in view. Then no threshold and no limit applies: levels have the
        greatest sum of weight times score within the budget, to within one step between two levels, except where
        `price`, `hysteresis` or a `floor` that does not fit prevents it. For each object the upper hull of (triangles,
        weight × score) counts: at a price λ it takes the finest level of the hull to which each triangle adds at least
        λ, and λ is the least price at which all fit. Steps at this price are taken in the order of the objects while
        they fit, then smaller ones. Of more than 16,384 steps those are tried until a thousandth of the budget is left.
        Scores are means over the views if a model has them, and beyond the measured sizes those at the ends. Objects
        count once for all cameras, with the greatest of their sizes.
    weight
        Weights for a budget: "object", all equal; "pixels", σ′ / (tangent of a pixel)², 0 beyond a lens's fold; or (N,)
        numbers, each 0 or from 10⁻¹⁵⁰ to 10¹⁵⁰.
    floor
        For a budget: objects get at least the score f(σ) − floor if the budget suffices for all; otherwise none gets
        more than that.
    price
        For a budget: λ of the previous frame, `Selection.spent.price`. It is kept, so that levels stay, if it spends at
        most the budget and at least 1 − hysteresis of it. The remainder goes to the levels in `previous` as far as they
        fit; without `previous` to smaller steps. With `previous`, an object loses its level only to a score per
        triangle that is better by the share `hysteresis`, or because it no longer fits.
    full
        Whether to fill the selection's columns: sizes, thresholds, scores and fades.

    Returns
    -------
    Selection
        Behaves like its (N,) int32 levels, 0 the finest, −1 out of view. It does not depend on the number of threads.

    Raises
    ------
    ValueError, TypeError
        Wrong shapes, numbers that are not finite, radii below 0, invalid indices of models and levels, weights below 0,
        or budgets below the coarsest levels of all objects in view, whose triangle count the error states.

    References
    ----------
    Liebisch (2021), Sec. 4.3–4.5. Guenter, Finch, Drucker, Tan, Snyder (2012) for "fovea".
    """
    selector = Selector(
        k=k,
        d=d,
        threshold=threshold,
        mode=mode,
        size=size,
        limit=limit,
        lens=lens,
        lens_radius=lens_radius,
        reference=reference,
        cull=cull,
        hysteresis=hysteresis,
        fade=fade,
        acuity_slope=acuity_slope,
        acuity_limit_deg=acuity_limit_deg,
        inverse=inverse,
        budget=budget,
        weight=weight,
        floor=floor,
    )
    return selector.select(
        models, model_index, centers, radii, camera=camera, previous=previous, price=price, gaze=gaze, full=full
    )
