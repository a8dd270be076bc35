"""Tests of the parts of views within boxes, which stand in for smaller cells."""

from __future__ import annotations

import itertools
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from nearfar import _core
from tests.support.orthoview_cases import CORNER, SIDE
from tests.support.orthoview_oracle import DIRECTIONS
from tests.support.splat_cases import CAMERAS, cell_of, draw_splats
from tests.support.splat_oracle import Splat

Box = tuple[list[float], list[float]]

CELL: Box = (CORNER.tolist(), (CORNER + SIDE).tolist())
ALL: Box = ([-np.inf] * 3, [np.inf] * 3)
CHANNELS = ("color", "coverage", "range", "position", "normal", "albedo")


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
    whole = draw_splats([view], CAMERAS[name], CHANNELS)
    parts = [view.crop_to_box(*box) for box in divided(ALL, CORNER + SIDE / 2)]
    together = draw_splats(parts, CAMERAS[name], CHANNELS)
    assert np.isfinite(whole["range"]).any()
    for channel in CHANNELS:
        assert together[channel].tobytes() == whole[channel].tobytes(), channel
    assert together["stats"]["splats"] == whole["stats"]["splats"] == view.count
    assert all(part.bytes < view.bytes for part in parts)
    nearest = np.min([draw_splats([part], CAMERAS[name], CHANNELS)["range"] for part in parts], axis=0)
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
