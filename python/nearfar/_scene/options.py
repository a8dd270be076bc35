"""Options for loading a file: axes and unit, limits, and the part of a world to read."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar, Literal, TypedDict, get_args

from numpy.typing import ArrayLike

from nearfar._base import check
from nearfar._base.settings import Alternatives
from nearfar._scene.city.levels import parse_max_level
from nearfar._scene.frames import checked_origin

Up = Literal["x", "y", "z", "-x", "-y", "-z"]
"""Axis that points up."""

OnInvalid = Literal["raise", "drop"]
"""Treatment of faces with invalid vertices."""

Blend = Literal["opaque", "cutout"]
"""How blending materials are drawn."""


@dataclass(frozen=True, kw_only=True)
class LoadOptions(Alternatives):
    """Options of `Scene.load` and `open_source`.

    ValueError and TypeError for options out of range, or both `error` and `triangles`.

    Parameters
    ----------
    up
        Axis of the file that points up: "x", "y", "z", "-x", "-y" or "-z"; it is turned to y.
    scale
        Metres per unit of the file, greater than 0. None for the unit that the file states, or the metre if it states
        none; `Scene.report` notes extents that suggest another unit.
    on_invalid
        Treatment of faces with vertices that are not finite or do not exist: "raise" raises `SceneError`, "drop" leaves
        them out, and `Scene.report` counts them.
    max_bytes
        Bytes that the file may unpack to, at least 1. None for a hundred times the bytes read, but at least 256 MiB and
        at most 16 GiB.
    blend
        How blending materials are drawn: "opaque", or "cutout", which omits fragments with alpha below ½.
        `Scene.report` counts these materials.
    error
        For a tileset, its maximum geometric error in metres, at least 0. None for all detail. Not with `triangles`.
    triangles
        For a tileset, its maximum number of triangles, 1 to 2⁴⁰; tiles with large errors are refined first. None for
        all detail.
    origin
        Longitude and latitude in degrees and height in metres of (0, 0, 0), for tilesets on the Earth and footprints in
        degrees; x points east, y up and z south there. None for the middle of the data, which `Scene.report` states.
    lod
        Maximum level of detail of CityJSON, such as "2.2"; 2 includes all of 2.x. None for the highest of each object.
    height
        Property that states the height of footprints in metres. None for the usual names.
    """

    _alternatives: ClassVar = (("error",), ("triangles",))

    up: Up = "y"
    scale: float | None = None
    on_invalid: OnInvalid = "raise"
    max_bytes: int | None = None
    blend: Blend = "opaque"
    error: float | None = None
    triangles: int | None = None
    origin: ArrayLike | None = None
    lod: str | float | None = None
    height: str | None = None

    def __post_init__(self) -> None:
        check.choice("up", self.up, get_args(Up))
        check.choice("on_invalid", self.on_invalid, get_args(OnInvalid))
        check.choice("blend", self.blend, get_args(Blend))
        if self.error is not None and self.triangles is not None:
            raise ValueError("triangles: expected None if error is given, got both")
        checks: dict[str, Any] = {
            "scale": check.positive,
            "max_bytes": lambda name, value: check.integer(name, value, 1, 1 << 62),
            "error": check.at_least_zero,
            "triangles": lambda name, value: check.integer(name, value, 1, 1 << 40),
            "origin": lambda _, value: checked_origin(value),
            "height": check.text,
        }
        for name, convert in checks.items():
            if getattr(self, name) is not None:
                object.__setattr__(self, name, convert(name, getattr(self, name)))
        if self.lod is not None:
            parse_max_level(self.lod)  # only checked: reports state the level as the caller wrote it

    @property
    def drops(self) -> bool:
        """Whether faces with invalid vertices are left out."""
        return self.on_invalid == "drop"

    @property
    def max_level(self) -> float | None:
        """Maximum level of detail of CityJSON as a number."""
        return None if self.lod is None else parse_max_level(self.lod)


class LoadKeywords(TypedDict, total=False):
    """Fields of `LoadOptions` as keywords of `Scene.load` and `open_source`; a test compares both."""

    up: Up
    scale: float | None
    on_invalid: OnInvalid
    max_bytes: int | None
    blend: Blend
    error: float | None
    triangles: int | None
    origin: ArrayLike | None
    lod: str | float | None
    height: str | None
