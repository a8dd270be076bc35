"""Frames: the images of one view, and the files they become."""

from __future__ import annotations

import os
from dataclasses import dataclass, field, fields
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import exr, files, formats
from nearfar._camera.camera import Camera, CubeFace, Fov, Orthographic
from nearfar._render.channels import CHANNELS

VERSION = 1
"""Of the EXR files that frames are saved as."""


@dataclass(frozen=True, eq=False)
class Frame:
    """The images of one view; those that were not rendered are None.

    Images are (H, W) or (H, W, 3), row 0 on top. Colour is anti-aliased where the renderer was asked to; all other
    images hold what the ray through the pixel's centre met.
    """

    camera: Camera
    """The view."""
    origin: tuple[float, float, float] = (0.0, 0.0, 0.0)
    """World position in metres that `position` is relative to: the scene's origin."""
    color: NDArray[np.float32] | None = field(default=None, repr=False)
    """(H, W, 3) float32, linear RGB in 0..1."""
    range: NDArray[np.float32] | None = field(default=None, repr=False)
    """(H, W) float32, metres from the camera to what is displayed (for parallel rays from the image plane); +inf where
    nothing was hit."""
    object_id: NDArray[np.int32] | None = field(default=None, repr=False)
    """(H, W) int32, index into the scene's `object_names`; −1 where nothing was hit."""
    face_id: NDArray[np.int64] | None = field(default=None, repr=False)
    """(H, W) int64, triangle number in the scene; −1 where nothing was hit."""
    position: NDArray[np.float32] | None = field(default=None, repr=False)
    """(H, W, 3) float32, metres: the unmorphed surface point relative to `origin`; NaN where nothing was hit."""
    normal: NDArray[np.float32] | None = field(default=None, repr=False)
    """(H, W, 3) float32, unit normal of the triangle towards the viewer, whatever normals of vertices the colour takes;
    NaN where nothing was hit."""

    lod: Any = field(default=None, repr=False)
    """What was drawn of objects with levels of detail, where `lod` chose some: their `levels` (N,) in the order of
    `Scene.leveled`, `triangles`, `full_triangles` and the `selection`; else None. Files don't keep it."""

    def __post_init__(self) -> None:
        width, height = self.camera.size
        for name in self.channels:
            image = getattr(self, name)
            expected = (height, width, 3) if name in ("color", "position", "normal") else (height, width)
            if image.shape != expected:
                raise ValueError(f"{name}: expected shape {expected} for the camera's size, got {image.shape}")

    @property
    def channels(self) -> tuple[str, ...]:
        """Names of the images that the frame holds."""
        return tuple(name for name in CHANNELS if getattr(self, name) is not None)

    def require(self, channel: str) -> NDArray[Any]:
        """Return an image by name; ValueError with the channels to ask for where it was not rendered."""
        if channel not in CHANNELS:
            raise ValueError(f"channel: expected one of {', '.join(CHANNELS)}, got {channel!r}")
        image: NDArray[Any] | None = getattr(self, channel)
        if image is None:
            wanted = tuple(name for name in CHANNELS if name in {channel, *self.channels})
            raise ValueError(f"frame has no {channel}: render it with channels={wanted!r}")
        return image

    def to_image(self) -> NDArray[np.uint8]:
        """Colour as (H, W, 3) uint8 in sRGB, rounded to the nearest code; ValueError where there is no colour."""
        color = np.ascontiguousarray(self.require("color"), np.float32)
        return _core.encode_srgb(color).reshape(color.shape)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the frame to a file, whole or not at all.

        Parameters
        ----------
        path
            `.png`: colour, 8 bits, sRGB. `.exr`: all images, lossless. Colour is `R`, `G`, `B` (float32, linear),
            range `range` (float32, metres, +inf kept), vectors `position.X` … `normal.Z`, numbers unsigned 32-bit in
            two's complement, `face_id` with its upper half in `face_id_high`; the camera stands in the header.

        Raises
        ------
        ValueError
            For another suffix, and for a PNG of a frame without colour.
        OSError
            Where the file cannot be written.
        """
        suffix = Path(path).suffix.lower()
        if suffix == ".png":
            from PIL import Image

            image = Image.fromarray(self.to_image())
            with files.atomic_file(path) as aside:
                image.save(aside, format="PNG")
        elif suffix == ".exr":
            exr.write(path, {"frame": _exr_channels(self)}, _document(self))
        else:
            raise ValueError(f"path: expected a name ending in .png or .exr, got {os.fspath(path)!r}")

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Frame:
        """Read what `save` wrote as `.exr`; FormatError for other files and for newer versions."""
        document, parts = exr.read(path, "frame", VERSION)
        with formats.guarded(path, "frame"):
            channels = parts["frame"]
            camera, origin = _camera(document["camera"]), document["origin"]
            images = {name: image for name in CHANNELS if (image := _image(name, channels)) is not None}
            return cls(camera, (origin[0], origin[1], origin[2]), **images)


_AXES = {"color": ("R", "G", "B")} | {
    name: tuple(f"{name}.{axis}" for axis in "XYZ") for name in ("position", "normal")
}


def _exr_channels(frame: Frame) -> dict[str, NDArray[Any]]:
    """Images of a frame as two-dimensional channels of the types that OpenEXR knows."""
    channels: dict[str, NDArray[Any]] = {}
    for name in frame.channels:
        image = frame.require(name)
        if name in _AXES:
            channels |= {axis: np.ascontiguousarray(image[..., i], np.float32) for i, axis in enumerate(_AXES[name])}
        elif name == "range":
            channels[name] = np.ascontiguousarray(image, np.float32)
        else:
            bits = image.astype(np.int64).view(np.uint64)
            channels[name] = (bits & 0xFFFFFFFF).astype(np.uint32)
            if name == "face_id":
                channels["face_id_high"] = (bits >> 32).astype(np.uint32)
    if not channels:
        raise ValueError("frame has no images: render it with at least one channel")
    return channels


def _image(name: str, channels: exr.Channels) -> NDArray[Any] | None:
    """An image from channels; None where they do not hold it."""
    if name in _AXES:
        axes = _AXES[name]
        return np.stack([channels[axis] for axis in axes], axis=-1) if axes[0] in channels else None
    if name not in channels or name == "range":
        return channels.get(name)
    if name == "object_id":
        return channels[name].view(np.int32)
    high = channels["face_id_high"].astype(np.uint64)
    return (high << np.uint64(32) | channels[name]).view(np.int64)


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
