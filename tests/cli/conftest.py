"""Set-up of the tests of the command line, which call it hundreds of times in one process."""

from __future__ import annotations

import functools
import importlib.util
from collections.abc import Iterator
from typing import Any

import pytest
import typer.main


@pytest.fixture(scope="session", autouse=True)
def _build_commands_once() -> Iterator[None]:
    """Read the options of all commands once instead of at every call."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(typer.main, "get_command", functools.cache(typer.main.get_command))
        yield


@pytest.fixture(scope="session", autouse=True)
def _draw_small_plots() -> Iterator[None]:
    """Draw plots in few pixels, and leave their margins alone, whose sizes take most of the time."""
    if not importlib.util.find_spec("matplotlib"):
        yield
        return
    from matplotlib.figure import Figure

    save = Figure.savefig

    def save_small(figure: Figure, path: Any, **options: Any) -> None:
        figure.set_layout_engine("none")
        save(figure, path, **options | {"dpi": 30})

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Figure, "savefig", save_small)
        yield
