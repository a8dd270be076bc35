"""Tests of the views of leaves and parents, and of connected pixels, against pixel-by-pixel definitions."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
import trimesh
from numpy.typing import NDArray
from PIL import Image

import nearfar as nf
from nearfar import _core
from tests.support import data, orthoview_oracle as oracle, splat_oracle
from tests.support.orthoview_cases import CORNER, FORMAT, SIDE, SIZE, STEPS, boxes, check_alike, leaf, picture
from tests.support.orthoview_oracle import DIRECTIONS, OCTANTS, Axes, Picture, Triple


@pytest.mark.parametrize("way", ["rays", "triangles"])
@pytest.mark.parametrize("direction", DIRECTIONS)
def test_a_leaf_view_equals_rays_within_its_cell(direction: Triple, way: str) -> None:
    scene, colors = boxes()
    got = picture(leaf(scene, directions=[direction], way=way), 0)
    double = oracle.draw_view(scene, colors, CORNER, SIDE, direction, 2 * SIZE, STEPS)
    extents = Axes.from_direction(direction).extents * SIDE
    reach = oracle.REACH_PIXELS * max(extents[:2]) / (2 * SIZE) / (extents[2] / STEPS)
    right = oracle.reduced(double, reach)
    assert np.isfinite(right.depth).mean() > 0.3
    check_alike(got, right, share=0.005)


def fence() -> nf.Scene:
    """Crossed quads whose texture has round holes."""
    rows, columns = np.indices((64, 64)) % 16 - 7.5
    texels = np.full((64, 64, 4), 255, np.uint8)
    texels[..., 0] = np.arange(64) * 4
    texels[..., 3] = np.where(np.hypot(rows, columns) < 5, 0, 255)
    material = trimesh.visual.material.PBRMaterial(
        baseColorTexture=Image.fromarray(texels), alphaMode="MASK", alphaCutoff=0.5
    )
    corners = np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], float)
    quads = []
    for angle in (0.0, 1.0, 2.0):
        visual = trimesh.visual.TextureVisuals(uv=(corners[:, :2] + 1) / 2, material=material)
        quad = trimesh.Trimesh(corners, [[0, 1, 2], [0, 2, 3]], visual=visual, process=False)
        quads.append(quad.apply_transform(trimesh.transformations.rotation_matrix(angle, (0.2, 1, 0.1))))
    return nf.Scene.from_trimesh(trimesh.Scene(quads))


SCENES: dict[str, tuple[Callable[[], nf.Scene], float]] = {
    "fence": (fence, 1.5),
    "forest": (lambda: nf.datasets.forest(), 60.0),
    "city": (lambda: nf.datasets.city(blocks=3), 60.0),
    "Duck": (lambda: nf.Scene.load(data("objects/gltf/Duck.glb")), 1.0),
    "tokyo": (lambda: nf.Scene.load(data("city/tokyo23/tokyo_core_lod1.glb")), 500.0),
}

STRESS = {"forest": pytest.mark.stress}


@pytest.mark.slow
@pytest.mark.parametrize("name", [pytest.param(name, marks=STRESS.get(name, ())) for name in SCENES])
def test_both_renderers_agree_on_textures_instances_and_holes(name: str) -> None:
    """Exceptions are rays through edges, and coincident surfaces, whose order depends on rounding."""
    make, side = SCENES[name]
    scene, most = make(), 0.003
    corner = scene.bounds.mean(axis=0) - side / 2
    corner[1] = scene.bounds[0, 1] - 0.1
    by_rays, by_triangles = (leaf(scene, corner, side, way=way, behind=True) for way in ("rays", "triangles"))
    for one, other in ((by_rays, by_triangles), (by_rays.second_layer(), by_triangles.second_layer())):
        assert one is not None
        assert other is not None
        there = one.depths() > 0
        assert there.mean() > 0.01
        apart = there != (other.depths() > 0)
        steps = np.abs(one.depths().astype(int) - other.depths())[there & ~apart]
        colors = np.abs(one.colors().astype(int) - other.colors())[(there & ~apart)[..., 0]].max(axis=1)
        assert apart.sum() <= most * there.sum()
        assert (steps > 1).mean() <= most
        assert (colors > 2).mean() <= most


@pytest.mark.parametrize("direction", DIRECTIONS)
def test_a_parents_pixels_equal_those_of_its_children(direction: Triple) -> None:
    """Each pixel of a child is a pixel of the parent's picture at twice the size, at the same position in space."""
    scene, _ = boxes(side=2 * SIDE)
    axes = Axes.from_direction(direction)
    parent = _core.OrthoParent([direction], FORMAT)
    extents = axes.extents * 2 * SIDE
    front = oracle.pixel_points(CORNER, 2 * SIDE, direction, 2 * SIZE)
    least = np.full((2 * SIZE, 2 * SIZE), np.inf)
    color, normal = np.zeros((2 * SIZE, 2 * SIZE, 3)), np.zeros((2 * SIZE, 2 * SIZE, 3))
    for octant in OCTANTS:
        corner = CORNER + np.array(octant) * SIDE
        views = leaf(scene, corner, directions=[direction])
        parent.add(octant, views)
        child, own = picture(views, 0), oracle.pixel_points(corner, SIDE, direction, SIZE)
        # The position of each pixel in space, not from the core's integers.
        offset = own - front[0, 0]
        column = offset @ axes.right / (extents[0] / (2 * SIZE))
        row = -(offset @ axes.up) / (extents[1] / (2 * SIZE))
        before = -(offset @ axes.toward) / (extents[2] / (2 * STEPS))
        for values in (column, row, before):
            np.testing.assert_allclose(values, np.rint(values), atol=1e-9)
        places = (np.rint(row).astype(int), np.rint(column).astype(int))
        assert len(np.unique(np.ravel_multi_index(places, least.shape))) == SIZE * SIZE
        depth = child.depth + np.rint(before)
        is_first = depth < least[places]
        chosen = tuple(place[is_first] for place in places)
        least[chosen], color[chosen], normal[chosen] = depth[is_first], child.color[is_first], child.normal[is_first]
    reach = oracle.REACH_PIXELS * max(extents[:2]) / (2 * SIZE) / (extents[2] / (2 * STEPS))
    right = oracle.reduced(Picture(least, color, normal), reach)
    got = picture(parent.finish(), 0)
    # Depths are integers, so nothing is at a border.
    np.testing.assert_array_equal(got.depth, np.floor(right.depth / 2))
    is_there = np.isfinite(got.depth)
    assert is_there.mean() > 0.2
    assert np.abs(got.color - right.color)[is_there].max() < 0.006
    assert (got.normal * right.normal).sum(axis=2)[is_there].min() > np.cos(np.radians(0.1))


@pytest.mark.parametrize("direction", [(0, 1, 1), (-1, 1, -1)])
def test_depths_three_levels_up_equal_those_of_all_leaf_pixels(direction: Triple) -> None:
    """A depth step contains the step of the first surface on each level, so errors do not accumulate."""
    scene, _ = boxes(200, 8 * SIDE)
    axes = Axes.from_direction(direction)
    size, root = 8 * SIZE, 8 * SIDE
    extents = axes.extents * root
    front = oracle.pixel_points(CORNER, root, direction, size)[0, 0]
    least = np.full((size, size), np.inf)

    def build(corner: NDArray[np.float64], side: float) -> _core.OrthoViews:
        if side == SIDE:
            views = leaf(scene, corner, directions=[direction])
            offset = oracle.pixel_points(corner, SIDE, direction, SIZE) - front
            column = np.rint(offset @ axes.right / (extents[0] / size)).astype(int)
            row = np.rint(-(offset @ axes.up) / (extents[1] / size)).astype(int)
            before = np.rint(-(offset @ axes.toward) / (extents[2] / (8 * STEPS)))
            np.minimum.at(least, (row, column), picture(views, 0).depth + before)
            return views
        parent = _core.OrthoParent([direction], FORMAT)
        for octant in OCTANTS:
            parent.add(octant, build(corner + np.array(octant) * side / 2, side / 2))
        return parent.finish()

    got = picture(build(CORNER, root), 0)
    blocks = least.reshape(SIZE, 8, SIZE, 8).min(axis=(1, 3))
    np.testing.assert_array_equal(got.depth, np.floor(blocks / 8))


def test_views_are_restored_from_arrays_and_invalid_ones_are_refused() -> None:
    scene, _ = boxes()
    views = leaf(scene)
    arrays: list[Any] = [views.colors(), views.depths(), views.normals()]
    again = _core.OrthoViews.from_arrays(DIRECTIONS, FORMAT, *arrays)
    for one, other in zip(arrays, (again.colors(), again.depths(), again.normals()), strict=True):
        np.testing.assert_array_equal(one, other)
    assert views.steps == STEPS
    deep = arrays[1].copy()
    deep[3, 4, 5] = STEPS + 1
    with pytest.raises(ValueError, match="depths and normals with the bits of their format"):
        _core.OrthoViews.from_arrays(DIRECTIONS, FORMAT, arrays[0], deep, arrays[2])
    with pytest.raises(ValueError, match=r"colors: expected shape \[25, 32, 32, 3\]"):
        _core.OrthoViews.from_arrays(DIRECTIONS[1:], FORMAT, *arrays)
    with pytest.raises(ValueError, match="directions and the format of its parent"):
        _core.OrthoParent(DIRECTIONS[1:], FORMAT).add((0, 0, 0), views)
    with pytest.raises(ValueError, match="0 or 1 along each axis"):
        _core.OrthoParent(DIRECTIONS, FORMAT).add((0, 2, 0), views)


def test_cells_without_surfaces_are_empty() -> None:
    scene, _ = boxes()
    assert all(leaf(scene, CORNER + 500).empty())
    assert not any(leaf(scene).empty())
    parent = _core.OrthoParent(DIRECTIONS, FORMAT)
    assert all(parent.finish().empty())


@pytest.mark.parametrize(
    ("numbers", "named"), [((30, 12, 16), "size"), ((0, 12, 16), "size"), ((32, 7, 16), "depth_bits"),
                          ((32, 17, 16), "depth_bits"), ((32, 12, 20), "normal_bits")]
)  # fmt: skip
def test_formats_are_checked(numbers: Any, named: str) -> None:
    with pytest.raises(ValueError, match=named):
        _core.OrthoParent(DIRECTIONS, numbers)


# Connected pixels and surfels -----------------------------------------------------------------------------------------
BOUNDS = (4.0, 0.5, 0.7)
TOWARD: list[Triple] = [(0, 0, 1), (0, 1, 1), (1, 1, -1)]


@pytest.mark.parametrize("direction", TOWARD)
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
    surfels = splat_oracle.neighbours(got) > 4
    np.testing.assert_array_equal(_core.orthoview_surfels(got[None, ..., None])[0, ..., 0], surfels)


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


@pytest.mark.parametrize("direction", TOWARD)
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
