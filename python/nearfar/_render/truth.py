"""Renders a scene exactly (ground truth), or another renderable with its default settings."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping

from numpy.typing import ArrayLike

from nearfar._base import check
from nearfar._camera.camera import Camera
from nearfar._camera.clip import Clip
from nearfar._render.frame import Frame
from nearfar._render.level_choice import Lod
from nearfar._render.renderable import Renderable
from nearfar._render.renderer import Renderer, View, posed_at


def render(
    scene: Renderable,
    camera: Camera,
    *,
    at: Mapping[str, ArrayLike] | None = None,
    user: ArrayLike | None = None,
    before: Camera | None = None,
    before_at: Mapping[str, ArrayLike] | None = None,
    t_min: float = 0.0,
    t_max: float = math.inf,
    clip: Clip | None = None,
    samples: int = 1,
    channels: Iterable[str] | None = None,
    lod: Lod | None = None,
    backend: str | None = None,
) -> Frame:
    """Render a scene or any other `Renderable`.

    Every pixel of a scene is exact; only `lod` simplifies objects. A reduced scene is rendered with the default
    settings of `ReducedScene.render`.

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
        Camera of an earlier frame, of the same size, and its poses of dynamic objects, for the channel "motion"; by
        default the scene's present poses.
    t_min, t_max
        Limits in metres along each pixel's ray, for parallel rays from the image plane; surfaces nearer than `t_min` or
        farther than `t_max` are not drawn. For reduced scenes see `ReducedScene.render`.
    clip
        Planes and a box; nothing outside them is drawn.
    samples
        Number of colour samples of each pixel, spread evenly over its square, 1 to 1024. Coverage counts them
        too; all other images are sampled once, at the pixel's centre.
    channels
        Images to compute, from "color", "range", "object_id", "face_id", "position", "normal", "albedo",
        "shading_normal", "coverage" and "motion"; see `Frame`. The default is colour, range and object_id for a scene,
        and the channels of its map for a reduced scene.
    lod
        Level of detail of objects with levels (`Scene.with_levels`). None draws level 0. The names "off", "depth",
        "depth+eccentricity" and "fovea" are modes of `nearfar.lod.select` with default settings and no lens. A
        `nearfar.lod.Selector` (which may have a lens), or a function with the arguments of `select` that returns
        levels, chooses for this camera; objects that it reports as out of view are not drawn. Levels may also be given
        as for `Scene.at_levels`. Each object is drawn at one level; engines may fade between two levels.
    backend
        "cpu" traces rays. "gpu" draws with the graphics adapter that `nearfar.gpu.select` or NEARFAR_ADAPTER names, or
        the best one. "auto" uses that adapter if it is hardware, or if it was measured to be faster for such pictures
        of this scene (`nearfar.gpu.measure`); otherwise it traces rays and logs the reason, once on a machine. None
        chooses as "auto" does, and logs nothing unless an adapter was named.

    Returns
    -------
    Frame
        The bytes are the same for any number of threads. Pixels that hit nothing have the colour of the sky. Both
        backends evaluate the same formulas along the same rays, so that their pictures differ only by rounding: if an
        edge passes within 1/256 of a pixel of its centre, either face may be shown, and the GPU draws nothing nearer
        than a micrometre. With 4 samples most adapters use their own multisampling, which finds a face for each sample
        and shades each face once, at the pixel's centre; edges and textures then differ by tens of 8-bit codes in
        single pixels. With other numbers, with OpenGL, for limits of rays and with `clip`, adapters use the tracer's
        samples.

    Raises
    ------
    ValueError, TypeError
        Arguments out of range.
    DeviceError
        No usable adapter for "gpu"; the message names software to install. A lost adapter or exhausted memory of it;
        the next call opens it again.

    References
    ----------
    Rays: Woop, Benthin, Wald (2013), watertight. Textures: Williams (1983), trilinear, in linear light. Samples:
    Hammersley (1960). Shading, without shadows: albedo × (sky(n) + sun · max(0, n·l)), where l is the direction to the
    sun and n the triangle's normal or, if its mesh has vertex normals, the interpolated one (Phong 1975), on the
    viewer's side of the triangle.
    """
    renderer = Renderer(scene, channels, samples, lod, argument="scene")
    shot = renderer.shot([camera], user, t_min, t_max, clip)
    (frame,) = renderer.frames(shot, at, renderer.device(backend), _earlier(renderer, camera, before, before_at))
    return frame


def _earlier(
    renderer: Renderer, camera: Camera, before: Camera | None, at: Mapping[str, ArrayLike] | None
) -> View | None:
    """The view that motion is relative to."""
    if before is None:
        if at is not None:
            raise ValueError("before_at: expected None without the camera `before`")
        return None
    if check.instance("before", before, Camera).size != camera.size:
        raise ValueError(f"before: expected a camera of {camera.size} pixels, got {before.size}")
    source = renderer.source if at is None else posed_at(renderer.source, at, "before_at")
    return View(renderer.shot([before]), source)
