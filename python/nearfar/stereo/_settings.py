"""Settings of the pictures of a rig: culling, assembly and depths."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal, TypedDict, get_args

from nearfar._base import check
from nearfar._base.settings import set_fields
from nearfar._render.settings import RenderKeywords

Cull = Literal["frustum", "discard", "occlusion"]
"""Name of a culling mode for pixels and geometry of the shared picture that no eye needs."""

Assembly = Literal["bilinear", "resolved"]
"""Name of a way to look up the shared picture."""

UNUSED = ("t_min", "t_max", "clip")
"""Fields of `RenderSettings` that the pictures of a rig cannot use: depths limit them."""


@dataclass(frozen=True, kw_only=True)
class HybridSettings:
    """Settings of hybrid pictures: culling, look-up of the shared picture, and depths.

    ValueError and TypeError for settings out of range.

    Parameters
    ----------
    cull
        Pixels of the shared picture to draw. "frustum" draws all pixels, "discard" only the pixels that an eye looks
        up; "occlusion" also leaves out geometry that is completely occluded. The eyes' pictures do not depend on it.
        The tracer needs no culling of geometry, so its "occlusion" equals "discard".
    assembly
        How eyes look up the shared picture. "bilinear" interpolates four pixels, as graphics adapters do, which softens
        textures and edges. "resolved", for scenes only, intersects the third camera's ray with the triangles that these
        four pixels show, and shades the nearest hit. The CPU assembles the pictures of graphics adapters, too.
    near, far
        Depths in metres in front of the eyes between which surfaces are drawn, 0 < near < far.
    """

    cull: Cull = "occlusion"
    assembly: Assembly = "bilinear"
    near: float = 0.1
    far: float = math.inf

    def __post_init__(self) -> None:
        check.choice("cull", self.cull, get_args(Cull))
        check.choice("assembly", self.assembly, get_args(Assembly))
        near, far = check_depths(check.positive("near", self.near), self.far)
        set_fields(self, near=near, far=far)


class HybridKeywords(TypedDict, total=False):
    """Fields of `HybridSettings` as keywords; a test compares both."""

    cull: Cull
    assembly: Assembly
    near: float
    far: float


def check_depths(near: float, far: float) -> tuple[float, float]:
    """Check depths in metres in front of the eyes, 0 ≤ near < far; ValueError or TypeError otherwise."""
    nearest, farthest = check.at_least_zero("near", near), check.number("far", far, finite=False)
    if not farthest > nearest:
        raise ValueError(f"far: expected more than near, {nearest:g} m, got {farthest:g}")
    return nearest, farthest


class HybridOptions(RenderKeywords, HybridKeywords, total=False):
    """Keywords of the functions that render a rig."""
