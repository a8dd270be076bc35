"""Tests of blending levels: which splats of two levels are drawn, against slow code, and that both fit together."""

from __future__ import annotations

import itertools
from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from nearfar import _core
from nearfar.orthoview._codec import CONNECTION_LIMITS
from nearfar.orthoview._grid import Grid, Place
from tests.support.blend_oracle import Blend, Key
from tests.support.orthoview_cases import CORNER, SIDE, boxes
from tests.support.orthoview_oracle import OCTANTS, Triple, steps_of
from tests.support.splat_cases import MIDDLE, draw_splats

DIRECTIONS: list[Triple] = [(0, 1, 0), (1, 0, 0), (1, 1, 0), (-1, 1, 1)]
SIZE, BITS = 12, 12
"""Children lie on odd pixels of their parents' pictures for the direction of a corner."""

GRID = Grid((CORNER[0], CORNER[1], CORNER[2]), SIDE / 4, (4, 4, 4))
FOV = nf.Fov(-0.5, 0.5, -0.5, 0.5)
BAND = 0.25


@dataclass
class Pyramid:
    """Views of a cell, its children and grandchildren, including second layers."""

    layers: dict[Key, list[_core.OrthoSplats]] = field(default_factory=dict)
    depths: dict[Key, NDArray[Any]] = field(default_factory=dict)

    def add(self, level: int, place: Place, views: _core.OrthoViews) -> None:
        cell = (GRID.corner(level, place), GRID.side(level))
        behind = views.second_layer()
        for number in range(len(DIRECTIONS)):
            if views.empty()[number]:
                continue
            own = [_core.OrthoSplats(views, number, views.connected(CONNECTION_LIMITS), cell)]
            if behind is not None and not behind.empty()[number]:
                own.append(_core.OrthoSplats(behind, number, behind.connected(CONNECTION_LIMITS), cell))
            self.layers[level, place, number] = own
            self.depths[level, place, number] = views.depths()[number, ..., 0]


@pytest.fixture(scope="module")
def pyramid() -> Pyramid:
    scene, found = boxes()[0], Pyramid()
    layout = (SIZE, BITS, 16)
    top = _core.OrthoParent(DIRECTIONS, layout, behind=True)
    for x, y, z in OCTANTS:
        parent = _core.OrthoParent(DIRECTIONS, layout, behind=True)
        for i, j, k in OCTANTS:
            place = (2 * x + i, 2 * y + j, 2 * z + k)
            cell = (GRID.corner(0, place), GRID.side(0))
            views = _core.OrthoViews.of_cell(scene._core, cell, DIRECTIONS, layout, behind=True)
            parent.add((i, j, k), views)
            found.add(0, place, views)
        top.add((x, y, z), parent.finish())
        found.add(1, (x, y, z), parent.finish())
    found.add(2, (0, 0, 0), top.finish())
    assert any(len(layers) == 2 for layers in found.layers.values())
    return found


def eye_at(distance: float, fov: Any = FOV) -> nf.Camera:
    """A viewer at a distance from the cell's middle."""
    toward = np.array([0.6, 0.64, 0.48])
    return nf.Camera.look_at(MIDDLE + distance * toward, MIDDLE, fov=fov, size=(64, 64))


def rule_of(camera: nf.Camera, reach: float, gaze: Any = None, band: float | None = BAND) -> _core.OrthoRule:
    """A rule that gives the distance beyond which leaves are fine enough."""
    return _core.OrthoRule(camera._core, pitch=reach / 64, error=1.0, band=band, gaze=gaze)


def blended(
    pyramid: Pyramid, keys: Iterable[Key], partial: set[tuple[int, Place]], rule: _core.OrthoRule
) -> dict[Key, list[_core.OrthoSplats]]:
    wanted = list(keys)
    views = [(pyramid.layers[key], *key, key[:2] in partial) for key in wanted]
    return dict(zip(wanted, _core.blend_orthoviews(views, rule), strict=True))


@pytest.mark.parametrize("share", [0.2, 0.5, 0.9])
def test_the_number_of_splats_is_predicted(pyramid: Pyramid, share: float) -> None:
    """The splats of a far cell have one place in the band: that share of them is drawn, the rest of its children's."""
    camera = eye_at(5000.0)
    rule, partial = rule_of(camera, 5000 / 4 / (1 + BAND * share)), {(2, (0, 0, 0))}
    for level, right in ((2, share), (1, 1 - share)):
        # The children's share is known if the parent is among the views.
        keys = [key for key in pyramid.layers if key[0] in (2, level)]
        found, counts = blended(pyramid, keys, partial, rule), dict[int, int]()
        for key in keys:
            counts[key[0]] = counts.get(key[0], 0) + sum(layer.count for layer in found[key])
        whole = sum(layer.count for key in keys if key[0] == level for layer in pyramid.layers[key])
        # A parent's splat replaces four.
        assert abs(counts[level] - right * whole) < 4 * np.sqrt(4 * whole * share * (1 - share))
        expected = _core.expected_orthoviews([(pyramid.layers[key], *key, key[:2] in partial) for key in keys], rule)
        assert expected == pytest.approx(sum(counts.values()), rel=0.1)
    without = rule_of(camera, 1250.0, band=None)
    views = [(layers, *key, True) for key, layers in pyramid.layers.items()]
    total = sum(layer.count for layers in pyramid.layers.values() for layer in layers)
    assert _core.expected_orthoviews(views, without) == total


def pixels_of(key: Key, splats: _core.OrthoSplats) -> NDArray[np.bool_]:
    """The pixels of a view that have a splat, in parallel projection along its direction."""
    axes, extents = _core.orthoview_axes(DIRECTIONS[key[2]])
    side = GRID.side(key[0])
    middle = np.array(GRID.corner(key[0], key[1])) + side / 2
    half = np.array(extents) * side / 2
    camera = nf.Camera.look_at(
        middle + np.array(axes[2]) * 4 * side,
        middle,
        fov=nf.Orthographic(-half[0], half[0], -half[1], half[1]),
        size=(SIZE, SIZE),
        up=axes[1],
    )
    return np.asarray(np.isfinite(draw_splats([splats], camera, ("range",))["range"]))


def above(place: Place, levels: int = 1) -> Place:
    x, y, z = place
    return (x >> levels, y >> levels, z >> levels)


PARTIAL = {
    "the top and one child": {(2, (0, 0, 0)), (1, (0, 1, 1)), (1, (1, 0, 0))},
    "the top": {(2, (0, 0, 0))},
    "children": {(1, place) for place in OCTANTS},
}


@pytest.mark.parametrize(("name", "distance"), [*zip(PARTIAL, (24.0, 40.0, 31.0), strict=True)])
def test_drawn_splats_are_coarse_enough_and_not_covered(pyramid: Pyramid, name: str, distance: float) -> None:
    partial = PARTIAL[name]
    camera, reach = eye_at(distance), 15.0 if name == "children" else 7.5
    eye = np.array(camera.position)
    # Includes a direction missing in a parent: then the children decide by their own surfaces.
    keys = [key for key in pyramid.layers if key[2] in (0, 2, 3) or key[0] == 1]
    own = Blend(
        GRID,
        DIRECTIONS,
        {key: pyramid.depths[key] for key in keys},
        partial,
        steps_of(BITS),
        lambda point: float(np.linalg.norm(point - eye)),
        reach,
        BAND,
    )
    found = blended(pyramid, keys, partial, rule_of(camera, reach))
    shares = set()
    for key in keys:
        right = own.drawn_pixels(key)
        assert found[key][0].count == right.sum(), key
        np.testing.assert_array_equal(pixels_of(key, found[key][0]), right)
        shown = pyramid.depths[key] > 0
        shares.add(bool(right.any()) + 2 * bool((shown & ~right).any()))
        if len(pyramid.layers[key]) == 2:
            # Second layers follow the first.
            whole = pixels_of(key, pyramid.layers[key][1])
            np.testing.assert_array_equal(pixels_of(key, found[key][1]), whole & right)
    assert 3 in shares


@pytest.mark.parametrize("distance", [26.0, 31.0, 35.0, 60.0, 5.0])
def test_two_levels_complement_each_other(pyramid: Pyramid, distance: float) -> None:
    """In a parent's pixel either its own splat is drawn or all of its children's."""
    partial = PARTIAL["the top"]
    keys = [key for key in pyramid.layers if key[0] > 0]
    found = blended(pyramid, keys, partial, rule_of(eye_at(distance), 7.5))
    oracle = Blend(GRID, DIRECTIONS, pyramid.depths, partial, 0, lambda point: 0.0, 0.0, 0.0)
    for number in range(len(DIRECTIONS)):
        of_parent = pixels_of((2, (0, 0, 0), number), found[2, (0, 0, 0), number][0])
        for place in OCTANTS:
            key = (1, place, number)
            if key not in keys:
                continue
            of_child = pixels_of(key, found[key][0])
            for row, column in np.argwhere(pyramid.depths[key]):
                parent = of_parent[oracle.pixel_above(key, (int(row), int(column)))]
                assert parent != of_child[row, column]
    total = sum(found[2, (0, 0, 0), number][0].count for number in range(len(DIRECTIONS)))
    whole = sum(pyramid.layers[2, (0, 0, 0), number][0].count for number in range(len(DIRECTIONS)))
    if distance in (60.0, 5.0):
        assert total == (whole if distance == 60.0 else 0)
    else:
        assert 0.02 * whole < total < 0.98 * whole


def test_splats_change_gradually(pyramid: Pyramid) -> None:
    """A viewer that approaches through the band changes all splats of a cell, few at a time."""
    partial, number = PARTIAL["the top"], 2
    key = (2, (0, 0, 0), number)
    whole = pyramid.layers[key][0].count
    distances = np.linspace(52, 18, 200)
    seen = [pixels_of(key, blended(pyramid, [key], partial, rule_of(eye_at(d), 7.5))[key][0]) for d in distances]
    assert seen[0].sum() == whole
    assert seen[-1].sum() == 0
    changes = [int((one != other).sum()) for one, other in itertools.pairwise(seen)]
    # The cell's surfaces and the band take 17 of the 34 m, 100 of the steps.
    assert max(changes) <= 0.08 * whole
    assert sum(changes) == whole


def test_distances_grow_away_from_the_gaze(pyramid: Pyramid) -> None:
    partial, camera, reach = PARTIAL["the top"], eye_at(40.0), 9.0
    eye, pixel = np.array(camera.position), (60.0, 40.0)
    through = camera.rays()[1][39:41, 59:61].mean(axis=(0, 1))
    through /= np.linalg.norm(through)
    pixel_deg = np.degrees(np.arctan(1 / 64))
    keys = [key for key in pyramid.layers if key[0] == 2]

    def apparent(point: NDArray[np.float64]) -> float:
        offset = point - eye
        angle = np.degrees(np.arccos(offset @ through / np.linalg.norm(offset)))
        return float(np.linalg.norm(offset) / nf.lod.acuity([angle], pixel_deg=pixel_deg)[0])

    own = Blend(GRID, DIRECTIONS, pyramid.depths, partial, steps_of(BITS), apparent, reach, BAND)
    found = blended(pyramid, keys, partial, rule_of(camera, reach, (pixel, 0.0275, 1 / 48)))
    for key in keys:
        assert found[key][0].count == own.drawn_pixels(key).sum()
    without = blended(pyramid, keys, partial, rule_of(camera, reach))
    assert sum(found[key][0].count for key in keys) > 1.2 * sum(without[key][0].count for key in keys) > 0


def test_parallel_rays_blend_levels_by_the_width_of_their_pixels(pyramid: Pyramid) -> None:
    partial, key = PARTIAL["the top"], (2, (0, 0, 0), 1)
    shares = []
    for width in (8.0, 11.3, 30.0):
        # A pixel of the picture is width/64 m wide, a pixel of a leaf's views 1/32 m: four times that at level 2.
        camera = eye_at(40.0, nf.Orthographic(-width / 2, width / 2, -width / 2, width / 2))
        rule = _core.OrthoRule(camera._core, pitch=1 / 26, error=1.0, band=BAND, gaze=None)
        shares.append(blended(pyramid, [key], partial, rule)[key][0].count / pyramid.layers[key][0].count)
        luck = 1 / ((1 / 26) / (width / 64) * 4) - 1
        assert shares[-1] == pytest.approx(min(max(luck / BAND, 0), 1), abs=0.1)
    assert shares[0] == 0 < shares[1] < shares[2] == 1


def test_without_a_band_all_splats_are_drawn(pyramid: Pyramid) -> None:
    keys = list(pyramid.layers)
    rule = rule_of(eye_at(31.0), 7.5, band=None)
    found = blended(pyramid, keys, PARTIAL["the top"], rule)
    assert all(found[key] == pyramid.layers[key] for key in keys)
    # Views outside the band are the same objects.
    rule = rule_of(eye_at(31.0), 7.5)
    leaf = next(key for key in keys if key[0] == 0)
    assert blended(pyramid, [leaf], set(), rule)[leaf] == pyramid.layers[leaf]


def test_invalid_blend_rules_are_named() -> None:
    camera, flat = eye_at(31.0)._core, eye_at(31.0, nf.Orthographic(-1, 1, -1, 1))._core
    for band in (0.0, -0.5, 1.5, np.nan):
        with pytest.raises(ValueError, match="band: expected a number above 0, at most 1"):
            _core.OrthoRule(camera, pitch=1.0, error=1.0, band=band)
    with pytest.raises(ValueError, match="gaze: expected a camera with perspective, or None, got parallel rays"):
        _core.OrthoRule(flat, pitch=1.0, error=1.0, gaze=((3.0, 4.0), 0.0275, 1 / 48))
    with pytest.raises(ValueError, match="views: expected at least one layer of each, got none"):
        _core.blend_orthoviews([([], 0, (0, 0, 0), 0, False)], rule_of(eye_at(31.0), 1.0))
