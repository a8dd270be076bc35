"""The report of `nearfar compare`: heat maps, text and tables."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar.cli import _thresholds
from nearfar.cli._output import bytes_text, count, metres, radii_text
from nearfar.cli._page import Page

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


def text(value: float | None) -> str:
    """Format a measure with four digits; a dash for None."""
    return "–" if value is None else f"{value:.4g}"


def _percent(share: float | None) -> str:
    return "–" if share is None else f"{100 * share:.0f} %"


def page(document: dict[str, Any]) -> Page:
    """Make the report's page."""
    title = f"Near-far comparison of {document['source']}"
    shown = [(name, caption) for name, caption in PICTURES.items() if name in document["files"]]
    return Page(title, _summary(document), shown, _tables(document), document["generator"])


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
