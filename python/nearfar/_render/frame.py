"""Frames: the images of one view, and their PNG and EXR files."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass, field, fields, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import background, card, check, exr, files, formats
from nearfar._base.pickling import WithStats
from nearfar._base.settings import set_fields
from nearfar._camera.camera import Camera, CubeFace, Fov, Orthographic
from nearfar._render import preview
from nearfar._render.channels import CHANNELS, VECTORS, missing

VERSION = 1
"""Version of the format of saved EXR frames."""


@dataclass(frozen=True, eq=False)
class Frame(WithStats):
    """The images of one view; None for images that were not rendered.

    Images are (H, W) or (H, W, 3), row 0 on top. Colour and coverage are means of all samples; all other images
    describe the hit of the ray through the pixel's centre.
    """

    camera: Camera
    """The view."""
    origin: tuple[float, float, float] = (0.0, 0.0, 0.0)
    """World position in metres that `position` is relative to, the scene's origin."""
    color: NDArray[np.float32] | None = field(default=None, repr=False)
    """(H, W, 3) float32, linear RGB in 0..1."""
    range: NDArray[np.float32] | None = field(default=None, repr=False)
    """(H, W) float32, metres from the camera to the displayed point (for parallel rays from the image plane); +inf
    where nothing was hit."""
    object_id: NDArray[np.int32] | None = field(default=None, repr=False)
    """(H, W) int32, index into the scene's `object_names`; −1 where nothing was hit."""
    face_id: NDArray[np.int64] | None = field(default=None, repr=False)
    """(H, W) int64, triangle number in the scene; −1 where nothing was hit."""
    position: NDArray[np.float32] | None = field(default=None, repr=False)
    """(H, W, 3) float32, metres: the unmorphed surface point relative to `origin`; NaN where nothing was hit."""
    normal: NDArray[np.float32] | None = field(default=None, repr=False)
    """(H, W, 3) float32, unit normal of the triangle, on the viewer's side; vertex normals affect only the colour. NaN
    where nothing was hit."""
    albedo: NDArray[np.float32] | None = field(default=None, repr=False)
    """(H, W, 3) float32, linear RGB of the material in 0..1, without light; NaN where no triangle was hit."""
    shading_normal: NDArray[np.float32] | None = field(default=None, repr=False)
    """(H, W, 3) float32, unit normal used for shading, interpolated between vertex normals if there are any; NaN where
    no triangle was hit."""
    coverage: NDArray[np.float32] | None = field(default=None, repr=False)
    """(H, W) float32, share of the pixel's colour samples that show a triangle, 0 to 1; neither sky nor map counts."""
    motion: NDArray[np.float32] | None = field(default=None, repr=False)
    """(H, W, 2) float32, motion of the pixel's surface since an earlier frame, pixels to the right and down; see
    `render`. NaN where it was behind the earlier camera."""

    lod: Any = field(default=None, repr=False)
    """Levels of detail drawn, if `lod` chose some: `levels` (N,) in the order of `Scene.leveled`, `triangles`,
    `full_triangles` and `selection`; None otherwise. Not saved to files."""
    stats: Mapping[str, Any] = field(default_factory=dict, repr=False)
    """Counts of a frame of a reduced scene, read-only; empty for other frames, and not saved to files.

    `frame_triangles`: triangles drawn after splitting (0 if the scene's own trees were traced). `dynamic_triangles`:
    moving triangles drawn in a separate pass (0 without such a pass). `tolerance_held`: whether `tolerance_px` was a
    proven bound. It is without a morph, and for "vertex" at full strength with the user at the camera, within 0.6 r1 of
    the centre for "blend" or 0.5 r1 for "cylinder". `opposed_directions`: vertices that user and centre see in opposite
    directions, which only happens if the user is outside the near cylinder. For pictures of a walk see `Walk.render`.
    """

    def __post_init__(self) -> None:
        check.instance("camera", self.camera, Camera)
        self._freeze_stats()
        set_fields(self, origin=check.vector("origin", self.origin))
        width, height = self.camera.size
        for name in self.channels:
            image = check.instance(name, getattr(self, name), np.ndarray, "an array")
            components = (3,) if name in VECTORS else (2,) if name == "motion" else ()
            expected = (height, width, *components)
            if image.shape != expected:
                raise ValueError(f"{name}: expected shape {expected} for the camera's size, got {image.shape}")

    @property
    def channels(self) -> tuple[str, ...]:
        """Names of the images that the frame has."""
        return tuple(name for name in CHANNELS if getattr(self, name) is not None)

    def require(self, channel: str) -> NDArray[Any]:
        """Return an image by name; if it was not rendered, a ValueError states the channels to render."""
        check.choice("channel", channel, CHANNELS)
        image: NDArray[Any] | None = getattr(self, channel)
        if image is None:
            raise missing(channel, self.channels)
        return image

    def to_image(self) -> NDArray[np.uint8]:
        """Convert colour to sRGB (H, W, 3) uint8, rounded to the nearest code; ValueError if there is no colour."""
        color = np.ascontiguousarray(self.require("color"), np.float32)
        return _core.encode_srgb(color).reshape(color.shape)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the frame atomically, as `.png` (colour, 8 bits, sRGB) or `.exr` (all images, lossless).

        In an EXR file colour is `R`, `G`, `B` (float32, linear), range is `range` (float32, metres, +inf kept), vectors
        are `position.X` … `albedo.B`. Numbers are unsigned 32-bit in two's complement; the upper half of `face_id` is
        in `face_id_high`. The header contains the camera. ValueError for another suffix, and a PNG of a frame without
        colour; OSError if the file cannot be written.
        """
        target = check.path("path", path, ".png", ".exr")
        if target.suffix.lower() == ".png":
            files.write_png(target, self.to_image())
        else:
            exr.write(target, {"frame": background.run(lambda: _exr_channels(self))}, _document(self))

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Frame:
        """Read an `.exr` file that `save` wrote; FormatError for other files and newer versions."""
        path = check.path("path", path)
        document, parts = exr.read(path, "frame", VERSION)
        with formats.guarded(path, "frame"):
            channels = parts["frame"]
            camera, origin = _camera(document["camera"]), document["origin"]
            images: dict[str, Any] = background.run(lambda: _images(channels))
            return cls(camera, (origin[0], origin[1], origin[2]), **images)

    def _preview(self) -> tuple[str, NDArray[np.uint8]]:
        """Return the name and a picture of the most informative image; StopIteration without images."""
        name = next(name for name in preview.CAPTIONS if name in self.channels)
        return name, preview.pixels(name, card.subsample(self.require(name)))

    @card.repr_png
    def _repr_png_(self) -> NDArray[np.uint8]:
        """Picture for notebooks without HTML."""
        return self._preview()[1]

    @card.repr_html
    def _repr_html_(self) -> str:
        """Picture for notebooks, with size and channels below."""
        name, pixels = self._preview()
        width, height = self.camera.size
        caption = f"{width} × {height} pixels of {', '.join(self.channels)}; shown: {preview.CAPTIONS[name]}"
        return card.page("Frame", (), card.picture(pixels, preview.CAPTIONS[name], caption))


def blend(old: Frame, new: Frame, share: float) -> Frame:
    """Cross-fade two frames of one camera: return the newer frame with a linear blend of both colours.

    `share` is the weight of the newer frame, 0 to 1. ValueError for frames without colour or of different sizes.
    """
    old_color = check.instance("old", old, Frame).require("color")
    new_color = check.instance("new", new, Frame).require("color")
    weight = np.float32(check.in_range("share", share, 0.0, 1.0))
    if old_color.shape != new_color.shape:
        sizes = f"the old one's shape {old_color.shape[:2]}, got {new_color.shape[:2]}"
        raise ValueError(f"new: expected a frame of {sizes}")
    return replace(new, color=old_color + weight * (new_color - old_color))


_AXES = {"color": ("R", "G", "B"), "motion": ("motion.X", "motion.Y")} | {
    name: tuple(f"{name}.{axis}" for axis in ("RGB" if name == "albedo" else "XYZ")) for name in VECTORS[1:]
}


def _exr_channels(frame: Frame) -> dict[str, NDArray[Any]]:
    """Split a frame's images into two-dimensional channels of OpenEXR's types."""
    channels: dict[str, NDArray[Any]] = {}
    for name in frame.channels:
        image = frame.require(name)
        if name in _AXES:
            channels |= {axis: np.ascontiguousarray(image[..., i], np.float32) for i, axis in enumerate(_AXES[name])}
        elif name in ("range", "coverage"):
            channels[name] = np.ascontiguousarray(image, np.float32)
        else:
            bits = image.astype(np.int64).view(np.uint64)
            channels[name] = (bits & 0xFFFFFFFF).astype(np.uint32)
            if name == "face_id":
                channels["face_id_high"] = (bits >> 32).astype(np.uint32)
    if not channels:
        raise ValueError("frame has no images: render it with at least one channel")
    return channels


def _images(channels: exr.Channels) -> dict[str, NDArray[Any]]:
    return {name: _image(name, channels) for name in CHANNELS if _AXES.get(name, (name,))[0] in channels}


def _image(name: str, channels: exr.Channels) -> NDArray[Any]:
    """Join channels to an image."""
    if name in _AXES:
        return np.stack([exr.check_kind("f", channels[axis]) for axis in _AXES[name]], axis=-1)
    if name in ("range", "coverage"):
        return exr.check_kind("f", channels[name])
    numbers = exr.check_kind("u", channels[name])
    if name == "object_id":
        return numbers.view(np.int32)
    high = exr.check_kind("u", channels["face_id_high"]).astype(np.uint64)
    numbers_64: NDArray[Any] = high << np.uint64(32) | numbers
    return numbers_64.view(np.int64)


def _document(frame: Frame) -> dict[str, Any]:
    camera, fov = frame.camera, frame.camera.fov
    view = {
        "position": camera.position,
        "orientation": camera.orientation,
        "projection": type(fov).__name__,
        "bounds": [getattr(fov, side.name) for side in fields(fov)],
        "size": camera.size,
    }
    return formats.header("frame", VERSION, origin=list(frame.origin), color_space="linear", camera=view)


def _camera(document: dict[str, Any]) -> Camera:
    kinds: dict[str, type[Fov | Orthographic | CubeFace]] = {k.__name__: k for k in (Fov, Orthographic, CubeFace)}
    fov = kinds[document["projection"]](*document["bounds"])
    return Camera(document["position"], document["orientation"], fov=fov, size=document["size"])
