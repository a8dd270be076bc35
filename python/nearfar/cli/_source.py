"""Reduced scenes that commands read from a folder, and the scenes that they were made from."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import nearfar as nf
from nearfar.cli import _options as options


def refuse(reason: str, **given: object) -> None:
    """Raise ValueError for options that do not fit a folder, by their names with underscores; None was not given."""
    for name, value in given.items():
        if value is not None:
            raise ValueError(f"--{name.replace('_', '-')}: expected none with a folder as -i, {reason}")


def report_of(folder: str) -> dict[str, Any]:
    """Return the report that `nearfar reduce` wrote beside a reduced scene; empty if there is none."""
    path = Path(folder) / "report.json"
    if not path.is_file():
        return {}
    try:
        document = json.loads(path.read_text(encoding="utf-8"))
    except ValueError:
        return {}
    return document if isinstance(document, dict) else {}


def open_truth(
    folder: str, truth: str | None, *, up: str, on_invalid: str, scale: float | None
) -> tuple[str, nf.Scene]:
    """Open the scene that a folder was made from, `truth` or what its report names; also returns its name."""
    if truth is not None:
        return truth, options.open_scene(truth, up=up, on_invalid=on_invalid, scale=scale)
    report = report_of(folder)
    source = report.get("source")
    if not isinstance(source, str):
        raise ValueError(f"--truth: expected the scene that {folder} was made from, which no report.json names there")
    try:
        stated = report.get("scale", scale)
        loaded = options.open_scene(
            source,
            up=str(report.get("up", up)),
            on_invalid=str(report.get("on_invalid", on_invalid)),
            scale=stated if isinstance(stated, float) else scale,
        )
    except FileNotFoundError:
        raise ValueError(f"--truth: expected the scene that {folder} was made from; {source} is not there") from None
    return source, loaded
