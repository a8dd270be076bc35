"""Renders a scene exactly (ground truth), or another renderable with its default settings."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Unpack

from numpy.typing import ArrayLike

from nearfar._base import check
from nearfar._base.settings import gather
from nearfar._camera.camera import Camera
from nearfar._render.frame import Frame
from nearfar._render.renderable import Renderable
from nearfar._render.renderer import Renderer, View, posed_at
from nearfar._render.settings import RenderKeywords, RenderSettings


def render(
    scene: Renderable,
    camera: Camera,
    *,
    at: Mapping[str, ArrayLike] | None = None,
    user: ArrayLike | None = None,
    before: Camera | None = None,
    before_at: Mapping[str, ArrayLike] | None = None,
    settings: RenderSettings | None = None,
    **keywords: Unpack[RenderKeywords],
) -> Frame:
    """Render a scene or any other `Renderable`.

    Every pixel of a scene is exact; only `lod` simplifies objects. A reduced scene is rendered with the default
    `MorphSettings`. ValueError and TypeError for arguments out of range. DeviceError if "gpu" has no usable adapter
    (the message names software to install), and if the adapter is lost or out of memory; the next call opens the
    adapter again.

    Rays: Woop, Benthin, Wald (2013), watertight. Textures: Williams (1983), trilinear, in linear light. Samples:
    Hammersley (1960). Shading, without shadows: albedo × (sky(n) + sun · max(0, n·l)), where l is the direction to the
    sun and n the triangle's normal or, if its mesh has vertex normals, the interpolated one (Phong 1975), on the
    viewer's side of the triangle.

    Parameters
    ----------
    scene
        The scene, reduced scene, or other renderable.
    camera
        The view, with any projection.
    at
        Poses of dynamic objects, as `Scene.at` takes them.
    user
        World position (3,) in metres of the eye for which a reduced scene is morphed; by default the camera's position.
        A scene does not depend on it.
    before, before_at
        Camera of an earlier frame of the same size, and the poses of dynamic objects in that frame, for the channel
        "motion". Without `before_at` the poses of `scene` itself are used.
    settings
        Samples, channels, limits, backend and levels of detail, as `RenderSettings`.
    keywords
        Fields of `settings`, which they replace: `samples`, `t_min`, `t_max`, `clip`, `channels`, `backend`, `lod`.

    Returns
    -------
    Frame
        The bytes are the same for any number of threads. Pixels that hit nothing have the colour of the sky. Both
        backends evaluate the same formulas along the same rays, so that their pictures differ only by rounding: if an
        edge passes a pixel's centre within 1/256 of the pixel's width, either face may be shown. The GPU draws nothing
        nearer than a micrometre. With 4 samples most adapters use their own multisampling, which finds a face for each
        sample and shades each face once, at the pixel's centre; edges and textures then differ by tens of 8-bit codes
        in single pixels. With other numbers, with OpenGL, for limits of rays and with `clip`, adapters use the
        tracer's samples.
    """
    renderer = Renderer(scene, gather(RenderSettings, settings, keywords), argument="scene")
    shot = renderer.shot([camera], user)
    (frame,) = renderer.frames(shot, at, renderer.device(), _earlier(renderer, camera, before, before_at))
    return frame


def _earlier(
    renderer: Renderer, camera: Camera, before: Camera | None, at: Mapping[str, ArrayLike] | None
) -> View | None:
    """Make the view of the earlier frame, which motion is relative to; None without `before`."""
    if before is None:
        if at is not None:
            raise ValueError("before_at: expected None without the camera `before`")
        return None
    if check.instance("before", before, Camera).size != camera.size:
        raise ValueError(f"before: expected a camera of {camera.size} pixels, got {before.size}")
    source = renderer.source if at is None else posed_at(renderer.source, at, "before_at")
    return View(renderer.shot([before]), source)
