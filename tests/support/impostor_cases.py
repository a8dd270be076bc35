"""A yard for tests of impostors: tiled ground, rows of coloured boxes around, and a car that can be posed."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.ndimage import maximum_filter, minimum_filter

import nearfar as nf
from nearfar._base import check
from nearfar._impostor.settings import ImpostorSettings
from nearfar._reduce.impostors import reduce_to_impostors
from tests.support.reduce_cases import box

CENTER = (3.0, 1.7, -2.0)
SETTINGS: dict[str, Any] = {"center": CENTER, "reach": 2.0, "r2": 12.0, "face_size": 256}
FOV = nf.Fov.symmetric(90, 16 / 9)
SIZE = (192, 108)
_EXTENT, _TILES, _SPLIT = 96.0, 24, 3
"""Half the width of the ground in metres, its coloured tiles across, and the parts of a tile's edge."""


def yard(at: tuple[float, float, float] = (0.0, 0.0, 0.0), *, copies: int = 20) -> nf.Scene:
    """Return the scene, moved by `at` metres; it has `copies` boxes 5 to 50 m from the centre, of several heights."""
    build = nf.SceneBuilder()
    cells = _TILES * _SPLIT
    lines = np.linspace(-_EXTENT, _EXTENT, cells + 1)
    x, z = (axis.ravel() for axis in np.meshgrid(lines, lines, indexing="ij"))
    number = np.arange(len(x)).reshape(cells + 1, -1)
    a, b, c, d = (rows.ravel() for rows in (number[:-1, :-1], number[:-1, 1:], number[1:, :-1], number[1:, 1:]))
    faces = np.concatenate([np.column_stack([a, b, c]), np.column_stack([c, b, d])])
    shades = [build.material((0.25, shade, 0.2, 1.0)) for shade in (0.25, 0.45)]
    material = np.tile((a // (cells + 1) // _SPLIT + a % (cells + 1) // _SPLIT) % 2, 2).astype(np.int32)
    ground = np.column_stack([x, np.zeros_like(x), z]) + at
    build.instance(build.mesh(ground, faces, material=np.array(shades, np.int32)[material]), name="ground")
    draw = np.random.default_rng(7)
    for copy in range(copies):
        angle, distance = 2.4 * copy, np.geomspace(5.0, 50.0, copies)[copy]
        low = np.array([CENTER[0] + distance * np.cos(angle), 0.0, CENTER[2] + distance * np.sin(angle)])
        corners, sides = box(tuple(low), tuple(low + draw.uniform([1.0, 1.0, 1.0], [5.0, 9.0, 5.0])))
        color = build.material((*draw.uniform(0.1, 0.9, 3), 1.0))
        build.instance(build.mesh(corners + at, sides, material=color), name=f"box_{copy}")
    corners, sides = box((-1.0, 0.0, -2.0), (1.0, 1.5, 2.0))
    place = np.eye(4)
    place[:3, 3] = np.add(at, (CENTER[0], 0.0, CENTER[2] - 25.0))
    build.instance(build.mesh(corners, sides, material=build.material((0.9, 0.05, 0.05, 1.0))), place, name="car")
    return build.build(dynamic=["car"])


def bake(
    scene: nf.Scene, *, center: ArrayLike, r2: float, earlier: nf.Impostors | None = None, **settings: Any
) -> nf.Impostors:
    """Bake impostors as `nf.reduce` does, also of scenes with so few triangles that it would keep them as they are.

    With `earlier`, as the next region of a walk.
    """
    place = check.vector("center", center)
    return reduce_to_impostors(scene, place, r2, ImpostorSettings(**settings), may_keep=False, earlier=earlier)


def view(user: NDArray[np.float64], turn: float = 0.0, size: tuple[int, int] = SIZE) -> nf.Camera:
    """Return a level view, turned by `turn` radians about the vertical axis."""
    return nf.Camera.look_at(user, np.add(user, (np.sin(turn), 0.05, -np.cos(turn))), fov=FOV, size=size)


def misplaced(truth: nf.Frame, frame: nf.Frame, pixels: int, step: float = 0.04) -> float:
    """Share of a frame's pixels whose colour the truth has nowhere within so many pixels, up to a step of sRGB."""
    colors, shown = truth.to_image() / 255.0, frame.to_image() / 255.0
    around = (2 * pixels + 1, 2 * pixels + 1, 1)
    low, high = minimum_filter(colors, around), maximum_filter(colors, around)
    return float(((shown < low - step) | (shown > high + step)).any(axis=-1).mean())
