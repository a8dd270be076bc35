"""Levels of detail of one object: the same surface in fewer and fewer triangles."""

from __future__ import annotations

import itertools
import operator
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import check
from nearfar._bounds import bounding_sphere
from nearfar._scene.arrays import transforms_of
from nearfar._scene.scene import Scene


@dataclass(frozen=True, eq=False, kw_only=True)
class Level:
    """One level of detail.

    Parameters
    ----------
    scene
        The object in its own frame, with its materials.
    ratio
        The share of the base's triangles that was asked for.
    error
        Metres: the greatest distance found between its surface and the base's, either way; 0 for the base.
    mean_error
        Metres: the mean of these distances, by area.
    note
        Where it has not the triangles that were asked for, how many instead, and which ratios can't be reached.
    """

    scene: Scene
    ratio: float = 1.0
    error: float = 0.0
    mean_error: float = 0.0
    note: str = ""

    def __post_init__(self) -> None:
        check.instance("scene", self.scene, Scene)
        check.text("note", self.note)
        for name in ("ratio", "error", "mean_error"):
            object.__setattr__(self, name, check.number(name, getattr(self, name)))

    @property
    def triangle_count(self) -> int:
        """Its triangles."""
        return self.scene.triangle_count


class Levels(Sequence[Level]):
    """Levels of detail of one object, the base first: `simplify` makes them, or they come from files.

    Parameters
    ----------
    levels
        At least one; none has more triangles than the one before it.
    name
        Of the object.
    frame
        (4, 4), the object's own frame → that of the levels' scenes: where a single object of a scene was simplified,
        the transform that it was loaded with. `Scene.with_levels` takes it off again. By default they are the same.

    Raises
    ------
    ValueError, TypeError
        For no levels, other things than levels, empty levels, and levels that grow.
    """

    def __init__(self, levels: Iterable[Level], *, name: str = "object", frame: ArrayLike | None = None) -> None:
        self._levels = tuple(check.items("levels", levels, Level, "a sequence of Levels of one object"))
        if not self._levels:
            raise ValueError("levels: expected at least one, got none")
        for number, level in enumerate(self._levels):
            if not level.triangle_count:
                raise ValueError(f"levels: expected triangles in level {number}, got none")
        counts = [level.triangle_count for level in self._levels]
        for number, (finer, coarser) in enumerate(itertools.pairwise(counts)):
            if coarser > finer:
                raise ValueError(
                    f"levels: expected no more than {finer} triangles in level {number + 1}, got {coarser}"
                )
        self.name = check.text("name", name)
        self.frame: NDArray[np.float64] = np.eye(4) if frame is None else transforms_of("frame", frame)
        """The object's own frame → that of the levels' scenes (4, 4)."""
        if self.frame.shape != (4, 4) or np.linalg.matrix_rank(self.frame[:3, :3]) < 3:
            raise ValueError("frame: expected one invertible 4x4 matrix")
        center, radius = bounding_sphere(_corners(self._levels[0].scene))
        self.center: NDArray[np.float64] = center
        """Centre of the base's smallest bounding sphere (3,), metres in the object's frame."""
        self.radius: float = radius
        """Its radius, metres."""

    @overload
    def __getitem__(self, index: int) -> Level: ...

    @overload
    def __getitem__(self, index: slice) -> Levels: ...

    def __getitem__(self, index: int | slice) -> Level | Levels:
        """One level, or some as levels of the same object."""
        if isinstance(index, slice):
            return Levels(self._levels[index], name=self.name, frame=self.frame)
        try:
            return self._levels[operator.index(index)]
        except (IndexError, TypeError) as error:
            count = len(self._levels)
            message = f"index: expected a number from {-count} to {count - 1}, got {check.shown(index)}"
            raise type(error)(message) from None

    def __len__(self) -> int:
        """Return the number of levels."""
        return len(self._levels)

    def __repr__(self) -> str:
        counts = ", ".join(f"{level.triangle_count:,}" for level in self._levels)
        return f"Levels({self.name!r}: {counts} triangles)"

    def __str__(self) -> str:
        """Table of the levels: triangles, the ratio reached beside that asked for, distances from the base, notes."""
        base = self._levels[0].triangle_count
        rows = [f"{'level':>5}  {'triangles':>11}  {'ratio':>7}  {'asked':>7}  {'error m':>9}  {'mean m':>9}"]
        rows += [
            f"{number:>5}  {level.triangle_count:>11,}  {level.triangle_count / base:>7.4f}  {level.ratio:>7.4f}  "
            f"{level.error:>9.3g}  {level.mean_error:>9.3g}" + (f"  {level.note}" if level.note else "")
            for number, level in enumerate(self._levels)
        ]
        return "\n".join([f"{self.name}, radius {self.radius:.4g} m", *rows])


def level_numbers(name: str, value: ArrayLike, count: int) -> NDArray[np.int64]:
    """Check ascending numbers of some of `count` levels, of which the first is 0; ValueError or TypeError otherwise."""
    numbers = check.array(name, value, columns=None, dtype=np.int64)
    if numbers.ndim != 1 or not numbers.size or numbers[0] != 0:
        got = f"shape {numbers.shape}" if numbers.ndim != 1 else check.shown(numbers.tolist())
        raise ValueError(f"{name}: expected numbers of levels (N,), the first of them 0, got {got}")
    if numbers[-1] >= count or (np.diff(numbers) <= 0).any():
        raise ValueError(f"{name}: expected ascending numbers of levels up to {count - 1}, got others")
    return numbers


def _corners(scene: Scene) -> NDArray[np.float64]:
    return scene.triangles().reshape(-1, 3) + scene.origin
