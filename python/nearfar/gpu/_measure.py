"""Times the same picture on the CPU and on a graphics adapter."""

from __future__ import annotations

import time
from collections.abc import Iterable

from nearfar._camera.camera import Camera
from nearfar._render import backend as backends
from nearfar._render.renderable import Renderable
from nearfar._render.renderer import Renderer

ROUNDS = 3
"""Number of timed pictures, after one that is not timed."""


def measure(
    source: Renderable, camera: Camera, *, channels: Iterable[str] | None = None, samples: int = 1
) -> dict[str, float]:
    """Time a picture on the CPU and on the selected adapter; from then on "auto" uses the faster one.

    Parameters
    ----------
    source
        A scene or a reduced scene. The result is used for this object, as long as it exists, and for pictures with the
        same channels and samples; scenes derived from it have to be measured separately.
    camera
        A typical view, of the size of later pictures.
    channels
        Images to compute; by default the source's `default_channels`.
    samples
        Number of colour samples of each pixel.

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
    renderer = Renderer(source, channels, samples)
    shot = renderer.shot([camera])
    label = backends.open_device().label
    timings: dict[str, list[float]] = {"cpu": [], "gpu": []}
    for _ in range(ROUNDS + 1):
        for backend, seconds in timings.items():
            started = time.perf_counter()
            renderer.frames(shot, None, renderer.device(backend))
            seconds.append(time.perf_counter() - started)
    least = {backend: min(seconds[1:]) for backend, seconds in timings.items()}
    backends.remember(source, renderer.work, label, least["gpu"] < least["cpu"])
    return least
