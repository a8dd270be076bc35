"""Parked cars, lamps and trees along the streets of a town."""

from __future__ import annotations

import functools

from nearfar.datasets import _furniture as furniture, _vehicles as vehicles
from nearfar.datasets._draw import Draw
from nearfar.datasets._shapes import Indexed, weld
from nearfar.datasets._world.sites import Town
from nearfar.datasets._world.streets import MAIN, PAVEMENT, SQUARE, SQUARED, Thing, layout, street_pieces

CAR, LAMP, TREE = "car", "lamp", "oak"
_CARS = 12


@functools.lru_cache(maxsize=256)
def things(seed: int, town: Town) -> tuple[Thing, ...]:
    """List the objects along the streets of a town."""
    plan, draw = layout(seed, town), Draw(seed, 230, town.i, town.j)
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

            position = start + draw.number(0.0, 6.0)
            while position < end - 4.0:
                if draw.chance(0.24):
                    put(CAR, int(draw.integers(1, _CARS)[0]), *beside(position + 2.4, half - 1.05), ahead)
                position += 7.0
            put(LAMP, 0, *beside(start + 8.0 + (24.0 if side > 0.0 else 0.0), half + 0.45), inwards)
            for step in range(int((end - start) // 13.0)) if half == MAIN else ():
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
