"""Selection of levels by size, lens and gaze."""

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

    An object of solid angle σ needs a score of f(σ). It is seen at a size σ′, and level i has the score M_i(σ′): the
    level is the coarsest i with f(σ) ≤ M_i(σ′), or 0. It is always 0 where the eye is in the sphere, where σ′ is above
    σ₁/₁₆ (`limit`), and above the largest size at which the model was measured. Below the smallest such size, curves
    keep their value. A model that knows its pixels is read at σ′ times (its pixel / the camera's)²: the same object in
    smaller pixels shows more.

    Parameters
    ----------
    models
        One for each kind of object, in a row or by name.
    model_index
        (N,) the model of each object: whole numbers, by name names or numbers in the mapping's order.
    centers
        (N, 3), world metres: middles of the objects' bounding spheres.
    radii
        (N,) or one, metres, at least 0, scaled as the objects are.
    camera
        The eye, with a `Fov` of any shape and orientation; or several, such as a headset's two: then the finer of their
        answers counts, and only objects that no eye sees are out of view.
    lens
        One without tangential terms, for all eyes; None leaves sizes as they are. Its axis is the eye's line of sight.
    lens_radius
        tan ω of the lens, the tangent at which r = 1, such as `Hmd.tan_half_angle`. By default the greatest to the left
        or right of any eye.
    k, d, threshold
        f: a `LodThreshold` as `threshold`, or else its k and d, and its kind as `threshold`.
    mode
        "off": level 0 for all and no work, so that nothing is culled. "depth": σ′ = σ. "depth+eccentricity": σ′ is
        the solid angle behind the lens (`corrected_solid_angle`), without a lens that of "depth". "fovea": that solid
        angle times the squared `acuity` at its angle from the gaze. "panel": σ′ = σ D(α) counts pixels of the panel,
        as a multiple of those that the same object takes on the axis: `panel_magnification` at the angle α of the
        sphere's middle, at most that of the view's corner. The camera's pixels are then those of the panel: a headset's
        `camera(…, size=hmd.panel_size)`.
    size
        Through a lens: "axis", the published product σ (α⁺ − α⁻)/2μ, in which the lens shrinks one axis, or "area",
        that times sin α′/sin α of the middle, in which it shrinks both.
    limit
        "seen": level 0 where σ′ is above σ₁/₁₆. "own": where σ is, so that near objects lose nothing through the lens.
    reference
        σ₁/₁₆, steradians; by default `reference_solid_angle` of the eye that sees farthest to a side.
    cull
        Whether objects out of view get −1 instead of a level. A sphere that is partly in view never gets it; one beside
        a corner of the view may keep a level.
    previous
        (N,) levels of the frame before, −1 for none.
    hysteresis
        In units of the score, 0 to 1: a level coarser than the previous one needs f + hysteresis. Finer levels come at
        once, so the threshold always holds. From level 0 a coarser one also needs sizes that are smaller than the
        limits by this share.
    fade
        0 to 1: the share of the way from one level to the next over which they are blended; see `Selection.shown`. With
        level i chosen the way is t = (M_i − f) / (M_i − M), M the best score of a coarser level, or M_i − 0.05 where
        there is none, and the next finer level that is good enough has the weight 1 − t/fade. Over the last quarter of
        the sizes that curves are asked for, times `fade`, levels run to 0. `shown` is continuous except where the curve
        of a finer level crosses that of a coarser one and f as well, and where hysteresis holds levels.
    gaze
        World direction of the gaze (3,), any length; by default the line of sight, of several cameras the mean of
        theirs. Of "fovea".
    acuity_slope, acuity_limit_deg
        The eye's least visible angle, as in `acuity`; pixels are the camera's. The sphere's nearest edge counts.
    inverse
        Of the lens: "lut", whose σ′ is within 10⁻⁸ of itself, or "newton", within rounding.
    budget
        Triangles that all objects in view may have together. Then no threshold and no limit applies: levels have the
        greatest sum of weight times score that the budget allows, to within one step between two levels, but for what a
        `price`, `hysteresis` and a `floor` that does not fit hold back. Of an object the upper hull of (triangles,
        weight × score) counts: at a price λ it takes the finest level of the hull to which each triangle adds at least
        λ, and λ is the least price at which all fit. Steps at this price are taken in the order of the objects while
        they fit, then smaller ones. Of more than 16,384 steps those are tried until a thousandth of the budget is left.
        Scores are means over the views where a model has them, and beyond the sizes that were measured those at the
        ends. Objects count once for all cameras, with the greatest of their sizes.
    weight
        Of a budget: "object", all the same; "pixels", σ′ / (tangent of a pixel)², 0 beyond a lens's fold; or (N,)
        numbers, each 0 or from 10⁻¹⁵⁰ to 10¹⁵⁰.
    floor
        Of a budget: objects get at least the score f(σ) − floor where it suffices for all; where it does not, none gets
        more than that.
    price
        Of a budget: λ of the frame before, `Selection.spent.price`. It is kept, so that levels stay, where it spends no
        more than the budget and at least 1 − hysteresis of it. What it leaves goes to the levels in `previous`, as far
        as they fit; without `previous` to smaller steps. With `previous`, an object loses its level only to a score per
        triangle that is better by the share `hysteresis`, or because it no longer fits.
    full
        Whether to fill the columns of the selection too: sizes, thresholds, scores and fades.

    Returns
    -------
    Selection
        Computes as (N,) int32 levels, 0 the finest, −1 out of view. The same for any number of threads.

    Raises
    ------
    ValueError, TypeError
        For other shapes, numbers that are not finite, radii below 0, numbers of models and levels that are not, weights
        below 0, and budgets below the coarsest levels of all objects in view, whose triangles the error names.

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
