"""Tests of the kernel that splats views: against slow code, and colours by arithmetic."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from nearfar import _core
from nearfar.orthoview._codec import CONNECTION_LIMITS
from nearfar.orthoview._grid import directions_of
from tests.support import render_oracle, splat_oracle
from tests.support.orthoview_cases import CORNER, SIDE, boxes
from tests.support.orthoview_oracle import DIRECTIONS, Triple
from tests.support.splat_cases import CAMERAS, CHANNELS, LARGE, MIDDLE, WIDE, cell_of, draw_splats, facing, splats_of


@pytest.mark.parametrize("name", CAMERAS)
def test_samples_show_the_nearest_splat(name: str) -> None:
    # Balls in one row of a view are equidistant from a camera that looks across it: many of them overlap.
    doubt = 0.3 if name.startswith(("cube", "along")) else 0.02
    splats, known = cell_of([(1, 0, 0), (0, 1, 0), (0, 1, 1)])
    share = splat_oracle.check(draw_splats(splats, CAMERAS[name]), known, CAMERAS[name], most_doubt=doubt)
    assert 0.03 < share < 1


def test_screen_tiles_fit_together() -> None:
    splats, known = cell_of([(1, 0, 0), (0, 1, 0)], size=12)
    images = draw_splats(splats, LARGE)
    assert images["stats"]["splats_projected"] > images["stats"]["splats"]
    assert splat_oracle.check(images, known, LARGE, most_doubt=0.1) > 0.03


@pytest.mark.parametrize("fov", [nf.Orthographic(-32, 32, -32, 32), nf.Fov(-1, 1, -1, 1)])
def test_a_floor_at_eye_height_is_a_line_of_its_length(fov: nf.Fov | nf.Orthographic) -> None:
    layout, size = (8, 12, 16), 8
    codes = np.full((1, size, size, 1), 2046, np.uint16)
    up = np.full((1, size, size, 2), 127, np.uint16)
    up[..., 1] = 254
    views = _core.OrthoViews.from_arrays([(0, 1, 0)], layout, np.zeros((1, size, size, 3), np.uint8), codes, up)
    np.testing.assert_allclose(views.vectors()[0, 0, 0], (0, 1, 0), atol=1e-6)
    splats = [_core.OrthoSplats(views, 0, views.connected(CONNECTION_LIMITS), ((-4.0, -4.0, -4.0), 8.0))]
    height = 4 - (2046 - 0.5) * 8 / 4092
    camera = nf.Camera((0.0, height, 32.0), fov=fov, size=(65, 65))
    shown = np.isfinite(draw_splats(splats, camera)["range"])
    rows, columns = np.nonzero(shown)
    # The floor is 8 m wide in front of the eye, of pixels of 64/65 m at 32 m.
    middle, half = 32, 4.6 * 65 / 64 * (32 / 28 if isinstance(fov, nf.Fov) else 1)
    assert len(rows) > 3
    assert (np.abs(columns - middle) <= half + 1).all()
    assert (np.abs(rows - 32) <= 1).all()


@pytest.mark.parametrize("direction", DIRECTIONS)
def test_views_of_all_directions_are_drawn(direction: Triple) -> None:
    assert set(DIRECTIONS) == set(directions_of(26))
    splats, known = cell_of([direction], size=12)
    camera = facing(direction, WIDE)
    assert splat_oracle.check(draw_splats(splats, camera), known, camera) > 0.1


@pytest.mark.parametrize(("depth_bits", "normal_bits", "size"), [(8, 16, 24), (12, 24, 20), (16, 24, 16)])
def test_splats_of_all_formats_are_drawn(depth_bits: int, normal_bits: int, size: int) -> None:
    """One size is no multiple of the side of blocks."""
    splats, known = cell_of([(0, 0, 1), (1, 1, 1)], depth_bits, normal_bits, size)
    camera = facing((1, 1, 2), WIDE)
    assert splat_oracle.check(draw_splats(splats, camera), known, camera) > 0.1


def test_a_cell_far_from_the_origin_keeps_its_precision() -> None:
    """Positions are made relative to the camera before they become float32."""
    splats = splats_of([(0, 0, 1)])
    layout, shift = (16, 12, 24), np.array([2.0**22, 0, -(2.0**22)])
    views = _core.OrthoViews.of_cell(boxes()[0]._core, (tuple(CORNER), SIDE), [(0, 0, 1)], layout)
    far = [_core.OrthoSplats(views, 0, views.connected(CONNECTION_LIMITS), (tuple(CORNER + shift), SIDE))]
    camera = facing((0, 0, 1), WIDE)
    x, y, z = np.array(camera.position) + shift
    near, moved = draw_splats(splats, camera), draw_splats(far, replace(camera, position=(x, y, z)))
    both = np.isfinite(near["range"]) & np.isfinite(moved["range"])
    # Coordinates of 2²² m are rounded to 2⁻³⁰ m in float64.
    assert (np.isfinite(near["range"]) != np.isfinite(moved["range"])).sum() <= 2
    assert (np.abs(near["range"][both] - moved["range"][both]) < 1e-4).mean() > 0.99
    np.testing.assert_array_equal(draw_splats(far, camera)["range"], np.inf)


@pytest.mark.parametrize("name", ["perspective", "parallel", "cube face 4"])
@pytest.mark.parametrize("grid", [2, 3, 4])
def test_colour_is_the_mean_of_finer_samples(grid: int, name: str) -> None:
    splats = splats_of([(1, 0, 0), (0, 1, 0), (0, 1, 1)])
    camera = CAMERAS[name]
    width, height = camera.size
    finer = replace(camera, size=(width * grid, height * grid))
    channels = ("color", "coverage")
    got, fine = draw_splats(splats, camera, channels, grid), draw_splats(splats, finer, (*channels, "range"))

    def mean(image: NDArray[Any]) -> NDArray[Any]:
        split = image.astype(np.float64).reshape(height, grid, width, grid, -1)
        means: NDArray[Any] = split.mean(axis=(1, 3)).reshape(height, width, *image.shape[2:])
        return means

    np.testing.assert_allclose(got["color"], mean(fine["color"]), atol=1e-6)
    np.testing.assert_allclose(got["coverage"], mean(fine["coverage"]), atol=1e-6)
    np.testing.assert_array_equal(fine["coverage"] == 1, np.isfinite(fine["range"]))
    assert ((got["coverage"] > 0) & (got["coverage"] < 1)).mean() > 0.01


def test_colour_is_lit_albedo_and_sky_elsewhere() -> None:
    splats = splats_of([(1, 0, 0), (0, 1, 0), (0, 1, 1)])
    camera = CAMERAS["perspective"]
    images = draw_splats(splats, camera, ("color", "coverage", *CHANNELS, "position", "shading_normal"))
    shown = np.isfinite(images["range"])
    light = render_oracle.irradiance(images["normal"][shown].astype(np.float64))
    np.testing.assert_allclose(images["color"][shown], images["albedo"][shown] * light, atol=1e-6)
    start, direction = camera.rays()
    np.testing.assert_allclose(images["color"][~shown], render_oracle.background(direction[~shown]), atol=1e-5)
    np.testing.assert_array_equal(images["coverage"], shown)
    np.testing.assert_array_equal(images["shading_normal"], images["normal"])
    places = (start + direction * images["range"][..., None])[shown]
    np.testing.assert_allclose(images["position"][shown] + MIDDLE, places, atol=1e-4)
    assert np.isnan(images["position"][~shown]).all()
