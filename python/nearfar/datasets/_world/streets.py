"""Plan of a town: streets on a grid that fades out at its edge, houses on plots along them, and street objects."""

from __future__ import annotations

import functools
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nearfar.datasets import _furniture as furniture, _vehicles as vehicles
from nearfar.datasets._buildings import Kind
from nearfar.datasets._random import Floats, RandomStream, step
from nearfar.datasets._shapes import Indexed, weld
from nearfar.datasets._world import roads
from nearfar.datasets._world.houses import CHURCH, COTTAGE
from nearfar.datasets._world.lattice import BUILT
from nearfar.datasets._world.noise import uniform_hash
from nearfar.datasets._world.relief import natural
from nearfar.datasets._world.sites import Town

PITCH = (92.0, 66.0)
"""Distances between streets across and along the first main street, metres."""
MAIN, SIDE = 3.5, 2.75
"""Half the width of the carriageway of a main street and of another, metres."""
PAVEMENT = 2.0
SQUARE_RADIUS = 240.0
"""Radius of a town above which it has a square with a church beside its main crossing, metres."""
SQUARE = (46.0, 33.0, 39.0, 26.0)
"""The square in the town's frame: centre u, v and half its sides, metres. It fills a block."""
_SETBACK, _CORNER = 4.0, 11.0
"""Distances of houses from the pavement, and from the centre lines of crossing streets, metres."""
_STREETS_PER_SIDE = 8
"""Greatest number of streets on each side of the main streets."""

CAR, LAMP, TREE = "car", "lamp", "oak"
_CARS = 12


@dataclass(frozen=True)
class Thing:
    """A house or a street object: shape, world position in metres, turn as a share of a circle, size as a factor."""

    name: str
    variant: int | Kind
    x: float
    z: float
    turn: float
    size: float = 1.0


Pieces = NDArray[np.int64]


def street_pieces(along: Pieces, across: Pieces) -> Iterator[tuple[int, float, float, float, float]]:
    """Yield pieces of a `Layout`: axis (0 for u, 1 for v), start, end, position across it, half the width in metres."""
    for axis, pieces in enumerate((along, across)):
        for a, b, main in pieces.tolist():
            first, line = (a, b) if axis == 0 else (b, a)
            ends = first * PITCH[axis], (first + 1) * PITCH[axis]
            yield axis, *ends, line * PITCH[1 - axis], MAIN if main else SIDE


@dataclass(frozen=True)
class Layout:
    """Streets of a town in its own frame (u along the first main street, v across), and its houses in world space."""

    town: Town
    along: Pieces
    """(S, 3) street pieces along u: node (a, b) to node (a + 1, b), and 1 for main streets."""
    across: Pieces
    """(T, 3) street pieces along v: node (a, b) to node (a, b + 1), and 1 for main streets."""
    nodes: NDArray[np.int64]
    """(N, 2) crossings (a, b) that streets lead to."""
    houses: tuple[Thing, ...]
    reach: Floats
    """Houses as rectangles (H, 4): centre u, v and half the sides along u and v in metres."""

    inside: NDArray[np.bool_]
    """(17, 17) crossings within the town's outline, the centre in the middle."""
    gates: tuple[int, ...]
    """Arms of the main streets, 0 to 3, that continue as a road."""

    def built(self, x: Floats, z: Floats) -> Floats:
        """Share of built-up land at world positions, 0 … 1, interpolated between the crossings."""
        u, v = self.town.local(x, z)
        a, b = u / PITCH[0] + _STREETS_PER_SIDE, v / PITCH[1] + _STREETS_PER_SIDE
        i, j = (np.clip(np.floor(c), 0, 2 * _STREETS_PER_SIDE - 1).astype(np.int64) for c in (a, b))
        s, t = np.clip(a - i, 0.0, 1.0), np.clip(b - j, 0.0, 1.0)
        flags = self.inside.astype(np.float64)
        low = flags[i, j] + s * (flags[i + 1, j] - flags[i, j])
        fraction = low + t * (flags[i, j + 1] + s * (flags[i + 1, j + 1] - flags[i, j + 1]) - low)
        return step(0.1, 0.55, fraction)

    def free(self, x: Floats, z: Floats, clear: float) -> NDArray[np.bool_]:
        """Whether world positions are `clear` metres away from all streets and houses."""
        u, v = self.town.local(x, z)
        is_free = np.ones(x.shape, bool)
        for axis, start, end, line, half in street_pieces(self.along, self.across):
            p, q = (u, v) if axis == 0 else (v, u)
            margin = half + PAVEMENT + clear
            is_free &= ~((p > start - margin) & (p < end + margin) & (np.abs(q - line) < margin))
        for hu, hv, wide, deep in self.reach.tolist():
            is_free &= (np.abs(u - hu) > wide + clear) | (np.abs(v - hv) > deep + clear)
        return is_free


@functools.lru_cache(maxsize=256)
def layout(seed: int, town: Town) -> Layout:
    """Plan a town."""
    random = RandomStream(seed, 210, town.i, town.j)
    inside = _in_town(seed, town)
    a, b = np.nonzero(inside[:-1] & inside[1:])
    along = np.stack([a - _STREETS_PER_SIDE, b - _STREETS_PER_SIDE, b == _STREETS_PER_SIDE], -1)
    a, b = np.nonzero(inside[:, :-1] & inside[:, 1:])
    across = np.stack([a - _STREETS_PER_SIDE, b - _STREETS_PER_SIDE, a == _STREETS_PER_SIDE], -1)
    ends = [along[:, :2], along[:, :2] + [1, 0], across[:, :2], across[:, :2] + [0, 1]]
    nodes = np.unique(np.concatenate(ends), axis=0)
    nodes = nodes if len(nodes) else np.zeros((1, 2), np.int64)
    near = roads.near(seed, (town.x, town.x, town.z, town.z), town.radius + 60.0)
    plots = [plot for piece in street_pieces(along, across) for plot in _plots(town, *piece, random)]
    houses, rectangles = _houses(seed, town, plots, near)
    return Layout(
        town, along, across, nodes, tuple(houses), np.reshape(rectangles, (-1, 4)), inside, _gates(town, near)
    )


def _gates(town: Town, near: list[roads.Road]) -> tuple[int, ...]:
    ends = np.array([road.line[row, [0, 2]] for road in near for row in (0, -1)]).reshape(-1, 2)
    arm_ends = [np.array([town.x, town.z]) + town.radius * town.axis(quarter) for quarter in range(4)]
    return tuple(quarter for quarter in range(4) if (np.abs(ends - arm_ends[quarter]).sum(1) < 1.0).any())


def _in_town(seed: int, town: Town) -> NDArray[np.bool_]:
    """Crossings (2n + 1, 2n + 1) within the town's irregular outline."""
    line = np.arange(-_STREETS_PER_SIDE, _STREETS_PER_SIDE + 1)
    a, b = (axis.astype(np.int64) for axis in np.meshgrid(line, line, indexing="ij"))
    u, v = PITCH[0] * a.astype(np.float64), PITCH[1] * b.astype(np.float64)
    wobble = uniform_hash(seed, 211, a + 64 * town.i, b + 64 * town.j)
    relative_distance = np.sqrt(u * u + v * v) / (town.radius - 30.0)
    x, z = town.world(u.reshape(-1), v.reshape(-1))
    is_dry = natural(seed, x, z).reshape(u.shape) > 2.0
    inside: NDArray[np.bool_] = is_dry & (relative_distance < 0.62 + 0.38 * wobble)
    return inside


@dataclass(frozen=True)
class _Plot:
    """A place for a house beside a piece of street along an axis, in the town's frame."""

    u: float
    v: float
    axis: int
    turn: float
    width: float
    depth: float
    variant: int

    @property
    def rectangle(self) -> tuple[float, float, float, float]:
        """Centre u, v and half the sides along u and v."""
        sides = (self.width, self.depth) if self.axis == 0 else (self.depth, self.width)
        return self.u, self.v, 0.5 * sides[0], 0.5 * sides[1]


def _houses(
    seed: int, town: Town, plots: list[_Plot], near_roads: list[roads.Road]
) -> tuple[list[Thing], list[tuple[float, float, float, float]]]:
    """Houses, and the rectangle that each occupies: on firm ground, away from roads and from each other."""
    houses: list[Thing] = []
    taken: list[tuple[float, float, float, float]] = []
    places = np.array([SQUARE[:2], *((plot.u, plot.v) for plot in plots)])
    x, z = town.world(places[:, 0], places[:, 1])
    ground = natural(seed, x, z)
    road_distance = np.full(len(x), 1000.0)
    for road in near_roads:
        gap = (x[:, None] - road.line[:, 0]) ** 2 + (z[:, None] - road.line[:, 2]) ** 2
        road_distance = np.minimum(road_distance, np.sqrt(gap.min(1)))
    is_firm = (ground > 2.5) & (np.abs(ground - town.height) < BUILT - 6.0)
    x, z = np.floor(x * 64.0) / 64.0, np.floor(z * 64.0) / 64.0
    if town.radius > SQUARE_RADIUS:
        # The whole block is reserved for the church.
        houses.append(Thing("church", Kind(110, 280, CHURCH, 3, 0), float(x[0]), float(z[0]), -0.25 - town.heading))
        taken.append(SQUARE)
    for k, plot in enumerate(plots, 1):
        if is_firm[k] and road_distance[k] > 0.5 * (plot.width + plot.depth) + 6.0 and not _hits(plot.rectangle, taken):
            kind = Kind(round(10 * plot.width), round(10 * plot.depth), COTTAGE, 3, plot.variant)
            houses.append(Thing("house", kind, float(x[k]), float(z[k]), plot.turn))
            taken.append(plot.rectangle)
    return houses, taken


def _hits(rectangle: tuple[float, ...], taken: list[tuple[float, float, float, float]]) -> bool:
    """Whether a rectangle comes within 2 m of others."""
    u, v, wide, deep = rectangle
    return any(abs(u - a) < wide + w + 2.0 and abs(v - b) < deep + d + 2.0 for a, b, w, d in taken)


def _plots(
    town: Town, axis: int, start: float, end: float, line: float, half: float, random: RandomStream
) -> list[_Plot]:
    """Plots on both sides of a piece of street, as in `street_pieces`."""
    plots: list[_Plot] = []
    for side in (-1.0, 1.0):
        # Fronts face +z before rotation; turns go from +z towards +x.
        quarter = (0.5 if side > 0.0 else 0.0) if axis == 0 else (0.75 if side > 0.0 else 0.25)
        position = start + _CORNER + random.number(0.0, 3.0)
        while True:
            width, depth, variant, gap, skip = _design(town, position, line, half == MAIN, random)
            if position + width > end - _CORNER:
                break
            p, q = position + 0.5 * width, line + side * (half + PAVEMENT + _SETBACK + 0.5 * depth)
            if not skip:
                u, v = (p, q) if axis == 0 else (q, p)
                plots.append(_Plot(u, v, axis, quarter - town.heading, width, depth, variant))
            position += width + gap
    return plots


def _design(
    town: Town, position: float, line: float, main: bool, random: RandomStream
) -> tuple[float, float, int, float, bool]:
    """Width, depth and variant of a house, the gap to the next, and whether the plot is left empty."""
    relative_distance = float(np.sqrt(position * position + line * line)) / max(town.radius, 260.0)
    kind = random.integers(3, 4).tolist()
    if town.radius > SQUARE_RADIUS and relative_distance < 0.2:
        return 14.0 + 3.0 * (kind[0] % 2), 12.0 + 2.0 * (kind[1] % 2), kind[2], 2.5, False
    width, depth = 9.0 + 1.5 * (kind[0] % 3), 8.0 + 3.5 * (kind[1] % 2)
    gap = random.number(4.0, 8.0) + 9.0 * relative_distance
    return width, depth, kind[2], gap, random.chance(0.06 + 0.25 * relative_distance * (0.4 if main else 1.0))


@functools.lru_cache(maxsize=256)
def street_things(seed: int, town: Town) -> tuple[Thing, ...]:
    """List the objects along the streets of a town."""
    plan, random = layout(seed, town), RandomStream(seed, 230, town.i, town.j)
    listed: list[Thing] = []
    cosine, sine = town.axis(0)

    def put(kind: str, variant: int, u: float, v: float, turn: float, size: float = 1.0) -> None:
        x, z = town.x + u * cosine - v * sine, town.z + u * sine + v * cosine
        listed.append(Thing(kind, variant, int(x * 64.0) / 64.0, int(z * 64.0) / 64.0, turn - town.heading, size))

    for axis, first, last, line, half in street_pieces(plan.along, plan.across):
        start, end = first + 11.0, last - 11.0
        for side in (-1.0, 1.0):
            # Fronts face +z before rotation; turns go from +z towards +x, so +u is a quarter turn.
            ahead = (0.25 if side > 0.0 else 0.75) if axis == 0 else (0.5 if side > 0.0 else 0.0)
            inwards = (0.5 if side > 0.0 else 0.0) if axis == 0 else (0.75 if side > 0.0 else 0.25)

            def beside(position: float, aside: float) -> tuple[float, float]:
                across = line + side * aside  # noqa: B023
                return (position, across) if axis == 0 else (across, position)  # noqa: B023

            position = start + random.number(0.0, 6.0)
            while position < end - 4.0:
                if random.chance(0.24):
                    put(CAR, int(random.integers(1, _CARS)[0]), *beside(position + 2.4, half - 1.05), ahead)
                position += 7.0
            put(LAMP, 0, *beside(start + 8.0 + (24.0 if side > 0.0 else 0.0), half + 0.45), inwards)
            for k in range(int((end - start) // 13.0)) if half == MAIN else ():
                if random.chance(0.55):
                    place = beside(start + 6.0 + 13.0 * k, half + PAVEMENT + 0.9)
                    put(TREE, k % 5, *place, random.number(), random.number(0.6, 0.8))
    if town.radius > SQUARE_RADIUS:
        u, v, wide, deep = SQUARE
        for k in range(9):
            for side in (-1.0, 1.0):
                place = u + wide * (k - 4) / 4.4, v + side * (deep - 3.0)
                put(TREE, k % 5, *place, random.number(), random.number(0.8, 1.0))
    return tuple(listed)


@functools.lru_cache(maxsize=64)
def thing_shape(kind: str, variant: int, detail: int) -> Indexed:
    """The shape of a car or a lamp at detail 0 … 2."""
    if kind == LAMP:
        return weld(furniture.lamp_post(detail))
    bodies, paints = vehicles.BODIES, vehicles.PAINTS
    return weld(vehicles.car(bodies[variant % len(bodies)], paints[(variant * 5) % len(paints)], detail))
