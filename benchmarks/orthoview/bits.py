"""Bits of depths and normals: bytes, errors, surfels that become balls, and changes of a picture of the splats.

Differences are relative to depths of 16 bits and normals of 24. Pictures are also compared with the leaf itself: their
camera is beside the view's direction, so surfaces that the view does not show are missing at any number of bits.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness.report import save_figure, start, subplots, table
from benchmarks.orthoview import _splats
from benchmarks.orthoview._leaves import DIRECTIONS, SIZE, Leaf, layout_of, leaves, metres_of
from nearfar import _core
from nearfar.orthoview import _codec, _zstd

Format = tuple[int, int]
"""Numbers of bits of depths and of normals."""

FINEST: Format = (16, 24)
DEPTHS: list[Format] = [(bits, 24) for bits in (8, 9, 10, 11, 12, 14, 16)]
NORMALS: list[Format] = [(16, 16), (12, 16), (10, 16), (12, 24)]
"""Formats of the second table."""

RENDERED = (4, 5)
"""Numbers of the rendered directions: from above, and from above and beside."""

PLOT = "orthoview-bits.png"


@dataclass(frozen=True)
class StoredViews:
    """A leaf's views in a format."""

    kilobytes: dict[str, float]
    """Compressed size of a non-empty view, and of its channels alone."""
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
    max: tuple[float, float]
    """Maximum error of a depth, millimetres and pixels."""
    angles: tuple[float, float]
    """Mean and maximum error of the normals, degrees."""
    changed: float
    """Share of the pixels that change from surfels to balls or back."""
    psnr: float
    ssim: float
    truth: float
    """SSIM with the leaf itself."""

    @property
    def pictures(self) -> tuple[float, ...]:
        """Figures of a table: share of changed pixels, PSNR, SSIM, and SSIM with the leaf itself."""
        return self.changed, self.psnr, self.ssim, self.truth


def main() -> None:
    plots = start(__doc__, "--plots").plots
    losses: dict[str, dict[Format, Loss]] = {}
    for leaf in leaves():
        truths = [_splats.truth(leaf, DIRECTIONS[number], SIZE) for number in RENDERED]
        views = {bits: store_views(leaf, bits) for bits in dict.fromkeys([*DEPTHS, *NORMALS])}
        losses[leaf.name] = {bits: loss_of(each, views[FINEST], truths, leaf.side) for bits, each in views.items()}
    picture_columns = " | surfels or balls changed {:.2%} | PSNR, dB {:.1f} | SSIM {:.4f} | SSIM with the leaf {:.4f}"
    header = "leaf | bits | depths, kB a view {:.1f} | RMS, mm {:.3g} | greatest, mm {:.3g} | RMS, pixels {:.3g}"
    rows = [
        [name, bits[0], loss.kilobytes["depth"], loss.rms[0], loss.max[0], loss.rms[1], loss.max[1], *loss.pictures]
        for name, by_format in losses.items()
        for bits, loss in ((bits, by_format[bits]) for bits in DEPTHS)
    ]
    title = f"Depths, normals of 24 bits, views of {SIZE}² pixels"
    print(table(title, f"{header} | greatest, pixels {{:.3g}}{picture_columns}", rows))
    rows = [
        [name, bits, loss.kilobytes["normal"], *loss.angles, *loss.pictures, loss.kilobytes["view"]]
        for name, by_format in losses.items()
        for bits, loss in ((bits, by_format[bits]) for bits in NORMALS)
    ]
    header = "leaf | bits of depths, normals {}, {} | normals, kB a view {:.1f} | mean, ° {:.2g} | greatest, ° {:.2g}"
    print(table("Normals", f"{header}{picture_columns} | whole view, kB {{:.1f}}", rows))
    if plots is not None:
        plot(losses, plots / PLOT)
        print(f"![Bits of depths]({PLOT})\n")


def store_views(leaf: Leaf, bits: Format) -> StoredViews:
    layout = layout_of(*bits)
    views = leaf.views(layout)
    channels = _codec.channels_of(views, layout)
    shown = [number for number, is_empty in enumerate(views.empty()) if not is_empty]
    kilobytes = {"view": float(np.mean([*map(len, _codec.encode(views, layout).values())])) / 1e3}
    for name, values in channels._asdict().items():
        if name == "depth":  # stored by planes of bytes
            values = np.moveaxis(np.ascontiguousarray(values[..., None]).view(np.uint8), -1, 1)
        kilobytes[name] = float(np.mean([len(_zstd.compress(values[number])) for number in shown])) / 1e3
    return StoredViews(
        kilobytes,
        np.array([metres_of(views, number, layout, leaf.side, np.nan) for number in range(len(DIRECTIONS))]),
        views.vectors(),
        _core.orthoview_surfels(views.connected(_codec.CONNECTION_LIMITS))[..., 0],
        [_splats.picture(leaf, views, layout, number) for number in RENDERED],
    )


def loss_of(views: StoredViews, finest: StoredViews, truths: list[NDArray[np.uint8]], side: float) -> Loss:
    is_shown = np.isfinite(finest.metres)
    errors = views.metres - finest.metres
    widths = [max(_core.orthoview_axes(direction)[1][:2]) for direction in DIRECTIONS]
    pixels = np.array(widths) * side / is_shown.shape[1]
    errors_by_unit = [1e3 * errors[is_shown], (errors / pixels[:, None, None])[is_shown]]
    # Half a chord is the sine of half an angle, which float32 represents accurately for small angles.
    chords = np.linalg.norm(views.normals[is_shown].astype(np.float64) - finest.normals[is_shown], axis=1)
    angles = np.degrees(2 * np.arcsin(np.minimum(chords / 2, 1)))
    millimetres, in_pixels = (float(np.sqrt((of_unit**2).mean())) for of_unit in errors_by_unit)
    greatest, greatest_in_pixels = (float(np.abs(of_unit).max()) for of_unit in errors_by_unit)
    return Loss(
        views.kilobytes,
        (millimetres, in_pixels),
        (greatest, greatest_in_pixels),
        (float(angles.mean()), float(angles.max())),
        float((views.surfels != finest.surfels)[is_shown].mean()),
        *differences(finest.pictures, views.pictures),
        differences(truths, views.pictures)[1],
    )


def differences(references: list[NDArray[np.uint8]], pictures: list[NDArray[np.uint8]]) -> tuple[float, float]:
    """PSNR in decibels over all pictures, and the mean of their SSIM."""
    ssim = np.mean([nf.ssim(one, other, data_range=255) for one, other in zip(references, pictures, strict=True)])
    return nf.psnr(np.concatenate(references), np.concatenate(pictures), data_range=255), float(ssim)


def plot(losses: dict[str, dict[Format, Loss]], path: Path) -> None:
    figure, (sizes, pictures) = subplots(1, 2, figsize=(10, 3.8))
    numbers = [bits[0] for bits in DEPTHS]
    for name, by_format in losses.items():
        sizes.plot(numbers, [by_format[bits].kilobytes["depth"] for bits in DEPTHS], marker=".", label=name)
        pictures.plot(numbers[:-1], [1 - by_format[bits].ssim for bits in DEPTHS[:-1]], marker=".", label=name)
    sizes.set(xlabel="bits of a depth", ylabel="kB of a view's depths", ylim=(0, None))
    pictures.set(xlabel="bits of a depth", ylabel="1 − SSIM, from 16 bits", yscale="log")
    sizes.legend(fontsize="small")
    save_figure(figure, path)


if __name__ == "__main__":
    main()
