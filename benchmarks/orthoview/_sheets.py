"""Draws sheets of pictures with their errors, halves of two pictures side by side, and panels."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from PIL import Image

import nearfar as nf
from benchmarks.harness.pictures import Picture
from benchmarks.orthoview._quality import Truth

PICTURE_SIZE = (292, 219)
"""Pixels of the sheet's pictures."""
WIDE = (1200, 500)
GAIN = 3
"""Factor of the displayed errors."""
MARGIN, LINE_HEIGHT = 4, 18


def save_sheet(rows: Sequence[tuple[str, Truth, Sequence[nf.Frame]]], titles: Sequence[str], path: Path) -> None:
    """Save rows of a name, a truth and frames, with the errors below the frames."""
    panels: list[tuple[str, Picture]] = []
    for name, truth, frames in rows:
        reference, pictures = truth.color.to_image(), [frame.to_image() for frame in frames]
        panels += zip(("truth", *titles), (reference, *pictures), strict=True)
        panels.append((f"{name}: above; right:\ndifferences, {GAIN} times as great", np.full_like(reference, 255)))
        panels += [("", error(reference, picture)) for picture in pictures]
    save_panels(panels, len(titles) + 1, path)


def error(reference: Picture, picture: Picture) -> Picture:
    """Greatest difference of the three colours, black on white."""
    difference = np.abs(reference.astype(int) - picture).max(axis=-1, keepdims=True)
    return np.asarray((255 - np.minimum(GAIN * difference, 255)).astype(np.uint8).repeat(3, axis=-1))


def save_halves(first: Picture, second: Picture, path: Path) -> None:
    """Save the left half of one picture beside the right half of another, with a line between them."""
    middle = first.shape[1] // 2
    codes = np.concatenate([first[:, :middle], second[:, middle:]], axis=1)
    codes[:, middle - 1 : middle + 1] = 255
    picture = Image.fromarray(codes)
    write(picture, "triangles", (middle - 50, 14))
    write(picture, "orthoviews", (middle + 54, 14))
    save(picture, path)


def save_panels(panels: Sequence[tuple[str, Picture]], columns: int, path: Path, *, scale: int = 1) -> None:
    """Save pictures of one size in rows, enlarged by a whole number, each below a title of one or more lines."""
    height, width = (scale * side for side in panels[0][1].shape[:2])
    rows = [panels[start : start + columns] for start in range(0, len(panels), columns)]
    lines = [max(len(title.splitlines()) for title, _ in row) for row in rows]
    tops = [LINE_HEIGHT * count + MARGIN for count in lines]
    sheet = Image.new("RGB", (columns * (width + MARGIN) - MARGIN, sum(tops) + height * len(rows)), "white")
    y = 0
    for row, top in zip(rows, tops, strict=True):
        for n, (title, picture) in enumerate(row):
            x = n * (width + MARGIN)
            write(sheet, title, (x + width // 2, y + top // 2))
            large = Image.fromarray(picture).resize((width, height), Image.Resampling.NEAREST)
            sheet.paste(large, (x, y + top))
        y += top + height
    save(sheet, path)


def write(picture: Image.Image, text: str, middle: tuple[int, int]) -> None:
    """Write black text centred at a point; the font has no ×."""
    from PIL import ImageDraw, ImageFont

    ImageDraw.Draw(picture).text(
        middle, text.replace("×", "x"), fill="black", anchor="mm", font=ImageFont.load_default(15), align="center"
    )


def save(picture: Image.Image, path: Path) -> None:
    """Save a picture; PNG files get a palette of 256 colours, enough for pictures of few hues."""
    if path.suffix == ".jpg":
        picture.save(path, quality=88, optimize=True)
        return
    picture.quantize(256, dither=Image.Dither.NONE).save(path, optimize=True)
