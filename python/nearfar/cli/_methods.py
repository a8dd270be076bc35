"""Renders truth, conventional and continuous method from one eye, for `nearfar reduce` and `nearfar compare`."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import nearfar as nf
from nearfar.cli._output import Clock

METHODS = {"conventional": "none", "continuous": "blend"}
"""Morph of each method, by the method's name."""


def morph_of(method: str, saved: nf.ReducedScene | None) -> str:
    """Morph of a method; a saved scene keeps its continuous one."""
    continues = method == "continuous" and saved is not None and saved.morph != "none"
    return saved.morph if saved is not None and continues else METHODS[method]


def render_all(
    scene: nf.Scene,
    view: nf.Camera,
    clock: Clock,
    *,
    pictures: dict[str, Any],
    reduction: dict[str, Any],
    drawing: dict[str, Any] | None = None,
    saved: nf.ReducedScene | None = None,
) -> tuple[dict[str, nf.Frame], nf.ReducedScene]:
    """Render the truth and both methods; returns the frames and the reduced scene, whose map both methods share.

    The dicts are arguments of `render`, of `reduce`, and of `ReducedScene.render` beside those of `render`. A `saved`
    reduced scene is shown instead of a new one; if its map has no range, a new one gives the positions of far pixels.
    """
    with clock.step("truth"):
        frames = {"truth": nf.render(scene, view, backend=reduction["backend"], **pictures)}
    lacks = saved is not None and saved.env is not None and saved.env.range is None
    positions = "position" in pictures["channels"] and (saved is None or lacks)
    with clock.step("reduce"):
        made = nf.reduce(scene, **reduction) if saved is None or positions else saved
    reduced = made if saved is None else saved
    for name in METHODS:
        morph = morph_of(name, saved)
        with clock.step(name):
            if reduced is made:
                frames[name] = made.with_morph(morph).render(view, **pictures, **(drawing or {}))
                continue
            seen = reduced.with_morph(morph).render(view, **pictures | {"channels": ("color",)})
            measured = made.with_morph(morph).render(view, channels=("position",))
            frames[name] = replace(seen, origin=measured.origin, position=measured.position)
    return frames, reduced
