"""Input and output of every benchmark: options of the command line, the machine, tables, plots and folders."""

from __future__ import annotations

import argparse
import os
import platform
import sys
import tempfile
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

FOLDER = "NEARFAR_BENCH_OUT"
"""Environment variable that names the folder for plots; without it none are made. `scripts/bench.py` sets it."""


def make_folder(name: str) -> Path:
    """Make the folder that an option names."""
    Path(name).mkdir(parents=True, exist_ok=True)
    return Path(name)


_TILES = "folder of tiles of the whole of Tokyo, which nf.write_tiles wrote"
SHARED: dict[str, dict[str, Any]] = {
    "--quick": {"action": "store_true", "help": "smaller inputs and fewer of them"},
    "--plots": {"type": make_folder, "help": f"folder for plots and pictures; by default {FOLDER}"},
    "--out": {"type": make_folder, "help": f"folder for plots and pictures; by default {FOLDER}"},
    "--tiles": {"help": _TILES},
    "--trees": {"type": make_folder, "help": "folder that keeps trees; by default a temporary one"},
    "tree": {"type": Path, "help": "store that nf.orthoview.build wrote"},
}
"""Options that several benchmarks have, by their names on the command line."""


def start(doc: str | None, *shared: str, **own: Any) -> argparse.Namespace:
    """Read the options of a benchmark from the command line, and print the machine.

    `doc` is the module's description; `shared` are names of `SHARED`; `own` are further options by name.
    Each is given as its default, which also sets its type; as a type, if there is no default; as a pair of either and a
    help text; or as settings of `ArgumentParser.add_argument`, which without "default" or "type" are positional.
    """
    own_name = getattr(sys.modules["__main__"].__spec__, "name", None)
    parser = argparse.ArgumentParser(
        own_name and f"python -m {own_name}", description=doc, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    for name in shared:
        parser.add_argument(name, **SHARED[name])
    if "--plots" in shared or "--out" in shared:
        parser.set_defaults(plots=os.environ.get(FOLDER), out=os.environ.get(FOLDER))
    for name, value in own.items():
        settings = value if isinstance(value, dict) else _settings(*(value if isinstance(value, tuple) else (value,)))
        is_option = "default" in settings or "type" in settings
        parser.add_argument(f"--{name.replace('_', '-')}" if is_option else name, **settings)
    options = parser.parse_args()
    print(machine(), end="\n\n", flush=True)
    return options


def _settings(default: Any, text: str | None = None) -> dict[str, Any]:
    """Settings of an argument from its default or its type."""
    if default is bool:
        return {"action": "store_true", "default": False, "help": text}
    if isinstance(default, type):
        return {"type": default, "default": None, "help": text}
    if isinstance(default, list):
        return {"nargs": "*", "type": type(default[0]), "default": default, "help": text}
    return {"type": type(default), "default": default, "help": text}


def machine() -> str:
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
    return f"{platform.machine()}, {cores} cores, {platform.system()}, Python {platform.python_version()}"


def table(title: str, header: str | Sequence[str], rows: Iterable[Iterable[Any]]) -> str:
    """Format a Markdown table under a title.

    The header has the columns' titles, as a sequence or as one text separated by " | ". A format in braces may end a
    title: the values of "seconds {:.2f}" have two decimals. Strings among the values are not formatted, None makes an
    empty cell, and a tuple fills several braces.
    """
    columns = [title.partition(" {") for title in (header.split(" | ") if isinstance(header, str) else header)]
    titles, formats = [name for name, _, _ in columns], [brace.strip() + rest for _, brace, rest in columns]
    cells = [[_cell(value, form) for value, form in zip(row, formats, strict=True)] for row in rows]
    lines = [f"### {title}", "", *(f"| {' | '.join(line)} |" for line in (titles, *cells))]
    return "\n".join([*lines[:3], "|" + " --- |" * len(titles), *lines[3:], ""])


def _cell(value: object, form: str) -> str:
    if value is None or isinstance(value, str):
        return value or ""
    return (form or "{}").format(*(value if isinstance(value, tuple) else (value,)))


@contextmanager
def folder_or_temporary(folder: Path | None = None) -> Iterator[Path]:
    """Yield a folder that was named, or else a temporary one."""
    with tempfile.TemporaryDirectory() as name:
        yield Path(name) if folder is None else make_folder(str(folder))


def subplots(rows: int = 1, columns: int = 1, **settings: Any) -> tuple[Any, Any]:
    """Return a figure without a screen, and its axes."""
    import matplotlib as mpl

    mpl.use("agg")
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(rows, columns, **{"layout": "constrained", **settings})
    return figure, axes


def save_figure(figure: Any, path: Path, dpi: int = 100, **settings: Any) -> None:
    """Write a figure into a folder, which is made, and close it."""
    from matplotlib import pyplot

    path.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path, dpi=dpi, **settings)
    pyplot.close(figure)
