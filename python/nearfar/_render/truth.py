"""Pictures of a source as it is: ground truth for scenes."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping

from numpy.typing import ArrayLike

from nearfar._camera.camera import Camera
from nearfar._render.frame import Frame
from nearfar._render.level_choice import Lod
from nearfar._render.renderable import Renderable
from nearfar._render.renderer import Renderer


def render(
    scene: Renderable,
    camera: Camera,
    *,
    at: Mapping[str, ArrayLike] | None = None,
    user: ArrayLike | None = None,
    t_min: float = 0.0,
    t_max: float = math.inf,
    samples: int = 1,
    channels: Iterable[str] | None = None,
    lod: Lod | None = None,
    backend: str = "auto",
) -> Frame:
    """Render a scene, or anything else that is a `Renderable`.

    Of a scene every pixel is exact, and nothing is simplified but what `lod` says. A reduced scene is drawn as
    `ReducedScene.render` draws it by default.

    Parameters
    ----------
    scene
        The scene, reduced scene, or other renderable.
    camera
        The view; any projection.
    at
        Poses of dynamic objects, as `Scene.at` takes them.
    user
        World position (3,) of the eye that a reduced scene is bent for; by default the camera's. A scene is the same
        for every user.
    t_min, t_max
        Metres along each pixel's ray between which surfaces are seen, along parallel rays from the image plane; what
        lies nearer or farther is not there. Of reduced scenes see `ReducedScene.render`.
    samples
        Colour samples of each pixel, spread evenly over its square, 1 to 1024. All other images are taken at the
        pixel's centre whatever the number.
    channels
        Images to compute, of "color", "range", "object_id", "face_id", "position" and "normal"; see `Frame`. By
        default colour, range and object_id of a scene, and of a reduced scene those that its map has.
    lod
        Which level of detail the objects show that have some (`Scene.with_levels`); None draws level 0 of all.
        "off", "depth", "depth+eccentricity" and "fovea" are modes of `nearfar.lod.select` with its defaults, without
        a lens; a `nearfar.lod.Selector`, which may have one, or whatever takes the arguments of `select` and returns
        levels, decides for this camera, and objects that it says are out of view are not drawn. Levels themselves are
        given as `Scene.at_levels` takes them. Objects show one level each, never two: fading between levels is left
        to engines.
    backend
        "cpu" traces rays. "gpu" draws with the graphics adapter that `nearfar.gpu.select` or NEARFAR_ADAPTER names, or
        the best one there is. "auto" does so where that is more than the processor itself, or was measured to be
        faster for such pictures of this scene (`nearfar.gpu.measure`); else it traces rays, and says so once.

    Returns
    -------
    Frame
        The same bytes for any number of threads. Where nothing was hit, colour is that of the sky. Both back ends use
        the same formulas along the same rays, so that pictures differ by rounding: where an edge passes a pixel's
        centre by 1/256 of a pixel or less, either face may be shown, and nothing nearer than a micrometre is drawn on
        the GPU. With 4 samples most adapters take their own multisampling, which finds each sample's face and shades it
        once, at the pixel's centre: another antialiasing of edges and textures, by tens of codes in single pixels. With
        other numbers, behind OpenGL, and for a part of each ray they take the tracer's samples.

    Raises
    ------
    ValueError, TypeError
        For arguments out of their domains.
    DeviceError
        For "gpu" where no adapter can be used; says what to install. Where the adapter is lost or its memory is spent;
        the next call opens it again.

    References
    ----------
    Rays: Woop, Benthin, Wald (2013), watertight. Textures: Williams (1983), trilinear, in linear light. Samples:
    Hammersley (1960). The shading is nearfar's own: albedo × (sky(n) + sun · max(0, n·l)), no shadows, n being the
    triangle's normal or, where its mesh has normals of vertices, what lies between them (Phong 1975), on the viewer's
    side of the triangle.
    """
    renderer = Renderer(scene, channels, samples, lod, argument="scene")
    shot = renderer.shot([camera], user, t_min, t_max)
    (frame,) = renderer.frames(shot, at, renderer.device(backend))
    return frame
