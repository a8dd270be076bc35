"""Tests of the procedural world: queries agree where they overlap, no cracks, errors within detail."""

from __future__ import annotations

import itertools
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from nearfar import datasets
from nearfar.datasets._world import lattice, tiles
from tests.support.solids import digest
from tests.support.thread_counts import process

HIGH = (-1.0e4, 1.0e4)


def column(x0: float, x1: float, z0: float, z1: float) -> NDArray[np.float64]:
    """Return a box of all heights."""
    return np.array([[x0, HIGH[0], z0], [x1, HIGH[1], z1]])


def corners(scene: nf.Scene) -> NDArray[np.float64]:
    """Return world corners (T, 3, 3) of all triangles."""
    return np.asarray(scene.triangles().astype(np.float64) + scene.origin)


def rows(triangles: NDArray[np.float64]) -> set[bytes]:
    """Return triangles as a set of their bytes."""
    return {row.tobytes() for row in np.ascontiguousarray(triangles).reshape(-1, 9)}


def land(scene: nf.Scene, prefix: str = "land_") -> NDArray[np.float64]:
    """Return world corners of the triangles of objects whose names begin so."""
    found = [name for name in scene.object_names if name.startswith(prefix)]
    return corners(scene.subset(objects=found))


WORLD = datasets.world(8)
FARMLAND, TOWN = column(700, 830, -900, -790), column(-60, 90, -70, 60)


@pytest.mark.parametrize("box", [FARMLAND, TOWN], ids=["fields", "town"])
def test_parts_of_a_query_equal_those_of_the_whole(box: NDArray[np.float64]) -> None:
    whole = rows(corners(WORLD.query(box)))
    (x0, _, z0), (x1, _, z1) = box.tolist()
    x, z = 0.4 * x0 + 0.6 * x1, 0.7 * z0 + 0.3 * z1
    cells = [column(a, b, c, d) for a, b in ((x0, x), (x, x1)) for c, d in ((z0, z), (z, z1))]
    parts = [rows(corners(WORLD.query(cell))) for cell in cells]
    assert set().union(*parts) == whole
    assert all(len(part) < len(whole) for part in parts)


def test_overlapping_queries_return_equal_triangles() -> None:
    first, second = column(600, 760, -1000, -850), column(700, 900, -900, -780)
    a, b = (corners(WORLD.query(box)) for box in (first, second))
    for mine, box, other in ((a, second, b), (b, first, a)):
        inside = ((mine >= box[0]) & (mine <= box[1])).all(2).any(1)
        assert inside.sum() > 300
        assert rows(mine[inside]) <= rows(other)


SAME = """
from nearfar import datasets
from tests.support.solids import digest
world = datasets.world(8)
boxes = [[[-60, -1e4, -70], [40, 1e4, 10]], [[700, -1e4, -900], [800, 1e4, -820]]]
for place, detail in ORDER:
    scene = world.query(boxes[place], detail)
    print(place, detail, digest(scene.triangles()), scene.triangle_count, len(scene.object_names))
"""


@pytest.mark.slow
def test_equal_in_other_processes_and_orders() -> None:
    order = [(0, 0.0), (1, 0.0), (0, 6.0), (1, 6.0)]
    printed = [
        process(threads).output_of(SAME.replace("ORDER", str(own)))
        for threads, own in (("1", order), ("2", order[::-1]))
    ]
    first, second = (sorted(text.splitlines()) for text in printed)
    assert first == second
    assert len(set(first)) == 4


OUTER = ((0, -2000, -1500), (2, 500, 1000))
"""Axes, and minimum and maximum coordinates, of two neighbouring queries together."""


@pytest.mark.parametrize("detail", [0.0, 2.5, 20.0])
def test_the_ground_of_neighbouring_queries_has_no_cracks(detail: float) -> None:
    (x0, x1), (z0, z1) = OUTER[0][1:], OUTER[1][1:]
    cells = [column(x0, (x0 + x1) / 2, z0, z1), column((x0 + x1) / 2, x1, z0, z1)]
    parts = [land(WORLD.query(cell, detail)) for cell in cells]
    triangles = np.unique(np.concatenate(parts).reshape(-1, 9), axis=0).reshape(-1, 3, 3)
    points, number = np.unique(triangles.reshape(-1, 3), axis=0, return_inverse=True)
    faces = number.reshape(-1, 3)
    edges = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    key, opposite = edges[:, 0] * len(points) + edges[:, 1], edges[:, 1] * len(points) + edges[:, 0]
    assert len(np.unique(key)) == len(key)
    lone = points[edges[~np.isin(key, opposite)]]
    # No boundary edge lies inside both boxes together, seen from above.
    beyond = [(lone[..., k] <= low).all(1) | (lone[..., k] >= high).all(1) for k, low, high in OUTER]
    assert len(lone)
    assert np.any(beyond, axis=0).all()
    assert points.min(0)[0] <= -2000
    assert points.max(0)[0] >= -1500


PLACES = [(0, 0), (150, 90)]
"""Tiles of level 2 with large errors: the town of seed 0, and mountains."""


@pytest.mark.parametrize("place", PLACES)
def test_coarse_ground_stays_within_its_error(place: tuple[int, int]) -> None:
    i, j = place
    fine = {(a, b): tiles.tile(0, 0, 4 * i + a, 4 * j + b).height for a in range(4) for b in [(0, 2, 1, 3)[a]]}
    for level in range(1, 5):
        worst = 0.0
        for (a, b), height in fine.items():
            lines = (lattice.SPACING * (64 * (4 * n + m) + np.arange(64)) for n, m in ((j, b), (i, a)))
            z, x = np.meshgrid(*lines, indexing="ij")
            below = tiles.foot(0, level, x.reshape(-1), z.reshape(-1)).reshape(x.shape)
            worst = max(worst, float(np.abs(below - height[:-1, :-1]).max()))
        assert worst <= lattice.error(level)


def test_the_coarsest_ground_stays_within_its_error() -> None:
    for level, i, j, row, column_ in ((7, 0, 0, 5, 9), (11, -1, -1, 60, 2)):
        coarse = tiles.tile(0, level, i, j)
        x, z = ((n * 64 + k + 0.3) * lattice.spacing(level) for n, k in ((i, column_), (j, row)))
        side = 64 * lattice.SPACING
        fine = tiles.tile(0, 0, int(x // side), int(z // side))
        a, b = int((x % side) // lattice.SPACING), int((z % side) // lattice.SPACING)
        at = [np.array([(n * 64 + k) * lattice.SPACING]) for n, k in ((fine.i, a), (fine.j, b))]
        difference = tiles.foot(0, level, *at)[0] - fine.height[b, a]
        assert abs(difference) <= lattice.error(level)
        assert coarse.height.shape == (65, 65)


def test_levels_share_vertices() -> None:
    fine, coarse = tiles.tile(0, 2, -1, -1), tiles.tile(0, 3, -1, -1)
    np.testing.assert_array_equal(fine.height[::2, ::2], coarse.height[32:, 32:])


@pytest.mark.slow
@pytest.mark.parametrize("detail", [1.0, 4.0, 30.0])
def test_coarse_parts_deviate_from_fine_ones_by_at_most_detail(detail: float) -> None:
    half = 25.0
    for x, z in ((0.0, 0.0), (800.0, -900.0)):
        box, wide = (column(x - side, x + side, z - side, z + side) for side in (half, half + 2 * detail + 10))
        for part, whole in ((0.0, detail), (detail, 0.0)):
            points = corners(WORLD.query(box, part)).reshape(-1, 3)
            inside = (np.abs(points[:, [0, 2]] - [x, z]) <= half).all(1)
            points = np.unique(points[inside], axis=0)
            assert len(points) > 10
            distance = nf.nearest_points(WORLD.query(wide, whole), points).distance
            assert distance.max() <= detail


@pytest.mark.slow
def test_detail_omits_and_simplifies_objects() -> None:
    counts = [WORLD.query(TOWN, detail).triangle_count for detail in (0.0, 12.0, 200.0)]
    assert all(a > 1.2 * b for a, b in itertools.pairwise(counts))
    names = WORLD.query(TOWN, 24.0).object_names
    assert not [name for name in names if name.startswith(("car_", "bush_", "rock_", "lamp_"))]
    assert [name for name in names if name.startswith("church_")]


@pytest.mark.parametrize(
    "box",
    [
        [[0, 2800, 0], [100, 3000, 100]],
        [[0, -300, 0], [100, -200, 100]],
        [[4500, -100, 0], [4600, 100, 100]],
        [[100, 200, 100], [200, 300, 200]],
        [[np.inf] * 3, [np.inf] * 3],
    ],
)
def test_empty_space_is_an_empty_scene(box: Any) -> None:
    assert WORLD.query(box).triangle_count == 0


def test_a_world_ends_at_its_bounds() -> None:
    world = datasets.world(1)
    scene = world.query([[-np.inf] * 3, [np.inf] * 3], 12.0)
    ground = land(scene)
    np.testing.assert_array_equal(ground.min((0, 1))[[0, 2]], [-500, -500])
    np.testing.assert_array_equal(ground.max((0, 1))[[0, 2]], [500, 500])
    assert (corners(scene).min((0, 1)) >= world.bounds[0]).all()
    assert (corners(scene).max((0, 1)) <= world.bounds[1]).all()
    # Four tiles, each with a quarter of it inside: 32 × 32 cells of two triangles.
    assert len(ground) == 4 * 32 * 32 * 2


def test_smaller_worlds_are_the_middles_of_larger_ones() -> None:
    box = column(100, 160, 200, 240)
    first, second = (corners(datasets.world(km).query(box)) for km in (1, 777))
    np.testing.assert_array_equal(first, second)


def test_far_away_the_ground_is_as_precise() -> None:
    world = datasets.world(10_000)
    first, second = (
        column(4_990_010, 4_990_200, -3_000_100, -2_999_900),
        column(4_990_100, 4_990_400, -3_000_000, -2_999_700),
    )
    scenes = [world.query(box) for box in (first, second)]
    assert all(np.abs(scene.origin[0]) > 1.0e6 for scene in scenes)
    a, b = (land(scene) for scene in scenes)
    for points in (a, b):
        assert (points % (1.0 / 64.0) == 0.0).all()
        assert (points[..., [0, 2]] % lattice.SPACING == 0.0).all()
    inside = ((a >= second[0]) & (a <= second[1])).all(2).any(1)
    assert inside.sum() > 100
    assert rows(a[inside]) <= rows(b)
    # Both lie around their boxes, and instances stand on the ground.
    assert np.abs(a.mean((0, 1)) - first.mean(0))[[0, 2]].max() < 60


def test_a_point_touches_its_triangle() -> None:
    part = land(WORLD.query(column(801, 801, -901, -901)))
    flat = part[:, :, [0, 2]]
    assert 1 <= len(part) <= 2
    assert (flat.min((0, 1)) <= [801, -901]).all()
    assert (flat.max((0, 1)) >= [801, -901]).all()


def test_a_box_with_too_many_triangles_is_refused_at_once() -> None:
    with pytest.raises(ValueError, match=r"aabb: expected at most 8,192 tiles .* at detail 0, got 1,600,000,000"):
        datasets.world(10_000).query([[-np.inf] * 3, [np.inf] * 3])
    assert 100 < datasets.world(16).query([[-np.inf] * 3, [np.inf] * 3], 1000.0).triangle_count < 10_000


GOLDEN = "0bd04306e215c331"
"""Digest of a tile; it changes only with the world."""


def test_the_ground_has_the_same_bytes_everywhere() -> None:
    ground = tiles.tile(0, 0, 3, -4)
    assert digest(ground.height, ground.color)[:16] == GOLDEN
