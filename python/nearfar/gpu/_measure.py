"""How long the CPU and an adapter take for the same picture."""

from __future__ import annotations

import time
from collections.abc import Iterable

from nearfar import _backend, _check
from nearfar._camera import Camera
from nearfar._render import MAX_SAMPLES, channel_names, render
from nearfar._scene import Scene, core_of

ROUNDS = 3
"""Pictures that are timed, after one that is not."""


def measure(
    source: Scene, camera: Camera, *, channels: Iterable[str] | None = None, samples: int = 1
) -> dict[str, float]:
    """Time a picture on the CPU and on the selected adapter, and let "auto" take the faster one from then on.

    Parameters
    ----------
    source
        The scene. What was found holds for this object, as long as it lives, and for pictures with the same channels
        and samples; scenes made from it are measured by themselves.
    camera
        A view that stands for those to come, of their size.
    channels
        Images to compute, by default those that `render` computes by default.
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
    core_of(source)
    samples = _check.integer("samples", samples, 1, MAX_SAMPLES)
    wanted = channel_names(("color", "range", "object_id") if channels is None else channels)
    label = _backend.opened().label
    taken: dict[str, list[float]] = {"cpu": [], "gpu": []}
    for _ in range(ROUNDS + 1):
        for backend, seconds in taken.items():
            started = time.perf_counter()
            render(source, camera, channels=wanted, samples=samples, backend=backend)
            seconds.append(time.perf_counter() - started)
    least = {backend: min(seconds[1:]) for backend, seconds in taken.items()}
    _backend.remember(source, (tuple(wanted), samples), label, least["gpu"] < least["cpu"])
    return least
