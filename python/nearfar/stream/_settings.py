"""Settings of the files of bundles: maps, geometry and textures."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal, TypedDict, get_args

from nearfar._base import check
from nearfar._base.settings import set_fields
from nearfar.stream._maps import MAX_SAMPLES, TILE

MAX_FACE_SIZE = 4096

MAX_RANGE_ERROR = 0.005
"""Greatest accepted relative error of ranges; the compression supports no coarser codes."""

Compression = Literal["meshopt"]
"""Compression of geometry."""


@dataclass(frozen=True, kw_only=True)
class ExportSettings:
    """Settings of `export`: quality and compression of maps, geometry and textures.

    Parameters
    ----------
    face_size
        Texels along a face of the maps, a multiple of 64 up to 4096.
    samples
        Colour samples per texel, 1 to 1024.
    quality
        Quality of the WebP images of maps and textures, 0 to 100; None makes them lossless.
    range_error
        Greatest relative error of the maps' ranges, 10⁻⁶ to 0.005. If 16 bits do not suffice, the error is larger; the
        manifest states it.
    step
        Step in metres, 10⁻⁶ to 1, rounded down to a power of two. Positions are rounded to its multiples, so that
        neighbouring triangles stay joined. Beyond 2²³ steps from the scene's origin positions have the precision of
        float32.
    compression
        Compression of geometry: "meshopt" (`EXT_meshopt_compression`), or None for files that any glTF 2.0 reader
        loads.
    pixels_per_degree
        Resolution of the client's display in the middle of the picture, 1 to 500; 25 suits today's headsets. Textures
        are halved while their texels still suffice for its pixels at the nearest user position. Users stay within 1 m
        of a centre, or within half the distance to its farthest neighbour. None keeps full-size textures.
    split_px
        For clients that morph vertices and do not split triangles themselves: greatest error in pixels of the client's
        display, 0.001 to 1000 (see `pixels_per_degree`; if that is None, 60 pixels per degree). Large triangles of
        rings are split as by `nearfar.tessellate`, for the growth of their ring, all later radii, and the user
        positions above. Placements of a mesh that need no split still share it. At most 10 million triangles may be
        added to a region. None splits no triangle.
    speed
        Speed in degrees per second at which the picture turns while a ring grows, for a user 1 m from the centre; see
        `Growth`.
    by_footprint
        Whether to write the near objects a second time, ordered by footprint, with the full map of the last ring. The
        strategies vis0 and vis1, with which CloVR is compared, send these instead of rings.
    """

    face_size: int = 1024
    samples: int = 4
    quality: int | None = 90
    range_error: float = 2.0**-11
    step: float = 2.0**-10
    compression: Compression | None = "meshopt"
    pixels_per_degree: float | None = 25.0
    split_px: float | None = None
    speed: float = 0.7
    by_footprint: bool = False

    def __post_init__(self) -> None:
        pixels, split = self.pixels_per_degree, self.split_px
        checked: dict[str, Any] = {
            "face_size": check.integer("face_size", self.face_size, TILE, MAX_FACE_SIZE),
            "samples": check.integer("samples", self.samples, 1, MAX_SAMPLES),
            "quality": None if self.quality is None else check.integer("quality", self.quality, 0, 100),
            "range_error": check.in_range("range_error", self.range_error, 1e-6, MAX_RANGE_ERROR),
            "step": check.in_range("step", self.step, 1e-6, 1.0),
            "pixels_per_degree": None if pixels is None else check.in_range("pixels_per_degree", pixels, 1.0, 500.0),
            "split_px": None if split is None else check.in_range("split_px", split, 1e-3, 1e3),
            "speed": check.positive("speed", self.speed),
            "by_footprint": check.flag("by_footprint", self.by_footprint),
        }
        if self.compression is not None:
            check.choice("compression", self.compression, get_args(Compression))
        if checked["face_size"] % TILE:
            raise ValueError(f"face_size: expected a multiple of {TILE}, got {checked['face_size']}")
        set_fields(self, **checked)


class ExportKeywords(TypedDict, total=False):
    """Fields of `ExportSettings` as keywords of `export`; a test compares both."""

    face_size: int
    samples: int
    quality: int | None
    range_error: float
    step: float
    compression: Compression | None
    pixels_per_degree: float | None
    split_px: float | None
    speed: float
    by_footprint: bool
