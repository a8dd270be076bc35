"""Tests of notebook cards of partitions and load curves."""

from __future__ import annotations

import numpy as np
import pytest
from PIL import ImageColor

import nearfar as nf
from nearfar._partition import preview
from tests.support.card_cases import Card
from tests.support.reduce_cases import CENTER, R1, R2, street


@pytest.fixture(scope="module")
def scene() -> nf.Scene:
    return street(dynamic=True, ground=False)


@pytest.mark.parametrize("shift", [0.0, 1e6])
def test_the_top_view_shows_zones_at_their_positions(scene: nf.Scene, shift: float) -> None:
    """Uses a flat board in each zone, near the scene's origin and far from it."""
    build = nf.SceneBuilder()
    square = np.array([[-4, 0, -4], [-4, 0, 4], [4, 0, 4], [4, 0, -4]], float)
    places = {"near": (10.0, 0.0), "intermediate": (0.0, 40.0), "far": (-60.0, 0.0)}
    for zone, (x, z) in places.items():
        mesh = build.mesh(
            np.add(square, (shift + x, 0, z)), [[0, 1, 2], [0, 2, 3]], material=build.material((1, 1, 1, 1))
        )
        build.instance(mesh, name=zone)
    parts = nf.partition(build.build(), center=(shift, 0, 0), r1=30, r2=50)
    shown = Card(parts._repr_html_())
    (picture,) = shown.pictures()
    scale = preview.SIZE / 2 / (preview.REACH * 50)
    for zone, (x, z) in places.items():
        row, column = round(preview.SIZE / 2 + z * scale), round(preview.SIZE / 2 + x * scale)
        color = ImageColor.getrgb(preview.ZONES[zone])
        np.testing.assert_array_equal(picture[row, column], (*color, 255), zone)
    assert picture[5, 5, 3] == 0, "the ground of the picture is the page's"


def test_counts_equal_the_summary(scene: nf.Scene) -> None:
    parts = nf.partition(scene, center=CENTER, r1=R1, r2=R2)
    shown, counts = Card(parts._repr_html_()), parts.summary()
    assert shown.facts()["drawn as geometry"] == f"{counts['nsf']:,}"
    assert shown.facts()["far"] == f"{counts['far']:,}"
    assert shown.facts()["centre"] == "3, 1.7, -2 m"


def test_only_the_largest_of_many_triangles_are_drawn(scene: nf.Scene, monkeypatch: pytest.MonkeyPatch) -> None:
    parts = nf.partition(scene, center=CENTER, r1=R1, r2=R2)
    monkeypatch.setattr(preview, "MAX_DRAWN", 2)
    monkeypatch.setattr(preview, "LARGEST", 2)
    settings = (parts._core, parts.scene._core, "far", (R1, R2), np.array(parts.scene.origin) - CENTER, 2.0)
    area, flat = preview._largest_triangles(*settings)
    assert 2 <= len(area) == len(flat) < parts.summary()["far"]
    assert area[0] == area.max()
    monkeypatch.setattr(preview, "MAX_LISTED", 1)
    for one, other in zip(preview._largest_triangles(*settings), (area, flat), strict=True):
        np.testing.assert_allclose(one, other, rtol=1e-6)


def test_empty_and_damaged_partitions_are_shown(scene: nf.Scene) -> None:
    empty = scene.subset(triangles=np.zeros(scene.triangle_count, bool))
    assert len(Card(nf.partition(empty, center=CENTER, r1=0, r2=1e-3)._repr_html_()).pictures()) == 1
    broken = nf.partition(scene, center=CENTER, r1=R1, r2=R2)
    object.__setattr__(broken, "_core", None)
    assert broken._repr_html_() == "<pre>&lt;nearfar._partition.partition.Partition, damaged&gt;</pre>"


def test_the_load_curve_is_a_plot_with_counts(scene: nf.Scene) -> None:
    curve = nf.load_curve(scene, center=CENTER)
    shown = Card(curve._repr_html_())
    assert shown.count("polyline") == 1
    assert shown.facts()["r₂ = 50 m"] == f"{curve.count(50.0):,} triangles"


def test_a_curve_of_moving_triangles_has_no_plot(scene: nf.Scene) -> None:
    moving = scene.subset(objects=["car"])
    shown = Card(nf.load_curve(moving, center=CENTER)._repr_html_())
    assert shown.count("svg") == 0
    assert shown.facts()["of them moving"] == "12"
