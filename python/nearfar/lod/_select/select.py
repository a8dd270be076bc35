"""Selects a level of detail for each object of a picture."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Unpack

from numpy.typing import ArrayLike

from nearfar._camera.camera import Camera
from nearfar.lod._model import LodModel
from nearfar.lod._select.rules import LodOptions
from nearfar.lod._select.selection import Selection
from nearfar.lod._select.selector import Selector


def select(
    models: Sequence[LodModel] | Mapping[str, LodModel],
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
    previous
        Levels (N,) of the previous frame, −1 for none.
    price
        For a budget: λ of the previous frame, `Selection.spent.price`. It is kept, so that levels stay, if it spends at
        most the budget and at least 1 − hysteresis of it. The remainder goes to the levels in `previous` as far as they
        fit; without `previous` to smaller steps. With `previous`, an object loses its level only to a score per
        triangle that is better by the share `hysteresis`, or because it no longer fits.
    gaze
        World direction of the gaze (3,), any length, for "fovea"; by default the line of sight, for several cameras the
        mean of theirs.
    full
        Whether to fill the selection's columns: sizes, thresholds, scores and fades.
    options
        `rules`, as `LodRules`; and its fields, which replace those of `rules`: `k`, `d`, `threshold`, `mode`, `size`,
        `limit`, `lens`, `lens_radius`, `reference`, `cull`, `hysteresis`, `fade`, `acuity_slope`, `acuity_limit_deg`,
        `inverse`, `budget`, `weight`, `floor`.

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
    return Selector(**options).select(
        models, model_index, centers, radii, camera=camera, previous=previous, price=price, gaze=gaze, full=full
    )
