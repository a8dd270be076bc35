"""Report pages: a title, paragraphs, pictures and tables, as Markdown and as one HTML page."""

from __future__ import annotations

import base64
import html
from dataclasses import dataclass
from importlib import resources
from pathlib import Path
from string import Template
from typing import Any
from xml.etree.ElementTree import Element, SubElement, tostring

from nearfar._base import formats
from nearfar.cli._output import count

BROKEN = ("not met", "not measured")
"""Last cells of table rows that are highlighted."""


@dataclass(frozen=True)
class Page:
    """A report, and the document from which it is made."""

    document: dict[str, Any]
    title: str
    paragraphs: list[str]
    """Paragraphs; those that begin with "Note: " are highlighted."""
    captions: dict[str, str]
    """Captions of pictures by their file names in the report's folder; pictures without a file are left out."""
    tables: dict[str, list[list[str]]]
    """Table rows by heading; the first row of each is its header."""

    @property
    def pictures(self) -> list[tuple[str, str]]:
        """File names of the pictures that were made, and their captions."""
        return [(name, caption) for name, caption in self.captions.items() if name in self.document["files"]]

    @property
    def footer(self) -> str:
        return f"Written by {self.document['generator']}."

    def save(self, folder: Path, name: str) -> None:
        """Write the document, report.md and report.html."""
        formats.write_json(folder / name, self.document)
        (folder / "report.md").write_text(self.markdown(), encoding="utf-8")
        (folder / "report.html").write_text(self.html(folder), encoding="utf-8")

    def markdown(self) -> str:
        lines = [f"# {self.title}", ""]
        for paragraph in self.paragraphs:
            lines += [paragraph, ""]
        lines += [line for name, caption in self.pictures for line in (f"![{caption}]({name})", "")]
        for heading, rows in self.tables.items():
            lines += [f"## {heading}", "", table(*rows), ""]
        return "\n".join([*lines, self.footer, ""])

    def html(self, folder: Path) -> str:
        """Format the report as one HTML page that embeds its pictures."""
        body = Element("body")
        _add(body, "h1", self.title)
        for paragraph in self.paragraphs:
            _add(body, "p", paragraph, is_broken=paragraph.startswith("Note: "))
        for name, caption in self.pictures:
            data = base64.b64encode((folder / name).read_bytes()).decode("ascii")
            _add(body, "h2", caption)
            SubElement(body, "img", alt=caption, src=f"data:image/png;base64,{data}")
        for heading, (header, *rows) in self.tables.items():
            _add(body, "h2", heading)
            grid = SubElement(body, "table")
            _add_row(SubElement(grid, "thead"), "th", header)
            lines = SubElement(grid, "tbody")
            for row in rows:
                _add_row(lines, "td", row)
        _add(body, "footer", self.footer)
        return fill(
            "report.html", title=html.escape(self.title), body=tostring(body, encoding="unicode", method="html")
        )


def fill(template: str, **values: Any) -> str:
    """Return a template of this package with its $names replaced by values."""
    text = (resources.files("nearfar") / "cli" / "templates" / template).read_text(encoding="utf-8")
    return Template(text).substitute(values)


def paragraphs(template: str, **values: Any) -> list[str]:
    """Return the paragraphs of a filled template, each as one line."""
    return [" ".join(text.split()) for text in fill(template, **values).split("\n\n")]


def table(header: list[str], *rows: list[str]) -> str:
    """Format a table as Markdown; all columns but the first hold numbers."""
    lines = [header, ["---", *["---:"] * (len(header) - 1)], *rows]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def notes_table(document: dict[str, Any]) -> dict[str, list[list[str]]]:
    """Return the table of notes about differences from the file, by its heading; empty without notes."""
    notes = document["notes"]
    return {"Not drawn as in the file": [["note"], *([note] for note in notes)]} if notes else {}


def load_curve_rows(document: dict[str, Any]) -> list[list[str]]:
    """Return the table of the load curve, header first."""
    rows = ([f"{entry['radius']:g} m", count(entry["triangles"])] for entry in document["load_curve"])
    return [["within", "triangles"], *rows]


def time_rows(document: dict[str, Any]) -> list[list[str]]:
    """Return the table of the time of each step, header first."""
    return [["step", "seconds"], *([name, f"{value:.2f}"] for name, value in document["seconds"].items())]


def _add(parent: Element, tag: str, text: str = "", *, is_broken: bool = False) -> Element:
    """Add an element with a text; broken ones are highlighted."""
    child = SubElement(parent, tag, {"class": "broken"} if is_broken else {})
    child.text = text
    return child


def _add_row(parent: Element, tag: str, cells: list[str]) -> None:
    row = _add(parent, "tr", is_broken=cells[-1] in BROKEN)
    for cell in cells:
        _add(row, tag, cell)
