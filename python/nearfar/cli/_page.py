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

BROKEN = ("not met", "not measured")
"""Last cells of table rows that are highlighted."""


@dataclass(frozen=True)
class Page:
    """A report."""

    title: str
    paragraphs: list[str]
    """Paragraphs; those that begin with "Note: " are highlighted."""
    pictures: list[tuple[str, str]]
    """File names in the report's folder, and captions."""
    tables: dict[str, list[list[str]]]
    """Table rows by heading; the first row of each is its header."""
    generator: str

    def save(self, folder: Path) -> None:
        """Write report.md and report.html."""
        (folder / "report.md").write_text(self.markdown(), encoding="utf-8")
        (folder / "report.html").write_text(self.html(folder), encoding="utf-8")

    def markdown(self) -> str:
        """Format the report as Markdown."""
        lines = [f"# {self.title}", ""]
        for paragraph in self.paragraphs:
            lines += [paragraph, ""]
        lines += [line for name, caption in self.pictures for line in (f"![{caption}]({name})", "")]
        for heading, rows in self.tables.items():
            lines += [f"## {heading}", "", table(*rows), ""]
        return "\n".join([*lines, f"Written by {self.generator}.", ""])

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
        _add(body, "footer", f"Written by {self.generator}.")
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


def save(folder: Path, name: str, document: dict[str, object], page: Page) -> None:
    """Write a document and its report pages."""
    formats.write_json(folder / name, document)
    page.save(folder)


def _add(parent: Element, tag: str, text: str = "", *, is_broken: bool = False) -> Element:
    """Add an element with a text; broken ones are highlighted."""
    child = SubElement(parent, tag, {"class": "broken"} if is_broken else {})
    child.text = text
    return child


def _add_row(parent: Element, tag: str, cells: list[str]) -> None:
    """Add a row of a table with cells of this tag."""
    row = _add(parent, "tr", is_broken=cells[-1] in BROKEN)
    for cell in cells:
        _add(row, tag, cell)
