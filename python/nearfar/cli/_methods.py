"""Rendering of truth, conventional and continuous method from one eye, for `nearfar reduce` and `nearfar compare`."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, Literal

import nearfar as nf
from nearfar._camera.density import with_density
from nearfar.cli._output import Clock

Morph = Literal["blend", "cylinder", "none"]

METHODS: dict[str, Morph] = {"conventional": "none", "continuous": "blend"}
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


def morph_of(method: str, saved: nf.ReducedScene | None) -> Morph:
    """Return the morph of a method; a saved scene keeps its continuous one."""
    is_own = saved is not None and method == "continuous" and saved.morph != "none"
    return saved.morph if saved is not None and is_own else METHODS[method]


def render_all(
    scene: nf.Scene,
    view: nf.Camera,
    clock: Clock,
    *,
    pictures: dict[str, Any],
    reduction: dict[str, Any],
    exact: bool = False,
    saved: nf.ReducedScene | None = None,
) -> Rendered:
    """Render the truth and both methods; `position` among the channels also requests dense pictures.

    The dicts are arguments of `render` and of `reduce`. With `exact` both methods bend a ray for every pixel, and trace
    the far part. A `saved` reduced scene is shown instead of a new one; if its map has no range, a new one provides the
    positions of far pixels.
    """
    needs_positions = "position" in pictures["channels"]
    drawing: dict[str, Any] = {"method": "exact", "env": False} if exact else {}
    with clock.step("truth"):
        frames = {"truth": nf.render(scene, view, backend=reduction["backend"], **pictures)}
    has_no_range = saved is not None and saved.env is not None and saved.env.range is None
    with clock.step("reduce"):
        measured = nf.reduce(scene, **reduction) if saved is None or (needs_positions and has_no_range) else saved
    shown = saved or measured
    for name in METHODS:
        morph = morph_of(name, saved)
        with clock.step(name):
            if shown is measured:
                frames[name] = shown.with_morph(morph).render(view, **pictures, **drawing)
                continue
            frame = shown.with_morph(morph).render(view, **pictures | {"channels": ("color",)})
            positions = measured.with_morph(morph).render(view, channels=("position",))
            frames[name] = replace(frame, origin=positions.origin, position=positions.position)
    dense: dict[str, nf.Frame] = {}
    if needs_positions:
        with clock.step("dense pictures"):
            dense_view = with_density(view, DENSITY)
            for name in METHODS:
                # Splitting triangles for all directions takes seconds; bent rays are only traced within the view.
                settings = {"channels": ("position",), "method": "exact"} | drawing
                dense[name] = measured.with_morph(morph_of(name, saved)).render(dense_view, **settings)
    return Rendered(frames, shown, dense)
