"""Three scenes with surfaces across the depths where stereo ends: beams, spheres, an open landscape.

They resemble those of the study by Fink et al. (2019), Hybrid mono-stereo rendering in virtual reality, whose models
are not published.
"""

from __future__ import annotations

import functools

import numpy as np

from nearfar._base import check
from nearfar._scene.scene import Scene
from nearfar.datasets import _vegetation as vegetation
from nearfar.datasets._forest import Land, scatter, surface
from nearfar.datasets._palette import materials
from nearfar.datasets._random import Floats, RandomStream, turn, xyz
from nearfar.datasets._shapes import Soup, boxes, quads, sheet, sphere, triangles
from nearfar.datasets._stage import Stage, placements

EYE_HEIGHT = 1.7
"""Height of the viewer's eyes at the origin, metres."""
_MAX = 1_000_000
_PAINTS = materials(
    "sign_red", "sign_teal", "sign_mustard", "paint_sky", "paint_mint", "paint_rose", "panel_navy", "brick_orange"
)


def beams(count: int = 80, seed: int = 0) -> Scene:
    """Make straight beams that point away from a viewer at the origin, over a floor.

    Beams of 8 to 40 m lie at about the viewer's height, from 2 m to beyond 40 m away and within 45° of the forward
    direction −z: each crosses many depths, so that a kink where stereo ends is visible at once. Objects are "floor" and
    "beam_0", "beam_1" … of twelve triangles. ValueError for numbers out of range.

    Parameters
    ----------
    count
        Number of beams, 1 to 1,000,000.
    seed
        0 to 2⁶³ − 1.
    """
    count, seed = _check_arguments(count, seed, "count")
    stage, random = Stage(), RandomStream(seed, 70)
    _floor(stage)
    fraction, side = random.uniform(count), random.uniform(count, -1.0, 1.0)
    distance = 2.0 + 28.0 * fraction * fraction
    starts = xyz(side * distance, random.uniform(count, 0.2, 4.5), -distance)
    # Turned to a side by up to 45°, and up or down by up to 10°.
    yaw, pitch = random.uniform(count, -0.125, 0.125), random.uniform(count, -0.028, 0.028)
    sizes = np.stack([random.uniform(count, 0.12, 0.4)] * 2 + [random.uniform(count, 8.0, 40.0)], -1)
    transforms = _oriented(yaw, pitch, sizes, starts)

    def bar(paint: int) -> Soup:
        return boxes((-0.5, -0.5, -1.0), (0.5, 0.5, 0.0), _PAINTS[paint])

    stage.mixed(bar, random.integers(count, len(_PAINTS)), transforms, "beam")
    return stage.build()


def spheres(count: int = 1000, seed: int = 0, detail: int = 3) -> Scene:
    """Make spheres at all distances around a viewer at the origin, over a floor.

    Their centres are 1.5 to 60 m away, with uniform density over distance; radii are 0.08 to 1 m, smaller near the
    viewer. Objects are "floor" and "sphere_0", "sphere_1" … ValueError for numbers out of range.

    Parameters
    ----------
    count
        Number of spheres, 1 to 1,000,000.
    seed
        0 to 2⁶³ − 1.
    detail
        Number of subdivisions, 0 to 7: a sphere has 20 · 4ⁿ triangles.
    """
    count, seed = _check_arguments(count, seed, "count")
    detail = check.integer("detail", detail, 0, 7)
    stage, random = Stage(), RandomStream(seed, 71)
    _floor(stage)
    distance = random.uniform(count, 1.5, 60.0)
    cosine, sine = turn(random.uniform(count))
    radii = np.minimum(random.uniform(count, 0.08, 1.0), 0.12 * distance)
    height = radii + random.uniform(count, 0.0, 1.0) * (0.4 + 0.35 * distance)
    transforms = placements(sine * distance, height, -cosine * distance, 0.0, radii)
    balls = [triangles(sphere(detail), paint) for paint in _PAINTS]
    stage.mixed(balls.__getitem__, random.integers(count, len(_PAINTS)), transforms, "sphere")
    return stage.build()


def landscape(trees: int = 250, seed: int = 0, detail: int = 2) -> Scene:
    """Make open hills up to the horizon, with single trees and rocks, about a viewer at the origin.

    The ground at the origin is at y = 0. Objects are "land", "spruce_17", "oak_4" and "rock_2". ValueError for numbers
    out of range.

    Parameters
    ----------
    trees
        Number of trees, 1 to 1,000,000; there are as many rocks.
    seed
        0 to 2⁶³ − 1.
    detail
        0 to 3, as in `forest`.
    """
    trees, seed = _check_arguments(trees, seed, "trees")
    detail = check.integer("detail", detail, 0, 3)
    # Ten times as much land for each tree as in a forest.
    stage, land, random = Stage(), Land.generate(10 * trees, seed), RandomStream(seed, 72)
    stage.once(surface(land, detail), "land")
    for name, make, count, clear, sizes in (
        ("spruce", vegetation.conifer, trees - trees // 2, 3.0, (0.7, 1.3)),
        ("oak", vegetation.broadleaf, trees // 2, 3.0, (0.6, 1.2)),
        ("rock", vegetation.rock, trees, 1.5, (0.3, 2.5)),
    ):
        x, z = scatter(land, count, clear, random)
        transforms = placements(x, land.height(x, z), z, random.uniform(count), random.uniform(count, *sizes))
        stage.mixed(functools.partial(make, seed, detail=detail), random.integers(count, 4), transforms, name)
    return stage.build()


def _check_arguments(count: int, seed: int, name: str) -> tuple[int, int]:
    return check.integer(name, count, 1, _MAX), check.integer("seed", seed, 0, 2**63 - 1)


def _floor(stage: Stage) -> None:
    """Add a floor of tiles in two greys, 160 m wide."""
    lines = np.linspace(-80.0, 80.0, 81)
    x, z = np.meshgrid(lines, lines)
    row, column = np.divmod(np.arange(80 * 80), 80)
    tiles = np.array(materials("concrete", "concrete_dark"), np.int32)[(row + column) % 2]
    stage.once(quads(sheet(xyz(x, 0.0, z)), tiles), "floor")


def _oriented(yaw: Floats, pitch: Floats, sizes: Floats, starts: Floats) -> Floats:
    """Make transforms (K, 4, 4): scale, pitch up and yaw left by fractions of a turn, translate."""
    (cy, sy), (cp, sp) = turn(yaw), turn(pitch)
    matrices = np.zeros((len(yaw), 4, 4))
    zero = np.zeros_like(cy)
    columns = np.stack([[cy, zero, -sy], [sy * sp, cp, cy * sp], [sy * cp, -sp, cy * cp]])
    matrices[:, :3, :3] = np.moveaxis(columns, (0, 1, 2), (2, 1, 0)) * sizes[:, None, :]
    matrices[:, :3, 3], matrices[:, 3, 3] = starts, 1.0
    return matrices
