"""Tests of prefetching: queues of cuts at positions ahead, and which cells may come into view."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from numpy.typing import NDArray

import nearfar as nf
from nearfar.orthoview._cut import GEOMETRY, Part
from nearfar.orthoview._prefetch import Frustums
from tests.support import cut_oracle
from tests.support.flight_cases import parts_of
from tests.support.orthoview_cases import CORNER

Tree = nf.orthoview.OrthoTree

MIDDLE = CORNER + 40.0
PLACES = {
    "inside": MIDDLE + np.array((1.3, -2.1, 7.7)),
    "beside": MIDDLE + np.array((61.3, 13.9, 40.2)),
    "far": MIDDLE + np.array((931.3, 99.0, 40.0)),
}
PAPER: dict[str, Any] = {"fov": nf.Fov.symmetric(60, 4 / 3), "size": (640, 480)}
SMALL: dict[str, Any] = {"fov": nf.Fov.symmetric(60, 4 / 3), "size": (48, 36)}
CAMERA = nf.Camera((0, 0, 0), **SMALL)


def distance_of(tree: Tree, part: Part, eye: NDArray[np.float64]) -> float:
    return float(cut_oracle.nearest(eye, *tree.box(*part[:2])))


@pytest.mark.parametrize("velocity", [None, (3.0, 0.5, -2.0)])
@pytest.mark.parametrize("name", PLACES)
def test_queues_contain_the_parts_of_cuts_here_and_ahead(tree: Tree, name: str, velocity: Any) -> None:
    eye = PLACES[name]
    found = tree.prefetch_queue(eye, camera=CAMERA, velocity=velocity)
    assert found.needed == parts_of(tree, nf.Camera(eye, **SMALL))
    assert found.unknown == []
    cuts = [parts_of(tree, nf.Camera(place, **SMALL)) for place in found.positions]
    both = [*found.needed, *found.soon]
    assert len(set(both)) == len(both) == len(found)
    assert set(both) == set(found.needed).union(*cuts)
    # Ordered by the first position that needs a part, then by distance, then by level.
    first = {part: next(n for n, cut in enumerate(cuts) if part in cut) for part in found.soon}
    order = [(first[part], distance_of(tree, part, eye), part[0]) for part in found.soon]
    # NumPy and Rust may round a distance differently, so parts at nearly equal distances may change places.
    for before, after in pairwise(order):
        assert before <= after or (before[0] == after[0] and before[1] == pytest.approx(after[1], rel=1e-12))
    assert found.soon or name == "far"
    cut = tree.cut(nf.Camera(eye, **SMALL), around=True)
    sides = [*(tree.cell * 2.0**level for level in cut.level), *(tree.cell for _ in cut.leaves)]
    assert found.ahead == min(sides)
    assert found.renewed_after == pytest.approx(0.1 * found.ahead)


def test_without_a_course_positions_lie_along_the_axes(tree: Tree) -> None:
    eye = PLACES["inside"]
    for velocity in (None, (0, 0, 0)):
        found = tree.prefetch_queue(eye, velocity=velocity)
        ways = (found.positions - eye) / found.ahead
        axes = [(-1, 0, 0), (1, 0, 0), (0, -1, 0), (0, 1, 0), (0, 0, -1), (0, 0, 1)]
        np.testing.assert_allclose(ways, axes, atol=1e-12)


@settings(max_examples=20)
@given(st.tuples(*[st.floats(-50, 50)] * 3).filter(lambda way: np.linalg.norm(way) > 0.1))
def test_positions_lie_along_the_course(tree: Tree, velocity: tuple[float, float, float]) -> None:
    """Half-way, all the way, and at 15 degrees to four perpendicular sides."""
    eye, course = PLACES["beside"], np.array(velocity) / np.linalg.norm(velocity)
    found = tree.prefetch_queue(eye, camera=CAMERA, velocity=velocity, error_px=8.0)
    ways = (found.positions - eye) / found.ahead
    np.testing.assert_allclose(ways[0], 0.5 * course, atol=1e-9)
    np.testing.assert_allclose(ways[1], course, atol=1e-9)
    assert ways.shape == (6, 3)
    np.testing.assert_allclose(np.linalg.norm(ways[2:], axis=1), 1)
    np.testing.assert_allclose(ways[2:] @ course, math.cos(math.radians(15)))
    across = ways[2:] - (ways[2:] @ course)[:, None] * course
    cosines = across @ across.T / math.sin(math.radians(15)) ** 2
    right = [[1, -1, 0, 0], [-1, 1, 0, 0], [0, 0, 1, -1], [0, 0, -1, 1]]
    np.testing.assert_allclose(cosines, right, atol=1e-9)


def test_the_cameras_resolution_and_field_of_view_matter(tree: Tree) -> None:
    """Its position does not matter."""
    eye = PLACES["far"]
    coarse = nf.Camera((1.0, 2.0, 3.0), fov=nf.Fov.symmetric(60), size=(64, 48))
    fine = nf.Camera((1.0, 2.0, 3.0), fov=nf.Fov.symmetric(60), size=(1280, 960))
    found = {width: tree.prefetch_queue(eye, camera=camera) for width, camera in ((64, coarse), (1280, fine))}
    for width, camera in ((64, coarse), (1280, fine)):
        at = nf.Camera(eye, fov=camera.fov, size=camera.size)
        assert found[width].needed == parts_of(tree, at)
    assert len(found[1280].needed) > 9 * len(found[64].needed)
    assert found[1280].ahead < found[64].ahead


def test_prefetch_settings_are_applied(tree: Tree) -> None:
    eye = PLACES["inside"]
    raised = {"views": 1, "geometry": False, "lift_deg": 40.0}
    each: list[dict[str, Any]] = [{}, {"views": 1}, {"error_px": 4.0}, {"geometry": False}, raised]
    for own in each:
        found = tree.prefetch_queue(eye, **own)
        assert found.needed == parts_of(tree, nf.Camera(eye, **PAPER), **own)
        cuts = [parts_of(tree, nf.Camera(place, **PAPER), **own) for place in found.positions]
        assert set(found.soon) == set().union(*cuts) - set(found.needed)
    assert set(found.needed) != set(tree.prefetch_queue(eye, views=1, geometry=False).needed)
    bare = tree.prefetch_queue(eye, geometry=False)
    assert all(part[2] != GEOMETRY for part in [*bare.needed, *bare.soon])
    assert any(part[2] == GEOMETRY for part in tree.prefetch_queue(eye).needed)


def test_an_empty_place_has_a_queue(tree: Tree) -> None:
    """From very far the whole world is one cell, whose side is the look-ahead."""
    found = tree.prefetch_queue(MIDDLE + 1e6)
    assert {part[:2] for part in found.needed} == {(tree.levels - 1, (0, 0, 0))}
    assert found.ahead == tree.cell * 2 ** (tree.levels - 1)
    assert found.soon == []


# Frustums.

unit = st.tuples(*[st.floats(-1, 1)] * 4).filter(lambda turn: np.linalg.norm(turn) > 0.1)
tangents = st.floats(0.1, 3.0)


def camera_of(turn: Any, left: float, right: float, down: float, up: float) -> nf.Camera:
    x, y, z, w = (np.array(turn) / np.linalg.norm(turn)).tolist()
    return nf.Camera((1.0, 2.0, 3.0), (x, y, z, w), fov=nf.Fov(-left, right, -down, up), size=(64, 64))


def angles_of(camera: nf.Camera, points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Angles to the right and upwards of the camera's axis (N, 2), −π to π."""
    x, y, z, w = camera.orientation
    offsets = points - np.array(camera.position)
    # v + 2 q × (q × v + w v), with the inverse quaternion.
    axis = -np.array([x, y, z])
    local = offsets + 2 * np.cross(axis, np.cross(axis, offsets) + w * offsets)
    angles: NDArray[np.float64] = np.arctan2(local[:, :2], -local[:, 2:])
    return angles


def sees(frustums: Frustums, corners: NDArray[np.float64], sides: NDArray[np.float64]) -> NDArray[np.bool_]:
    return frustums.overlap(np.array([1.0, 2.0, 3.0]), corners, sides)


@given(unit, tangents, tangents, tangents, tangents, st.floats(0, 1.5), st.integers(0, 2**32 - 1))
def test_cells_with_a_visible_point_are_visible(
    turn: Any, left: float, right: float, down: float, up: float, margin: float, seed: int
) -> None:
    """Points are visible within the picture's angles and a margin; cells beyond one side are invisible."""
    camera = camera_of(turn, left, right, down, up)
    rng = np.random.default_rng(seed)
    corners, sides = rng.uniform(-60, 60, (15, 3)), rng.uniform(1, 40, 15)
    seen = sees(Frustums([camera], margin), corners, sides)
    limits = np.array([[math.atan(left), math.atan(right)], [math.atan(down), math.atan(up)]]) + margin
    lattice = np.stack(np.meshgrid(*[np.linspace(0, 1, 6)] * 3), -1).reshape(-1, 3)
    ends = np.stack(np.meshgrid(*[[0.0, 1.0]] * 3), -1).reshape(-1, 3)
    for corner, side, is_seen in zip(corners, sides, seen, strict=True):
        angles = angles_of(camera, corner + side * lattice)
        shows = (angles >= -limits[:, 0] - 1e-9) & (angles <= limits[:, 1] - 1e-9)
        if shows.all(axis=1).any():
            assert is_seen
        outer = angles_of(camera, corner + side * ends)
        for axis in (0, 1):
            for end, sign in ((0, -1), (1, 1)):
                limit = limits[axis, end]
                beyond = sign * outer[:, axis] > limit + 1e-9
                # All corners lie beyond the plane of one side, none of them beyond its other half.
                if (
                    limit < math.pi / 2
                    and limits[axis].sum() < math.pi
                    and (beyond & (sign * outer[:, axis] < limit + math.pi)).all()
                ):
                    assert not is_seen


def test_frustums_in_all_directions_include_every_cell() -> None:
    camera = camera_of((0, 0, 0, 1), 1, 1, 1, 1)
    cube = nf.Camera((1.0, 2.0, 3.0), fov=nf.CubeFace(2), size=(8, 8))
    plan = nf.Camera((1.0, 2.0, 3.0), fov=nf.Orthographic(-1, 1, -1, 1), size=(8, 8))
    corners, sides = np.random.default_rng(0).uniform(-60, 60, (40, 3)), np.full(40, 2.0)
    assert not sees(Frustums([camera], 0.0), corners, sides).all()
    for frustums in (Frustums([camera], None), Frustums([camera, cube], 0.1), Frustums([plan], 0.1), Frustums([], 0.1)):
        assert sees(frustums, corners, sides).all()


def test_frustums_of_several_cameras_are_their_union() -> None:
    cameras = [camera_of((0, 1, 0, turn), 0.5, 0.5, 0.5, 0.5) for turn in (0.3, 1.0, 4.0)]
    corners, sides = np.random.default_rng(1).uniform(-60, 60, (200, 3)), np.full(200, 2.0)
    each = [sees(Frustums([camera], 0.1), corners, sides) for camera in cameras]
    np.testing.assert_array_equal(sees(Frustums(cameras, 0.1), corners, sides), np.any(each, axis=0))
    assert not np.array_equal(each[0], each[1])


@given(unit, st.tuples(*[st.floats(0.1, 1.2)] * 4), st.floats(-0.2, 0.2), st.sampled_from([0, 1]))
def test_rotated_pictures_stay_within_the_margin(turn: Any, sides: Any, angle: float, axis: int) -> None:
    """Rotates a camera sideways or upwards by at most the margin; fields of view are up to 100 degrees."""
    camera = camera_of(turn, *sides)
    local = np.zeros(4)
    local[1 - axis], local[3] = math.sin(angle / 2), math.cos(angle / 2)
    x, y, z, w = camera.orientation
    own = np.array([x, y, z])
    vector = w * local[:3] + local[3] * own + np.cross(own, local[:3])
    turned = camera_of((*vector, w * local[3] - own @ local[:3]), *sides)
    corners, small = np.random.default_rng(2).uniform(-60, 60, (300, 3)), np.full(300, 1e-9)
    now = sees(Frustums([turned], 0.0), corners, small)
    assert not (now & ~sees(Frustums([camera], abs(angle) * 1.5 + 1e-6), corners, small)).any()
