"""The factory: calls the builders of its parts in order."""

from __future__ import annotations

import functools
from collections import Counter
from collections.abc import Callable

import numpy as np

from nearfar._base import check
from nearfar._scene.scene import Scene
from nearfar.datasets import _textures as textures
from nearfar.datasets._factory import (
    forklifts,
    gangway,
    machines,
    pipes,
    plan,
    presses,
    robots,
    shell,
    steel,
    storage,
    tanks,
)
from nearfar.datasets._random import RandomStream
from nearfar.datasets._shapes import Soup
from nearfar.datasets._stage import Stage, placements

Point = tuple[float, float, float]

_VIEWS = (((-5.2, 1.7, 1.6), (-24.0, 2.4, -1.2)), ((27.0, 1.7, 40.8), (-6.0, 3.4, 42.0)))
_RACKS = (44.5, 48.2, 51.8, 55.4)
"""The z of the rows of racks."""
_BAYS = 10
"""Bays of a row of racks in one block."""


def factory(seed: int = 0, detail: int = 2, *, instanced: bool = True) -> Scene:
    """Make a factory hall, 160 m by 120 m and 12 m high to the eaves, full of machines, pipes, tanks and racks.

    The floor is at y = 0 and the origin in the middle of the hall, where two lanes cross: see `factory_view`. The hall
    is closed: every ray from inside meets a surface. Objects are called "floor", "wall_north", "column_7",
    "machine_12", "robot_5", "conveyor_30", "tank_3", "pipe_40", "branch_9", "rack_3", "lamp_8", "railing_2",
    "gangway_1", "crane_0" and so on; "forklift_0" to "forklift_7" are dynamic. ValueError for numbers out of range;
    TypeError for an `instanced` that is not a bool.

    Parameters
    ----------
    seed
        0 to 2⁶³ − 1; it decides the kinds of machines in the slots, the loads of the racks and the cartons on the
        conveyors. The hall and its plan are the same for all seeds.
    detail
        0: boxes, and pipes with few sides. 1: branches of the pipes, ducts, fences, loads piece by piece. 2: bolts,
        grilles, rollers, hoses, bevelled edges. 3: more sides, rounder edges. Levels 0 to 3 have 0.15, 0.8, 2.2 and 3.7
        million triangles, of which 25, 80, 220 and 360 thousand are stored; the others are instances. At detail 3, the
        objects that reach within 63 m of `factory_view()` have 2.4 million triangles, 117 MB as vertices with position,
        normal and texture coordinates, instances expanded; CloVR (2024) states 113 MB.
    instanced
        Whether repeated objects share a mesh, as in `city`.
    """
    seed = check.integer("seed", seed, 0, 2**63 - 1)
    detail = check.integer("detail", detail, 0, 3)
    stage = Stage(instanced=check.flag("instanced", instanced))
    shell.build(stage, seed, detail)
    steel.build(stage, detail)
    pipes.build(stage, detail)
    _machines(stage, seed, detail)
    _robots(stage, seed, detail)
    _racks(stage, seed, detail)
    if detail >= 1:
        _floor_pallets(stage, seed, detail)
    gangway.build(stage, detail)
    return stage.build(dynamic=forklifts.build(stage, seed, detail))


def factory_view(place: int = 0) -> tuple[Point, Point]:
    """Return eye and target, world metres, for pictures of any `factory`; nothing is within 0.8 m of the eye.

    ValueError for other numbers.

    Parameters
    ----------
    place
        0: on the lane in the middle of the hall, between machines. 1: on a lane beside the racks.
    """
    return _VIEWS[check.integer("place", place, 0, len(_VIEWS) - 1)]


def _machines(stage: Stage, seed: int, detail: int) -> None:
    """Add single machines in their slots: machine tools, work places, compressors and tanks."""
    makers: tuple[tuple[str, int, Callable[..., Soup], str], ...] = (
        ("L", 4, machines.lathe_machine, "machine"),
        ("M", 4, machines.mill, "machine"),
        ("P", 4, presses.press, "machine"),
        ("C", 2, presses.compressor, "machine"),
        ("B", 4, functools.partial(presses.bench, seed), "bench"),
        ("T", 4, tanks.tank, "tank"),
    )
    counts: Counter[str] = Counter()
    for kind, (letter, variants, make, name) in enumerate(makers):
        slots = [slot for slot in plan.slots() if slot.kind == letter]
        transforms = placements([s.x for s in slots], 0.0, [s.z for s in slots], [s.quarter for s in slots])
        variant = RandomStream(seed, 96, kind).integers(len(slots), variants)
        stage.mixed(functools.partial(make, detail=detail), variant, transforms, name, counts[name])
        counts[name] += len(slots)


def _robots(stage: Stage, seed: int, detail: int) -> None:
    """Add robots with their conveyors, the cartons on these, and fences in front."""
    random = RandomStream(seed, 97)
    slots = [slot for slot in plan.slots() if slot.kind == "R"]
    x, z, quarters = np.array([(slot.x, slot.z, slot.quarter) for slot in slots]).T
    front = np.where(quarters == 0.0, 1.0, -1.0)
    robot = functools.partial(robots.robot, detail=detail)
    stage.mixed(robot, random.integers(len(slots), 4), placements(x, 0.0, z - 0.8 * front, quarters), "robot")
    # Five slots share a conveyor, which is as long as their block.
    starts = np.arange(-14.0, 14.0, 2.0)
    x, z, front = (x[2::5, None] + starts).ravel(), np.repeat(z[2::5], len(starts)), np.repeat(front[2::5], len(starts))
    belt_z = z + 0.8 * front
    stage.many(robots.conveyor(detail), placements(x, 0.0, belt_z), "conveyor")
    if detail == 0:
        return
    stage.many(robots.fence(detail), placements(x, 0.0, z + 2.2 * front), "fence")
    x, z = x + random.uniform(len(x), 0.5, 1.5), belt_z + random.uniform(len(x), -0.08, 0.08)
    transforms = placements(x, robots.DECK, z, random.uniform(len(x), -0.03, 0.03))
    variant = np.where(random.uniform(len(x)) < 0.75, random.integers(len(x), 4), -1)
    stage.mixed(functools.partial(robots.carton, detail=detail), variant, transforms, "carton")


def _racks(stage: Stage, seed: int, detail: int) -> None:
    """Add the rows of racks on the south side of the hall."""
    z, middle, bay = (axis.ravel() for axis in np.meshgrid(_RACKS, plan.BLOCKS, np.arange(_BAYS), indexing="ij"))
    starts = placements(middle + storage.WIDE * (bay - 0.5 * _BAYS), 0.0, z)
    variant = RandomStream(seed, 98).integers(len(z), 10)
    stage.mixed(functools.partial(storage.rack, seed, detail=detail), variant, starts, "rack")
    ends = placements(middle[::_BAYS] + 0.5 * storage.WIDE * _BAYS, 0.0, z[::_BAYS])
    stage.many(storage.rack_end(detail), ends, "rack_end")


def _floor_pallets(stage: Stage, seed: int, detail: int) -> None:
    """Add pallets and barrels on the floor beside the lanes along z, and notice boards at columns."""
    random = RandomStream(seed, 99)
    rows = sorted({slot.z for slot in plan.slots() if abs(slot.z) < 40.0})
    x, z = (values.reshape(-1) for values in np.meshgrid([-43.6, -36.2, 36.2, 43.6], rows))
    variants = [storage.pallet(RandomStream(seed, 100, k), detail) for k in range(6)]
    variant = np.where(random.uniform(len(x)) < 0.8, random.integers(len(x), len(variants)), -1)
    turns = 0.25 + random.uniform(len(x), -0.01, 0.01)
    stage.mixed(variants.__getitem__, variant, placements(x, 0.0, z, turns), "pallet")
    white = stage.material((1.0, 1.0, 1.0, 1.0), textures.notices(seed))
    boards = placements([-10.0, 10.0, -30.0, 30.0], 0.0, [9.78, -9.78, 29.78, -29.78], [0.5, 0.0, 0.5, 0.0])
    stage.many(storage.notice_board(white), boards, "notice_board")
