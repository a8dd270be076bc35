"""Renders truth, conventional and continuous method from one eye, for `nearfar reduce` and `nearfar compare`."""

from __future__ import annotations

from typing import Any

import nearfar as nf
from nearfar.cli._output import Clock

METHODS = {"conventional": "none", "continuous": "blend"}
"""Morph of each method, by the method's name."""


def render_all(
    scene: nf.Scene,
    view: nf.Camera,
    clock: Clock,
    *,
    pictures: dict[str, Any],
    reduction: dict[str, Any],
    drawing: dict[str, Any] | None = None,
) -> tuple[dict[str, nf.Frame], nf.ReducedScene]:
    """Render the truth and both methods; returns the frames and the reduced scene, whose map both methods share.

    The dicts are arguments of `render`, of `reduce`, and of `ReducedScene.render` beside those of `render`.
    """
    with clock.step("truth"):
        frames = {"truth": nf.render(scene, view, backend=reduction["backend"], **pictures)}
    with clock.step("reduce"):
        reduced = nf.reduce(scene, **reduction)
    for name, morph in METHODS.items():
        with clock.step(name):
            frames[name] = reduced.with_morph(morph).render(view, **pictures, **(drawing or {}))
    return frames, reduced
