"""Headsets of `nearfar render`: picture size, lens and files."""

from __future__ import annotations

from pathlib import Path

import nearfar as nf
from nearfar._base import check, files
from nearfar.cli import _options as options


def headset(name: str, lens: str, fov: float | None) -> nf.Hmd:
    """Return the headset, with the generic lens if requested."""
    check.choice("--lens", lens, ("own", "generic"))
    if fov is not None:
        raise ValueError(f"--fov: expected none with --hmd, which has fields of view of its own, got {fov:g}")
    device = options.headset(name)
    return device if lens == "own" else device.with_lens()


STRETCHED = 0.03
"""Relative difference of aspect ratios that is not reported."""


def pixels_of(size: str | None, device: nf.Hmd | None) -> tuple[int, int]:
    """Return width and height of a picture; for a headset by default those of an eye."""
    if size is None and device is not None:
        return device.render_size
    return options.read_size("--size", "1280x720" if size is None else size)


def stretching(pixels: tuple[int, int], device: nf.Hmd) -> list[str]:
    """Report a headset's pictures whose aspect ratio differs from the headset's."""
    width, height = device.render_size
    if abs(pixels[0] * height / (pixels[1] * width) - 1.0) <= STRETCHED:
        return []
    fitting = f"{round(pixels[1] * width / height)}x{pixels[1]}"
    return [f"the picture is stretched: an eye has {width} × {height} pixels, and {fitting} would keep its shape"]


def targets_of(output: Path, device: nf.Hmd) -> dict[str, Path]:
    """Return the files of a headset's pictures by content."""
    names = ["left", "right", *(("left_warped", "right_warped") if device.lens else ())]
    return {"side_by_side": output} | {name: output.with_stem(f"{output.stem}_{name}") for name in names}


def save(result: nf.Frame | nf.StereoFrame, targets: dict[str, Path]) -> None:
    """Write the picture, or the pictures of both eyes, to files by content."""
    result.save(targets["side_by_side"])
    if isinstance(result, nf.Frame):
        return
    result.left.save(targets["left"])
    result.right.save(targets["right"])
    if result.hmd is not None and result.hmd.lens is not None:
        from PIL import Image

        for name, picture in zip(("left_warped", "right_warped"), result.warped(), strict=True):
            with files.atomic_file(targets[name]) as temporary:
                Image.fromarray(picture).save(temporary, format="PNG")
