"""Tests of notebook cards: escaped, in the page's colours, and never an obstacle to showing the object."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable

import numpy as np
import pytest

from nearfar._base import card
from tests.support.card_cases import Card, decoded

EVIL = "<script>alert('\"&\"')</script>"


class Broken:
    """An object whose card fails, and optionally its `repr`."""

    def __init__(self, text: Callable[[], str]) -> None:
        self._text = text

    def __repr__(self) -> str:
        return self._text()

    @card.repr_html
    def _repr_html_(self) -> str:
        raise ZeroDivisionError


def test_text_is_escaped_everywhere() -> None:
    pixels = np.zeros((4, 8, 3), np.uint8)
    line = card.Line(np.array([1.0, 10.0]), np.array([1.0, 2.0]), EVIL)
    shown = Card(
        card.page(
            EVIL,
            [(EVIL, EVIL)],
            card.picture(pixels, EVIL, EVIL, [("#123456", EVIL)]),
            card.plot([line], EVIL, EVIL),
            card.table([[EVIL] * 3], [EVIL] * 3),
            notes=[EVIL],
        )
    )
    assert shown.text.count(EVIL) == 15
    assert next(shown.root.iter("img")).get("alt") == EVIL


def test_an_object_whose_card_fails_shows_its_repr() -> None:
    assert Broken(lambda: "<a & b>")._repr_html_() == "<pre>&lt;a &amp; b&gt;</pre>"


def test_an_object_whose_repr_fails_shows_its_class() -> None:
    text = Broken(lambda: str(1 / 0))._repr_html_()
    assert "Broken, damaged&gt;</pre>" in text


@pytest.mark.parametrize("shape", [(1, 1, 3), (3, 5000, 3), (5000, 3, 4), (100, 100, 3), (2000, 2000, 3)])
def test_pictures_are_scaled_to_a_readable_size(shape: tuple[int, int, int]) -> None:
    picture = decoded(card.png(np.full(shape, 200, np.uint8)))
    assert max(picture.shape[:2]) <= card.MAX_PIXELS
    assert max(picture.shape[:2]) >= card.MIN_PIXELS // 2
    assert (picture == 200).all()


def test_plots_omit_values_that_axes_cannot_show() -> None:
    x = np.array([0.0, 1.0, 10.0, 100.0, 1000.0, np.inf])
    y = np.array([1.0, 2.0, np.nan, 0.0, 8.0, 9.0])
    shown = Card(card.plot([card.Line(x, y, points=(x, y))], "x", "y", log_y=True))
    (line,) = shown.root.iter("polyline")
    assert len(line.attrib["points"].split()) == 2
    assert shown.count("circle") == 2


@pytest.mark.parametrize("values", [[], [5.0], [5.0, 5.0], [np.nan, np.nan]])
@pytest.mark.parametrize("log_y", [False, True])
def test_plots_of_few_values_are_drawn(values: list[float], log_y: bool) -> None:
    line = card.Line(np.array(values), np.array(values))
    assert Card(card.plot([line], "x", "y", log_y=log_y)).count("svg") == 1


def test_ticks_are_round_and_within_the_axis() -> None:
    rng = (np.arange(1, 40) * 0.37) ** 3
    for low, high in zip(rng, rng[::-1], strict=True):
        if low < high:
            for is_log in (False, True):
                axis = card._Axis.spanning(np.array([low, high]), is_log, 0.0, 100.0)
                ticks = axis.ticks()
                assert 2 <= len(ticks) <= 8
                assert all(-1e-6 <= axis(value) <= 100.0 + 1e-6 for value, _ in ticks)


def test_the_package_does_not_load_plotting_or_widgets() -> None:
    code = (
        "import sys, nearfar as nf; nf.Scene, nf.ReducedScene, nf.Frame, nf.Hmd, nf.lod.LodModel; "
        "print({'matplotlib', 'ipywidgets', 'IPython'} & set(sys.modules))"
    )
    process = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert process.stdout.strip() == "set()"
