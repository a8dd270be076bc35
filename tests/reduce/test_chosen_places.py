"""Reductions without a centre or radii: the library chooses what the command chooses, and says why."""

from __future__ import annotations

import logging
from pathlib import Path

import pytest

import nearfar as nf
from tests.support.cli_cases import command, document
from tests.support.reduce_cases import CENTER, street


def test_a_procedural_scene_gets_the_place_and_the_radii_of_the_command(capsys: pytest.CaptureFixture[str]) -> None:
    printed = document(command(capsys, "partition", "-i", "forest:trees=500,detail=0", "--json")[1], "partition")
    reduced = nf.reduce(nf.datasets.forest(trees=500, detail=0), settings=nf.MapSettings(face_size=8, samples=1))
    assert list(reduced.center) == pytest.approx(printed["center"])
    assert (reduced.r1, reduced.r2) == pytest.approx((printed["r1"], printed["r2"]))
    assert reduced.reason.startswith("the centre (")
    assert reduced.reason.endswith(f" is an open place near the middle; {printed['radii_reason']}")


def test_a_given_centre_gets_the_radii_of_the_command(capsys: pytest.CaptureFixture[str]) -> None:
    printed = document(command(capsys, "partition", "-i", "room:detail=0", "--json")[1], "partition")
    reduced = nf.reduce(nf.datasets.room(detail=0), center=printed["center"], face_size=8, samples=1)
    assert (reduced.r1, reduced.r2) == pytest.approx((printed["r1"], printed["r2"]))
    assert reduced.reason == printed["radii_reason"]


def test_the_choice_is_logged(caplog: pytest.LogCaptureFixture) -> None:
    with caplog.at_level(logging.INFO, logger="nearfar"):
        reduced = nf.reduce(street(), center=CENTER, r2=20.0, face_size=8, samples=1)
    assert reduced.r2 == 20.0
    assert reduced.r1 == 8.0
    assert reduced.reason.startswith("with r1 = 8 m the greatest shear of the ground between the radii is ")
    assert caplog.messages == [f"reduce: {reduced.reason}"]
    assert ", chosen by reduce: " in repr(reduced)
    assert "greatest shear" in reduced._repr_html_()
    assert reduced.with_morph("none").reason == reduced.reason
    assert reduced.with_r1(4.0).reason == ""
    open_place = nf.reduce(street(), r2=20.0, face_size=8, samples=1)
    moved = open_place.with_r1(4.0)
    assert open_place.reason.startswith(f"{moved.reason}; with r1 = 8 m")
    assert moved.reason.endswith("is an open place near the middle")
    assert "chosen" not in repr(moved)
    whole = nf.reduce(street(), center=CENTER, r1=8.0, r2=20.0, face_size=8, samples=1)
    assert whole.reason == ""
    assert "chosen" not in repr(whole)


def test_reasons_are_saved(tmp_path: Path) -> None:
    reduced = nf.reduce(street(), r2=20.0, face_size=8, samples=1)
    reduced.save(tmp_path / "light")
    loaded = nf.ReducedScene.load(tmp_path / "light")
    assert loaded.reason == reduced.reason
    assert ", chosen by reduce: " in repr(loaded)


@pytest.mark.parametrize(
    ("center", "place"),
    [((0.0, -500.0, 0.0), "below"), ((99_000.0, 1.7, 0.0), "away from"), ((0.0, 1.7, -99e3), "away from")],
)
def test_centres_that_must_be_mistakes_are_refused(center: tuple[float, float, float], place: str) -> None:
    with pytest.raises(ValueError, match=f"center: expected a place in or near the scene.* m {place} it"):
        nf.reduce(street(), center=center)


def test_a_centre_above_or_beside_a_scene_is_used() -> None:
    for center in ((0.0, 150.0, 0.0), (-150.0, 1.7, 0.0)):
        assert nf.reduce(street(), center=center, face_size=8, samples=1).center == center
