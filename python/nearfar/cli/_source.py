"""Reduced scenes in folders, and the scenes that they were made from."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import nearfar as nf
from nearfar._base import check, formats
from nearfar.cli import _options as options
from nearfar.cli._viewpoint import Stand


def refuse(reason: str, **given: object) -> None:
    """Raise ValueError for options that do not fit a folder, given by name with underscores; None means absent."""
    for name, value in given.items():
        if value is not None:
            raise ValueError(f"--{name.replace('_', '-')}: expected none with a folder as -i, {reason}")


def report_of(folder: str) -> dict[str, Any]:
    """Return the report of `nearfar reduce` beside a reduced scene; empty if there is none."""
    path = Path(folder) / "report.json"
    if not path.is_file():
        return {}
    try:
        document = formats.from_json(path.read_text(encoding="utf-8"))
    except ValueError:
        return {}
    return document if isinstance(document, dict) else {}


def view_of(folder: str) -> Stand | None:
    """Return the view of the pictures beside a reduced scene from its report; None without a report."""
    report = report_of(folder)
    try:
        user, target = (check.vector(name, report[name]) for name in ("user", "target"))
    except (KeyError, TypeError, ValueError):
        return None
    return Stand(user, target, True) if user != target else None


def open_truth(
    folder: str,
    truth: str | None,
    *,
    up: str,
    on_invalid: str,
    scale: float | None,
    max_bytes: int | None = None,
    blend: str = "opaque",
    parts: Mapping[str, Any] = options.WHOLE,
) -> tuple[str, nf.Scene]:
    """Open the original scene of a folder, from `truth` or its report; also return its name."""
    if truth is not None:
        return truth, options.open_scene(
            truth, up=up, on_invalid=on_invalid, scale=scale, max_bytes=max_bytes, blend=blend, parts=parts
        )
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
            max_bytes=max_bytes,
            blend=str(report.get("blend", blend)),
            parts=_parts_of(report) | {name: value for name, value in parts.items() if value is not None},
        )
    except FileNotFoundError:
        raise ValueError(f"--truth: expected the scene that {folder} was made from; {source} is not there") from None
    return source, loaded


def _parts_of(report: dict[str, Any]) -> dict[str, Any]:
    """Return the selected part of a tileset or a city from a report."""
    stated = report.get("parts")
    known = stated if isinstance(stated, dict) else {}
    return {name: known.get(name) for name in options.WHOLE}
