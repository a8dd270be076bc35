"""Report pages: a title, paragraphs, pictures and tables, as Markdown and as one HTML page."""

from __future__ import annotations

import base64
import html
from dataclasses import dataclass
from pathlib import Path

from nearfar._base import formats

STYLE = """
body { font: 16px/1.5 system-ui, sans-serif; color: #222; max-width: 72rem; margin: 2rem auto; padding: 0 1rem }
h1 { font-size: 1.6rem } h2 { font-size: 1.2rem; margin-top: 2rem } img { max-width: 100%; height: auto }
table { border-collapse: collapse; margin: 1rem 0 } th, td { padding: .3rem .9rem; border-bottom: 1px solid #ddd }
td + td, th + th { text-align: right; font-variant-numeric: tabular-nums } th { text-align: left; color: #555 }
.broken { color: #b00020; font-weight: 600 } footer { margin-top: 3rem; color: #777; font-size: .9rem }
"""

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
        for heading, (header, *rows) in self.tables.items():
            lines += [f"## {heading}", "", f"| {' | '.join(header)} |", f"| --- |{' ---: |' * (len(header) - 1)}"]
            lines += [f"| {' | '.join(row)} |" for row in rows] + [""]
        return "\n".join([*lines, f"Written by {self.generator}.", ""])

    def html(self, folder: Path) -> str:
        """Format the report as one HTML page that embeds its pictures."""
        title = html.escape(self.title)
        parts = [f"<h1>{title}</h1>", *map(_paragraph, self.paragraphs)]
        for name, caption in self.pictures:
            data = base64.b64encode((folder / name).read_bytes()).decode("ascii")
            parts.append(f"<h2>{caption}</h2><img alt='{caption}' src='data:image/png;base64,{data}'>")
        for heading, (header, *rows) in self.tables.items():
            head = "".join(f"<th>{html.escape(cell)}</th>" for cell in header)
            body = "".join(
                f"<tr{_class(row)}>{''.join(f'<td>{html.escape(c)}</td>' for c in row)}</tr>" for row in rows
            )
            parts.append(f"<h2>{heading}</h2><table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>")
        parts.append(f"<footer>Written by {html.escape(self.generator)}.</footer>")
        head = f"<meta charset='utf-8'><meta name='viewport' content='width=device-width'><title>{title}</title>"
        return (
            f"<!doctype html><html lang='en'><head>{head}<style>{STYLE}</style></head>"
            f"<body>{''.join(parts)}</body></html>"
        )


def save(folder: Path, name: str, document: dict[str, object], page: Page) -> None:
    """Write a document and its report pages."""
    formats.write_json(folder / name, document)
    page.save(folder)


def _paragraph(text: str) -> str:
    mark = " class='broken'" if text.startswith("Note: ") else ""
    return f"<p{mark}>{html.escape(text)}</p>"


def _class(row: list[str]) -> str:
    return " class='broken'" if row[-1] in BROKEN else ""
