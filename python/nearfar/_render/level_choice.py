"""Which level each object of a scene shows in a picture: chosen for a camera, or given."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from nearfar._camera.camera import Camera
from nearfar._render.frame import Frame
from nearfar._scene.levels import Leveled, Selector, Shown, levels_of
from nearfar._scene.scene import Scene

Lod = str | Selector | Callable[..., Any] | ArrayLike | Mapping[str, int]
"""A mode, what chooses, or levels as `Scene.at_levels` takes them."""


class Choice:
    """How levels are chosen for pictures of a scene, one after the other: what was shown is remembered."""

    def __init__(self, scene: Scene, lod: Lod) -> None:
        leveled = _leveled(scene)
        self._lod: Any = lod
        if isinstance(lod, str):
            self._lod = leveled.models[0].selector(lod) if leveled.models else np.zeros(0, np.int64)
        elif not callable(lod) and not isinstance(lod, Selector):
            levels_of("lod", lod, leveled)
        self._last: Shown | None = None

    def __call__(self, scene: Scene, camera: Camera) -> tuple[Scene, Shown]:
        """Return what of a scene, in any pose, is drawn for a camera."""
        leveled = _leveled(scene)
        levels = self._lod
        selection: Any = None
        if isinstance(levels, Selector) or callable(levels):
            selection = self._selected(leveled, camera)
            levels = getattr(selection, "level", selection)
        chosen = levels_of("lod", levels, leveled)
        drawn = scene.at_levels(chosen)
        self._last = Shown(chosen, drawn.triangle_count, scene.triangle_count, selection)
        return drawn, self._last

    def _selected(self, leveled: Leveled, camera: Camera) -> Any:
        where = (leveled.models, leveled.model_index, leveled.centers, leveled.radii)
        if not isinstance(self._lod, Selector):
            return self._lod(*where, camera=camera)
        previous = None if self._last is None else self._last.levels
        # Weights are worked out where levels fade.
        return self._lod.select(*where, camera=camera, previous=previous, full=self._lod.fade > 0)


def said(frame: Frame, shown: Shown | None) -> Frame:
    """Return a frame that says what was shown."""
    return frame if shown is None else replace(frame, lod=shown)


def _leveled(scene: Scene) -> Leveled:
    leveled = scene.leveled
    if leveled is None:
        raise ValueError("lod: expected a scene whose objects have levels, got one without; see Scene.with_levels")
    return leveled
