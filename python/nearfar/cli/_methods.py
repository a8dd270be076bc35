"""Renders truth, conventional and continuous method from one eye, for `nearfar reduce` and `nearfar compare`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import nearfar as nf
from nearfar.cli._options import Point
from nearfar.cli._output import Clock

METHODS = {"conventional": "none", "continuous": "blend"}
"""Morph of each method, by the method's name."""


@dataclass(frozen=True)
class Setting:
    """Settings of the reduction and of the pictures."""

    view: nf.Camera
    center: Point
    r1: float
    r2: float
    face_size: int
    samples: int
    backend: str
    channels: tuple[str, ...] = ("color",)
    """Channels of the pictures."""
    baked: tuple[str, ...] = ("color",)
    """Channels of the map."""
    map_samples: int = 4
    """Number of colour samples of each texel of the map."""
    render_options: dict[str, Any] | None = None
    """Further arguments of `ReducedScene.render`."""


def render_all(scene: nf.Scene, setting: Setting, clock: Clock) -> tuple[dict[str, nf.Frame], nf.ReducedScene]:
    """Render the truth and both methods; returns the frames and the reduced scene, whose map both methods share."""
    settings: dict[str, Any] = {"samples": setting.samples, "channels": setting.channels}
    with clock.step("truth"):
        frames = {"truth": nf.render(scene, setting.view, backend=setting.backend, **settings)}
    with clock.step("reduce"):
        reduced = nf.reduce(
            scene,
            center=setting.center,
            r1=setting.r1,
            r2=setting.r2,
            face_size=setting.face_size,
            samples=setting.map_samples,
            channels=setting.baked,
            backend=setting.backend,
        )
    for name, morph in METHODS.items():
        with clock.step(name):
            frames[name] = reduced.with_morph(morph).render(setting.view, **settings, **(setting.render_options or {}))
    return frames, reduced
