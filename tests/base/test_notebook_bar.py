"""Tests of progress bars in notebooks: one output, which is empty at the end."""

from __future__ import annotations

from typing import Any

import pytest

from nearfar._base import progress
from tests.support import need


class Cell:
    """Stand-in for the handle of a displayed output."""

    def __init__(self) -> None:
        self.texts: list[str] = []

    def update(self, content: Any) -> None:
        self.texts.append(content.data)


def test_a_bar_is_one_output_that_ends_empty(monkeypatch: pytest.MonkeyPatch) -> None:
    need("notebook")
    from IPython import display

    cells = []

    def record_display(content: Any, *, display_id: bool) -> Cell:
        assert display_id
        cells.append(Cell())
        cells[-1].update(content)
        return cells[-1]

    monkeypatch.delenv("NEARFAR_PROGRESS", raising=False)
    monkeypatch.setattr(display, "display", record_display)
    monkeypatch.setattr(progress, "_in_notebook", lambda: True)
    monkeypatch.setattr(progress, "DELAY", 0.0)
    monkeypatch.setattr(progress, "UPDATE", 0.0)
    with progress.bar("baking") as outer:
        outer(1, 4)
        with progress.bar("inner") as inner:
            inner(1, 2)
        outer(2, 4)
    (cell,) = cells
    assert 'value="1" max="4"' in cell.texts[0]
    assert any("baking" in text and 'value="2" max="4"' in text for text in cell.texts)
    assert cell.texts[-1] == "<span></span>"
    assert not any("inner" in text for text in cell.texts)


def test_a_process_without_a_kernel_is_not_a_notebook() -> None:
    need("notebook")
    import ipykernel

    assert ipykernel.__name__ == "ipykernel"
    assert not progress._in_notebook()
