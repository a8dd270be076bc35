"""Tests of the second layer against a slow definition, and on scenes with known hidden surfaces."""

from __future__ import annotations

import functools
from collections.abc import Sequence
from typing import Any

import numpy as np
import pytest
import trimesh

import nearfar as nf
from nearfar import _core
from nearfar.orthoview._grid import directions_of
from tests.support import orthoview_layers as slow, orthoview_oracle as oracle
from tests.support.orthoview_cases import CORNER, FORMAT, SIDE, SIZE, STEPS, boxes, check_alike, leaf, picture
from tests.support.orthoview_oracle import OCTANTS, Picture, Triple

NINE: list[Triple] = list(directions_of(9))
DOWN = NINE.index((0, 1, 0))


def second(views: _core.OrthoViews) -> _core.OrthoViews:
    behind = views.second_layer()
    assert behind is not None
    return behind


def same(one: _core.OrthoViews, other: _core.OrthoViews) -> bool:
    """Whether all pixels are bit-identical."""
    arrays = ((views.colors(), views.depths(), views.normals()) for views in (one, other))
    return all(np.array_equal(*pair) for pair in zip(*arrays, strict=True))


@functools.cache
def behind_by_definition(direction: Triple) -> Picture:
    scene, colors = boxes()
    triangles = scene.triangles().astype(np.float64) + scene.origin
    return slow.Leaf(triangles, colors, CORNER, SIDE, SIZE, STEPS).second_layer(direction, NINE)


@pytest.mark.parametrize("way", ["rays", "triangles"])
@pytest.mark.parametrize("direction", [(0, 0, 1), (0, 1, 0), (1, 1, 0)])
def test_the_second_layer_equals_its_definition(direction: Triple, way: str) -> None:
    scene, _ = boxes()
    right = behind_by_definition(direction)
    assert np.isfinite(right.depth).mean() > 0.1
    got = picture(second(leaf(scene, directions=NINE, way=way, behind=True)), NINE.index(direction))
    check_alike(got, right, share=0.01)


@pytest.mark.parametrize("way", ["rays", "triangles"])
def test_the_first_layer_does_not_depend_on_the_second(way: str) -> None:
    scene, _ = boxes(side=2 * SIDE)
    parents = [_core.OrthoParent(NINE, FORMAT, behind=behind) for behind in (False, True)]
    for octant in OCTANTS:
        corner = CORNER + np.array(octant) * SIDE
        alone, both = (leaf(scene, corner, directions=NINE, way=way, behind=behind) for behind in (False, True))
        assert alone.second_layer() is None
        assert same(alone, both)
        for parent, views in zip(parents, (alone, both), strict=True):
            parent.add(octant, views)
    alone, both = (parent.finish() for parent in parents)
    assert alone.second_layer() is None
    assert same(alone, both)
    assert not all(second(both).empty())


@functools.cache
def children() -> tuple[tuple[Triple, _core.OrthoViews], ...]:
    scene, _ = boxes(200, side=2 * SIDE)
    corners = [(octant, CORNER + np.array(octant) * SIDE) for octant in OCTANTS]
    return tuple((octant, leaf(scene, corner, directions=NINE, behind=True)) for octant, corner in corners)


def parent_of(drawn: Sequence[tuple[Triple, _core.OrthoViews]]) -> _core.OrthoViews:
    parent = _core.OrthoParent(NINE, FORMAT, behind=True)
    for octant, views in drawn:
        parent.add(octant, views)
    return parent.finish()


@pytest.mark.parametrize("number", [DOWN, 6])
def test_a_parents_second_layer_is_composed_of_all_layers_of_its_children(number: int) -> None:
    drawn = [*children()]
    # One child has no second layer, as if omitted: its first one may be behind another child's.
    drawn[1] = (drawn[1][0], drawn[1][1].keep_behind([False] * len(NINE)))
    parent = parent_of(drawn)
    layers = [(octant, [views, *filter(None, [views.second_layer()])]) for octant, views in drawn]
    pictures = [(octant, [picture(views, number) for views in of_child]) for octant, of_child in layers]
    for views, right in zip((parent, second(parent)), slow.composed(pictures, NINE[number], SIZE, STEPS), strict=True):
        got = picture(views, number)
        np.testing.assert_array_equal(got.depth, right.depth)
        is_there = np.isfinite(got.depth)
        assert is_there.mean() > 0.1
        assert np.abs(got.color - right.color)[is_there].max() < 0.006
        assert (got.normal * right.normal).sum(axis=2)[is_there].min() > np.cos(np.radians(0.1))


def test_the_order_of_children_matters_only_at_equal_depths() -> None:
    drawn = children()
    one, other = parent_of(drawn), parent_of(drawn[::-1])
    for views, reversed_views in ((one, other), (second(one), second(other))):
        np.testing.assert_array_equal(views.depths(), reversed_views.depths())
        apart = (views.colors() != reversed_views.colors()).any(axis=-1)
        assert apart.sum() <= 0.002 * (views.depths() > 0).sum()


def test_no_surface_is_in_both_layers() -> None:
    for views in (children()[0][1], parent_of(children())):
        first, behind = (layer.depths().astype(float) for layer in (views, second(views)))
        for direction, near, far in zip(NINE, first, behind, strict=True):
            extents = oracle.Axes.from_direction(direction).extents
            reach = oracle.REACH_PIXELS * max(extents[:2]) / (2 * SIZE) / (extents[2] / STEPS)
            apart = (far - near)[far > 0]
            assert len(apart)
            assert (near[far > 0] > 0).all()
            # Depths lie anywhere within their steps.
            assert apart.min() > reach - 1


def plate(corner: Any, extents: Any) -> trimesh.Trimesh:
    """A box given by a corner, relative to the cell's, and extents."""
    box = trimesh.creation.box(extents)
    box.apply_translation(CORNER + corner + np.multiply(extents, 0.5))
    return box


def on_ground(*parts: trimesh.Trimesh) -> nf.Scene:
    """Parts above a ground sheet at y = −2.5 of the cell."""
    low, high = CORNER - 5, CORNER + SIDE + 5
    corners = [(low[0], -2.5, low[2]), (low[0], -2.5, high[2]), (high[0], -2.5, high[2]), (high[0], -2.5, low[2])]
    ground = trimesh.Trimesh(corners, [[0, 1, 2], [0, 2, 3]], process=False)
    return nf.Scene.from_trimesh(trimesh.util.concatenate([ground, *parts]))


def test_the_second_layer_shows_the_visible_ground_below_a_table() -> None:
    views = leaf(on_ground(plate((3, 8, 2), (14.0, 0.5, 16.0))), directions=NINE, behind=True)
    got = second(views).depths()[DOWN, ..., 0]
    # The lines half-way to the upper edges lean by 22.5° and pass below the edge of the table, 7.5 m above the ground.
    reach, pixel = 7.5 * np.tan(np.radians(22.5)), SIDE / SIZE
    place = (np.arange(SIZE) + 0.5) * pixel
    across, along = np.minimum(place - 3, 17 - place), np.minimum(place - 2, 18 - place)
    distance = np.minimum(across, along[:, None])
    assert (got[(distance > pixel) & (distance < reach - pixel)] == np.ceil((SIDE - 0.5) / SIDE * STEPS)).all()
    assert not got[(distance < -pixel) | (distance > reach + pixel)].any()
    assert (distance > reach + pixel).any()


def test_the_second_layer_omits_the_inside_of_a_house_and_the_ground_below() -> None:
    house = plate((5, 0.5, 5), (10.0, 11.0, 10.0))
    behind = second(leaf(on_ground(house), directions=NINE, behind=True))
    # From the upper edges the house hides ground beside it.
    assert behind.empty() == [direction not in directions_of(9)[5:] for direction in NINE]
    number = NINE.index((0, 1, 1))
    depths = behind.depths()[number, ..., 0].astype(float)
    front = oracle.pixel_points(CORNER, SIDE, NINE[number], SIZE)
    axes = oracle.Axes.from_direction(NINE[number])
    points = front - ((depths - 0.5) * axes.extents[2] * SIDE / STEPS)[..., None] * axes.toward
    shown = points[depths > 0] - CORNER
    # The house is 11 m high and ends at z = 5.
    assert (np.abs(shown[:, 1] - 0.5) < 0.5).all()
    assert (shown[:, 2] < 5.5).all()
    assert shown[:, 2].min() < 0.5
    assert np.ptp(shown[:, 0]) > 8.5


def test_cells_without_hidden_surfaces_have_no_second_layer() -> None:
    ground = on_ground()
    views = leaf(ground, directions=NINE, behind=True)
    assert not all(views.empty())
    assert views.second_layer() is None
    assert views.unseen() == [0.0] * 9
    parent = _core.OrthoParent(NINE, FORMAT, behind=True)
    for octant in ((0, 0, 0), (1, 0, 0)):
        parent.add(octant, views)
    assert parent.finish().second_layer() is None


def test_an_occluded_child_is_in_the_second_layer() -> None:
    """The far child is added first, and then moved back by the near one."""
    far = leaf(on_ground(), directions=NINE)
    near = leaf(nf.Scene.from_trimesh(plate((5, 10, 5), (10.0, 1.0, 10.0))), directions=NINE)
    for order in (((0, 0, 0), (0, 1, 0)), ((0, 1, 0), (0, 0, 0))):
        parent = _core.OrthoParent(NINE, FORMAT, behind=True)
        for octant in order:
            parent.add(octant, near if octant[1] else far)
        depths = second(parent.finish()).depths()[DOWN, ..., 0]
        # The near child is 5 to 15 m of the parent's 40 m wide.
        place = (np.arange(SIZE) + 0.5) / SIZE * 2 * SIDE
        inside = (place > 5) & (place < 15)
        right = inside & inside[:, None]
        assert (depths[right] == np.ceil((2 * SIDE - 0.5) / (2 * SIDE) * STEPS)).all()
        assert not depths[~right].any()


@pytest.mark.slow
def test_the_unseen_share_counts_points_without_a_view() -> None:
    scene, _ = boxes(120)
    views = leaf(scene, directions=NINE, behind=True)
    firsts, seconds = list(views.depths()[..., 0]), list(second(views).depths()[..., 0])
    right = slow.unseen(firsts, seconds, NINE, STEPS)
    np.testing.assert_allclose(views.unseen(), right, atol=0.002)
    assert 0.002 < right.mean() < 0.5


def test_second_layers_are_restored_from_arrays_and_omitted_by_direction() -> None:
    scene, _ = boxes()
    views = leaf(scene, directions=NINE, behind=True)
    behind = second(views)
    alone = leaf(scene, directions=NINE)
    arrays: list[Any] = [behind.colors(), behind.depths(), behind.normals()]
    again = _core.OrthoViews.with_behind(alone, _core.OrthoViews.from_arrays(NINE, FORMAT, *arrays))
    assert same(again, views)
    assert same(second(again), behind)
    assert alone.second_layer() is None
    keep = [number % 2 == 0 for number in range(9)]
    kept = second(views.keep_behind(keep))
    assert kept.empty() == [not is_kept for is_kept in keep]
    np.testing.assert_array_equal(kept.depths()[::2], behind.depths()[::2])
    assert views.keep_behind([False] * 9).second_layer() is None
    nothing = _core.OrthoViews.from_arrays(NINE, FORMAT, *(np.zeros_like(array) for array in arrays))
    assert _core.OrthoViews.with_behind(alone, nothing).second_layer() is None
    with pytest.raises(ValueError, match="keep: expected 9 values"):
        views.keep_behind([True] * 8)
    with pytest.raises(ValueError, match="directions and the format of the first layer"):
        _core.OrthoViews.with_behind(alone, leaf(scene, directions=NINE[:5]))
