"""Collects triangle soups for a scene; prototypes are welded once and placed many times."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._scene.builder import SceneBuilder
from nearfar._scene.scene import Scene
from nearfar.datasets import _palette
from nearfar.datasets._random import Floats, turn
from nearfar.datasets._shapes import Indexed, Soup, weld

# Least number of triangles of a prototype that becomes instances: smaller ones are traced faster as copies in one tree.
_MERGED_BELOW = 100
# Greatest number of triangles of all copies; more would cost too much memory.
_MERGED_TOTAL = 200_000


class Stage:
    """A scene under construction; without `instanced` each copy of a prototype becomes a separate mesh."""

    def __init__(self, *, instanced: bool = True) -> None:
        self._builder, self._instanced = SceneBuilder(), instanced
        self._numbers = np.array([self._builder.material(color) for color in _palette.linear_colors()], np.int32)

    def material(
        self, base_color: tuple[float, float, float, float], texture: NDArray[np.uint8], cutoff: float | None = None
    ) -> int:
        """Add a textured material and return its number for `Soup.materials`."""
        number = self._builder.material(base_color, texture=texture, cutoff=cutoff)
        self._numbers = np.append(self._numbers, np.int32(number))
        return len(self._numbers) - 1

    def once(self, soup: Soup, name: str) -> None:
        """Add a soup that is placed once, in world coordinates."""
        if len(soup):
            self._builder.instance(self._mesh(weld(soup)), name=name)

    def many(self, soup: Soup, transforms: Floats, names: Sequence[str] | str, *, moves: bool = False) -> None:
        """Add a prototype placed by transforms (K, 4, 4); `names` as in `SceneBuilder.place_many`."""
        if not len(soup) or not len(transforms):
            return
        shape = weld(soup)
        large = len(soup) >= _MERGED_BELOW or len(soup) * len(transforms) > _MERGED_TOTAL
        if self._instanced and (moves or large):
            self._builder.place_many(self._mesh(shape), transforms, names)
            return
        names = [f"{names}_{i}" for i in range(len(transforms))] if isinstance(names, str) else names
        for transform, name in zip(transforms, names, strict=True):
            self._builder.instance(self._mesh(shape), transform, name=name)

    def mixed(
        self, make: Callable[[int], Soup], variants: NDArray[np.int64], transforms: Floats, name: str, first: int = 0
    ) -> None:
        """Place objects (K, 4, 4) with prototypes `variants` (K,), −1 for none; they are numbered from `first`."""
        for variant in np.unique(variants[variants >= 0]).tolist():
            numbers = np.flatnonzero(variants == variant)
            self.many(make(variant), transforms[numbers], [f"{name}_{first + k}" for k in numbers])

    def _mesh(self, shape: Indexed) -> int:
        numbers = self._numbers[shape.materials]
        return self._builder.mesh(shape.positions, shape.faces, material=numbers, uvs=shape.uvs, colors=shape.colors)

    def build(self, dynamic: Iterable[str] = ()) -> Scene:
        return self._builder.build(dynamic=dynamic)


def placements(x: ArrayLike, y: ArrayLike, z: ArrayLike, fraction: ArrayLike = 0.0, scale: ArrayLike = 1.0) -> Floats:
    """Make transforms (K, 4, 4): scale, rotate about the vertical by fractions of a full turn, and translate."""
    xs, ys, zs, turns, sizes = np.broadcast_arrays(
        *(np.atleast_1d(np.asarray(v, float)) for v in (x, y, z, fraction, scale))
    )
    cosine, sine = turn(turns)
    matrices = np.zeros((len(xs), 4, 4))
    matrices[:, 0, 0] = matrices[:, 2, 2] = cosine * sizes
    matrices[:, 0, 2], matrices[:, 2, 0] = sine * sizes, 0.0 - sine * sizes
    matrices[:, 1, 1], matrices[:, 3, 3] = sizes, 1.0
    matrices[:, :3, 3] = np.stack([xs, ys, zs], -1)
    return matrices
