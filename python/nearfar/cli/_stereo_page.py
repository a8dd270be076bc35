"""Report of `nearfar stereo`: text and tables."""

from __future__ import annotations

import math
from typing import Any

import nearfar as nf
from nearfar.cli._output import count, metres
from nearfar.cli._page import Page, paragraphs

DEPTHS = (1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0, 128.0, 1000.0, math.inf)
"""Depths of the listed errors, metres."""

PICTURES = {
    "side_by_side.png": "Left and right eye",
    "anaglyph.png": "Both eyes, for red–cyan glasses",
    "center.png": "The shared picture; pixels that no eye looks up are black",
    "differences.png": "Difference from plain stereo, and (1 − SSIM) × 10, of both eyes",
    "error.png": "Error against depth",
}
"""Captions of the pictures."""


def plane_of(document: dict[str, Any]) -> str:
    """Describe the position of the mono plane."""
    end = document["zone_end"]
    return f"{document['mono_plane']:g} m" + ("" if end is None else f", lines bend up to {end:g} m")


def page(document: dict[str, Any], rig: nf.stereo.HybridRig) -> Page:
    """Make the report's page."""
    eyes, pixels, seconds = document["eyes"], document["pixels"], document["seconds"]
    tables = {
        "Against plain stereo": [
            ["measure", "left", "right"],
            ["SSIM", *(f"{eyes[side]['ssim']:.5f}" for side in eyes)],
            ["PSNR, dB", *("∞" if eyes[side]["psnr"] is None else f"{eyes[side]['psnr']:.2f}" for side in eyes)],
        ],
        "Greatest error by depth": [
            ["depth", "to the side, pixels", "upwards, pixels"],
            *(
                ["∞" if math.isinf(depth) else f"{depth:g} m", *(f"{rig.max_error(depth, a):.2f}" for a in _AXES)]
                for depth in DEPTHS
            ),
        ],
        "Pixels": [
            ["picture", "pixels"],
            *([_PIXELS[name], count(pixels[name])] for name in _PIXELS if name in pixels),
        ],
        "Time": [
            ["stage", "seconds"],
            *([name, f"{value:.3f}"] for name, value in document["stages"].items()),
            ["hybrid, all", f"{seconds['hybrid']:.3f}"],
            ["plain stereo", f"{seconds['plain']:.3f}"],
        ],
    }
    if document["triangles"]:
        tables["Triangles"] = [
            ["drawn for", "triangles"],
            *([_TRIANGLES[name], count(document["triangles"][name])] for name in _TRIANGLES),
        ]
    if document["notes"]:
        tables["Not drawn as in the file"] = [["note"], *([note] for note in document["notes"])]
    width, height = document["size"]
    summary = [
        *(f"Note: {finding}." for finding in document["findings"]),
        *paragraphs(
            "stereo.md",
            hmd=document["hmd"],
            width=width,
            height=height,
            head=metres(document["head"]),
            plane=plane_of(document),
            assembly=document["assembly"],
        ),
    ]
    shown = [(name, caption) for name, caption in PICTURES.items() if name in document["files"]]
    return Page(f"Hybrid mono-stereo of {document['source']}", summary, shown, tables, document["generator"])


_AXES = ("horizontal", "vertical")
_PIXELS = {
    "left": "left eye, own surfaces",
    "right": "right eye, own surfaces",
    "center": "shared, drawn",
    "discarded": "shared, not looked up",
}
_TRIANGLES = {
    "left": "the left eye",
    "right": "the right eye",
    "center": "the shared picture",
    "thrice": "all three, across the plane",
    "plain": "plain stereo, both eyes",
}
