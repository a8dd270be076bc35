"""Pixels of views as Gaussians: centres, axes, sizes, colours, removal of duplicates, and SPZ files."""

from __future__ import annotations

import functools
import gzip
import math
import struct
from pathlib import Path

import numpy as np
import pytest
import trimesh
from numpy.typing import NDArray

import nearfar as nf
from nearfar._base.errors import UnusableError
from nearfar._scene.srgb import to_linear
from nearfar.orthoview import _spz
from nearfar.orthoview._gaussians import (
    NO_GAUSSIANS,
    NORMAL_FACTOR,
    SIGMA,
    SUN,
    Gaussians,
    Surfaces,
    gaussians_of,
    matrices,
    shade,
)
from nearfar.orthoview._splat_cells import Cells, Sun
from nearfar.orthoview._thinned import Picture
from tests.support import need
from tests.support.reader_cases import answer_of
from tests.support.splat_files import Rows, spz_rows, turn

EVERYWHERE = np.array([[-np.inf] * 3, [np.inf] * 3])


def cells_of(tree: nf.orthoview.OrthoTree, sun: Sun = None) -> Cells:
    return Cells(tree._files, tree._layout, tree.generation, EVERYWHERE, sun)


def pictures_of(tree: nf.orthoview.OrthoTree, level: int, place: tuple[int, int, int]) -> list[Picture]:
    cells = cells_of(tree)
    return cells._pictures(level, cells.chunks(level, place))


@functools.cache
def fullest(tree: nf.orthoview.OrthoTree, level: int, count: int) -> list[tuple[int, tuple[int, int, int]]]:
    """The cells with the most pixels."""
    cells = cells_of(tree)
    return sorted(cells.cells_of_level(level), key=lambda cell: -cells.read(*cell).pixels)[:count]


def covariances(gaussians: Gaussians) -> NDArray[np.float64]:
    axes = matrices(gaussians.rotation).astype(np.float64) * gaussians.scale[:, None, :]
    return axes @ axes.transpose(0, 2, 1)


def test_gaussians_equal_the_formulas_of_surfels_and_balls(few_tree: nf.orthoview.OrthoTree) -> None:
    level, place = fullest(few_tree, 1, 1)[0]
    checked = {"surfel": 0, "ball": 0}
    for number, direction in enumerate(few_tree.directions):
        view = few_tree.view(level, place, number)
        assert view is not None
        (picture,) = [own for own in pictures_of(few_tree, level, place) if np.allclose(own.axes[2], view.toward)]
        shown = picture.surfaces()
        got = gaussians_of(shown, picture.axes, picture.pitch, None)
        rows = np.isfinite(view.depth)
        assert np.allclose(got.middle, view.points()[rows] - view.center, atol=1e-4), direction
        assert (got.color == view.color[rows]).all()
        assert (shown.is_surfel == view.surfel[rows]).all()
        width, height = view.extents[:2] / few_tree.size
        normals = view.normal[rows].astype(np.float64)
        for covariance, scale, normal, is_surfel in list(
            zip(covariances(got), got.scale, normals, shown.is_surfel, strict=True)
        )[::3]:
            if not is_surfel:
                radius = np.hypot(width, height) / 2
                assert np.allclose(covariance, np.eye(3) * (SIGMA * radius / np.sqrt(0.5)) ** 2, rtol=1e-4)
                checked["ball"] += 1
                continue
            # u and v of docs/orthoview_view.md, in the axes of the world.
            n_x, n_y, n_z = normal @ view.right, normal @ view.up, max(normal @ view.toward, 0.25)
            u = width * (view.right - n_x / n_z * view.toward)
            v = height * (view.up - n_y / n_z * view.toward)
            wanted = SIGMA**2 * (np.outer(u, u) + np.outer(v, v))
            plane = np.cross(u, v) / np.linalg.norm(np.cross(u, v))
            wanted += (NORMAL_FACTOR * SIGMA * np.linalg.svd(np.array([u, v]))[1][1]) ** 2 * np.outer(plane, plane)
            assert np.allclose(covariance, wanted, atol=1e-4 * np.trace(wanted)), direction
            assert scale[2] < min(scale[:2])
            checked["surfel"] += 1
    assert min(checked.values()) > 20, checked


def test_the_third_axis_is_the_normal_and_w_is_the_largest_component() -> None:
    rng = np.random.default_rng(1)
    normal = rng.normal(size=(500, 3))
    normal[:, 2] = np.abs(normal[:, 2]) + 0.5  # No flatter than a surfel.
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    ones = np.ones(len(normal), bool)
    shown = Surfaces(np.zeros((500, 3), np.float32), normal.astype(np.float32), np.zeros((500, 3), np.uint8), ones)
    got = gaussians_of(shown, np.eye(3, dtype=np.float32), (0.5, 0.8), None)
    steep = normal[:, 2] >= 0.25
    along = np.abs((matrices(got.rotation)[:, :, 2] * normal).sum(axis=1))
    assert steep.sum() > 400
    assert np.allclose(along[steep], 1, atol=1e-5)
    assert np.allclose(np.linalg.norm(got.rotation, axis=1), 1, atol=1e-5)
    assert (got.rotation[:, 3:] >= np.abs(got.rotation[:, :3]) - 1e-6).all()
    assert np.allclose(np.linalg.det(matrices(got.rotation)), 1, atol=1e-5)


def test_gaussians_are_lit_like_pictures() -> None:
    ball = trimesh.creation.icosphere(subdivisions=3)
    ball.visual.vertex_colors = [180, 120, 60, 255]
    camera = nf.Camera.look_at((3, 2, 4), (0, 0, 0), fov=nf.Fov.symmetric(40, 1), size=(48, 48))
    frame = nf.render(nf.Scene.from_trimesh(ball), camera, channels=("color", "albedo", "shading_normal", "coverage"))
    shown = np.asarray(frame.coverage) == 1
    codes = np.rint(np.full((shown.sum(), 3), (180, 120, 60))).astype(np.uint8)
    assert np.allclose(np.asarray(frame.albedo)[shown], to_linear(codes / 255), atol=1e-3)
    got = shade(codes, np.asarray(frame.shading_normal)[shown].astype(np.float32), SUN)
    assert shown.sum() > 300
    assert np.abs(to_linear(got / 255) - np.asarray(frame.color)[shown]).max() < 0.006  # Half a code of white.
    assert shade(codes, np.zeros((len(codes), 3), np.float32), None) is codes


def test_the_direction_of_the_sun_is_applied() -> None:
    white, normal = np.full((2, 3), 255, np.uint8), np.array([[1, 0, 0], [-1, 0, 0]], np.float32)
    from_right, from_left = (to_linear(shade(white, normal, (x, 0.0, 0.0)) / 255) for x in (1.0, -1.0))
    # The sun of (0.60, 0.56, 0.50) lights one of two sides, the sky both.
    assert np.allclose(from_right[0] - from_left[0], (0.60, 0.56, 0.50), atol=0.01)
    assert np.allclose(from_left[1] - from_right[1], (0.60, 0.56, 0.50), atol=0.01)


def plate_tree(folder: Path, directions: int, thickness: float = 0.0) -> nf.orthoview.OrthoTree:
    """A level plate in a cell of 16 m, seen at 16² pixels."""
    need("zarr")
    low, high = np.array([0.0, 4.0, 0.0]), np.array([16.0, 4.0 + max(thickness, 1e-3), 16.0])
    plate = trimesh.creation.box(bounds=[low, high])
    aabb = [(0.0, 0.0, 0.0), (16.0, 16.0, 16.0)]
    scene = nf.Scene.from_trimesh(plate)
    return nf.orthoview.build(scene, folder / "plate.zarr", cell=16.0, aabb=aabb, size=16, directions=directions)


def test_the_top_of_a_plate_is_written_once(tmp_path: Path) -> None:
    tree = plate_tree(tmp_path, 9)
    cell = cells_of(tree).read(0, (0, 0, 0))
    up = matrices(cell.gaussians.rotation)[:, 1, 2]
    top = np.abs(up) > 0.9
    # Seen from above it has 16² pixels; those at the corners are balls. The views between sides and top show
    # it, too, with coarser pixels; at rims a few of these count.
    assert cell.pixels > 2 * 256
    assert 252 <= top.sum() <= 272


def test_a_thin_plate_has_no_lower_side_and_a_thick_one_has(tmp_path: Path) -> None:
    counts = {}
    for thickness in (0.0, 3.0):
        (tmp_path / str(thickness)).mkdir()
        tree = plate_tree(tmp_path / str(thickness), 26, thickness)
        cells = cells_of(tree, (0.0, 1.0, 0.0))  # Light from above distinguishes the sides.
        gaussians = cells.read(0, (0, 0, 0)).gaussians
        level = np.abs(matrices(gaussians.rotation)[:, 1, 2]) > 0.9
        bright = gaussians.color[level][:, 0].astype(int)
        middle = (bright.max() + bright.min()) / 2
        counts[thickness] = (int((bright > middle).sum()), int((bright <= middle).sum()))
    assert counts[3.0][0] >= 252
    assert counts[3.0][1] >= 252
    assert counts[0.0][0] + counts[0.0][1] <= 256 + 2 * 16  # One side, and rims.


def test_each_removed_pixel_lies_beside_a_kept_one(few_tree: nf.orthoview.OrthoTree) -> None:
    left_out = 0
    for level, place in fullest(few_tree, 2, 3):
        pictures = pictures_of(few_tree, level, place)
        kept = cells_of(few_tree).read(level, place).gaussians
        for picture in pictures:
            shown = picture.surfaces()
            apart = np.linalg.norm(shown.middle[:, None] - kept.middle[None], axis=2).min(axis=1)
            # In another view's grid the nearest pixel is half a diagonal away at most; pixels lean by 75° at most.
            pixel = max(max(own.pitch) for own in pictures)
            assert apart.max() < 2 * pixel, (place, apart.max() / pixel)
            left_out += int((apart > 1e-6).sum())
    assert left_out > 50


def test_a_box_keeps_centres_within_it(few_tree: nf.orthoview.OrthoTree) -> None:
    ((level, place),) = fullest(few_tree, 1, 1)
    low, high = few_tree.box(level, place)
    box = np.array([low, [*((low + high) / 2)[:2], high[2]]])
    cells = Cells(few_tree._files, few_tree._layout, few_tree.generation, box, None)
    got, whole = (own.read(level, place) for own in (cells, cells_of(few_tree)))
    middles = got.gaussians.middle + got.center
    assert 0 < len(got.gaussians) < len(whole.gaussians)
    assert ((box[0] - 1e-4 <= middles) & (middles <= box[1] + 1e-4)).all()
    outside = next(cell for cell in cells_of(few_tree).cells_of_level(level) if cell[1][0] > place[0] + 1)
    assert cells_of(few_tree).direction_mask(*outside) != 0
    assert cells.direction_mask(*outside) == 0


# SPZ files against a reader written from the format's description -----------------------------------------------------
def some(count: int, reach: float = 60.0) -> Gaussians:
    """Random Gaussians whose quaternions have w as the largest component."""
    rng = np.random.default_rng(7)
    rotation = rng.normal(size=(count, 4))
    rotation /= np.linalg.norm(rotation, axis=1, keepdims=True)
    at = np.abs(rotation).argmax(axis=1)
    rotation[np.arange(count), at], rotation[:, 3] = rotation[:, 3], rotation[np.arange(count), at]
    rotation *= np.sign(rotation[:, 3:])
    return Gaussians(
        rng.uniform(-reach, reach, (count, 3)).astype(np.float32),
        rotation.astype(np.float32),
        np.exp(rng.uniform(-5, 3, (count, 3))).astype(np.float32),
        rng.integers(0, 256, (count, 3), dtype=np.uint8),
    )


def check(got: Rows, right: Gaussians, bits: int, degrees: float) -> None:
    """Check numbers within half a step, and rotations within some degrees."""
    # Positions are float32 before they are rounded.
    assert np.abs(got.middle - right.middle).max() <= 2.0**-bits / 2 + 1e-6 * np.abs(right.middle).max()
    assert np.abs(np.log(got.scale / right.scale)).max() <= 1 / 32 + 1e-6
    assert np.abs(got.color - right.color / 255).max() <= 0.5 / 255 * 0.282095 / 0.15 + 1e-9
    assert (got.opacity == 1).all()
    for quaternion, matrix in zip(got.rotation, matrices(right.rotation), strict=True):
        cosine = (np.trace(turn(quaternion).T @ matrix) - 1) / 2
        assert math.degrees(math.acos(min(cosine, 1))) <= degrees


# A component of version 2 is off by 1/255 at most and w by as much for each of the others, each at most as great as w:
# 2 asin of the length of all four, √(3 + 3²)/255, is 1.6°. A step of version 3 is √½/511.
@pytest.mark.parametrize(("version", "degrees"), [(2, 1.6), (3, 0.3)])
def test_values_are_restored_within_half_a_step(version: int, degrees: float) -> None:
    gaussians = some(400)
    data = _spz.encode(gaussians, version=version)
    bits = gzip.decompress(data)[13]
    assert 10 <= bits <= 17  # A reach of 60 m needs 6 of 23 bits.
    check(spz_rows(data, version), gaussians, bits, degrees)


def test_a_file_consists_of_header_and_sections() -> None:
    data = _spz.encode(some(3))
    content = gzip.decompress(data)
    assert struct.unpack_from("<III", content) == (0x5053474E, 3, 3)
    assert len(content) == 16 + 3 * (9 + 1 + 3 + 3 + 4)
    assert data[4:8] == bytes(4)  # No time stamp, so that the same splats give the same bytes.
    assert data == _spz.encode(some(3))


def test_fraction_bits_cover_the_reach_and_are_as_few_as_needed() -> None:
    for reach in (0.5, 60.0, 20_000.0, 8e6):
        bits = _spz.fraction_bits(reach, 0.01)
        assert reach * 2**bits <= 2**23 - 1
        assert reach * 2 ** (bits + 1) > 2**23 - 1 or 2**bits >= 32 / 0.01
    assert _spz.fraction_bits(10.0, 1.0) == 5
    with pytest.raises(UnusableError, match="do not fit"):
        _spz.fraction_bits(2e7, 1.0)


def test_a_file_may_be_empty() -> None:
    for version in (2, 3):
        assert len(spz_rows(_spz.encode(NO_GAUSSIANS, version=version), version).middle) == 0


@pytest.mark.slow
def test_the_reference_implementation_agrees(tmp_path: Path) -> None:
    need("browser")
    gaussians = some(200)
    versions = (2, 3)
    for version in versions:
        (tmp_path / f"{version}.spz").write_bytes(_spz.encode(gaussians, version=version))
    (tmp_path / "profile").mkdir()
    job = {"files": [f"/bundles/a/{version}.spz" for version in versions]}
    answer = answer_of("spz.mjs", job, tmp_path / "profile", {"a": tmp_path})
    for version, own in zip(versions, answer["files"], strict=True):
        right = spz_rows((tmp_path / f"{version}.spz").read_bytes(), version)
        assert (own["count"], own["degree"]) == (200, 0)
        assert np.allclose(np.reshape(own["positions"], (-1, 3)), right.middle, atol=1e-5)
        assert np.allclose(np.reshape(own["scales"], (-1, 3)), right.scale, rtol=1e-5)
        assert np.allclose(np.reshape(own["rotations"], (-1, 4)), right.rotation, atol=1e-5)
        # It returns colours in 0..1, computed with three digits of the spherical harmonic.
        assert np.allclose(np.reshape(own["colors"], (-1, 3)), right.color, atol=5e-4)
        assert own["alphas"] == [1] * 200
