"""Settings of a measurement: screen, views, sizes, and how scores become a model."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar, Self, TypedDict, Unpack, get_args

from nearfar._base import check
from nearfar._base.settings import Alternatives, set_fields
from nearfar._camera.camera import Fov
from nearfar._camera.shot import MAX_SAMPLES
from nearfar._render import backend as backends
from nearfar._render.backend import Backend
from nearfar.hmd._hmd import Hmd
from nearfar.lod._measure import statistic
from nearfar.lod._measure.statistic import Mean
from nearfar.lod._measure.views import AXES, Directions, Screen, Spacing

MIN_VIEWS = 4
"""Least number of views: fewer directions lie in one plane and may miss whole sides of an object."""

MAX_VIEWS = 1 << 20
MAX_DISTANCES = 1000


@dataclass(frozen=True, kw_only=True)
class MeasureSettings(Alternatives):
    """Settings of `measure`: the pictures to compare, and the levels to keep.

    By default, views are added until a standard error is reached. `MeasureSettings.full(…)` compares all views of all
    levels, `MeasureSettings.published(…)` the views of the thesis. ValueError and TypeError for settings out of range,
    no screen, or two screens.

    Parameters
    ----------
    hmd
        The headset. Pictures have the pixels of its left eye's view, but are symmetric about the axis. Only the
        object's box is rendered, with the same result.
    fov, size
        A view and its width and height in pixels, each at least 11, instead of `hmd`.
    views
        Greatest number of pictures of each level at each distance, at least 4. The object turns in front of a camera on
        +z; light and sky turn with it.
    directions
        Directions of the views. "even": as many directions as views, uniform over the sphere (a Fibonacci sphere), each
        by the shortest turn of the object. "published": turns in equal steps (10° for 144 views) about four axes
        perpendicular to the line of sight: horizontal, vertical and the two diagonals between them; the number of views
        must be a multiple of 4.
    spacing
        Sequence of the distances. At the solid angle σ₁/₁₆ = 2π(1−cos(asin(¼ tan ω))), where ω is half the horizontal
        field of view, the bounding sphere fills 1/16 of the screen. "published": the first distance is at σ₁/₁₆; at the
        others the sphere's nearest point is 2, 3, … times as far. "geometric": sizes in equal factors, from a sphere
        twice as wide as at σ₁/₁₆, where budgets and a `quality` need curves, to one 4 pixels wide.
    distances
        Number of distances, 1 to 1000. With fewer than 4 curves are "unfittable"; with fewer than 8 many are "flat" and
        have their least score at all sizes.
    standard_error
        Greatest standard error of a score; twice as much is allowed above σ₁/₁₆. At each distance a twelfth of the
        views is compared first, then about twice as many each time, always from all sides, until the errors of all
        measured levels are small enough or no views are left. The error is estimated as for random views; the error of
        evenly spread views is smaller. 0 compares all views.
    percentile
        Percentile over the views that is a level's score at a size, 0 to 100, by NumPy's method
        "averaged_inverted_cdf"; or "mean". `LodModel.refit` applies another one without new pictures.
    step
        Of the levels with a score of at least 1 − step the coarsest is kept, likewise of those with at least 1 − 2
        step, and so on. Scores are compared at the first distance at or below σ₁/₁₆ and at the next three, because SSIM
        of bumpy objects may fall as they get smaller. Other levels look no better than a coarser one, and are measured
        only as far as needed to find that out. The base is always kept. None keeps all levels.
    saturated
        A level that reaches this score at two successive distances is not measured at further ones, where its last
        score is assumed. None measures all levels at all distances.
    samples
        Samples of each pixel, as in `render`.
    backend
        As in `render`. Curves measured by a GPU that multisamples differ slightly from those of the CPU.
    cache
        Whether to cache scores, by content and settings. Scores measured before, also by a call that Ctrl-C ended, are
        not measured again; if a level is added, only that level is measured.
    """

    _alternatives: ClassVar = (("hmd",), ("fov", "size"))

    hmd: Hmd | None = None
    fov: Fov | None = None
    size: tuple[int, int] | None = None
    views: int = 144
    directions: Directions = "even"
    spacing: Spacing = "geometric"
    distances: int = 16
    standard_error: float = 0.02
    percentile: float | Mean = 25.0
    step: float | None = 0.05
    saturated: float | None = 0.999
    samples: int = 4
    backend: Backend | None = None
    cache: bool = True

    def __post_init__(self) -> None:
        screen = self.screen
        set_fields(
            self,
            size=screen.size if self.hmd is None else None,
            views=check.integer("views", self.views, MIN_VIEWS, MAX_VIEWS),
            directions=check.choice("directions", self.directions, get_args(Directions)),
            spacing=check.choice("spacing", self.spacing, get_args(Spacing)),
            standard_error=check.at_least_zero("standard_error", self.standard_error),
            distances=check.integer("distances", self.distances, 1, MAX_DISTANCES),
            percentile=statistic.check_percentile(self.percentile),
            step=None if self.step is None else check.positive("step", self.step),
            saturated=None if self.saturated is None else check.in_range("saturated", self.saturated, -1.0, 1.0),
            samples=check.integer("samples", self.samples, 1, MAX_SAMPLES),
            backend=None if self.backend is None else backends.check(self.backend),
            cache=check.flag("cache", self.cache),
        )
        if self.directions == "published" and self.views % len(AXES):
            raise ValueError(f"views: expected a multiple of {len(AXES)} for published directions, got {self.views}")

    @classmethod
    def full(cls, **keywords: Unpack[MeasureKeywords]) -> Self:
        """Return settings that compare all levels from all views at all distances; `keywords` are other fields."""
        every: MeasureKeywords = {"standard_error": 0.0, "step": None, "saturated": None}
        return cls(**(every | keywords))

    @classmethod
    def published(cls, **keywords: Unpack[MeasureKeywords]) -> Self:
        """Return settings that compare all views and distances of Liebisch (2021); `keywords` are other fields."""
        thesis: MeasureKeywords = {"directions": "published", "spacing": "published"}
        return cls.full(**(thesis | keywords))

    @property
    def screen(self) -> Screen:
        """Screen of the pictures, from the headset or the view."""
        return Screen.from_arguments(self.hmd, self.fov, self.size)


class MeasureKeywords(TypedDict, total=False):
    """Fields of `MeasureSettings` as keywords of `measure`; a test compares both."""

    hmd: Hmd | None
    fov: Fov | None
    size: tuple[int, int] | None
    views: int
    directions: Directions
    spacing: Spacing
    distances: int
    standard_error: float
    percentile: float | Mean
    step: float | None
    saturated: float | None
    samples: int
    backend: Backend | None
    cache: bool


class MeasureOptions(MeasureKeywords, total=False):
    """All keywords of `measure`."""

    settings: MeasureSettings | None
    workers: int | None
    client: Any
