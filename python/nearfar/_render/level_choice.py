"""Choice of the level of detail of each object in a picture, by a selector or by the caller."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from nearfar._base import check
from nearfar._camera.shot import Shot
from nearfar._render.renderable import Renderable
from nearfar._scene.levels import Leveled, Selector, Shown, levels_of

Lod = str | Selector | Callable[..., Any] | ArrayLike | Mapping[str, int]
"""A mode's name, a selector, a function like `nearfar.lod.select`, or levels as `Scene.at_levels` takes them."""


class LevelChoice:
    """Chooses levels for one picture after another and remembers the last levels, which hysteresis needs."""

    def __init__(self, source: Renderable, lod: Lod) -> None:
        leveled = _leveled(source, (0.0, 0.0, 0.0))
        self._lod: Any = lod
        if isinstance(lod, str):
            self._lod = _selector(leveled, lod)
        elif isinstance(lod, Selector):
            if not callable(lod.select):
                raise TypeError(f"lod: expected a mode, a selector, a function or levels, got {check.described(lod)}")
        elif not callable(lod):
            levels_of("lod", lod, leveled)
        self._last: Shown | None = None

    def __call__(self, source: Renderable, shot: Shot) -> tuple[Renderable, Shown]:
        """Choose levels for a shot; returns the source, which may be in any pose, at these levels."""
        leveled = _leveled(source, shot.eye)
        levels = self._lod
        selection: Any = None
        if isinstance(levels, Selector) or callable(levels):
            selection = self._selected(leveled, shot)
            levels = getattr(selection, "level", selection)
        chosen = levels_of("lod", levels, leveled)
        drawn = source.at_levels(chosen)
        self._last = Shown(chosen, drawn.triangle_count, source.triangle_count, selection)
        return drawn, self._last

    def _selected(self, leveled: Leveled, shot: Shot) -> Any:
        objects = (leveled.models, leveled.model_index, leveled.centers, leveled.radii)
        camera = shot.cameras[0] if len(shot.cameras) == 1 else shot.cameras
        if not isinstance(self._lod, Selector):
            return self._lod(*objects, camera=camera)
        previous = None if self._last is None else self._last.levels
        # Only a selector that fades needs the weights, which `full` computes.
        return self._lod.select(*objects, camera=camera, previous=previous, full=self._lod.fade > 0)


def _selector(leveled: Leveled, mode: str) -> Any:
    """Selector of a mode, or no levels for a scene without objects that have some."""
    try:
        return leveled.models[0].selector(mode) if leveled.models else np.zeros(0, np.int64)
    except ValueError as error:
        raise ValueError(f"lod: {error}") from None


def _leveled(source: Renderable, user: ArrayLike) -> Leveled:
    leveled = source.shown_to(user)
    if leveled is None:
        raise ValueError("lod: expected a scene whose objects have levels, got one without; see Scene.with_levels")
    return leveled
