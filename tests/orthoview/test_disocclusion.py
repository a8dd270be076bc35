"""Tests of disocclusion, the share of a world that views hide, and of the set of directions chosen by it."""

from __future__ import annotations

import itertools
from typing import Any

import numpy as np
import pytest
import trimesh
from numpy.typing import ArrayLike, NDArray

import nearfar as nf
from nearfar._base import progress
from nearfar.orthoview import _disocclusion as measure, _sampling as sampling
from nearfar.orthoview._disocclusion import SIZE, choose_directions, nearest, smallest_set, viewers
from nearfar.orthoview._grid import COUNTS, Grid, Place, directions_of
from nearfar.orthoview._sampling import leaves
from tests.support.orthoview_cases import boxes

SIDE = 20.0
ONE = Grid((0.0, 0.0, 0.0), SIDE, (1, 1, 1))
ALONE: Place = (0, 0, 0)


def disocclusion(part: nf.Scene, grid: Grid, place: Any, *, size: int = SIZE) -> dict[int, float]:
    """Share of a leaf's visible surface that the views of each set of directions hide, 0 for an empty leaf."""
    visible, hidden = measure._count_holes(part, grid, place, COUNTS, size, measure.viewers(below=False))
    return {count: hidden[count] / max(visible, 1) for count in COUNTS}


def scene_of(*meshes: trimesh.Trimesh) -> nf.Scene:
    return nf.Scene.from_trimesh(trimesh.util.concatenate(list(meshes)))


def block(low: ArrayLike, high: ArrayLike) -> trimesh.Trimesh:
    return trimesh.creation.box(bounds=[low, high])


def sheet(*corners: ArrayLike) -> trimesh.Trimesh:
    return trimesh.Trimesh(np.array(corners, np.float64), [[0, 1, 2], [0, 2, 3]])


def seen_across(monkeypatch: pytest.MonkeyPatch, scene: nf.Scene, slope: float) -> dict[int, float]:
    """Disocclusion for a single viewer in the direction (0, slope, 1)."""
    viewer = np.array([[0.0, slope, 1.0]]) / np.hypot(slope, 1.0)
    monkeypatch.setattr(measure, "viewers", lambda below: viewer)
    monkeypatch.setattr(measure, "RAYS", 300)  # Lengths of walls are counted in whole rays.
    return disocclusion(scene, ONE, ALONE, size=256)


def test_viewers_are_distributed_evenly_over_the_upper_hemisphere() -> None:
    looks = viewers()
    np.testing.assert_allclose(np.linalg.norm(looks, axis=1), 1)
    # Each of n evenly spread points on a hemisphere has 2π/n: the area of a cap of the angle acos(1 − 1/n).
    cap = np.arccos(1 - 1 / len(looks))
    apart = np.arccos(np.clip(looks @ looks.T - 2 * np.eye(len(looks)), -1, 1)).min(axis=1)
    assert (apart > cap).all()
    assert (apart < 2.5 * cap).all()
    assert 0 < looks[:, 1].min() < np.sin(np.radians(2))
    all_round = viewers(below=True)
    np.testing.assert_allclose(np.sort(all_round[:, 1]), np.sort(-all_round[:, 1]), atol=1e-12)


@pytest.mark.parametrize("count", COUNTS)
def test_the_nearest_directions_have_the_least_angles(count: int) -> None:
    directions = np.array([np.array(d) / np.linalg.norm(d) for d in directions_of(count)])
    for viewer in viewers():
        angles = [np.arctan2(np.linalg.norm(np.cross(d, viewer)), d @ viewer) for d in directions]
        assert sorted(nearest(directions, viewer)) == sorted(sorted(range(count), key=lambda n: angles[n])[:3])
    # Among equally near directions the first is used, regardless of rounding.
    first = {5: [0, 1, 4], 9: [5, 6, 0], 13: [9, 5, 6], 26: [9, 5, 6]}[count]
    assert nearest(directions, np.array([1.0, 1.0, 1.0]) / np.sqrt(3)) == first


def test_single_surfaces_hide_nothing() -> None:
    turn = trimesh.transformations.rotation_matrix(0.5, (0.2, 1, 0.1), (10, 10, 10))
    alone = {
        "a ball": trimesh.creation.icosphere(4, 6.0).apply_translation((10, 10, 10)),
        "a turned box": block((6, 6, 6), (14, 14, 14)).apply_transform(turn),
        "a slope": sheet((0, 2, 0), (20, 8, 0), (20, 8, 20), (0, 2, 20)),
        "level ground on a side of the cell": sheet((0, 0, 0), (20, 0, 0), (20, 0, 20), (0, 0, 20)),
    }
    for name, mesh in alone.items():
        shares = disocclusion(scene_of(mesh), ONE, ALONE)
        assert max(shares.values()) < 0.003, name
        seen, _ = measure._count_holes(scene_of(mesh), ONE, ALONE, (5,), 32, viewers())
        assert seen > 10_000, name


@pytest.mark.parametrize("slope", [0.5, 1.0])
def test_a_wall_hides_the_foot_of_a_higher_one(monkeypatch: pytest.MonkeyPatch, slope: float) -> None:
    # From the front the near wall hides 10 m of the far one, 4 m behind, of which viewers see 4 · slope metres over the
    # near wall's top. They see 10 m of the near wall, and of the far one 6 m and those: all foreshortened alike.
    walls = scene_of(
        sheet((0, 0, 5), (20, 0, 5), (20, 16, 5), (0, 16, 5)), sheet((0, 0, 9), (20, 0, 9), (20, 10, 9), (0, 10, 9))
    )
    shares = seen_across(monkeypatch, walls, slope)
    assert shares[5] == pytest.approx(4 * slope / (16 + 4 * slope), abs=0.01)
    # The direction (0, 1, 1) sees as much as a viewer at 45°, and more than one below.
    assert shares[9] < 0.003


@pytest.mark.parametrize(("slope", "five", "nine"), [(0.5, 3, 0), (1.0, 6, 0), (1.5, 9, 3)])
def test_disocclusion_of_street_canyons_equals_trigonometry(
    monkeypatch: pytest.MonkeyPatch, slope: float, five: float, nine: float
) -> None:
    # A street of 6 m between houses of 10 m, whose ends are open. A viewer sees 6 · slope metres of the wall beyond the
    # street, which neither the front nor the top shows. The direction (0, 1, 1) shows 6 m of it. The viewer sees the
    # cell's 20 m of roofs, street and ground times sin e, and 10 m of walls times cos e; slope = tan e.
    houses = block((0, 0, 0), (20, 10, 8)), block((0, 0, 14), (20, 10, 18))
    canyon = scene_of(*houses, sheet((0, 0, 0), (20, 0, 0), (20, 0, 20), (0, 0, 20)))
    shares = seen_across(monkeypatch, canyon, slope)
    assert shares[5] == pytest.approx(five / (20 * slope + 10), abs=0.01)
    assert shares[9] == pytest.approx(nine / (20 * slope + 10), abs=0.01)


def test_disocclusion_equals_rays_back_to_the_views() -> None:
    # Slow reference: a direction shows a point if nothing in the cell lies between it and a viewer in that direction.
    scene, _ = boxes(40, SIDE)
    grid = Grid((40.0, -3.0, -60.0), SIDE, (1, 1, 1))
    box, holes, total = grid.box(0, ALONE), dict.fromkeys(COUNTS, 0), 0
    looks = viewers()
    for viewer, visible in zip(looks, measure._visible(scene, box, looks), strict=True):
        points = visible[::5]
        total += len(points)
        for count in COUNTS:
            shown = np.zeros(len(points), bool)
            directions = np.array([np.array(d) / np.linalg.norm(d) for d in directions_of(count)])
            for number in nearest(directions, viewer):
                toward = directions[number]
                starts = points + 1e-3 * toward
                with np.errstate(divide="ignore"):
                    room = np.where(toward > 0, (box[1] - starts) / toward, (box[0] - starts) / toward)
                room = np.where(toward == 0, np.inf, room).min(axis=1)
                shown |= nf.cast_rays(scene, starts, np.broadcast_to(toward, starts.shape)).t_hit > room
            holes[count] += int((~shown).sum())
    exact = {count: number / total for count, number in holes.items()}
    measured = disocclusion(scene, grid, ALONE, size=256)
    assert exact[5] > 0.05
    # Views show surfaces at grazing angles poorly, and also show points within a pixel of their own.
    assert all(abs(exact[count] - measured[count]) < 0.015 for count in COUNTS), (exact, measured)


def street_grid(degrees: float) -> nf.Scene:
    """Houses of 3 × 3 m, 4 m high, with streets of 1 m between them, about the middle of a cell."""
    middle = SIDE / 2
    corners = [middle + 4 * (n - 5) + 0.5 for n in range(10)]
    houses = [block((x, 0, z), (x + 3, 4, z + 3)) for x, z in itertools.product(corners, corners)]
    turn = trimesh.transformations.rotation_matrix(np.radians(degrees), (0, 1, 0), (middle, 0, middle))
    ground = sheet((0, 0, 0), (20, 0, 0), (20, 0, 20), (0, 0, 20))
    return scene_of(trimesh.util.concatenate(houses).apply_transform(turn), ground)


def test_street_grids_defeat_views_along_their_axes() -> None:
    aligned, turned = (disocclusion(street_grid(degrees), ONE, ALONE) for degrees in (0, 30))
    assert aligned[5] > 1.4 * turned[5]
    assert aligned[9] > 2 * turned[9]
    assert aligned[13] < 0.5 * aligned[9]
    assert (smallest_set(aligned), smallest_set(turned)) == (13, 9)


def test_moving_objects_hide_nothing() -> None:
    wall = sheet((0, 0, 5), (20, 0, 5), (20, 16, 5), (0, 16, 5))
    door = sheet((0, 0, 9), (20, 0, 9), (20, 10, 9), (0, 10, 9))
    group = trimesh.Scene({"wall": wall, "door": door})
    both = nf.Scene.from_trimesh(group)
    assert disocclusion(both, ONE, ALONE)[5] > 0.02
    assert disocclusion(both.with_dynamic(["door"]), ONE, ALONE) == disocclusion(scene_of(wall), ONE, ALONE)
    moving = both.with_dynamic(["door", "wall"])
    assert disocclusion(moving, ONE, ALONE) == dict.fromkeys(COUNTS, 0.0)


def test_the_smallest_sufficient_set_is_chosen() -> None:
    good, worse = measure.GOOD_DISOCCLUSION, measure.GOOD_DISOCCLUSION + 2 * measure.MIN_IMPROVEMENT
    assert smallest_set({5: good, 9: 0.0, 13: 0.0, 26: 0.0}) == 5
    assert smallest_set({5: worse, 9: good, 13: 0.0, 26: 0.0}) == 9
    assert smallest_set({5: 0.5, 9: 0.4, 13: 0.3, 26: 0.2}) == 26
    # No set is good enough, and none is much better than the second.
    assert smallest_set({5: 0.5, 9: 0.2, 13: 0.195, 26: 0.195}) == 9
    # The next set is no better than the first, but the one after it is.
    assert smallest_set({5: 0.5, 9: 0.5, 13: 0.2, 26: 0.2}) == 13


class Counted:
    """A source that counts queries, and fails in chosen leaves."""

    def __init__(self, scene: nf.Scene, *, fails: Any = lambda box: False) -> None:
        self.scene, self.fails = scene, fails
        self.queries: list[NDArray[np.float64]] = []

    @property
    def bounds(self) -> NDArray[np.float64]:
        return self.scene.bounds

    def query(self, aabb: ArrayLike, detail: Any = 0.0) -> nf.Scene:
        box = np.asarray(aabb)
        self.queries.append(box)
        if self.fails(box):
            raise OSError("the disk is gone")
        return self.scene.query(box)


class Touching(Counted):
    """Such a source with `touches`."""

    looks = 0

    def touches(self, aabb: ArrayLike) -> bool:
        self.looks += 1
        return self.scene.touches(aabb)


def far_apart() -> nf.Scene:
    """Boxes in two corners of a world of 8,192 × 8,192 leaves of 20 m."""
    one = boxes(10, SIDE)[0].triangles().reshape(-1, 3).astype(np.float64)
    points = np.concatenate([one, one + np.array([160_000, 0, 160_000])])
    return nf.Scene.from_arrays(points, np.arange(len(points)).reshape(-1, 3))


def test_sparse_worlds_need_queries_per_level_instead_of_per_leaf(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(measure, "RAYS", 16)
    world = Touching(far_apart())
    grid = Grid.from_bounds(world.bounds, SIDE)
    assert grid.levels >= 14
    found = list(leaves(world, grid))
    assert len(found) == len(set(found)) >= 8
    assert {place[0] > 100 for place in found} == {True, False}
    assert all(world.scene.touches(grid.box(0, place)) for place in found)
    assert world.looks <= 8 * sampling.CELLS_PER_LEVEL * (grid.levels - 1)
    assert world.queries == []
    choice = choose_directions(world, grid)
    assert choice.cells >= 4
    assert len(world.queries) <= measure.COUNTED_LEAVES + measure.MAX_LEAVES


def test_scenes_in_memory_are_sampled_at_their_triangles() -> None:
    # Ground of 40,000 leaves, and boxes in nine of them.
    ground = sheet((-2000, 0, -2000), (2000, 0, -2000), (2000, 0, 2000), (-2000, 0, 2000))
    houses = [block((x, 0, z), (x + 9, 9, z + 9)) for x, z in itertools.product((105, 125, 145), (205, 225, 245))]
    scene = scene_of(ground, *houses)
    grid = Grid.from_bounds(scene.bounds, SIDE)
    first = list(itertools.islice(leaves(scene, grid), 9))
    built = {(100 + 5 + x, 0, 100 + 10 + z) for x in range(3) for z in range(3)}
    assert len(built & set(first)) >= 6
    # A grid over a part of the scene only has leaves of that part.
    part = Grid.from_bounds(np.array([[100.0, 0, 200], [119, 9, 219]]), SIDE)
    assert list(leaves(scene, part)) == [(0, 0, 0)]


def test_leaves_of_sources_without_touches_are_sampled_evenly() -> None:
    world = Counted(far_apart())
    grid = Grid.from_bounds(world.bounds, SIDE)
    drawn = np.array(list(leaves(world, grid)))
    assert 100 < len(drawn) <= sampling.UNIFORM_LEAVES
    assert (drawn < grid.counts).all()
    half = np.array(grid.counts)[[0, 2]] / 2
    quarters = (drawn[:, [0, 2]] < half) @ (1, 2)
    assert np.bincount(quarters, minlength=4).min() > 15
    few = Grid((0.0, 0.0, 0.0), SIDE, (3, 2, 4))
    assert sorted(leaves(world, few)) == list(itertools.product(range(3), range(2), range(4)))
    assert list(leaves(world, few)) == list(leaves(world, few)) != sorted(leaves(world, few))


def test_choices_are_deterministic(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(measure, "RAYS", 16)
    monkeypatch.setattr(measure, "MAX_LEAVES", 3)
    scene, _ = boxes(30, 80.0)
    grid = Grid.from_bounds(scene.bounds, 60.0)
    choice = choose_directions(scene, grid)
    assert choice == choose_directions(scene.query(scene.bounds), grid)
    assert choice.count == smallest_set(choice.shares)
    # The mean over its leaves, weighted by pixels, lies between their minimum and maximum.
    each = [
        disocclusion(scene.query(grid.box(0, place)), grid, place) for place in measure._densest(scene, grid, print)
    ]
    assert min(shares[5] for shares in each) < choice.shares[5] < max(shares[5] for shares in each)
    assert choice.cells == len(each) == 3


def test_leaves_whose_query_fails_are_skipped(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(measure, "RAYS", 16)
    scene, _ = boxes(30, 80.0)
    grid = Grid.from_bounds(scene.bounds, 30.0)
    near = [place for place in leaves(scene, grid) if place[0] == 2 and scene.query(grid.box(0, place)).triangle_count]
    middle = grid.box(0, (2, 0, 0))[:, 0]
    part = choose_directions(Touching(scene, fails=lambda box: box[0, 0] != middle[0]), grid)
    assert 0 < part.cells <= len(near) < measure.MAX_LEAVES
    none = choose_directions(Touching(scene, fails=lambda box: True), grid)
    assert none == measure.Choice(9, {}, 0)


def test_a_source_that_fails_at_the_second_query_is_skipped() -> None:
    scene, _ = boxes(30, 80.0)
    grid = Grid.from_bounds(scene.bounds, 30.0)
    world = Touching(scene)
    world.fails = lambda box: sum(bool((box == other).all()) for other in world.queries) == 2
    assert choose_directions(world, grid) == measure.Choice(9, {}, 0)
    assert len(world.queries) > measure.MAX_LEAVES


def test_empty_worlds_have_the_default_directions() -> None:
    scene, _ = boxes(3, 80.0)
    empty = scene.query([scene.bounds[0] - 9, scene.bounds[0] - 8])
    assert choose_directions(empty, ONE) == measure.Choice(9, {}, 0)
    assert disocclusion(empty, ONE, ALONE) == dict.fromkeys(COUNTS, 0.0)


def test_choosing_directions_can_be_interrupted() -> None:
    scene, _ = boxes(30, 80.0)
    world = Touching(scene)

    def stop() -> None:
        if len(world.queries) >= 3:
            raise KeyboardInterrupt

    with progress.watched(stop), pytest.raises(KeyboardInterrupt):
        choose_directions(world, Grid.from_bounds(scene.bounds, 30.0))
    assert len(world.queries) == 3
