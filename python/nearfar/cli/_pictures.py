"""Pictures and plots of reports."""

from __future__ import annotations

import importlib.util
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from nearfar.stereo._differences import EyeDifference

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
    """Write all pictures; return False if matplotlib is not installed, without which the error is not plotted."""
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
