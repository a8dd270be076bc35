"""The `Hmd` class: a headset's geometry as its runtime reports it, cameras of its eyes, and files."""

from __future__ import annotations

import math
import os
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from nearfar._base import card, check
from nearfar._base.settings import set_fields
from nearfar._camera.camera import Camera
from nearfar._lens.lens import RadialLens, check_symmetric
from nearfar.hmd import _file, _hmdq, _picture
from nearfar.hmd._eye import Eye, TotalFov, total_fov

CARDBOARD_LENSES = {"Cardboard I/O 2014 (V1)": (0.441, 0.156), "Cardboard I/O 2015 (V2)": (0.34, 0.55)}
"""Lens coefficients of viewers that have no profile, in the form of `Hmd.lens` with a `lens_radius` of 1, so that r is
the tangent itself. Source: immersive-web/cardboard-vr-display src/device-info.js."""
GENERIC_VIEWER = "Cardboard I/O 2015 (V2)"
GENERIC_LENS = RadialLens(CARDBOARD_LENSES[GENERIC_VIEWER])
"""Lens for headsets whose lens is unpublished, with a `lens_radius` of 1: the lens of the second Cardboard viewer."""
GENERIC_RADIUS = 1.0
"""Tangent at which the generic lens has r = 1."""
GENERIC_SOURCE = f"generic, that of {GENERIC_VIEWER}: immersive-web/cardboard-vr-display src/device-info.js"
"""Source of the generic lens, as `Hmd.sources` names it."""
EYES = ("left", "right")
"""Names of the eyes."""
IPDS = (0.04, 0.09)
"""Least and greatest distance between eyes, metres: from small children to a centimetre above the range of adults."""
LENS = "lens: "
"""Prefix of the lens's source in `Hmd.sources`."""
FORMATS = ("nearfar", "hmdq")
"""Names of the file formats that `Hmd.save` describes."""


@dataclass(frozen=True, kw_only=True)
class Hmd:
    """A headset as its runtime reports it.

    ValueError and TypeError for values that are out of range, in the wrong order or not finite.

    Parameters
    ----------
    name
        Name of the device.
    left, right
        The eyes: field of view, position and orientation on the head.
    render_size
        Width and height in pixels of an eye's picture that the runtime recommends, before the lens warp.
    panel_size
        Width and height in pixels of an eye's part of the panel; None if unknown.
    refresh_hz
        Number of pictures per second; None if unknown.
    lens
        The lens, if its coefficients are known in the form of `RadialLens`, without tangential terms. The coefficients
        of OpenHMD and Monado (panotools) have odd powers of r, which `RadialLens` cannot express.
    lens_radius
        Tangent of the angle at which r = 1; None stands for `tan_half_angle`.
    triangle_budget
        Least and greatest number of triangles per frame that the maker recommends; None if unpublished.
    hidden_area_percent
        Percentage of a view that the runtime's hidden-area mesh covers; None without a mesh.
    sources
        Sources of these data, one sentence each.
    """

    name: str
    left: Eye
    right: Eye
    render_size: tuple[int, int]
    panel_size: tuple[int, int] | None = None
    refresh_hz: float | None = None
    lens: RadialLens | None = None
    lens_radius: float | None = None
    triangle_budget: tuple[int, int] | None = None
    hidden_area_percent: float | None = None
    sources: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        if not check.text("name", self.name):
            raise ValueError("name: expected a name, got an empty string")
        for side in EYES:
            check.instance(side, getattr(self, side), Eye, "Eye")
        if self.lens is not None:
            check_symmetric(self.lens)
        for name, convert in _CONVERSIONS.items():
            value = getattr(self, name)
            if value is not None or name == "render_size":
                set_fields(self, **{name: convert(name, value)})
        set_fields(self, sources=tuple(check.texts("sources", self.sources)))

    @property
    def ipd(self) -> float:
        """Distance between the eyes, metres."""
        return math.dist(self.left.position, self.right.position)

    @property
    def tan_half_angle(self) -> float:
        """Greatest tangent to the left or right in either eye: the usual tangent at which a lens has r = 1."""
        return max(abs(tangent) for eye in (self.left, self.right) for tangent in (eye.fov.left, eye.fov.right))

    @property
    def half_angle(self) -> float:
        """Half the horizontal field of view ω in radians; the larger side of an asymmetric one."""
        return math.atan(self.tan_half_angle)

    @property
    def total_fov(self) -> TotalFov:
        """Total field of view of both eyes, degrees; hidden areas, which reduce it for some headsets, are ignored."""
        return total_fov(self.left, self.right)

    def camera(
        self,
        eye: str,
        position: ArrayLike,
        orientation: ArrayLike = (0.0, 0.0, 0.0, 1.0),
        *,
        size: tuple[int, int] | None = None,
    ) -> Camera:
        """Make the camera of an eye, "left" or "right", from the pose of the head.

        The pose is a world position in metres and a unit quaternion (x, y, z, w) that turns head axes into world axes.
        `size` in pixels is `render_size` by default.
        """
        viewer: Eye = getattr(self, check.choice("eye", eye, EYES))
        return viewer._camera(position, orientation, self.render_size if size is None else size)

    def with_ipd(self, ipd: float) -> Hmd:
        """Return the headset with the eyes `ipd` metres apart, 0.04 to 0.09, about the same middle.

        Almost all adults have 0.045 to 0.08 m, children from five years on at least 0.04 m (Dodgson 2004). ValueError
        for other distances, and for eyes in one place.
        """
        distance, (least, greatest) = check.number("ipd", ipd), IPDS
        if not least <= distance <= greatest:
            raise ValueError(f"ipd: expected {least:g} to {greatest:g}, in metres: 0.064, not 64; got {distance:g}")
        if self.ipd == 0.0:
            raise ValueError("ipd: expected eyes at different positions, which define the direction, got equal ones")
        left, right = np.array(self.left.position), np.array(self.right.position)
        half_offset, middle = (right - left) * (0.5 * distance / self.ipd), (left + right) / 2.0
        left_eye = replace(self.left, position=tuple((middle - half_offset).tolist()))
        return replace(self, left=left_eye, right=replace(self.right, position=tuple((middle + half_offset).tolist())))

    def with_lens(
        self, lens: RadialLens | None = None, *, lens_radius: float | None = None, source: str | None = None
    ) -> Hmd:
        """Return the headset with another lens, whose `lens_radius` is the tangent at which r = 1.

        None stands for the generic lens, `nearfar.hmd.GENERIC_LENS`, a published lens of another viewer, with its own
        radius; `lens_source` then begins with "generic". For other lenses, the radius is by default `tan_half_angle`,
        and `source` names the source of the coefficients in `sources`, by default "given by the caller". ValueError and
        TypeError for a lens with tangential terms, a radius that is not above 0, and a radius or source without a lens.
        """
        if lens is None:
            for name, value in (("lens_radius", lens_radius), ("source", source)):
                if value is not None:
                    got = check.value_or_type(value)
                    raise ValueError(f"{name}: expected None with the generic lens, which has its own, got {got}")
            lens, lens_radius, source = GENERIC_LENS, GENERIC_RADIUS, GENERIC_SOURCE
        others = tuple(text for text in self.sources if not text.startswith(LENS))
        source = check.text("source", "given by the caller" if source is None else source)
        return replace(self, lens=lens, lens_radius=lens_radius, sources=(*others, f"{LENS}{source}"))

    @property
    def lens_source(self) -> str:
        """Source of the lens, from `sources`: begins with "generic" for the generic lens; empty without a lens."""
        stated = [text.removeprefix(LENS) for text in self.sources if text.startswith(LENS)]
        return "" if self.lens is None else stated[0] if stated else "not stated"

    def save(self, path: str | os.PathLike[str], *, format: str = "nearfar") -> None:  # noqa: A002
        """Write the headset as JSON, atomically.

        `format` is "nearfar", which `load` reads back bit for bit, or "hmdq", for hmdq's viewer hmdv: only the
        geometry, because its format has no panel, lens, hidden area, budget and sources.
        """
        check.choice("format", format, FORMATS)
        write = _file.write if format == "nearfar" else _hmdq.write
        write(check.path("path", path), self._fields())

    @classmethod
    def load(cls, path: str | os.PathLike[str], *, runtime: str | None = None) -> Hmd:
        """Read a headset from a JSON file that `save` or hmdq (any version) wrote.

        A file of hmdq may have data of several runtimes: `runtime` is "openvr", "oculus" (the default view) or
        "oculus_max"; by default the first of these in the file. If hmdq recorded no name, the file's name is used.
        FormatError for other files, naming file and key; ValueError for a `runtime` with a file of nearfar; OSError if
        the file is missing.
        """
        file = check.path("path", path)
        if runtime is not None:
            check.choice("runtime", runtime, _hmdq.RUNTIMES)
        return cls._from_json(file.read_bytes(), os.fspath(file), runtime=runtime)

    @classmethod
    def _from_json(cls, text: bytes, where: str, *, runtime: str | None = None) -> Hmd:
        """Read a headset from the bytes of a file of either format; `where` names them in messages."""
        document = _file.parse(text, where)
        if _hmdq.is_hmdq(document):
            fields = _hmdq.fields(document, where, runtime)
        else:
            fields = _file.fields(document, where)
            if runtime is not None:
                raise ValueError(f"runtime: expected None for {where}, which is not an hmdq file, got {runtime!r}")
        return _file.convert(where, lambda: cls(**fields))

    @card.repr_html
    def _repr_html_(self) -> str:
        """Fields of view and figures for notebooks."""
        total, budget = self.total_fov, self.triangle_budget
        across, up, both = total.horizontal_deg, total.vertical_deg, total.overlap_deg
        texts = {
            "field of view": f"{across:.0f}° × {up:.0f}°, of which both eyes see {both:.0f}°",
            "picture": "{} × {} pixels an eye".format(*self.render_size),
            "panel": None if self.panel_size is None else "{} × {} pixels an eye".format(*self.panel_size),
            "refresh rate": None if self.refresh_hz is None else f"{self.refresh_hz:g} Hz",
            "distance of eyes": f"{1000.0 * self.ipd:.1f} mm",
            "budget": None if budget is None else f"{budget[0]:,} to {budget[1]:,} triangles a frame",
            "hidden area": None if self.hidden_area_percent is None else f"{self.hidden_area_percent:.3g} % of a view",
        }
        facts = [(name, text) for name, text in texts.items() if text is not None]
        return card.page(self.name, facts, _picture.fields(self.left, self.right, total), notes=self.sources)

    def _fields(self) -> dict[str, Any]:
        return {name: getattr(self, name) for name in self.__dataclass_fields__}


def _pixels(name: str, value: tuple[int, int]) -> tuple[int, int]:
    return check.pair(name, value, 1, check.MAX_SIZE)


def _budget(name: str, value: tuple[int, int]) -> tuple[int, int]:
    least, most = check.pair(name, value, 1, 1 << 40)
    if least > most:
        raise ValueError(f"{name}: expected the least number first, got {value}")
    return least, most


_CONVERSIONS: dict[str, Callable[[str, Any], Any]] = {
    "render_size": _pixels,
    "panel_size": _pixels,
    "refresh_hz": check.positive,
    "lens_radius": check.positive,
    "triangle_budget": _budget,
    "hidden_area_percent": partial(check.in_range, low=0.0, high=100.0),
}
"""Checks of the fields that hold numbers; all but the first may be None."""
