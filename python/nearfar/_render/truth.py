"""Ground truth: pictures of a scene as it is."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from nearfar import _core
from nearfar._base import check
from nearfar._camera.camera import Camera
from nearfar._render.frame import CHANNELS, Frame
from nearfar._render.level_choice import Choice, Lod, said
from nearfar._render.renderer import Painter, Report, check_camera
from nearfar._scene.scene import Scene, core_of

DEFAULTS = ("color", "range", "object_id")
"""Images that are computed where nobody says which."""

MAX_SAMPLES = 1024
"""Most colour samples of a pixel."""


def render(
    scene: Scene,
    camera: Camera,
    *,
    samples: int = 1,
    channels: Iterable[str] = DEFAULTS,
    lod: Lod | None = None,
    backend: str = "auto",
) -> Frame:
    """Render a scene: every pixel is exact, and nothing is simplified but what `lod` says.

    Parameters
    ----------
    scene
        What is looked at.
    camera
        From where; any projection.
    samples
        Colour samples of each pixel, spread evenly over its square, 1 to 1024. All other images are taken at the
        pixel's centre whatever the number.
    channels
        Images to compute, of "color", "range", "object_id", "face_id", "position" and "normal"; see `Frame`.
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
        other numbers, and behind OpenGL, they take the tracer's samples.

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
    check_camera(camera)
    how = painter(scene, channels, samples)
    if lod is None:
        return how.paint(scene, camera, backend)
    drawn, shown = Choice(scene, lod)(scene, camera)
    return said(how.paint(drawn, camera, backend), shown)


def painter(scene: Scene, channels: Iterable[str] | None, samples: int) -> Painter:
    """How a scene is seen as it is; None stands for the default images."""
    core_of(scene)
    samples = check.integer("samples", samples, 1, MAX_SAMPLES)
    wanted = channel_names(DEFAULTS if channels is None else channels)

    def trace(scene: Scene, camera: Camera, report: Report) -> dict[str, Any]:
        return _core.render_truth(scene._core, camera._core, channels=wanted, samples=samples, report=report)

    def begin(device: _core.GpuDevice, scene: Scene, camera: Camera, report: Report) -> _core.GpuJob:
        return device.truth(scene._core, camera._core, channels=wanted, samples=samples, report=report)

    return Painter(scene, scene, (tuple(wanted), samples), trace, begin)


def channel_names(channels: Iterable[str]) -> list[str]:
    """Return the names of wanted images, each once and in the order of `CHANNELS`; ValueError for unknown ones."""
    if isinstance(channels, str):
        raise TypeError(f"channels: expected a sequence of names such as ({channels!r},), got the string {channels!r}")
    if not isinstance(channels, Iterable):
        raise TypeError(f"channels: expected a sequence of names, got {type(channels).__name__}")
    names = {check.choice("channels", name, CHANNELS) for name in channels}
    if not names:
        raise ValueError(f"channels: expected at least one of {', '.join(CHANNELS)}, got none")
    return [name for name in CHANNELS if name in names]
