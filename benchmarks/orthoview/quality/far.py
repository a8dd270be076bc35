"""A far forest, whose trees cover a few pixels each: geometry with many samples against orthoviews with one.

The truth has 16 × 16 samples a pixel. The tree is built once, in some minutes, and stored in --trees.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

import nearfar as nf
from benchmarks.harness.pictures import Picture, similarity
from benchmarks.harness.report import folder_or_temporary, start, table
from benchmarks.harness.timing import best
from benchmarks.orthoview import _sheets
from benchmarks.orthoview._worlds import FOV, PICTURE, World

TREES, SIDE, CELL = 96_000, 1760.0, 160.0
"""Number of trees of the forest; its side and the side of leaves, metres."""
EYE, TARGET = (0.0, 350.0, 1700.0), (0.0, 0.0, 150.0)
LARGE = (2072, 1554)
"""Size in pixels of a picture with one sample per pixel, which is then reduced."""
TRUTH_SAMPLES = 256
"""Samples per pixel of the truth."""
PART, CROP, ZOOM = (128, 104, 320, 240), (256, 230, 80, 60), 4
"""Displayed and enlarged parts of the pictures (left, top, width, height in pixels), and the enlargement."""


def main() -> None:
    options = start(__doc__, "--trees", "--out", repeat=2)
    forest = nf.datasets.forest(trees=TREES)
    half_side = SIDE / 2
    world = World("far forest", forest.query, (-half_side, -40.0, -half_side), SIDE, 120.0, CELL)
    with folder_or_temporary(options.trees) as folder:
        # Without geometry, since nothing is near.
        tree = nf.orthoview.open(world.build(folder, 9, geometry=False))
        camera = nf.Camera.look_at(EYE, TARGET, fov=FOV, size=PICTURE)
        clip = nf.Clip(box=tree.bounds)
        print(f"{world.scene.triangle_count:,} triangles; {tree.held['bytes'] / 1e6:.0f} MB of views\n")
        truth = nf.render(world.scene, camera, clip=clip, samples=TRUTH_SAMPLES, channels=("color",)).to_image()
        rows, panels = [], [("truth, 16 × 16 samples", truth)]
        for name, draw in methods(world, tree, camera).items():
            picture = draw()
            psnr, ssim = similarity(truth, picture)
            timing = best(draw, repeat=options.repeat)
            rows.append([name, timing.wall, timing.cpu, psnr, ssim])
            if name in PANELS:
                panels.append((f"{name}\n{timing.cpu:.2f} CPU s, {psnr:.1f} dB, SSIM {ssim:.3f}", picture))
        print(table("A far forest", "method | s {:.2f} | CPU s {:.2f} | PSNR, dB {:.1f} | SSIM {:.3f}", rows))
        print(dict(tree.render(camera, channels=("color",)).stats))
    if options.out is not None:
        save(panels, options.out / "orthoview_far.jpg")


PANELS = ("geometry, 4 × 4 samples", f"geometry, {LARGE[0]} × {LARGE[1]} reduced", "orthoviews, one sample")


def methods(world: World, tree: nf.orthoview.OrthoTree, camera: nf.Camera) -> dict[str, Callable[[], Picture]]:

    def geometry(samples: int, size: tuple[int, int] = PICTURE) -> nf.Frame:
        settings: dict[str, Any] = {
            "clip": nf.Clip(box=tree.bounds),
            "samples": samples,
            "channels": ("color",),
            "backend": "cpu",
        }
        return nf.render(world.scene, replace(camera, size=size), **settings)

    def orthoviews(samples: int, error: float = 1.0) -> Callable[[], Picture]:
        return lambda: tree.render(camera, samples=samples, error_px=error, channels=("color",)).to_image()

    return {
        "geometry, one sample": lambda: geometry(1).to_image(),
        PANELS[0]: lambda: geometry(16).to_image(),
        PANELS[1]: lambda: average(geometry(1, LARGE)),
        PANELS[2]: orthoviews(1),
        "orthoviews, 4 × 4 samples": orthoviews(16),
        "orthoviews, 4 × 4 samples, half the error": orthoviews(16, 0.5),
    }


def average(frame: nf.Frame) -> Picture:
    """Average linear light over each pixel of the smaller picture."""
    channels = [Image.fromarray(channel) for channel in np.moveaxis(frame.require("color"), -1, 0)]
    smaller = [np.asarray(channel.resize(PICTURE, Image.Resampling.BOX)) for channel in channels]
    return nf.Frame(replace(frame.camera, size=PICTURE), color=np.stack(smaller, axis=-1)).to_image()


def save(panels: list[tuple[str, Picture]], path: Path) -> None:
    """Save parts of the pictures, and below them an enlarged part of each."""
    x, y, width, height = PART
    column, row, crop_width, crop_height = CROP
    parts = [(title, picture[y : y + height, x : x + width]) for title, picture in panels]
    crops = [picture[row : row + crop_height, column : column + crop_width] for _, picture in panels]
    enlarged = [("", crop.repeat(ZOOM, axis=0).repeat(ZOOM, axis=1)) for crop in crops]
    _sheets.save_panels([*parts, *enlarged], len(panels), path)


if __name__ == "__main__":
    main()
