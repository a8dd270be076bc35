"""Choice of the level of detail of each object in a picture, by a selector or by the caller."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import check
from nearfar._camera.camera import Camera
from nearfar._camera.shot import Shot
from nearfar._render.renderable import Renderable
from nearfar._scene.levels import Leveled, Selector, Shown, levels_of

Lod = str | Selector | Callable[..., Any] | ArrayLike | Mapping[str, int]
"""A mode's name, a selector, a function like `nearfar.lod.select`, or levels as `Scene.at_levels` takes them."""


Draws = Callable[[Renderable, Leveled], NDArray[np.uint8]]
"""Function that returns how often each of the N objects of a source is drawn (N,)."""


class LevelChoice:
    """Chooses levels for successive pictures, and remembers the last levels for hysteresis."""

    def __init__(self, source: Renderable, lod: Lod) -> None:
        self._lod = rule_of(lod, _leveled(source, (0.0, 0.0, 0.0)))
        self._last: Shown | None = None

    def __call__(self, source: Renderable, shot: Shot, draws: Draws | None = None) -> tuple[Renderable, Shown]:
        """Choose levels for a shot; return the source, which may have any pose, at these levels.

        `draws` counts how often each object is drawn, for selectors with a budget; by default once for each camera.
        """
        leveled = _leveled(source, shot.eye)
        draw_counts = None
        if _has_budget(self._lod):
            once_each = np.full(len(leveled), len(shot.cameras), np.uint8)
            draw_counts = once_each if draws is None else draws(source, leveled)
        levels, selection = choose_levels(self._lod, leveled, shot.cameras, self._last, draw_counts)
        source_at_levels = source.at_levels(levels)
        self._last = Shown(levels, source_at_levels.triangle_count, source.triangle_count, selection)
        return source_at_levels, self._last


def _has_budget(rule: Any) -> bool:
    """Return whether a rule from `rule_of` is a selector with a budget of triangles."""
    return isinstance(rule, Selector) and getattr(getattr(rule, "rules", None), "budget", None) is not None


def rule_of(lod: Lod, leveled: Leveled) -> Any:
    """Check the argument `lod`, and convert it to a rule: the name of a mode becomes the mode's selector."""
    if isinstance(lod, str):
        return _selector(leveled, lod)
    if isinstance(lod, Selector):
        if not callable(lod.select):
            raise TypeError(f"lod: expected a mode, a selector, a function or levels, got {check.type_and_value(lod)}")
    elif not callable(lod):
        levels_of("lod", lod, leveled)
    return lod


def choose_levels(
    rule: Any,
    leveled: Leveled,
    cameras: Sequence[Camera],
    last: Shown | None = None,
    draws: NDArray[np.uint8] | None = None,
) -> tuple[NDArray[np.int64], Any]:
    """Return the levels (N,) of objects by a rule from `rule_of`, and the selector's result; None for fixed levels."""
    if not (isinstance(rule, Selector) or callable(rule)):
        return levels_of("lod", rule, leveled), None
    objects = (leveled.models, leveled.model_index, leveled.centers, leveled.radii)
    camera = cameras[0] if len(cameras) == 1 else tuple(cameras)
    if isinstance(rule, Selector):
        # `full` also computes weights, which only selectors that fade need.
        draw_arguments = {} if draws is None else {"draws": draws}
        selection = rule.select(
            *objects, camera=camera, full=rule.fade > 0, **draw_arguments, **_previous_arguments(last)
        )
    else:
        selection = rule(*objects, camera=camera)
    return levels_of("lod", getattr(selection, "level", selection), leveled), selection


def _previous_arguments(last: Shown | None) -> dict[str, Any]:
    """Return the last levels, and the last price if there was a budget, as arguments of `nearfar.lod.select`."""
    spent = None if last is None else getattr(last.selection, "spent", None)
    return {"previous": None if last is None else last.levels} | ({} if spent is None else {"price": spent.price})


def _selector(leveled: Leveled, mode: str) -> Any:
    """Return the selector of a mode; an empty array if no object of the scene has levels."""
    try:
        return leveled.models[0].selector(mode) if leveled.models else np.zeros(0, np.int64)
    except ValueError as error:
        raise ValueError(f"lod: {error}") from None


def _leveled(source: Renderable, user: ArrayLike) -> Leveled:
    leveled = source.shown_to(user)
    if leveled is None:
        raise ValueError("lod: expected a scene whose objects have levels, got one without; see Scene.with_levels")
    return leveled
