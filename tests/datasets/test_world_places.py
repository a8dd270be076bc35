"""Tests of placement in the procedural world: on the ground, out of the water, apart from each other."""

from __future__ import annotations

import numpy as np
import pytest

import nearfar as nf
from nearfar.datasets._buildings import Kind
from nearfar.datasets._shapes import Indexed, quads, weld
from nearfar.datasets._world import forest, houses, noise, roads, sites, source, streets, tiles
from nearfar.datasets._world.lattice import SPACING
from nearfar.datasets._world.relief import natural
from tests.support.solids import areas

CELLS = [(i, j) for i in range(-2, 3) for j in range(-2, 3)]
TOWNS = [town for i, j in CELLS if (town := sites.town(0, i, j)) is not None]


def ground(x: np.ndarray, z: np.ndarray, seed: int = 0) -> np.ndarray:
    """Return heights of the finest ground at positions (N,)."""
    side, found = tiles.COUNT * SPACING, np.zeros(len(x))
    i, j = np.floor(x / side).astype(int), np.floor(z / side).astype(int)
    for a, b in sorted(set(zip(i.tolist(), j.tolist(), strict=True))):
        mine = np.flatnonzero((i == a) & (j == b))
        found[mine] = tiles.foot(seed, 0, x[mine], z[mine])
    return found


def test_noise_returns_its_slope() -> None:
    x, z = (np.linspace(low, low + 900.0, 4000) for low in (-500.0, 12_345.0))
    value, across, along = noise.noise_with_slopes(3, 7, x, z, 130.0)
    np.testing.assert_array_equal(value, noise.noise(3, 7, x, z, 130.0))
    for slope, dx, dz in ((across, 1.0, 0.0), (along, 0.0, 1.0)):
        step = 1.0e-4
        ahead, behind = (noise.noise(3, 7, x + s * dx, z + s * dz, 130.0) for s in (step, -step))
        np.testing.assert_allclose(slope / 130.0, (ahead - behind) / (2.0 * step), atol=1e-6)
    assert 0.4 < np.abs(value).max() <= 1.0
    # A few scattered points draw their gradients one by one, many from a table.
    few = noise.noise(3, 7, x[::999], z[::999], 1.0)
    np.testing.assert_array_equal(few, noise.noise(3, 7, x, z, 1.0)[::999])


def test_towns_lie_apart_on_dry_ground_and_one_at_the_origin() -> None:
    assert len(TOWNS) > 12
    home = sites.town(0, 0, 0)
    assert home is not None
    assert np.hypot(home.x, home.z) < 200
    for k, a in enumerate(TOWNS):
        assert a.height > 2.0
        for b in TOWNS[:k]:
            assert np.hypot(a.x - b.x, a.z - b.z) > a.radius + b.radius


@pytest.mark.parametrize("town", TOWNS[::3], ids=lambda town: town.name)
def test_houses_stand_on_level_dry_ground_apart_from_each_other_and_from_streets(town: sites.Town) -> None:
    plan = streets.layout(0, town)
    assert len(plan.houses) == len(plan.reach) > 5
    u, v, wide, deep = plan.reach.T
    for k in range(len(u)):
        apart = (np.abs(u - u[k]) >= wide + wide[k] + 2.0) | (np.abs(v - v[k]) >= deep + deep[k] + 2.0)
        assert apart.sum() == len(u) - 1
    for pieces, p, q, half_p, half_q, pitch in (
        (plan.along, u, v, wide, deep, streets.PITCH),
        (plan.across, v, u, deep, wide, streets.PITCH[::-1]),
    ):
        for a, b, main in pieces.tolist():
            first, line = (a, b) if p is u else (b, a)
            kerb = (streets.MAIN if main else streets.SIDE) + streets.PAVEMENT
            meets = (p + half_p > first * pitch[0]) & (p - half_p < (first + 1) * pitch[0])
            assert (np.abs(q - line * pitch[1]) - half_q)[meets].min(initial=99.0) > kerb
    around = [(su, sv) for su in (-1.0, 1.0) for sv in (-1.0, 1.0)]
    x, z = town.world(
        *(np.concatenate([c + s[k] * h for s in around]) for k, (c, h) in enumerate(((u, wide), (v, deep))))
    )
    # Walls extend 0.5 m into the ground.
    assert np.abs(ground(x, z) - town.height).max() < 0.4
    assert natural(0, x, z).min() > 0.0
    for road in roads.near(0, (town.x - 600, town.x + 600, town.z - 600, town.z + 600), 0.0):
        gap = np.hypot(x[:, None] - road.line[:, 0], z[:, None] - road.line[:, 2])
        assert gap.min() > roads.HALF + 2.0


ROADS = roads.near(0, (-6000.0, 6000.0, -6000.0, 6000.0), 0.0)


def test_roads_join_gates_of_towns_above_water_and_are_not_steep() -> None:
    assert len(ROADS) > 12
    gates = np.concatenate([[[t.x, t.z] + t.radius * t.axis(q) for q in range(4)] for t in TOWNS])
    for road in ROADS:
        x, y, z = road.line.T
        assert y.min() >= roads.CLEARANCE - 0.01
        run = np.hypot(np.diff(x), np.diff(z))
        assert run.min() > 6.0
        assert run.max() < 10.0
        assert (np.abs(np.diff(y)) / run).max() < 0.3
    inner = [road for road in ROADS if max(map(abs, road.box)) < 6000.0]
    assert len(inner) > 8
    for road in inner:
        for end in road.line[[0, -1]]:
            assert np.hypot(*(gates - end[[0, 2]]).T).min() < 0.1


def test_roads_lie_on_the_ground() -> None:
    for road in ROADS[::30]:
        right_x, right_z = road.sides()
        for across in (-roads.HALF, 0.0, roads.HALF):
            x, z = road.line[:, 0] + across * right_x, road.line[:, 2] + across * right_z
            above = road.line[:, 1] - ground(x, z)
            dry = ~road.bridge & (natural(0, x, z) > 1.5)
            # Nothing covers a road, and its skirt of 0.9 m reaches the ground.
            assert above[dry].min() > 0.0
            assert np.quantile(above[dry], 0.99) < 0.9


def test_plants_stand_on_land_away_from_roads_and_houses() -> None:
    seen = 0
    for i, j in ((0, 0), (1, -1), (3, -4), (-2, 2), (-7, 5)):
        found = forest.plants(0, i, j)
        seen += len(found.x)
        side = tiles.COUNT * SPACING
        assert (np.floor(found.x / side) == i).all()
        assert (np.floor(found.z / side) == j).all()
        assert ground(found.x, found.z).min() > 0.5
        for road in roads.near(0, (i * side, (i + 1) * side, j * side, (j + 1) * side), 30.0):
            gap = np.hypot(found.x[:, None] - road.line[:, 0], found.z[:, None] - road.line[:, 2])
            # Points of a road are 8 m apart.
            assert gap.min() > roads.HALF + 1.0
        for town in sites.near(0, (i * side, (i + 1) * side, j * side, (j + 1) * side), 0.0):
            assert streets.layout(0, town).free(found.x, found.z, 3.0).all()
    assert seen > 800


def test_street_furniture_stands_on_streets_and_outside_houses() -> None:
    town = TOWNS[0]
    plan = streets.layout(0, town)
    for thing in streets.street_things(0, town):
        u, v = town.local(np.array([thing.x]), np.array([thing.z]))
        assert not (
            (np.abs(plan.reach[1:, 0] - u) < plan.reach[1:, 2]) & (np.abs(plan.reach[1:, 1] - v) < plan.reach[1:, 3])
        ).any()


def dense(shape: Indexed) -> np.ndarray:
    """Return points on a shape, at most about 0.25 m apart."""
    corners = shape.positions[shape.faces].astype(float)
    length = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).max(1)
    found = [corners.reshape(-1, 3)]
    for count in (2, 4, 8, 16, 32, 64):
        mine = (length > 0.125 * count) & ((length <= 0.25 * count) | (count == 64))
        weights = np.array([(a, b, count - a - b) for a in range(count + 1) for b in range(count + 1 - a)]) / count
        found.append(np.einsum("kc,tcx->tkx", weights, corners[mine]).reshape(-1, 3))
    return np.concatenate(found)


def apart(first: Indexed, second: Indexed) -> float:
    """Return the Hausdorff distance of two shapes, metres."""
    scenes = [nf.Scene.from_arrays(shape.positions, shape.faces, copy=True) for shape in (first, second)]
    return max(
        float(nf.nearest_points(scene, dense(shape)).distance.max())
        for shape, scene in zip((second, first), scenes, strict=True)
    )


@pytest.mark.parametrize("seed", [0, 1])
def test_simpler_plants_are_within_their_stated_error(seed: int) -> None:
    for kind in (forest.SPRUCE, forest.OAK, forest.BUSH, forest.ROCK):
        for variant in range(2):
            full = forest.shape(seed, kind, variant, 2)
            reach = np.linalg.norm(full.positions, axis=1).max()
            assert reach <= forest.REACHES[kind]
            for detail, error in zip((1, 0), forest.COARSER[kind], strict=True):
                assert apart(forest.shape(seed, kind, variant, detail), full) <= error


@pytest.mark.slow
def test_simpler_houses_and_cars_are_within_their_stated_error() -> None:
    kinds = [Kind(w, d, houses.COTTAGE, 3, v) for v in (0, 1) for w, d in ((90, 80), (105, 115), (120, 80), (170, 140))]
    for kind in (*kinds, Kind(110, 280, houses.CHURCH, 3, 0)):
        full = houses.shape(0, kind, 2)
        for detail, error in zip((1, 0), source._HOUSES, strict=True):
            assert apart(houses.shape(0, kind, detail), full) <= error
    for kind_name, variant in (("car", 0), ("car", 5), ("lamp", 0)):
        full = streets.thing_shape(kind_name, variant, 2)
        for detail, error in zip((1, 0), source._CARS, strict=True):
            assert apart(streets.thing_shape(kind_name, variant, detail), full) <= error


@pytest.mark.parametrize("kind", [Kind(105, 80, 0, 3, 0), Kind(170, 140, 0, 3, 1), Kind(110, 280, 9, 3, 0)])
def test_houses_have_no_slivers(kind: Kind) -> None:
    shape = houses.shape(0, kind, 2)
    assert areas(shape.positions[shape.faces]).min() > 1e-8
    assert weld(quads(np.zeros((0, 4, 3)), 0)).faces.shape == (0, 3)
