"""Report of `nearfar reduce`: pictures side by side, the load curve, and the text as JSON and Markdown."""

from __future__ import annotations

import importlib.util
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from nearfar._base import formats
from nearfar._reduce import default_radii
from nearfar.cli._output import bytes_text, count, metres, radii_text

CAPTION = 0.07
"""Height of a caption as a share of the picture's height."""

TITLES = {
    "truth": "truth: the whole scene",
    "conventional": "conventional: near geometry and map, not joined",
    "continuous": "continuous: near-far morph",
    "published": "continuous, with the published ratio of radii",
}
"""Captions of the pictures."""


def save_pictures(folder: Path, pictures: dict[str, NDArray[np.uint8]]) -> None:
    """Save each picture, and all of them side by side under captions."""
    from PIL import Image

    for name, picture in pictures.items():
        Image.fromarray(picture).save(folder / f"{name}.png")
    captioned = [caption(picture, TITLES[name]) for name, picture in pictures.items()]
    gap = np.full((captioned[0].shape[0], 6, 3), 255, np.uint8)
    row = [part for picture in captioned for part in (picture, gap)][:-1]
    Image.fromarray(np.concatenate(row, axis=1)).save(folder / "side_by_side.png", optimize=True)


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


def save_curve(folder: Path, curve: nf.LoadCurve, r2: float) -> bool:
    """Plot the load curve with r2 marked; return False if matplotlib is not installed."""
    if not importlib.util.find_spec("matplotlib"):
        return False
    from matplotlib.figure import Figure

    figure = Figure(figsize=(7.0, 4.5), layout="constrained")
    axes = figure.subplots()
    curve.plot(axes)
    axes.axvline(r2, color="0.5", linestyle=":", label=f"$r_2$ = {r2:g} m")
    axes.legend(loc="upper left", fontsize="small")
    figure.savefig(folder / "load_curve.png", dpi=130)
    return True


def save(folder: Path, document: dict[str, Any]) -> None:
    """Write report.json and report.md."""
    formats.write_json(folder / "report.json", document)
    (folder / "report.md").write_text(markdown(document), encoding="utf-8")


def markdown(document: dict[str, Any]) -> str:
    """Format the report as Markdown."""
    share = 100.0 * document["triangles_left"] / max(document["triangles"], 1)
    lines = [
        f"# Near-far reduction of {document['source']}",
        "",
        *([f"Note: {document['unit_note']}.", ""] if document["unit_note"] else []),
        f"{count(document['triangles'])} triangles become {count(document['triangles_left'])} ({share:.3g} %) "
        f"and a cube map of 6 × {document['face_size']}² texels ({bytes_text(document['map_bytes'])}).",
        "",
        *(line for note in document["findings"] for line in (f"**Note:** {note}.", "")),
        f"Centre O at {metres(document['center'])}, user U at {metres(document['user'])}; {radii_text(document)}.",
        "",
        "![truth, conventional and continuous](side_by_side.png)",
        "",
        "| picture | pixels that differ from the truth | share | RMSE |",
        "| --- | ---: | ---: | ---: |",
    ]
    for name, value in document["pictures"].items():
        lines.append(f"| {name} | {count(value['pixels'])} | {100 * value['share']:.2f} % | {value['rmse']:.4f} |")
    lines += [
        "",
        "A pixel differs where a channel is off by 8 of 255 levels or more. Both methods show the far part as it looks "
        "from O, so both differ from the truth; what the continuous one avoids is the break at the boundary, which "
        "`nearfar compare` measures.",
        "",
        *_on_published(document),
        "| within | triangles |",
        "| ---: | ---: |",
        *(f"| {entry['radius']:g} m | {count(entry['triangles'])} |" for entry in document["load_curve"]),
        "",
    ]
    if "load_curve.png" in document["files"]:
        lines += ["![load curve](load_curve.png)", ""]
    lines += ["| step | seconds |", "| --- | ---: |"]
    lines += [f"| {name} | {seconds:.2f} |" for name, seconds in document["seconds"].items()]
    if document["notes"]:
        lines += ["", "Not drawn as in the file:", "", *(f"- {note}" for note in document["notes"])]
    return "\n".join([*lines, "", f"Written by {document['generator']}.", ""])


def _on_published(document: dict[str, Any]) -> list[str]:
    if "published" not in document["pictures"]:
        return []
    wide, narrow = default_radii.PUBLISHED * document["r2"], document["r1"]
    text = (
        f"The last picture has r1 = {wide:g} m, the published ratio to r2: it shears the ground more than {narrow:g} m."
    )
    return [text, ""]
