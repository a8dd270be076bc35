"""How long the CPU and an adapter take for the same picture."""

from __future__ import annotations

import time
from collections.abc import Iterable

from nearfar._camera.camera import Camera
from nearfar._render import backend as backends
from nearfar._render.renderable import Renderable
from nearfar._render.renderer import Renderer

ROUNDS = 3
"""Pictures that are timed, after one that is not."""


def measure(
    source: Renderable, camera: Camera, *, channels: Iterable[str] | None = None, samples: int = 1
) -> dict[str, float]:
    """Time a picture on the CPU and on the selected adapter, and let "auto" take the faster one from then on.

    Parameters
    ----------
    source
        The scene, or a reduced one. What was found holds for this object, as long as it lives, and for pictures with
        the same channels and samples; scenes made from it are measured by themselves.
    camera
        A view that stands for those to come, of their size.
    channels
        Images to compute, by default those that its `render` computes by default.
    samples
        Colour samples of each pixel.

    Returns
    -------
    dict
        Seconds of a picture on the "cpu" and on the "gpu": the least of three each, taken in turns after a first one
        that sends the scene to the adapter and builds the tracer's trees.

    Raises
    ------
    ValueError, TypeError
        For arguments out of their domains.
    DeviceError
        Where no adapter can be used.
    """
    renderer = Renderer(source, channels, samples)
    shot = renderer.shot([camera])
    label = backends.opened().label
    taken: dict[str, list[float]] = {"cpu": [], "gpu": []}
    for _ in range(ROUNDS + 1):
        for backend, seconds in taken.items():
            started = time.perf_counter()
            renderer.frames(shot, None, renderer.device(backend))
            seconds.append(time.perf_counter() - started)
    least = {backend: min(seconds[1:]) for backend, seconds in taken.items()}
    backends.remember(source, renderer.work, label, least["gpu"] < least["cpu"])
    return least
