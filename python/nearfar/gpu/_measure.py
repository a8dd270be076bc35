"""Times the same picture on the CPU and on a graphics adapter."""

from __future__ import annotations

import time
from typing import Unpack

from nearfar._base.settings import gather
from nearfar._camera.camera import Camera
from nearfar._render import backend as backends
from nearfar._render.renderable import Renderable
from nearfar._render.renderer import Renderer
from nearfar._render.settings import RenderKeywords, RenderSettings, require_defaults

ROUNDS = 3
"""Number of timed pictures, after one that is not timed."""


def measure(
    source: Renderable,
    camera: Camera,
    *,
    settings: RenderSettings | None = None,
    **keywords: Unpack[RenderKeywords],
) -> dict[str, float]:
    """Time a picture on the CPU and on the selected adapter; from then on "auto" uses the faster one.

    Parameters
    ----------
    source
        A scene or a reduced scene. The result is used for this object, as long as it exists, and for pictures with the
        same channels and samples; scenes derived from it have to be measured separately.
    camera
        A typical view, of the size of later pictures.
    settings
        Samples, channels, limits and levels, as `nearfar.RenderSettings`; the backend stays None.
    keywords
        Fields of `settings`, which they replace.

    Returns
    -------
    dict
        Seconds per picture on the "cpu" and on the "gpu": the least of three each, taken alternately, after a first
        picture that uploads the scene to the adapter and builds the tracer's trees.

    Raises
    ------
    ValueError, TypeError
        Arguments out of range.
    DeviceError
        If no adapter can be used.
    """
    chosen = gather(RenderSettings, settings, keywords)
    require_defaults(chosen, "nearfar.gpu.measure", "backend")
    renderer, device = Renderer(source, chosen), backends.open_device()
    shot = renderer.shot([camera])
    timings: dict[str, list[float]] = {"cpu": [], "gpu": []}
    for _ in range(ROUNDS + 1):
        for backend, seconds in timings.items():
            started = time.perf_counter()
            renderer.frames(shot, None, device if backend == "gpu" else None)
            seconds.append(time.perf_counter() - started)
    least_seconds = {backend: min(seconds[1:]) for backend, seconds in timings.items()}
    backends.remember(source, renderer.work, device.label, least_seconds["gpu"] < least_seconds["cpu"])
    return least_seconds
