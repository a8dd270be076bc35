"""Writes the files of `nearfar compare`: heat maps, and the report as Markdown and as one HTML page."""

from __future__ import annotations

import base64
import html
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base import formats
from nearfar.cli import _thresholds
from nearfar.cli._output import bytes_text, count, metres, radii_text

MEASURES = {
    "tear": "tear along the boundary at r₂, pixels",
    "tear_kink": "of which change of slope",
    "psnr": "PSNR, dB",
    "ssim": "SSIM",
    "rmse": "RMSE",
    "discontinuity": "discontinuity δ, mean",
    "discontinuity_p99": "discontinuity δ, 99th percentile",
    "boundary": "discontinuity δ along the boundary at r₂",
}
"""Labels of the measures."""

PARADOX = (
    "PSNR and SSIM compare pixel by pixel: they often prefer the conventional picture, which is right inside r₂ and "
    "broken at it, to one that bends a little everywhere. Tear says by how many pixels of a headset, 20 for each "
    "degree, neighbours along r₂ are torn apart; a change of slope, which is no tear, is the second line. The "
    "published discontinuity δ compares distances over 17 pixels and counts shear, too."
)

PICTURES = {
    "side_by_side.png": "Truth, conventional and continuous",
    "discontinuity.png": "Discontinuity of both methods, on one scale",
    "load_curve.png": "Triangles left as geometry",
}
"""Captions of the pictures."""

STYLE = """
body { font: 16px/1.5 system-ui, sans-serif; color: #222; max-width: 72rem; margin: 2rem auto; padding: 0 1rem }
h1 { font-size: 1.6rem } h2 { font-size: 1.2rem; margin-top: 2rem } img { max-width: 100%; height: auto }
table { border-collapse: collapse; margin: 1rem 0 } th, td { padding: .3rem .9rem; border-bottom: 1px solid #ddd }
td + td, th + th { text-align: right; font-variant-numeric: tabular-nums } th { text-align: left; color: #555 }
.broken { color: #b00020; font-weight: 600 } footer { margin-top: 3rem; color: #777; font-size: .9rem }
"""


def save_heat_maps(folder: Path, maps: dict[str, NDArray[np.float32]]) -> None:
    """Draw maps of discontinuity (H, W) side by side on one scale, up to the greatest 99th percentile."""
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


def text(value: float | None) -> str:
    """Format a measure with four digits; a dash for None."""
    return "–" if value is None else f"{value:.4g}"


def _percent(share: float | None) -> str:
    return "–" if share is None else f"{100 * share:.0f} %"


def save(folder: Path, document: dict[str, Any]) -> None:
    """Write compare.json, report.md and report.html."""
    formats.write_json(folder / "compare.json", document)
    (folder / "report.md").write_text(markdown(document), encoding="utf-8")
    (folder / "report.html").write_text(page(document, folder), encoding="utf-8")


def _tables(document: dict[str, Any]) -> dict[str, list[list[str]]]:
    """Make the report's tables by title; the first row of each is its header."""
    pictures = document["pictures"]
    tables = {
        "Against the truth": [
            ["measure", *pictures],
            *([label, *(text(values[key]) for values in pictures.values())] for key, label in MEASURES.items()),
            ["boundary pixels that see both sides", *(_percent(values["tear_shared"]) for values in pictures.values())],
            ["pixels along the boundary", *(count(values["boundary_pixels"]) for values in pictures.values())],
        ],
        "Triangles left": [
            ["within", "triangles"],
            *([f"{entry['radius']:g} m", count(entry["triangles"])] for entry in document["load_curve"]),
        ],
        "Time": [["step", "seconds"], *([name, f"{value:.2f}"] for name, value in document["seconds"].items())],
    }
    if document["notes"]:
        tables["Not drawn as in the file"] = [["note"], *([note] for note in document["notes"])]
    if document["thresholds"]:
        rows = [
            [check["option"], f"{check['limit']:.4g}", text(check["value"]), _thresholds.result(check)]
            for check in document["thresholds"]
        ]
        tables["Thresholds"] = [["threshold", "limit", "continuous", "result"], *rows]
    return tables


def _summary(document: dict[str, Any]) -> list[str]:
    margin = document["fold_margin"]
    folds = (
        "the picture has folded"
        if margin is None or margin < 0
        else f"the picture folds {margin:.1f} m farther away from O"
    )
    return [
        *(f"Note: {note}." for note in (document["unit_note"], *document["findings"]) if note),
        f"{count(document['triangles'])} triangles become {count(document['triangles_left'])} and a cube map of 6 × "
        f"{document['face_size']}² texels ({bytes_text(document['map_bytes'])}). Method: {document['method']}.",
        f"Centre O at {metres(document['center'])}; user U at {metres(document['user'])}; {radii_text(document)}; "
        f"{folds}.",
        PARADOX,
    ]


def markdown(document: dict[str, Any]) -> str:
    """Format the report as Markdown."""
    lines = [f"# Near-far comparison of {document['source']}", ""]
    for paragraph in _summary(document):
        lines += [paragraph, ""]
    lines += [line for name, title in _shown(document) for line in (f"![{title}]({name})", "")]
    for title, (header, *rows) in _tables(document).items():
        lines += [f"## {title}", "", f"| {' | '.join(header)} |", f"| --- |{' ---: |' * (len(header) - 1)}"]
        lines += [f"| {' | '.join(row)} |" for row in rows] + [""]
    return "\n".join([*lines, f"Written by {document['generator']}.", ""])


def page(document: dict[str, Any], folder: Path) -> str:
    """Format the report as one HTML page that embeds its pictures."""
    title = html.escape(f"Near-far comparison of {document['source']}")
    parts = [f"<h1>{title}</h1>", *map(_paragraph, _summary(document))]
    for name, caption in _shown(document):
        data = base64.b64encode((folder / name).read_bytes()).decode("ascii")
        parts.append(f"<h2>{caption}</h2><img alt='{caption}' src='data:image/png;base64,{data}'>")
    for heading, (header, *rows) in _tables(document).items():
        head = "".join(f"<th>{html.escape(cell)}</th>" for cell in header)
        body = "".join(f"<tr{_class(row)}>{''.join(f'<td>{html.escape(c)}</td>' for c in row)}</tr>" for row in rows)
        parts.append(f"<h2>{heading}</h2><table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>")
    parts.append(f"<footer>Written by {html.escape(document['generator'])}.</footer>")
    head = f"<meta charset='utf-8'><meta name='viewport' content='width=device-width'><title>{title}</title>"
    return (
        f"<!doctype html><html lang='en'><head>{head}<style>{STYLE}</style></head><body>{''.join(parts)}</body></html>"
    )


def _paragraph(text: str) -> str:
    mark = " class='broken'" if text.startswith("Note: ") else ""
    return f"<p{mark}>{html.escape(text)}</p>"


def _class(row: list[str]) -> str:
    return " class='broken'" if row[-1] in ("not met", "not measured") else ""


def _shown(document: dict[str, Any]) -> list[tuple[str, str]]:
    return [(name, title) for name, title in PICTURES.items() if name in document["files"]]
