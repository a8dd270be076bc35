"""Settings of all functions that render pictures: samples, limits of rays, channels, backend and levels."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, fields
from typing import TypedDict

from nearfar._base.settings import set_fields
from nearfar._camera.clip import Clip
from nearfar._camera.shot import Sampling
from nearfar._render import backend as backends
from nearfar._render.backend import Backend
from nearfar._render.channels import channel_names
from nearfar._render.level_choice import Lod


@dataclass(frozen=True, kw_only=True)
class RenderSettings(Sampling):
    """Settings of pictures: samples, limits of rays, channels, backend and levels of detail.

    ValueError and TypeError for settings out of range.

    Parameters
    ----------
    samples
        Number of colour samples of each pixel, spread evenly over its square, 1 to 1024. The channels "color"
        and "coverage" use all of them; the other channels are sampled once, at the pixel's centre. Trees of orthoviews
        take samples on a grid: 1, 4, 9 … 64.
    t_min, t_max
        Limits in metres along each pixel's ray, measured from the eye, or from the image plane if the rays are
        parallel; surfaces nearer than `t_min` or farther than `t_max` are not drawn. For reduced scenes they limit the
        displayed distance of near geometry and moving objects; the map is drawn only if `t_max` is infinite, and only
        where its range, if it has any, is at least `t_min`.
    clip
        Planes and a box; nothing outside them is drawn. Reduced scenes are limited by displayed position, and their map
        is drawn only in pixels whose ray no plane cuts off. A splat is drawn if its centre is within the limits.
    channels
        Images to compute, from "color", "range", "object_id", "face_id", "position", "normal", "albedo",
        "shading_normal", "coverage" and "motion"; see `Frame`. None for the source's `default_channels`: colour, range
        and object_id for a scene, the channels of its map for a reduced scene, colour and range for a tree of
        orthoviews.
    backend
        "cpu" traces rays. "gpu" draws with the graphics adapter that `nearfar.gpu.select` or NEARFAR_ADAPTER names, or
        the best one. "auto" uses that adapter if it is hardware, or if it was measured to be faster for such pictures
        of this scene (`nearfar.gpu.measure`); otherwise it traces rays and logs the reason, once per machine. None
        chooses as "auto" does, but logs only if an adapter was named.
    lod
        Level of detail of objects with levels (`Scene.with_levels`). None draws level 0. The names "off", "depth",
        "depth+eccentricity" and "fovea" are modes of `nearfar.lod.select` with default settings and no lens. Pass a
        `nearfar.lod.Selector`, which may have a lens, or a function with the signature of `select`, to choose levels
        for this camera; objects that it reports as out of view are not drawn. Levels may also be given as for
        `Scene.at_levels`. Each object is drawn at one level; game engines that load an exported model may fade between
        two. The map of a reduced scene shows far objects at the levels that were baked.
    """

    channels: Iterable[str] | None = None
    backend: Backend | None = None
    lod: Lod | None = None

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.channels is not None:
            set_fields(self, channels=channel_names(self.channels))
        backends.check(self.backend)


class RenderKeywords(TypedDict, total=False):
    """Fields of `RenderSettings` as keywords; a test compares both."""

    samples: int
    t_min: float
    t_max: float
    clip: Clip | None
    channels: Iterable[str] | None
    backend: Backend | None
    lod: Lod | None


def require_defaults(settings: RenderSettings, function: str, *names: str) -> None:
    """Raise ValueError if one of the named fields, which a function cannot use, differs from its default."""
    for field in fields(settings):
        value = getattr(settings, field.name)
        if field.name in names and value != field.default:
            raise ValueError(f"{field.name}: expected {field.default} for {function}, which cannot use it, got {value}")
