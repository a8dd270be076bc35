"""Tests of notebook cards of models of levels."""

from __future__ import annotations

import numpy as np

from tests.support.card_cases import Card
from tests.support.leveled_cases import model_of


def test_the_table_contains_the_values_of_the_text() -> None:
    model = model_of((3, 2, 1), name="<ball>")
    shown = Card(model._repr_html_())
    assert shown.text.startswith("LodModel <ball>, radius")
    cells = [["".join(cell.itertext()) for cell in row] for row in shown.root.iter("tr")]
    assert [row[1] for row in cells[1:]] == [f"{count:,}" for count in model.triangles]
    text = [line.split() for line in str(model).splitlines()[2:]]
    assert [[cell for cell in row if cell] for row in cells[1:]] == text
    assert shown.count("polyline") == 2


def test_a_single_level_has_no_plot() -> None:
    shown = Card(model_of((1,))._repr_html_())
    assert shown.count("svg") == 0
    assert "level" in shown.text


def test_damaged_models_show_their_repr() -> None:
    broken = model_of((2, 1))
    object.__setattr__(broken, "errors", np.zeros(0))
    assert broken._repr_html_().startswith("<pre>LodModel(&#x27;ball&#x27;")
