"""Truth, conventional and continuous method from one eye: the pictures of `nearfar reduce` and `nearfar compare`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import nearfar as nf
from nearfar.cli._options import Point
from nearfar.cli._output import Clock

METHODS = {"conventional": "none", "continuous": "blend"}
"""The reduced pictures, and the morph of each."""


@dataclass(frozen=True)
class Setting:
    """How a scene is reduced and seen."""

    view: nf.Camera
    center: Point
    r1: float
    r2: float
    face_size: int
    samples: int
    backend: str
    channels: tuple[str, ...] = ("color",)
    """Of the pictures."""
    baked: tuple[str, ...] = ("color",)
    """Of the map."""
    map_samples: int = 4
    how: dict[str, Any] | None = None
    """What else `ReducedScene.render` is told."""


def render_all(scene: nf.Scene, setting: Setting, clock: Clock) -> tuple[dict[str, nf.Frame], nf.ReducedScene]:
    """Render the truth and both methods, and return the reduced scene too. Both show one map: it is baked once."""
    seen: dict[str, Any] = {"samples": setting.samples, "channels": setting.channels}
    with clock.step("truth"):
        frames = {"truth": nf.render(scene, setting.view, backend=setting.backend, **seen)}
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
            frames[name] = reduced.with_morph(morph).render(setting.view, **seen, **(setting.how or {}))
    return frames, reduced
