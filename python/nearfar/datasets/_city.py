"""The city: calls the builders of its parts in order."""

from __future__ import annotations

import itertools
import operator

import numpy as np

from nearfar._base import check
from nearfar._scene.scene import Scene
from nearfar.datasets import _ground as streets, _layout as layout, _vehicles as vehicles
from nearfar.datasets._buildings import building
from nearfar.datasets._dressing import dress
from nearfar.datasets._furniture import fountain
from nearfar.datasets._layout import AVENUE, KERB, STREET, Grid, Plot
from nearfar.datasets._random import xyz
from nearfar.datasets._shapes import bars
from nearfar.datasets._stage import Stage, placements

_MAX_BLOCKS = 64
_SEEDS = 2**63
# (runs along z, offset from the middle of the avenue in metres, position along it in metres, body, paint).
_TRAFFIC = (
    (True, 1.7, -17.0, 0, 3), (True, 4.5, -41.0, 5, 0), (True, -1.7, -28.0, 1, 6), (False, 1.7, 34.0, 2, 4),
    (True, -4.5, -64.0, 0, 1), (False, -1.7, -23.0, 3, 2), (True, 1.7, 26.0, 4, 7), (False, 4.5, -52.0, 1, 5),
)  # fmt: skip


def city(blocks: int = 12, seed: int = 0, detail: int = 2, *, instanced: bool = True) -> Scene:
    """Make a city: a grid of streets with buildings, parks, trees, parked cars and a few moving ones.

    The ground is at y = 0, pavements are 0.15 m higher. Two avenues cross at the origin, and the view along both
    reaches the horizon: see `street_view`. A park lies towards −x and −z of the crossing, down-town towards −z. Objects
    are called "ground", "building_12_3" (block and building), "tree_17", "parked_car_4", "lamp_post_9" and so on;
    "car_0" to "car_7" are dynamic. ValueError for numbers out of range; TypeError for an `instanced` that is not a
    bool.

    Parameters
    ----------
    blocks
        Blocks along each side of the grid, 1 to 64; a block takes 84 m by 64 m.
    seed
        0 to 2⁶³ − 1; it decides the buildings and their places. The streets are the same for all seeds.
    detail
        0: boxes. 1: windows painted on, low-poly trees. 2: windows with reveals, bars and sills, balconies, roofs with
        machinery, street furniture. 3: frames, dense railings and trees with separate leaves. With 12 blocks, levels 0
        to 3 have 0.025, 1.5, 7 and 50 million triangles, of which 0.025, 0.25, 0.6 and 1 million are stored; the others
        are instances.
    instanced
        Whether repeated objects share a mesh. With False each copy is a separate mesh, to measure what instancing
        saves: the same triangles, all of them stored.
    """
    blocks = check.integer("blocks", blocks, 1, _MAX_BLOCKS)
    seed = check.integer("seed", seed, 0, _SEEDS - 1)
    detail = check.integer("detail", detail, 0, 3)
    stage, grid = Stage(instanced=check.flag("instanced", instanced)), Grid.generate(blocks)
    stage.once(streets.ground(grid, seed, detail), "ground")
    plots = layout.plots(grid, seed)
    _buildings(stage, plots, seed, detail)
    if detail >= 1:
        _parks(stage, grid, seed, detail)
        _paint(stage, grid)
        dress(stage, grid, plots, seed, detail)
    return stage.build(dynamic=_moving_cars(stage, detail))


def street_view() -> tuple[tuple[float, float, float], tuple[float, float, float]]:
    """Return a view for pictures of any `city`: an eye on the crossing of the avenues, and its target.

    Returns eye and target, world metres. Nothing but the street is within 2 m of the eye, the view along the avenue is
    open to the horizon, and façades begin 12 m from it on both sides.
    """
    return (0.0, 1.7, 0.0), (-1.5, 4.5, -40.0)


def _buildings(stage: Stage, plots: list[Plot], seed: int, detail: int) -> None:
    kind_of = operator.attrgetter("kind")
    for kind, group in itertools.groupby(sorted(plots, key=kind_of), kind_of):
        names, x, z, quarters = zip(*((plot.name, plot.x, plot.z, plot.quarter) for plot in group), strict=True)
        stage.many(building(kind, seed, detail), placements(x, KERB, z, np.multiply(0.25, quarters)), names)


def _parks(stage: Stage, grid: Grid, seed: int, detail: int) -> None:
    """Add paths and fountains of parks, and garden walls between the rows of the other blocks."""
    centers = []
    for block, (i, j) in enumerate(grid.numbers()):
        x0, x1, z0, z1 = np.add(grid.block(i, j), np.multiply(layout.PAVEMENT, (1, -1, 1, -1))).tolist()
        x, z = (0.5 * (first + last) for first, last in (grid.block(i, j)[:2], grid.block(i, j)[2:]))
        use = grid.use(i, j, seed)
        if use == "park":
            stage.once(streets.paths(x0, x1, z0, z1), f"path_{block}")
            centers.append((x, z))
        elif use == "rows":
            low = xyz([x0 + 0.437, x1 - 0.737], 0.0, z - 8.0)
            stage.once(bars(low, [0.3, KERB + 2.4, 16.0], "brick_grey", without="-y"), f"garden_wall_{block}")
    if centers:
        x, z = np.array(centers).T
        stage.many(fountain(detail), placements(x, KERB + 0.05, z), "fountain")


def _paint(stage: Stage, grid: Grid) -> None:
    """Add crossings and lane lines: their meshes lie along z and are rotated for streets along x."""
    crossings: dict[float, list[tuple[float, float, float]]] = {STREET: [], AVENUE: []}
    lines: dict[tuple[float, float], list[tuple[float, float, float]]] = {}
    last = grid.blocks
    for i, j in itertools.product(range(last + 1), repeat=2):
        x, z, half_x, half_z = float(grid.x[i]), float(grid.z[j]), grid.half(i), grid.half(j)
        if j < last:
            crossings[half_x].append((x, z + half_z, 0.0))
            gap = float(grid.z[j + 1] - grid.half(j + 1)) - (z + half_z)
            lines.setdefault((half_x, gap), []).append((x, z + half_z, 0.0))
        if j > 0:
            crossings[half_x].append((x, z - half_z, 0.5))
        if i < last:
            crossings[half_z].append((x + half_x, z, 0.25))
            gap = float(grid.x[i + 1] - grid.half(i + 1)) - (x + half_x)
            lines.setdefault((half_z, gap), []).append((x + half_x, z, 0.25))
        if i > 0:
            crossings[half_z].append((x - half_x, z, 0.75))
    marks = [(streets.zebra(half), poses, f"zebra_{round(2 * half)}m") for half, poses in crossings.items() if poses]
    for (half, gap), poses in sorted(lines.items()):
        marks.append((streets.lane_lines(gap, half), poses, f"lanes_{round(2 * half)}m_{round(gap)}m"))
    for soup, poses, name in marks:
        xs, zs, turns = np.array(poses).T
        stage.many(soup, placements(xs, 0.0, zs, turns), name)


def _moving_cars(stage: Stage, detail: int) -> list[str]:
    """Add the cars on the two avenues, each an object that can be posed; returns their names."""
    names = [f"car_{number}" for number in range(len(_TRAFFIC))]
    for name, (along_z, offset, position, body, paint) in zip(names, _TRAFFIC, strict=True):
        soup = vehicles.car(vehicles.BODIES[body], vehicles.PAINTS[paint], detail)
        if along_z:
            transform = placements(offset, 0.0, position, 0.5 if offset > 0 else 0.0)
        else:
            transform = placements(position, 0.0, offset, 0.25 if offset > 0 else 0.75)
        stage.many(soup, transform, [name], moves=True)
    return names
