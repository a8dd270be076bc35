"""Report of `nearfar stereo`: pictures of both eyes, difference maps, and tables."""

from __future__ import annotations

import importlib.util
import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from nearfar.cli._output import count, metres
from nearfar.cli._page import Page

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

MEANING = (
    "The shared picture is taken once, from behind the eyes, and shown to both through the mono plane: what lies "
    "beyond it is drawn once instead of twice, has no disparity, and is shown beside its place by the error below. "
    "SSIM has windows of 4 × 4 pixels, as in Fink et al. 2019."
)


@dataclass(frozen=True)
class Compared:
    """Differences between an eye's picture and plain stereo."""

    document: dict[str, Any]
    difference: NDArray[np.float32]
    """Greatest difference of a channel (H, W), sRGB codes."""
    dissimilarity: NDArray[np.float64]
    """Mean of 1 − SSIM over the channels (H, W)."""


def compare(plain: nf.Frame, hybrid: nf.Frame) -> Compared:
    """Compare one eye's pictures as sRGB codes."""
    before, after = plain.to_image(), hybrid.to_image()
    similarity = nf.ssim(before, after, data_range=255.0, window="uniform", size=4, convention="full", full=True)
    psnr = nf.psnr(before, after, data_range=255.0)
    document = {
        "ssim": round(float(similarity), 6),
        "psnr": round(psnr, 4) if math.isfinite(psnr) else None,
    }
    difference = np.abs(before.astype(np.float32) - after.astype(np.float32)).max(axis=-1)
    return Compared(document, difference, 1.0 - similarity.map.mean(axis=-1))


def save_pictures(
    folder: Path,
    hybrid: nf.StereoFrame,
    plain: nf.StereoFrame,
    compared: dict[str, Compared],
    rig: nf.stereo.HybridRig,
) -> bool:
    """Write all pictures; return False if matplotlib is not installed, without which the error is not plotted."""
    from PIL import Image

    hybrid.left.save(folder / "left.png")
    hybrid.right.save(folder / "right.png")
    hybrid.save(folder / "side_by_side.png")
    plain.save(folder / "plain_side_by_side.png")
    Image.fromarray(hybrid.anaglyph).save(folder / "anaglyph.png")
    if hybrid.center is not None:
        hybrid.center.save(folder / "center.png")
    grey = [
        np.concatenate([c.difference, 255.0 * np.clip(10.0 * c.dissimilarity, 0.0, 1.0)]) for c in compared.values()
    ]
    Image.fromarray(np.concatenate(grey, axis=1).astype(np.uint8)).save(folder / "differences.png")
    if not importlib.util.find_spec("matplotlib"):
        return False
    _plot_error(folder / "error.png", rig)
    return True


def _plot_error(path: Path, rig: nf.stereo.HybridRig) -> None:
    from matplotlib.figure import Figure

    plane = rig.planes[0]
    depths = np.geomspace(plane, 100.0 * plane, 200)
    figure = Figure(figsize=(7.0, 4.0), layout="constrained")
    axes = figure.subplots()
    for axis in ("horizontal", "vertical"):
        axes.plot(depths, [rig.max_error(depth, axis) for depth in depths], label=axis)
    axes.axhline(rig.max_error(), color="0.7", linewidth=0.8, linestyle="--")
    axes.set(xscale="log", xlabel="depth in metres", ylabel="greatest error in pixels", ylim=(0.0, None))
    axes.legend()
    figure.savefig(path, dpi=110)


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
        f"{document['hmd']}, {width} × {height} pixels an eye. Head at {metres(document['head'])}. Mono plane at "
        f"{plane_of(document)}; {document['assembly']} assembly.",
        MEANING,
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
