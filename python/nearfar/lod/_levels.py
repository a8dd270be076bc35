"""Levels of detail of an object: the same surface with decreasing triangle counts."""

from __future__ import annotations

import itertools
import operator
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import check
from nearfar._base.settings import set_fields
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
        Requested share of the base's triangles.
    error
        Greatest distance found between its surface and the base's, in both directions, metres; 0 for the base.
    mean_error
        Area-weighted mean of these distances, metres.
    note
        Actual triangle count if it differs from the requested one, and ratios that could not be reached.
    """

    scene: Scene
    ratio: float = 1.0
    error: float = 0.0
    mean_error: float = 0.0
    note: str = ""

    def __post_init__(self) -> None:
        check.instance("scene", self.scene, Scene)
        check.text("note", self.note)
        set_fields(self, **{name: check.number(name, getattr(self, name)) for name in ("ratio", "error", "mean_error")})

    @property
    def triangle_count(self) -> int:
        """Number of triangles."""
        return self.scene.triangle_count


class Levels(Sequence[Level]):
    """Levels of detail of one object, base first, made by `simplify` or from files.

    ValueError and TypeError for no levels, items of other types, empty levels, or triangle counts that grow.

    Parameters
    ----------
    levels
        At least one; none has more triangles than its predecessor.
    name
        Name of the object.
    frame
        Matrix (4, 4) from the object's own frame to the frame of the levels' scenes, by default the identity. If a
        scene with a single object was simplified, it is the object's load transform, whose inverse `Scene.with_levels`
        applies.
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
        """Matrix (4, 4) from the object's own frame to that of the levels' scenes."""
        if self.frame.shape != (4, 4) or np.linalg.matrix_rank(self.frame[:3, :3]) < 3:
            raise ValueError("frame: expected one invertible 4x4 matrix")
        base = self._levels[0].scene
        center, radius = bounding_sphere(base.triangles().reshape(-1, 3) + base.origin)
        self.center: NDArray[np.float64] = center
        """Centre of the base's smallest bounding sphere (3,), metres in the object's frame."""
        self.radius: float = radius
        """Radius of that sphere, metres."""

    @overload
    def __getitem__(self, index: int) -> Level: ...

    @overload
    def __getitem__(self, index: slice) -> Levels: ...

    def __getitem__(self, index: int | slice) -> Level | Levels:
        """Return one level, or several as levels of the same object."""
        if isinstance(index, slice):
            return Levels(self._levels[index], name=self.name, frame=self.frame)
        try:
            return self._levels[operator.index(index)]
        except (IndexError, TypeError) as error:
            count = len(self._levels)
            message = f"index: expected a number from {-count} to {count - 1}, got {check.value_or_type(index)}"
            raise type(error)(message) from None

    def __len__(self) -> int:
        """Return the number of levels."""
        return len(self._levels)

    def __repr__(self) -> str:
        counts = ", ".join(f"{level.triangle_count:,}" for level in self._levels)
        return f"Levels({self.name!r}: {counts} triangles)"

    def __str__(self) -> str:
        """Table of the levels: triangles, actual and requested ratio, distances from the base, notes."""
        base = self._levels[0].triangle_count
        rows = [f"{'level':>5}  {'triangles':>11}  {'ratio':>7}  {'asked':>7}  {'error m':>9}  {'mean m':>9}"]
        rows += [
            f"{number:>5}  {level.triangle_count:>11,}  {level.triangle_count / base:>7.4f}  {level.ratio:>7.4f}  "
            f"{level.error:>9.3g}  {level.mean_error:>9.3g}" + (f"  {level.note}" if level.note else "")
            for number, level in enumerate(self._levels)
        ]
        return "\n".join([f"{self.name}, radius {self.radius:.4g} m", *rows])


def pick_levels(levels: Levels, numbers: Iterable[int]) -> Levels:
    """Return some of an object's levels, given by ascending numbers that start with 0."""
    return Levels([levels[number] for number in numbers], name=levels.name, frame=levels.frame)


def level_numbers(name: str, value: ArrayLike, count: int) -> NDArray[np.int64]:
    """Check ascending level numbers below `count` that start with 0; ValueError or TypeError otherwise."""
    numbers = check.array(name, value, columns=None, dtype=np.int64)
    if numbers.ndim != 1 or not numbers.size or numbers[0] != 0:
        got = f"shape {numbers.shape}" if numbers.ndim != 1 else check.value_or_type(numbers.tolist())
        raise ValueError(f"{name}: expected numbers of levels (N,), the first of them 0, got {got}")
    if numbers[-1] >= count or (np.diff(numbers) <= 0).any():
        raise ValueError(f"{name}: expected ascending numbers of levels up to {count - 1}, got others")
    return numbers
