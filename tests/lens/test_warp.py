"""Tests of warped pictures against plain loops and other libraries, and of meshes against the exact map."""

from __future__ import annotations

import math
from typing import Any

import cv2
import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from numpy.typing import NDArray
from scipy.ndimage import map_coordinates

import nearfar as nf

Array = NDArray[Any]

RIFT_S = nf.RadialLens((0.22, 0.24))
EYE = nf.Fov(-1.28, 1.0, -1.19, 1.11)
"""An asymmetric field of view, typical of headsets."""


def smooth(width: int, height: int) -> Array:
    """A smooth picture."""
    x, y = np.meshgrid(np.linspace(0, 3, width), np.linspace(0, 2, height))
    return np.asarray(128 + 60 * np.sin(2.1 * x + y) + 50 * np.cos(1.7 * y - x))


def sources(lens: nf.RadialLens, inverse: bool, fov: nf.Fov, output: nf.Fov, size: tuple[int, int]) -> Array:
    """Return the source position of each pixel, as shares of the picture from its top left corner."""
    width, height = size
    omega = max(abs(fov.left), abs(fov.right))
    x = output.left + (np.arange(width) + 0.5) / width * (output.right - output.left)
    y = output.up - (np.arange(height) + 0.5) / height * (output.up - output.down)
    places = np.stack(np.meshgrid(x, y), axis=-1).reshape(-1, 2) / omega
    # The point at r is shown at f(r), so a pixel of the distorted picture comes from f⁻¹ of its position.
    map_ = lens.distort_points if inverse else lens.undistort_points
    found = map_(places, outside="nan") * omega
    across, down = (found[:, 0] - fov.left) / (fov.right - fov.left), (fov.up - found[:, 1]) / (fov.up - fov.down)
    return np.stack([across, down], axis=-1).reshape(height, width, 2)


def keys(t: float) -> float:
    """Evaluate Keys' kernel with a = −1/2."""
    t = abs(t)
    if t < 1:
        return 1.5 * t**3 - 2.5 * t**2 + 1
    return -0.5 * t**3 + 2.5 * t**2 - 4 * t + 2 if t < 2 else 0.0


def looked_up(image: Array, across: float, down: float, reach: int, kernel: Any) -> float:
    """Interpolate one value by the definition."""
    height, width = image.shape
    x, y = across * width - 0.5, down * height - 0.5
    total = 0.0
    for j in range(math.floor(y) - reach + 1, math.floor(y) + reach + 1):
        for i in range(math.floor(x) - reach + 1, math.floor(x) + reach + 1):
            weight = kernel(x - i) * kernel(y - j)
            total += weight * image[min(max(j, 0), height - 1), min(max(i, 0), width - 1)]
    return total


@pytest.mark.parametrize("inverse", [False, True])
@pytest.mark.parametrize(("name", "reach", "kernel"), [("linear", 1, lambda t: max(0, 1 - abs(t))), ("cubic", 2, keys)])
@pytest.mark.parametrize("lens", [RIFT_S, nf.RadialLens((-0.2,)), nf.RadialLens((0.1,), (0.02, -0.01))])
def test_pixels_equal_the_definition(lens: nf.RadialLens, name: Any, reach: int, kernel: Any, inverse: bool) -> None:
    image = np.random.default_rng(0).random((23, 31))
    output, size = nf.Fov(-1.0, 1.2, -0.8, 0.9), (19, 17)
    shown = lens.warp(image, inverse, fov=EYE, output_fov=output, size=size, filter=name, fill=-7.0)
    assert shown.shape == (17, 19)
    beside = 0
    for (across, down), value in zip(
        sources(lens, inverse, EYE, output, size).reshape(-1, 2), shown.reshape(-1), strict=True
    ):
        if 0 <= across <= 1 and 0 <= down <= 1:
            # "lut" inside: 5e-10 of a place, times 31 pixels and slopes up to 2.
            assert value == pytest.approx(looked_up(image, across, down, reach, kernel), abs=1e-7)
        else:
            beside += 1
            assert value == -7.0
    assert beside < shown.size
    # Barrel distortion shows nothing from outside the picture; the other lenses do.
    assert beside > 0 or not (inverse and lens.k[0] > 0)


def test_the_identity_lens_changes_nothing() -> None:
    for dtype in (np.uint8, np.uint16, np.float32, np.float64):
        image = (np.random.default_rng(1).random((40, 30, 4)) * 200).astype(dtype)
        for name in ("linear", "cubic"):
            # Positions are exact to 1e-15 of the picture, values of 200 to 1e-12 before rounding.
            shown = nf.RadialLens(()).warp(image, fov="symmetric", filter=name)
            assert shown.dtype == dtype
            assert np.abs(shown.astype(float) - image).max() <= (0 if dtype in (np.uint8, np.uint16) else 1e-4)


@pytest.mark.parametrize(("name", "order", "theirs"), [("linear", 1, cv2.INTER_LINEAR), ("cubic", 3, None)])
def test_warps_agree_with_other_libraries(name: Any, order: int, theirs: int | None) -> None:
    image = smooth(160, 120)
    fov = nf.Fov(-1.0, 1.0, -0.75, 0.75)
    places = sources(RIFT_S, True, fov, fov, (160, 120)) * (160, 120) - 0.5
    shown = RIFT_S.warp(image, True, fov=fov, filter=name, fill=np.nan)
    inside = np.isfinite(shown)
    inside &= ((places > 3) & (places < np.array([156, 116]))).all(axis=-1)
    assert inside.mean() > 0.2
    scipys = map_coordinates(image, [places[..., 1], places[..., 0]], order=order)
    # Splines and Catmull–Rom cubics are both of the third order on smooth pictures; pixels are 4 levels apart.
    assert np.abs(shown - scipys)[inside].max() < (1e-6 if order == 1 else 0.02)
    if theirs is not None:
        maps = places.astype(np.float32)
        opencvs = cv2.remap(image.astype(np.float32), maps[..., 0], maps[..., 1], theirs)
        # OpenCV rounds places to 1/32 pixel; a pixel is up to 4 levels from the next.
        assert np.abs(shown - opencvs)[inside].max() < 4 / 32


def test_the_lens_undoes_the_warp() -> None:
    image = smooth(400, 400)
    warped = RIFT_S.warp(image, True, fov="symmetric", filter="cubic")
    back = RIFT_S.warp(warped, fov="symmetric", filter="cubic", fill=np.nan)
    # The warped picture does not shrink near the middle; parts moved outside it cannot come back.
    x, y = np.meshgrid(np.linspace(-1, 1, 400), np.linspace(-1, 1, 400))
    near = np.hypot(x, y) < 0.6
    assert np.abs(back - image)[near].max() < 0.05


def test_the_picture_is_magnified_by_the_lens() -> None:
    image = np.zeros((201, 201))
    # A pixel at r = 0.5 to the right is shown at f(0.5) = 0.535.
    image[100, 150] = 1.0
    shown = RIFT_S.warp(image, fov="symmetric")
    row, column = np.unravel_index(shown.argmax(), shown.shape)
    assert row == 100
    assert (column + 0.5) / 201 * 2 - 1 == pytest.approx(float(RIFT_S.distort((150.5) / 201 * 2 - 1)), abs=0.01)


def test_each_colour_channel_may_have_its_lens() -> None:
    image = np.random.default_rng(2).random((60, 50, 3))
    lenses = [nf.RadialLens((c,)) for c in (0.1, 0.2, 0.3)]
    both = nf.ChromaticLens(*lenses)
    shown = both.warp(image, True, fov="symmetric", filter="cubic")
    for channel, lens in enumerate(lenses):
        assert np.array_equal(
            shown[..., channel], lens.warp(image[..., channel], True, fov="symmetric", filter="cubic")
        )
    with pytest.raises(ValueError, match=r"image: expected shape \(H, W, 3\), a channel"):
        both.warp(image[..., :2])
    mesh = both.warp_mesh((500, 500), fov="symmetric")
    assert mesh.texcoords.shape[0] == 3
    assert mesh.error_px <= 0.25
    single = lenses[1].warp_mesh((500, 500), fov="symmetric", cells=(8, 8))
    assert np.array_equal(both.warp_mesh((500, 500), fov="symmetric", cells=(8, 8)).texcoords[1], single.texcoords[0])


def through(mesh: nf.WarpMesh, lens: int, random: np.random.Generator, count: int) -> tuple[Array, Array]:
    """Return random positions within faces, in clip coordinates, and the texture coordinates shown there."""
    faces = mesh.faces[random.integers(0, len(mesh.faces), count)]
    weights = random.dirichlet([1.0, 1.0, 1.0], count)[..., None]
    return (mesh.positions[faces] * weights).sum(axis=1), (mesh.texcoords[lens][faces] * weights).sum(axis=1)


def off_by(mesh: nf.WarpMesh, lens: nf.RadialLens, inverse: bool, fov: nf.Fov, output: nf.Fov, size: Array) -> float:
    """Return the greatest distance in pixels between shown and exact positions, at many places."""
    places, shown = through(mesh, 0, np.random.default_rng(3), 40_000)
    omega = max(abs(fov.left), abs(fov.right))
    x = output.left + (places[:, 0] + 1) / 2 * (output.right - output.left)
    y = output.down + (places[:, 1] + 1) / 2 * (output.up - output.down)
    map_ = lens.distort_points if inverse else lens.undistort_points
    exact = map_(np.column_stack([x, y]) / omega, outside="nan") * omega
    across, down = (exact[:, 0] - fov.left) / (fov.right - fov.left), (fov.up - exact[:, 1]) / (fov.up - fov.down)
    # Positions outside the picture do not count.
    inside = (across >= 0) & (across <= 1) & (down >= 0) & (down <= 1)
    return float(np.nanmax(np.linalg.norm((np.column_stack([across, down]) - shown) * size, axis=1)[inside]))


@pytest.mark.parametrize("inverse", [True, False])
@pytest.mark.parametrize("k", [(0.22, 0.24), (-0.1, 0.01), (0.05, -0.02, 0.04)])
def test_meshes_keep_their_error_bound(k: tuple[float, ...], inverse: bool) -> None:
    lens, size = nf.RadialLens(k), (1832, 1920)
    for cells in ((12, 12), (40, 30)):
        mesh = lens.warp_mesh(size, inverse, fov=EYE, cells=cells)
        assert mesh.faces.shape == (2 * cells[0] * cells[1], 3)
        off = off_by(mesh, lens, inverse, EYE, EYE, np.array(size))
        # The bound takes the worst direction, the densest axis and the farthest corner of a cell.
        assert 0.25 * mesh.error_px < off <= mesh.error_px


@settings(max_examples=settings().max_examples // 2)
@given(st.floats(1e-9, 0.5), st.floats(1e-9, 0.3), st.floats(-0.02, 0.02), st.floats(-0.02, 0.02), st.booleans())
def test_meshes_keep_their_error_bound_with_tangential_terms(
    k1: float, k2: float, p1: float, p2: float, back: bool
) -> None:
    lens = nf.RadialLens((k1, k2), (p1, p2))
    fov = nf.Fov(-1.0, 1.0, -1.0, 1.0)
    mesh = lens.warp_mesh((1000, 1000), not back, fov=fov, cells=(10, 10))
    off = off_by(mesh, lens, not back, fov, fov, np.array([1000, 1000]))
    assert off <= mesh.error_px


@pytest.mark.parametrize(
    ("k", "p", "fov"),
    [
        ((), (-0.05517924, -0.02195516), nf.Fov(0.2, 0.9903, -1.01604, 1.9976)),
        (
            (-0.01326868, -0.04297477, -0.00693983),
            (-0.00406291, -0.07910825),
            nf.Fov(0.2, 1.89532, -1.45632, 1.22493),
        ),
    ],
)
def test_bounds_cover_the_source_of_tangential_terms(k: tuple[float, ...], p: tuple[float, float], fov: nf.Fov) -> None:
    lens = nf.RadialLens(k, p)
    mesh = lens.warp_mesh((1000, 1000), False, fov=fov, cells=(50, 50))
    assert off_by(mesh, lens, False, fov, fov, np.array([1000, 1000])) <= mesh.error_px


def test_the_lens_does_not_depend_on_the_field_of_view() -> None:
    # A guard band around the picture changes the source picture, not the lens's distortion.
    screen, wide = nf.Fov(-1, 1, -1, 1), nf.Fov(-1.3, 1.3, -1.3, 1.3)
    image = np.zeros((260, 260))
    image[:, 180] = 1.0
    narrow = image[30:230, 30:230]
    shown = [
        RIFT_S.warp(picture, True, fov=fov, output_fov=screen, lens_radius=1.0, size=(200, 200))
        for picture, fov in ((image, wide), (np.ascontiguousarray(narrow), screen))
    ]
    assert np.allclose(shown[0][60:140, 60:140], shown[1][60:140, 60:140], atol=1e-9)
    eye = nf.hmd.VIVE.left.fov
    meshes = [RIFT_S.warp_mesh((100, 100), fov=eye, lens_radius=r, cells=(5, 5)) for r in (None, 2.0)]
    assert not np.array_equal(meshes[0].texcoords, meshes[1].texcoords)


def test_very_long_pictures_are_refused_at_once() -> None:
    tall = RIFT_S.warp_mesh((100, 200), fov="symmetric")
    assert tall.error_px <= 0.25
    with pytest.raises(ValueError, match=r"tolerance_px: expected at least .* px, the error of 262,144 cells"):
        RIFT_S.warp_mesh((2, 6000), fov="symmetric", tolerance_px=1e-4)


def test_meshes_have_as_many_cells_as_a_tolerance_needs() -> None:
    size = (1832, 1920)
    for tolerance in (2.0, 0.25):
        mesh = RIFT_S.warp_mesh(size, fov=EYE, tolerance_px=tolerance)
        assert mesh.error_px <= tolerance
        columns = len(np.unique(mesh.positions[:, 0])) - 1
        rows = len(np.unique(mesh.positions[:, 1])) - 1
        assert RIFT_S.warp_mesh(size, fov=EYE, cells=(columns - 2, rows - 2)).error_px > 0.9 * tolerance
    flat = nf.RadialLens(()).warp_mesh(size, fov="symmetric")
    assert flat.error_px < 1e-3
    assert len(flat.faces) == 2


def test_meshes_are_drawn_counter_clockwise_over_the_whole_view() -> None:
    mesh = RIFT_S.warp_mesh((640, 480), fov="symmetric")
    a, b, c = (mesh.positions[mesh.faces[:, n]].astype(np.float64) for n in range(3))
    area = ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]) / 2
    assert (area > 0).all()
    assert area.sum() == pytest.approx(4.0, abs=1e-5)
    # The top left corner shows a point far outside the picture's own.
    corner = np.flatnonzero((mesh.positions == [-1, 1]).all(axis=1))
    assert (mesh.texcoords[0, corner] < -0.1).all()
    middle = np.flatnonzero((np.abs(mesh.positions) < 1e-6).all(axis=1))
    assert np.allclose(mesh.texcoords[0, middle], 0.5, atol=1e-6)


def test_meshes_omit_areas_that_the_lens_cannot_show() -> None:
    lens = nf.RadialLens((-0.2,))
    wide = nf.Fov(-1.0, 1.0, -1.0, 1.0)
    mesh = lens.warp_mesh((800, 800), fov=wide, output_fov=nf.Fov(-2, 2, -2, 2), cells=(40, 40))
    assert 0 < len(mesh.faces) < 2 * 40 * 40
    assert np.isfinite(mesh.texcoords).all()
    assert mesh.faces.max() == len(mesh.positions) - 1
    with pytest.raises(ValueError, match=r"tolerance_px: expected at least .* px, the error of 262,144 cells"):
        lens.warp_mesh((800, 800), False, fov=wide, tolerance_px=1e-4)
    with pytest.raises(ValueError, match="fov: expected a field of view within the fold of the lens"):
        lens.warp_mesh((800, 800), fov=wide, output_fov=nf.Fov(2, 3, 2, 3), cells=(4, 4))
    with pytest.raises(ValueError, match=r"cells\[1\]: expected a whole number"):
        lens.warp_mesh((800, 800), fov="symmetric", cells=(4, 0))
