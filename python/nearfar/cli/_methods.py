"""Rendering of truth, conventional and continuous method from one eye, for `nearfar reduce` and `nearfar compare`."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import nearfar as nf
from nearfar._camera.density import with_density
from nearfar.cli._output import Clock

METHODS = {"conventional": "none", "continuous": "blend"}
"""Morph of each method by name."""

DENSITY = 20.0
"""Pixels per degree of a headset, at which tears are measured."""


@dataclass(frozen=True)
class Rendered:
    """Pictures of a scene and of its reduction, from one eye."""

    frames: dict[str, nf.Frame]
    """Frames of the truth and the methods by name."""
    reduced: nf.ReducedScene
    """Reduced scene whose map both methods share."""
    dense: dict[str, nf.Frame]
    """Positions of both methods at `DENSITY`, if requested."""


def morph_of(method: str, saved: nf.ReducedScene | None) -> str:
    """Return the morph of a method; a saved scene keeps its continuous one."""
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
) -> Rendered:
    """Render the truth and both methods; `position` among the channels also requests dense pictures.

    The dicts are arguments of `render`, of `reduce`, and additional ones of `ReducedScene.render`. A `saved` reduced
    scene is shown instead of a new one; if its map has no range, a new one provides the positions of far pixels.
    """
    with clock.step("truth"):
        frames = {"truth": nf.render(scene, view, backend=reduction["backend"], **pictures)}
    lacks = saved is not None and saved.env is not None and saved.env.range is None
    measures = "position" in pictures["channels"]
    with clock.step("reduce"):
        made = nf.reduce(scene, **reduction) if saved is None or (measures and lacks) else saved
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
    dense: dict[str, nf.Frame] = {}
    if measures:
        with clock.step("dense pictures"):
            for name in METHODS:
                shown = made.with_morph(morph_of(name, saved))
                # Splitting triangles for all directions takes seconds; bent rays are only traced within the view.
                how = {"method": "exact", **(drawing or {})}
                dense[name] = shown.render(with_density(view, DENSITY), channels=("position",), **how)
    return Rendered(frames, reduced, dense)
