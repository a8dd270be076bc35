"""Reports as pages in Markdown and HTML, and their pictures and plots."""

from __future__ import annotations

import base64
import html
import importlib.util
from dataclasses import dataclass
from importlib import resources
from pathlib import Path
from string import Template
from typing import TYPE_CHECKING, Any
from xml.etree.ElementTree import Element, SubElement, tostring

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from nearfar._base import formats
from nearfar.cli._output import count
from nearfar.stereo._differences import EyeDifference

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

BROKEN = ("not met", "not measured")
"""A table row is highlighted if its last cell is one of these texts."""

CAPTION = 0.07
"""Height of a caption as a share of the picture's height."""

TITLES = {
    "truth": "truth: the whole scene",
    "conventional": "conventional: near geometry and map, not joined",
    "continuous": "continuous: near-far morph",
    "impostors": "impostors: near geometry and textured quads",
    "published": "continuous, with the published ratio of radii",
}
"""Captions of the pictures."""


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
        return fill("report.html", title=html.escape(self.title), body=tostring(body, "unicode", "html"))


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
    """Return the table of notes on parts that are drawn differently than in the file, by heading; empty if none."""
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
    """Add an element with a text, highlighted if `is_broken`."""
    child = SubElement(parent, tag, {"class": "broken"} if is_broken else {})
    child.text = text
    return child


def _add_row(parent: Element, tag: str, cells: list[str]) -> None:
    row = _add(parent, "tr", is_broken=cells[-1] in BROKEN)
    for cell in cells:
        _add(row, tag, cell)


def save_pictures(folder: Path, pictures: dict[str, NDArray[np.uint8]]) -> None:
    """Save each picture, and all of them side by side under captions, more than three in two rows."""
    from PIL import Image

    for name, picture in pictures.items():
        Image.fromarray(picture).save(folder / f"{name}.png")
    captioned = [caption(picture, TITLES[name]) for name, picture in pictures.items()]
    columns = len(captioned) if len(captioned) <= 3 else (len(captioned) + 1) // 2
    height, width = (side + 6 for side in captioned[0].shape[:2])
    sheet = np.full((-(-len(captioned) // columns) * height - 6, columns * width - 6, 3), 255, np.uint8)
    for number, picture in enumerate(captioned):
        top, left = number // columns * height, number % columns * width
        sheet[top : top + height - 6, left : left + width - 6] = picture
    Image.fromarray(sheet).save(folder / "side_by_side.png", optimize=True)


def caption(picture: NDArray[np.uint8], text: str) -> NDArray[np.uint8]:
    """Add a bar with a text above a picture (H, W, 3)."""
    from PIL import Image, ImageDraw, ImageFont

    height, width = picture.shape[:2]
    bar = max(14, round(CAPTION * height))
    canvas = Image.new("RGB", (width, height + bar), "white")
    canvas.paste(Image.fromarray(picture), (0, bar))
    draw, size = ImageDraw.Draw(canvas), 0.62 * bar
    font = ImageFont.load_default(size)
    while draw.textlength(text, font=font) > 0.98 * width and size > 6.0:
        size *= 0.9
        font = ImageFont.load_default(size)
    draw.text((width / 2, bar / 2), text, fill="black", font=font, anchor="mm")
    return np.asarray(canvas)


def make_plot(height: float, *, right: float = 0.98) -> tuple[Figure, Axes]:
    """Make a plot 7 by `height` inches with fixed margins: fitting them takes longer than drawing."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(7.0, height))
    figure.subplots_adjust(left=0.11, right=right, bottom=0.54 / height, top=1.0 - 0.12 / height)
    return figure, figure.subplots()


def save_curve(folder: Path, curve: nf.LoadCurve, r2: float) -> bool:
    """Plot the load curve with r2 marked; return False if matplotlib is not installed."""
    if not importlib.util.find_spec("matplotlib"):
        return False
    figure, axes = make_plot(4.5, right=0.88)
    curve.plot(axes)
    axes.axvline(r2, color="0.5", linestyle=":", label=f"$r_2$ = {r2:g} m")
    axes.legend(loc="best", fontsize="small")
    figure.savefig(folder / "load_curve.png", dpi=130)
    return True


def save_heat_maps(folder: Path, maps: dict[str, NDArray[np.float32]]) -> None:
    """Plot maps of discontinuity (H, W) side by side on one scale, up to the greatest 99th percentile."""
    from matplotlib.figure import Figure

    greatest = max(float(np.nanpercentile(torn, 99)) if np.isfinite(torn).any() else 0.0 for torn in maps.values())
    height, width = next(iter(maps.values())).shape
    figure = Figure(figsize=(7.0 * len(maps), 7.0 * height / width + 0.6), layout="constrained")
    axes = figure.subplots(1, len(maps), squeeze=False)[0]
    for ax, (name, torn) in zip(axes, maps.items(), strict=True):
        ax.set_facecolor("0.85")
        image = ax.imshow(torn, cmap="inferno", vmin=0.0, vmax=max(greatest, 1e-3), interpolation="nearest")
        ax.set(title=name, xticks=[], yticks=[])
    figure.colorbar(image, ax=list(axes), label="discontinuity", shrink=0.9)
    figure.savefig(folder / "discontinuity.png", dpi=110)


def save_eyes(
    folder: Path,
    hybrid: nf.StereoFrame,
    plain: nf.StereoFrame,
    compared: dict[str, EyeDifference],
    rig: nf.stereo.HybridRig,
) -> bool:
    """Write all pictures; return False if the error could not be plotted, because matplotlib is not installed."""
    from PIL import Image

    hybrid.left.save(folder / "left.png")
    hybrid.right.save(folder / "right.png")
    hybrid.save(folder / "side_by_side.png")
    plain.save(folder / "plain_side_by_side.png")
    Image.fromarray(hybrid.anaglyph).save(folder / "anaglyph.png")
    if hybrid.center is not None:
        hybrid.center.save(folder / "center.png")
    grey = np.concatenate([difference.picture for difference in compared.values()], axis=1)
    Image.fromarray(grey).save(folder / "differences.png")
    if not importlib.util.find_spec("matplotlib"):
        return False
    _plot_error(folder / "error.png", rig)
    return True


def _plot_error(path: Path, rig: nf.stereo.HybridRig) -> None:
    plane = rig.planes[0]
    depths = np.geomspace(plane, 100.0 * plane, 200)
    figure, axes = make_plot(4.0)
    for axis in ("horizontal", "vertical"):
        axes.plot(depths, [rig.max_error(depth, axis) for depth in depths], label=axis)
    axes.axhline(rig.max_error(), color="0.7", linewidth=0.8, linestyle="--")
    axes.set(xscale="log", xlabel="depth in metres", ylabel="greatest error in pixels", ylim=(0.0, None))
    axes.legend()
    figure.savefig(path, dpi=110)
