"""Tests of drawing parts of splats: with geometry, limits, masks and boxes, and the same bytes everywhere."""

from __future__ import annotations

import itertools
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from nearfar import _core
from tests.support import printed_by_threads, splat_oracle
from tests.support.orthoview_cases import CORNER, SIDE
from tests.support.orthoview_oracle import DIRECTIONS
from tests.support.splat_cases import (
    CAMERAS,
    CHANNELS,
    MIDDLE,
    STRAIGHT,
    THREE,
    cell_of,
    draw_splats,
    flat,
    limits_of,
    splats_of,
    wall,
)
from tests.support.splat_oracle import Lens, Splat


@pytest.mark.parametrize("name", ["perspective", "asymmetric", "parallel", "cube face 2"])
def test_the_nearer_of_geometry_and_splats_is_visible(name: str) -> None:
    camera, splats = CAMERAS[name], splats_of(THREE)
    channels = ("color", "coverage", *CHANNELS, "object_id", "face_id")
    alone = draw_splats(splats, camera, channels)
    shown = np.isfinite(alone["range"])
    rng = np.random.default_rng(1)
    ranges = np.where(rng.random(shown.shape) < 0.3, np.inf, np.median(alone["range"][shown]))
    before = wall(camera, ranges)
    got = draw_splats(splats, camera, channels, before=before)
    is_wall = before["range"] < alone["range"]
    assert 0.02 < is_wall[shown].mean() < 0.98
    for channel in channels:
        flags = is_wall[..., None] if got[channel].ndim == 3 else is_wall
        np.testing.assert_array_equal(got[channel], np.where(flags, before[channel], alone[channel]))
    assert (got["object_id"][~is_wall] == -1).all()
    assert (got["face_id"][~is_wall] == -1).all()


def test_walls_hide_all_splats_or_none() -> None:
    camera, splats = CAMERAS["perspective"], splats_of(THREE)
    alone = draw_splats(splats, camera, ("color", "range"))
    near = draw_splats(splats, camera, ("color", "range"), before=wall(camera, 1))
    assert (near["range"] == 1).all()
    assert near["stats"]["splats_seen"] == near["stats"]["splats_projected"] == 0
    assert alone["stats"]["splats_seen"] > 0
    far = draw_splats(splats, camera, ("color", "range"), before=wall(camera, 1e4))
    shown = np.isfinite(alone["range"])
    np.testing.assert_array_equal(far["color"][shown], alone["color"][shown])
    assert (far["range"][~shown] == 1e4).all()


def test_geometry_is_composited_per_sample() -> None:
    """Geometry has a pixel for each sample: it hides some of four samples."""
    camera, splats = CAMERAS["perspective"], splats_of(THREE)
    width, height = camera.size
    finer = replace(camera, size=(2 * width, 2 * height))
    ranges = np.full((2 * height, 2 * width), np.inf)
    ranges[::2, ::2] = 1.0
    alone, before = draw_splats(splats, finer, ("color", "coverage", "range")), wall(finer, ranges)
    got = draw_splats(splats, camera, ("color", "coverage"), 2, before)
    fine = np.where(np.isfinite(ranges)[..., None], before["color"], alone["color"]).astype(np.float64)
    mean = fine.reshape(height, 2, width, 2, 3).mean(axis=(1, 3))
    np.testing.assert_allclose(got["color"], mean, atol=1e-6)
    assert got["coverage"].min() == 0.25
    with pytest.raises(ValueError, match="before"):
        draw_splats(splats, camera, ("color",), 2, wall(camera, 1.0))


def test_at_equal_depth_the_first_splat_is_drawn() -> None:
    dark, light = flat(50), flat(200)
    for order in ([dark, light], [light, dark]):
        first, both = draw_splats(order[:1], STRAIGHT), draw_splats(order, STRAIGHT)
        assert np.isfinite(first["range"]).all()
        for channel in CHANNELS:
            np.testing.assert_array_equal(both[channel], first[channel])
    nearer = flat(120, 99)
    np.testing.assert_array_equal(
        draw_splats([dark, nearer], STRAIGHT)["albedo"], draw_splats([nearer], STRAIGHT)["albedo"]
    )


def test_at_equal_depth_splats_hide_geometry() -> None:
    """Along −z a range is a distance, without rounding."""
    splats = [flat(50)]
    alone = draw_splats(splats, STRAIGHT, ("color", "range"))
    at_once = draw_splats(splats, STRAIGHT, ("color", "range"), before=wall(STRAIGHT, alone["range"]))
    np.testing.assert_array_equal(at_once["color"], alone["color"])
    nearer = wall(STRAIGHT, np.nextafter(alone["range"], np.float32(0)))
    assert (draw_splats(splats, STRAIGHT, ("color", "range"), before=nearer)["color"] == [1, 0, 0]).all()


@pytest.mark.parametrize("camera", ["perspective", "parallel"])
@pytest.mark.parametrize("name", ["t_min", "t_max", "both", "box", "planes"])
def test_splats_with_centres_within_limits_are_drawn(name: str, camera: str) -> None:
    limits, view, (splats, known) = limits_of(name), CAMERAS[camera], cell_of(THREE)
    lens = Lens.from_camera(view)
    points = np.array([splat.point for splat in known])
    away = points - lens.eye
    ranges = away @ lens.rows[2] if lens.is_parallel else np.linalg.norm(away, axis=1)
    inside = (limits.get("t_min", 0) <= ranges) & (ranges <= limits.get("t_max", np.inf))
    if "clip" in limits:
        spaces = limits["clip"].half_spaces
        inside &= (points @ spaces[:, :3].T + spaces[:, 3] >= 0).all(axis=1)
    assert 0.05 < inside.mean() < 0.95
    within = [splat for splat, is_within in zip(known, inside, strict=True) if is_within]
    splat_oracle.check(draw_splats(splats, view, **limits), within, view)


def test_masked_pixels_are_misses_and_bare_pictures_have_no_sky() -> None:
    camera, splats = CAMERAS["perspective"], splats_of(THREE)
    channels = ("color", "coverage", "range")
    width, height = camera.size
    mask = np.random.default_rng(0).random((height, width)) < 0.6
    whole, masked = draw_splats(splats, camera, channels), draw_splats(splats, camera, channels, mask=mask)
    for channel in channels:
        np.testing.assert_array_equal(masked[channel][mask], whole[channel][mask])
    assert (masked["color"][~mask] == 0).all()
    assert np.isinf(masked["range"][~mask]).all()
    bare, shown = draw_splats(splats, camera, channels, bare=True), np.isfinite(whole["range"])
    np.testing.assert_array_equal(bare["color"], np.where(shown[..., None], whole["color"], 0))
    np.testing.assert_array_equal(bare["range"], whole["range"])


def test_an_empty_picture_is_sky() -> None:
    camera, splats = CAMERAS["perspective"], splats_of(THREE)
    none = draw_splats([], camera, ("coverage", "range"))
    assert np.isinf(none["range"]).all()
    away = nf.Camera.look_at(
        MIDDLE + np.array([0, 0, 60]), MIDDLE + np.array([0, 0, 90]), fov=camera.fov, size=camera.size
    )
    behind = draw_splats(splats, away, ("coverage", "range"))
    assert (behind["coverage"] == 0).all()
    assert behind["stats"]["splats_in_picture"] == 0 < behind["stats"]["splats"]


PICTURES = """
import hashlib
from tests.support.splat_cases import CAMERAS, CHANNELS, LARGE, THREE, draw_splats, splats_of
splats = splats_of(THREE, size=32)
for name, grid in [("large", 3), ("close", 3), ("parallel", 1), ("cube face 1", 3)]:
    images = draw_splats(splats, LARGE if name == "large" else CAMERAS[name], ("color", *CHANNELS), grid)
    print(name, *(hashlib.sha256(images[channel].tobytes()).hexdigest() for channel in ("color", *CHANNELS)))
    print(images["stats"]["splats"], images["stats"]["splats_seen"])
"""


@pytest.mark.slow
def test_pictures_are_the_same_for_any_number_of_threads() -> None:
    printed = printed_by_threads(PICTURES)
    assert len(printed) == 1
    assert len(set(printed.pop().split("\n"))) > 5


@pytest.mark.parametrize("name", ["perspective", "inside", "parallel", "cube face 1"])
def test_pictures_are_the_same_for_all_instruction_sets(name: str) -> None:
    splats, pictures = splats_of(THREE, size=32), []
    try:
        for instructions in _core.instruction_sets():
            _core.use_instruction_set(instructions)
            images = draw_splats(splats, CAMERAS[name], ("color", *CHANNELS))
            pictures.append([images[channel].tobytes() for channel in ("color", *CHANNELS)])
    finally:
        _core.use_instruction_set(_core.instruction_sets()[-1])
    assert all(picture == pictures[0] for picture in pictures[1:])


def test_invalid_splat_calls_are_named() -> None:
    camera, splats = CAMERAS["perspective"], splats_of([(0, 0, 1)])
    with pytest.raises(ValueError, match="grid: expected 1 to 8, got 9"):
        draw_splats(splats, camera, ("color",), 9)
    with pytest.raises(ValueError, match="grid: expected an odd number for images of the pixels' middles, got 2"):
        draw_splats(splats, camera, ("color", "range"), 2)
    views = _core.OrthoViews.from_arrays(
        [(0, 0, 1)],
        (8, 12, 16),
        np.zeros((1, 8, 8, 3), np.uint8),
        np.zeros((1, 8, 8, 1), np.uint16),
        np.zeros((1, 8, 8, 2), np.uint16),
    )
    bits = np.zeros((1, 8, 8, 1), np.uint8)
    cell = ((0.0, 0.0, 0.0), 1.0)
    assert _core.OrthoSplats(views, 0, bits, cell).count == 0
    with pytest.raises(ValueError, match="number: expected one of 1 views, got 1"):
        _core.OrthoSplats(views, 1, bits, cell)
    with pytest.raises(ValueError, match="connected: expected pixels of 1 views, got 32"):
        _core.OrthoSplats(views, 0, bits[:, :4], cell)


# Parts within boxes, which stand in for smaller cells -----------------------------------------------------------------
Box = tuple[list[float], list[float]]

CELL: Box = (CORNER.tolist(), (CORNER + SIDE).tolist())
ALL: Box = ([-np.inf] * 3, [np.inf] * 3)
IMAGES = ("color", "coverage", "range", "position", "normal", "albedo")


@pytest.fixture(scope="module")
def cell() -> tuple[list[_core.OrthoSplats], list[Splat]]:
    return cell_of(DIRECTIONS)


def divided(box: Box, at: NDArray[np.float64]) -> list[Box]:
    """Eight boxes that share a corner."""
    low, high = np.array(box)
    return [
        (np.where(octant, at, low).tolist(), np.where(octant, high, at).tolist())
        for octant in itertools.product((False, True), repeat=3)
    ]


def in_box(points: NDArray[np.float64], box: Box) -> NDArray[np.bool_]:
    low, high = np.array(box)
    found: NDArray[np.bool_] = np.all((points >= low) & (points < high), axis=1)
    return found


def points_of(known: list[Splat], views: list[_core.OrthoSplats]) -> list[NDArray[np.float64]]:
    """Centres of the splats of each view."""
    ends = np.cumsum([view.count for view in views])[:-1]
    return np.split(np.array([splat.point for splat in known]), ends)


@pytest.mark.parametrize("at", [CORNER + SIDE / 2, CORNER + np.array([3.1, 17.2, 9.9])])
def test_parts_contain_splats_with_centres_in_the_box(cell: Any, at: NDArray[np.float64]) -> None:
    views, known = cell
    for view, points in zip(views, points_of(known, views), strict=True):
        assert np.abs(points - at).min() > 1e-9  # Rounding decides nothing.
        counts = [view.crop_to_box(*box).count for box in divided(CELL, at)]
        assert counts == [in_box(points, box).sum() for box in divided(CELL, at)]
        assert np.count_nonzero(counts) > 3
        assert sum(view.crop_to_box(*box).count for box in divided(ALL, at)) == view.count
        assert view.crop_to_box(*ALL).count == view.count


def test_parts_of_parts_equal_parts(cell: Any) -> None:
    views, known = cell
    for view, points in zip(views, points_of(known, views), strict=True):
        for box in divided(CELL, CORNER + SIDE / 2):
            part = view.crop_to_box(*box)
            smaller = divided(box, np.mean(box, axis=0))
            assert [part.crop_to_box(*one).count for one in smaller] == [in_box(points, one).sum() for one in smaller]
            assert [part.crop_to_box(*one).count for one in smaller] == [
                view.crop_to_box(*one).count for one in smaller
            ]


def test_a_box_without_splats_is_empty(cell: Any) -> None:
    views, _ = cell
    low, high = CELL
    for box in ((high, high), ((CORNER - 9).tolist(), (CORNER - 1).tolist()), (high, low)):
        parts = [view.crop_to_box(*box) for view in views]
        assert [part.count for part in parts] == [0] * len(parts)
        image = draw_splats(parts, CAMERAS["perspective"])
        assert np.isinf(image["range"]).all()
        assert image["stats"]["splats"] == 0


@pytest.mark.parametrize("name", ["perspective", "inside", "parallel"])
def test_all_parts_together_show_the_whole(cell: Any, name: str) -> None:
    """Each part shows the picture of its splats alone, and takes memory for these only."""
    views, _ = cell
    view = views[len(views) // 2]
    whole = draw_splats([view], CAMERAS[name], IMAGES)
    parts = [view.crop_to_box(*box) for box in divided(ALL, CORNER + SIDE / 2)]
    together = draw_splats(parts, CAMERAS[name], IMAGES)
    assert np.isfinite(whole["range"]).any()
    for channel in IMAGES:
        assert together[channel].tobytes() == whole[channel].tobytes(), channel
    assert together["stats"]["splats"] == whole["stats"]["splats"] == view.count
    assert all(part.bytes < view.bytes for part in parts)
    nearest = np.min([draw_splats([part], CAMERAS[name], IMAGES)["range"] for part in parts], axis=0)
    np.testing.assert_array_equal(nearest, whole["range"])


def test_a_part_lies_in_its_box(cell: Any) -> None:
    """The box may be exceeded by half a pixel of the view, or a third with wide borders, on each side."""
    views, _ = cell
    reach = 3 * SIDE / 16
    for view in views:
        for box in divided(CELL, CORNER + SIDE / 2):
            image = draw_splats([view.crop_to_box(*box)], CAMERAS["perspective"], ("range", "position"))
            places = image["position"][np.isfinite(image["range"])] + CORNER + SIDE / 2
            assert (places >= np.array(box[0]) - reach).all()
            assert (places <= np.array(box[1]) + reach).all()
