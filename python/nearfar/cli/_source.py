"""Reduced scenes in folders, and the scenes that they were made from."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import nearfar as nf
from nearfar._base import check, formats
from nearfar.cli._scenes import PARTS, open_scene
from nearfar.cli._viewpoint import Stand


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


def open_truth(folder: str, truth: str | None, loading: nf.LoadOptions) -> tuple[str, nf.Scene]:
    """Open the original scene of a folder, from `truth` or its report; also return its name."""
    if truth is not None:
        return truth, open_scene(truth, loading)
    report = report_of(folder)
    source = report.get("source")
    if not isinstance(source, str):
        raise ValueError(f"--truth: expected the scene that {folder} was made from, which no report.json names there")
    try:
        stated = _stated(report, loading)
    except (TypeError, ValueError) as error:
        raise ValueError(f"{folder}/report.json: {error}") from None
    try:
        return source, open_scene(source, stated)
    except FileNotFoundError:
        raise ValueError(f"--truth: expected the scene that {folder} was made from; {source} is not there") from None


def _stated(report: dict[str, Any], loading: nf.LoadOptions) -> nf.LoadOptions:
    """Return options with those that a report states; options given for a part of a tileset or a city stay."""
    parts = report.get("parts")
    stated = {name: report.get(name) for name in ("up", "scale", "on_invalid", "blend")}
    if isinstance(parts, dict):
        stated |= {name: parts.get(name) for name in PARTS if getattr(loading, name) is None}
    options: dict[str, Any] = {name: value for name, value in stated.items() if value is not None}
    return replace(loading, **options)
