"""Pictures of the conventional and the continuous method, and the choice of a view in which both can be measured."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal, Self

import nearfar as nf
from nearfar.cli._output import Clock

Morph = Literal["blend", "cylinder", "none"]

METHODS: dict[str, Morph] = {"conventional": "none", "continuous": "blend"}
"""Morph of each method by name."""

DENSITY = 20.0
"""Pixels per degree of a headset, at which tears are measured."""

PREVIEW_DENSITY = 4.0
"""Pixels per degree of the small pictures that show whether a view can be measured."""

PREVIEW_EPSILON = 1.5
"""Radius of a neighbourhood in them, pixels: it contains a pixel's direct neighbours."""

MIN_SHARED = 0.1
"""Least share of the boundary's pixels that see both sides in a view that counts as measurable."""


@dataclass(frozen=True)
class Methods:
    """Both methods, on a reduced scene whose map they share."""

    measured: nf.ReducedScene
    """Reduced scene that positions are measured with."""
    saved: nf.ReducedScene | None = None
    """Saved reduced scene to show instead."""
    exact: bool = False
    """Whether pictures bend a ray for every pixel, and trace the far part."""

    @classmethod
    def prepare(
        cls,
        scene: nf.Scene,
        reduction: dict[str, Any],
        *,
        saved: nf.ReducedScene | None = None,
        positions: bool = False,
        exact: bool = False,
    ) -> Self:
        """Reduce a scene with these arguments of `reduce`, unless a saved one will do.

        If `positions` of far pixels are needed and the saved map has no range, a new reduction provides them.
        """
        has_no_range = saved is not None and saved.env is not None and saved.env.range is None
        is_new = saved is None or (positions and has_no_range)
        return cls(nf.reduce(scene, **reduction) if saved is None or is_new else saved, saved, exact)

    @property
    def reduced(self) -> nf.ReducedScene:
        """The reduced scene that is shown."""
        return self.saved or self.measured

    @property
    def _drawing(self) -> dict[str, Any]:
        return {"method": "exact", "env": False} if self.exact else {}

    def render(self, name: str, view: nf.Camera, pictures: dict[str, Any]) -> nf.Frame:
        """Render a method's picture; `pictures` are arguments of `render`."""
        morph = morph_of(name, self.saved)
        if self.reduced is self.measured or "position" not in pictures["channels"]:
            return self.reduced.with_morph(morph).render(view, **pictures, **self._drawing)
        frame = self.reduced.with_morph(morph).render(view, **pictures | {"channels": ("color",)})
        positions = self.measured.with_morph(morph).render(view, channels=("position",))
        return replace(frame, origin=positions.origin, position=positions.position)

    def positions(self, name: str, view: nf.Camera) -> nf.Frame:
        """Trace the positions that a method shows in a view."""
        # Splitting triangles for all directions takes seconds; bent rays are only traced within the view.
        settings = {"channels": ("position",), "method": "exact"} | self._drawing
        return self.measured.with_morph(morph_of(name, self.saved)).render(view, **settings)

    def can_measure(self, view: nf.Camera) -> bool:
        """Whether a small picture of each method shows both sides of the boundary next to each other in the truth."""
        assert isinstance(view.fov, nf.Fov)
        shrinking = math.degrees(view.fov.right - view.fov.left) * PREVIEW_DENSITY / view.width
        width, height = (max(round(side * shrinking), 1) for side in (view.width, view.height))
        small = replace(view, size=(width, height))
        place: dict[str, Any] = {"center": self.measured.center, "radius": self.measured.r2}
        tears = (
            nf.metrics.boundary_tear(self.positions(name, small), epsilon=PREVIEW_EPSILON, **place) for name in METHODS
        )
        return is_measurable(tear.shared for tear in tears)


def is_measurable(shares: Iterable[float | None]) -> bool:
    """Return whether enough pixels of the boundary see both sides, from their share in the picture of each method."""
    return all((share or 0.0) >= MIN_SHARED for share in shares)


@dataclass(frozen=True)
class ViewChoice:
    """The first view that can be measured by its small pictures, or else the first one."""

    number: int
    """Index of the chosen view."""
    others: int
    """Number of other views in which the boundary can be measured for both methods."""


def choose_view(methods: Methods, views: Sequence[nf.Camera]) -> ViewChoice:
    """Choose the first view in which the boundary can be measured for both methods."""
    if len(views) == 1:
        return ViewChoice(0, 0)
    can_measure = [methods.can_measure(view) for view in views]
    number = can_measure.index(True) if any(can_measure) else 0
    return ViewChoice(number, sum(can_measure) - can_measure[number])


def morph_of(method: str, saved: nf.ReducedScene | None) -> Morph:
    """Return the morph of a method; a saved scene keeps its continuous one."""
    is_own = saved is not None and method == "continuous" and saved.morph != "none"
    return saved.morph if saved is not None and is_own else METHODS[method]


def render_all(
    scene: nf.Scene, methods: Methods, view: nf.Camera, clock: Clock, pictures: dict[str, Any], backend: Any
) -> dict[str, nf.Frame]:
    """Render the truth and both methods, by name; `pictures` are arguments of `render`."""
    with clock.step("truth"):
        frames = {"truth": nf.render(scene, view, backend=backend, **pictures)}
    for name in METHODS:
        with clock.step(name):
            frames[name] = methods.render(name, view, pictures)
    return frames
