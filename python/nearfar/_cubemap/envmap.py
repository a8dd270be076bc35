"""Environment maps: cube maps of colour, range and objects around a point, with look-up and files."""

from __future__ import annotations

import os
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import background, card, check, exr, files, formats
from nearfar._base.settings import set_fields
from nearfar._cubemap.layouts import convert_envmap
from nearfar._cubemap.lookup import FILTERS, Filter, cube_lookup

FACES = ("px", "nx", "py", "ny", "pz", "nz")
"""Names of the faces in files."""

CHANNELS = ("color", "range", "object_id")
"""Channels that a map may have."""

HALF_LIMIT = 65504.0
"""Greatest finite float16."""

VERSION = 1
"""Version of the format of saved maps."""

PREVIEW = (180, 360)
"""Height and width in pixels of the picture that notebooks show."""


@dataclass(frozen=True, eq=False)
class EnvMap:
    """Cube map of the surroundings of a point: colour in every direction, optionally range and object numbers.

    Six faces +x −x +y −y +z −z of S×S texels in the Vulkan/WebGPU orientation. The arrays become read-only. ValueError
    and TypeError for arrays of wrong shapes or types, colours that are not finite, ranges that are NaN or below 0.
    """

    center: tuple[float, float, float]
    """World position in metres that the map was baked from."""
    color: NDArray[np.float32] = field(repr=False)
    """(6, S, S, 3) float32, linear RGB."""
    range: NDArray[np.float32] | NDArray[np.float16] | None = field(default=None, repr=False)
    """(6, S, S) float32 or float16, metres from the centre; +inf where nothing is visible. None if it was not baked.

    float16 takes half the memory and ends at 65,504 m; from 2⁻¹⁴ m on its relative error is at most 2⁻¹¹.
    """
    object_id: NDArray[np.int32] | None = field(default=None, repr=False)
    """(6, S, S) int32, index into the scene's `object_names`; −1 where nothing is visible. None if not baked."""
    object_names: tuple[str, ...] = field(default=(), repr=False)
    """Names of the objects by number; empty if unknown."""

    def __post_init__(self) -> None:
        set_fields(self, center=check.vector("center", self.center))
        shape = check.plain("color", self.color).shape
        size = shape[1] if len(shape) == 4 else 0
        for name in CHANNELS:
            values = getattr(self, name)
            if values is None and name != "color":
                continue
            array = check.array(name, values, columns=None, dtype=_kind(name, values)).view()
            expected = (6, size, size, 3) if name == "color" else (6, size, size)
            if size == 0 or array.shape != expected:
                raise ValueError(f"{name}: expected shape (6, S, S{', 3' * (name == 'color')}), got {array.shape}")
            _check_values(name, array)
            array.flags.writeable = False
            set_fields(self, **{name: array})
        set_fields(self, object_names=tuple(check.texts("object_names", self.object_names)))

    @property
    def face_size(self) -> int:
        """Number of texels across a face, S."""
        return int(self.color.shape[1])

    @property
    def channels(self) -> tuple[str, ...]:
        """Names of the channels that the map has."""
        return tuple(name for name in CHANNELS if getattr(self, name) is not None)

    @property
    def nbytes(self) -> int:
        """Size of all channels in bytes."""
        return sum(getattr(self, name).nbytes for name in self.channels)

    def sample(
        self,
        directions: ArrayLike,
        *,
        channel: str = "color",
        filter: Filter | None = None,  # noqa: A002
        radius: float | None = None,
    ) -> NDArray[Any]:
        """Look up a channel, "color", "range" or "object_id", along world directions (..., 3) of any length.

        `filter` and `radius` are as in `cube_lookup`; `radius` is the half-angle in radians of the cone about each
        direction that "min" and "max" search. The default filter is "linear" for colour and "nearest" for the other
        channels. Ranges are never averaged, because no surface lies at the mean range across a silhouette. Returns
        (..., 3) linear RGB, (...) metres (float32) or (...) object numbers. ValueError for a channel that was not
        baked, and a filter that does not fit it.
        """
        check.choice("channel", channel, CHANNELS)
        values = getattr(self, channel)
        if values is None:
            raise ValueError(f"channel: expected a baked one ({', '.join(self.channels)}), got {channel!r}")
        default: Filter = "linear" if channel == "color" else "nearest"
        filter_name = default if filter is None else check.choice("filter", filter, FILTERS)
        if channel == "range" and filter_name in ("linear", "cubic"):
            raise ValueError(f"filter: expected 'nearest', 'min' or 'max' for range, got {filter_name!r}")
        if channel == "object_id" and filter_name != "nearest":
            raise ValueError(f"filter: expected 'nearest' for object_id, got {filter_name!r}")
        faces = values.astype(np.float32) if values.dtype == np.float16 else values
        return cube_lookup(faces, directions, filter=filter_name, radius=radius)

    def save(self, path: str | os.PathLike[str], *, half: bool = True) -> None:
        """Write the map to an OpenEXR file, whose name ends in `.exr`, atomically.

        The file has one part for each face, `px nx py ny pz nz`, with the channels `R G B` and, if the map has them,
        `range` (in its own type, exact, +inf kept) and `object_id` (unsigned, two's complement). Compression is
        lossless. The attribute `nearfar` stores centre and object names as JSON; the attribute `center` repeats the
        centre for other programs, rounded to float32. `half` stores colour as 16-bit floats: half the size, with a
        relative error of at most 2⁻¹¹, a quarter of a step of 8-bit sRGB. Without `half`, float32 is stored bit for
        bit.

        ValueError for another suffix, and colours beyond 65,504 with `half`; TypeError for anything but a string or a
        path; OSError if the file cannot be written.
        """
        target = check.path("path", path, ".exr")
        brightest = max(float(np.abs(face).max()) for face in self.color)
        if check.flag("half", half) and brightest > HALF_LIMIT:
            raise ValueError(f"half: expected False for colours up to {brightest:g}, beyond {HALF_LIMIT:g}, got True")
        kind = np.float16 if half else np.float32
        parts: dict[str, dict[str, NDArray[Any]]] = {}
        for face, name in enumerate(FACES):
            color = self.color[face]
            parts[name] = {axis: np.ascontiguousarray(color[..., i], kind) for i, axis in enumerate("RGB")}
            if self.range is not None:
                parts[name]["range"] = self.range[face]
            if self.object_id is not None:
                parts[name]["object_id"] = self.object_id[face].view(np.uint32)
        document = formats.header(
            "envmap",
            VERSION,
            color_space="linear",
            center=list(self.center),
            orientation="Vulkan/WebGPU cube faces",
            object_names=list(self.object_names),
        )
        exr.write(target, parts, document, {"center": self.center})

    def save_equirectangular(self, path: str | os.PathLike[str], *, height: int | None = None) -> None:
        """Write the colour as one equirectangular picture, atomically, for programs without cube maps.

        `.exr` is linear, 16-bit floats, with channels `R G B`; `.png` is sRGB, 8 bits. The middle of the picture shows
        −z, and +x is to the right of it, as in `convert_envmap`. The picture has H = `height` rows and 2 H columns; by
        default H is twice the face size, which makes its pixels as fine as the map's texels. ValueError for another
        suffix, and colours beyond 65,504 in an EXR file; TypeError for anything but a string or a path; OSError if the
        file cannot be written.
        """
        target = check.path("path", path, ".exr", ".png")
        rows = 2 * self.face_size if height is None else check.integer("height", height, 1, 2**15)
        color = convert_envmap(self.color, source="cube", target="equirectangular", size=rows)
        if target.suffix.lower() == ".png":
            codes = _core.encode_srgb(np.ascontiguousarray(color, np.float32)).reshape(color.shape)
            files.write_png(target, codes)
            return
        if (brightest := float(np.abs(color).max())) > HALF_LIMIT:
            raise ValueError(f"path: expected .png for colours up to {brightest:g}, beyond {HALF_LIMIT:g}, got .exr")
        channels = {axis: np.ascontiguousarray(color[..., i], np.float16) for i, axis in enumerate("RGB")}
        document = formats.header("equirectangular", 1, color_space="linear", center=list(self.center))
        exr.write(target, {"color": channels}, document, {"center": self.center})

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> EnvMap:
        """Read a file that `save` wrote; FormatError for other files and newer versions, OSError if it is missing."""
        path = check.path("path", path)
        document, parts = exr.read(path, "envmap", VERSION)
        with formats.guarded(path, "environment map"):
            images: dict[str, Any] = background.run(lambda: _images([parts[name] for name in FACES]))
            return cls(document["center"], **images, object_names=document.get("object_names", ()))

    def _preview(self) -> tuple[float, NDArray[np.uint8]]:
        """Return the map as a small equirectangular picture, and the factor that its colours were multiplied by."""
        # A single look-up per pixel would alias on fine maps; 16 take a few milliseconds for maps of any size.
        spread = min(4, max(1, round(4 * self.face_size / PREVIEW[1])))
        picture = convert_envmap(self.color, source="cube", target="equirectangular", size=PREVIEW, samples=spread)
        exposure = 1.0 / max(1.0, float(np.percentile(picture, 99.0)))
        return exposure, _core.encode_srgb(np.ascontiguousarray(picture * np.float32(exposure))).reshape(picture.shape)

    @card.repr_png
    def _repr_png_(self) -> NDArray[np.uint8]:
        """Picture for notebooks without HTML."""
        return self._preview()[1]

    @card.repr_html
    def _repr_html_(self) -> str:
        """Picture for notebooks: all directions, −z in the middle and +x to the right of it."""
        exposure, pixels = self._preview()
        dimmed = f"; colours × {exposure:.2g}" if exposure < 1.0 else ""
        facts = [
            ("faces", f"6 × {self.face_size} × {self.face_size} texels, {self.nbytes / 1e6:,.1f} MB"),
            ("channels", ", ".join(self.channels)),
            ("centre", card.point(self.center)),
        ]
        caption = f"all directions, −z in the middle, +x to the right{dimmed}"
        return card.page("EnvMap", facts, card.picture(pixels, "equirectangular map", caption))


def _check_values(channel: str, values: NDArray[Any]) -> None:
    """Raise ValueError for colours that are not finite and for NaN and negative ranges; sums and minima reveal them."""
    if channel == "color" and not (np.isfinite(values.sum(dtype=np.float64)) or np.isfinite(values).all()):
        raise ValueError("color: expected finite numbers, got some that are not")
    if channel == "range" and not values.min() >= 0.0:
        raise ValueError(f"range: expected metres of at least 0 or +inf, got {values.min()}")


def to_half(ranges: NDArray[np.float32]) -> NDArray[np.float16]:
    """Round ranges in metres to float16, keeping +inf; ValueError if a finite one exceeds 65,504 m."""
    farthest = float(np.max(ranges, initial=0.0, where=np.isfinite(ranges)))
    if farthest > HALF_LIMIT:
        raise ValueError(
            f"range_dtype: expected float32 for a map that reaches {farthest:,.0f} m, got float16, "
            f"which ends at {HALF_LIMIT:,.0f} m"
        )
    return ranges.astype(np.float16)


def _kind(channel: str, values: Any) -> type[np.generic]:
    """Return the type in which a map stores a channel."""
    if channel == "object_id":
        return np.int32
    return np.float16 if channel == "range" and getattr(values, "dtype", None) == np.float16 else np.float32


def _images(faces: list[exr.Channels]) -> dict[str, NDArray[Any]]:
    """Join the channels of six faces to images."""
    color = np.stack([np.stack([face[axis] for axis in "RGB"], axis=-1) for face in faces])
    images: dict[str, NDArray[Any]] = {"color": exr.check_kind("f", color).astype(np.float32, copy=False)}
    if "range" in faces[0]:
        images["range"] = exr.check_kind("f", np.stack([face["range"] for face in faces]))
    if "object_id" in faces[0]:
        images["object_id"] = exr.check_kind("u", np.stack([face["object_id"] for face in faces])).view(np.int32)
    return images
