"""Parked cars, lamps and trees along the streets of a town."""

from __future__ import annotations

import functools
from dataclasses import dataclass

from nearfar.datasets import _furniture as furniture, _vehicles as vehicles
from nearfar.datasets._draw import Draw
from nearfar.datasets._shapes import Indexed, weld
from nearfar.datasets._world.sites import Town
from nearfar.datasets._world.streets import MAIN, PAVEMENT, PITCH, SIDE, SQUARE, SQUARED, layout

CAR, LAMP, TREE = "car", "lamp", "oak"
_CARS = 12


@dataclass(frozen=True)
class Thing:
    """A street object: kind, variant, world position in metres, turn as a share of a circle, size as a factor."""

    kind: str
    variant: int
    x: float
    z: float
    turn: float
    size: float


@functools.lru_cache(maxsize=256)
def things(seed: int, town: Town) -> tuple[Thing, ...]:
    """List the objects along the streets of a town."""
    plan, draw = layout(seed, town), Draw(seed, 230, town.i, town.j)
    listed: list[Thing] = []
    cosine, sine = town.axis(0)

    def put(kind: str, variant: int, u: float, v: float, turn: float, size: float = 1.0) -> None:
        x, z = town.x + u * cosine - v * sine, town.z + u * sine + v * cosine
        listed.append(Thing(kind, variant, int(x * 64.0) / 64.0, int(z * 64.0) / 64.0, turn - town.heading, size))

    for axis, pieces in enumerate((plan.along, plan.across)):
        for a, b, main in pieces.tolist():
            first, line = (a, b * PITCH[1]) if axis == 0 else (b, a * PITCH[0])
            half = MAIN if main else SIDE
            for side in (-1.0, 1.0):
                # Fronts face +z before rotation; turns go from +z towards +x, so +u is a quarter turn.
                ahead = (0.25 if side > 0.0 else 0.75) if axis == 0 else (0.5 if side > 0.0 else 0.0)
                inwards = (0.5 if side > 0.0 else 0.0) if axis == 0 else (0.75 if side > 0.0 else 0.25)

                def beside(at: float, away: float, line: float = line, side: float = side) -> tuple[float, float]:
                    return (at, line + side * away) if axis == 0 else (line + side * away, at)  # noqa: B023

                start, end = first * PITCH[axis] + 11.0, (first + 1) * PITCH[axis] - 11.0
                at = start + draw.number(0.0, 6.0)
                while at < end - 4.0:
                    if draw.chance(0.24):
                        put(CAR, int(draw.integers(1, _CARS)[0]), *beside(at + 2.4, half - 1.05), ahead)
                    at += 7.0
                put(LAMP, 0, *beside(start + 8.0 + (24.0 if side > 0.0 else 0.0), half + 0.45), inwards)
                if main:
                    for step in range(int((end - start) // 13.0)):
                        if draw.chance(0.55):
                            place = beside(start + 6.0 + 13.0 * step, half + PAVEMENT + 0.9)
                            put(TREE, step % 5, *place, draw.number(), draw.number(0.6, 0.8))
    if town.radius > SQUARED:
        u, v, wide, deep = SQUARE
        for k in range(9):
            for side in (-1.0, 1.0):
                place = u + wide * (k - 4) / 4.4, v + side * (deep - 3.0)
                put(TREE, k % 5, *place, draw.number(), draw.number(0.8, 1.0))
    return tuple(listed)


@functools.lru_cache(maxsize=64)
def shape(kind: str, variant: int, detail: int) -> Indexed:
    """The shape of a car or a lamp at detail 0 … 2."""
    if kind == LAMP:
        return weld(furniture.lamp_post(detail))
    bodies, paints = vehicles.BODIES, vehicles.PAINTS
    return weld(vehicles.car(bodies[variant % len(bodies)], paints[(variant * 5) % len(paints)], detail))
