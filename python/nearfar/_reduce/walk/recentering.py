"""Reduces a scene around another centre in the background, with the same settings."""

from __future__ import annotations

from collections.abc import Callable
from typing import Self, TypeVar

from numpy.typing import ArrayLike

from nearfar._base import background, check
from nearfar._reduce.data import ReducedData

Result = TypeVar("Result")


class Recentering(background.Later[Result]):
    """A reduction in progress in the background; returned by `ReducedScene.recentered`.

    Ctrl-C interrupts `result`, but not the work, so that a later call still returns it. `result` raises any exception
    of partition or baking, such as MemoryError or DeviceError.
    """

    def __init__(self, center: ArrayLike, make: Callable[[], Result]) -> None:
        self._center = check.vector("center", center)
        if not callable(make):
            raise TypeError(f"make: expected a function without arguments, got {check.type_and_value(make)}")
        super().__init__(make)

    @property
    def center(self) -> tuple[float, float, float]:
        """World position of the new centre, metres."""
        return self._center

    def __repr__(self) -> str:
        x, y, z = self._center
        return f"Recentering(({x:g}, {y:g}, {z:g}), {'ready' if self.ready else 'in the making'})"


class RecenterMixin(ReducedData):
    """Mixin of `ReducedScene` that reduces the scene around another centre."""

    def recentered(self, center: ArrayLike) -> Recentering[Self]:
        """Start reducing the same scene around another centre, a world position (3,) in metres, in the background.

        Radii, morph, boundary, poses and all settings of the map stay. The scene is shared, with its meshes, search
        trees and textures: only the partition and the map are new. In the result, `ready` says whether it is finished;
        `result()` waits for the new `ReducedScene`. ValueError and TypeError for an invalid centre, or a loaded scene,
        whose far geometry was not saved.
        """
        new_center = check.vector("center", center)
        if not self._is_whole:
            raise ValueError(
                "center: expected the saved centre for a loaded scene, whose far geometry was not saved; reduce the "
                "whole scene for another centre"
            )
        return Recentering(new_center, lambda: self._reduce_again(self._baking, center=new_center))
