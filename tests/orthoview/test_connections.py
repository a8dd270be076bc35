"""Tests of connected pixels and surfels, against all pairs and on shapes with known results."""

from __future__ import annotations

import numpy as np
import pytest
import trimesh
from numpy.typing import NDArray

import nearfar as nf
from nearfar import _core
from tests.support import orthoview_oracle as oracle
from tests.support.orthoview_cases import CORNER, SIDE, SIZE, STEPS, boxes, leaf
from tests.support.orthoview_oracle import Triple

BOUNDS = (4.0, 0.5, 0.7)
DIRECTIONS: list[Triple] = [(0, 0, 1), (0, 1, 1), (1, 1, -1)]


@pytest.mark.parametrize("direction", DIRECTIONS)
@pytest.mark.parametrize("bounds", [BOUNDS, (1.0, 0.2, 0.95), (20.0, 0.9, -0.5)])
def test_connections_equal_all_pairs_and_stay_within_blocks(
    direction: Triple, bounds: tuple[float, float, float]
) -> None:
    scene, _ = boxes()
    views = leaf(scene, directions=[direction])
    got = views.connected(bounds)[0, ..., 0]
    right = oracle.connected(
        views.depths()[0, ..., 0], oracle.decoded(views.normals()[0], 12), direction, STEPS, bounds
    )
    # A cosine at a bound falls on either side in float32.
    assert (got != right).mean() < 0.002
    assert 0 < (got > 0).mean() < 1
    np.testing.assert_array_equal(_core.orthoview_surfels(got[None, ..., None])[0, ..., 0], surfels(got))


def surfels(bits: NDArray[np.uint8]) -> NDArray[np.bool_]:
    """Pixels with more than four connected neighbours, computed one by one."""
    count = np.zeros(bits.shape, int)
    for bit, (rows, columns) in enumerate([(0, 1), (1, 0), (1, 1), (1, -1)]):
        for row, column in np.argwhere(bits >> bit & 1):
            count[row, column] += 1
            count[row + rows, column + columns] += 1
    return count > 4


def of_mesh(mesh: trimesh.Trimesh, direction: Triple) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Masks of pixels that show a surface, and of surfels."""
    scene = nf.Scene.from_trimesh(mesh.apply_translation(CORNER + SIDE / 2))
    views = leaf(scene, directions=[direction])
    bits = views.connected(BOUNDS)
    return views.depths()[0, ..., 0] > 0, _core.orthoview_surfels(bits)[0, ..., 0]


def inner(mask: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Pixels whose neighbours are all in the mask."""
    shifted = [np.roll(mask, (row, column), (0, 1)) for row in (-1, 0, 1) for column in (-1, 0, 1)]
    inside: NDArray[np.bool_] = np.logical_and.reduce(shifted)
    inside[[0, -1]] = inside[:, [0, -1]] = False
    return inside


@pytest.mark.parametrize("direction", DIRECTIONS)
def test_a_sphere_consists_of_surfels_except_at_steep_pixels(direction: Triple) -> None:
    shown, surfel = of_mesh(trimesh.creation.icosphere(5, 0.45 * SIDE), direction)
    rows, columns = np.indices(shown.shape) + 0.5 - SIZE / 2
    extents = oracle.Axes.from_direction(direction).extents
    slope = np.hypot(rows * extents[1], columns * extents[0]) / SIZE / 0.45
    assert surfel[inner(shown) & (slope < np.sin(np.radians(60)))].all()
    assert not surfel[~shown].any()


def test_planes_are_surfels_at_steep_angles() -> None:
    for angle in (0, 30, 60):
        plane = trimesh.creation.box((4 * SIDE, 4 * SIDE, 0.01 * SIDE))
        plane.apply_transform(trimesh.transformations.rotation_matrix(np.radians(angle), (0, 1, 0)))
        shown, surfel = of_mesh(plane, (0, 0, 1))
        assert surfel[inner(shown)].mean() > 0.99, angle


def test_pixels_across_a_step_are_not_connected() -> None:
    near, far = (trimesh.creation.box((SIDE, SIDE, 0.1)) for _ in range(2))
    near.apply_translation((SIDE / 2, 0, 0.4 * SIDE))
    views = leaf(
        nf.Scene.from_trimesh(trimesh.util.concatenate([near, far]).apply_translation(CORNER + SIDE / 2)),
        directions=[(0, 0, 1)],
    )
    bits = views.connected(BOUNDS)[0, ..., 0]
    middle = SIZE // 2 - 1
    assert not (bits[:, middle] & 0b0101).any()
    assert (bits[:-1, [middle - 1, middle + 1]] & 0b0111 == 0b0111).all()


def test_thin_wires_are_balls() -> None:
    wire = trimesh.creation.cylinder(0.01 * SIDE, 0.9 * SIDE)
    shown, surfel = of_mesh(wire, (1, 0, 0))
    assert shown.any()
    assert not surfel.any()


def test_bits_beyond_the_border_of_a_picture_are_ignored() -> None:
    """Damaged stores may contain them."""
    found = _core.orthoview_surfels(np.full((2, 4, 4, 1), 15, np.uint8))
    assert found[:, 1:3, 1:3].all()
    assert not found[:, [0, 0, 3, 3], [0, 3, 0, 3]].any()
    with pytest.raises(ValueError, match="views of"):
        _core.orthoview_surfels(np.zeros((1, 3, 4, 1), np.uint8))
