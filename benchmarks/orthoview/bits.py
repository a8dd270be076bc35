"""Bits of depths and normals: bytes, errors, surfels that become balls, and how much a picture of the splats changes.

Differences are relative to depths of 16 bits and normals of 24. Pictures are also compared with the leaf itself: from
beside the view's direction its splats show only what that view saw, regardless of the bits.
"""

from __future__ import annotations

import argparse
import os
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness.compare import FOLDER
from benchmarks.harness.timing import machine, table
from benchmarks.orthoview import _splats
from benchmarks.orthoview._leaves import DIRECTIONS, SIZE, Leaf, layout_of, leaves
from nearfar import _core
from nearfar.orthoview import _codec

Format = tuple[int, int]
"""Numbers of bits of depths and of normals."""

FINEST: Format = (16, 24)
DEPTHS: list[Format] = [(bits, 24) for bits in (8, 9, 10, 11, 12, 14, 16)]
NORMALS: list[Format] = [(16, 16), (12, 16), (10, 16), (12, 24)]
"""Formats of the second table."""

SHOWN = (4, 5)
"""Numbers of the rendered directions: from above, and from above and beside."""

PLOT = "orthoview-bits.png"


@dataclass(frozen=True)
class Stored:
    """A leaf's views in a format."""

    kilobytes: dict[str, float]
    """Compressed size of a non-empty view, by channel."""
    metres: NDArray[np.float64]
    """Depths (D, size, size) in metres; NaN for empty pixels."""
    normals: NDArray[np.float32]
    surfels: NDArray[np.bool_]
    pictures: list[NDArray[np.uint8]]


@dataclass(frozen=True)
class Loss:
    """Costs and losses of a format."""

    kilobytes: dict[str, float]
    rms: tuple[float, float]
    """Root mean square error of the depths, millimetres and pixels."""
    most: tuple[float, float]
    """Maximum error of a depth, millimetres and pixels."""
    angles: tuple[float, float]
    """Mean and maximum error of the normals, degrees."""
    changed: float
    """Share of the pixels that change from surfels to balls or back."""
    psnr: float
    ssim: float
    truth: float
    """SSIM with the leaf itself."""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--size", type=int, default=SIZE, help="width and height of views, pixels")
    parser.add_argument("--leaf", default="", help="part of the names of the leaves that are drawn")
    given = parser.parse_args()
    print(machine(), "\n")
    losses = {leaf.name: losses_of(leaf, given.size) for leaf in leaves() if given.leaf in leaf.name}
    shown = ["surfels or balls changed", "PSNR, dB", "SSIM", "SSIM with the leaf"]
    header = ["leaf", "bits", "depths, kB a view", "RMS, mm", "greatest, mm", "RMS, pixels", "greatest, pixels", *shown]
    rows = [row for name, by_format in losses.items() for row in rows_of_depths(name, by_format)]
    print(table(f"Depths, normals of 24 bits, views of {given.size}² pixels", header, rows))
    header = ["leaf", "bits of depths, normals", "normals, kB a view", "mean, °", "greatest, °", *shown]
    rows = [row for name, by_format in losses.items() for row in rows_of_normals(name, by_format)]
    print(table("Normals", [*header, "all channels, kB a view"], rows))
    if folder := os.environ.get(FOLDER):
        plot(losses, Path(folder) / PLOT)
        print(f"![Bits of depths]({PLOT})\n")


def losses_of(leaf: Leaf, size: int) -> dict[Format, Loss]:
    finest = stored(leaf, FINEST, size)
    truths = [_splats.truth(leaf, DIRECTIONS[number], size) for number in SHOWN]
    formats = dict.fromkeys([*DEPTHS, *NORMALS])
    return {bits: loss_of(stored(leaf, bits, size), finest, truths, leaf.side) for bits in formats}


def stored(leaf: Leaf, bits: Format, size: int) -> Stored:
    layout = layout_of(*bits, size)
    views = leaf.views(layout)
    lengths: dict[str, list[int]] = {}
    for (_, channel), chunk in _codec.encoded(views, layout).items():
        lengths.setdefault(channel, []).append(len(chunk))
    codes = views.depths()[..., 0]
    deep = np.array([_core.orthoview_axes(direction)[1][2] for direction in DIRECTIONS]) * leaf.side
    return Stored(
        {channel: float(np.mean(of_channel)) / 1e3 for channel, of_channel in lengths.items()},
        np.where(codes > 0, (codes - 0.5) * (deep / layout.steps)[:, None, None], np.nan),
        views.vectors(),
        _core.orthoview_surfels(views.connected(_codec.CONNECTED))[..., 0],
        [_splats.picture(leaf, views, layout, number) for number in SHOWN],
    )


def loss_of(views: Stored, finest: Stored, truths: list[NDArray[np.uint8]], side: float) -> Loss:
    seen = np.isfinite(finest.metres)
    errors = views.metres - finest.metres
    pixels = np.array([max(_core.orthoview_axes(direction)[1][:2]) for direction in DIRECTIONS]) * side / seen.shape[1]
    each = [1e3 * errors[seen], (errors / pixels[:, None, None])[seen]]
    # Half a chord is the sine of half an angle, which float32 represents accurately for small angles.
    chords = np.linalg.norm(views.normals[seen].astype(np.float64) - finest.normals[seen], axis=1)
    angles = np.degrees(2 * np.arcsin(np.minimum(chords / 2, 1)))
    millimetres, in_pixels = (float(np.sqrt((of_unit**2).mean())) for of_unit in each)
    most, most_in_pixels = (float(np.abs(of_unit).max()) for of_unit in each)
    return Loss(
        views.kilobytes,
        (millimetres, in_pixels),
        (most, most_in_pixels),
        (float(angles.mean()), float(angles.max())),
        float((views.surfels != finest.surfels)[seen].mean()),
        *differences(finest.pictures, views.pictures),
        differences(truths, views.pictures)[1],
    )


def differences(right: list[NDArray[np.uint8]], shown: list[NDArray[np.uint8]]) -> tuple[float, float]:
    """PSNR in decibels over all pictures, and the mean of their SSIM."""
    square = float(np.mean([nf.metrics.rmse(one, other) ** 2 for one, other in zip(right, shown, strict=True)]))
    ssim = np.mean([nf.ssim(one, other, data_range=255) for one, other in zip(right, shown, strict=True)])
    return (float(20 * np.log10(255 / np.sqrt(square))) if square else np.inf), float(ssim)


def rows_of_depths(name: str, losses: dict[Format, Loss]) -> Iterable[list[str]]:
    for bits in DEPTHS:
        loss = losses[bits]
        errors = [f"{value:.3g}" for value in (loss.rms[0], loss.most[0], loss.rms[1], loss.most[1])]
        yield [name, str(bits[0]), f"{loss.kilobytes['depth']:.1f}", *errors, *of_pictures(loss)]


def rows_of_normals(name: str, losses: dict[Format, Loss]) -> Iterable[list[str]]:
    for bits in NORMALS:
        loss = losses[bits]
        angles = [f"{angle:.2g}" for angle in loss.angles]
        whole = f"{sum(loss.kilobytes.values()):.1f}"
        yield [name, f"{bits[0]}, {bits[1]}", f"{loss.kilobytes['normal']:.1f}", *angles, *of_pictures(loss), whole]


def of_pictures(loss: Loss) -> list[str]:
    return [f"{loss.changed:.2%}", f"{loss.psnr:.1f}", f"{loss.ssim:.4f}", f"{loss.truth:.4f}"]


def plot(losses: dict[str, dict[Format, Loss]], path: Path) -> None:
    import matplotlib as mpl

    mpl.use("Agg")
    from matplotlib import pyplot as plt

    figure, (sizes, pictures) = plt.subplots(1, 2, figsize=(10, 3.8), layout="constrained")
    numbers = [bits[0] for bits in DEPTHS]
    for name, by_format in losses.items():
        sizes.plot(numbers, [by_format[bits].kilobytes["depth"] for bits in DEPTHS], marker=".", label=name)
        pictures.plot(numbers[:-1], [1 - by_format[bits].ssim for bits in DEPTHS[:-1]], marker=".", label=name)
    sizes.set(xlabel="bits of a depth", ylabel="kB of a view's depths", ylim=(0, None))
    pictures.set(xlabel="bits of a depth", ylabel="1 − SSIM, from 16 bits", yscale="log")
    sizes.legend(fontsize="small")
    figure.savefig(path, dpi=100)
    plt.close(figure)


if __name__ == "__main__":
    main()
