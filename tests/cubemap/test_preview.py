"""Tests of notebook previews of environment maps."""

from __future__ import annotations

import numpy as np

import nearfar as nf
from nearfar._cubemap.envmap import PREVIEW
from tests.support.card_cases import Card, decoded

FACE_COLORS = np.array([[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 0], [0, 1, 1], [1, 0, 1]], np.float32)


def faces(size: int = 64, brightness: float = 1.0) -> nf.EnvMap:
    color = np.broadcast_to(brightness * FACE_COLORS[:, None, None], (6, size, size, 3))
    return nf.EnvMap((1.0, 2.0, 3.0), color)


def test_minus_z_is_in_the_middle_and_plus_x_to_the_right() -> None:
    shown = Card(faces()._repr_html_())
    (picture,) = shown.pictures()
    assert picture.shape == (*PREVIEW, 3)
    height, width = PREVIEW
    places = {0: (height // 2, 3 * width // 4), 1: (height // 2, width // 4), 5: (height // 2, width // 2)}
    for face, (row, column) in {**places, 2: (2, 40), 3: (height - 3, 40), 4: (height // 2, 1)}.items():
        np.testing.assert_array_equal(picture[row, column], (255 * FACE_COLORS[face]).astype(np.uint8))
    assert shown.facts()["centre"] == "1, 2, 3 m"
    assert shown.facts()["faces"].startswith("6 × 64 × 64 texels")
    png = faces()._repr_png_()
    assert png is not None
    np.testing.assert_array_equal(decoded(png), picture)


def test_bright_maps_are_dimmed_with_a_note() -> None:
    shown = Card(faces(brightness=100.0)._repr_html_())
    assert "colours × 0.01" in shown.text
    np.testing.assert_array_equal(shown.pictures()[0], Card(faces()._repr_html_()).pictures()[0])


def test_damaged_maps_show_their_repr() -> None:
    broken = faces()
    object.__setattr__(broken, "color", None)
    assert broken._repr_html_().startswith("<pre>EnvMap(")
    assert broken._repr_png_() is None


def test_the_smallest_map_is_shown() -> None:
    assert Card(faces(1)._repr_html_()).pictures()[0].shape == (*PREVIEW, 3)
