"""Tests of notebook previews of frames."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar._base import card
from nearfar._render import preview
from nearfar._render.channels import CHANNELS
from tests.support.card_cases import Card, decoded

SIZE = (320, 200)


@pytest.fixture(scope="module")
def full() -> nf.Frame:
    build = nf.SceneBuilder()
    plane = [[-50, 0, -50], [-50, 0, 50], [50, 0, 50], [50, 0, -50]]
    build.instance(
        build.mesh(plane, [[0, 1, 2], [0, 2, 3]], material=build.material((0.9, 0.2, 0.1, 1))), name="ground"
    )
    camera = nf.Camera((0, 2, 0), fov=nf.Fov.symmetric(90, 1.6), size=SIZE)
    before = nf.Camera((0.2, 2, 0), fov=camera.fov, size=SIZE)
    return nf.render(build.build(), camera, channels=CHANNELS, before=before, backend="cpu")


def test_colour_is_shown_as_saved(full: nf.Frame) -> None:
    shown = Card(full._repr_html_())
    (picture,) = shown.pictures()
    np.testing.assert_array_equal(picture, full.to_image())
    assert "320 × 200 pixels of color, range" in shown.text
    png = full._repr_png_()
    assert png is not None
    np.testing.assert_array_equal(decoded(png), picture)


@pytest.mark.parametrize("name", preview.CAPTIONS)
def test_every_image_alone_has_a_picture(full: nf.Frame, name: str) -> None:
    image: dict[str, Any] = {name: full.require(name)}
    frame = nf.Frame(full.camera, full.origin, **image)
    shown = Card(frame._repr_html_())
    (picture,) = shown.pictures()
    assert picture.shape == (*SIZE[::-1], 3)
    assert preview.CAPTIONS[name] in shown.text
    # Pixels without a surface move like the sky.
    if name not in ("color", "motion"):
        hit = full.require("object_id") >= 0
        assert (picture[~hit] == 48).all()
        assert not (picture[hit] == 48).all(axis=-1).all()


def test_near_ranges_are_brighter(full: nf.Frame) -> None:
    frame = nf.Frame(full.camera, range=full.require("range"))
    (picture,) = Card(frame._repr_html_()).pictures()
    assert picture[-1, 160, 0] > picture[120, 160, 0] > picture[106, 160, 0]


def test_large_frames_are_subsampled_before_conversion() -> None:
    camera = nf.Camera((0, 0, 0), fov=nf.Fov.symmetric(90, 4.0), size=(16000, 4000))
    color = np.broadcast_to(np.float32(0.5), (4000, 16000, 3))
    frame = nf.Frame(camera, color=color)
    assert max(card.subsample(frame.require("color")).shape) <= 2 * card.MAX_PIXELS
    (picture,) = Card(frame._repr_html_()).pictures()
    assert picture.shape == (160, 640, 3)


def test_frames_without_displayable_pixels_show_their_repr(full: nf.Frame) -> None:
    empty = nf.Frame(full.camera)
    assert empty._repr_html_().startswith("<pre>Frame(")
    assert empty._repr_png_() is None
    damaged = nf.Frame(full.camera, color=full.color)
    object.__setattr__(damaged, "color", "nothing")
    assert damaged._repr_html_().startswith("<pre>Frame(")
    assert damaged._repr_png_() is None


def test_frames_that_hit_nothing_are_shown(full: nf.Frame) -> None:
    nothing = nf.Frame(full.camera, range=np.full(SIZE[::-1], np.inf, np.float32))
    (picture,) = Card(nothing._repr_html_()).pictures()
    assert (picture == 48).all()
