"""Set-up of the tests of the command line, which call it hundreds of times in one process."""

import functools
import importlib.util
from collections.abc import Iterator
from typing import Any

import pytest
import typer.main


@pytest.fixture(scope="session", autouse=True)
def _save_time() -> Iterator[None]:
    """Read the options of commands once, and draw small plots without margins, whose layout takes most of the time."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(typer.main, "get_command", functools.cache(typer.main.get_command))
        if importlib.util.find_spec("matplotlib"):
            from matplotlib.figure import Figure

            save = Figure.savefig

            def save_small(figure: Figure, path: Any, **options: Any) -> None:
                figure.set_layout_engine("none")
                save(figure, path, **options | {"dpi": 30})

            patch.setattr(Figure, "savefig", save_small)
        yield
