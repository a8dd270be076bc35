"""Settings of impostors: the users' region, the error, texels, and budgets."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypedDict

import numpy as np

from nearfar._base import check
from nearfar._base.settings import set_fields

MAX_ERROR_PX = 100.0
"""Greatest error, pixels."""
MAX_FACE_SIZE = 8192
"""Greatest width of a face of a layer's cube map, texels."""
MIN_FACE_SIZE = 64
MAX_CENTERS = 64


@dataclass(frozen=True, kw_only=True)
class ImpostorSettings:
    """Settings of impostors: the users' region, the error, texels, and budgets for near and far part together.

    ValueError and TypeError for settings out of range.

    Parameters
    ----------
    reach
        Radius in metres, less than r2, of the sphere about O within which the error holds for users' eyes. None is the
        lesser of 8 m and half of r2.
    height
        Distance in metres, at least 0, that users' eyes are expected to move above and below O: probes there look for
        what is missing. The error holds in the whole sphere. None is the lesser of 0.5 m and half of `reach`.
    error_px
        Greatest angle, in pixels of a headset with 20 pixels per degree, above 0 to 100, by which a user within `reach`
        sees the centre of a texel beside its place.
    face_size
        Number of texels across each face of a centre's cube map, 64 to 8192. 1024 is 11 texels per degree.
    centers
        Greatest number of centres, 1 to 64.
    missing
        Share of the pixels of the region's probes, 0 to 1, that may be missing when no centre is added.
    triangles
        Greatest number of triangles of near and far part together, at least 1; None for no limit. If they are more,
        `error_px` grows, up to 8 px, by at most four more bakes. If they are still more, the quads that show fewest
        texels are dropped, which leaves holes; the result's `stats` count them.
    bytes
        Greatest size of the file `light.glb` with its default compression, at least 1; None for no limit. If it is
        larger, `face_size` falls and `error_px` grows, by at most four more bakes; then quads are dropped as above.
    visible
        True drops near static triangles that no user sees, as far as the rays of the bake tell. `stats["changed"]` is
        the share of the pixels of other users within `reach` that this changes. Far triangles that users see then stay
        geometry instead of quads if they are no more and take no more bytes.
    """

    reach: float | None = None
    height: float | None = None
    error_px: float = 2.0
    face_size: int = 1024
    centers: int = 16
    missing: float = 0.0005
    triangles: int | None = None
    bytes: int | None = None
    visible: bool = True

    def __post_init__(self) -> None:
        error = check.positive("error_px", self.error_px)
        most = np.iinfo(np.int64).max
        set_fields(
            self,
            reach=None if self.reach is None else check.positive("reach", self.reach),
            height=None if self.height is None else check.at_least_zero("height", self.height),
            error_px=check.in_range("error_px", error, 0.0, MAX_ERROR_PX),
            face_size=check.integer("face_size", self.face_size, MIN_FACE_SIZE, MAX_FACE_SIZE),
            centers=check.integer("centers", self.centers, 1, MAX_CENTERS),
            missing=check.in_range("missing", self.missing, 0.0, 1.0),
            triangles=None if self.triangles is None else check.integer("triangles", self.triangles, 1, most),
            bytes=None if self.bytes is None else check.integer("bytes", self.bytes, 1, most),
            visible=check.flag("visible", self.visible),
        )


def height_of(settings: ImpostorSettings, reach: float) -> float:
    """Return the height of a region for its radius, both in metres."""
    return min(0.5, 0.5 * reach) if settings.height is None else min(settings.height, reach)


class ImpostorKeywords(TypedDict, total=False):
    """Fields of `ImpostorSettings` as keywords; a test compares both."""

    reach: float | None
    height: float | None
    error_px: float
    face_size: int
    centers: int
    missing: float
    triangles: int | None
    bytes: int | None
    visible: bool
