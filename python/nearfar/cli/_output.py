"""Output of commands: JSON documents, tables, timing, and the formatting of numbers."""

from __future__ import annotations

import contextlib
import math
import time
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import typer

from nearfar._base import files, formats, progress


@dataclass
class Clock:
    """Wall-clock time of each step, seconds."""

    seconds: dict[str, float] = field(default_factory=dict)

    @contextlib.contextmanager
    def step(self, name: str) -> Iterator[None]:
        """Measure the time of a step, and name it in lines of progress."""
        started = time.perf_counter()
        with progress.step(name):
            yield
        self.seconds[name] = round(time.perf_counter() - started, 3)


def show(document: dict[str, Any], rows: Iterable[tuple[str, str]], *, title: str, as_json: bool) -> None:
    """Print a document on standard output, as JSON or as a table of rows."""
    if as_json:
        typer.echo(formats.to_json(document), nl=False)
        return
    from rich import box
    from rich.console import Console
    from rich.table import Table

    table = Table(title=title, box=box.SIMPLE, show_header=False, title_justify="left")
    table.add_column(style="dim")
    table.add_column(justify="left", overflow="fold")
    for label, value in rows:
        table.add_row(label, value)
    Console().print(table)


def check_target(path: Path, *suffixes: str) -> None:
    """Reject a path that cannot be written or has another suffix, before the work starts."""
    if path.suffix.lower() not in suffixes:
        raise ValueError(f"{path}: expected a name ending in {' or '.join(suffixes)}")
    files.check_writable(files.atomic_file(path))


def check_folder(path: Path) -> None:
    """Reject a new folder whose parent is missing or cannot be written, before the work starts."""
    if not path.exists():
        files.check_writable(files.atomic_folder(path))


def count(value: int) -> str:
    return f"{value:,}"


def triangles_text(document: dict[str, Any]) -> str:
    """Format the numbers of triangles before and after a reduction."""
    before, after = document["triangles"], document["triangles_left"]
    word = ", no reduction" if before == after else ", hardly a reduction" if after > 0.9 * before else ""
    return f"{count(before)} → {count(after)}{word}"


def note_rows(document: dict[str, Any]) -> list[tuple[str, str]]:
    """Return table rows for findings about a result, and for parts of the file that are drawn differently."""
    notes = document["notes"]
    return [
        *(("note", finding) for finding in document.get("findings", [])),
        *(("drawn differently" if not number else "", note) for number, note in enumerate(notes)),
    ]


def radii_rows(document: dict[str, Any]) -> list[tuple[str, str]]:
    """Return table rows for the radii and the reason for them."""
    reason = document["radii_reason"]
    return [("radii", f"r1 = {document['r1']:g} m, r2 = {document['r2']:g} m"), *([("", reason)] if reason else [])]


def rounded(value: float | None, digits: int = 6) -> float | None:
    """Round a measure for a document; None for a missing or an infinite one."""
    return None if value is None or math.isinf(value) else round(value, digits)


def reduction_texts(document: dict[str, Any]) -> dict[str, str]:
    """Format the values of a reduction that the templates of reports contain."""
    texts = {name: count(document[name]) for name in ("triangles", "triangles_left")}
    texts |= {name: metres(document[name]) for name in ("center", "user")}
    face_size, map_bytes = str(document["face_size"]), map_text(document)
    reason = f" ({document['radii_reason']})" if document["radii_reason"] else ""
    radii = f"r₁ = {document['r1']:g} m, r₂ = {document['r2']:g} m{reason}"
    return texts | {"face_size": face_size, "map_bytes": map_bytes, "radii": radii}


def map_text(document: dict[str, Any]) -> str:
    """Format the size of a map in memory, and of its file if there is one."""
    sizes = [f"{bytes_text(document['map_bytes'])} in memory"]
    if document.get("map_file_bytes"):
        sizes.append(f"{bytes_text(document['map_file_bytes'])} on disk")
    return ", ".join(sizes)


def bytes_text(value: float) -> str:
    """Format a number of bytes with a suitable unit."""
    for unit in ("bytes", "kB", "MB"):
        if value < 1000.0:
            return f"{value:.0f} {unit}" if unit == "bytes" else f"{value:.3g} {unit}"
        value /= 1000.0
    return f"{value:.3g} GB"


def metres(values: Iterable[float]) -> str:
    """Format a position or extents in metres, to a millimetre or six digits: a centre can be pasted into `--center`."""
    return ",".join(f"{value:.3f}" if abs(value) >= 1000.0 else f"{value:.6g}" for value in values) + " m"
