"""Rules by which levels are chosen: threshold, lens, limits, transitions and budget."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import Any, Literal, TypeAlias, TypedDict, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check
from nearfar._base.settings import Alternatives, set_fields
from nearfar._camera.camera import Fov
from nearfar._lens.lens import RadialLens
from nearfar.lod._select.size import ACUITY_LIMIT_DEG, ACUITY_SLOPE, checked_lens
from nearfar.lod._select.threshold import Kind, LodThreshold, threshold_of

Mode: TypeAlias = Literal["off", "depth", "depth+eccentricity", "fovea", "panel"]
Size: TypeAlias = Literal["axis", "area"]
Limit: TypeAlias = Literal["seen", "own"]
Inverse: TypeAlias = Literal["lut", "newton"]
Weighting: TypeAlias = Literal["object", "pixels"]

MAX_TRIANGLES = 1 << 62


@dataclass(frozen=True, kw_only=True, eq=False)
class LodRules(Alternatives):
    """Rules by which `select` and `Selector` choose levels; equal if they have the same threshold and other fields.

    As in `select`, σ is an object's solid angle, σ′ its apparent size, f(σ) the score that it needs, M_i the score of
    level i, and σ₁/₁₆ the `reference`. ValueError and TypeError for rules out of range, a lens with tangential terms, k
    or d beside a `LodThreshold`, a `weight` or `floor` without a budget, and a `fade` or the mode "off" with a budget.

    Parameters
    ----------
    k, d, threshold
        The threshold f: a `LodThreshold` as `threshold`; or its kind as `threshold`, and its k and d.
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
        "seen": objects with σ′ above σ₁/₁₆ get level 0. "own": objects with σ above it do, so that near objects lose no
        detail through the lens.
    lens
        A lens without tangential terms, for all eyes; None leaves sizes unchanged. Its axis is the eye's line of sight.
    lens_radius
        tan ω of the lens, the tangent at which r = 1, such as `Hmd.tan_half_angle`. By default the greatest tangent to
        the left or right of any eye.
    reference
        σ₁/₁₆, steradians; by default `reference_solid_angle` of the eye with the widest view to a side.
    cull
        Whether objects out of view get −1 instead of a level. A sphere that is partly in view never does; one beside a
        corner of the view may keep a level.
    hysteresis
        Margin of the score, 0 to 1: a level coarser than the previous one needs a score of at least f + hysteresis.
        Finer levels are taken at once, so the threshold always holds. To leave level 0, an object's size must also be
        below the limits by this share.
    fade
        Share of the transition from one level to the next, 0 to 1, over which they blend; see `Selection.shown`. If
        level i is chosen, the transition is t = (M_i − f) / (M_i − M), where M is the best score of a coarser level, or
        M_i − 0.05 if there is none. The next finer level that is good enough has the weight 1 − t/fade. Levels also
        blend to level 0 over the last quarter of the sizes for which curves are evaluated, times `fade`. `shown` is
        continuous except where the curve of a finer level crosses both f and the curve of a coarser level, and where
        hysteresis holds levels.
    acuity_slope, acuity_limit_deg
        `slope` and `limit_deg` of `acuity`, for "fovea"; the pixel is the camera's, and the eccentricity that of the
        sphere's point nearest to the gaze.
    inverse
        Inverse of the lens: "lut", with a relative error of σ′ within 10⁻⁸, or "newton", within rounding.
    budget
        Maximum number of triangles of all objects in view, instead of threshold and limit. Levels have the greatest sum
        of weight × score within the budget, except for one step between two levels, unless `price`, `hysteresis` or a
        `floor` that does not fit prevents it. Levels are chosen on the upper hull of each object's (triangles, weight ×
        score): at a price λ an object takes the finest level of its hull to which each triangle adds at least λ, and λ
        is the least price at which all objects fit. The remaining triangles pay for further steps, first those at this
        price in the order of the objects, then smaller ones; of more than 16,384 steps only until a thousandth of the
        budget is left. Scores are means over the views if a model has them. These may rise with size; beyond the
        measured sizes they are constant. With several cameras an object's greatest size counts. Its triangles count
        once, or as often as `draws` of `select` says: `render_eyes` counts them twice, and `HybridRig.render` counts
        the pictures that may draw the object.
    weight
        Weights for a budget: "pixels", σ′ / (tangent of a pixel)², 0 beyond a lens's fold; "object", all equal; or (N,)
        numbers, each 0 or from 10⁻¹⁵⁰ to 10¹⁵⁰. With equal weights, many small objects get more triangles than one
        that fills the view.
    floor
        For a budget: all objects get at least the score f(σ) − floor if the budget suffices; otherwise no object gets a
        finer level than this score needs.
    """

    k: float | None = None
    d: float | None = None
    threshold: LodThreshold | Kind | None = None
    mode: Mode = "depth+eccentricity"
    size: Size = "axis"
    limit: Limit = "seen"
    lens: RadialLens | None = None
    lens_radius: float | None = None
    reference: float | None = None
    cull: bool = True
    hysteresis: float = 0.0
    fade: float = 0.0
    acuity_slope: float = ACUITY_SLOPE
    acuity_limit_deg: float = ACUITY_LIMIT_DEG
    inverse: Inverse = "lut"
    budget: int | None = None
    weight: Weighting | ArrayLike = "pixels"
    floor: float | None = None

    def __post_init__(self) -> None:
        if self.lens is not None:
            checked_lens(self.lens, Fov(-1, 1, -1, 1), self.lens_radius)
        for name, options in (("mode", Mode), ("size", Size), ("limit", Limit), ("inverse", Inverse)):
            check.choice(name, getattr(self, name), get_args(options))
        set_fields(
            self,
            lens_radius=None if self.lens_radius is None else check.positive("lens_radius", self.lens_radius),
            reference=None if self.reference is None else check.positive("reference", self.reference),
            cull=check.flag("cull", self.cull),
            hysteresis=check.in_range("hysteresis", self.hysteresis, 0.0, 1.0),
            fade=check.in_range("fade", self.fade, 0.0, 1.0),
            acuity_slope=check.at_least_zero("acuity_slope", self.acuity_slope),
            acuity_limit_deg=check.positive("acuity_limit_deg", self.acuity_limit_deg),
            budget=None if self.budget is None else check.integer("budget", self.budget, 0, MAX_TRIANGLES),
            weight=_weight_of(self.weight),
            floor=None if self.floor is None else check.at_least_zero("floor", self.floor),
        )
        _ = self.score_threshold  # checks it
        self._check_budget()

    @property
    def score_threshold(self) -> LodThreshold:
        """The threshold f, of `threshold`, `k` and `d`."""
        return threshold_of(self.threshold, self.k, self.d)

    def _adapted_to(self, keywords: Mapping[str, Any]) -> dict[str, Any]:
        """A new threshold replaces k and d; new k or d replace those of the threshold."""
        if isinstance(keywords.get("threshold"), LodThreshold):
            return {"k": None, "d": None}
        threshold = self.threshold
        if isinstance(threshold, LodThreshold) and keywords.keys() & {"k", "d"}:
            return {"k": threshold.k, "d": threshold.d, "threshold": threshold.kind}
        return {}

    def _check_budget(self) -> None:
        """Reject rules that have no meaning without, or with, a budget."""
        if self.budget is None:
            if self.floor is not None:
                raise ValueError(f"floor: expected None without a budget, got {self.floor}")
            if not isinstance(self.weight, str) or self.weight != "pixels":
                raise ValueError(f"weight: expected 'pixels' without a budget, got {check.value_or_type(self.weight)}")
            return
        if self.mode == "off":
            raise ValueError("budget: expected None for the mode 'off', which draws all at level 0")
        if self.fade > 0:
            raise ValueError(f"fade: expected 0 with a budget, under which levels do not blend, got {self.fade}")

    def __eq__(self, other: object) -> bool:
        return isinstance(other, LodRules) and self._content == other._content

    def __hash__(self) -> int:
        return hash(self._content)

    @property
    def _content(self) -> tuple[Any, ...]:
        """The threshold and the values of all fields after it; weights as bytes."""
        values = (getattr(self, field.name) for field in fields(self)[3:])
        contents = (value.tobytes() if isinstance(value, np.ndarray) else value for value in values)
        return (self.score_threshold, *contents)


class LodKeywords(TypedDict, total=False):
    """Fields of `LodRules` as keywords of `select` and `Selector`; a test compares both."""

    k: float | None
    d: float | None
    threshold: LodThreshold | Kind | None
    mode: Mode
    size: Size
    limit: Limit
    lens: RadialLens | None
    lens_radius: float | None
    reference: float | None
    cull: bool
    hysteresis: float
    fade: float
    acuity_slope: float
    acuity_limit_deg: float
    inverse: Inverse
    budget: int | None
    weight: Weighting | ArrayLike
    floor: float | None


class LodOptions(LodKeywords, total=False):
    """Keywords of `Selector`."""

    rules: LodRules | None


def _weight_of(weight: Weighting | ArrayLike) -> str | NDArray[np.float64]:
    """Check the kind of weights, or explicit weights (N,)."""
    if isinstance(weight, str):
        check.choice("weight", weight, get_args(Weighting))
        return weight
    weights = np.array(check.array("weight", weight, columns=None, dtype=np.float64))
    if weights.ndim != 1:
        raise ValueError(f"weight: expected shape (N,), one for each object, got {weights.shape}")
    weights.flags.writeable = False
    _core.check_weights(weights)
    return weights
