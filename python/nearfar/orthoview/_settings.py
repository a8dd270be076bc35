"""Settings of a tree's views and of flights through it; the size of views that a display needs."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal, SupportsFloat, SupportsIndex, TypedDict, get_args

from nearfar import _core
from nearfar._base import check
from nearfar._base.settings import set_fields
from nearfar.orthoview._cut import Settings
from nearfar.orthoview._flight import MAX_THREADS, THREADS
from nearfar.orthoview._flight_tree import MARGIN
from nearfar.orthoview._grid import COUNTS, directions_of, widest
from nearfar.orthoview._pilot import PrefetchSettings
from nearfar.orthoview._renderable_tree import settings_of

MAX_SIZE = 4096
"""Greatest size of a view, pixels."""

Compression = Literal["zstd", "webp"]
"""Compression of colours."""


@dataclass(frozen=True, kw_only=True)
class ViewSettings:
    """Settings of `build`: number, size and format of the views of each cell.

    ValueError and TypeError for settings out of range or of another type; ValueError for a quality with zstd.

    Parameters
    ----------
    size
        Width and height of a view, pixels; a multiple of 4, at most 4096.
    directions
        5 views of each cell (from four sides and the top), 9 (also from the upper edges), 13 (also from the upper
        corners) or 26 (from everywhere). "auto" measures sampled leaves for some seconds, and takes the smallest set
        that hides few of their surfaces from viewers above; a build that resumes keeps its set.
    depth_bits
        Bits of a depth, 8 to 16, which number the steps of a cell's depth range: 4,092 steps for 12 bits. A surface is
        assumed to lie in the middle of its step.
    normal_bits
        Bits of a normal, 16 or 24: its error is at most 0.96° or 0.06°.
    color
        Compression of colours: "zstd", which every Zarr reader has, or "webp", smaller for textured worlds.
    quality
        Quality of WebP, 0 to 100; None for lossless files.
    layers
        2 also stores, for each pixel, the next surface more than 2 pixels behind the first one. A view keeps this
        second layer if more than 1 % of its non-empty pixels thereby show a surface that no first layer of the cell
        shows.
    """

    size: int = 512
    directions: int | Literal["auto"] = 9
    depth_bits: int = 12
    normal_bits: int = 16
    color: Compression = "zstd"
    quality: int | None = None
    layers: int = 1

    def __post_init__(self) -> None:
        count, quality = self.directions, self.quality
        if isinstance(count, str) and count != "auto":
            raise ValueError(f"directions: expected one of {COUNTS} or 'auto', got {check.shortened(count)}")
        set_fields(
            self,
            size=check.integer("size", self.size, 4, MAX_SIZE),
            directions=count if isinstance(count, str) else len(directions_of(count)),
            depth_bits=check.integer("depth_bits", self.depth_bits, 8, 16),
            normal_bits=check.integer("normal_bits", self.normal_bits, 16, 24),
            color=check.choice("color", self.color, get_args(Compression)),
            quality=None if quality is None else check.integer("quality", quality, 0, 100),
            layers=check.integer("layers", self.layers, 1, 2),
        )
        if quality is not None and self.color == "zstd":
            raise ValueError("quality: expected None with color='zstd', which is lossless")
        # The core rejects sizes and bits between the limits checked above.
        _core.orthoview_steps((self.size, self.depth_bits, self.normal_bits))


class ViewKeywords(TypedDict, total=False):
    """Fields of `ViewSettings` as keywords of `build`; a test compares both."""

    size: int
    directions: int | Literal["auto"]
    depth_bits: int
    normal_bits: int
    color: Compression
    quality: int | None
    layers: int


@dataclass(frozen=True, kw_only=True)
class FlightSettings:
    """Settings of the flight that `simulate` simulates.

    ValueError and TypeError for settings out of range or of another type.

    Parameters
    ----------
    views, error_px, geometry, prefetch, margin_deg, adapt, threads
        As in `OrthoTree.fly`.
    """

    views: int = 3
    error_px: float = 1.0
    geometry: bool = True
    prefetch: bool = True
    margin_deg: float | None = MARGIN
    adapt: bool = True
    threads: int = THREADS

    def __post_init__(self) -> None:
        cut, margin = self.cut, self.margin_deg
        set_fields(
            self,
            views=cut.views,
            error_px=cut.error_px,
            prefetch=check.flag("prefetch", self.prefetch),
            margin_deg=None if margin is None else check.in_range("margin_deg", margin, 0.0, 180.0),
            adapt=check.flag("adapt", self.adapt),
            threads=check.integer("threads", self.threads, 1, MAX_THREADS),
        )

    @property
    def cut(self) -> Settings:
        """Settings of the cuts."""
        return settings_of(self.views, self.error_px, self.geometry)

    @property
    def ahead(self) -> PrefetchSettings:
        """Settings of prefetching."""
        margin = None if self.margin_deg is None else math.radians(self.margin_deg)
        return PrefetchSettings(self.prefetch, margin, self.adapt)


class FlightKeywords(TypedDict, total=False):
    """Fields of `FlightSettings` as keywords of `simulate`; a test compares both."""

    views: int
    error_px: float
    geometry: bool
    prefetch: bool
    margin_deg: float | None
    adapt: bool
    threads: int


_ROUNDING = 1e-12
"""Relative rounding error by which a number may exceed a whole number without being rounded up."""


def size_for(
    pixels: SupportsIndex,
    *,
    cell: SupportsFloat,
    distance: SupportsFloat,
    fov: SupportsFloat,
    angle: SupportsFloat = 0.0,
    directions: SupportsIndex = 9,
) -> int:
    """Return the size of views whose pixels are as fine as a display's.

    Returns the least multiple of 4 that is at least q = p/cos θ · w s/(2 r tan(α/2)). At the distance r a pixel of the
    display is 2 r tan(α/2)/p wide; the largest side of a view's pixel is w s/q. ValueError for values out of range, or
    a size above 4096 pixels; TypeError for values that are not numbers. Source: Chaudhuri et al. (2009), section 4.1,
    with w = 1.

    Parameters
    ----------
    pixels
        Width of the display, p.
    cell
        Side of a leaf, s, metres.
    distance
        Distance beyond which views replace geometry, r, metres.
    fov
        Horizontal field of view, α, radians, between 0 and π.
    angle
        Angle between a surface's normal and the view, θ, radians, at least 0 and below π/2: a view shows a surface
        tilted by θ with fewer pixels.
    directions
        As in `nearfar.orthoview.build`. The widest view of a cell is w sides wide: w = 1 for 5, √2 for 9, 1.633 for
        13 and 26.
    """
    width = check.integer("pixels", pixels, 1, 1 << 20)
    side, least_distance = check.positive("cell", cell), check.positive("distance", distance)
    field_of_view, tilt = check.number("fov", fov), check.number("angle", angle)
    if not 0 < field_of_view < math.pi:
        raise ValueError(f"fov: expected radians between 0 and π, got {field_of_view:g}")
    if not 0 <= tilt < math.pi / 2:
        raise ValueError(f"angle: expected radians from 0 to below π/2, got {tilt:g}")
    widest_view = widest(directions_of(directions))
    visible_width = 2 * least_distance * math.tan(field_of_view / 2) * math.cos(tilt)
    if not width * widest_view * side <= MAX_SIZE * visible_width:
        values = f"{width}, {side:g}, {least_distance:g}, {field_of_view:g}, {tilt:g}"
        raise ValueError(
            f"pixels, cell, distance, fov, angle: expected values for which {MAX_SIZE} pixels are enough, got {values}"
        )
    return max(4, 4 * math.ceil(width * widest_view * side / visible_width / 4 * (1 - _ROUNDING)))
