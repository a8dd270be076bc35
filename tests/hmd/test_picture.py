"""Tests of notebook cards of headsets."""

from __future__ import annotations

import dataclasses
import math

import numpy as np
import pytest

import nearfar as nf
from nearfar.hmd import _picture
from tests.support.card_cases import Card


@pytest.mark.parametrize("name", nf.hmd.names())
def test_every_headset_has_a_drawing_of_both_eyes(name: str) -> None:
    hmd = nf.hmd.get(name)
    shown = Card(hmd._repr_html_())
    assert shown.count("polygon") == 2
    assert f"both eyes see {hmd.total_fov.overlap_deg:.0f}°" in shown.facts()["field of view"]
    assert shown.facts()["distance of eyes"] == f"{1000 * hmd.ipd:.1f} mm"
    assert all(source in shown.text for source in hmd.sources)
    assert ("panel" in shown.facts()) == (hmd.panel_size is not None)


def test_outlines_are_the_angles_of_the_edges() -> None:
    eye = nf.hmd.Eye(nf.Fov.from_angles(*np.radians([-40.0, 50.0, 45.0, -55.0])), (0.03, 0.0, 0.0))
    outline = _picture._outline(eye)
    assert outline[:, 0].min() == pytest.approx(-40.0)
    assert outline[:, 0].max() == pytest.approx(50.0)
    # Edges are straight in the picture, so they bulge in the middle, where the eye looks straight up or down.
    assert outline[:, 1].max() <= 45.0 + 1e-9
    assert outline[:, 1].min() >= -55.0 - 1e-9
    assert math.isclose(outline[:, 1].max(), 45.0, abs_tol=0.5)


def test_unknown_figures_are_omitted_and_names_are_escaped() -> None:
    known = nf.hmd.QUEST_2
    eye = known.left
    bare = nf.Hmd(name="<b>A & B</b>", left=eye, right=dataclasses.replace(eye, position=(1, 0, 0)), render_size=(8, 9))
    shown = Card(bare._repr_html_())
    assert set(shown.facts()) == {"field of view", "picture", "distance of eyes"}
    assert shown.text.startswith("<b>A & B</b>")


def test_damaged_headsets_show_their_repr() -> None:
    broken = dataclasses.replace(nf.hmd.QUEST_2)
    object.__setattr__(broken, "left", None)
    assert broken._repr_html_().startswith("<pre>Hmd(")
