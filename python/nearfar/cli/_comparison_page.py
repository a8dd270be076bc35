"""The report of `nearfar compare`: text and tables."""

from __future__ import annotations

from typing import Any

from nearfar.cli import _thresholds
from nearfar.cli._output import bytes_text, count, metres, radii_text
from nearfar.cli._page import Page, paragraphs
from nearfar.cli._report_page import load_curve_rows, time_rows

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

PICTURES = {
    "side_by_side.png": "Truth, conventional and continuous",
    "discontinuity.png": "Discontinuity of both methods, on one scale",
    "load_curve.png": "Triangles left as geometry",
}
"""Captions of the pictures."""


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
        "Triangles left": load_curve_rows(document),
        "Time": time_rows(document),
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
        *paragraphs(
            "comparison.md",
            triangles=count(document["triangles"]),
            triangles_left=count(document["triangles_left"]),
            face_size=document["face_size"],
            map_bytes=bytes_text(document["map_bytes"]),
            method=document["method"],
            center=metres(document["center"]),
            user=metres(document["user"]),
            radii=radii_text(document),
            folds=folds,
        ),
    ]
