"""Triangulated polygons against Mapbox's own program and formulas, prisms, and WKB."""

from __future__ import annotations

import itertools
import struct
from collections.abc import Sequence

import mapbox_earcut
import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from numpy.typing import NDArray

from nearfar import SceneError, _core
from nearfar._scene.city.collector import Surfaces
from nearfar._scene.city.outlines import offsets

Ring = NDArray[np.float64]


def packed(polygons: Sequence[Sequence[Ring]]) -> tuple[NDArray[np.float64], NDArray[np.int64], NDArray[np.int64]]:
    """Points, and offsets of rings and polygons."""
    rings = [ring for polygon in polygons for ring in polygon]
    points = np.concatenate([np.zeros((0, 2)), *rings])
    return points, offsets([len(ring) for ring in rings]), offsets([len(polygon) for polygon in polygons])


def shoelace(ring: Ring) -> float:
    """Signed area of a ring by the shoelace formula."""
    total = 0.0
    local = ring - ring[0]
    for (x0, y0), (x1, y1) in zip(local, np.roll(local, -1, axis=0), strict=True):
        total += x0 * y1 - x1 * y0
    return total / 2


def areas(points: NDArray[np.float64], faces: NDArray[np.uint32]) -> NDArray[np.float64]:
    a, b, c = np.moveaxis(points[faces], 1, 0)
    return np.asarray(((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]) / 2)


def star(random: np.random.Generator, count: int, scale: float, centre: tuple[float, float]) -> Ring:
    """A ring around a centre without self-intersections."""
    angle = (np.arange(count) + random.uniform(0, 0.9, count)) * 2 * np.pi / count
    radius = random.uniform(0.5, 1, count) * scale
    ring = np.stack([np.cos(angle), np.sin(angle)], axis=-1) * radius[:, None] + centre
    return ring[::-1].copy() if random.random() < 0.5 else ring


def polygons(seed: int, count: int) -> list[list[Ring]]:
    """Polygons at coordinates of a national grid, some with two holes."""
    random = np.random.default_rng(seed)
    made: list[list[Ring]] = []
    for _ in range(count):
        x, y = random.uniform(-1e6, 1e6, 2)
        outer = np.array([[-9.0, -9], [9, -9], [9, 9], [-9, 9]]) + np.array([x, y]) + star(random, 4, 1, (0, 0))
        holes = [star(random, int(random.integers(3, 20)), 3, (x + side, y)) for side in (-4, 4)]
        made.append(
            [outer, *holes] if random.random() < 0.5 else [star(random, int(random.integers(4, 90)), 9, (x, y))]
        )
    return made


def in_polygon(polygon: Sequence[Ring], points: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Whether points lie inside, by crossings of a ray."""
    odd = np.zeros(len(points), bool)
    for ring in polygon:
        for (x0, y0), (x1, y1) in zip(ring, np.roll(ring, -1, axis=0), strict=True):
            spans = (y0 > points[:, 1]) != (y1 > points[:, 1])
            if spans.any():
                cut = x0 + (points[:, 1] - y0) / (y1 - y0 if y1 != y0 else 1) * (x1 - x0)
                odd ^= spans & (points[:, 0] < cut)
    return odd


def test_areas_equal_the_shoelace_formula_and_triangles_lie_inside() -> None:
    made = polygons(3, 300)
    points, rings, runs = packed(made)
    faces, ends, crossing = _core.triangulate_polygons(points, rings, runs)
    assert crossing == 0
    assert (areas(points, faces) > -1e-9).all()
    for number, polygon in enumerate(made):
        own = faces[ends[number] : ends[number + 1]]
        expected = abs(shoelace(polygon[0])) - sum(abs(shoelace(hole)) for hole in polygon[1:])
        assert areas(points, own).sum() == pytest.approx(expected, rel=1e-9)
        big = own[areas(points, own) > 1e-6]
        assert in_polygon(polygon, points[big].mean(axis=1)).all()


def test_triangle_counts_equal_mapbox() -> None:
    made = polygons(5, 500)
    points, rings, runs = packed(made)
    _, ends, _ = _core.triangulate_polygons(points, rings, runs)
    counts = []
    for polygon in made:
        local = np.concatenate(polygon) - polygon[0][0]
        ring_ends = np.cumsum([len(ring) for ring in polygon]).astype(np.uint32)
        counts.append(len(mapbox_earcut.triangulate_float64(local, ring_ends)) // 3)
    assert np.array_equal(np.diff(ends), counts)


def test_degenerate_rings_are_triangulated() -> None:
    line = np.array([[0.0, 0], [1, 1], [2, 2]])
    twice = np.array([[0.0, 0], [0, 0], [4, 0], [4, 4], [4, 4], [0, 4]])
    bow = np.array([[0.0, 0], [4, 4], [4, 0], [0, 4]])
    touching = np.array([[0.0, 0], [2, 2], [4, 0], [4, 4], [2, 2], [0, 4]])
    points, rings, runs = packed([[line], [twice], [bow], [touching], [twice[:2], line], []])
    faces, ends, crossing = _core.triangulate_polygons(points, rings, runs)
    assert crossing == 1
    sums = [areas(points, faces[a:b]).sum() for a, b in itertools.pairwise(ends)]
    assert sums[0] == 0
    assert sums[1] == 16
    assert 0 < sums[2] <= 16
    assert sums[3] == 8
    assert sums[4:] == [0, 0]


def test_polygons_whose_rings_cross_are_counted() -> None:
    """At any place and size; holes that overlap, cross themselves or lie outside are not between the rings either."""
    bow = np.array([[0.0, 0], [4, 4], [4, 0], [0, 4]])
    hook = np.array([[0.0, 0], [4, 0], [4, 4], [1, 4], [1, -1], [0, -1]])
    square, hole = (np.array([[0.0, 0], [1, 0], [1, 1], [0, 1]]) * size for size in (9, 2))
    wrong = [
        [bow],
        [hook],
        [square, hole + 1, hole + 2],
        [square, hole + 8],
        [square, hole + 20],
        [square, bow * [1, 0.5] + 1, hook + 3],
        [square, bow + 2],
        [square, np.array([[3.0, 3], [8, 7], [8, 3], [3, 6]])],
        [square, hole + 1, bow + 4],
    ]
    for scale, place in itertools.product((1e-3, 1.0, 1e3), ([0.0, 0.0], [85e3, 447e3])):
        made = [[ring * scale + place for ring in polygon] for polygon in [*wrong, [square, hole + 1, hole + 4]]]
        points, rings, runs = packed(made)
        assert _core.triangulate_polygons(points, rings, runs)[2] == len(wrong)
        assert _core.polygon_prisms(points, rings, runs, np.zeros(len(made), bool))[2] == len(wrong)


@pytest.mark.parametrize("wrong", [np.nan, np.inf, -1e31])
def test_non_finite_coordinates_are_refused(wrong: float) -> None:
    points, rings, runs = packed([[np.array([[0.0, 0], [1, wrong], [1, 0]])]])
    with pytest.raises(ValueError, match="points: expected numbers up to 1e30"):
        _core.triangulate_polygons(points, rings, runs)


def test_inconsistent_offsets_are_refused() -> None:
    points = np.zeros((4, 2))
    for rings, runs in (([0, 5], [0, 1]), ([0, 4], [0, 2]), ([1, 4], [0, 1]), ([0, 3, 2, 4], [0, 3]), ([], [])):
        with pytest.raises(ValueError, match="expected numbers that ascend from 0"):
            _core.triangulate_polygons(points, np.array(rings, np.int64), np.array(runs, np.int64))


@given(st.lists(st.tuples(st.integers(-3, 3), st.integers(-3, 3)), min_size=3, max_size=30), st.integers(0, 30))
@settings(deadline=None)
def test_random_rings_are_triangulated(corners: list[tuple[int, int]], cut: int) -> None:
    points = np.array(corners, np.float64)
    rings = np.array([0, min(cut, len(points)), len(points)])
    faces, ends, _ = _core.triangulate_polygons(points, rings, np.array([0, 2]))
    assert ends[-1] == len(faces) <= 3 * len(points)
    assert (areas(points, faces) >= 0).all()


def test_surfaces_in_space_keep_their_area_and_their_side() -> None:
    random = np.random.default_rng(11)
    rows, sizes, counts = [], [], []
    for polygon in polygons(7, 200):
        turn, _ = np.linalg.qr(random.normal(size=(3, 3)))
        place = random.uniform(-1e6, 1e6, 3)
        for number, ring in enumerate(polygon):
            direction = 1 if (shoelace(ring) > 0) == (number == 0) else -1
            flat = (ring - polygon[0][0])[::direction]
            rows.append(np.c_[flat, np.zeros(len(flat))] @ turn.T + place)
            sizes.append(len(ring))
        counts.append(len(polygon))
    surfaces = Surfaces(np.concatenate(rows), offsets(sizes), offsets(counts))
    faces, ends, _ = surfaces.triangles()
    a, b, c = np.moveaxis(surfaces.local()[faces], 1, 0)
    halves = np.cross(b - a, c - a) / 2
    newell = np.add.reduceat(surfaces.area_vectors(), surfaces.surfaces[:-1])
    summed = np.add.reduceat(halves, ends[:-1])
    np.testing.assert_allclose(summed, newell, rtol=0, atol=1e-9 * np.abs(newell).max())


def wkb(polygon: Sequence[Ring]) -> bytes:
    data = struct.pack("<BII", 1, 3, len(polygon))
    for ring in polygon:
        closed = np.concatenate([ring, ring[:1]])
        data += struct.pack("<I", len(closed)) + closed.astype("<f8").tobytes()
    return data


def test_wkb_is_decoded() -> None:
    made = polygons(13, 40)
    rows = [wkb(polygon) for polygon in made]
    data = np.frombuffer(b"".join(rows), np.uint8)
    points, rings, runs, features, skipped = _core.read_wkb(data, offsets([len(row) for row in rows]))
    expected = packed(made)
    for found, wanted in zip((points, rings, runs), expected, strict=True):
        assert np.array_equal(found, wanted)
    assert np.array_equal(features, np.arange(41))
    assert skipped == 0


def test_errors_about_truncated_wkb_name_the_row() -> None:
    row = wkb(polygons(13, 1)[0])
    data = np.frombuffer(row + row[:-3], np.uint8)
    with pytest.raises(SceneError, match="row 1: it "):
        _core.read_wkb(data, np.array([0, len(row), len(data)]))


def test_prisms_are_closed_and_face_outwards() -> None:
    made = polygons(17, 50)
    points, rings, runs = packed(made)
    floors = np.ones(len(made), bool)
    faces, ends, crossing = _core.polygon_prisms(points, rings, runs, floors)
    assert crossing == 0
    for number, polygon in enumerate(made):
        first = points[rings[runs[number]]]
        corners = np.c_[np.tile(points - first, (2, 1)), np.repeat([0.0, 5.0], len(points))]
        a, b, c = np.moveaxis(corners[faces[ends[number] : ends[number + 1]]], 1, 0)
        volume = np.einsum("ij,ij->", a, np.cross(b, c)) / 6
        area = abs(shoelace(polygon[0])) - sum(abs(shoelace(hole)) for hole in polygon[1:])
        assert volume == pytest.approx(5 * area, rel=1e-9)
