"""Pipes: racks of them along the columns, risers, branches to the machines, ducts and sprinklers under the roof."""

from __future__ import annotations

import numpy as np

from nearfar.datasets._factory import parts, plan
from nearfar.datasets._factory.plan import grid
from nearfar.datasets._palette import Material
from nearfar.datasets._random import xyz
from nearfar.datasets._shapes import Soup, bars, boxes, join, lathe
from nearfar.datasets._stage import Stage, placements

# For each pipe of a rack: distance from the line of columns, height of its underside, radius, material.
_RACK = (
    (-0.82, 4.2, 0.1, "pipe_green"), (-0.46, 4.2, 0.15, "steel_grey"), (0.46, 4.2, 0.15, "machine_blue"),
    (0.82, 4.2, 0.09, "safety_yellow"), (-0.6, 5.4, 0.26, "metal_light"), (0.6, 5.4, 0.26, "metal_light"),
)  # fmt: skip
_LENGTH = 10.0
_ENDS = (-70.0, 70.0)
_STARTS = np.arange(_ENDS[0], _ENDS[1] - 1.0, _LENGTH)
"""The x at which the pieces of pipes, ducts and sprinklers begin, metres."""
_FED = "MLPBC"
"""Letters of machine kinds that a branch of the rack leads to."""


def build(stage: Stage, detail: int) -> None:
    """Add all pipes, numbered through."""
    count = 0
    for offset, low, radius, name in _RACK:
        pipe = straight(radius, name, detail, insulated=radius > 0.2)
        end = riser(low + radius, radius, name, detail)
        x, z = grid(_STARTS, plan.COLUMNS_Z + offset)
        end_x, end_z = grid(_ENDS[::-1], plan.COLUMNS_Z + offset, indexing="ij")
        pipes, ends = placements(x, low + radius, z), placements(end_x, low + radius, end_z, 0.5 * (end_x < 0.0))
        for soup, transforms in ((pipe, pipes), (end, ends)):
            stage.many(soup, transforms, [f"pipe_{count + k}" for k in range(len(transforms))])
            count += len(transforms)
    if detail == 0:
        return
    _supports(stage, detail)
    fed = [slot for slot in plan.slots() if slot.kind in _FED]
    transforms = placements([s.x for s in fed], 0.0, [s.column for s in fed], [s.quarter for s in fed])
    stage.many(branch(detail), transforms, "branch")
    _under_roof(stage, detail)


def straight(radius: float, paint: Material, detail: int, *, insulated: bool) -> Soup:
    """A pipe of 10 m along x from the origin; a joint at its start, or bands around its insulation."""
    soups = [parts.drum(radius, 0.0, _LENGTH, paint, detail)]
    if insulated and detail >= 1:
        step = (2.0, 5.0, 2.0, 1.0)[detail]
        band = parts.drum(radius + 0.012, -0.025, 0.025, "metal", detail)
        soups.append(band.copies(xyz(0.0, np.arange(0.5 * step, _LENGTH, step), 0.0)))
    return join([*soups, parts.flange(radius, paint, detail)]).laid_x()


def riser(height: float, radius: float, paint: Material, detail: int) -> Soup:
    """The end of a pipe of the rack: a bend down to the floor, with a valve and a joint."""
    out, bend = 0.6 + 2.5 * radius, 2.2 * radius
    line = [[0.0, 0.0, 0.0], [out, 0.0, 0.0], [out, -height - 0.05, 0.0]]
    joint = parts.flange(radius, paint, detail)
    soups = [parts.piping(line, radius, bend, paint, detail), joint.laid_x().translate([0.3, 0.0, 0.0])]
    soups.append(joint.translate([out, 0.25 - height, 0.0]))
    return join([*soups, valve(radius, detail).translate([out, 1.3 - height, 0.0])])


def valve(radius: float, detail: int) -> Soup:
    """A gate valve on an upright pipe, with its handwheel towards +x."""
    reach, half = 2.2 * radius + 0.12, 1.6 * radius + 0.06
    wide = 1.35 * radius + 0.01
    profile = [(1.05 * radius, -half), (wide, -0.6 * radius), (wide, 0.6 * radius), (1.05 * radius, half)]
    body = lathe(profile, parts.ROUND[detail], "steel_grey")
    if detail == 0:
        return body
    bonnet = parts.drum(0.7 * radius + 0.01, 0.0, 0.7 * reach, "steel_grey", detail, 0.1 * radius).laid_x()
    stem = parts.rod((0.5 * reach, 0.0, 0.0), (reach + 0.06, 0.0, 0.0), 0.12 * radius + 0.006, "metal", detail)
    wheel = parts.handwheel(1.1 * radius + 0.05, "safety_red", detail).laid_x().translate([reach, 0.0, 0.0])
    joints = parts.flange(radius, "steel_grey", detail).copies([[0.0, -half, 0.0], [0.0, half, 0.0]])
    return join([body, bonnet, stem, wheel, joints])


def branch(detail: int) -> Soup:
    """A branch from the rack at z = 0.46 to the supply cabinet of the machine at +z."""
    steel, radius, height = "machine_blue", 0.05, 4.35
    line = [[0.0, height, 0.46], [0.0, height + 0.42, 0.46], [0.0, height + 0.42, 1.3], [0.0, 1.05, 1.3]]
    return join([
        parts.piping(line, radius, 0.14, steel, detail),
        parts.flange(radius, steel, detail).translate([0.0, height + 0.25, 0.46]),
        valve(radius, detail).translate([0.0, 1.75, 1.3]),
        parts.flange(radius, steel, detail).translate([0.0, 3.0, 1.3]),
        parts.rod((0.0, 2.3, 1.3), (0.0, 2.3, 1.4), 0.015, "metal", detail),
        parts.gauge(0.08, detail).translate([0.0, 2.3, 1.39]),
        parts.casing([-0.4, 0.05, 1.1], [0.4, 1.1, 1.5], 0.02, "machine_grey", detail),
        boxes([-0.38, -0.02, 1.12], [0.38, 0.06, 1.48], "metal_dark"),
        parts.rod([0.25, 1.0, 1.3], [0.25, 3.9, 1.3], 0.03, "rubber", detail),
        bars([[0.19, 3.9, 0.9]], [[0.12, 0.1, 0.5]], "metal"),
    ])  # fmt: skip


def _supports(stage: Stage, detail: int) -> None:
    """Arms on the columns and posts between them, beside the lanes, which carry the racks."""
    x, z = grid(plan.COLUMNS_X, plan.COLUMNS_Z)
    stage.many(_arms(detail), placements(x, 0.0, z), "pipe_arm")
    x, z = grid([-60.0, -42.8, -37.2, -20.0, -3.4, 3.4, 20.0, 37.2, 42.8, 60.0], plan.COLUMNS_Z)
    post = join([
        boxes([-0.08, 0.02, -0.08], [0.08, 5.3, 0.08], "steel_blue"),
        boxes([-0.2, -0.02, -0.2], [0.2, 0.03, 0.2], "steel_blue"),
        _arms(detail),
    ])  # fmt: skip
    stage.many(post, placements(x, 0.0, z), "pipe_post")


def _arms(detail: int) -> Soup:
    """Two arms across, under the pipes of a rack, with clips around the pipes from detail 2 on."""
    soups = [bars([[-0.06, 4.08, -1.05], [-0.065, 5.27, -1.0]], [[0.12, 0.115, 2.1], [0.13, 0.125, 2.0]], "steel_blue")]
    if detail >= 2:
        for offset, low, radius, _ in _RACK:
            clip = parts.drum(radius + 0.012, -0.03, 0.03, "metal_dark", detail).laid_x()
            soups.append(clip.translate([0.0, low + radius, offset]))
    return join(soups)


def _under_roof(stage: Stage, detail: int) -> None:
    """Air ducts with outlets, and thin sprinkler pipes, all along x."""
    x, z = grid(_STARTS, [-45.0, -25.0, -15.0, 15.0, 25.0, 45.0])
    stage.many(duct(detail), placements(x, 8.85, z), "duct")
    x, z = grid(_STARTS, [-55.0, -35.0, -5.0, 5.0, 35.0, 55.0])
    stage.many(sprinkler(detail), placements(x, 9.6, z), "sprinkler")


def duct(detail: int) -> Soup:
    """A round duct of 10 m along x, with seams, an outlet below, and rods to the gutter that it hangs from."""
    tin, dark, radius = "metal_light", "metal_dark", 0.5
    step = (5.0, 5.0, 2.5, 2.0)[detail]
    seams = parts.torus(radius + 0.004, 0.02, tin, detail).copies(xyz(0.0, np.arange(0.5 * step, _LENGTH, step), 0.0))
    return join([
        join([parts.drum(radius, 0.0, _LENGTH, tin, detail), seams]).laid_x(),
        boxes([4.4, -0.72, -0.35], [5.6, -0.3, 0.35], tin),
        parts.grille(1.1, 0.6, detail).pitched(0.25).translate([5.0, -0.715, 0.0]),
        *(parts.rod((0.18, -0.54, z), (0.18, 2.78, z), 0.012, dark, min(detail, 1)) for z in (-0.54, 0.54)),
        boxes([0.14, -0.56, -0.57], [0.22, -0.5, 0.57], dark),
    ])  # fmt: skip


def sprinkler(detail: int) -> Soup:
    """Ten metres of a thin red pipe along x with heads, and the rod to the gutter that it hangs from."""
    steel = "metal_light"
    soups = [parts.rod((0, 0, 0), (_LENGTH, 0, 0), 0.035, "safety_red", detail)]
    for x in (1.25, 3.75, 6.25, 8.75):
        if detail >= 1:
            soups.append(parts.rod((x, 0.0, 0.0), (x, -0.16, 0.0), 0.018, steel, min(detail, 2)))
        if detail >= 2:
            soups.append(lathe([(0.05, -0.17), (0.05, -0.16)], parts.THIN[detail], steel).translate([x, 0.0, 0.0]))
    soups.append(parts.rod((0.18, 0.0, 0.0), (0.18, 2.02, 0.0), 0.01, "metal_dark", min(detail, 1)))
    return join(soups)
